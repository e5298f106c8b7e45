"""The engine's view of a drive that is worked out place by place: of a ratio that changes, or viscous friction."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise

from engine.drivetrain import Mechanism
from engine.drivetrain.bends import LEAST, Sizes
from engine.machine.bent import Scales
from engine.machine.limits import Judged, Limits
from engine.machine.places import scales_of
from engine.machine.train import Train
from engine.mechanisms.crank_slider import crank_slider
from engine.mechanisms.inverted import Cubics
from engine.mechanisms.linkage import Linkage
from engine.mechanisms.registry import LINKED
from engine.mechanisms.rocker import rocker
from engine.mechanisms.table import PositionTable
from workbook.book.sentence import figure
from workbook.entries.units import DEGREE, MM, si
from workbook.machines.machine import chain
from workbook.machines.machine.chain import MechanismEntry, TablePoint
from workbook.machines.machine.choice import Choice
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.view import MovingAxis


def linkage_of(given: MechanismEntry, unit: float) -> Linkage:
    """Return the mechanism that is entered, of an axis in a unit. Raises ValueError for sizes that cannot be."""
    if given.kind == "table":
        return PositionTable([(si(one.angle, DEGREE), si(one.position, unit)) for one in given.points])
    offset = si(given.offset or 0.0, MM)
    if given.kind == "rocker":
        lever, link, angle = si(given.lever or 0.0, MM), si(given.link or 0.0, MM), si(given.angle or 0.0, DEGREE)
        return rocker(lever, link, offset, angle, given.slide != "behind", -1 if given.direction == "backward" else 1)
    crank, rod, position = (si(one or 0.0, MM) for one in (given.crank, given.rod, given.position))
    return crank_slider(crank, rod, offset, given.zero or "inner", given.branch or "ahead", position)


FALLS = "point {} at {} °, {} {} is not beyond the one before it, at {} °, {} {}"
SHARP = "between points {} and {} the table is more than 100 times as steep as at one of them"
APART = {
    "crank-slider": "the rod is not longer than crank and offset: the crank cannot turn round",
    "rocker": "where the motion begins, the link does not reach from the lever to the slide, or is in line with it",
}


def apart(given: MechanismEntry, unit: str) -> str:
    """Return what is wrong with sizes that do not go together; nothing where they do."""
    if given.kind == "table":
        return unlike_table(given.points, unit)
    try:
        linkage_of(given, MM)
    except ValueError:
        return APART[given.kind]
    return ""


def unlike_table(points: list[TablePoint], unit: str) -> str:
    """Return which point of a table does not rise, or between which the table bends too sharply; nothing if none."""
    for row, (one, other) in enumerate(pairwise(points), 2):
        if other.angle <= one.angle or other.position <= one.position:
            (angle, position), (low, lowest) = ((figure(p.angle), figure(p.position)) for p in (other, one))
            return FALLS.format(row, angle, position, unit, low, lowest, unit)
    made = PositionTable([(si(one.angle, DEGREE), one.position) for one in points])
    sharp = Cubics.of(made).sharp.tolist()
    return SHARP.format(sharp.index(True) + 1, sharp.index(True) + 2) if True in sharp else ""


class PlacedDriven(Driven):
    """An axis with such a drive."""

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


class LinkedDriven(PlacedDriven):
    """An axis with a drive of a ratio that depends on the load's position."""

    @cached_property
    def linkage(self) -> Linkage:
        """The mechanism."""
        return linkage_of(self.given, self.axis.unit)

    @property
    def entered_angle(self) -> float:
        """Of a rocker, the lever where the motion begins (rad)."""
        return si(self.given.angle or 0.0, DEGREE)

    @cached_property
    def mechanism(self) -> Mechanism:
        """Reducer and mechanism, their parts and the load; of the mechanism's stage the linkage knows the ratio."""
        return LINKED[self.given.kind].of(self.load, self.given.efficiency, [self.stage], self.turned)

    @property
    def train(self) -> Train:
        """The drive with all that acts on the load."""
        return Train(self.drive, self.linkage, self.viscous, self.windows)

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


def driven_of(axis: MovingAxis, products: Choice) -> Driven:
    """Return the drive of an axis, as its torque is worked out. Raises ValueError where it has none."""
    mechanism, viscous = axis.given.mechanism, axis.given.load.viscous
    if mechanism and mechanism.kind in chain.LINKED:
        return LinkedDriven(axis, products)
    return (Driven if viscous is None else PlacedDriven)(axis, products)
