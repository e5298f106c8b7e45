"""Formulas taken apart: those of a column once, for they differ in the number of their row only; and as trees."""

import re
from functools import lru_cache
from typing import Any, NamedTuple

from workbook.book.formula import Area, Formula, FormulaError, Resolve, read, words

# stand for the number of the formula's row, and of the row above; no cell's text has them
HERE, ABOVE = "\0", "\1"
_ROW = r"\$?[A-Za-z]{1,3}\$?([\0\1]|[0-9]+)"
MOVING = re.compile(rf"(?:[^\0\1]*!)?{_ROW}(?::{_ROW})?")


class Moving(NamedTuple):
    """A reference that moves with the row of its formula: how far its corners lie from that row, or None."""

    area: Area
    top: int | None
    bottom: int | None

    def at(self, row: int) -> Area:
        """Return the area that it refers to in the formula of a row."""
        area, top, bottom = self
        first = area.top if top is None else row + top
        last = first if area.single else area.bottom if bottom is None else row + bottom
        return Area(area.sheet, min(first, last), area.left, max(first, last), area.right, area.single)


class Pattern(NamedTuple):
    """A formula with its row left open; ``formula`` is where it was met first."""

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
    """Takes formulas of a sheet apart; ``area`` resolves a name, or a sheet's title.

    A formula met before differs in its rows only where every number left open is the whole row of a reference.
    """

    def __init__(self, sheet: str, area: Resolve) -> None:
        self._sheet, self._area = sheet, area
        self._known: dict[str, Area | str] = {}
        self._patterns: dict[str, Pattern | None] = {}

    def read(self, text: str, row: int) -> Formula | Moved:
        """Split the formula of a row into its shape and arguments; raise FormulaError as :func:`read` does."""
        open_text = open_row_numbers(text, row)
        pattern = self._patterns.get(open_text) if open_text is not text else None
        if pattern is not None:
            return Moved(pattern, row)
        formula = read(text, self._sheet, self._area, self._known)
        if open_text not in self._patterns and open_text is not text:
            self._patterns[open_text] = pattern_of(open_text, formula, row)
        return formula


def open_row_numbers(text: str, row: int) -> str:
    """Return a formula's text with the numbers of its row and the row above left open; itself where that cannot be."""
    if row < 2 or HERE in text or ABOVE in text:
        return text
    return text.replace(str(row), HERE).replace(str(row - 1), ABOVE)


def pattern_of(open_text: str, formula: Formula, row: int) -> Pattern | None:
    """Return the pattern of a formula, or None where a number left open is more, or less, than a reference's row."""
    arguments: list[Area | str | Moving] = []
    left_open = open_text.count(HERE) + open_text.count(ABOVE)
    for argument, word in zip(formula.arguments, formula.written, strict=True):
        match = None if isinstance(argument, str) else MOVING.fullmatch(open_row_numbers(word, row))
        offsets = [{HERE: 0, ABOVE: -1}.get(digits) for digits in (match.groups() if match else ())]
        moves = len(offsets) - offsets.count(None)
        left_open -= moves
        if moves and isinstance(argument, Area):
            top, bottom = offsets if match and match[2] else (offsets[0], offsets[0])
            rows = [int(digits) for digits in re.findall(r"[A-Za-z]\$?([0-9]+)(?=:|$)", word)]
            if match and match[2] and rows != [argument.top, argument.bottom]:
                return None  # written from the lower corner to the upper
            arguments.append(Moving(argument, top, bottom))
        else:
            arguments.append(argument)
    return Pattern(formula, tuple(arguments)) if left_open == 0 else None


LEVELS = (("=", "<>", "<", ">", "<=", ">="), ("&",), ("+", "-"), ("*", "/"), ("^",))
"""operations of two sides, those that bind least first"""


class Node(NamedTuple):
    """An operation (of one part: a sign), a call, a number, an argument, constants, or a name or error; its parts."""

    kind: str
    value: Any = None
    parts: "tuple[Node, ...]" = ()


@lru_cache(maxsize=20_000)
def tree(shape: str) -> Node:
    """Return the tree of a shape such as ``=A1*SUM(A2:B2)``; raise FormulaError where it is no formula."""
    reader = Reader([*words(shape[1:])])
    node = reader.level(0)
    if reader.left:
        raise FormulaError("#NAME?", f"{reader.left[0][1]!r} is not expected")
    return node


class Reader:
    """Takes words from the front of a formula."""

    def __init__(self, formula: list[tuple[str, str]]) -> None:
        self.left = formula

    def next(self) -> tuple[str, str]:
        """Take the next word; raise FormulaError at the end."""
        if not self.left:
            raise FormulaError("#NAME?", "the formula ends early")
        return self.left.pop(0)

    def sees(self, *signs: str) -> bool:
        """Whether any of these signs comes next."""
        return bool(self.left) and self.left[0][0] == "sign" and self.left[0][1] in signs

    def level(self, depth: int) -> Node:
        """Return the operation whose signs bind at least as strongly as those of ``LEVELS[depth]``."""
        if depth == len(LEVELS):
            return self.single()
        node = self.level(depth + 1)
        while self.sees(*LEVELS[depth]):
            node = Node("operation", self.next()[1], (node, self.level(depth + 1)))
        return node

    def single(self) -> Node:
        """Return a number, argument, call or bracket, with the signs before and behind it."""
        kind, word = self.next()
        if kind == "sign" and word in "+-":
            return Node("operation", word, (self.single(),))
        if kind == "function":
            node = Node("call", word[:-1].upper().removeprefix("_XLFN."), self.arguments())
        elif word == "(":
            node = self.level(0)
            self.next()
        elif word == "{":
            while self.next()[1] != "}":
                pass
            node = Node("constants")
        elif kind == "number":
            node = Node("number", float(word))
        elif kind == "reference":
            node = Node("argument", int(word.split(":")[0][1:]) - 1)
        elif kind in ("name", "error"):
            node = Node("other", word)
        else:
            raise FormulaError("#NAME?", f"{word!r} is not expected")
        while self.sees("%"):
            node = Node("operation", self.next()[1], (node,))
        return node

    def arguments(self) -> tuple[Node, ...]:
        """Return the arguments of a call, whose bracket is open; nothing between commas is an empty argument."""
        arguments: list[Node] = []
        while not self.sees(")"):
            arguments.append(Node("other") if self.sees(",") else self.level(0))
            if not self.sees(")"):
                self.next()
        self.next()
        return tuple(arguments)
