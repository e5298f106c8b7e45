"""Ranges of numbers as NumPy has them, between an operator of a formula and the next one.

A range is a tuple of rows to pycel, and each operator makes another one of it, element by element. Here it stays an
array from its first operator until a function wants it that knows none. What is not all numbers, or would not give what
pycel gives of each element, is left to the way by elements.
"""

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from workbook.witnesses.pycel.limits import NEAR, NUMBERS

COMPARED = {"Lt": np.less, "LtE": np.less_equal, "Gt": np.greater, "GtE": np.greater_equal, "Eq": np.equal,
            "NotEq": np.not_equal}  # fmt: skip
SUMS = {"Add": np.add, "Sub": np.subtract, "Mult": np.multiply}
POWERS = frozenset((2, 3, 4))
MOST_KEPT = 2_000_000  # cells
SMALLEST = 4  # cells of a range for which an array is worth its making


class Array:
    """A range of numbers, or of truth values."""

    __slots__ = ("cells",)

    def __init__(self, cells: NDArray[Any]) -> None:
        self.cells = cells

    def rows(self) -> tuple[tuple[Any, ...], ...]:
        """Return the range as pycel's functions take it."""
        return tuple(map(tuple, self.cells.tolist()))

    def item(self) -> Any:
        """Return its first element: what a cell holds of a range."""
        return self.cells.flat[0].item()


def plain(value: Any) -> Any:
    """Return a value as pycel's functions take it."""
    return value.rows() if type(value) is Array else value


def plainly(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that knows no arrays as one that may be given them."""

    def call(*arguments: Any) -> Any:
        return function(*map(plain, arguments)) if Array in map(type, arguments) else function(*arguments)

    return call


class Known:
    """What was made of ranges in one evaluation: a formula writes the same term many times, and so do its neighbours.

    Each range is kept with what it was made, so that its identity stays its own.
    """

    arrays: ClassVar[dict[int, tuple[Any, NDArray[Any] | None]]] = {}
    results: ClassVar[dict[tuple[Any, ...], tuple[Any, Any, Array | None]]] = {}
    cells: ClassVar[int] = 0

    @classmethod
    def forget(cls) -> None:
        """Begin another evaluation."""
        cls.arrays.clear()
        cls.results.clear()
        cls.cells = 0

    @classmethod
    def keep(cls, cells: int) -> None:
        """Make room for so many cells more."""
        if cls.cells > MOST_KEPT:
            cls.forget()
        cls.cells += cells + 8  # an entry takes some room itself


def array_of(value: Any) -> NDArray[Any] | None:
    """Return a range as an array; None where it does not hold numbers alone."""
    if type(value) is Array:
        return value.cells
    known = Known.arrays.get(id(value))
    if known is None:
        Known.keep(len(value) * len(value[0]))
        known = Known.arrays[id(value)] = value, _made(value)
    return known[1]


def _made(rows: tuple[tuple[Any, ...], ...]) -> NDArray[Any] | None:
    if len(rows) * len(rows[0]) < SMALLEST or not all(NUMBERS.issuperset(map(type, row)) for row in rows):
        return None
    try:
        return np.array(rows, dtype=float)
    except OverflowError:
        return None


def operated(left: Any, operator: str, right: Any) -> Array | None:
    """Return what an operator makes of ranges of one size, or of a range and a number; None where that is not plain."""
    kind, other = type(left), type(right)
    one, two = kind in NUMBERS, other in NUMBERS
    key = one, left if one else id(left), operator, two, right if two else id(right)
    known = Known.results.get(key)
    if known is None:
        a, b = left if one else array_of(left), right if two else array_of(right)
        made = None
        if a is not None and b is not None and (one or two or a.shape == b.shape):
            made = _result(a, operator, b)
            Known.keep(0 if made is None else made.size)
        known = Known.results[key] = left, right, None if made is None else Array(made)
    return known[2]


def _result(a: Any, operator: str, b: Any) -> NDArray[Any] | None:
    truths = bool in (getattr(a, "dtype", None), getattr(b, "dtype", None))
    made: NDArray[Any] | None = None
    if operator in SUMS:
        if truths:
            a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
        made = SUMS[operator](a, b)
    elif truths:
        return None
    elif operator in COMPARED:
        apart = np.abs(a - b)
        doubtful = (apart > 0) & (apart <= 2.0 * NEAR * np.abs(b))  # the same to 15 digits, perhaps
        return None if doubtful.any() else COMPARED[operator](a, b)
    elif operator == "Div" and np.all(b):
        made = a / b
    elif operator == "Pow" and ((type(b) in NUMBERS and b in POWERS) or (type(a) in NUMBERS and a > 0)):
        made = a**b
    return made if made is not None and np.isfinite(made).all() else None


def applied(function: Callable[[NDArray[Any]], NDArray[Any]], value: Array) -> Array | None:
    """Return a function of each element; None where one has no value."""
    made = function(value.cells) if value.cells.dtype != bool else None
    return Array(made) if made is not None and np.isfinite(made).all() else None
