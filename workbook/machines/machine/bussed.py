"""The engine's view of drives on a common DC bus: their power at places of the turn, joined by straight lines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np

from engine.laws.base import Array
from engine.machine.bent import middle, turned
from engine.machine.powering import Powering
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, si
from workbook.machines.machine.chain import PowerEntry
from workbook.machines.machine.linked.worked import LinkedWork
from workbook.machines.machine.stretched import STEP, Stretched

FULL, MORE = 3, 12
"""drives of which all stretches have room, and stretches of each further one"""


class Bus:
    """Drives of constant ratios over one turn, those that run at the machine's rate together on a bus."""

    def __init__(self, drives: Sequence[Stretched], entered: PowerEntry) -> None:
        self.all_drives = drives
        self.drives = [one for one in drives if not isinstance(one, LinkedWork)]
        self.efficiency, self.hours = entered.efficiency, entered.hours
        self.near = drives[0].near

    @property
    def shared(self) -> list[Stretched]:
        """The drives that share the bus: one at a rate of its own has no place in the turn."""
        return [one for one in self.drives if one.driven.entered.rate is None]

    @property
    def breaks(self) -> list[tuple[float, float, float]]:
        """Where each stretch begins, and by how much the power jumps there: of each drive alone, and on the bus."""
        found = []
        for one in self.drives:
            each = [self.jump(one, k) if one in self.shared else (0.0, 0.0, 0.0) for k in range(len(one.powers))]
            found += filled(each, one.rows, (each[-1][0], 0.0, 0.0))
        return found

    def jump(self, one: Stretched, k: int) -> tuple[float, float, float]:
        """Return the same of a stretch."""
        late = one.driven.axis.given.shift
        low, high = one.spans[k]
        begin = max(0.0, turned(middle((low, high)), late, TURN) - 0.5 * (high - low))
        before, after = one.powers[k - 1].ends[1], one.powers[k].ends[0]
        alone = max(0.0, after) / self.efficiency - max(0.0, before) / self.efficiency
        return begin, alone, self.drawn(after) - self.drawn(before)

    def drawn(self, power: float) -> float:
        """Return what a drive draws for a power at its shaft (W); below 0 what it gives back."""
        return power / self.efficiency if power > 0.0 else power * self.efficiency

    @property
    def room(self) -> int:
        """Rows of the table: for the grid, and for places where power may jump."""
        rows = [one.rows for one in self.drives]
        return round(TURN / STEP) + sum(rows[:FULL]) + MORE * len(rows[FULL:])

    @cached_property
    def spans(self) -> list[tuple[float, float]]:
        """What lies between grid and breaks, in degrees of the master shaft, as far as there is room."""
        cuts = sorted({TURN, *(STEP * n for n in range(round(TURN / STEP))), *(one[0] for one in self.breaks)})
        kept = [0.0]
        for cut in cuts:
            if cut > kept[-1] + self.near and kept[-1] < TURN - self.near:
                kept.append(cut)
        return list(pairwise(kept))[: self.room]

    @property
    def enough(self) -> bool:
        """Whether there is."""
        return self.spans[-1][1] >= TURN - self.near

    def within(self, one: Stretched, span: tuple[float, float]) -> tuple[float, float]:
        """Return the power of a drive at begin and end of a span (W)."""
        if one not in self.shared:
            return 0.0, 0.0
        at = turned(middle(span), -one.driven.axis.given.shift, TURN)
        begins = [low for low, _ in one.spans]
        found: Powering = one.powers[int(np.searchsorted(begins, at, side="right")) - 1]
        half = 0.5 * si(span[1] - span[0], DEGREE)
        u = si(at, DEGREE) - found.part.piece.begin
        return found.power(u - half), found.power(u + half)

    @cached_property
    def power(self) -> Array:
        """Power of each drive (W) at begin and end of each span: drives, spans, ends."""
        return np.array([[self.within(one, span) for span in self.spans] for one in self.drives])

    @cached_property
    def alone(self) -> Array:
        """What all drives take from the mains without a common bus (W) at both ends of each span."""
        return np.asarray(np.maximum(self.power, 0.0).sum(axis=0) / self.efficiency)

    @cached_property
    def common(self) -> Array:
        """What they draw together (W), below 0 what goes into the resistor, at both ends of each span."""
        return np.asarray(self.alone - np.maximum(-self.power, 0.0).sum(axis=0) * self.efficiency)

    @property
    def areas(self) -> list[float]:
        """What straight lines have above 0 in each span (W°)."""
        return [area(high - low, a, b) for (low, high), (a, b) in zip(self.spans, self.common.tolist(), strict=True)]

    @property
    def mean(self) -> float:
        """Mean of what they draw together, above 0 (W)."""
        return math.fsum(self.areas) / TURN

    @property
    def net(self) -> float:
        """Mean of what they draw together (W)."""
        each = zip(self.spans, self.common.tolist(), strict=True)
        return math.fsum((high - low) * (a + b) / 2.0 for (low, high), (a, b) in each) / TURN

    @property
    def size(self) -> float:
        """The largest power of all together (W)."""
        return max(1e-3, float(np.abs(self.power).sum(axis=0).max()))

    def off(self, one: Stretched) -> float:
        """Return by how much the straight lines of a drive are off at most (W)."""
        return one.most_off if one in self.shared else 0.0

    def rowed(self, values: Sequence[float]) -> list[float]:
        """Return values of spans; spare rows repeat the last."""
        return filled(values, self.room, values[-1])


def area(width: float, a: float, b: float) -> float:
    """Return what a straight line between two values has above 0."""
    if min(a, b) >= 0.0:
        return width * (a + b) / 2.0
    return width * max(a, b) ** 2 / (2.0 * abs(a - b)) if max(a, b) > 0.0 else 0.0
