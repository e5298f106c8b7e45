"""The parts of a workbook file as Excel itself writes them, the same bytes each time; whether two files are the same.

openpyxl leaves three things that Excel mends in silence when it saves: the time of day, charts without alternative
text, and fonts whose elements are out of order. Drawings without a prefix and targets from the root of the archive are
valid, but programs that know Excel's files alone do not read them (ExcelJS 4). It writes no values of formulas, and
cells several times as slowly.
"""

import hashlib
import io
import math
import posixpath
import re
import zipfile
from collections import defaultdict
from html import escape
from itertools import zip_longest
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from openpyxl.cell.cell import ERROR_CODES
from openpyxl.utils import get_column_letter

EPOCH = (2020, 1, 1, 0, 0, 0)  # written into the file instead of the time of day
MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
FONT_ORDER = ("b i strike condense extend outline shadow u vertAlign sz color name family charset scheme").split()
CACHED = re.compile(rb'(</f>|<pt idx="\d+">)<v>([^<]*)</v>')
LAST_PLACES = 1e-12  # of saved results and points of charts: another machine may round the last digit differently
TYPE = (
    '<Override PartName="/xl/{}.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.{}+xml"/>'
)
LINK = (
    '<Relationship Id="{0}" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/{1}" '
    'Target="{0}.xml"/>'
)
FROM_ROOT = re.compile(r'(?<= Target=")/([^"]+)')
# a cell that Excel does not know to be a dynamic-array formula gets an @ before each function that may give an array
# ([MS-XLSX] 2.6.205, 'CT_DynamicArrayProperties'): what the mark cm="1" of a cell leads to, which openpyxl lacks
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


def complete_parts(parts: dict[str, bytes], strings: bytes, abouts: list[tuple[str, str]]) -> dict[str, bytes]:
    """Return the parts as Excel writes them; ``abouts`` are title and alternative text of each chart, in order."""
    complete, core = dict(parts), "docProps/core.xml"
    complete[core] = re.sub(rb"\d{4}-\d\d-\d\dT[\d:]+Z", b"%04d-%02d-%02dT%02d:%02d:%02dZ" % EPOCH, complete[core])
    ElementTree.register_namespace("", MAIN)
    styles = ElementTree.fromstring(complete["xl/styles.xml"])
    # in the order of the standard (ISO/IEC 29500-1, 18.8.22)
    for font in styles.iter(f"{{{MAIN}}}font"):
        font[:] = sorted(font, key=lambda child: FONT_ORDER.index(child.tag.rpartition("}")[2]))
    complete["xl/styles.xml"] = ElementTree.tostring(styles)
    named = (f'name="{escape(title)}" descr="{escape(about)}"'.encode() for title, about in abouts)
    for name, part in complete.items():
        if re.fullmatch(r"xl/drawings/drawing\d+\.xml", name):
            drawing = re.sub(rb'name="Chart \d+"', lambda _: next(named), part)
            drawing = re.sub(rb"<(/?)(?=\w+[ />])", rb"<\g<1>xdr:", drawing)
            complete[name] = drawing.replace(b" xmlns=", b" xmlns:xdr=")
        elif name.endswith(".rels"):
            complete[name] = with_relative_targets(name, part.decode()).encode()
    return with_part(complete, "sharedStrings", strings)


def with_relative_targets(name: str, part: str) -> str:
    """Return the relationships of a part, ``name`` their own, with each target as seen from the folder of that part."""
    folder = posixpath.dirname(posixpath.dirname(name))
    return FROM_ROOT.sub(lambda target: posixpath.relpath(target[1], folder), part)


def with_part(parts: dict[str, bytes], name: str, part: bytes, kind: str = "") -> dict[str, bytes]:
    """Return the parts with a further part of the workbook, of this name and kind of relationship."""
    whole = parts | {f"xl/{name}.xml": part}
    for where, entry in (
        ("[Content_Types].xml", TYPE.format(name, kind or name)),
        ("xl/_rels/workbook.xml.rels", LINK.format(name, kind or name)),
    ):
        body, _, end = whole[where].rpartition(b"</")
        whole[where] = body + entry.encode() + b"</" + end
    return whole


def zipped(parts: dict[str, bytes], method: int = zipfile.ZIP_STORED) -> bytes:
    """Return the archive of the parts, in their order, with the fixed time."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        for name, part in parts.items():
            archive.writestr(zipfile.ZipInfo(name, EPOCH), part, method)
    return data.getvalue()


def unzipped(data: bytes) -> dict[str, bytes]:
    """Return the parts of an archive by name."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {info.filename: archive.read(info) for info in archive.infolist()}


def same_book(first: Path, other: Path) -> bool:
    """Compare two files: to the byte, but for the last places of saved results of formulas and of points of charts."""
    with zipfile.ZipFile(first) as a, zipfile.ZipFile(other) as b:
        if a.namelist() != b.namelist():
            return False
        return all(same_part(a.read(name), b.read(name)) for name in a.namelist())


