"""Formula cells that call LAMBDA names, as Excel 365 itself stores them, with their results.

A cell that Excel does not know to be a dynamic-array formula gets an @ before each function that may give an array.
The mark is the cell's metadata ``cm="1"``, which leads to ``xl/metadata.xml`` ([MS-XLSX] 2.6.205,
'CT_DynamicArrayProperties'); openpyxl writes neither.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from html import escape
from typing import Any

METADATA = "xl/metadata.xml"
METADATA_XML = (
    b'<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
    b'<metadata xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" '
    b'xmlns:xda="http://schemas.microsoft.com/office/spreadsheetml/2017/dynamicarray">'
    b'<metadataTypes count="1"><metadataType name="XLDAPR" minSupportedVersion="120000" copy="1" pasteAll="1" '
    b'pasteValues="1" merge="1" splitFirst="1" rowColShift="1" clearFormats="1" clearComments="1" assign="1" '
    b'coerce="1" cellMeta="1"/></metadataTypes>'
    b'<futureMetadata name="XLDAPR" count="1"><bk><extLst><ext uri="{bdbb8cdc-fa1e-496e-a857-3c3f30c029c3}">'
    b'<xda:dynamicArrayProperties fDynamic="1" fCollapsed="0"/></ext></extLst></bk></futureMetadata>'
    b'<cellMetadata count="1"><bk><rc t="1" v="0"/></bk></cellMetadata></metadata>'
)
TYPE = (
    b'<Override PartName="/xl/metadata.xml" '
    b'ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheetMetadata+xml"/>'
)
LINK = (
    b'<Relationship Id="metadata" '
    b'Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/sheetMetadata" '
    b'Target="metadata.xml"/>'
)
CELL = re.compile(rb'<c r="([A-Z]+\d+)"([^>]*)><f>([^<]*)</f><v\s*(?:/>|></v>)</c>')


def completed(parts: Mapping[str, bytes], results: Mapping[str, Mapping[str, Any]], marks: str) -> dict[str, bytes]:
    """Return the parts with the result of every formula, and those whose text has ``marks`` marked as dynamic.

    ``results`` are by sheet part and cell. Raises KeyError for a formula that has none.
    """
    made = dict(parts)
    for part, values in results.items():
        made[part] = CELL.sub(partial(stored, values, marks.encode()), made[part])
    made[METADATA] = METADATA_XML
    for name, entry in (("[Content_Types].xml", TYPE), ("xl/_rels/workbook.xml.rels", LINK)):
        body, _, end = made[name].rpartition(b"</")
        made[name] = body + entry + b"</" + end
    return made


def stored(values: Mapping[str, Any], marks: bytes, cell: re.Match[bytes]) -> bytes:
    """Return a formula cell with its result, and with the mark of a dynamic array if it calls for one."""
    place, look, formula = cell.groups()
    kind, value = shown(values[place.decode()])
    if marks not in formula:
        return b'<c r="%s"%s%s><f>%s</f><v>%s</v></c>' % (place, look, kind, formula, value)
    return b'<c r="%s"%s cm="1"%s><f t="array" ref="%s">%s</f><v>%s</v></c>' % (
        place, look, kind, place, formula, value,
    )  # fmt: skip


def shown(value: Any) -> tuple[bytes, bytes]:
    """Return the type attribute and the text of a result: a number, a text, or an error value."""
    if isinstance(value, str):
        return b' t="e"' if value.startswith("#") else b' t="str"', escape(value, quote=False).encode()
    return b"", repr(float(value)).encode()
