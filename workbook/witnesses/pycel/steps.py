"""What an evaluation is made of: a formula called with its arguments, a range filled from its cells."""

import math
from collections.abc import Iterable, Sequence
from typing import Any

from pycel.excelutil import EMPTY, list_like

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
        return rows_of(map(values.__getitem__, self.sources), self._width)


def rows_of(values: Iterable[Any], width: int) -> tuple[tuple[Any, ...], ...]:
    """Return values as rows of ``width``."""
    cells = iter(values)
    return tuple(zip(*[cells] * width, strict=True))


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
