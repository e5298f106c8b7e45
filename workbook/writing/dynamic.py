"""What marks formula cells that call LAMBDA names as dynamic arrays, as Excel 365 itself stores it.

A cell that Excel does not know to be a dynamic-array formula gets an @ before each function that may give an array.
The mark is the cell's metadata ``cm="1"``, which leads to ``xl/metadata.xml`` ([MS-XLSX] 2.6.205,
'CT_DynamicArrayProperties'); openpyxl writes neither.
"""

from __future__ import annotations

from workbook.writing import archive

METADATA = (
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


def completed(parts: dict[str, bytes]) -> dict[str, bytes]:
    """Return the parts with the metadata that the marks of the cells lead to."""
    return archive.added(parts, "metadata", METADATA, "sheetMetadata")
