"""The rows of a worksheet's part, met one by one: each cell once and of one reading, and what it was saved with.

Where the standard leaves it to a reader what two formulas in a cell mean, or an element inside of a formula, readers
differ, and a file could show one thing and be verified as another: such a part is refused.
"""

import re
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple
from xml.etree.ElementTree import Element, SubElement

from openpyxl.utils import column_index_from_string

from workbook.reading.count import MOST_DEPTH, MOST_IN_ROWS, MOST_IN_TAG, MOST_LONG, SAVE_AS, Count, Refusal, shown

MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
LAST_ROW, LAST_COLUMN = 1_048_576, 16_384
KINDS = frozenset({"n", "s", "str", "b", "e", "inlineStr", "d"})
FORMULAS = frozenset({"normal", "array", "shared", "dataTable"})
USUAL = frozenset({"r", "s", "t"})  # attributes of almost every cell
PLACED = frozenset({"r", "spans"})  # attributes of a row that say nothing of its looks
IN_CELL = frozenset({"f", "v", "is", "extLst"})
NOTHING: dict[str, str] = {}
WITHIN = {"is": frozenset({"t", "r", "rPh", "phoneticPr"}), "r": frozenset({"rPr", "t"}), "rPh": frozenset({"t"})}
FREE = frozenset({"extLst", "rPr"})  # what stands in these is no part of a text
WRITTEN = {
    "n": re.compile(r"\s*+[+-]?(?:[0-9]++\.?[0-9]*+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?\s*+"),
    "s": re.compile(r"[0-9]+"),
    "b": re.compile(r"[01]"),
}
CORNER = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")
PLAIN = re.compile(r"([A-Z]{1,3})([1-9][0-9]{0,6})")


class Written(NamedTuple):
    """A cell as it is written: its place, the number of its style, the type of its value (``n``, ``str`` ...).

    Besides the value's text, and the attributes and the text of its formula, where it has them.
    """

    row: int
    column: int
    style: int
    kind: str
    value: str | None
    how: dict[str, str] | None
    formula: str


@lru_cache(maxsize=20_000)
def column_number(letters: str) -> int:
    """Return the number of a column."""
    return column_index_from_string(letters.upper())


def corner(text: str, rule: re.Pattern[str] = CORNER) -> tuple[int, int]:
    """Return row and column of a cell; raise Refusal where a sheet has no such cell."""
    found = rule.fullmatch(text)
    if found is None:
        raise Refusal(f"damaged: {shown(text)} stands where a cell is expected; {SAVE_AS}")
    letters, digits = found.groups()
    row, column = int(digits), column_number(letters)
    if not (1 <= row <= LAST_ROW and column <= LAST_COLUMN):
        raise Refusal(f"holds a cell {shown(text)}; the last cell of a sheet is XFD1048576")
    return row, column


