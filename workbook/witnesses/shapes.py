"""A formula as a shape with arguments: formulas of a column differ in their references only.

``=$B7*drive_tau+Laws!C$3`` in row 7 and the formula below it have the same shape, ``=A1*A2+A3``, and three
arguments each. Texts in quotes become arguments too, so that nothing of a file's text reaches a compiler.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from openpyxl.utils import column_index_from_string, get_column_letter

TOKEN = re.compile(
    r"""
    (?P<text>"(?:[^"]|"")*")
    |(?P<reference>
        (?:(?P<sheet>'(?:[^']|'')+'|[^\W\d][\w.]*)!)?
        \$?(?P<c1>[A-Za-z]{1,3})\$?(?P<r1>[0-9]{1,7})(?::\$?(?P<c2>[A-Za-z]{1,3})\$?(?P<r2>[0-9]{1,7}))?
        (?![\w(.!:])
    )
    |(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)
    |(?P<function>[^\W\d][\w.]*\()
    |(?P<error>\#(?:N/A|VALUE!|REF!|DIV/0!|NUM!|NAME\?|NULL!))
    |(?P<name>[^\W\d][\w.\\?]*!?)
    |(?P<plain>[-+*/^&=<>(),;:%{}\s])
    """,
    re.VERBOSE,
)
CORNER = re.compile(r"\$?[A-Za-z]{1,3}(?P<fixed>\$?)[0-9]{1,7}")
MOST_CELLS = 200_000  # of one range: what is larger is refused


class FormulaError(ValueError):
    """A formula that cannot be evaluated, and the error value it stands for."""

    def __init__(self, value: str, reason: str) -> None:
        super().__init__(reason)
        self.value = value


class Area(NamedTuple):
    """A cell or a rectangle of cells; ``single`` where the formula means one cell, not a range of one."""

    sheet: str
    top: int
    left: int
    bottom: int
    right: int
    single: bool


@dataclass(frozen=True)
class Formula:
    """A shape, and what its arguments are: areas, or texts; ``written`` is how the file writes each of them."""

    shape: str
    arguments: tuple[Area | str, ...]
    functions: frozenset[str]
    written: tuple[str, ...] = ()
    _moving: list[int] | None = None  # which arguments follow the row, once asked for

    @property
    def anchors(self) -> tuple[str, ...]:
        """Where each reference has its ``$``: ``$Timing!$B7:C$9`` gives ``$cr:c$r``; nothing for a name or a text."""
        return tuple(anchored(w) for w in self.written)

    def in_row(self, row: int, below: int) -> Formula:
        """Return the formula as it would stand in another row, ``below`` being the one it stands in."""
        if self._moving is None:
            moving = [
                i for i, (a, w) in enumerate(zip(self.arguments, self.written, strict=True)) if moves(a, w, below)
            ]
            object.__setattr__(self, "_moving", moving)
        arguments = list(self.arguments)
        for i in self._moving or ():
            area = arguments[i]
            if isinstance(area, Area):
                top, bottom = (row if corner == below else corner for corner in (area.top, area.bottom))
                arguments[i] = Area(area.sheet, top, area.left, bottom, area.right, area.single)
        return Formula(self.shape, tuple(arguments), self.functions, self.written)


def read(text: str, sheet: str, area: Callable[[str, str], Area]) -> Formula:
    """Split a formula into its shape and arguments; ``area`` resolves a name, or a sheet's title.

    Raises FormulaError for text that is no formula of the kinds that can be evaluated.
    """
    shape: list[str] = []
    arguments: list[Area | str] = []
    functions: set[str] = set()
    written: list[str] = []
    position = 0
    for token in TOKEN.finditer(text):
        if token.start() != position:
            break
        position = token.end()
        kind = token.lastgroup
        if kind in ("plain", "error"):
            shape.append(token.group())
        elif kind == "number":
            shape.append(token.group() if token.group().isdigit() else repr(float(token.group())))
        elif kind == "function":
            functions.add(token.group()[:-1].upper())
            shape.append(token.group().upper())
        elif kind == "name" and token.group().upper() in ("TRUE", "FALSE"):
            shape.append(token.group().upper())
        else:
            arguments.append(argument(token, sheet, area))
            written.append(token.group())
            shape.append(dummy(len(arguments), arguments[-1]))
    if position != len(text):
        raise FormulaError("#NAME?", f"cannot be read from {text[position : position + 20]!r} on")
    return Formula("".join(shape), tuple(arguments), frozenset(functions), tuple(written))


def argument(token: re.Match[str], sheet: str, area: Callable[[str, str], Area]) -> Area | str:
    """Return what a token of a formula stands for."""
    if token.lastgroup == "text":
        return token.group()[1:-1].replace('""', '"')
    if token.lastgroup == "name":
        return area(token.group(), sheet)
    named = token.group("sheet")
    title = sheet if named is None else area(f"{unquoted(named)}!", sheet).sheet
    top, left = int(token.group("r1")), column(token.group("c1"))
    if token.group("c2") is None:
        return Area(title, top, left, top, left, single=True)
    bottom, right = int(token.group("r2")), column(token.group("c2"))
    found = Area(title, min(top, bottom), min(left, right), max(top, bottom), max(left, right), single=False)
    return bounded(found)


def anchored(written: str) -> str:
    """Return where a reference has its ``$``, or nothing for a name or a text."""
    reference = written.rpartition("!")[2]
    if written.startswith('"') or not CORNER.fullmatch(reference.partition(":")[0]):
        return ""
    return re.sub(r"[0-9]+", "r", re.sub(r"[A-Za-z]+", "c", reference))


def moves(argument: Area | str, written: str, row: int) -> bool:
    """Whether a reference is written relative to ``row``, in which it has a corner."""
    if isinstance(argument, str):
        return False
    corners = [CORNER.fullmatch(corner) for corner in written.rpartition("!")[2].split(":")]
    fixed = any(corner is None or corner.group("fixed") for corner in corners)
    return not fixed and row in (argument.top, argument.bottom)


@lru_cache(maxsize=10_000)
def row_mark(row: int) -> re.Pattern[str]:
    """Return the pattern of a cell of ``row`` that is written relative to it."""
    return re.compile(rf"(?<![\w.$])(\$?[A-Z]{{1,3}}){row}(?![\w.(])")


def bounded(area: Area) -> Area:
    """Return the area, or refuse one of absurd size."""
    if (area.bottom - area.top + 1) * (area.right - area.left + 1) > MOST_CELLS:
        raise FormulaError("#VALUE!", f"refers to a range of more than {MOST_CELLS:,} cells")
    return area


def unquoted(sheet: str) -> str:
    """Return a sheet's title as it stands before a ``!``."""
    return sheet[1:-1].replace("''", "'") if sheet.startswith("'") else sheet


@lru_cache(maxsize=4096)
def column(letters: str) -> int:
    """Return the number of a column; FormulaError beyond the last one, XFD."""
    number = column_index_from_string(letters.upper())
    if number > 16_384:
        raise FormulaError("#NAME?", f"there is no column {letters}")
    return number


@lru_cache(maxsize=4096)
def letters(number: int) -> str:
    """Return the letters of a column."""
    return get_column_letter(number)


def dummy(number: int, argument: Area | str) -> str:
    """Return the reference by which a shape names its argument: a cell, or a range, of column A."""
    return f"A{number}" if isinstance(argument, str) or argument.single else f"A{number}:B{number}"
