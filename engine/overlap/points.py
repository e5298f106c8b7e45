"""The share of time at which a law has reached a height, by points of the law: what a table in a workbook gives.

The exact one is :func:`engine.laws.inverse.inverse`; this is within :data:`HEIGHT` of it in height.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.motion.pieces import law_pieces

INTERVALS = 96  # between points, at most
HEIGHT = 1e-6  # of the rise: how near to a height the law is at the time found
REST = 1e-5  # a velocity below this, in units of the mean velocity, is too slow for a correction


class Points(NamedTuple):
    """Points of a law: arrays of the length INTERVALS + 1; spare ones are its end."""

    n: int  # intervals on each piece
    piece: Array  # number of the piece, from 1
    share: Array  # of the piece's duration
    xi: Array
    s: Array
    v: Array


@lru_cache(maxsize=256)
def points_of(law: Law) -> Points:
    """Return the points of a law, as many on each of its pieces: of n, the i-th at the share (1 − cos(πi/n))/2."""
    pieces = law_pieces(law)
    n, k = INTERVALS // len(pieces), np.arange(INTERVALS + 1)
    piece = np.minimum(k // n + 1, len(pieces))
    share = np.where(k >= n * len(pieces), 1.0, (1.0 - np.cos(np.pi * (k % n) / n)) / 2.0)
    begins, durations = (np.array(each) for each in zip(*((p.begin, p.piece.duration) for p in pieces), strict=True))
    xi = np.minimum(begins[piece - 1] + share * durations[piece - 1], 1.0)
    found = law.evaluate(xi)
    return Points(n, piece.astype(float), share, xi, found.s, found.v)


class Between(NamedTuple):
    """Between which points heights lie, and the share of time of each: arrays."""

    heights: Array
    point: Array  # the last point that is not above, from 1
    low: Points  # that point
    high: Points  # and the next
    over: Array  # of the height over that of the lower point
    acceleration: Array  # as if it were constant from one to the other
    near: Array  # the share of time by it
    s: Array  # height there
    v: Array  # velocity there
    correction: Array  # what is missing of the height over the velocity there; 0 beside a point at rest

    @property
    def xi(self) -> Array:
        """The share of time; that of heights 0 and 1 is exact."""
        inner = (self.heights > 0.0) & (self.heights < 1.0)
        return np.where(inner, self.near + self.correction, self.heights)


def between(law: Law, heights: Array) -> Between:
    """Return where a law reaches heights: u = 2Δs/(v + √(v² + 2aΔs)) between points, then what is missing over v."""
    points = points_of(law)
    k = np.searchsorted(points.s, np.minimum(heights + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE), side="right") - 1
    low, high = (points._replace(xi=points.xi[i], s=points.s[i], v=points.v[i]) for i in (k, k + 1))
    d, over = high.xi - low.xi, heights - low.s
    a = 2.0 * (high.s - low.s - low.v * d) / d**2
    on_low, on_high = over <= BREAK_TOLERANCE, heights >= high.s - BREAK_TOLERANCE
    inside = ~(on_low | on_high)
    root = np.sqrt(low.v**2 + 2.0 * a * over, out=np.ones_like(over), where=inside)
    near = np.select([on_low, on_high], [low.xi, high.xi], low.xi + 2.0 * over / (low.v + root))
    found = law.evaluate(near)
    moving = np.minimum(low.v, high.v) > REST
    correction = np.divide(heights - found.s, found.v, out=np.zeros_like(over), where=moving)
    return Between(heights, (k + 1).astype(float), low, high, over, a, near, found.s, found.v, correction)


def inverse_by_points(law: Law, heights: Array) -> Array:
    """Return the share of time at which a law has reached heights from 0 to 1, by its points."""
    return between(law, heights).xi
