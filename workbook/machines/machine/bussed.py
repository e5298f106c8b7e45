"""The engine's view of drives on a common DC bus."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple, TypeVar

from engine.laws.base import Array
from engine.machine.bus import Means, Peaks, means, peaks, together
from engine.machine.sharing import Jump, Running, Sharing, room_for
from workbook.book.rows import filled
from workbook.entries.abscissa import Abscissa
from workbook.entries.turn import TURN
from workbook.machines.machine.chain import PowerEntry
from workbook.machines.machine.stretched import Stretched

FULL, MORE = 2, 12
"""drives of which all stretches have room, and stretches of each further one"""
NONE = Jump(0.0, 0.0, 0.0)
T = TypeVar("T")


class Begin(NamedTuple):
    """Formulas of where a stretch begins on the master shaft, whether it is one, and the power behind and before."""

    at: str
    on: str
    after: str
    before: str


class Bus:
    """Drives over one turn, those that run at the machine's rate together on a bus."""

    def __init__(self, drives: Sequence[Stretched], entered: PowerEntry) -> None:
        self.drives, self.entered = drives, entered

    @property
    def over(self) -> Abscissa:
        """What the cycle is shown over."""
        return self.drives[0].one.machine.over

    def shares(self, one: Stretched) -> bool:
        """Whether a drive is on the bus: one at a rate of its own has no place in the turn."""
        return one.driven.entered.rate is None

    def row(self, one: Stretched) -> int:
        """Return the row of a drive in the table of all drives, from 1."""
        return self.drives.index(one) + 1

    @cached_property
    def each(self) -> list[Means]:
        """What each drive takes and burns without a common bus."""
        driven = [one.driven for one in self.drives]
        return [means(one.demand.energy, one.demand.course.time, self.entered.efficiency) for one in driven]

    @cached_property
    def most(self) -> list[Peaks]:
        """The peak powers of each drive without a common bus."""
        power = [one.driven.demand.power for one in self.drives]
        return [peaks(one.highest.value, one.lowest.value, self.entered.efficiency) for one in power]

    def of(self, each: Sequence[T], *, shared: bool) -> list[T]:
        """Return what is known of the drives that are on the bus, or of those that are not."""
        return [known for known, one in zip(each, self.drives, strict=True) if self.shares(one) is shared]

    @cached_property
    def alone(self) -> Means:
        """What all drives take and burn, each alone."""
        return together(self.each)

    @cached_property
    def common(self) -> Means:
        """What those on the bus take and burn together."""
        return Means(self.lines.mean, self.lines.mean - self.lines.net)

    @cached_property
    def mains_peak(self) -> float:
        """The largest power from the mains of those on the bus (W)."""
        return max(0.0, float(self.lines.common.max()))

    @cached_property
    def running(self) -> list[Running]:
        """The drives that can be on it."""
        return [one.running for one in self.drives]

    @cached_property
    def lines(self) -> Sharing:
        """Their power, joined by straight lines."""
        each = zip(self.drives, self.running, strict=True)
        shared = tuple(running for one, running in each if self.shares(one))
        return Sharing(shared, self.entered.efficiency, TURN, self.step, self.drives[0].near, self.room)

    @property
    def step(self) -> float:
        """The step of the grid, in degrees of the master shaft."""
        return self.drives[0].step

    @property
    def room(self) -> int:
        """Rows of the table."""
        return room_for([one.jump_rows for one in self.drives], TURN, self.step, FULL, MORE)

    @property
    def jumps(self) -> list[Jump]:
        """Where each stretch of each drive begins, a row each."""
        found: list[Jump] = []
        for one, running in zip(self.drives, self.running, strict=True):
            each = self.lines.jumps(running) if self.shares(one) else [NONE]
            found += filled(each, one.jump_rows, Jump(each[-1].at, 0.0, 0.0))
        return found

    @property
    def power(self) -> list[list[float]]:
        """The power of each drive at each row (W): none of one that is not on the bus."""
        found = iter(self.lines.power.tolist())
        rests = self.rowed([0.0 for _ in self.lines.spans])
        return [self.rowed([at for at, _ in next(found)]) if self.shares(one) else rests for one in self.drives]

    @property
    def size(self) -> float:
        """The largest power of all together (W)."""
        return max(1e-3, self.lines.size)

    def off(self, one: Stretched) -> float:
        """Return by how much the straight lines of a drive are off at most (W)."""
        return one.most_off if self.shares(one) else 0.0

    def rowed(self, values: Sequence[float]) -> list[float]:
        """Return values of lines; spare rows repeat the last."""
        return filled(values, self.room, values[-1])

    def ends(self, values: Array, end: int) -> list[float]:
        """Return values at begins or ends of the rows; spare rows repeat the last."""
        return self.rowed(values[:, end].tolist())
