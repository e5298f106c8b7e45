"""Points joined by a cubic spline (SPL): the law, and its solution row by row, as a table of cells has it."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from engine.laws.base import Array, require_finite
from engine.laws.ends import AT_REST, BoundaryLaw, Slopes
from engine.laws.family import Vendors
from engine.laws.inverse import velocity_peak
from engine.laws.piece import Piece

MOST = 100  # points
NARROWEST = 1e-6  # least step of ξ between two points
Point = tuple[float, float]
EXAMPLE: tuple[Point, ...] = ((0.0, 0.0), (0.25, 0.15), (0.5, 0.5), (0.75, 0.85), (1.0, 1.0))


@dataclass(frozen=True)
class Spline(BoundaryLaw):
    """The cubic spline through points: v and a are continuous, a is linear between two points."""

    code = "SPL"
    number = 20
    name = "Cubic spline"
    aliases = ("points", "spline")
    source = "the cubic spline in moments; TwinCAT, MC_MotionFunctionType, CubicSpline"
    vendors = Vendors(twincat="CubicSpline (MC3: 11)")

    # 2 to 100 (ξ, s), of rising ξ, from (0, 0) to (1, 1), else ValueError
    points: tuple[Point, ...] = EXAMPLE
    # entered velocities at the ends; None: the neighbouring phase's, 0 next to a dwell
    slopes: Slopes = AT_REST
    natural: tuple[bool, bool] = (False, False)  # whether each end is natural: a = 0, and v follows

    def __post_init__(self) -> None:
        points = tuple((float(xi), float(s)) for xi, s in self.points)
        _require(points)
        for name, slope in zip(("first", "last"), self.slopes, strict=True):
            if slope is not None:
                require_finite(**{f"the {name} slope": slope})
        object.__setattr__(self, "points", points)

    @property
    def fixes_ends(self) -> bool:
        """Whether both ends have an entered slope or are natural."""
        return all(free or slope is not None for free, slope in zip(self.natural, self.slopes, strict=True))

    @cached_property
    def moments(self) -> Array:
        """Acceleration at each point."""
        below, diagonal, above, right = self.system
        return np.asarray(np.linalg.solve(np.diag(below, -1) + np.diag(diagonal) + np.diag(above, 1), right))

    @cached_property
    def system(self) -> tuple[Array, Array, Array, Array]:
        """The tridiagonal equations of the accelerations at the points: lower, main and upper diagonal, right side.

        With the steps d_k = ξ_{k+1} − ξ_k and the slopes m_k between the points, d_{k−1} a_{k−1} + 2(d_{k−1} + d_k) a_k
        + d_k a_{k+1} = 6(m_k − m_{k−1}), and at an end with the slope v, 2 d_0 a_0 + d_0 a_1 = 6(m_0 − v).
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
        """ξ of the points, and their s times the stroke."""
        xi, s = np.array(self.points).T
        return xi, s * self.ends.stroke

    @cached_property
    def table(self) -> Array:
        """ξ, s, v, a and j at the begin of each interval: shape (5, n − 1) for n points."""
        (xi, s), a = self.knots, self.moments
        d = np.diff(xi)
        v = np.diff(s) / d - d * (2.0 * a[:-1] + a[1:]) / 6.0
        return np.array([xi[:-1], s[:-1], v, a[:-1], np.diff(a) / d])

    @property
    def entry_velocity(self) -> float:
        """Velocity at the first point."""
        return float(self.table[2, 0])

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return a cubic for each interval."""
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


def _eliminate_forward(below: Array, diagonal: Array, above: Array, right: Array) -> tuple[list[float], ...]:
    """Return multipliers, pivots and right sides of a diagonally dominant tridiagonal system, eliminated forward."""
    d, x, shares = diagonal.tolist(), right.tolist(), [0.0]
    for k, (low, high) in enumerate(zip(below.tolist(), above.tolist(), strict=True)):
        share = low / d[k]
        d[k + 1] -= share * high
        x[k + 1] -= share * x[k]
        shares.append(share)
    return shares, d, x


STILL = 1e-9  # share of the largest velocity below which a velocity counts as 0
EQUAL = 1e-12  # share of the largest velocity by which equal peaks may differ
SAME = 1e-9  # difference of ξ below which two places are the same


def _rising_zeros(v: Array, v1: Array, a: Array, j: Array, low: Array, high: Array, still: float) -> Array:
    """Return u at which v rises through 0 on each interval, from below −``still`` to above ``still``; else 0."""
    rises = ((v < -still) & (high > still)) | ((v1 > still) & (low < -still))
    root = np.sqrt(np.maximum(0.0, a**2 - 2.0 * j * v))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(rises, np.where(a < 0.0, (root - a) / j, -2.0 * v / (root + a)), 0.0)


@dataclass(frozen=True)
class SplineTable:
    """A spline as a table of cells has it: a row for each point, then spare rows; with its extremes by interval.

    On an interval a is linear and W = a² − 2 j v constant. So v is extreme where a = 0, v = 0 where a = ±√W, and v·a is
    stationary where a = ±√(W/3), with the value −W a/(3j).
    """

    law: Spline
    rows: int  # of the table, spare ones included

    @property
    def used(self) -> int:
        """Number of points."""
        return len(self.law.points)

    @property
    def slopes(self) -> tuple[float, float]:
        """The entered slopes, 0 if none is entered."""
        first, last = self.law.slopes
        return first or 0.0, last or 0.0

    def filled(self, values: Sequence[Any] | Array, spare: Any) -> list[Any]:
        """Return a column of the table, with ``spare`` in the spare rows."""
        column = np.asarray(values).tolist()
        return [*column, *[spare] * (self.rows - len(column))]

    @cached_property
    def solved(self) -> dict[str, list[Any]]:
        """Columns of the elimination, a value for each point: forward from the first, ``back`` from the last."""
        below, _, above, right = self.law.system
        shares, pivots, rights = _eliminate_forward(*self.law.system)
        xi, s = self.law.knots
        d, (begin, end) = np.diff(xi), self.law.natural
        return {
            "d": self.filled(d, 0.0),
            "m": self.filled(np.diff(s) / d, self.slopes[1]),
            "before": self.filled([0.0, *d], 0.0),
            "held": self.filled([int(begin), *[0] * (self.used - 2), int(end)], 1),
            "low": self.filled([0.0, *below], 0.0),
            "high": self.filled(above, 0.0),
            "rhs": self.filled(right, 0.0),
            "share": self.filled(shares, 0.0),
            "pivot": self.filled(pivots, 1.0),
            "right": self.filled(rights, 0.0),
            "back": self.filled(self.law.moments[::-1], 0.0),
        }

    @cached_property
    def intervals(self) -> dict[str, Array]:
        """Columns of the interval that begins in each row; from the last point on intervals without duration."""
        (xi, s), moments, end = self.law.knots, self.law.moments, self.law.end
        rates = self.law.table
        velocities = [*rates[2], end.v]
        begun = {
            "xi": (xi[:-1], 1.0),
            "d": (np.diff(xi), 0.0),
            "y": (s[:-1], end.s),
            "y1": (s[1:], end.s),
            "v": (velocities[:-1], end.v),
            "v1": (velocities[1:], end.v),
            "a": (moments[:-1], moments[-1]),
            "a1": (moments[1:], moments[-1]),
            "j": (rates[4], 0.0),
        }
        columns = {name: np.array(self.filled(values, spare)) for name, (values, spare) in begun.items()}
        d, y, y1, v, v1, a, a1, j = (columns[name] for name in ("d", "y", "y1", "v", "v1", "a", "a1", "j"))
        w = a**2 - 2.0 * j * v
        third = np.sqrt(np.maximum(0.0, w) / 3.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            crest = np.where(a * a1 < 0.0, v + a**2 * d / (2.0 * (a - a1)), v)
            plus, minus = (
                np.where((j != 0.0) & ((a - at) * (a1 - at) < 0.0), -w * at / (3.0 * j), v * a)
                for at in (third, -third)
            )
        low, high = np.min([v, v1, crest], axis=0), np.max([v, v1, crest], axis=0)
        rises = _rising_zeros(v, v1, a, j, low, high, self.still)
        falls = _rising_zeros(-v, -v1, -a, -j, -high, -low, self.still)
        turns = [y + u * (4.0 * v + a * u) / 6.0 for u in (rises, falls)]
        powers = [v * a, v1 * a1, plus, minus]
        return columns | {
            "w": w,
            "v_low": low,
            "v_high": high,
            "third": third,
            "va_plus": plus,
            "va_minus": minus,
            "va_low": np.min(powers, axis=0),
            "va_high": np.max(powers, axis=0),
            "rises": rises,
            "falls": falls,
            "s_low": np.min([y, y1, turns[0]], axis=0),
            "s_high": np.max([y, y1, turns[1]], axis=0),
            "square": d * (a**2 + a * a1 + a1**2) / 3.0,
        }

    @property
    def still(self) -> float:
        """Velocity below which the law counts as at rest."""
        return STILL * self.law.coefficients.cv

    @property
    def fastest_xi(self) -> Array:
        """The first ξ of each interval at which v reaches its peak over the law; 1 of an interval without the peak."""
        xi, d, v, a, a1, high = (self.intervals[name] for name in ("xi", "d", "v", "a", "a1", "v_high"))
        top = high.max() - EQUAL * abs(high.max())
        over = np.where((a > 0.0) & (a1 < 0.0), a - a1, 1.0)
        place = np.where((a > 0.0) & (a1 < 0.0), xi + d * a / over, xi + d)
        return np.where((d == 0.0) | (high < top), 1.0, np.where(v >= top, xi, place))

    @cached_property
    def peak(self) -> float:
        """The first ξ at which v is largest."""
        return velocity_peak(self.law)

    @property
    def wrong_way(self) -> Array:
        """Decrease of v before its peak, or increase after it, within each interval; else 0."""
        xi, d, v, v1, low, high = (self.intervals[name] for name in ("xi", "d", "v", "v1", "v_low", "v_high"))
        falls, rises = np.maximum(v - low, high - v1), np.maximum(high - v, v1 - low)
        step = np.where(xi + d <= self.peak + SAME, falls, np.where(xi >= self.peak - SAME, rises, 0.0))
        return np.where(d > 0.0, np.maximum(0.0, step), 0.0)
