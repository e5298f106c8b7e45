"""What an evaluation is made of: a formula called with its arguments, a range filled from its cells."""

import math
from collections.abc import Hashable, Iterator, Mapping, Sequence
from typing import Any

from pycel.excelutil import EMPTY, list_like

from workbook.book.address import Address
from workbook.witnesses.pycel.compiled import Compiled, arguments

LONGEST_TEXT = 32_767  # characters that a cell can hold
LARGEST_EXACT = 2**53  # whole numbers beyond are not exact in a cell


class FormulaStep:
    """One formula cell: the numbers of the cells, ranges and texts that its shape is called with."""

    __slots__ = ("_call", "_dummies", "sources")

    def __init__(self, compiled: Compiled, sources: Sequence[int]) -> None:
        self._call, self._dummies, self.sources = compiled.call, compiled.dummies, sources

    def compute(self, values: list[Any] | dict[int, Any]) -> Any:
        """Return what the cell holds; raise what pycel raises, and OverflowError for what no cell can hold."""
        arguments.update(zip(self._dummies, map(values.__getitem__, self.sources), strict=True))
        return held(self._call())


class RangeStep:
    """One range: the numbers of its cells, row by row."""

    __slots__ = ("_width", "sources")

    def __init__(self, sources: Sequence[int], width: int) -> None:
        self.sources, self._width = sources, width

    def compute(self, values: list[Any] | dict[int, Any]) -> tuple[tuple[Any, ...], ...]:
        """Return the range as pycel's functions take it, a tuple of rows."""
        cells = map(values.__getitem__, self.sources)
        return tuple(zip(*[cells] * self._width, strict=True))


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


class _Visit:
    """A key under way: what it has still to look at, and the outermost key that it leads back to."""

    __slots__ = ("back", "key", "rest", "via")

    def __init__(self, key: int, rest: Iterator[int], depth: int) -> None:
        self.key, self.rest = key, rest
        self.back, self.via = depth + 1, key  # deeper than itself: it leads back to nothing


def ordered(needs: Mapping[int, Sequence[int]]) -> tuple[list[int], dict[int, int]]:
    """Return the keys of ``needs`` so that each follows those it needs, and the keys of cycles.

    Depth first, without recursion: a chain may be as long as a sheet. Each key of a cycle comes with the one
    that it needs in that cycle; a cycle is cut where it was noticed. Needs that are no keys are passed over.
    """
    order: list[int] = []
    cyclic: dict[int, int] = {}
    depth: dict[int, int] = {}  # of a key under way; -1 when done
    for start in needs:
        if start in depth:
            continue
        path = [_Visit(start, iter(needs[start]), 0)]
        depth[start] = 0
        while path:
            visit = path[-1]
            for need in visit.rest:
                if need not in needs:
                    continue
                there = depth.get(need)
                if there is None:
                    depth[need] = len(path)
                    path.append(_Visit(need, iter(needs[need]), len(path)))
                    break
                if 0 <= there < visit.back:
                    visit.back, visit.via = there, need
            else:
                _leave(path, depth, cyclic)
                order.append(visit.key)
    return order, cyclic


def _leave(path: list[_Visit], depth: dict[int, int], cyclic: dict[int, int]) -> None:
    visit = path.pop()
    depth[visit.key] = -1
    if visit.back <= len(path):
        cyclic[visit.key] = visit.via
    if visit.back < len(path) and visit.back < path[-1].back:
        path[-1].back, path[-1].via = visit.back, visit.key
