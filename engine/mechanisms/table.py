"""A mechanism known by points: the load's position over the shaft's angle, by a monotone cubic. SI units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from engine.laws.base import Array, require_finite
from engine.mechanisms.linkage import Linkage, Reach, ShaftAngles

STEPS = 60  # of Newton's method, or of halving where that leaves the bracket
LAST_DIGITS = 4e-16  # of a part between two points: within them rounding turns the steps to and fro


@dataclass(frozen=True)
class PositionTable(Linkage):
    """Points (φ in rad, y in m or rad), both strictly rising, joined by the monotone cubic of Fritsch and Carlson.

    Raises ValueError for fewer than two points, or points that do not rise. At the ends the slope is that of the first
    and the last chord. Source: F. N. Fritsch, R. E. Carlson, Monotone piecewise cubic interpolation, SIAM J. Numer.
    Anal. 17 (1980) 238–246: slopes of the parabola through three points, brought into the circle α² + β² ≤ 9.
    """

    points: tuple[tuple[float, float], ...]
    name = "table"
    steady = True

    def __init__(self, points: Sequence[tuple[float, float]]) -> None:
        object.__setattr__(self, "points", tuple((float(angle), float(y)) for angle, y in points))
        if len(self.points) < 2:
            raise ValueError(f"table: {len(self.points)} points are given; expected at least two")
        for k, (one, other) in enumerate(pairwise(self.points), 2):
            require_finite(angle=other[0], position=other[1])
            if not (other[0] > one[0] and other[1] > one[1]):
                raise ValueError(f"table: point {k} does not rise in angle and position; expected both to")

    @cached_property
    def columns(self) -> Array:
        """Angle, position and slope dy/dφ of each point."""
        angle, y = np.array(self.points).T
        return np.vstack([angle, y, _slopes(angle, y)])

    @property
    def reach(self) -> Reach:
        """From the first to the last point."""
        return Reach(self.points[0][1], self.points[-1][1], "begin of the table", "end of the table")

    @property
    def knots(self) -> tuple[float, ...]:
        """Positions of the points but the first and the last."""
        return tuple(y for _, y in self.points[1:-1])

    def part(self, y: Array) -> Array:
        """Return the number, from 0, of the part between two points in which positions lie, on a point of the next."""
        position = self.columns[1]
        return np.clip(np.searchsorted(position, y, side="right") - 1, 0, position.size - 2)

    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        angle, position, slope = self.columns
        k = self.part(within)
        width, rise = angle[k + 1] - angle[k], position[k + 1] - position[k]
        begin, end = slope[k] * width / rise, slope[k + 1] * width / rise
        share = _inverse(begin, end, (y - position[k]) / rise)
        c2, c3 = 3.0 - 2.0 * begin - end, begin + end - 2.0
        first = (begin + share * (2.0 * c2 + 3.0 * share * c3)) * rise / width
        second = (2.0 * c2 + 6.0 * share * c3) * rise / width**2
        return ShaftAngles(angle[k] + share * width, 1.0 / first, -second / first**3)


def _slopes(angle: Array, y: Array) -> Array:
    width, chord = np.diff(angle), np.diff(y) / np.diff(angle)
    inner = (width[1:] * chord[:-1] + width[:-1] * chord[1:]) / (width[1:] + width[:-1])
    slope = np.concatenate([chord[:1], inner, chord[-1:]])
    for k, one in enumerate(chord):
        radius = np.hypot(slope[k], slope[k + 1]) / one
        if radius > 3.0:
            slope[k : k + 2] *= 3.0 / radius
    return np.asarray(slope)


def _inverse(begin: Array, end: Array, height: Array) -> Array:
    """Return t in [0, 1] with t (b + t (3 − 2b − e + t (b + e − 2))) = height, for cubics that rise."""
    low, high = np.zeros_like(height), np.ones_like(height)
    t = np.clip(height, 0.0, 1.0)
    c2, c3 = 3.0 - 2.0 * begin - end, begin + end - 2.0
    for _ in range(STEPS):
        value = t * (begin + t * (c2 + t * c3)) - height
        low, high = np.where(value > 0.0, low, t), np.where(value > 0.0, t, high)
        rate = begin + t * (2.0 * c2 + 3.0 * t * c3)
        newton = t - np.divide(value, rate, out=np.full_like(t, np.inf), where=rate > 0.0)
        following = np.where((newton >= low) & (newton <= high), newton, 0.5 * (low + high))
        moved, t = float(np.abs(following - t).max(initial=0.0)), following
        if moved <= LAST_DIGITS:
            break
    return np.asarray(t)
