"""Formulas of a sheet, those of a column taken apart once: they differ in the number of their row only."""

import re
from typing import NamedTuple

from workbook.book.formula import Area, Formula, Resolve, read

HERE, ABOVE = "\0", "\1"  # stand for the number of the formula's row, and of the row above; no cell's text has them
_ROW = r"\$?[A-Za-z]{1,3}\$?([\0\1]|[0-9]+)"
MOVING = re.compile(rf"(?:[^\0\1]*!)?{_ROW}(?::{_ROW})?")


class Moving(NamedTuple):
    """A reference that moves with the row of its formula: how far its corners lie from that row, or None."""

    area: Area
    top: int | None
    bottom: int | None

    def at(self, row: int) -> Area:
        """Return what it means in the formula of a row."""
        area, top, bottom = self
        first = area.top if top is None else row + top
        last = first if area.single else area.bottom if bottom is None else row + bottom
        return Area(area.sheet, min(first, last), area.left, max(first, last), area.right, area.single)


class Pattern(NamedTuple):
    """A formula with its row left open; ``formula`` is the one in which it was met first."""

    formula: Formula
    arguments: tuple[Area | str | Moving, ...]


class Moved(NamedTuple):
    """The formula of a pattern in a row: what it refers to is worked out when it is asked for."""

    pattern: Pattern
    row: int

    @property
    def shape(self) -> str:
        """The shape, that of the whole column."""
        return self.pattern.formula.shape

    @property
    def functions(self) -> frozenset[str]:
        """The names of the functions called, in capitals."""
        return self.pattern.formula.functions

    @property
    def arguments(self) -> tuple[Area | str, ...]:
        """The arguments, in their order."""
        return tuple([a.at(self.row) if isinstance(a, Moving) else a for a in self.pattern.arguments])


class Formulas:
    """Takes formulas of one sheet apart; ``area`` resolves a name, or a sheet's title.

    A formula's text with the numbers of its row left out is looked up among those already met. Where every number
    left out is the whole row of a reference, the formula met differs in these rows only.
    """

    def __init__(self, sheet: str, area: Resolve) -> None:
        self._sheet, self._area = sheet, area
        self._known: dict[str, Area | str] = {}
        self._patterns: dict[str, Pattern | None] = {}

    def read(self, text: str, row: int) -> Formula | Moved:
        """Split the formula of a row into its shape and arguments; raise FormulaError as :func:`read` does."""
        open_text = opened(text, row)
        pattern = self._patterns.get(open_text) if open_text is not text else None
        if pattern is not None:
            return Moved(pattern, row)
        formula = read(text, self._sheet, self._area, self._known)
        if open_text not in self._patterns and open_text is not text:
            self._patterns[open_text] = pattern_of(open_text, formula, row)
        return formula


def opened(text: str, row: int) -> str:
    """Return a formula's text with the numbers of its row and the row above left open; itself where that cannot be."""
    if row < 2 or HERE in text or ABOVE in text:
        return text
    return text.replace(str(row), HERE).replace(str(row - 1), ABOVE)


def pattern_of(open_text: str, formula: Formula, row: int) -> Pattern | None:
    """Return the pattern of a formula, or None where a number left open is more, or less, than a reference's row."""
    arguments: list[Area | str | Moving] = []
    left_open = open_text.count(HERE) + open_text.count(ABOVE)
    for argument, word in zip(formula.arguments, formula.written, strict=True):
        found = None if isinstance(argument, str) else MOVING.fullmatch(opened(word, row))
        offsets = [{HERE: 0, ABOVE: -1}.get(digits) for digits in (found.groups() if found else ())]
        moves = len(offsets) - offsets.count(None)
        left_open -= moves
        if moves and isinstance(argument, Area):
            top, bottom = offsets if found and found[2] else (offsets[0], offsets[0])
            rows = [int(digits) for digits in re.findall(r"[A-Za-z]\$?([0-9]+)(?=:|$)", word)]
            if found and found[2] and rows != [argument.top, argument.bottom]:
                return None  # written from the lower corner to the upper one
            arguments.append(Moving(argument, top, bottom))
        else:
            arguments.append(argument)
    return Pattern(formula, tuple(arguments)) if left_open == 0 else None
