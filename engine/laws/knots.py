"""A spline worked out row by row, a row a point, as a table of cells has it; its extremes interval by interval.

On an interval a is linear and W = a² − 2 j v the same everywhere: so v turns where a = 0, v = 0 where a = ±√W, and
v·a is stationary where a = ±√(W/3), and is ∓W a/(3j) there. The engine's own extremes are those of
:mod:`engine.laws.piece_extremes`.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.laws.inverse import velocity_peak
from engine.laws.spline import Spline, eliminated

STILL = 1e-9
"""of the largest velocity: one below this is none"""
EQUAL = 1e-12
"""of the largest velocity: peaks that differ by less are equal"""
SAME = 1e-9
"""of ξ: places no farther apart are one"""


def rising(v: Array, v1: Array, a: Array, j: Array, low: Array, high: Array, still: float) -> Array:
    """Return u at which v rises through 0 on each interval; 0 where it does not by more than ``still``."""
    rises = ((v < -still) & (high > still)) | ((v1 > still) & (low < -still))
    root = np.sqrt(np.maximum(0.0, a**2 - 2.0 * j * v))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(rises, np.where(a < 0.0, (root - a) / j, -2.0 * v / (root + a)), 0.0)


@dataclass(frozen=True)
class Knots:
    """A spline in a table of ``rows``, of which the first are its points."""

    law: Spline
    rows: int

    @property
    def used(self) -> int:
        """How many points it has."""
        return len(self.law.points)

    @property
    def slopes(self) -> tuple[float, float]:
        """The slopes entered, 0 where none is."""
        first, last = self.law.slopes
        return first or 0.0, last or 0.0

    def filled(self, values: Sequence[Any] | Array, spare: Any) -> list[Any]:
        """Return a column of the table, with ``spare`` in the rows that are left."""
        column = np.asarray(values).tolist()
        return [*column, *[spare] * (self.rows - len(column))]

    @cached_property
    def solved(self) -> dict[str, list[Any]]:
        """What is solved at each point, by column: forward from the first, ``back`` from the last."""
        below, _, above, right = self.law.system
        shares, pivots, rights = eliminated(*self.law.system)
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
        """The interval that begins in each row, by column; behind the last point one of no duration."""
        (xi, s), moments, end, rates = self.law.knots, self.law.moments, self.law.end, self.law.table
        velocities = [*rates[2], end.v]
        begun = {
            "xi": (xi[:-1], 1.0), "d": (np.diff(xi), 0.0), "y": (s[:-1], end.s), "y1": (s[1:], end.s),
            "v": (velocities[:-1], end.v), "v1": (velocities[1:], end.v), "a": (moments[:-1], moments[-1]),
            "a1": (moments[1:], moments[-1]), "j": (rates[4], 0.0),
        }  # fmt: skip
        found = {name: np.array(self.filled(values, spare)) for name, (values, spare) in begun.items()}
        d, y, y1, v, v1, a, a1, j = (found[name] for name in ("d", "y", "y1", "v", "v1", "a", "a1", "j"))
        w = a**2 - 2.0 * j * v
        third = np.sqrt(np.maximum(0.0, w) / 3.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            crest = np.where(a * a1 < 0.0, v + a**2 * d / (2.0 * (a - a1)), v)
            plus, minus = (
                np.where((j != 0.0) & ((a - at) * (a1 - at) < 0.0), -w * at / (3.0 * j), v * a)
                for at in (third, -third)
            )
        low, high = np.min([v, v1, crest], axis=0), np.max([v, v1, crest], axis=0)
        rises = rising(v, v1, a, j, low, high, self.still)
        falls = rising(-v, -v1, -a, -j, -high, -low, self.still)
        turns = [y + u * (4.0 * v + a * u) / 6.0 for u in (rises, falls)]
        powers = [v * a, v1 * a1, plus, minus]
        return found | {
            "w": w, "v_low": low, "v_high": high, "third": third, "va_plus": plus, "va_minus": minus,
            "va_low": np.min(powers, axis=0), "va_high": np.max(powers, axis=0), "rises": rises, "falls": falls,
            "s_low": np.min([y, y1, turns[0]], axis=0), "s_high": np.max([y, y1, turns[1]], axis=0),
            "square": d * (a**2 + a * a1 + a1**2) / 3.0,
        }  # fmt: skip

    @property
    def still(self) -> float:
        """A velocity below which there is none."""
        return STILL * self.law.coefficients.cv

    @property
    def fast(self) -> Array:
        """The first ξ of each interval at which v is the largest of all; 1 where it is nowhere."""
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
    def wrong(self) -> Array:
        """By how much v falls before its peak, or rises after it, at once, interval by interval."""
        xi, d, v, v1, low, high = (self.intervals[name] for name in ("xi", "d", "v", "v1", "v_low", "v_high"))
        falls, rises = np.maximum(v - low, high - v1), np.maximum(high - v, v1 - low)
        step = np.where(xi + d <= self.peak + SAME, falls, np.where(xi >= self.peak - SAME, rises, 0.0))
        return np.where(d > 0.0, np.maximum(0.0, step), 0.0)
