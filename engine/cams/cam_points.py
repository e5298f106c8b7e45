"""Points of a cam table: their precision, the rates at its ends; its phases, and splines through few points."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import subdivide_intervals
from engine.cams.interpolation import spline
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.ends import BoundaryLaw
from engine.laws.spline import MOST, NARROWEST, Spline
from engine.motion.profile import CamProfile

FEW = 6  # points, from which the velocity at an end of a table is computed
ROUND = 24  # numbers: up to so many may be round by chance
COUNTING = range(6, 10)  # digits that count, to which a file may round its numbers
ROUNDED = 1e-9  # share of the range: least error that a fit may have
# share of the peak by which a law's velocity and acceleration may deviate from a table's
RATES = 1e-5
QUINTIC = "PO5"
LONGER = 2.0  # length over the neighbours' from which a single interval counts as a dwell, or as a straight line
AT_SPEED = 1e-3  # share of the largest velocity: a slower end is at rest
SEAM = 1e-2  # share of the largest velocity by which begin and end of a continuous cycle may differ


class CamPoints(NamedTuple):
    """Points of a cam table, which may begin or end at speed; arrays of equal length, in any units."""

    x: Array
    y: Array
    v: Array | None  # y', if the table has it
    a: Array | None  # y'', if the table has it
    precision: float  # of y
    begins: bool = False  # whether it begins at speed, with no phase before
    ends: bool = False  # whether it ends at speed, with no phase after
    thinned: float = 0.0  # allowed error of a spline in place of a law
    seam: tuple[float, float] | None = None  # y' and y'' at both ends of a continuous cycle

    def part(self, begin: int, end: int) -> "CamPoints":
        """Return the points from a number to another, both included, from 0."""
        inside = slice(begin, end + 1)
        v, a = (None if rates is None else rates[inside] for rates in (self.v, self.a))
        begins, ends = self.begins and begin == 0, self.ends and end == len(self.x) - 1
        return self._replace(x=self.x[inside], y=self.y[inside], v=v, a=a, begins=begins, ends=ends)

    @property
    def fastest(self) -> float:
        """The largest |y'| of the chords from point to point."""
        return float(np.abs(np.diff(self.y) / np.diff(self.x)).max())

    @property
    def near(self) -> float:
        """The allowed error of a fit."""
        return max(2.0 * self.precision, ROUNDED * float(np.ptp(self.y)))

    def identifies(self, law: Law) -> bool:
        """Return whether the points suffice for a law: two with y' and y'' do for a polynomial of degree 5 only."""
        return len(self.x) > 2 or self.a is None or law.code == QUINTIC

    def rate_at(self, side: int) -> tuple[float, float]:
        """Return y' and y'' at the begin (0) or the end (-1): the table's own, else of a polynomial through points."""
        some = slice(0, FEW) if side == 0 else slice(-FEW, None)
        v, a = _polynomial_rates(self.x[some] - self.x[side], self.y[some])
        return v if self.v is None else float(self.v[side]), a if self.a is None else float(self.a[side])

    def moves_at(self, side: int) -> bool:
        """Return whether the table begins (0) or ends (-1) at speed."""
        return abs(self.rate_at(side)[0]) > AT_SPEED * self.fastest

    def rates_across(self) -> tuple[float, float] | None:
        """Return y' and y'' across the end of the cycle, from points on both sides; None if they do not continue."""
        if self.v is not None or abs(self.rate_at(0)[0] - self.rate_at(-1)[0]) > SEAM * self.fastest:
            return None
        half = FEW // 2 + 1
        x, y = (np.concatenate([row[-half:-1] - row[-1], row[:half] - row[0]]) for row in (self.x, self.y))
        return _polynomial_rates(x, y)


def precision(y: Array) -> float:
    """Return the precision of numbers: half of the last digit, or the rounding of the largest in 32 or 64 bits.

    They have as many decimals each, or as many digits that count, of which the largest tells. Few numbers may be round
    by chance, so their digits do not count.
    """
    size, halves = float(np.abs(y).max(initial=0.0)), []
    if len(y) > ROUND and size > 0.0:
        decimals = (n for n in range(10) if np.allclose(y, np.round(y, n), rtol=0.0, atol=1e-15 * size))
        counting = (n for n in COUNTING if np.allclose(y, [float(f"{number:.{n}g}") for number in y], 1e-15, 0.0))
        halves += [0.5 * 10.0**-n for n in islice(decimals, 1)]
        halves += [0.5 * 10.0 ** (math.floor(math.log10(size)) + 1 - n) for n in islice(counting, 1)]
    single = np.array_equal(y, y.astype(np.float32).astype(np.float64))
    return max(halves, default=size * (2.0**-24 if single else 2.0**-50))


