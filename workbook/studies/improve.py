"""Make a machine better: its limits in their order, single changes by what they gain, the best together."""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from engine.drive.highest_rate import RateLimit, limits_in_order, moment_of
from engine.drive.limits import at_speed
from workbook.errors import InputError
from workbook.fields.paths import Place, get, key_of
from workbook.improving import AIMS, Change
from workbook.pool import Pool, WorkerDied
from workbook.studies.design import GAIN, Design
from workbook.studies.plan import changed_machine
from workbook.studies.timing import Done, best_timing

ORDER = 5  # limits that are listed in their order
DIGITS = 4  # of figures in words
STARTS = 2  # from which the best timing is looked for, beside the present one
ROUNDS = 12  # over all phases of the axis that limits, at most
RATE = ("master", "rate")
STAGES: dict[str, tuple[str, Collection[str], str]] = {
    "laws": ("laws", ("law",), ""),
    "timing": ("timing", ("edge",), ""),
    "both": ("laws and timing", ("law", "edge"), "laws"),
    "motors": ("laws, timing and motors", ("law", "edge", "product"), "both"),
}
"""by name: the words and the kinds of changes that are made together, and the stage with whose best it begins"""


class Obstacle(NamedTuple):
    """A limit of an axis, the rate (1/s) at which it is reached, and where it is used most."""

    axis: str
    limit: RateLimit
    where: str


def obstacles(design: Design) -> list[Obstacle]:
    """Return the limits of all drives that are reached first, in their order."""
    every = [(limit, axis) for axis in design.costs for limit in limits_in_order(design.limits(axis))]
    first = []
    for limit, axis in sorted(every)[:ORDER]:
        checks = design.limits(axis)
        moment = moment_of(at_speed(checks, limit.rate * checks.drive_cycle.unshifted.total), limit.limit)
        first.append(Obstacle(axis, limit, design.improving.where(design.machine, axis, moment)))
    return first


def gain_in_words(design: Design, before: float, after: float) -> str:
    """Return two costs as the aim shows them, and by how much that is more or less."""
    was, now = design.shown(before), design.shown(after)
    more = f" ({100.0 * (now / was - 1.0):+.1f} %)" if was else ""
    figures = (f"{shown:#.{DIGITS}g}".rstrip(".") for shown in (was, now))
    return f"{' → '.join(figures)} {design.aim.unit}{more}"


class Gain(NamedTuple):
    """A single change and the cost of the machine before and after it, exact; all entries that are changed then."""

    words: str
    before: float
    after: float
    changes: Mapping[Place, Any]

    def sentence(self, design: Design) -> str:
        """Return it in words."""
        return f"{self.words}, {gain_in_words(design, self.before, self.after)}"


def tried(change: Change, design: Design) -> Design | str:
    """Return the design with a change, or why there is none: a task of a pool."""
    return design.changed(change)


def improved(design: Design, changes: Sequence[Change], pool: Pool, done: Done) -> list[tuple[Change, Design]]:
    """Return the changes with which the axis that limits is better, and the designs with them, the best first."""
    axis, better_ones = design.limiting, []
    for count, (change, other) in enumerate(pool.each(tried, changes, design), 1):
        done(count, len(changes), change.words)
        if isinstance(other, Design) and other.costs[axis] < design.costs[axis] * (1.0 - GAIN):
            better_ones.append((change, other))
        elif isinstance(other, WorkerDied):
            raise InputError([f"{change.words}: a worker died"])
    return sorted(better_ones, key=lambda pair: (pair[1].costs[axis], pair[0].words))


def single_gains(design: Design, pool: Pool, done: Done) -> Iterator[Gain]:
    """Yield what each single change gains that breaks nothing, the best by points first, worked out exactly."""
    axis, broken, before = design.limiting, design.breaks(), design.exact_cost
    for change, other in improved(design, [*design.tries(axis)], pool, done):
        if other.breaks() <= broken and (after := other.exact_cost) < before * (1.0 - GAIN):
            yield Gain(change.words, before, after, other.changes)


def better(design: Design, kinds: Collection[str], pool: Pool, done: Done) -> Iterator[Design]:
    """Yield designs with better laws, timing or products, none worse than the last, of the axis that limits.

    Each phase and each product has the best of what can be tried in turn, then all edges move. Of axes that limit
    alike the machine is faster only when each has changed.
    """
    broken = design.breaks()
    for n in range(ROUNDS):
        axis, begin = design.limiting, design
        tries: dict[tuple[Place, ...], list[Change]] = {}
        for change in design.tries(axis):
            if change.kind in kinds and change.kind != "edge":
                tries.setdefault(change.what, []).append(change)
        for changes in tries.values():
            if design.limiting != axis:
                break
            gaining = (other for _, other in improved(design, changes, pool, done) if other.breaks() <= broken)
            if other := next(gaining, None):
                design = other
                yield design
        if "edge" in kinds and (timed := best_timing(design, 0 if n else STARTS, done)):
            design = timed
            yield design
        if design is begin:
            return


def reshaped_laws(design: Design) -> Iterator[tuple[Design, str, str]]:
    """Yield each law that is shaped for its drive shaped anew: a design with it, its place, and what that gains.

    A law that gains nothing stays as it is, and what it gains is empty.
    """
    for name in design.machine.laws.names:
        if not (aim := getattr(design.machine.laws[name], "shaped", None)):
            continue
        present, costs = replace(design, aim=AIMS[aim], held={}, costs={}), list[float]()
        for _ in range(ROUNDS):  # at the higher rate another law is the best
            try:
                axis, change = design.improving.reshaped(present.machine, name)
                other = present.changed(change)
                costs = costs or [present.cost_of(axis)]
                cost = math.inf if isinstance(other, str) else other.cost_of(axis)
            except (ValueError, ArithmeticError) as error:  # too few pieces, or what the engine refuses
                raise InputError([f"laws.{key_of(name)}.shaped: {error}"]) from None
            if isinstance(other, str) or cost >= costs[-1] * (1.0 - GAIN):
                break
            present = other
            costs.append(cost)
        design = replace(design, machine=present.machine, changes=present.changes)
        yield design, f"{name}: {change.words}", gain_in_words(present, costs[0], costs[-1]) if costs[1:] else ""


def rate_to_write(design: Design) -> float | None:
    """Return the highest rate (cycles/min) that sheets and the exact engine hold, cut off; None of another aim."""
    if get(design.machine, RATE) is None or not design.aim.is_rate:
        return None
    exact = cut_off(design.shown(max(design.cost, design.exact_cost)))
    there = changed_machine(design.base, dict(design.data), {**design.changes, RATE: exact})
    return exact if isinstance(there, str) else min(exact, cut_off(design.improving.sheet_rate(there)))


def cut_off(rate: float) -> float:
    """Return a rate rounded down to two decimals."""
    return rate if math.isinf(rate) else math.floor(rate * 100.0) / 100.0
