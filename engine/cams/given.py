"""A table of points as it is given: its columns, how precise they are, and how fast it begins and ends."""

from typing import NamedTuple

import numpy as np

from engine.laws import Law
from engine.laws.base import Array

FEW = 6  # points, from which the velocity at an end of a table is told
ROUND = 24  # numbers, so many of which may be round ones
QUINTIC = "PO5"
LONGER = 2.0  # times its neighbours: an interval between two equal points is a dwell, one along a line is one
AT_SPEED = 1e-3  # of the fastest: what is slower rests
SEAM = 1e-2
"""of the fastest: so alike are begin and end of a cycle that goes on as it began, as few points tell them"""


class Points(NamedTuple):
    """A table: x, y, where it has them y' and y'', and the precision of y.

    ``begins`` and ``ends`` say whether it begins and ends on the way, and meets nothing there; what keeps to no law is
    ``thinned`` to a spline that is no farther from it. ``seam`` is y' and y'' where the cycle goes on as it began.
    """

    x: Array
    y: Array
    v: Array | None
    a: Array | None
    precision: float
    begins: bool = False
    ends: bool = False
    thinned: float = 0.0
    seam: tuple[float, float] | None = None


def precision(y: Array) -> float:
    """Return how precise numbers are: half of their last decimal, or what 32 or 64 bits keep of the largest.

    A few numbers may have few decimals because they are round: of these the bits alone count.
    """
    size = float(np.abs(y).max(initial=0.0))
    for digits in range(10 if len(y) > ROUND else 0):
        if np.allclose(y, np.round(y, digits), rtol=0.0, atol=1e-15 * size):
            return float(0.5 * 10.0**-digits)
    single = np.array_equal(y, y.astype(np.float32).astype(np.float64))
    return size * (2.0**-24 if single else 2.0**-50)


def part(of: Points, begin: int, end: int) -> Points:
    """Return a table from one of its points to another."""
    inside = slice(begin, end + 1)
    v, a = (None if one is None else one[inside] for one in (of.v, of.a))
    begins, ends = of.begins and begin == 0, of.ends and end == len(of.x) - 1
    return of._replace(x=of.x[inside], y=of.y[inside], v=v, a=a, begins=begins, ends=ends)


def may_be(one: Law, of: Points) -> bool:
    """Whether a law can be told from so few points: two with y' and y'' are a polynomial of degree 5, and no other."""
    return len(of.x) > 2 or of.a is None or one.code == QUINTIC


def _polynomial_rates(x: Array, y: Array) -> tuple[float, float]:
    """Return y' and y'' at x = 0 of a polynomial through points."""
    width = float(np.abs(x).max())
    c = np.linalg.lstsq(np.polynomial.polynomial.polyvander(x / width, len(x) - 1), y, rcond=None)[0]
    return float(c[1]) / width, 2.0 * float(c[2]) / width**2 if len(c) > 2 else 0.0


def rate_at(of: Points, side: int) -> tuple[float, float]:
    """Return y' and y'' at the begin (0) or the end (-1) of a table: its own, or of a polynomial through its points."""
    some = slice(0, FEW) if side == 0 else slice(-FEW, None)
    v, a = _polynomial_rates(of.x[some] - of.x[side], of.y[some])
    return v if of.v is None else float(of.v[side]), a if of.a is None else float(of.a[side])


def moves_at(of: Points, side: int) -> bool:
    """Whether a table begins (0) or ends (-1) on the way."""
    return abs(rate_at(of, side)[0]) > AT_SPEED * fastest(of)


def fastest(of: Points) -> float:
    """Return the largest y' from point to point."""
    return float(np.abs(np.diff(of.y) / np.diff(of.x)).max())


def seam(of: Points) -> tuple[float, float] | None:
    """Return y' and y'' where a cycle goes on as it began, by a polynomial through the points on either side.

    None where its velocities at begin and end are not alike, or the table tells them.
    """
    if of.v is not None or abs(rate_at(of, 0)[0] - rate_at(of, -1)[0]) > SEAM * fastest(of):
        return None
    half = FEW // 2 + 1
    x, y = (np.concatenate([one[-half:-1] - one[-1], one[:half] - one[0]]) for one in (of.x, of.y))
    return _polynomial_rates(x, y)
