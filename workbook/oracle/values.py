"""Values of cells compared: numbers to a deviation, texts and truth values as they are."""

import math
from typing import Any

import numpy as np

ROUNDING, SMALLEST = 1e-9, 1e-12
"""of two values that are the same: a relative and an absolute deviation"""


def close(found: Any, expected: Any, allowed: float) -> bool:
    """Whether a value deviates from the expected one by no more than is allowed; a text must be the same."""
    if is_number(found) and is_number(expected):
        return math.isfinite(found) and abs(found - expected) <= allowed + SMALLEST
    return type(found) is type(expected) and bool(found == expected)


def same(found: Any, expected: Any) -> bool:
    """Whether two values are the same but for rounding."""
    return close(found, expected, ROUNDING * size(expected))


def size(value: Any) -> float:
    """Return the magnitude of a number, else 0."""
    return abs(float(value)) if is_number(value) else 0.0


def is_number(value: Any) -> bool:
    """Whether a value is a number, and not a truth value."""
    return isinstance(value, int | float | np.number) and not isinstance(value, bool)
