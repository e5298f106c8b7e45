"""A formula as a shape with arguments: formulas of a column differ in their references only.

``=$B7*drive_tau+Laws!C$3`` in row 7 and the formula below it have the same shape, ``=A1*A2+A3``, and three
arguments each. Texts in quotes become arguments too, so that of a file's text nothing but numbers, operators and
the names of functions reaches a compiler.
"""

import math
import re
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

from openpyxl.utils.cell import coordinate_to_tuple

from workbook.book.address import Address

LONGEST = 8_192  # characters of a formula; Excel's limit
WHOLE = 1e15  # numbers below are exact, and written without a point where they are whole
LAST_ROW, LAST_COLUMN = 1_048_576, 16_384
MOST_CELLS = 200_000  # of a range: what is larger is refused

_SHEET = r"(?:'(?:[^']|'')++'|[\w.]++)!"
_CELL = r"\$?[A-Za-z]{1,3}\$?[0-9]{1,7}"
_END = r"(?![\w.(!\\?\[])"
# a scan: what is repeated is never given back, and a token that none of these is ends it
TOKEN = re.compile(
    rf"""
    (?P<function>[^\W\d][\w.]*+\()
    |(?P<text>"(?:[^"]|"")*+")
    |(?P<reference>(?:{_SHEET})?{_CELL}(?::(?:{_SHEET})?{_CELL})?{_END})
    |(?P<number>(?:[0-9]++\.?[0-9]*+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+(?![\w.:!]))
    |(?P<lines>(?:{_SHEET})?(?:\$?[A-Za-z]{{1,3}}:\$?[A-Za-z]{{1,3}}|\$?[0-9]++:\$?[0-9]++){_END})
    |(?P<error>(?:{_SHEET})?\#(?:N/A|VALUE!|REF!|DIV/0!|NUM!|NAME\?|NULL!))
    |(?P<name>(?:{_SHEET})?[^\W\d][\w.\\?]*+)
    |(?P<space>\s++)
    |(?P<other>[^-+*/^&=<>(),;%{{}}])
    """,
    re.VERBOSE,
)
REFERENCE = re.compile(rf"({_SHEET})?({_CELL})(?::({_SHEET})?({_CELL}))?")
FUNCTION = re.compile(r"[^\W\d][\w.]*(?=\()")


class FormulaError(ValueError):
    """A formula that cannot be evaluated, and the error value it stands for."""

    def __init__(self, value: str, reason: str) -> None:
        super().__init__(reason)
        self.value = value


class Area(NamedTuple):
    """A cell or a rectangle of cells; ``single`` where the formula means a cell, not a range."""

    sheet: str
    top: int
    left: int
    bottom: int
    right: int
    single: bool

    @property
    def size(self) -> int:
        """The number of cells."""
        return (self.bottom - self.top + 1) * (self.right - self.left + 1)

    @property
    def columns(self) -> range:
        """The numbers of the columns."""
        return range(self.left, self.right + 1)

    @property
    def first(self) -> Address:
        """The upper left cell."""
        return Address(self.sheet, self.top, self.left)

    @property
    def a1(self) -> str:
        """The cell or range on its sheet, such as ``B7:C9``."""
        last = Address(self.sheet, self.bottom, self.right).a1
        return self.first.a1 if self.single else f"{self.first.a1}:{last}"

    def cells(self) -> list[Address]:
        """Return the cells, row by row."""
        return [Address(self.sheet, r, c) for r in range(self.top, self.bottom + 1) for c in self.columns]

    def holds(self, cell: Address) -> bool:
        """Whether a cell lies within."""
        within = self.top <= cell.row <= self.bottom and self.left <= cell.column <= self.right
        return within and cell.sheet == self.sheet


class Formula(NamedTuple):
    """A shape, and what its arguments are: areas, or texts; ``written`` is how the file writes each of them."""

    shape: str
    arguments: tuple[Area | str, ...]
    written: tuple[str, ...]

    @property
    def functions(self) -> frozenset[str]:
        """The names of the functions called, in capitals."""
        return frozenset(FUNCTION.findall(self.shape))

    @property
    def anchors(self) -> tuple[str, ...]:
        """The places of ``$`` in references: ``$Timing!$B7:C$9`` gives ``$cr:c$r``; nothing for a name or a text."""
        return tuple(anchors(w) for w in self.written)


# a defined name used on a sheet, or ``title!``, to what it means
Resolve = Callable[[str, str], Area]


