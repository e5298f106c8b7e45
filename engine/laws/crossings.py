"""Where functions change their sign: many brackets narrowed at once."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array

PARTS = 256


def narrowed(positive: Callable[[Array], NDArray[np.bool_]], low: Array, high: Array, rounds: int) -> Array:
    """Return the points at which ``positive`` changes within brackets, to 256^-rounds of each bracket.

    ``positive`` takes and returns arrays of shape (n,) and differs at the ends of each bracket; where it changes
    more than once in a bracket, the first change that its samples show is taken. Sampling a whole bracket costs
    hardly more than halving it, and is worth eight halvings.
    """
    share = np.linspace(0.0, 1.0, PARTS + 1)
    each = np.arange(low.size)
    for _ in range(rounds):
        points = low[:, None] + (high - low)[:, None] * share
        above = positive(points.ravel()).reshape(points.shape)
        changed = above != above[:, :1]
        changed[:, -1] = True  # also where rounding hides it
        at = changed.argmax(axis=1)
        low, high = points[each, at - 1], points[each, at]
    return 0.5 * (low + high)
