"""The graph of cells, by number, and the changes of a cell by which it shows what alters with it."""

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.book.rows import is_number
from workbook.witnesses.pycel.compiled import depth_first


def raised_a_little(value: Any, place: int) -> Any:
    """Return another value near a number, of each cell of a range by another share; another text of a text."""
    return value * (1.01 + 1e-4 * place) + 1e-3 if is_number(value) else f"{value}?"


def other_value(value: Any, place: int) -> Any:
    """Return a number of the other sign; 1 for a text or nothing."""
    return -value - 1.0 - 1e-4 * place if is_number(value) else 1.0


CHANGES: tuple[Callable[[Any, int], Any], ...] = (raised_a_little, other_value)


class Graph(NamedTuple):
    """The numbers that cells and ranges read, each by its own; ``cells`` have the addresses of those that are cells."""

    reads: Mapping[int, Sequence[int]]
    cells: Mapping[int, Address]
    ranges: Collection[int]

    def order(self) -> list[int]:
        """Return the numbers of formula cells and ranges, each after those that it reads."""
        return depth_first(self.reads)[0]

    def reached(self, start: Collection[Address]) -> set[Address]:
        """Return the cells ``start``, and those that depend on any of them."""
        begun = {number for number, cell in self.cells.items() if cell in start} if start else set()
        for number in self.order() if begun else ():
            if number not in begun and not begun.isdisjoint(self.reads[number]):
                begun.add(number)
        return {self.cells[number] for number in begun if number in self.cells}

    def sources(self, number: int) -> list[int]:
        """Return the cells that a formula cell reads, those of ranges with them."""
        parts = (self.reads[source] if source in self.ranges else [source] for source in self.reads[number])
        return [cell for part in parts for cell in part]
