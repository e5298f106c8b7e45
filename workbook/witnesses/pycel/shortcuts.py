"""Shortcuts past pycel's checks for plain numbers, and arrays for ranges of numbers; pycel computes all else."""

import functools
import math
from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from itertools import repeat
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pycel.lib import lookup

from workbook.witnesses.pycel.limits import NEAR, NUMBERS, OPERATORS, build_operators, count_searches, cross, raised

Function = Callable[..., Any]
COMPARED = {"Lt": np.less, "LtE": np.less_equal, "Gt": np.greater, "GtE": np.greater_equal, "Eq": np.equal,
            "NotEq": np.not_equal}  # fmt: skip
SUMS = {"Add": np.add, "Sub": np.subtract, "Mult": np.multiply}
SIMPLE = {name: OPERATORS[name] for name in (*SUMS, *COMPARED)}
POWERS = frozenset((2, 3, 4))


class Range(tuple[tuple[Any, ...], ...]):
    """A range of cells as pycel's functions take it, a tuple of rows; as an array where it holds numbers alone."""

    @functools.cached_property
    def cells(self) -> NDArray[Any] | None:
        """The numbers, as an array once for all formulas that read the range."""
        if not all(NUMBERS.issuperset(map(type, row)) for row in self):
            return None
        try:
            return np.array(self, dtype=float)
        except OverflowError:
            return None

    @functools.cached_property
    def numbers(self) -> list[float]:
        """The numbers, row by row; none of a range that holds something else."""
        return [] if self.cells is None else self.cells.ravel().tolist()

    @functools.cached_property
    def sorted(self) -> list[float]:
        """The numbers from the smallest on, sorted once for all formulas that ask for any of them."""
        return sorted(self.numbers)


class Array:
    """The result of an operator on ranges: numbers, or truth values."""

    __slots__ = ("cells",)

    def __init__(self, cells: NDArray[Any]) -> None:
        self.cells = cells

    def item(self) -> Any:
        """Return its first element: what a cell holds of a range."""
        return self.cells.flat[0].item()


RANGES = frozenset((tuple, Range, Array))


def plain(value: Any) -> Any:
    """Return a value as pycel's functions take it."""
    return tuple(map(tuple, value.cells.tolist())) if type(value) is Array else value


def array_of(value: Any) -> NDArray[Any] | None:
    """Return a range as an array; None where it does not hold numbers alone."""
    cells: NDArray[Any] | None = (Range(value) if type(value) is tuple else value).cells
    return cells


CHECKED = build_operators(lambda is_exception, message: None)


def operate(left: Any, operator: str, right: Any) -> Any:
    """Return the result of an operator, as pycel's code calls it."""
    kind, other = type(left), type(right)
    if kind in NUMBERS and other in NUMBERS:
        if operator in SIMPLE:
            return SIMPLE[operator](left, right)
        if operator == "Div" and right:
            return left / right
        if operator == "Pow" and right > 0 and (left >= 0 or type(right) is int):
            return raised(left, right)
    elif kind in RANGES or other in RANGES:
        return operate_on_ranges(left, operator, right)
    return CHECKED(left, operator, right)


def operate_on_ranges(left: Any, operator: str, right: Any) -> Any:
    """Return the result of an operator on ranges, or a range and a number."""
    first, second = number_or_array(left), number_or_array(right)
    cells = None if first is None or second is None else array_operation(first, operator, second)
    if cells is not None:
        return Array(cells)
    left, right = plain(left), plain(right)
    if are_alike(left, right):
        rows = zip(*(x if isinstance(x, tuple) else repeat(repeat(x)) for x in (left, right)), strict=False)
        return tuple(tuple(map(operate, row, repeat(operator), other)) for row, other in rows)
    cross(left, right)
    return CHECKED(left, operator, right)


def number_or_array(value: Any) -> Any:
    """Return a number as it is, a range of numbers as an array; None for all else."""
    kind = type(value)
    return value if kind in NUMBERS else array_of(value) if kind in RANGES else None


def are_alike(left: Any, right: Any) -> bool:
    """Return whether both are ranges of the same size, or a range and a number."""
    ranges = [x for x in (left, right) if isinstance(x, tuple)]
    sizes = {(len(x), len(x[0])) for x in ranges}
    return len(sizes) == 1 and all(isinstance(x, tuple) or type(x) in NUMBERS for x in (left, right))


def array_operation(a: Any, operator: str, b: Any) -> NDArray[Any] | None:
    """Return the result of an operator on arrays of equal size, or array and number; None where it is not plain."""
    kinds = [array.dtype for array in (a, b) if isinstance(array, np.ndarray)]
    if len(kinds) == 2 and a.shape != b.shape:
        return None
    if operator in SUMS:
        return if_finite(SUMS[operator](a, b, dtype=float))
    if bool in kinds:
        return None
    if operator in COMPARED:
        apart = np.abs(a - b)
        doubtful = (apart > 0) & (apart <= 2.0 * NEAR * np.abs(b))  # the same to 15 digits, perhaps
        return None if doubtful.any() else COMPARED[operator](a, b)
    if operator == "Div" and np.all(b):
        return if_finite(a / b)
    return if_finite(a**b) if operator == "Pow" and has_plain_powers(a, b) else None


