"""Rows as spreadsheet programs write nearly all of theirs, taken by one pattern a cell: a third of the parser's time.

What the patterns accept is well-formed XML of one reading, and what they take is what :class:`Rows` makes of it. All
else, a single odd cell as well as what must be refused, is left to the parser and its rules: nothing is refused here.
"""

import re

from workbook.reading.count import MOST_FORMULAS, MOST_IN_ROWS, MOST_LONG
from workbook.reading.rows import LAST_COLUMN, LAST_ROW, NOTHING, PLACED, WRITTEN, Rows, Written, column_number

OPEN, CLOSE, END_OF_ROW = b"<sheetData>", b"</sheetData>", "</row>"
PLAIN = r"[^<&\x00-\x1f\ufffe\uffff]*+"
TEXT = rf"({PLAIN}(?:&(?:amp|lt|gt|quot|apos);{PLAIN})*+)"
NAMES = "r|spans|ht|customHeight|hidden|outlineLevel|collapsed|s|customFormat"
ROW = re.compile(rf'<row((?: (?:{NAMES})="[\w.:]{{1,20}}")*+)(/?)>', re.ASCII)
ATTRIBUTE = re.compile(r'(\w+)="([^"]*)"')
CELL = re.compile(
    r'<c r="([A-Z]{1,3})([1-9][0-9]{0,6})"( s="([0-9]{1,7})")?( t="(n|s|str|b|e)")?'
    rf'(?:/>|>(?:<f(?: aca="false")?>{TEXT}</f>)?(?:<v>{TEXT}</v>|(<v ?/>))?</c>)'
)
ENTITIES = {"&lt;": "<", "&gt;": ">", "&quot;": '"', "&apos;": "'", "&amp;": "&"}
ENTITY = re.compile("|".join(ENTITIES))


class OddError(Exception):
    """Something that the patterns do not take."""


def rows_between(data: bytes) -> tuple[int, int]:
    """Return where the rows of a worksheet's part may begin and end; twice the same place where they do not."""
    begin, end = data.find(OPEN) + len(OPEN), data.rfind(CLOSE)
    return (begin, end) if len(OPEN) <= begin <= end else (0, 0)


def taken(rows: Rows, text: str) -> bool:
    """Enter all rows of a worksheet, and count them; return whether they are plain. Nothing is entered otherwise."""
    found = Taken()
    try:
        found.take(text)
    except OddError:
        return False
    count = rows.count
    if count.in_rows + found.weight > MOST_IN_ROWS or count.formulas + found.length > MOST_FORMULAS:
        return False
    count.in_rows += found.weight
    count.element("row", found.heads, in_pivot=False)
    count.formulas += found.length
    rows.written, rows.looks = found.written, found.looks
    rows.cells = len(found.written)
    rows.last_row = max((cell.row for cell in found.written), default=0)
    rows.last_column = max((cell.column for cell in found.written), default=0)
    return True


class Taken:
    """The rows of a text: their cells and looks, how much they count, and the characters of their formulas."""

    def __init__(self) -> None:
        self.written: list[Written] = []
        self.looks: dict[int, dict[str, str]] = {}
        self.weight = self.heads = self.length = 0
        self._met: set[int] = set()

    def take(self, text: str) -> None:
        """Take row after row; raise OddError for anything that is none."""
        if "]]>" in text:
            raise OddError
        at = 0
        while at < len(text):
            head = ROW.match(text, at)
            if head is None:
                raise OddError
            number, at = self._begin(ATTRIBUTE.findall(head[1])), head.end()
            if not head[2]:
                at = self._cells(text, at, number)
                if not text.startswith(END_OF_ROW, at):
                    raise OddError
                at += len(END_OF_ROW)

    def _begin(self, found: list[tuple[str, str]]) -> int:
        """Return the number of a row that is met for the first time; keep its looks."""
        attributes = dict(found)
        digits = attributes.get("r", "")
        number = int(digits) if digits.isdecimal() and len(digits) < 8 else 0
        if not 1 <= number <= LAST_ROW or number in self._met or len(attributes) < len(found):
            raise OddError
        self._met.add(number)
        self.weight += 1 + len(found)
        self.heads += 1 + len(found)
        if not attributes.keys() <= PLACED:
            self.looks[number] = attributes
        return number

    def _cells(self, text: str, at: int, number: int) -> int:
        """Take the cells that follow one another; return the place after the last."""
        columns: set[int] = set()
        digits, match, add = str(number), CELL.match, self.written.append
        while found := match(text, at):
            letters, row, styled, style, typed, kind, formula, value, empty = found.groups()
            column = column_number(letters)
            if row != digits or column in columns or column > LAST_COLUMN:
                raise OddError
            columns.add(column)
            kind = kind or "n"
            if value:
                value = checked(value, kind)
            elif empty:
                value = ""
            how = None
            if formula is not None:
                formula, how = written_out(formula, "f"), NOTHING
                self.length += len(formula)
            self.weight += 2 + bool(styled) + bool(typed) + (how is not None) + (value is not None)
            add(Written(number, column, int(style or 0), kind, value, how, formula or ""))
            at = found.end()
        return at


def checked(value: str, kind: str) -> str:
    """Return the text of a value that is written as its kind should be."""
    rule = WRITTEN.get(kind)
    if rule and not rule.fullmatch(value):
        raise OddError
    return written_out(value, "v")


def written_out(text: str, element: str) -> str:
    """Return a text with its entities written out, of a length that the element may have."""
    if "&" in text:
        text = ENTITY.sub(lambda found: ENTITIES[found[0]], text)
    if len(text) > MOST_LONG[element]:
        raise OddError
    return text