def read(text: str, sheet: str, area: Resolve, known: dict[str, Area | str] | None = None) -> Formula:
    """Split a formula into shape and arguments, by ``area``; raise FormulaError for what cannot be evaluated.

    ``known`` keeps the arguments met on the same sheet, for the formulas that follow.
    """
    if len(text) > LONGEST:
        raise FormulaError("#NAME?", f"the formula is longer than {LONGEST:,} characters")
    arguments: list[Area | str] = []
    written: list[str] = []
    seen: dict[str, Area | str] = {} if known is None else known

    def replaced(token: re.Match[str]) -> str:
        word = token[0]
        argument = seen.get(word)
        if argument is None:
            kind = token.lastgroup
            if kind == "function" or kind == "space" or (kind == "name" and word.upper() in ("TRUE", "FALSE")):
                return word.upper()
            if kind == "number":
                return number(word)
            if kind == "error":
                return word[word.rindex("#") :].upper()
            seen[word] = argument = meant(kind, word, sheet, area)
        arguments.append(argument)
        written.append(word)
        cell = f"A{len(arguments)}"  # of column A: the reference, or range, by which the shape names the argument
        return cell if isinstance(argument, str) or argument.single else f"{cell}:B{len(arguments)}"

    shape = "=" + TOKEN.sub(replaced, text[1:])
    return Formula(shape, tuple(arguments), tuple(written))


def words(text: str) -> Iterator[tuple[str, str]]:
    """Yield the words of a formula with their kinds, and the signs between them, without blanks."""
    at = 0
    while at < len(text):
        token = TOKEN.match(text, at)
        signs = text[at : at + 2] if text[at : at + 2] in ("<>", "<=", ">=") else text[at]
        kind, word = (str(token.lastgroup), token[0]) if token else ("sign", signs)
        at += len(word)
        if kind != "space":
            yield kind, word


def meant(kind: str | None, word: str, sheet: str, area: Resolve) -> Area | str:
    """Return the area or the text that a word of a formula stands for."""
    if kind == "reference":
        return reference(word, sheet, area)
    if kind == "text":
        return word[1:-1].replace('""', '"')
    if kind == "name":
        before, mark, name = word.rpartition("!")
        scope = area(f"{unquoted(before)}!", sheet).sheet if mark else sheet
        return require_bounded(area(name, scope), word)
    if kind == "lines":
        raise FormulaError("#REF!", f"whole rows or columns, {word}, are not evaluated")
    raise FormulaError("#NAME?", f"{word!r} cannot be read; tables and computed references are not evaluated")


def reference(text: str, sheet: str, area: Resolve) -> Area:
    """Return the cell or range that a reference on ``sheet`` means."""
    match = REFERENCE.fullmatch(text)
    if match is None:
        raise FormulaError("#NAME?", f"{text} is no reference")
    before, first, before_second, second = match.groups()
    title = area(f"{unquoted(before[:-1])}!", sheet).sheet if before else sheet
    top, left = corner(first)
    if second is None:
        return Area(title, top, left, top, left, single=True)
    if before_second and area(f"{unquoted(before_second[:-1])}!", sheet).sheet != title:
        raise FormulaError("#REF!", f"{text} spans sheets")
    bottom, right = corner(second)
    top, bottom, left, right = min(top, bottom), max(top, bottom), min(left, right), max(left, right)
    return require_bounded(Area(title, top, left, bottom, right, single=False), text)


def corner(cell: str) -> tuple[int, int]:
    """Return row and column of ``$B$7``; raise FormulaError where no sheet has such a cell."""
    row, number = coordinate_to_tuple(cell.replace("$", "").upper())
    if not (1 <= row <= LAST_ROW and number <= LAST_COLUMN):
        raise FormulaError("#NAME?", f"there is no cell {cell}")
    return row, number


def number(text: str) -> str:
    """Return a number as Python writes it, ``1.0`` and ``1`` alike: ``007`` would be an error, ``1E999`` infinite."""
    value = float(text)
    if not math.isfinite(value):
        raise FormulaError("#NUM!", f"{text[:20]} is larger than any number")
    return str(int(value)) if value.is_integer() and value < WHOLE else repr(value)


def require_bounded(area: Area, text: str) -> Area:
    """Return the area, or refuse an area of absurd size."""
    if area.size > MOST_CELLS:
        raise FormulaError("#REF!", f"{text} is a range of more than {MOST_CELLS:,} cells")
    return area


def unquoted(sheet: str) -> str:
    """Return a sheet's title as it stands before a ``!``."""
    return sheet[1:-1].replace("''", "'") if sheet.startswith("'") else sheet


def anchors(written: str) -> str:
    """Return where a reference has its ``$``, or nothing for a name or a text."""
    if written.startswith('"') or not REFERENCE.fullmatch(written):
        return ""
    return re.sub(r"[0-9]+", "r", re.sub(r"[A-Za-z]+", "c", re.sub(_SHEET, "", written)))


@lru_cache(maxsize=20_000)
def functions_in(text: str) -> frozenset[str]:
    """Return the functions that a formula calls, in capitals and without prefix."""
    called = (word[:-1].upper() for kind, word in words(text) if kind == "function")
    return frozenset(name.removeprefix("_XLFN.").removeprefix("_XLWS.") for name in called)
