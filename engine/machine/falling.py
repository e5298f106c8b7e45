"""A motor's peak torque that falls beyond a speed, held against a drive's stretches at any rate. SI units.

Beyond a knee n_1 the peak torque falls in a straight line: |T| <= T_max − f (n − n_1). That is |T| + f n against the
line at no speed, T_max + f n_1. It is how a table of cells finds the reserve below a curve: from the places of a grid,
and what can be more between them. :class:`engine.machine.limits.Judged` finds it another way.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.machine.bent import BentPart
from engine.machine.course import Course, Stretch
from engine.machine.powering import Powering
from engine.machine.rows import Rows, rows_of
from engine.machine.searching import Function, largest

PARTS = 300
"""of a stretch: places of the grid, both ends with them"""
SHARES = np.arange(PARTS) / (PARTS - 1)
CLEAR = 1e-6
"""of the line at no speed: how far below it the highest rate keeps the torque"""


class Falling(NamedTuple):
    """The speed beyond which a peak torque falls (rad/s), and by how much (Nm s): 0 where it does not."""

    knee: float = 0.0
    fall: float = 0.0

    @classmethod
    def between(cls, knee: float, peak_torque: float, fastest: float, end_torque: float) -> Falling:
        """Return how a peak torque (Nm) falls from a knee to another torque at the largest speed (rad/s).

        Not at all where the second is not smaller, or the knee not below that speed.
        """
        return cls(knee, max(0.0, peak_torque - end_torque) / (fastest - knee)) if knee < fastest else cls()

    def corner(self, peak_torque: float) -> float:
        """Return the line at no speed (Nm); no limit where it does not fall."""
        return peak_torque + self.fall * self.knee if self.fall else math.inf

    def lowest(self, peak_torque: float) -> float:
        """Return what the highest rate holds the line to be at no speed (Nm), a little below what it is."""
        return self.corner(peak_torque) * (1.0 - CLEAR)


@dataclass(frozen=True)
class Against:
    """The stretches of a drive against a peak torque that falls."""

    parts: Sequence[BentPart]
    falling: Falling

    @property
    def sink(self) -> float:
        """By how much the curve falls where y' is 1 at the present rate (Nm)."""
        first = self.parts[0]
        return self.falling.fall * first.bends.drive.mechanism.ratio * first.speed

    def _column(self, figures: Sequence[float]) -> Array:
        return np.array(figures, dtype=np.float64)[:, None]

    @cached_property
    def _rows(self) -> Rows:
        return rows_of([part.piece for part in self.parts]).over(2)

    @cached_property
    def _places(self) -> Array:
        low, high = (self._column([part.sides[k] for part in self.parts]) for k in (0, 1))
        return np.asarray(low + (high - low) * SHARES)

    @cached_property
    def _acceleration(self) -> Array:
        return np.asarray(self._column([part.factor for part in self.parts]) * self._rows.at(self._places, 2))

    @cached_property
    def _velocity(self) -> Array:
        return np.asarray(self._column([part.going for part in self.parts]) * self._rows.at(self._places, 1))

    @cached_property
    def _between(self) -> tuple[Array, Array, Array]:
        """What |T''|, |y'''| and the jumps of T' over u stay below, times what a place between two may be off by."""
        powers = [Powering(part, 0.0) for part in self.parts]
        sharp, snap = (np.array([getattr(one, name) for one in powers]) for name in ("sharpest", "snap"))
        steps = np.array([part.bends.steps for part in self.parts])
        slopes = np.cumsum(np.column_stack([[part.falling for part in self.parts], steps]), axis=1)
        width = np.array([part.high - part.low for part in self.parts]) / (PARTS - 1)
        factor = np.abs([part.factor for part in self.parts])
        bend, jump = np.abs(slopes).max(axis=1) * factor * snap, factor * sharp * np.abs(steps).sum(axis=1)
        return bend * width**2 / 8.0, sharp * width**2 / 8.0, jump * width / 4.0

    def asked(self, x: float) -> Array:
        """Return what the line must be at no speed for each stretch (Nm), or a little more; 0 where none falls.

        x is the square of a rate over the present one. The largest |T| + f n of the places, and by how much it can be
        more between two: δ²/8 times the largest second derivative, and δ/4 times a jump of its slope. Source:
        P. J. Davis, Interpolation and Approximation, 3.1, the remainder of linear interpolation.
        """
        if not self.falling.fall:
            return np.zeros(len(self.parts))
        y = x * self._acceleration
        torque = self._column([part.bends.level for part in self.parts])
        torque = torque + self._column([part.falling for part in self.parts]) * y
        for k in (0, 1):
            level = self._column([part.levels[k + 1] for part in self.parts])
            torque = torque + self._column([part.bends.steps[k] for part in self.parts]) * np.maximum(0.0, y - level)
        sink = self.sink * math.sqrt(x)
        bend, sharp, jump = self._between
        found = (np.abs(torque) + sink * self._velocity).max(axis=1) + x * (bend + jump) + sink * sharp
        held = np.abs([part.held for part in self.parts])
        return np.where([part.going != 0.0 for part in self.parts], found, held)

    def most(self, x: float) -> float:
        """Return the same of the whole cycle."""
        return float(self.asked(x).max())


def line_asked(course: Course, falling: Falling) -> float:
    """Return what the line of a falling curve must be at no speed (Nm), by a search: the largest |T| + f n."""

    def line(one: Stretch) -> Function:
        return lambda u: np.abs(one.torque(u)) + falling.fall * np.abs(one.motor_speed(u))

    most = -math.inf
    for one in course.stretches:
        most = max(most, largest(line(one), one.low, one.high, one.nodes, most).value)
    return most
