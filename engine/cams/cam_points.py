"""A table of points as it is given: how precise it is, how fast it begins and ends, splines through few points."""

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import subdivided
from engine.cams.interpolation import spline
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.ends import BoundaryLaw
from engine.laws.spline import MOST, NARROWEST, Spline
from engine.motion.pieces import CamProfile

FEW = 6  # points, from which the velocity at an end of a table is told
ROUND = 24  # numbers, so many of which may be round ones
QUINTIC = "PO5"
LONGER = 2.0  # times its neighbours: an interval between two equal points is a dwell, one along a line is one
AT_SPEED = 1e-3  # of the fastest: what is slower rests
SEAM = 1e-2  # of the fastest: so alike are begin and end of a cycle that goes on as it began, as few points tell them


class CamPoints(NamedTuple):
    """A table of points, which may begin or end on the way."""

    x: Array
    y: Array
    v: Array | None  # y', where the table has it
    a: Array | None  # y'', likewise
    precision: float  # of y
    begins: bool = False  # on the way: it meets nothing there
    ends: bool = False  # likewise
    thinned: float = 0.0  # how far a spline may be from what keeps to no law
    seam: tuple[float, float] | None = None  # y' and y'' where the cycle goes on as it began

    def part(self, begin: int, end: int) -> "CamPoints":
        """Return the table from one of its points to another, both counted from 0."""
        inside = slice(begin, end + 1)
        v, a = (None if rates is None else rates[inside] for rates in (self.v, self.a))
        begins, ends = self.begins and begin == 0, self.ends and end == len(self.x) - 1
        return self._replace(x=self.x[inside], y=self.y[inside], v=v, a=a, begins=begins, ends=ends)

    @property
    def fastest(self) -> float:
        """The largest |y'| of the chords from point to point."""
        return float(np.abs(np.diff(self.y) / np.diff(self.x)).max())

    def identifies(self, law: Law) -> bool:
        """Whether so many points tell a law: two with y' and y'' tell a polynomial of degree 5, and no other."""
        return len(self.x) > 2 or self.a is None or law.code == QUINTIC

    def rate_at(self, side: int) -> tuple[float, float]:
        """Return y' and y'' at the begin (0) or the end (-1): the table's own, else of a polynomial through points."""
        some = slice(0, FEW) if side == 0 else slice(-FEW, None)
        v, a = _polynomial_rates(self.x[some] - self.x[side], self.y[some])
        return v if self.v is None else float(self.v[side]), a if self.a is None else float(self.a[side])

    def moves_at(self, side: int) -> bool:
        """Whether the table begins (0) or ends (-1) at speed."""
        return abs(self.rate_at(side)[0]) > AT_SPEED * self.fastest

    def rates_across(self) -> tuple[float, float] | None:
        """Return y' and y'' where the cycle goes on as it began, by the points on either side; None where it stops."""
        if self.v is not None or abs(self.rate_at(0)[0] - self.rate_at(-1)[0]) > SEAM * self.fastest:
            return None
        half = FEW // 2 + 1
        x, y = (np.concatenate([row[-half:-1] - row[-1], row[:half] - row[0]]) for row in (self.x, self.y))
        return _polynomial_rates(x, y)


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


def _polynomial_rates(x: Array, y: Array) -> tuple[float, float]:
    """Return y' and y'' at x = 0 of a polynomial through points."""
    width = float(np.abs(x).max())
    c = np.linalg.lstsq(np.polynomial.polynomial.polyvander(x / width, len(x) - 1), y, rcond=None)[0]
    return float(c[1]) / width, 2.0 * float(c[2]) / width**2 if len(c) > 2 else 0.0


LEVEL = 0.01  # of the reach: a movement that comes back so near to where it began is told as two
BETWEEN = 8  # places of a table whose polynomials are known, from point to point
MOST_PHASES = 20


@dataclass(frozen=True)
class FoundPhase:
    """A phase that was found: a law from x to x and from y by a lift."""

    law: Law
    begin: float
    end: float
    y: float
    lift: float
    residual: float = 0.0  # how far the table is from it at most
    fits: bool = True  # whether it keeps to the table at all
    known: bool = True  # a law of the registry, and no spline through the points

    @property
    def scale(self) -> float:
        """What the law's s is multiplied by: 1 where the law has the lift in itself."""
        return 1.0 if isinstance(self.law, BoundaryLaw) and not self.law.ends.at_rest else self.lift

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
        if not isinstance(self.law, BoundaryLaw):
            return 0.0, 0.0
        return self.law.ends.both("v")[side] / span, self.law.ends.both("a")[side] / span**2

    def off(self, of: CamPoints) -> Array:
        """Return by how much points are off it, or the line that it meets beyond an end that is prescribed."""
        xi = (of.x - self.begin) / (self.end - self.begin)
        inside = np.clip(xi, 0.0, 1.0)
        ends = (self.law.start.v, self.law.end.v) if isinstance(self.law, BoundaryLaw) else (0.0, 0.0)
        return np.asarray(self.y + self.scale * (self.law.s(inside) + np.where(xi < 0.0, *ends) * (xi - inside)) - of.y)


def splined(of: CamPoints, rebuilt: CamProfile, slopes: tuple[float, float], most: float) -> list[FoundPhase]:
    """Return splines one after the other that are at most ``most`` from the points; none where too many are needed.

    ``slopes`` are y' at both ends, what rebuilds the table has it at any place between, and where the table has y',
    places between its points as well. A movement is parted where it is farthest from its begin if it comes back, and in
    its middle if a hundred points do not do.
    """
    if of.v is not None:
        x = subdivided(of.x, BETWEEN)
        of = of._replace(x=x, y=rebuilt.at(x, left=True).y, v=None, a=None)
    found: list[FoundPhase] = []
    left = [(0, len(of.x) - 1, slopes)]
    while left:
        begin, end, ends = left.pop()
        y = of.y[begin : end + 1]
        comes_back = bool(abs(y[-1] - y[0]) <= LEVEL * np.ptp(y))
        one = None if comes_back else _thinned(of.part(begin, end), ends, most)
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


def _thinned(of: CamPoints, slopes: tuple[float, float], most: float) -> FoundPhase | None:
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
    return FoundPhase(law, begin, end, float(of.y[0]), lift, float(_misses(of, kept, slopes).max()), known=False)


def _misses(of: CamPoints, kept: NDArray[np.intp], slopes: tuple[float, float]) -> Array:
    """Return how far each point is from the spline through those that are kept."""
    return np.abs(spline(of.x[kept], of.y[kept], slopes).at(of.x).y - of.y)