def _polynomial_rates(x: Array, y: Array) -> tuple[float, float]:
    """Return y' and y'' at x = 0 of a polynomial through points."""
    width = float(np.abs(x).max())
    c = np.linalg.lstsq(np.polynomial.polynomial.polyvander(x / width, len(x) - 1), y, rcond=None)[0]
    return float(c[1]) / width, 2.0 * float(c[2]) / width**2 if len(c) > 2 else 0.0


LEVEL = 0.01  # share of the range: a movement that returns so near to its begin is divided in two
BETWEEN = 8  # parts of each interval at which known polynomials are evaluated
MOST_PHASES = 20


@dataclass(frozen=True)
class FoundPhase:
    """A phase identified in a cam table, in its units."""

    law: Law
    begin: float  # x
    end: float  # x
    y: float  # at the begin
    lift: float
    residual: float = 0.0  # largest deviation of the points
    fits: bool = True  # whether it follows the points at all
    known: bool = True  # whether its law is of the catalogue, not a spline through points

    @property
    def scale(self) -> float:
        """Factor of the law's s: 1 if the lift is in the law's boundary values."""
        return 1.0 if isinstance(self.law, BoundaryLaw) and not self.law.ends.at_rest else self.lift

    @property
    def rests(self) -> bool:
        """Whether it begins and ends at rest."""
        return max(abs(self.law.start.v), abs(self.law.end.v)) <= 1e-6 * self.law.coefficients.cv

    def rates(self, side: int) -> tuple[float, float]:
        """Return y' and y'' at its begin (0) or end (1) by its boundary values; 0 without."""
        span = self.end - self.begin
        if isinstance(self.law, Spline):
            return (self.law.slopes[side] or 0.0) * self.lift / span, 0.0
        if not isinstance(self.law, BoundaryLaw):
            return 0.0, 0.0
        return self.law.ends.both("v")[side] / span, self.law.ends.both("a")[side] / span**2

    def off(self, of: CamPoints) -> Array:
        """Return the deviations from points; beyond an end with a velocity, those of the line through that end."""
        xi = (of.x - self.begin) / (self.end - self.begin)
        inside = np.clip(xi, 0.0, 1.0)
        ends = (self.law.start.v, self.law.end.v) if isinstance(self.law, BoundaryLaw) else (0.0, 0.0)
        return np.asarray(self.y + self.scale * (self.law.s(inside) + np.where(xi < 0.0, *ends) * (xi - inside)) - of.y)

    def agrees(self, of: CamPoints, typical: Callable[[Array], float] = np.max) -> bool:
        """Return whether y' and y'' of a table, if it has them, are the phase's; at its end those of the next count."""
        d = self.end - self.begin
        at = self.law.evaluate(np.clip((of.x - self.begin) / d, 0.0, 1.0))
        per, peaks = self.scale / d, self.law.coefficients
        for given, meant, most in ((of.v, per * at.v, per * peaks.cv), (of.a, per / d * at.a, per / d * peaks.ca)):
            if given is not None:
                near = max(RATES * abs(most), 2.0 * precision(given))
                if typical(np.abs(given - meant)[:-1]) > near:
                    return False
        return True


