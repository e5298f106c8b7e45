"""Roots found by halving, step by step, as sheets find them: what each of their steps must come to."""

from __future__ import annotations

import numpy as np

from engine.laws import Law
from engine.laws.base import Array


def middles(width: Array, root: Array, count: int) -> Array:
    """Return, a row for each of ``count`` halvings of [0, width], the middle of the part that the root is in.

    The k-th halving has 2^(k−1) parts: (⌊2^(k−1) root/width⌋ + 1/2) width/2^(k−1). Of no width, the middle is 0.
    So the steps follow from a root that is known from elsewhere.
    """
    parts = 2.0 ** np.arange(count, dtype=np.float64)[:, None]
    share = np.divide(root, width, out=np.zeros_like(root), where=width > 0.0)
    found: Array = width * (np.clip(np.floor(share * parts), 0.0, parts - 1.0) + 0.5) / parts
    return found


def newton_step(t: Array, s: Array, v: Array, wanted: Array, width: Array, slow: float) -> Array:
    """Return t − (s − wanted)/v within [0, width]: Newton's step from t, where the law is at s and faster than slow.

    Where it is not, t stays. All in units of the law, s and v at t.
    """
    step = np.divide(s - wanted, v, out=np.zeros_like(t), where=v > slow)
    return np.clip(t - step, 0.0, width)


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
