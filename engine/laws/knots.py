"""A spline worked out row by row, a row a point, as a table of cells has it; its extremes interval by interval.

On an interval a is linear and W = a² − 2 j v the same everywhere: so v turns where a = 0, v = 0 where a = ±√W, and
v·a is stationary where a = ±√(W/3), and is ∓W a/(3j) there. The engine's own extremes are those of
:mod:`engine.laws.piece_extremes`.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws.sections import velocity_peak
from engine.laws.spline import Spline, eliminated

STILL = 1e-9
"""of the largest velocity: one below this is none"""
EQUAL = 1e-12
"""of the largest velocity: peaks that differ by less are equal"""
SAME = 1e-9
"""of ξ: places no farther apart are one"""


class Row(NamedTuple):
    """What is solved at a point, and the interval that begins there: behind the last point one of no duration."""

    d: float
    m: float
    before: float
    held: int
    low: float
    high: float
    rhs: float
    share: float
    pivot: float
    right: float
    back: float


class Interval(NamedTuple):
    """An interval: what it begins with and ends with, and by how much a rises."""

    xi: float
    d: float
    s: float
    s1: float
    v: float
    v1: float
    a: float
    a1: float
    j: float

    @property
    def w(self) -> float:
        """W = a² − 2 j v."""
        return self.a**2 - 2.0 * self.j * self.v

    @property
    def speeds(self) -> tuple[float, float]:
        """The lowest and the largest v."""
        found = [self.v, self.v1]
        if self.a * self.a1 < 0.0:
            found.append(self.v + self.a**2 * self.d / (2.0 * (self.a - self.a1)))
        return min(found), max(found)

    @property
    def powers(self) -> tuple[float, float]:
        """The lowest and the largest v·a."""
        found = self.v * self.a, self.v1 * self.a1, self.power_at(1.0), self.power_at(-1.0)
        return min(found), max(found)

    @property
    def third(self) -> float:
        """√(W/3): the size of a where v·a is stationary; 0 where it nowhere is."""
        return math.sqrt(max(0.0, self.w) / 3.0)

    def power_at(self, sign: float) -> float:
        """Return v·a where a = ±√(W/3); where that is not inside, v·a at the begin."""
        a = sign * self.third
        inside = self.j and (self.a - a) * (self.a1 - a) < 0.0
        return -self.w * a / (3.0 * self.j) if inside else self.v * self.a

    def rises(self, still: float) -> float:
        """Return u at which v rises through 0; 0 where it does not by more than ``still``."""
        low, high = self.speeds
        if not ((self.v < -still and high > still) or (self.v1 > still and low < -still)):
            return 0.0
        root = math.sqrt(self.w)
        return (root - self.a) / self.j if self.a < 0.0 else -2.0 * self.v / (root + self.a)

    def falls(self, still: float) -> float:
        """Return u at which v falls through 0; 0 where it does not by more than ``still``."""
        return Interval(self.xi, self.d, -self.s, -self.s1, -self.v, -self.v1, -self.a, -self.a1, -self.j).rises(still)

    def reach(self, still: float) -> tuple[float, float]:
        """Return the lowest and the highest s."""
        places = [self.rises(still), self.falls(still)]
        turns = [self.s + u * (4.0 * self.v + self.a * u) / 6.0 for u in places]
        return min(self.s, self.s1, turns[0]), max(self.s, self.s1, turns[1])

    @property
    def square(self) -> float:
        """∫a² dξ."""
        return self.d * (self.a**2 + self.a * self.a1 + self.a1**2) / 3.0

    def fastest(self, top: float) -> float:
        """Return the first ξ at which v is no less than ``top``; 1 where it is nowhere."""
        if not self.d or self.speeds[1] < top:
            return 1.0
        if self.v >= top:
            return self.xi
        if self.a > 0.0 > self.a1:
            return self.xi + self.d * self.a / (self.a - self.a1)
        return self.xi + self.d

    def wrong_way(self, peak: float) -> float:
        """Return by how much v falls before ``peak``, or rises after it, at once."""
        low, high = self.speeds
        if self.d and self.xi + self.d <= peak + SAME:
            return max(0.0, self.v - low, high - self.v1)
        return max(0.0, high - self.v, self.v1 - low) if self.d and self.xi >= peak - SAME else 0.0


@dataclass(frozen=True)
class Knots:
    """A spline in a table of ``rows``, of which the first are its points."""

    law: Spline
    rows: int

    @property
    def used(self) -> int:
        """How many points it has."""
        return len(self.law.points)

    @cached_property
    def solved(self) -> list[Row]:
        """The rows of the solution: forward from the first point, ``back`` from the last."""
        n, system = self.used, self.law.system
        found = eliminated(*system)
        xi, s = self.law.knots
        steps = np.diff(xi).tolist()
        m = [*(np.diff(s) / np.diff(xi)).tolist(), self.slopes[1]]
        free = self.law.natural
        rows = [
            Row(
                [*steps, 0.0][k], m[k], [0.0, *steps][k], int((free[0] and k == 0) or (free[1] and k == n - 1)),
                [0.0, *system.below.tolist()][k], [*system.above.tolist(), 0.0][k], float(system.right[k]),
                found.shares[k], found.pivots[k], found.rights[k], float(self.law.moments[n - 1 - k]),
            )
            for k in range(n)
        ]  # fmt: skip
        spare = Row(0.0, self.slopes[1], 0.0, 1, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        return [*rows, *[spare] * (self.rows - n)]

    @property
    def slopes(self) -> tuple[float, float]:
        """The slopes entered, 0 where none is."""
        first, last = self.law.slopes
        return first or 0.0, last or 0.0

    @cached_property
    def intervals(self) -> list[Interval]:
        """The interval that begins in each row."""
        (xi, s), a, end = self.law.knots, self.law.moments.tolist(), self.law.end
        v = [*self.law.table[2].tolist(), end.v]
        rates = self.law.table[4].tolist()
        lasting = [
            Interval(float(xi[k]), float(xi[k + 1] - xi[k]), float(s[k]), float(s[k + 1]), v[k], v[k + 1], a[k],
                     a[k + 1], rates[k])
            for k in range(self.used - 1)
        ]  # fmt: skip
        last = Interval(1.0, 0.0, end.s, end.s, end.v, end.v, a[-1], a[-1], 0.0)
        return [*lasting, *[last] * (self.rows - len(lasting))]

    @cached_property
    def speeds(self) -> tuple[float, float]:
        """The lowest and the largest v."""
        lows, highs = zip(*(one.speeds for one in self.intervals), strict=True)
        return min(lows), max(highs)

    @property
    def still(self) -> float:
        """A velocity below which there is none."""
        return STILL * self.law.coefficients.cv

    @property
    def top(self) -> float:
        """A velocity from which it counts as the largest."""
        return self.speeds[1] - EQUAL * abs(self.speeds[1])

    @cached_property
    def peak(self) -> float:
        """The first ξ at which v is largest."""
        return velocity_peak(self.law)

    @property
    def steps_wrong(self) -> list[float]:
        """By how much v goes the wrong way at once, interval by interval."""
        return [one.wrong_way(self.peak) for one in self.intervals]


def entered_rows(values: Sequence[float], rows: int) -> list[float | None]:
    """Return what is entered of the points, with the spare rows filled up."""
    return [*values, *[None] * (rows - len(values))]
