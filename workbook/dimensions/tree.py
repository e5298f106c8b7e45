"""A formula as a tree of operations, read once for all formulas of the same shape."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.book.columns import Moved
from workbook.book.formula import Area, Formula, FormulaError
from workbook.dimensions.rules import FREE, UNKNOWN, Reading, Term
from workbook.dimensions.units import Dimension, dimension_of, is_either, written
from workbook.reading.contents import Contents
from workbook.witnesses.spread import words

LEVELS = (("=", "<>", "<", ">", "<=", ">="), ("&",), ("+", "-"), ("*", "/"), ("^",))
"""operations of two sides, those that bind least first"""


class Node(NamedTuple):
    """An operation, a call, a number, an argument of the formula, or a text or error; and what it is made of."""

    kind: str
    value: Any = None
    parts: tuple[Node, ...] = ()


@lru_cache(maxsize=20_000)
def tree(shape: str) -> Node:
    """Return the tree of a shape such as ``=A1*SUM(A2:B2)``; raise FormulaError where it is no formula."""
    reader = Reader(list(words(shape[1:])))
    node = reader.level(0)
    if reader.left:
        raise FormulaError("#NAME?", f"{reader.left[0][1]!r} is not expected")
    return node


class Reader:
    """Takes words from the front of a formula."""

    def __init__(self, found: list[tuple[str, str]]) -> None:
        self.left = joined(found)

    def next(self) -> tuple[str, str]:
        """Take the next word; raise FormulaError at the end."""
        if not self.left:
            raise FormulaError("#NAME?", "the formula ends early")
        return self.left.pop(0)

    def sees(self, *signs: str) -> bool:
        """Whether one of these signs comes next."""
        return bool(self.left) and self.left[0][0] == "sign" and self.left[0][1] in signs

    def level(self, depth: int) -> Node:
        """Return what binds at least so much."""
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
            return Node("operation", "±", (self.single(),))
        if kind == "function":
            node = Node("call", word[:-1].upper().removeprefix("_XLFN."), self.arguments())
        elif word == "(":
            node = self.level(0)
            self.next()
        elif kind == "number":
            node = Node("number", float(word))
        elif kind == "reference":
            node = Node("argument", int(word.split(":")[0][1:]) - 1)
        elif kind in ("name", "error"):
            node = Node("other", word)
        else:
            raise FormulaError("#NAME?", f"{word!r} is not expected")
        while self.sees("%"):
            self.next()
        return node

    def arguments(self) -> tuple[Node, ...]:
        """Return the arguments of a call, whose bracket is open; nothing between commas is an empty one."""
        found: list[Node] = []
        while not self.sees(")"):
            found.append(Node("other") if self.sees(",") else self.level(0))
            if not self.sees(")"):
                self.next()
        self.next()
        return tuple(found)


def joined(found: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return the words with comparisons of two signs as one."""
    made: list[tuple[str, str]] = []
    for kind, word in found:
        if made and made[-1][0] == kind == "sign" and made[-1][1] + word in LEVELS[0]:
            made[-1] = ("sign", made[-1][1] + word)
        else:
            made.append((kind, word))
    return made


@dataclass
class Dimensions:
    """What came of it: what cannot be, in words, by cell; and how many formula cells have a known dimension."""

    wrong: dict[Address, str] = field(default_factory=dict)
    formulas: int = 0
    known: int = 0


def dimensions(contents: Contents, order: Iterable[Address], units: Mapping[Address, str]) -> Dimensions:
    """Run ``units`` through formulas, each behind those that it needs; a cell with a unit has its dimension."""
    return Walk(contents, units).walk(order)


class Walk:
    """The terms of cells met so far."""

    def __init__(self, contents: Contents, units: Mapping[Address, str]) -> None:
        self.contents, self.units = contents, units
        self.terms: dict[Address, Term] = {}
        self.areas: dict[Area, Term] = {}
        for cell, unit in units.items():
            found = dimension_of(unit)
            if is_either(unit):
                self.terms[cell] = UNKNOWN
            elif found is not None and not isinstance(contents.constants.get(cell), str):
                self.terms[cell] = Term(found)

    def walk(self, order: Iterable[Address]) -> Dimensions:
        """Return what came of all formulas."""
        found = Dimensions()
        for cell in order:
            made, wrong = self.formula(self.contents.formulas[cell])
            label = self.terms.setdefault(cell, made).dimension
            if label is not None and made.dimension is not None and made.dimension != label:
                wrong.append(f"{written(made.dimension)} where the unit says {written(label)}")
            if wrong and not is_either(self.units.get(cell, "")):
                found.wrong[cell] = "; ".join(dict.fromkeys(wrong))
            found.formulas += 1
            found.known += made.dimension is not None or made.free
        return found

    def formula(self, formula: Formula | Moved) -> tuple[Term, list[str]]:
        """Return the term that a formula gives, and what in it cannot be."""
        reading = Reading([self.argument(one) for one in formula.arguments])
        try:
            return reading.of(tree(formula.shape)), reading.wrong
        except (FormulaError, RecursionError):
            return UNKNOWN, []

    def argument(self, one: Area | str) -> Term:
        """Return the term of a text, a cell or a range."""
        if isinstance(one, str):
            return FREE
        if one.size == 1:
            return self.cell(one.first)
        if one not in self.areas:
            self.areas[one] = self.range(one)
        return self.areas[one]

    def range(self, one: Area) -> Term:
        """Return the term of a range: unknown where that of one of its cells is."""
        found: dict[Dimension, None] = {}
        for cell in one.cells():
            term = self.cell(cell)
            if term.dimension is None and not term.free:
                return UNKNOWN
            if term.dimension is not None:
                found[term.dimension] = None
        return Term(next(iter(found))) if len(found) == 1 else Term(several=tuple(found)) if found else FREE

    def cell(self, cell: Address) -> Term:
        """Return the term of a cell; texts and empty cells go with any."""
        if cell in self.terms:
            return self.terms[cell]
        held = self.contents.constants.get(cell)
        return FREE if cell not in self.contents.formulas and (held is None or isinstance(held, str)) else UNKNOWN
