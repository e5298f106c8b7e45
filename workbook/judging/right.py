"""What should stand in the cells of a matched file, by a declaration of the same layout."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.book.rows import as_rows
from workbook.entries.machine import Machine
from workbook.judging.matching import Column, Match
from workbook.templates import AnyTemplate


class Stated(NamedTuple):
    """What a declaration has in columns of cells, one after the other, and what deviations in each are measured by."""

    values: list[Any]
    peaks: list[float]


@dataclass(frozen=True)
class Variation:
    """Another machine of a book's layout: what its declaration has, in a process that knows nothing but this."""

    template: AnyTemplate
    machine: Machine
    columns: Sequence[Column]

    def __call__(self) -> Stated:
        """Declare its book, and return what that has."""
        return stated(self.template.declare(self.machine), self.columns)


def stated(book: Book, columns: Sequence[Column]) -> Stated:
    """Return what a book has in columns: the engine's values, entries, constants; and the peak of each column.

    That is the greatest size in the column, or the declared scale where that is greater.
    """
    values: list[Any] = []
    peaks = []
    for name, number, rows in columns:
        block = book.blocks[name]
        q = block.quantities[number]
        column = as_rows(q.value, block.size, q.name)
        values += column[:rows]
        peaks.append(max(greatest(column), q.floor))
    return Stated(values, peaks)


class Right:
    """What should stand in the cells of a matched file, by a declaration of the same layout.

    That is the engine's value in a formula cell, what was entered in an input, and what is declared in a constant.
    """

    def __init__(self, match: Match, declared: Book | Stated) -> None:
        self.values, self.peaks = declared if isinstance(declared, Stated) else stated(declared, match.columns)
        self._match = match

    def get(self, address: Address, default: Any = None) -> Any:
        """Return what should stand in a cell; ``default`` for one that is not declared."""
        number = self._match.numbers.get(address)
        return default if number is None else self.values[number]

    def peak(self, address: Address) -> float:
        """Return what deviations of a declared cell are measured against."""
        return self.peaks[self._match.column_of[self._match.numbers[address]]]


def greatest(values: list[Any]) -> float:
    """Return the greatest size of the finite numbers among ``values``, or 0."""
    try:
        size = max(map(abs, values), default=0.0)
    except TypeError:  # texts or empty cells among them
        size = math.inf
    if size < math.inf:
        return float(size)
    return max((abs(v) for v in values if isinstance(v, int | float) and abs(v) < math.inf), default=0.0)
