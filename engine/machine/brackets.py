"""Where a figure of a drive changes its sign between two places: in a few steps, as a row of cells finds it."""

from __future__ import annotations

import math
from typing import NamedTuple

NONE = 1e-4
"""of what has no sign: a value that is 0, from which no step is taken"""


class Point(NamedTuple):
    """A place, and the value of a figure there."""

    u: float
    value: float


class Step(NamedTuple):
    """From a place to where the parabola through three points is 0, one of them there.

    With p and q from there to the others, that is value + (slope t + bend t²)/size: by p²(g_q − g) − q²(g_p − g),
    q(g_p − g) − p(g_q − g) and p q (p − q). ``steep`` is what twice the value is divided by.
    """

    slope: float
    bend: float
    size: float
    steep: float
    place: float


class Bracket(NamedTuple):
    """Two places of a stretch, the values of a figure there, and how small a value has no sign."""

    low: float
    high: float
    at_low: float
    at_high: float
    lost: float

    @property
    def begin(self) -> Point:
        """The lower place."""
        return Point(self.low, self.at_low)

    @property
    def end(self) -> Point:
        """The higher one."""
        return Point(self.high, self.at_high)

    @property
    def rise(self) -> int:
        """1 where the figure rises from place to place, or −1."""
        return 1 if self.at_high >= self.at_low else -1

    def beside(self, u: float, value: float) -> Bracket:
        """Return the part of it, before or behind a place where the figure has a value, in which that changes sign."""
        same = value * self.at_low > self.lost * abs(self.at_low)
        return self._replace(low=u, at_low=value) if same else self._replace(high=u, at_high=value)

    def within(self, u: float) -> float:
        """Return a place, or the end that it lies beyond."""
        return max(self.low, min(self.high, u))

    @property
    def first(self) -> float:
        """Where a straight line through both ends is 0."""
        rise = self.at_high - self.at_low
        if abs(rise) <= self.lost:
            return self.low
        return self.within(self.low - self.at_low * (self.high - self.low) / rise)

    def step(self, one: Point, other: Point, last: Point, rise: int) -> Step:
        """Return the step to where a parabola through three points is 0 and rises (1) or falls (−1); 0: no step.

        Source: D. E. Muller, A method for solving algebraic equations using an automatic computer, Math. Tables Other
        Aids Comput. 10 (1956) 208–215.
        """
        p, q = one.u - last.u, other.u - last.u
        a, b = one.value - last.value, other.value - last.value
        slope, bend, size = p**2 * b - q**2 * a, q * a - p * b, p * q * (p - q)
        root = math.sqrt(max(0.0, slope**2 - 4.0 * bend * last.value * size))
        steep = rise * math.copysign(1.0, size) * slope + root if size else root
        if steep <= 0.0 or abs(last.value) <= NONE * self.lost:
            return Step(slope, bend, size, steep, last.u)
        place = self.within(last.u - 2.0 * last.value * rise * abs(size) / steep)
        return Step(slope, bend, size, steep, place)
