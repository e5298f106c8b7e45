"""The rows of a worksheet's part; what readers take differently, such as two formulas in a cell, is refused."""

import re
from typing import NamedTuple
from xml.etree.ElementTree import Element

from openpyxl.utils import column_index_from_string

SAVE_AS = "open it in Excel or LibreOffice and save it as .xlsx"
MOST_PLACES = 5_000_000  # of the rectangles around the cells of all sheets
MOST_CELLS = 1_500_000  # that openpyxl makes
MOST_IN_ROWS = 7 * MOST_CELLS  # elements and attributes inside of rows
MOST_OUTSIDE = 1_000_000  # elements, attributes and ranges outside of rows
MOST_OF = {"definedName": 20_000, "si": 200_000, "sheet": 250}
# characters; Excel's limits
MOST_LONG = {"f": 8_192, "definedName": 8_192, "v": 32_767, "t": 32_767}
MOST_FORMULAS = 400_000_000  # characters of all formulas and names, the shared ones written out
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
LAST_ROW, LAST_COLUMN = 1_048_576, 16_384
KINDS = frozenset({"n", "s", "str", "b", "e", "inlineStr", "d"})
FORMULAS = frozenset({"normal", "array", "shared", "dataTable"})
PLACED = frozenset({"r", "spans"})  # attributes of a row that say nothing of its looks
FORMULA, VALUE = f"{MAIN}f", f"{MAIN}v"
USUAL = frozenset({FORMULA, VALUE})  # what nearly all cells hold
FREE = frozenset({f"{MAIN}extLst", f"{MAIN}rPr"})  # what stands in these is no part of a text
WITHIN = {
    f"{MAIN}{name}": {f"{MAIN}{name}" for name in held.split()}
    for name, held in {
        "row": "c extLst",
        "c": "f v is extLst",
        "is": "t r rPh phoneticPr",
        "r": "rPr t",
        "rPh": "t",
    }.items()
}
"""what the elements of a row may hold; all others hold a text"""
IN = {"row": "in a row", "c": "in a cell"}
WRITTEN = {"n": re.compile(r"\s*+[+-]?(?:[0-9]++\.?[0-9]*+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?\s*+"),
           "s": re.compile(r"[0-9]+"), "b": re.compile(r"[01]")}  # fmt: skip
CORNER = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")
PLAIN = re.compile(r"([A-Z]{1,3})([1-9][0-9]{0,6})")


class Refusal(Exception):  # noqa: N818 - it says what it is
    """The reason to refuse a file, in words that follow its path."""


class Mendable(Refusal):
    """A reason that is gone once a spreadsheet program has saved the file anew, which its words advise."""

    def __init__(self, fault: str) -> None:
        super().__init__(f"{fault}; {SAVE_AS}")


def short(text: str) -> str:
    """Return a name from a file, short and without control characters."""
    return repr(text if len(text) <= 80 else f"{text[:77]}...")