def book_digest(path: Path) -> str:
    """Return the SHA-256 of a book's parts, in their order, without saved results of formulas and points of charts."""
    digest = hashlib.sha256()
    with zipfile.ZipFile(path) as book:
        for name in book.namelist():
            part = CACHED.sub(rb"\1", book.read(name))
            digest.update(f"{name} {len(part)} ".encode() + part)
    return digest.hexdigest()


def same_part(first: bytes, other: bytes) -> bool:
    """Compare a part: the text around cached results exactly, the results nearly."""
    if first == other:
        return True
    if CACHED.sub(rb"\1", first) != CACHED.sub(rb"\1", other):
        return False
    pairs = zip_longest(CACHED.findall(first), CACHED.findall(other), fillvalue=(b"", b""))
    return all(nearly_equal(a[1], b[1]) for a, b in pairs)


def nearly_equal(first: bytes, other: bytes) -> bool:
    """Whether two cached results agree but for rounding."""
    try:
        return first == other or math.isclose(float(first), float(other), rel_tol=LAST_PLACES, abs_tol=LAST_PLACES)
    except ValueError:
        return False


SHEET_DATA = re.compile(rb"<sheetData ?/>|<sheetData>.*?</sheetData>", re.DOTALL)
DIMENSION = re.compile(rb'(?<=<dimension ref=")[^"]*')


class Strings:
    """The shared texts of a workbook, each once (ISO/IEC 29500-1, 18.4.9)."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}
        self._count = 0

    def number(self, text: str) -> int:
        """Return the number by which a cell refers to ``text``."""
        self._count += 1
        return self._numbers.setdefault(text, len(self._numbers))

    def part(self) -> bytes:
        """Return the table as a part of the file."""
        texts = "".join(f"<si>{element('t', text)}</si>" for text in self._numbers)
        sizes = f'count="{self._count}" uniqueCount="{len(self._numbers)}"'
        return f'<sst xmlns="{MAIN}" {sizes}>{texts}</sst>'.encode()


class Cells:
    """The cells of a sheet, put in any order; a formula that holds ``dynamic`` is marked as a dynamic array."""

    def __init__(self, strings: Strings, dynamic: str = "") -> None:
        self._strings, self._dynamic = strings, dynamic
        self._rows: dict[int, dict[int, str]] = defaultdict(dict)
        self.heights: dict[int, float] = {}
        self.folded = range(0)  # rows of an outline that is closed

    def put(self, row: int, column: int, style: int, content: Any) -> None:
        """Put a text, a number, a truth value, or nothing but a style."""
        if isinstance(content, str):
            kind, value = ' t="s"', f"<v>{self._strings.number(content)}</v>"
        else:
            kind, value = value_xml(content)
        cell = f'<c r="{get_column_letter(column)}{row}" s="{style}"{kind}'
        self._rows[row][column] = f"{cell}>{value}</c>" if value else f"{cell}/>"

    def put_formula(self, row: int, column: int, style: int, formula: str, value: Any) -> None:
        """Put a formula, which begins with =, and what it computes; None where that is not known."""
        place = f"{get_column_letter(column)}{row}"
        kind, known = value_xml(value)
        array = marked = ""
        if self._dynamic and self._dynamic in formula:
            marked, array = ' cm="1"', f' t="array" ref="{place}"'
        text = escape(formula[1:], quote=False)
        self._rows[row][column] = f'<c r="{place}" s="{style}"{marked}{kind}><f{array}>{text}</f>{known}</c>'

    def within(self, sheet: bytes) -> bytes:
        """Return the part of a sheet with these cells, in their order, instead of its own."""
        columns = [column for cells in self._rows.values() for column in (min(cells), max(cells))]
        first, last = (get_column_letter(end(columns, default=1)) for end in (min, max))
        span = f"{first}{min(self._rows)}:{last}{max(self._rows)}" if self._rows else "A1"
        data = f"<sheetData>{''.join(map(self._row, sorted({*self._rows, *self.folded})))}</sheetData>".encode()
        return SHEET_DATA.sub(lambda _: data, DIMENSION.sub(span.encode(), sheet, count=1), count=1)

    def _row(self, row: int) -> str:
        height = f' ht="{self.heights[row]:g}" customHeight="1"' if row in self.heights else ""
        folded = ' hidden="1" outlineLevel="1"' if row in self.folded else ""
        cells = self._rows[row]
        return f'<row r="{row}"{height}{folded}>{"".join([cells[column] for column in sorted(cells)])}</row>'


def value_xml(value: Any) -> tuple[str, str]:
    """Return the type attribute and the element of a value; neither where there is none: None, not a finite number."""
    # all its digits: openpyxl writes 16, and some need 17 to come back; no cell has −0
    if isinstance(value, float):
        return "", f"<v>{repr(float(value) + 0.0).removesuffix('.0')}</v>" if math.isfinite(value) else ""
    if isinstance(value, str):
        return (' t="e"' if value in ERROR_CODES else ' t="str"'), element("v", value)
    return (' t="b"' if isinstance(value, bool) else ""), "" if value is None else f"<v>{int(value)}</v>"


def element(name: str, text: str) -> str:
    """Return an element with a text, in which blanks at the ends count."""
    space = ' xml:space="preserve"' if text != text.strip() else ""
    return f"<{name}{space}>{escape(text, quote=False)}</{name}>"
