"""Make a machine faster: its limits in their order, single changes by what they gain, the best laws."""

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

from engine.drive.highest_rate import RateLimit, highest_rate, limits_in_order, moment_of
from engine.drive.limits import LimitChecks, at_speed
from engine.drive.rate_range import at_points
from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.fields.paths import Place, get, table
from workbook.fields.units import PER_MINUTE, shown
from workbook.pool import Pool, WorkerDied
from workbook.studies.plan import changed_machine
from workbook.template_outputs import Change, Improving
from workbook.templates import TEMPLATES
from workbook.text_files import read_text

GAIN = 1e-4  # share of the rate: less is no gain
ORDER = 5  # limits that are listed in their order
ROUNDS = 12  # over all phases of the axis that limits, at most
RATE = ("master", "rate")
STAGES: dict[str, tuple[str, Collection[str]]] = {
    "laws": ("laws", ("law",)),
    "timing": ("laws and timing", ("law", "edge")),
    "motors": ("laws, timing and motors", ("law", "edge", "product")),
}
"""by name: the words and the kinds of changes that are made together, each beginning with the best of the last"""
Done = Callable[[int, int, str], None]  # takes how many changes of how many are tried, and words


@dataclass(frozen=True)
class Design:
    """A machine with entries of its base changed: the highest rate (1/s) of each drive, by points, by its axis."""

    base: Machine
    data: Mapping[str, Any]  # the base as a description
    machine: Machine
    changes: Mapping[Place, Any]
    rates: Mapping[str, float]

    @property
    def improving(self) -> Improving[Any]:
        """The functions by which its kind of machine is improved; raise InputError where there are none."""
        improving = TEMPLATES[self.base.template].improving
        if improving is None:
            raise InputError([f"a machine of the kind {self.base.template} has no highest rate; expected machine"])
        return improving

    @property
    def limiting(self) -> str:
        """The axis that limits the rate."""
        return min(self.rates, key=lambda name: self.rates[name])

    @property
    def rate(self) -> float:
        """The highest rate (1/s), by points."""
        return self.rates[self.limiting]

    def limits(self, axis: str) -> LimitChecks:
        """Return the limits of the drive of an axis."""
        return self.improving.limits(self.machine)[axis]()

    def changed(self, change: Change, axis: str) -> "Design | str":
        """Return the design with a change of an axis, or why there is none such: other axes keep their rates."""
        changes = {**self.changes, **change.entries}
        laws = {value for path, value in changes.items() if path[-1] == "law"}
        changes = {path: value for path, value in changes.items() if path[0] != "laws" or path[1] in laws}
        machine = changed_machine(self.base, dict(self.data), changes)
        if isinstance(machine, str):
            return machine
        design = replace(self, machine=machine, changes=changes)
        try:
            rate = at_points(design.limits(axis)).range.high
        except (ValueError, ArithmeticError) as error:  # what the engine refuses
            return str(error)
        return replace(design, rates={**self.rates, axis: rate})

    def breaks(self) -> set[str]:
        """Return the checks, beside limits of drives, that do not hold."""
        return self.improving.breaks(self.machine)

    def exact(self, axis: str) -> RateLimit:
        """Return the exact highest rate of an axis, and its limit."""
        return highest_rate(self.limits(axis))


def first_design(machine: Machine, is_roomy: bool) -> Design:
    """Return the design to begin with; raise InputError where no drive limits its rate.

    Unless ``is_roomy``, the description says nothing of the room for pieces of a motion, and there is what it needs.
    """
    for fault in machine.design.faults:
        raise InputError([f"{fault.key}: {fault.message}; improve expects a finished design"])
    sizes = {} if is_roomy else {"sizes": machine.sizes.model_dump(exclude={"motion_pieces"})}
    design = Design(machine, table(machine) | sizes, machine, {}, {})
    rates = {name: at_points(make()).range.high for name, make in design.improving.limits(machine).items()}
    if not any(rate < math.inf for rate in rates.values()):
        raise InputError(["no drive of this machine limits its rate; expected a motor, with its limits"])
    for name in (name for name, rate in rates.items() if rate == 0.0):
        raise InputError([f"{name}: its drive holds its limits at no rate; expected a motor and a ratio that do"])
    return replace(design, rates=rates)


class Obstacle(NamedTuple):
    """A limit of an axis, the rate (1/s) at which it is reached, and where it is used most."""

    axis: str
    limit: RateLimit
    where: str