class Totals:
    """Totals over all parts of a workbook; raises Refusal beyond each limit."""

    def __init__(self) -> None:
        self.places = self.filled = self.formulas = self.outside = self.in_rows = self.in_pivots = 0
        self.of = dict.fromkeys(MOST_OF, 0)
        self.referred: set[tuple[str, ...]] = set()

    def element(self, name: str, weight: int, in_pivot: bool) -> None:
        """Count an element outside of rows."""
        self.outside += weight
        self.in_pivots += weight if in_pivot else 0
        if name in self.of:
            self.of[name] += 1
            if self.of[name] > MOST_OF[name]:
                raise Refusal(f"holds more than {MOST_OF[name]:,} elements <{name}>")
        if self.outside + self.in_pivots * self.of["sheet"] > MOST_OUTSIDE:
            what = "XML elements and attributes besides its cells"
            raise Refusal(f"holds more than {MOST_OUTSIDE:,} {what}")

    def reference(self, *key: str) -> None:
        """Note a reference to a part; refuse a second."""
        if key in self.referred:
            fault = f"refers twice to {short(key[-1])} as a part of its own"
            raise Refusal(f"{fault}; once is expected")
        self.referred.add(key)

    def in_row(self, weight: int) -> None:
        """Count an element of a row, with its attributes."""
        self.in_rows += weight
        if self.in_rows > MOST_IN_ROWS:
            raise Refusal(f"holds more than {MOST_CELLS:,} cells")

    def range(self, cells: int, places: int = 0) -> None:
        """Count cells that openpyxl makes, of rows and ranges, and the places of the rectangle around a sheet's."""
        self.filled, self.places = self.filled + cells, self.places + places
        for reached, most in ((self.places, MOST_PLACES), (self.filled, MOST_CELLS)):
            if reached > most:
                raise Refusal(
                    f"its cells reach over {reached:,} places; at most {most:,} are expected, "
                    "and one that lies far from the others counts all between"
                )

    def formula(self, length: int) -> None:
        """Count the characters of a formula."""
        self.formulas += length
        if self.formulas > MOST_FORMULAS:
            raise Refusal(f"its formulas have more than {MOST_FORMULAS:,} characters together")


def tag(element: Element) -> str:
    """Return an element's name without its namespace."""
    return str(element.tag).rpartition("}")[2]


def text_of(element: Element, name: str, part: str) -> str:
    """Return the text of an element of this name; raise Refusal where it is longer than allowed."""
    text = element.text or ""
    if len(text) > MOST_LONG.get(name, len(text)):
        most = f"more than {MOST_LONG[name]:,} characters"
        raise Refusal(f"{part} holds a text of {most} in one <{name}>")
    return text


def refuse_two_texts(element: Element, part: str) -> None:
    """Refuse a text that is written twice, whole and in runs: readers take the one, the other, or both."""
    names = [name for name in map(tag, element) if name in ("t", "r")]
    if "t" in names and len(names) > 1:
        raise Mendable(f"damaged: {part} holds <{names[1]}> in a text beside another")


class RawCell(NamedTuple):
    """A cell as it is written."""

    row: int
    column: int
    style: int  # its number
    kind: str  # the type of its value: n, s, str ...
    value: str | None
    how: dict[str, str] | None  # the attributes of its formula, if any
    formula: str


def cell_position(text: str, rule: re.Pattern[str] = CORNER) -> tuple[int, int]:
    """Return row and column of a cell; raise Refusal where a sheet has no such cell."""
    match = rule.fullmatch(text)
    if match is None:
        raise Mendable(f"damaged: {short(text)} stands where a cell is expected")
    letters, digits = match.groups()
    row, column = int(digits), column_index_from_string(letters.upper())
    if not (1 <= row <= LAST_ROW and column <= LAST_COLUMN):
        raise Refusal(f"holds a cell {short(text)}; the last cell of a sheet is XFD1048576")
    return row, column


