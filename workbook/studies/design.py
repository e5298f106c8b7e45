"""A machine that is to be better: what changed in it, and what it has less of; the rate, or another aim."""

import math
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, replace
from functools import cached_property
from types import ModuleType
from typing import Any, cast

from engine.drive.limits import LimitChecks
from engine.drive.rate_range import at_points, highest_rate
from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.fields.paths import Place, get
from workbook.fields.units import PER_MINUTE, shown, si
from workbook.improving import AIMS, Aim, Change
from workbook.studies.plan import as_description, changed_machine
from workbook.templates import TEMPLATES

RATE = ("master", "rate")
GAIN = 1e-4  # share of the cost: less is no gain


@dataclass(frozen=True)
class Design:
    """A machine with entries of its base changed, and what it is to have less of: the ``costs``, by axis.

    They are the time of a cycle (s) at the highest rate, by points, or figures of the aim at the rate of the machine;
    ``held`` are the highest rates (1/s) that drives must hold beside another aim.
    """

    base: Machine
    data: Mapping[str, Any]  # the base as a description
    machine: Any  # as the base, with the changes
    changes: Mapping[Place, Any]
    costs: Mapping[str, float]
    aim: Aim
    held: Mapping[str, float]

    @property
    def improving(self) -> ModuleType:
        """The functions by which its kind of machine is improved; raise InputError where there are none."""
        improving = TEMPLATES[self.base.template].improving
        if improving is None:
            raise InputError([f"a machine of the kind {self.base.template} has no highest rate; expected machine"])
        return improving

    @property
    def limiting(self) -> str:
        """The axis that limits the rate, or has most of what is to be less."""
        return max(self.costs, key=lambda name: self.costs[name])

    @property
    def cost(self) -> float:
        """The cost of the machine: the largest of its axes, and the time of a cycle that the process takes."""
        process = 1.0 / self.improving.timing.process_rate(self.machine) if self.aim.is_rate else 0.0
        return max(self.costs[self.limiting], process)

    @property
    def rate(self) -> float:
        """The rate (1/s) that the machine has: the highest, by points, or the entered one where the aim is another."""
        return 1.0 / self.cost if self.aim.is_rate else si(self.machine.per_minute, PER_MINUTE)

    @cached_property
    def exact_cost(self) -> float:
        """The cost of the machine by the exact engine."""
        if not self.aim.is_rate:
            return self.cost
        rates = [highest_rate(self.limits(axis)).rate for axis in self.costs]
        return 1.0 / float(min([*rates, self.improving.timing.process_rate(self.machine)]))

    @cached_property
    def rate_to_write(self) -> float | None:
        """The highest rate (cycles/min) that sheets and the exact engine hold, to two decimals; None of another aim."""
        if get(self.machine, RATE) is None or not self.aim.is_rate:
            return None
        rate = self.shown(max(self.cost, self.exact_cost))
        there = changed_machine(self.base, dict(self.data), {**self.changes, RATE: rate})
        rate = rate if isinstance(there, str) else min(rate, self.improving.sheet_rate(there))
        return rate if math.isinf(rate) else math.floor(rate * 100.0) / 100.0

    def is_no_worse(self, than: "Design", broken: Set[str]) -> bool:
        """Return whether it breaks nothing else, and is no worse than another: exactly, and by the rate of its book.

        Sheets state a rate up to 1 % below the exact one: what is better by points may be written with a lower rate.
        """
        if not self.breaks() <= broken or self.exact_cost > than.exact_cost:
            return False
        return self.rate_to_write is None or self.rate_to_write >= (than.rate_to_write or 0.0)

    def shown(self, cost: float) -> float:
        """Return a cost as it is shown: as a rate (cycles/min), or in the unit of the aim."""
        return float(shown(1.0 / cost, PER_MINUTE)) if self.aim.is_rate else cost

    def limits(self, axis: str) -> LimitChecks:
        """Return the limits of the drive of an axis."""
        driven = self.improving.shaping.drives(self.machine)[axis]()
        return cast("LimitChecks", driven.limit_checks)

    def changed(self, change: Change) -> "Design | str":
        """Return the design with a change, or why there is none such: axes that it leaves alone keep their costs.

        Laws shaped for their drives take the rates over that their neighbours have where edges moved.
        """
        changes = {**self.changes, **change.entries}
        laws = {value for path, value in changes.items() if path[-1] == "law"}
        changes = {path: value for path, value in changes.items() if path[0] != "laws" or path[1] in laws}
        machine = changed_machine(self.base, dict(self.data), changes)
        if isinstance(machine, str):
            return machine
        try:
            refitted = self.improving.shaping.refitted(machine) if change.kind == "edge" else {}
        except ValueError as error:  # a law would overshoot
            return str(error)
        if refitted:
            changes |= refitted
            machine = changed_machine(self.base, dict(self.data), changes)
        design = replace(self, machine=machine, changes=changes)
        touched = dict.fromkeys(get(machine, (*path[:2], "name")) for path in change.entries if path[0] == "axes")
        try:
            costs = {axis: design.cost_of(axis) for axis in touched if axis in self.costs or axis in self.held}
        except (ValueError, ArithmeticError) as error:  # what the engine refuses
            return str(error)
        return replace(design, costs={axis: costs.get(axis, cost) for axis, cost in self.costs.items()})

    def cost_of(self, axis: str) -> float:
        """Return the cost of an axis; raise ValueError where its drive does not hold the rate that it must."""
        rate = at_points(self.limits(axis)).range.high if self.aim.is_rate or axis in self.held else math.inf
        if self.aim.is_rate:
            return 1.0 / rate if rate else math.inf
        if rate < self.held.get(axis, 0.0):
            raise ValueError(f"{axis}: its drive does not hold the rate")
        return float(self.improving.figure_of(self.machine, axis, self.aim).value)

    def tries(self, axis: str) -> Iterator[Change]:
        """Yield the single changes of an axis."""
        yield from self.improving.changes(self.machine, axis, self.rate, self.aim)

    def breaks(self) -> set[str]:
        """Return the checks, beside limits of drives, that do not hold."""
        return set(self.improving.breaks(self.machine))


