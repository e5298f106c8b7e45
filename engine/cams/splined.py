"""Points of a table that keep to no law: cubic splines through few of them, thinned to a tolerance."""

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.given import Points, part
from engine.cams.interpolation import spline
from engine.cams.profile import CamProfile
from engine.laws.base import Array
from engine.laws.spline import MOST, NARROWEST, Spline

LEVEL = 0.01
"""of the reach: a movement that comes back so near to where it began is told as two"""
BETWEEN = 8  # places of a table whose polynomials are known, from point to point
MOST_PHASES = 20


class Thinned(NamedTuple):
    """A spline from x to x and from y by a lift, and how far the points are from it."""

    law: Spline
    begin: float
    end: float
    y: float
    lift: float
    residual: float


def splined(
    of: Points, slopes: tuple[float, float], rate: Callable[[float], float], most: float
) -> list[Thinned]:  # fmt: skip
    """Return splines one after the other that are at most ``most`` from the points; none where too many are needed.

    ``slopes`` are y' at both ends, ``rate`` gives it at any place between. A movement is parted where it is farthest
    from its begin if it comes back, and in its middle if a hundred points do not do.
    """
    found: list[Thinned] = []
    left = [(0, len(of.x) - 1, slopes)]
    while left:
        begin, end, ends = left.pop()
        one = None if comes_back(of.y[begin : end + 1]) else thinned(part(of, begin, end), ends, most)
        if one:
            found.append(one)
            continue
        if end - begin < 2 or len(found) + len(left) >= MOST_PHASES:
            return []
        middle = parting(of.y, begin, end)
        there = rate(float(of.x[middle]))
        left += [(middle, end, (there, ends[1])), (begin, middle, (ends[0], there))]
    return found


def comes_back(y: Array) -> bool:
    """Whether a movement ends near where it began."""
    return bool(abs(y[-1] - y[0]) <= LEVEL * np.ptp(y))


def parting(y: Array, begin: int, end: int) -> int:
    """Return the point at which a movement is parted: the farthest from its begin if it comes back, else the middle."""
    inner = y[begin : end + 1]
    if comes_back(inner):
        farthest = begin + int(np.abs(inner - inner[0]).argmax())
        if begin < farthest < end:
            return farthest
    return (begin + end) // 2


def thinned(of: Points, slopes: tuple[float, float], most: float) -> Thinned | None:
    """Return the spline through as few of the points as keep the others within ``most``; None if 100 do not do."""
    last = len(of.x) - 1
    near = NARROWEST * float(of.x[-1] - of.x[0])
    kept = np.array([0, last])
    missed = misses(of, kept, slopes)
    while missed.max() > most:
        worst = [int(a + missed[a : b + 1].argmax()) for a, b in pairwise(kept.tolist())]
        more = [k for k in worst if missed[k] > most and k not in kept]
        kept = np.unique([*kept, *more])
        if not more or len(kept) > MOST or np.diff(of.x[kept]).min() < near:
            return None
        missed = misses(of, kept, slopes)
    for k in kept[1:-1].tolist():
        fewer = kept[kept != k]
        if misses(of, fewer, slopes).max() <= most:
            kept = fewer
    return law_of(of, kept, slopes)


def misses(of: Points, kept: NDArray[np.intp], slopes: tuple[float, float]) -> Array:
    """Return how far each point is from the spline through those that are kept."""
    return np.abs(spline(of.x[kept], of.y[kept], slopes).at(of.x).y - of.y)


def law_of(of: Points, kept: NDArray[np.intp], slopes: tuple[float, float]) -> Thinned:
    """Return the law of a spline through the points that are kept."""
    begin, end = float(of.x[0]), float(of.x[-1])
    lift, span = float(of.y[-1] - of.y[0]), end - begin
    xi, s = (of.x[kept] - begin) / span, (of.y[kept] - of.y[0]) / lift
    points = tuple(zip(xi.tolist(), s.tolist(), strict=True))
    one, other = (slope * span / lift for slope in slopes)
    return Thinned(
        Spline(((0.0, 0.0), *points[1:-1], (1.0, 1.0)), (one, other)), begin, end, float(of.y[0]), lift,
        float(misses(of, kept, slopes).max()),
    )  # fmt: skip


def rate_of(rebuilt: CamProfile) -> Callable[[float], float]:
    """Return what gives y' of a profile at a place."""
    return lambda x: float(rebuilt.at(np.array([x])).y1[0])


def dense(of: Points, rebuilt: CamProfile) -> Points:
    """Return the points, and some places between each two where y' and y'' are told: what lies there is known too."""
    if of.v is None:
        return of
    steps = np.linspace(0.0, 1.0, BETWEEN, endpoint=False)
    x = np.append((of.x[:-1, None] + np.diff(of.x)[:, None] * steps).ravel(), of.x[-1])
    return of._replace(x=x, y=rebuilt.at(x, left=True).y, v=None, a=None)