class Rows:
    """What one worksheet contains, read by expat: its ``written`` cells in order, the ``looks`` of rows by number.

    Besides the ``fonts`` within texts, by row and column, and where in the part's bytes the rows are.
    """

    def __init__(self, name: str, count: Count, prefix: str) -> None:
        self.name, self.count, self.prefix = name, count, prefix
        self.written: list[Written] = []
        self.looks: dict[int, dict[str, str]] = {}
        self.fonts: dict[tuple[int, int], list[Element]] = {}
        self.span = (0, 0)
        self.met = False  # the element that all rows stand in
        self.leave: Callable[[str], None] = lambda tag: None  # what is called at the end of a row
        self.own = tuple(prefix + name for name in ("worksheet", "sheetData", "row", "c"))
        self._tag = self.own[3]
        self.of_cell = {prefix + name: name for name in ("f", "v")}
        self.row = self.column = self.last_row = self.last_column = self.cells = 0
        self._rows: set[int] = set()
        self._columns: set[int] = set()
        self.path: list[str] = []  # the elements that are open within the row
        self._met: list[str] = []  # those that the cell has, or the text that is open
        self._kind = "n"
        self._style = 0
        self._text: list[str] = []
        self._length = 0
        self._value: str | None = None
        self._how: dict[str, str] | None = None
        self._formula_text = ""
        self._shared: str | None = None
        self._lengths: dict[str, int] = {}  # of formulas that are shared, by their number

    @property
    def size(self) -> int:
        """How many cells the rectangle around all cells has, or how many cells there are if these are more."""
        return max(self.last_row * self.last_column, self.cells)

    def begin(self, attributes: dict[str, str]) -> None:
        """Begin a row, numbered or next to the one before."""
        number = attributes.get("r")
        self.count.in_row(1 + len(attributes))
        try:
            self.row = self.row + 1 if number is None else int(float(number))
        except (ValueError, OverflowError):
            raise Refusal(f"damaged: {self.name} has a row numbered {shown(number or '')}; {SAVE_AS}") from None
        if self.row in self._rows:
            raise self._damaged(f"the row {self.row} twice")
        self._rows.add(self.row)
        self._columns, self.column = set(), 0
        if not attributes.keys() <= PLACED:
            self.looks[self.row] = attributes

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Begin an element within a row."""
        path, count = self.path, self.count
        count.in_rows += 1 + len(attributes)
        if count.in_rows > MOST_IN_ROWS:
            count.in_row(0)
        if attributes:
            if not path and tag == self._tag and attributes.keys() <= USUAL:
                self._cell(attributes)
                path.append("c")
                return
        elif len(path) == 1 and self._plain(tag):
            return
        if attributes and sum(map(len, attributes.values())) > MOST_IN_TAG:
            raise Refusal(f"{self.name} holds an element with more than {MOST_IN_TAG:,} characters of attributes")
        name = tag.removeprefix(self.prefix)
        if FREE.isdisjoint(path):
            if ":" in name or any(key.startswith("xmlns") for key in attributes):
                raise self._damaged(f"<{shown(tag)}> within a row")
            if path:
                self._in_cell(name, attributes)
            elif name == "c":
                self._cell(attributes)
            elif name != "extLst":
                raise self._damaged(f"<{name}> in a row")
        elif tag in self.own or MAIN in attributes.values():
            raise self._damaged(f"<{name}> inside of <{path[-1]}>")
        if name == "rPr":
            self.fonts.setdefault((self.row, self.column), []).append(Element(name))
        elif path and path[-1] == "rPr" and path[0] == "c":
            SubElement(self.fonts[self.row, self.column][-1], name, attributes)
        path.append(name)
        if len(path) > MOST_DEPTH:
            raise Refusal(f"{self.name} is nested more than {MOST_DEPTH} deep")

    def _plain(self, tag: str) -> bool:
        """Begin the formula or the value of a cell, as most of all elements are; return whether it is one."""
        name, met = self.of_cell.get(tag), self._met
        if name is None or self.path[0] != "c" or name in met:
            return False
        met.append(name)
        self.path.append(name)
        self._text, self._length = [], 0
        if name == "f":
            self._shared, self._how = None, NOTHING
        return True

    def end(self, tag: str) -> None:
        """End an element within a row, or the row."""
        path = self.path
        if not path:
            self.leave(tag)
            return
        name = path.pop()
        if len(path) == 1 and path[0] not in FREE:
            self._end_in_cell(name)
        elif not path and name == "c":
            self._end_cell()
        elif name == "t" and path[:2] == ["c", "is"] and path[2:] in ([], ["r"]):
            self._value = (self._value or "") + "".join(self._text)

    def characters(self, text: str) -> None:
        """Take the text of an element."""
        if self.path and self.path[-1] in MOST_LONG and FREE.isdisjoint(self.path):
            name = self.path[-1]
            self._text.append(text)
            self._length += len(text)
            if self._length > MOST_LONG[name]:
                raise Refusal(f"{self.name} holds a text of more than {MOST_LONG[name]:,} characters in one <{name}>")

    def aside(self, *said: str) -> None:
        """Refuse a comment within a row: some readers take what stands before it only."""
        raise self._damaged("a comment within a row")

    def _cell(self, attributes: dict[str, str]) -> None:
        """Place a cell, named or next to the one before."""
        at = attributes.get("r")
        row, column = corner(at, PLAIN) if at else (self.row, self.column + 1)
        if not (1 <= row <= LAST_ROW and column <= LAST_COLUMN):
            raise Refusal(f"{self.name} reaches beyond the last cell of a sheet, XFD1048576")
        if row != self.row:
            raise self._damaged(f"the cell {shown(at or '')} in the row {self.row}")
        if column in self._columns:
            raise self._damaged(f"the cell {shown(at or '')} twice")
        self._columns.add(column)
        self.column = column
        self.cells += 1
        if row > self.last_row:
            self.last_row = row
        if column > self.last_column:
            self.last_column = column
        self._kind, self._value, self._met = attributes.get("t", "n"), None, []
        self._how, self._formula_text, style = None, "", attributes.get("s", "0")
        if self._kind not in KINDS or not style.isdecimal():
            raise self._damaged(f"a cell of an unknown kind, {shown(self._kind)}")
        self._style = int(style)

    def _in_cell(self, name: str, attributes: dict[str, str]) -> None:
        path, met = self.path, self._met
        self._text, self._length = [], 0
        if len(path) == 1:
            if name not in IN_CELL or name in met:
                raise self._damaged(f"<{name}> {'twice in a cell' if name in met else 'in a cell'}")
            met.append(name)
            if name == "f":
                self._formula(attributes)
        elif name not in WITHIN.get(path[-1], ()):
            raise self._damaged(f"<{name}> inside of <{path[-1]}>")
        elif len(path) == 2:
            refuse_two_texts(name, met, self.name)

    def _formula(self, attributes: dict[str, str]) -> None:
        kind = attributes.get("t", "normal")
        if kind not in FORMULAS:
            raise self._damaged(f"a formula of an unknown kind, {shown(kind)}")
        self._how = attributes
        self._shared = attributes.get("si", "") if kind == "shared" else None
        if self._shared is not None:
            self.count.formula(self._lengths.get(self._shared, 0))

    def _end_in_cell(self, name: str) -> None:
        """Keep a value; count a formula, once more for each cell that shares it."""
        if name == "v":
            self._value = "".join(self._text)
        elif name == "f":
            self._formula_text = "".join(self._text)
            self.count.formula(self._length)
            if self._shared is not None and self._length:
                if self._shared in self._lengths:
                    raise self._damaged(f"two formulas to be shared under the number {shown(self._shared)}")
                self._lengths[self._shared] = self._length
        self._text, self._length = [], 0

    def _end_cell(self) -> None:
        rule = WRITTEN.get(self._kind)
        if rule and self._value and not rule.fullmatch(self._value):
            raise self._damaged(f"{shown(self._value)} as the value of a cell of the kind {self._kind!r}")
        self.written.append(Written(
            self.row, self.column, self._style, self._kind, self._value, self._how, self._formula_text,
        ))  # fmt: skip

    def _damaged(self, what: str) -> Refusal:
        return Refusal(f"damaged: {self.name} holds {what}; {SAVE_AS}")


def refuse_two_texts(name: str, met: list[str], part: str) -> None:
    """Refuse a text that is written twice, whole and in runs: readers take the one, the other, or both."""
    if (name == "t" and ("t" in met or "r" in met)) or (name == "r" and "t" in met):
        raise Refusal(f"damaged: {part} holds <{name}> in a text beside another; {SAVE_AS}")
    met.append(name)
