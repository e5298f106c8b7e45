"""What an evaluation is made of: a formula called with its arguments, a range filled from its cells."""

import math
from collections.abc import Hashable, Sequence
from graphlib import CycleError, TopologicalSorter
from typing import Any, NamedTuple

import numpy as np
from pycel.excelutil import EMPTY, list_like
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from workbook.book.address import Address
from workbook.witnesses.pycel.compiled import Compiled, arguments
from workbook.witnesses.pycel.shortcuts import Range

LONGEST_TEXT = 32_767  # characters that a cell can hold
LARGEST_EXACT = 2**53  # whole numbers beyond are not exact in a cell


class FormulaStep(NamedTuple):
    """One formula cell: its shape, and the numbers of the cells, ranges and texts that this is called with."""

    compiled: Compiled
    sources: Sequence[int]

    def compute(self, values: list[Any]) -> Any:
        """Return what the cell holds; raise what pycel raises, and OverflowError for what no cell can hold."""
        arguments.update(zip(self.compiled.dummies, map(values.__getitem__, self.sources), strict=True))
        return held(self.compiled.call())


class RangeStep(NamedTuple):
    """One range: the numbers of its cells, row by row."""

    sources: Sequence[int]
    width: int

    def compute(self, values: list[Any]) -> Range:
        """Return the range as pycel's functions take it."""
        cells = map(values.__getitem__, self.sources)
        return Range(zip(*[cells] * self.width, strict=True))


def held(result: Any) -> Any:
    """Return a result as a cell holds it: 0 for nothing, of an array its first element."""
    kind = type(result)
    if kind is float:
        if math.isfinite(result):
            return result
        raise OverflowError
    if kind is int:
        return result if abs(result) <= LARGEST_EXACT else float(result)
    if result is None or result == EMPTY:
        return 0
    if kind is str:
        return result if len(result) <= LONGEST_TEXT else "#VALUE!"
    if kind is bool:
        return result
    return held(result[0]) if list_like(result) else held(result.item())


class Numbering:
    """Gives numbers from 1; ``values`` holds what each begins with, and None, the empty cell of ranges, at 0."""

    def __init__(self) -> None:
        self.values: list[Any] = [None]
        self.cells: dict[int, Address] = {}
        self._columns: dict[tuple[str, int], dict[int, int]] = {}
        self._others: dict[Hashable, int] = {}

    def column(self, sheet: str, column: int) -> dict[int, int]:
        """Return the numbers of a column's cells, by row; it grows with them."""
        return self._columns.setdefault((sheet, column), {})

    def cell(self, address: Address, value: Any = None) -> int:
        """Return the number of a cell; a new one, with ``value``, for what has none."""
        number = self.column(address.sheet, address.column).setdefault(address.row, len(self.values))
        if number == len(self.values):
            self.values.append(value)
            self.cells[number] = address
        return number

    def other(self, key: Hashable, value: Any = None) -> int:
        """Return the number of a range or text; a new one, with ``value``, for what has none."""
        number = self._others.setdefault(key, len(self.values))
        if number == len(self.values):
            self.values.append(value)
        return number


def ordered(needs: dict[int, Sequence[int]]) -> tuple[list[int], dict[int, int]]:
    """Return keys so that each follows those keys that it needs; for each in a cycle, one that it needs there."""
    cyclic: dict[int, int] = {}
    try:
        order = list(TopologicalSorter(needs).static_order())
    except CycleError:
        ends = np.array([(key, need) for key, found in needs.items() for need in found])
        size = 1 + ends.max()
        parts = connected_components(coo_array((ends[:, 0] + 1, ends.T), (size, size)), connection="strong")[1]
        cyclic = dict(ends[parts[ends[:, 0]] == parts[ends[:, 1]]].tolist())
        order = list(TopologicalSorter(needs | dict.fromkeys(cyclic, ())).static_order())
    return [key for key in order if key in needs], cyclic