def obstacles(design: Design) -> list[Obstacle]:
    """Return the limits of all drives that are reached first, in their order."""
    every = [(limit, axis) for axis in design.rates for limit in limits_in_order(design.limits(axis))]
    first = []
    for limit, axis in sorted(every)[:ORDER]:
        checks = design.limits(axis)
        moment = moment_of(at_speed(checks, limit.rate * checks.drive_cycle.unshifted.total), limit.limit)
        first.append(Obstacle(axis, limit, design.improving.where(design.machine, axis, moment)))
    return first


class Gain(NamedTuple):
    """A single change and the highest rates (1/s) of the machine before and after it, exact."""

    words: str
    before: float
    after: float

    @property
    def line(self) -> str:
        """The change in a line, with the cycles/min before and after."""
        more = 100.0 * (self.after / self.before - 1.0)
        rates = " → ".join(f"{shown(rate, PER_MINUTE):.1f}" for rate in (self.before, self.after))
        return f"{self.words}, {rates} cycles/min ({more:+.1f} %)"


def tried(change: Change, design: Design, axis: str) -> Design | str:
    """Return the design with a change, or why there is none: a task of a pool."""
    return design.changed(change, axis)


def improved(design: Design, changes: Sequence[Change], pool: Pool, done: Done) -> list[tuple[Change, Design]]:
    """Return the changes with which the axis that limits is faster, and the designs with them, the fastest first."""
    axis, faster = design.limiting, []
    for count, (change, other) in enumerate(pool.each(tried, changes, design, axis), 1):
        done(count, len(changes), change.words)
        if isinstance(other, Design) and other.rates[axis] > design.rates[axis] * (1.0 + GAIN):
            faster.append((change, other))
        elif isinstance(other, WorkerDied):
            raise InputError([f"{change.words}: a worker died"])
    return sorted(faster, key=lambda pair: (-pair[1].rates[axis], pair[0].words))


def single_gains(design: Design, pool: Pool, done: Done) -> Iterator[Gain]:
    """Yield what each single change gains that breaks nothing, the best by points first, worked out exactly."""
    axis, broken = design.limiting, design.breaks()
    exact = {name: design.exact(name).rate for name in design.rates}
    before, others = min(exact.values()), [rate for name, rate in exact.items() if name != axis]
    for change, other in improved(design, [*design.improving.changes(design.machine, axis, exact[axis])], pool, done):
        after = min([other.exact(axis).rate, *others])
        if after > before * (1.0 + GAIN) and other.breaks() <= broken:
            yield Gain(change.words, before, after)


def better(design: Design, kinds: Collection[str], pool: Pool, done: Done) -> Iterator[Design]:
    """Yield designs with better laws, edges or products, none slower than the last, of the axis that limits.

    Each phase and each product has the best of what can be tried in turn, and an edge moves once. Of axes that limit
    alike the machine is faster only when each has changed.
    """
    broken = design.breaks()
    for _ in range(ROUNDS):
        axis, begin = design.limiting, design
        tries: dict[tuple[Place, ...], list[Change]] = {}
        for change in design.improving.changes(design.machine, axis, design.rate):
            if change.kind in kinds and not (change.kind == "edge" and design.changes.keys() & change.entries.keys()):
                tries.setdefault(change.what, []).append(change)
        for changes in tries.values():
            if design.limiting != axis:
                break
            faster = (other for _, other in improved(design, changes, pool, done) if other.breaks() <= broken)
            if other := next(faster, None):
                design = other
                yield design
        if design is begin:
            return


def rate_to_write(design: Design) -> float | None:
    """Return the highest rate (cycles/min) that sheets and the exact engine hold, cut off; None without a rate."""
    if get(design.machine, RATE) is None:
        return None
    rate = min([design.rate, *(design.exact(axis).rate for axis in design.rates)])
    return math.floor(shown(rate, PER_MINUTE) * 100.0) / 100.0


def edited(path: Path, design: Design) -> str:
    """Return the description in a file with the changes of a design, and the rate that it reaches; comments stay."""
    import tomlkit

    document = tomlkit.parse(read_text(path, "a machine description, a .toml file"))
    rate = rate_to_write(design)
    for place, value in ({**design.changes} | ({RATE: rate} if rate else {})).items():
        held: Any = document
        for part in place[:-1]:
            if part not in held and not isinstance(held, list):
                held[part] = tomlkit.table()
            held = held[int(part)] if isinstance(held, list) else held[part]
        held[place[-1]] = value
    return tomlkit.dumps(document)
