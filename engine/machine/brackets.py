"""Where a figure of a drive changes its sign between two places: in a few steps, as a row of cells finds it."""

from __future__ import annotations

from typing import NamedTuple

SAME = 1e-4
"""of what has no sign: how little two values may differ for a chord through them"""


class Bracket(NamedTuple):
    """Two places of a stretch, the values of a figure there, and how small a value has no sign."""

    low: float
    high: float
    at_low: float
    at_high: float
    lost: float

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

    def second(self, at_first: float) -> float:
        """Return where an inverse parabola through both ends and the first place is 0."""
        a, b, c, x = self.at_low, self.at_high, at_first, self.first
        if min(abs(c - a), abs(c - b)) <= self.lost:
            return x
        found = self.low * b * c / ((a - b) * (a - c)) + self.high * a * c / ((b - a) * (b - c))
        return self.within(found + x * a * b / ((c - a) * (c - b)))

    def chord(self, one: float, other: float, at_one: float, at_other: float) -> float:
        """Return where a straight line through two places is 0; the second where it is level."""
        rise = at_other - at_one
        if abs(rise) <= SAME * self.lost:
            return other
        return self.within(other - at_other * (other - one) / rise)
