"""Columns of tables: a value for each row; polynomials of coefficients side by side, and nine points that integrate."""

from collections.abc import Iterable
from itertools import repeat
from math import perm
from typing import Any


def filled(values: Any, rows: int, spare: Any = 0.0) -> list[Any]:
    """Return values as a column of a table, ``spare`` in the rows below them."""
    entries = values.tolist() if hasattr(values, "tolist") else list(values)
    return [*entries, *repeat(spare, rows - len(entries))]


def spread(values: Iterable[Any], places: Iterable[int], rows: int, spare: Any = 0.0) -> list[Any]:
    """Return values in their rows of a table, counted from 0, ``spare`` in the others."""
    cells_below = filled([], rows, spare)
    for place, value in zip(places, values, strict=True):
        cells_below[place] = value
    return cells_below


def as_rows(value: Any, size: int, where: str) -> list[Any]:
    """Return a value for each row, in Python's own types: a sequence as it is, a single value repeated."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, str) or not hasattr(value, "__len__"):
        return filled([], size, value)
    if len(value) != size:
        raise ValueError(f"{where}: {len(value)} values for {size} rows")
    return list(value)


def is_number(value: Any) -> bool:
    """Whether a value is a number; TRUE and an empty cell are none."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def total(column: str) -> str:
    """Return the formula of a column's sum; SUM misses a cell where LibreOffice 7.4 works out columns in threads."""
    return f"SUMPRODUCT([{column}])"


LEAST = 1e-30
NOT_ZERO = "+tiny"
"""added to the base of a power, with the value :data:`LEAST`: Excel has no 0^0, and no other figure changes"""
SHARES = (0.0, 0.0501210022942699, 0.161406860244631, 0.318441268086911, 0.5,
          0.681558731913089, 0.838593139755369, 0.94987899770573, 1.0)  # fmt: skip
WEIGHTS = (0.0138888888888889, 0.0827476807804028, 0.137269356250081, 0.173214255486523, 0.185759637188209,
           0.173214255486523, 0.137269356250081, 0.0827476807804028, 0.0138888888888889)  # fmt: skip
"""where nine points lie in an interval, and what they count in a mean. Source: Abramowitz and Stegun, 25.4.32"""


def polynomial(coefficients: str, x: str, count: int, order: int = 0) -> str:
    """Return the formula, without =, of a polynomial's derivative; of ``count`` coefficients those from x^order on."""
    powers = constants(range(count - order))
    factors = f"{constants(perm(k, order) for k in range(order, count))}," if order else ""
    return f"SUMPRODUCT({coefficients},{factors}{x}^{powers})"


def constants(numbers: Iterable[int]) -> str:
    """Return whole numbers as a row of constants in a formula."""
    return f"{{{','.join(map(str, numbers))}}}"
