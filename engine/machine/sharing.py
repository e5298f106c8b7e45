"""Drives on a common DC bus: their power at places of the turn, joined by straight lines. SI units.

It is how a table of cells sums them; :mod:`engine.machine.bus` has the exact sum.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, Protocol

import numpy as np

from engine.laws.base import Array
from engine.machine.bent import middle, turned


class Jump(NamedTuple):
    """Where a stretch begins, and by how much power jumps there (W): from the mains alone, and on the bus."""

    at: float
    alone: float
    common: float


class Power(Protocol):
    """The power of a drive over one stretch of its motion."""

    @property
    def ends(self) -> tuple[float, float]:
        """The power at begin and end: the limits from inside (W)."""

    def over(self, middle: float, half: float) -> tuple[float, float]:
        """Return the power (W) at both ends of a part, by the middle of that in the motion and half its width (rad)."""


@dataclass(frozen=True)
class Running:
    """The power of a drive over its stretches, where these are in its motion as it is told, and how late that is."""

    powers: Sequence[Power]
    spans: Sequence[tuple[float, float]]
    late: float

    def stretch(self, at: float) -> int:
        """Return the number of the stretch, from 0, in which a place of the motion lies."""
        return int(np.searchsorted([low for low, _ in self.spans], at, side="right")) - 1


@dataclass(frozen=True)
class Sharing:
    """Drives over a ``turn`` in units of its own: places are no farther apart than ``step``, and at every jump.

    Places nearer than ``near`` are one; there are no more than ``room`` lines.
    """

    drives: tuple[Running, ...]
    efficiency: float
    turn: float
    step: float
    near: float
    room: int

    def drawn(self, power: float) -> float:
        """Return what a drive draws for a power at its shaft (W); below 0 what it gives back."""
        return power / self.efficiency if power > 0.0 else power * self.efficiency

    def jumps(self, one: Running) -> list[Jump]:
        """Return the begin of each stretch of a drive."""
        found = []
        for k, (low, high) in enumerate(one.spans):
            begin = max(0.0, turned(middle((low, high)), one.late, self.turn) - 0.5 * (high - low))
            before, after = self.drawn(one.powers[k - 1].ends[1]), self.drawn(one.powers[k].ends[0])
            found.append(Jump(begin, max(0.0, after) - max(0.0, before), after - before))
        return found

    @property
    def steps(self) -> int:
        """Places of the grid."""
        return round(self.turn / self.step)

    @cached_property
    def spans(self) -> list[tuple[float, float]]:
        """What lies between places, as far as there is room."""
        grid = [self.step * n for n in range(self.steps)]
        cuts = sorted({self.turn, *grid, *(jump.at for one in self.drives for jump in self.jumps(one))})
        kept = [0.0]
        for cut in cuts:
            if cut > kept[-1] + self.near and kept[-1] < self.turn - self.near:
                kept.append(cut)
        return list(pairwise(kept))[: self.room]

    @property
    def enough(self) -> bool:
        """Whether there is."""
        return self.spans[-1][1] >= self.turn - self.near

    def within(self, one: Running, span: tuple[float, float]) -> tuple[float, float]:
        """Return the power of a drive at begin and end of a line (W)."""
        at, unit = turned(middle(span), -one.late, self.turn), 2.0 * math.pi / self.turn
        found = one.powers[one.stretch(at)]
        return found.over(at * unit, 0.5 * (span[1] - span[0]) * unit)

    def begins(self, one: Running) -> list[tuple[int, float]]:
        """Return the stretch of a drive, from 0, in which each line begins, and where in its motion that is (rad).

        The drive may be one that is not among these.
        """
        found, unit = [], 2.0 * math.pi / self.turn
        for low, _ in self.spans:
            at = turned(low + self.near, -one.late, self.turn)
            found.append((one.stretch(at), (at - self.near) * unit))
        return found

    @cached_property
    def power(self) -> Array:
        """Power of each drive (W) at begin and end of each line: drives, lines, ends."""
        found = [[self.within(one, span) for span in self.spans] for one in self.drives]
        return np.array(found).reshape(len(self.drives), len(self.spans), 2)

    @cached_property
    def alone(self) -> Array:
        """What the drives take from the mains without a common bus (W), at both ends of each line."""
        return self._whole(np.maximum(self.power, 0.0).sum(axis=0) / self.efficiency)

    @cached_property
    def common(self) -> Array:
        """What they draw together (W), below 0 what goes into the resistor, at both ends of each line."""
        drawn = np.where(self.power > 0.0, self.power / self.efficiency, self.power * self.efficiency)
        return self._whole(drawn.sum(axis=0))

    def _whole(self, values: Array) -> Array:
        """Return values; where there is no room for all, the last line is level."""
        found = np.array(values)
        if not self.enough:
            found[-1, 1] = found[-1, 0]
        return found

    @property
    def areas(self) -> list[float]:
        """What straight lines have above 0."""
        return [above(high - low, a, b) for (low, high), (a, b) in zip(self.spans, self.common.tolist(), strict=True)]

    @property
    def mean(self) -> float:
        """Mean of what they draw together, above 0 (W)."""
        return math.fsum(self.areas) / self.turn

    @property
    def net(self) -> float:
        """Mean of what they draw together (W)."""
        widths = np.array([high - low for low, high in self.spans])
        return float(widths @ self.common.sum(axis=1)) / (2.0 * self.turn)

    @property
    def size(self) -> float:
        """The largest power of all together (W)."""
        return float(np.abs(self.power).sum(axis=0).max())


def above(width: float, a: float, b: float) -> float:
    """Return what a straight line between two values has above 0."""
    if min(a, b) >= 0.0:
        return width * (a + b) / 2.0
    return width * max(a, b) ** 2 / (2.0 * abs(a - b)) if max(a, b) > 0.0 else 0.0


def room_for(rows: Sequence[int], turn: float, step: float, full: int, more: int) -> int:
    """Return the room for lines: of the grid, of all stretches of the first ``full`` drives, of a few of the others."""
    return round(turn / step) + sum(rows[:full]) + more * len(rows[full:])
