"""Roots found by halving, step by step, as sheets find them: what each of their steps must come to."""

from __future__ import annotations

import numpy as np

from engine.laws import Law
from engine.laws.base import Array


def velocity_halvings(law: Law, wanted: float, low: float, high: float, count: int, near: float) -> Array:
    """Return the bounds and the middle of each halving of [low, high] where v passes ``wanted``: three arrays.

    Where v rises from low to high, the root lies above a middle that is slower; where it falls, above one that is
    faster, each by more than ``near``.
    """
    rising = law.v(high) > law.v(low)
    rows = []
    for _ in range(count):
        middle = (low + high) / 2.0
        rows.append((low, high, middle))
        v = law.v(middle)
        above = v + near < wanted if rising else v - near > wanted
        low, high = (middle, high) if above else (low, middle)
    return np.array(rows).T
