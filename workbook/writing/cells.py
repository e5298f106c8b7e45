"""The cells of a sheet as XML, each formula with its value: openpyxl writes none, and takes several times as long."""

import math
import re
from collections import defaultdict
from html import escape
from typing import Any

from openpyxl.cell.cell import ERROR_CODES
from openpyxl.utils import get_column_letter

SHEET_DATA = re.compile(rb"<sheetData ?/>|<sheetData>.*?</sheetData>", re.DOTALL)
DIMENSION = re.compile(rb'(?<=<dimension ref=")[^"]*')
MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"


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
    """The cells of one sheet, put in any order; a formula that holds ``dynamic`` is marked as a dynamic array."""

    def __init__(self, strings: Strings, dynamic: str = "") -> None:
        self._strings, self._dynamic = strings, dynamic
        self._rows: dict[int, dict[int, str]] = defaultdict(dict)
        self.heights: dict[int, float] = {}

    def put(self, row: int, column: int, style: int, content: Any) -> None:
        """Put a text, a number, a truth value, or nothing but a style."""
        if isinstance(content, str):
            kind, value = ' t="s"', f"<v>{self._strings.number(content)}</v>"
        else:
            kind, value = result(content)
        cell = f'<c r="{get_column_letter(column)}{row}" s="{style}"{kind}'
        self._rows[row][column] = f"{cell}>{value}</c>" if value else f"{cell}/>"

    def put_formula(self, row: int, column: int, style: int, formula: str, value: Any) -> None:
        """Put a formula, which begins with =, and what it computes; None where that is not known."""
        place = f"{get_column_letter(column)}{row}"
        kind, known = result(value)
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
        data = f"<sheetData>{''.join(map(self._row, sorted(self._rows)))}</sheetData>".encode()
        return SHEET_DATA.sub(lambda _: data, DIMENSION.sub(span.encode(), sheet, count=1), count=1)

    def _row(self, row: int) -> str:
        height = f' ht="{self.heights[row]:g}" customHeight="1"' if row in self.heights else ""
        cells = self._rows[row]
        return f'<row r="{row}"{height}>{"".join([cells[column] for column in sorted(cells)])}</row>'


def result(value: Any) -> tuple[str, str]:
    """Return the type attribute and the element of a value; neither where there is none: None, not a finite number."""
    if isinstance(value, str):
        return (' t="e"' if value in ERROR_CODES else ' t="str"'), element("v", value)
    if isinstance(value, bool):
        return ' t="b"', f"<v>{value:d}</v>"
    if value is None or not math.isfinite(value):
        return "", ""
    # all its digits: openpyxl writes 16, and some numbers need 17 to come back; cells know no −0
    return "", f"<v>{value if type(value) is int else repr(float(value) + 0.0).removesuffix('.0')}</v>"


def element(name: str, text: str) -> str:
    """Return an element with a text, in which blanks at the ends count."""
    kept = ' xml:space="preserve"' if text != text.strip() else ""
    return f"<{name}{kept}>{escape(text, quote=False)}</{name}>"