class Rows:
    """Contents of a worksheet: ``written`` cells in order, ``looks`` of rows, and ``fonts`` within texts by place."""

    def __init__(self, name: str, count: Totals) -> None:
        self.name, self.count = name, count
        self.written: list[RawCell] = []
        self.looks: dict[int, dict[str, str]] = {}
        self.fonts: dict[tuple[int, int], list[Element]] = {}
        self.row = self.column = self.last_row = self.last_column = 0
        self._rows: set[int] = set()
        self._columns: set[int] = set()
        self._lengths: dict[str, int] = {}  # of formulas that are shared, by their number

    @property
    def size(self) -> int:
        """The number of cells of the rectangle around all cells, or of the cells if these are more."""
        return max(self.last_row * self.last_column, len(self.written))

    def begin(self, attributes: dict[str, str]) -> None:
        """Begin a row, numbered or next to the row before."""
        number = attributes.get("r")
        try:
            self.row = self.row + 1 if number is None else int(float(number))
        except (ValueError, OverflowError):
            fault = f"has a row numbered {short(number or '')}"
            raise Mendable(f"damaged: {self.name} {fault}") from None
        if self.row in self._rows:
            raise self._damaged(f"the row {self.row} twice")
        self._rows.add(self.row)
        self._columns, self.column = set(), 0
        looks = {name: text for name, text in attributes.items() if "}" not in name}
        if not looks.keys() <= PLACED:
            self.looks[self.row] = looks

    def cell(self, cell: Element) -> None:
        """Take a whole cell into its row."""
        self._place(cell.get("r"))
        kind, style = cell.get("t", "n"), cell.get("s", "0")
        if kind not in KINDS or not style.isdecimal():
            raise self._damaged(f"a cell of an unknown kind, {short(kind)}")
        held = {str(part.tag): part for part in cell}
        if not held.keys() <= USUAL or any(map(len, cell)):
            self.require_within(cell)
        if len(held) < len(cell):
            names = list(map(tag, cell))
            raise self._damaged(f"<{max(names, key=names.count)}> twice in a cell")
        written, how, value = held.get(f"{MAIN}is"), held.get(FORMULA), held.get(VALUE)
        text = None if value is None else text_of(value, "v", self.name)
        if written is not None:
            text = self._text(written, text)
        formula, given = ("", None) if how is None else (self._formula(how), how.attrib)
        rule = WRITTEN.get(kind)
        if rule and text and not rule.fullmatch(text):
            raise self._damaged(f"{short(text)} as the value of a cell of the kind {kind!r}")
        self.written.append(RawCell(self.row, self.column, int(style), kind, text, given, formula))

    def require_within(self, element: Element) -> None:
        """Refuse what no element of a row may hold."""
        may = WITHIN.get(str(element.tag), ())
        for part in element:
            if part.tag not in may:
                where = IN.get(tag(element), f"inside of <{tag(element)}>")
                where = where if str(part.tag).startswith(MAIN) else "within a row"
                raise self._damaged(f"<{tag(part)}> {where}")
            if len(part) and part.tag not in FREE:
                self.require_within(part)

    def _place(self, at: str | None) -> None:
        """Place a cell, named or next to the cell before."""
        row, column = cell_position(at, PLAIN) if at else (self.row, self.column + 1)
        if not (1 <= row <= LAST_ROW and column <= LAST_COLUMN):
            raise Refusal(f"{self.name} reaches beyond the last cell of a sheet, XFD1048576")
        if row != self.row:
            raise self._damaged(f"the cell {short(at or '')} in the row {self.row}")
        if column in self._columns:
            raise self._damaged(f"the cell {short(at or '')} twice")
        self._columns.add(column)
        self.column = column
        self.last_row, self.last_column = max(row, self.last_row), max(column, self.last_column)

    def _text(self, element: Element, before: str | None) -> str | None:
        """Return a text that is written in its cell, the text before it where there is none; keep the fonts within."""
        refuse_two_texts(element, self.name)
        if fonts := list(element.iter(f"{MAIN}rPr")):
            self.fonts[self.row, self.column] = fonts
        parts = [part for child in element if tag(child) in ("t", "r") for part in (child, *child)]
        texts = [text_of(part, "t", self.name) for part in parts if tag(part) == "t"]
        return "".join([before or "", *texts]) if texts else before

    def _formula(self, element: Element) -> str:
        """Return a formula; count it, once more for each cell that shares it."""
        text, kind = text_of(element, "f", self.name), element.get("t", "normal")
        if kind not in FORMULAS:
            raise self._damaged(f"a formula of an unknown kind, {short(kind)}")
        shared = element.get("si", "") if kind == "shared" else None
        if shared is not None and text:
            if shared in self._lengths:
                raise self._damaged(f"two formulas to be shared under the number {short(shared)}")
            self._lengths[shared] = len(text)
        self.count.formula(len(text) or self._lengths.get(shared or "", 0))
        return text

    def _damaged(self, what: str) -> Mendable:
        return Mendable(f"damaged: {self.name} holds {what}")
