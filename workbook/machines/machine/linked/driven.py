"""The engine's view of a drive of a ratio that depends on the load's position."""

from __future__ import annotations

from functools import cached_property

from engine.drivetrain import Mechanism
from engine.drivetrain.bends import LEAST, Sizes
from engine.machine.bent import Scales
from engine.machine.limits import Judged, Limits
from engine.machine.places import scales_of
from engine.machine.train import Train
from engine.mechanisms.linkage import Linkage
from engine.mechanisms.registry import LINKED
from workbook.entries.units import MM, si
from workbook.machines.machine.chain import MechanismEntry
from workbook.machines.machine.driven import Driven


def linkage_of(given: MechanismEntry) -> Linkage:
    """Return the mechanism that is entered. Raises ValueError for sizes that do not go together."""
    crank, rod, offset, position = (
        si(one or 0.0, MM) for one in (given.crank, given.rod, given.offset, given.position)
    )
    return LINKED[given.kind].make(crank, rod, offset, given.zero or "inner", given.branch or "ahead", position)


TOO_SHORT = "the rod is not longer than crank and offset: the crank cannot turn round"


def apart(given: MechanismEntry) -> str:
    """Return what is wrong with sizes that do not go together; nothing where they do."""
    return TOO_SHORT if (given.rod or 0.0) <= (given.crank or 0.0) + abs(given.offset or 0.0) else ""


class LinkedDriven(Driven):
    """An axis with such a drive."""

    @cached_property
    def linkage(self) -> Linkage:
        """The mechanism."""
        return linkage_of(self.given)

    @cached_property
    def mechanism(self) -> Mechanism:
        """Reducer and mechanism, their parts and the load; of the mechanism's stage the linkage knows the ratio."""
        return LINKED[self.given.kind].of(self.load, self.given.efficiency, [self.stage], self.turned)

    @property
    def train(self) -> Train:
        """The drive with all that acts on the load."""
        return Train(self.drive, self.linkage, windows=self.windows)

    @cached_property
    def judged(self) -> Judged:
        """The drive and its motor's limits."""
        return Judged(self.demand.course, Limits(self.motor))

    @property
    def inertia(self) -> float:
        """The largest inertia at the motor over the cycle, without it (kg m²)."""
        return self.judged.machine_inertia

    @property
    def inertia_ratio(self) -> float:
        """The same over the motor's; 0 of a motor without inertia."""
        return self.judged.inertia_ratio if self.motor_used.inertia else 0.0

    @cached_property
    def sizes(self) -> Sizes:
        """How large its quantities grow."""
        found = self.demand
        behind, torque = (max(found.shaft_torque(k).peak, LEAST) for k in (1, 0))
        return Sizes(self.axis.hardest, max(found.shaft_torque(2).peak, LEAST), behind, torque, 0.0)

    @cached_property
    def scales(self) -> Scales:
        """What its integrals are measured by."""
        return scales_of(self.demand, self.sizes.torque, self.sizes.behind)