def has_plain_powers(a: Any, b: Any) -> bool:
    """Whether a power is that of a cell, in an array's exact digits: small and whole, or of a positive number."""
    return (type(b) in NUMBERS and b in POWERS) or (type(a) in NUMBERS and a > 0)


def if_finite(cells: NDArray[Any]) -> NDArray[Any] | None:
    """Return an array whose numbers are all finite; None for any other."""
    return cells if np.isfinite(cells).all() else None


def index(array: Any, row: Any, column: Any = None) -> Any:
    """Return INDEX of ranges and whole numbers, fastest for a row of a column."""
    if type(row) is float and row.is_integer():
        row = int(row)
    if isinstance(array, tuple) and type(row) is int:
        if column is None and 0 < row <= len(array) and len(array[0]) == 1:
            return array[row - 1][0]
        if column == 0 and 0 < row <= len(array) > 1 < len(array[0]):
            return (array[row - 1],)
        if column is None or type(column) is int:
            return lookup.index(array, row, column)
    return None


def match(wanted: Any, array: Any, kind: Any = 1) -> int | None:
    """Return MATCH of a number among those of a row or column from the smallest on, sought by halves as pycel does."""
    if type(array) is Range and type(wanted) in NUMBERS and type(kind) is int and kind == 1:
        return bisect_right(array.numbers, wanted) or None if 1 in (len(array), len(array[0])) else None
    return None


def small(array: Any, place: Any) -> float | None:
    """Return SMALL of a range of numbers, a whole one without decimals as pycel has it."""
    if type(array) is Range and type(place) in NUMBERS and 1 <= place <= len(array.sorted):
        value = array.sorted[math.ceil(place) - 1]
        return int(value) if value.is_integer() else value
    return None


def of_number(body: Callable[[float], float], over: Callable[[Any], Any], *arguments: Any) -> Any:
    """Return a function of a number in its domain, or of an array of these."""
    value: Any = arguments[0] if len(arguments) == 1 else None
    if type(value) in NUMBERS:
        with suppress(ValueError, OverflowError):
            return body(value)
    elif type(value) is Array and value.cells.dtype != bool:
        cells = over(value.cells)
        return Array(cells) if np.isfinite(cells).all() else None
    return None


def of_numbers(body: Callable[[Sequence[float]], float], *arguments: Any) -> Any:
    """Return a function of any numbers, and of a range that holds nothing else."""
    one_range = len(arguments) == 1 and type(arguments[0]) in RANGES
    rows: Iterable[Any] = plain(arguments[0]) if one_range else (arguments,)
    values = [value for row in rows for value in row]
    return body(values) if values and NUMBERS.issuperset(map(type, values)) else None


def product_sum(*arrays: Any) -> Any:
    """Return SUMPRODUCT of ranges of numbers of the same size."""
    if arrays and RANGES.issuperset(map(type, arrays)):
        operands: list[Any] = list(map(array_of, arrays))
        numbers = all(cells is not None and cells.dtype != bool for cells in operands)
        if numbers and len({cells.shape for cells in operands}) == 1:
            return functools.reduce(np.multiply, operands).sum().item()
    return None


def chosen(function: Function, test: Any, true_value: Callable[[], Any], false_value: Callable[[], Any]) -> Any:
    """Return IF, of which only the value that counts is worked out, where the test is plain."""
    if type(test) is bool:
        return true_value() if test else false_value()
    return function(test, true_value(), false_value())


ELEMENTARY = ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "sqrt", "log10", "degrees", "radians")
SHORTCUTS: dict[str, Function] = {
    **{name: functools.partial(of_number, getattr(math, name), getattr(np, name)) for name in ELEMENTARY},
    "ln": functools.partial(of_number, math.log, np.log), "abs_": functools.partial(of_number, abs, np.abs),
    **{f"{body.__name__}_": functools.partial(of_numbers, body) for body in (min, max, sum)},
    "sumproduct": product_sum, "index": index, "match": match, "small": small,
}  # fmt: skip
"""shortcuts of pycel's functions, by their names there; each returns None for arguments that it does not take"""
COUNTED: dict[str, Function] = {"if_": cross}
COUNTED |= dict.fromkeys(("match", "vlookup", "hlookup", "lookup"), count_searches)
"""functions that count the cells which pycel's functions will pass through"""


def with_shortcut(name: str, function: Function) -> Function:
    """Return a function of pycel as formulas call it: with its shortcut, if any, counted, and for arrays."""
    way, count = SHORTCUTS.get(name), COUNTED.get(name)

    def call(*arguments: Any) -> Any:
        value = way(*arguments) if way is not None else None
        if value is not None:
            return value
        if Array in map(type, arguments):
            arguments = tuple(map(plain, arguments))
        if count is not None:
            count(*arguments)
        return function(*arguments)

    return call
