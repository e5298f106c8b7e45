"""Points joined by a cubic spline (SPL)."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from engine.laws.base import Array, require_finite
from engine.laws.ends import REST, EndedLaw, Ends
from engine.laws.family import Vendors
from engine.laws.piece import Piece

MOST = 100
NARROWEST = 1e-6  # of the time, between two points

Point = tuple[float, float]
Slopes = tuple[float | None, float | None]
EXAMPLE: tuple[Point, ...] = ((0.0, 0.0), (0.25, 0.15), (0.5, 0.5), (0.75, 0.85), (1.0, 1.0))


@dataclass(frozen=True)
class Spline(EndedLaw):
    """The cubic spline through points (ξ, s): v and a are continuous, a is linear between two points.

    ``points`` are 2 to 100, of rising ξ, the first (0, 0) and the last (1, 1). ``slopes`` are the velocities at
    begin and end where they are entered; what is None follows from the neighbouring phase, 0 beside a dwell.
    ``natural`` says which ends are free, with a = 0 there instead of a prescribed velocity. Else ValueError.
    Source: the cubic spline with clamped or natural ends, in moments; TwinCAT, MC_MotionFunctionType, CubicSpline.
    """

    code = "SPL"
    name = "Cubic spline"
    aliases = ("points", "spline")
    source = "the cubic spline in moments; TwinCAT, MC_MotionFunctionType, CubicSpline"
    vendors = Vendors(twincat="CubicSpline (MC3: 11)")

    points: tuple[Point, ...] = EXAMPLE
    slopes: Slopes = (None, None)
    natural: tuple[bool, bool] = (False, False)
    ends: Ends = REST

    def __post_init__(self) -> None:
        points = tuple((float(xi), float(s)) for xi, s in self.points)
        _require(points)
        for name, slope in zip(("first", "last"), self.slopes, strict=True):
            if slope is not None:
                require_finite(**{f"the {name} slope": slope})
        object.__setattr__(self, "points", points)

    def opened(self, begin: bool, end: bool) -> "Spline":
        """Return the spline with natural ends where nothing precedes or follows it, and no slope is entered."""
        free = [self.natural[k] or (open_ and self.slopes[k] is None) for k, open_ in enumerate((begin, end))]
        return replace(self, natural=(free[0], free[1]))

    @property
    def fixes_ends(self) -> bool:
        """Whether both ends are settled by itself: by an entered slope, or as natural ones."""
        return all(free or slope is not None for free, slope in zip(self.natural, self.slopes, strict=True))

    @cached_property
    def moments(self) -> Array:
        """Acceleration a at each point."""
        return tridiagonal(*self.system)

    @cached_property
    def system(self) -> tuple[Array, Array, Array, Array]:
        """The equations of the moments: below, on and above the diagonal, and their right sides.

        With the steps d_k = ξ_{k+1} − ξ_k and the slopes m_k between the points,
        d_{k−1} a_{k−1} + 2(d_{k−1} + d_k) a_k + d_k a_{k+1} = 6(m_k − m_{k−1}),
        and at an end with the slope v, 2 d_0 a_0 + d_0 a_1 = 6(m_0 − v).
        """
        xi, s = self.knots
        d = np.diff(xi)
        m = np.concatenate([[self._slope(0)], np.diff(s) / d, [self._slope(1)]])
        d = np.concatenate([[0.0], d, [0.0]])
        diagonal, right = 2.0 * (d[:-1] + d[1:]), 6.0 * np.diff(m)
        below, above = d[1:-1].copy(), d[1:-1].copy()
        for end, free in zip((0, -1), self.natural, strict=True):
            if free:
                diagonal[end], right[end] = 1.0, 0.0
                (above if end == 0 else below)[end] = 0.0
        return below, diagonal, above, right

    def _slope(self, end: int) -> float:
        entered = self.slopes[end]
        return (self.ends.v0, self.ends.v1)[end] if entered is None else entered * self.ends.stroke

    @cached_property
    def knots(self) -> tuple[Array, Array]:
        """ξ and s of the points, with the stroke."""
        xi, s = np.array(self.points).T
        return xi, s * self.ends.stroke

    @cached_property
    def table(self) -> Array:
        """ξ, s, v, a and j at the begin of each interval, in columns."""
        (xi, s), a = self.knots, self.moments
        d = np.diff(xi)
        v = np.diff(s) / d - d * (2.0 * a[:-1] + a[1:]) / 6.0
        return np.array([xi[:-1], s[:-1], v, a[:-1], np.diff(a) / d])

    @property
    def entry(self) -> float:
        """The velocity at the first point."""
        return float(self.table[2, 0])

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one cubic an interval."""
        d = np.diff(self.knots[0])
        return tuple(
            Piece(float(t), (float(a), float(j), 0.0, 0.0)) for t, a, j in zip(d, *self.table[3:], strict=True)
        )


def _require(points: Sequence[Point]) -> None:
    if not 2 <= len(points) <= MOST:
        raise ValueError(f"{len(points)} points are given; expected 2 to {MOST}")
    for k, (xi, s) in enumerate(points, 1):
        if not (math.isfinite(xi) and math.isfinite(s)):
            raise ValueError(f"point {k} is ({xi}, {s}); expected finite numbers")
    if points[0] != (0.0, 0.0) or points[-1] != (1.0, 1.0):
        raise ValueError(f"the points lead from {points[0]} to {points[-1]}; expected from (0, 0) to (1, 1)")
    for k, ((before, _), (after, _)) in enumerate(itertools.pairwise(points), 2):
        if not after - before >= NARROWEST:
            raise ValueError(f"point {k} is at {after:g}, the one before at {before:g}; expected them to rise")


def eliminated(below: Array, diagonal: Array, above: Array, right: Array) -> tuple[list[float], ...]:
    """Return what forward elimination leaves of a tridiagonal system: shares of the row before, pivots, right sides.

    The diagonal dominates; ``below`` and ``above`` have one number less than the others.
    """
    d, x, shares = diagonal.tolist(), right.tolist(), [0.0]
    for k, (low, high) in enumerate(zip(below.tolist(), above.tolist(), strict=True)):
        share = low / d[k]
        d[k + 1] -= share * high
        x[k + 1] -= share * x[k]
        shares.append(share)
    return shares, d, x


def tridiagonal(below: Array, diagonal: Array, above: Array, right: Array) -> Array:
    """Return x of a tridiagonal system: forward elimination, then back substitution."""
    _, d, x = eliminated(below, diagonal, above, right)
    x[-1] /= d[-1]
    for k in range(len(d) - 2, -1, -1):
        x[k] = (x[k] - float(above[k]) * x[k + 1]) / d[k]
    return np.array(x)


WAVE = ((0.0, 0.0), (0.1, 0.4), (0.3, -0.2), (0.32, -0.2), (0.8, 1.3), (0.97, 0.9), (1.0, 1.0))
