"""Values against values: what a witness computes against what the engine says."""

import math
from typing import Any

from workbook.book.sentence import Sentence

TOLERANCE = 1e-9  # relative to the greatest value of the cell's column


def difference(computed: Any, expected: Any, peak: float) -> float:
    """Return the deviation relative to ``peak``: 0 for equal texts, or sentences but for rounding; else infinite."""
    if isinstance(expected, Sentence):
        return 0.0 if expected.says(computed) else math.inf
    if not (is_number(computed) and is_number(expected)):
        return 0.0 if type(computed) is type(expected) and computed == expected else math.inf
    gap = abs(computed - expected)
    return gap / peak if peak else (0.0 if gap == 0 else math.inf)


def is_number(value: Any) -> bool:
    """Whether a value is a number; TRUE and an empty cell are none."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def is_error(value: Any) -> bool:
    """Whether a value is one of a spreadsheet's errors."""
    return isinstance(value, str) and value.startswith("#")
