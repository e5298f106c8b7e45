"""Points of a table that keep to no law: cubic splines through few of them, thinned to a tolerance."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import parted
from engine.cams.given import Points, part
from engine.cams.interpolation import spline
from engine.cams.profile import CamProfile
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.ends import EndedLaw
from engine.laws.spline import MOST, NARROWEST, Spline

LEVEL = 0.01
"""of the reach: a movement that comes back so near to where it began is told as two"""
BETWEEN = 8  # places of a table whose polynomials are known, from point to point
MOST_PHASES = 20


@dataclass(frozen=True)
class Found:
    """A phase that was found: a law from x to x and from y by a lift, and how far the table is from it at most.

    It is ``known`` if it is a law of the registry, and no spline through the points; ``fits`` if it does at all.
    """

    law: Law
    begin: float
    end: float
    y: float
    lift: float
    residual: float
    fits: bool = True
    known: bool = True

    @property
    def scale(self) -> float:
        """What the law's s is multiplied by: 1 where the law has the lift in itself."""
        return 1.0 if isinstance(self.law, EndedLaw) and not self.law.ends.at_rest else self.lift

    @property
    def rests(self) -> bool:
        """Whether it begins and ends at rest."""
        at = self.law.start, self.law.end
        return all(abs(one.v) <= 1e-6 * self.law.coefficients.cv for one in at)

    def rates(self, side: int) -> tuple[float, float]:
        """Return y' and y'' at its begin (0) or end (1), where its ends are prescribed; else 0."""
        span = self.end - self.begin
        if isinstance(self.law, Spline):
            return (self.law.slopes[side] or 0.0) * self.lift / span, 0.0
        if not isinstance(self.law, EndedLaw):
            return 0.0, 0.0
        return self.law.ends.both("v")[side] / span, self.law.ends.both("a")[side] / span**2


def splined(of: Points, rebuilt: CamProfile, slopes: tuple[float, float], most: float) -> list[Found]:
    """Return splines one after the other that are at most ``most`` from the points; none where too many are needed.

    ``slopes`` are y' at both ends, what rebuilds the table has it at any place between, and where the table has y',
    places between its points as well. A movement is parted where it is farthest from its begin if it comes back, and in
    its middle if a hundred points do not do.
    """
    if of.v is not None:
        x = parted(of.x, BETWEEN)
        of = of._replace(x=x, y=rebuilt.at(x, left=True).y, v=None, a=None)
    found: list[Found] = []
    left = [(0, len(of.x) - 1, slopes)]
    while left:
        begin, end, ends = left.pop()
        y = of.y[begin : end + 1]
        comes_back = bool(abs(y[-1] - y[0]) <= LEVEL * np.ptp(y))
        one = None if comes_back else _thinned(part(of, begin, end), ends, most)
        if one:
            found.append(one)
            continue
        if end - begin < 2 or len(found) + len(left) >= MOST_PHASES:
            return []
        farthest = begin + int(np.abs(y - y[0]).argmax())
        middle = farthest if comes_back and begin < farthest < end else (begin + end) // 2
        there = float(rebuilt.at(of.x[middle : middle + 1]).y1[0])
        left += [(middle, end, (there, ends[1])), (begin, middle, (ends[0], there))]
    return found


def _thinned(of: Points, slopes: tuple[float, float], most: float) -> Found | None:
    """Return the spline through as few of the points as keep the others within ``most``; None if 100 do not do."""
    begin, end = float(of.x[0]), float(of.x[-1])
    lift, span = float(of.y[-1] - of.y[0]), end - begin
    kept = np.array([0, len(of.x) - 1])
    missed = _misses(of, kept, slopes)
    while missed.max() > most:
        worst = [int(a + missed[a : b + 1].argmax()) for a, b in pairwise(kept.tolist())]
        more = [k for k in worst if missed[k] > most and k not in kept]
        kept = np.unique([*kept, *more])
        if not more or len(kept) > MOST or np.diff(of.x[kept]).min() < NARROWEST * span:
            return None
        missed = _misses(of, kept, slopes)
    for k in kept[1:-1].tolist():
        fewer = kept[kept != k]
        if _misses(of, fewer, slopes).max() <= most:
            kept = fewer
    inner = kept[1:-1]
    points = zip(((of.x[inner] - begin) / span).tolist(), ((of.y[inner] - of.y[0]) / lift).tolist(), strict=True)
    one, other = (slope * span / lift for slope in slopes)
    law = Spline(((0.0, 0.0), *points, (1.0, 1.0)), (one, other))
    return Found(law, begin, end, float(of.y[0]), lift, float(_misses(of, kept, slopes).max()), known=False)


def _misses(of: Points, kept: NDArray[np.intp], slopes: tuple[float, float]) -> Array:
    """Return how far each point is from the spline through those that are kept."""
    return np.abs(spline(of.x[kept], of.y[kept], slopes).at(of.x).y - of.y)