def splines(of: CamPoints, rebuilt: CamProfile, slopes: tuple[float, float], most: float) -> list[FoundPhase]:
    """Return consecutive splines through few points, in succession, that keep to the others.

    A movement that returns is divided farthest from its begin, a movement of more than a hundred points in its middle.

    Parameters
    ----------
    of : CamPoints
        A part of the table, in any units of x and y.
    rebuilt : CamProfile
        The same by the controller's rule: it gives y' where splines meet, and y between points if the table has y'.
    slopes : (float, float), unit of y over that of x
        y' at both ends.
    most : float, unit of y
        Deviation from the other points at most.

    Returns
    -------
    list of FoundPhase
        Empty if more than 20 are needed, or no point is left at which to divide.
    """
    if of.v is not None:
        x = subdivide_intervals(of.x, BETWEEN)
        of = of._replace(x=x, y=rebuilt.at(x, left=True).y, v=None, a=None)
    phases: list[FoundPhase] = []
    left = [(0, len(of.x) - 1, slopes)]
    while left:
        begin, end, ends = left.pop()
        y = of.y[begin : end + 1]
        comes_back = bool(abs(y[-1] - y[0]) <= LEVEL * np.ptp(y))
        fitted = None if comes_back else _thinned(of.part(begin, end), ends, most)
        if fitted:
            phases.append(fitted)
            continue
        if end - begin < 2 or len(phases) + len(left) >= MOST_PHASES:
            return []
        farthest = begin + int(np.abs(y - y[0]).argmax())
        middle = farthest if comes_back and begin < farthest < end else (begin + end) // 2
        there = float(rebuilt.at(of.x[middle : middle + 1]).y1[0])
        left += [(middle, end, (there, ends[1])), (begin, middle, (ends[0], there))]
    return phases


def _thinned(of: CamPoints, slopes: tuple[float, float], most: float) -> FoundPhase | None:
    """Return the spline through as few points as keep the others within ``most``; None if it takes more than 100."""
    begin, end = float(of.x[0]), float(of.x[-1])
    lift, span = float(of.y[-1] - of.y[0]), end - begin
    ends = np.array([0, len(of.x) - 1])
    missed = _misses(of, ends, slopes)
    while missed.max() > most:
        worst = [int(a + missed[a : b + 1].argmax()) for a, b in pairwise(ends.tolist())]
        more = [k for k in worst if missed[k] > most and k not in ends]
        ends = np.unique([*ends, *more])
        if not more or len(ends) > MOST or np.diff(of.x[ends]).min() < NARROWEST * span:
            return None
        missed = _misses(of, ends, slopes)
    for k in ends[1:-1].tolist():
        fewer = ends[ends != k]
        if _misses(of, fewer, slopes).max() <= most:
            ends = fewer
    inner = ends[1:-1]
    points = zip(((of.x[inner] - begin) / span).tolist(), ((of.y[inner] - of.y[0]) / lift).tolist(), strict=True)
    first, last = (slope * span / lift for slope in slopes)
    law = Spline(((0.0, 0.0), *points, (1.0, 1.0)), (first, last))
    return FoundPhase(law, begin, end, float(of.y[0]), lift, float(_misses(of, ends, slopes).max()), known=False)


def _misses(of: CamPoints, ends: NDArray[np.intp], slopes: tuple[float, float]) -> Array:
    """Return the deviation of each point from the spline through those that are ``corners``."""
    return np.abs(spline(of.x[ends], of.y[ends], slopes).at(of.x).y - of.y)


TURNS = 12  # iterations of Gauss and Newton
# in so many iterations the residual must fall to this share, else the law is another
SETTLED, SLOW = 3, 0.5
STEP = 1e-4  # share of the interval between points, for derivatives of the deviations by the place of a break


def gauss_newton(off: Callable[[Array], Array], fit: Array, steps: Array, near: float) -> Array | None:
    """Return parameters with small deviations, by the method of Gauss and Newton.

    Parameters
    ----------
    off : callable
        The deviations, array (n,), by the parameters, array (k,).
    fit, steps : array (k,)
        Parameters to begin with, and by how much an iteration may move each; without a limit infinite.
    near : float, unit of the deviations
        Largest deviation allowed.

    Returns
    -------
    array (k,) or None
        None where the deviations do not become so small, or fall too slowly.
    """
    missed: list[float] = []
    moves = np.diag(np.where(np.isfinite(steps), STEP * steps, 1.0))
    for _ in range(TURNS + 1):
        here = off(fit)
        missed.append(float(np.abs(here).max()))
        if missed[-1] <= near:
            return fit
        slow = len(missed) > SETTLED and missed[-1] > SLOW * missed[-SETTLED]
        if slow or not fit.size or not np.isfinite(missed[-1]):
            return None
        slopes = np.column_stack([(off(fit + move) - here) / move.sum() for move in moves])
        if not np.all(np.isfinite(slopes)):
            return None
        by = np.linalg.lstsq(slopes, -here, rcond=1e-12)[0]
        fit = fit + np.clip(by, -steps, steps)
    return None
