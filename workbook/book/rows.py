"""Columns of tables that have more rows than values."""

from __future__ import annotations

from itertools import repeat
from typing import Any


def filled(values: Any, rows: int, spare: Any = 0.0) -> list[Any]:
    """Return values as a column of a table, ``spare`` in the rows below them."""
    found = values.tolist() if hasattr(values, "tolist") else values
    return [*found, *repeat(spare, rows - len(found))]
