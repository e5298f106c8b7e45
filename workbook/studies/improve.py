"""Make a machine better: its limits in their order, single changes by what they gain, the best together."""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from engine.drive.limits import at_speed
from engine.drive.rate_range import RateLimit, limits_in_order, moment_of
from workbook.errors import InputError
from workbook.fields.paths import Place, key_of
from workbook.improving import AIMS, Change
from workbook.law_sheets.library import laws
from workbook.pool import Pool, WorkerDied
from workbook.studies.design import GAIN, Design
from workbook.studies.timing import Done, best_timing

ORDER = 5  # limits that are listed in their order
DIGITS = 4  # of figures in words
STARTS = 2  # from which the best timing is looked for, beside the present one
ROUNDS = 12  # over all phases of the axis that limits, at most
# ξ and shares of the rise by which laws that differ are told apart
SAMPLES = np.linspace(0.0, 1.0, 65)
SAME = 1e-6
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
        """Return the change in words."""
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
            others = (other for _, other in improved(design, changes, pool, done) if other.is_no_worse(design, broken))
            if other := next(others, None):
                design = other
                yield design
        if "edge" in kinds and (timed := best_timing(design, 0 if n else STARTS, done)):
            design = timed
            yield design
        if design is begin:
            return


def reshaped_laws(design: Design) -> Iterator[tuple[Design, str, str]]:
    """Yield each law that is shaped for its drive or its load shaped anew: a design with it, in words, what that gains.

    A law that gains nothing stays as it is, and what it gains is empty.
    """
    for name in design.machine.laws.names:
        shaped, shaper = (getattr(design.machine.laws[name], key, None) for key in ("shaped", "shaper"))
        if not (shaped or shaper):
            continue
        present = replace(design, aim=AIMS[shaped] if shaped else AIMS["vibration"], held={}, costs={})
        try:
            other, words, gain = given_out_anew(present, name) if shaper else reshaped(present, name)
        except (ValueError, ArithmeticError) as error:  # too few pieces, or what the engine refuses
            key = "shaper" if shaper else "shaped"
            raise InputError([f"laws.{key_of(name)}.{key}: {error}"]) from None
        design = replace(design, machine=other.machine, changes=other.changes)
        yield design, f"{name}: {words}", gain


def reshaped(design: Design, name: str) -> tuple[Design, str, str]:
    """Return the design with a law shaped anew for its drive until that gains no more, in words, and the gain.

    A law that does not meet its neighbours is shaped anew whatever that costs.
    """
    costs = list[float]()
    words = ""
    meets = name not in dict(design.improving.shaping.misfits(design.machine))
    for _ in range(ROUNDS):  # at the higher rate another law is the best
        axis, change = design.improving.shaping.reshaped(design.machine, name)
        words = change.words
        costs = costs or [design.cost_of(axis)] * meets
        other = design.changed(change)
        if isinstance(other, str) or (cost := other.cost_of(axis)) >= min(costs, default=math.inf) * (1.0 - GAIN):
            break
        design = other
        costs.append(cost)
    gain = gain_in_words(design, costs[0], costs[-1]) if costs[1:] else ""
    return design, words, gain if meets or not costs else "which meets its neighbours now"


def given_out_anew(design: Design, name: str) -> tuple[Design, str, str]:
    """Return the design with a law given out anew by its shaper, in words, and what it leaves where that differs."""
    axis, change = design.improving.shaping.reshaped(design.machine, name)
    other = design.changed(change)
    if isinstance(other, str):
        raise ValueError(other)
    then, now = (laws(each.machine.laws)[name].s(SAMPLES) for each in (design, other))
    if abs(now - then).max() < SAME:
        return design, change.words, ""
    before, after = (each.improving.figure_of(each.machine, axis, design.aim) for each in (design, other))
    return other, change.words, f"leaves {before.value:.4g} → {after.value:.4g} {after.unit} in RMS"