def first_design(machine: Machine, aim: Aim = AIMS["rate"], axis: str = "") -> Design:
    """Return the design to begin with; raise InputError where no drive limits its rate.

    An ``aim`` beside the rate is that of an ``axis``, by default that which has most of it.
    """
    for fault in machine.design.faults:
        raise InputError([f"{fault.key}: {fault.message}; improve expects a finished design"])
    design = Design(machine, as_description(machine), machine, {}, {}, aim, {})
    improving = design.improving
    for sentence in (name for name in design.breaks() if name.startswith("timing.")):
        raise InputError([sentence])
    rates = {name: at_points(design.limits(name)).range.high for name in improving.shaping.drives(machine)}
    if not aim.is_rate:
        return aimed(design, axis, rates)
    if axis:
        raise InputError([f"an axis is named, {axis}; expected none: all limit the highest rate"])
    if not any(rate < math.inf for rate in rates.values()):
        raise InputError(["no drive of this machine limits its rate; expected a motor, with its limits"])
    for name in (name for name, rate in rates.items() if rate == 0.0):
        raise InputError([f"{name}: its drive holds its limits at no rate; expected a motor and a ratio that do"])
    return replace(design, costs={name: 1.0 / rate for name, rate in rates.items()})


def aimed(design: Design, axis: str, rates: Mapping[str, float]) -> Design:
    """Return a design with the costs of its aim; ``rates`` are the highest (1/s) of the axes with drives."""
    kinematic = design.aim.name in ("acceleration", "vibration")
    names = [each.name for each in design.machine.axes if kinematic or each.name in rates]
    if design.aim.name == "vibration" and not design.aim.frequency:
        names = [each.name for each in design.machine.axes if each.vibration]
        if not names:
            raise InputError(["no axis has a table vibration; expected --frequency of a load, or axes.N.vibration"])
    if not names:
        raise InputError([f"no axis has a drive; expected one, of which the {design.aim.words} is to be less"])
    if axis and axis not in names:
        raise InputError([f"no axis with a {design.aim.words} is named {axis!r}; expected one of {', '.join(names)}"])
    figures = {
        name: design.improving.figure_of(design.machine, name, design.aim) for name in ([axis] if axis else names)
    }
    most = max(figures, key=lambda name: figures[name].value)
    held = {name: min(rate, design.rate) for name, rate in rates.items()}
    aim = design.aim._replace(unit=figures[most].unit)
    return replace(design, costs={most: figures[most].value}, held=held, aim=aim)
