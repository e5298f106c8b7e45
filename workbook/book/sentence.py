"""What a failing check says: where, and by how much; its figures are rounded for people."""

from __future__ import annotations

import re
from typing import Any

DIGITS = 9
"""decimals that are shown of an entry, at most"""
LARGEST = 1e9
"""of the entries that are shown"""
BEYOND = "beyond 1E9"
_FIGURE = re.compile(r"-?[0-9]+(?:[.,][0-9]+)?(?:[eE][+-]?[0-9]+)?")
_ROUNDED = 1.1e-3
"""figures may be rounded to three decimals, each program in its way"""


class Sentence(str):
    """A text with rounded figures, as cells put it together: programs write these with a point or with a comma."""

    __slots__ = ()

    def says(self, other: Any) -> bool:
        """Whether another text has the same words, and its figures are the same but for their last digit."""
        if not isinstance(other, str) or _FIGURE.split(self) != _FIGURE.split(other):
            return False
        pairs = zip(_FIGURE.findall(self), _FIGURE.findall(other), strict=True)
        return all(near(number(one), number(two)) for one, two in pairs)


def number(text: str) -> float:
    """Return the number that a figure shows."""
    return float(text.replace(",", "."))


def near(one: float, other: float) -> bool:
    """Whether two figures differ by no more than their rounding."""
    return abs(one - other) <= _ROUNDED + 1e-9 * abs(one)


def figure(value: float) -> str:
    """Return a number as sentences show it."""
    return f"{round(value, DIGITS) + 0.0:.15g}" if abs(value) < LARGEST else BEYOND


def figure_of(cell: str) -> str:
    """Return the formula that shows what is entered in a cell."""
    small = f"ROUND(MIN(MAX({cell},-{LARGEST:.0f}),{LARGEST:.0f}),{DIGITS})"  # pycel rounds before it asks
    number = f'IF(ABS({cell})<{LARGEST:.0f},{small}&"",{quoted(BEYOND)})'
    return f'IF(ISNUMBER({cell}),{number},"empty")'


def quoted(text: str) -> str:
    """Return a text as formulas write it."""
    return '"' + text.replace('"', '""') + '"'
