"""Columns of tables: a value for each row."""

from collections.abc import Iterable
from itertools import repeat
from typing import Any


def filled(values: Any, rows: int, spare: Any = 0.0) -> list[Any]:
    """Return values as a column of a table, ``spare`` in the rows below them."""
    found = values.tolist() if hasattr(values, "tolist") else list(values)
    return [*found, *repeat(spare, rows - len(found))]


def spread(values: Iterable[Any], places: Iterable[int], rows: int, spare: Any = 0.0) -> list[Any]:
    """Return values in their rows of a table, counted from 0, ``spare`` in the others."""
    found = filled([], rows, spare)
    for place, value in zip(places, values, strict=True):
        found[place] = value
    return found


def as_rows(value: Any, size: int, where: str) -> list[Any]:
    """Return one value for each row, in Python's own types: a sequence as it is, a single value repeated."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, str) or not hasattr(value, "__len__"):
        return filled([], size, value)
    if len(value) != size:
        raise ValueError(f"{where}: {len(value)} values for {size} rows")
    return list(value)


def total(column: str) -> str:
    """Return the formula of a column's sum.

    SUMPRODUCT, not SUM: in a book without saved values, which another program has written, LibreOffice 7.4 works out
    columns in threads, and SUM misses the first cell of one that is begun for it.
    """
    return f"SUMPRODUCT([{column}])"
