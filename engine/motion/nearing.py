"""Where two axes come near to each other, stretch by stretch, as a table of cells finds it.

A stretch is so short that the gap has one lowest place inside it at most: there its slope turns from falling to rising,
and the place is narrowed by counting points. :func:`engine.motion.shifted.least_gap` comes to the same by closed forms.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.laws.base import Array
from engine.laws.ladder import Curve
from engine.motion.shifted import Shifted, gap_curve
from engine.motion.turning import LOST, ROUNDS, narrowed

NODES = 72
"""parts of a cycle, beside the breaks of the motions, in which a gap has one lowest place at most"""


@dataclass(frozen=True)
class Nearing:
    """The gap of two axes over a stretch; ``steep`` and ``size`` are how large its slope and itself grow."""

    gap: Curve
    low: float
    high: float
    steep: float
    size: float

    @cached_property
    def slopes(self) -> tuple[float, float]:
        """Its slope at both ends."""
        slope = self.gap.derivative()
        return slope(0.0), slope(self.high - self.low)

    @property
    def turns(self) -> bool:
        """Whether it has a lowest place inside."""
        lost = LOST * self.steep
        return self.slopes[0] < -lost and self.slopes[1] > lost

    @cached_property
    def places(self) -> tuple[float, ...]:
        """That place from its begin, round by round; 0 without one."""
        if not self.turns:
            return (0.0,) * ROUNDS
        slope = self.gap.derivative()

        def values(u: Array) -> Array:
            return np.array([slope(one) for one in u.tolist()])

        return narrowed(values, 0.0, self.high - self.low, LOST * self.steep).places

    @cached_property
    def gaps(self) -> tuple[float, float, float]:
        """The gap at its begin, at its end and inside; where it has no lowest place inside, as at its begin."""
        return self.gap(0.0), self.gap(self.high - self.low), self.gap(self.places[-1])

    @property
    def least(self) -> float:
        """The least of them."""
        return min(self.gaps)

    @property
    def place(self) -> float:
        """Where that is; of two alike the begin."""
        begin, end, inner = self.gaps
        same = LOST * self.size
        if inner < min(begin, end) - same:
            return self.low + self.places[-1]
        return self.high if end < begin - same else self.low


def nearings(
    axes: Sequence[tuple[float, Shifted]], offset: float, spans: Sequence[tuple[float, float]]
) -> list[Nearing]:  # fmt: skip
    """Return the stretches of a gap ``offset`` + Σ factor · y between places where no piece of either begins."""
    steep = math.fsum(abs(f) * max(phase.y1_max for phase in one.motion.phases) for f, one in axes)
    size = gap_size(axes, offset)
    return [Nearing(gap_curve(axes, offset, low, high), low, high, steep, size) for low, high in spans]


def keeps(gap: float, least: float, size: float) -> bool:
    """Whether a gap leaves the least that is asked for, but for rounding of its size."""
    return gap >= least - LOST * size


def gap_size(axes: Sequence[tuple[float, Shifted]], offset: float) -> float:
    """Return how large a gap grows."""
    return abs(offset) + math.fsum(abs(f) * max(map(abs, one.motion.reach)) for f, one in axes)
