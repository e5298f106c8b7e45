"""The results of a machine by the names of its book, without a book: of many motors, reducers and rates at once."""

import re
from collections.abc import Collection, Mapping
from functools import cached_property, partial
from typing import Any

import numpy as np

from engine.drive.dc_bus import Means, together
from engine.motion.smoothness import shortfalls
from engine.timing import at_rate, ratio_of, turn_time
from workbook.entries.texts import place_of
from workbook.entries.units import KW, PER_MINUTE, shown, si
from workbook.laws.family import COEFFICIENTS
from workbook.laws.library import laws, named
from workbook.laws.shelf import LawShelf
from workbook.machines.machine.clearance.gap import Apart
from workbook.machines.machine.drive.behind import shaft_of
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.motion.tables import AxisRows
from workbook.machines.machine.power.sheet import KWH
from workbook.machines.machine.power.view import Mains
from workbook.machines.machine.studies import drive_results
from workbook.machines.machine.studies.drives import ONE, Studied, in_words
from workbook.machines.machine.view import MovingAxis, Whole
from workbook.scaling import Column, Results, Scaling, Worked
from workbook.selection.choosing import Choosing

SCALES = re.compile(r"(axes\.\d+\.(?:motor|reducer))\.(?!holding$)\w+|((?:master|axes\.\d+)\.rate)")
MASTER = "master.rate"
GROWTH = {"v": 1, "a": 2, "j": 3, "rms": 2}
"""the power of the rate with which a figure of a motion grows"""


def part(key: str) -> str:
    """Return motor or reducer of an axis, or the rate, to which the entry at a key belongs; empty for all others."""
    found = SCALES.fullmatch(key)
    return (found[1] or found[2]) if found else ""


def results(machine: AnyMachine, columns: Mapping[str, Column]) -> Results:
    """Return the results of designs that differ in motors, reducers and rates, by the keys of these entries."""
    whole, rows = Whole(machine, laws(machine.laws)), Rows(machine)
    rate = columns.get(MASTER, Column([machine.per_minute], ONE.places))
    faster = ratio_of(rate.each, machine.per_minute)
    found: Worked = {
        "about_rate": lambda: rate.each, "timing_rate": lambda: rate.each,
        "about_cycle": partial(cycles, rate), "timing_cycle": partial(cycles, rate),
    }  # fmt: skip
    checks = of_laws(machine, found)
    drives = []
    for axis in whole.axes:
        found |= of_axis(axis, faster)
        checks |= checks_of_axis(axis, rows)
        if axis.given.mechanism and axis.given.motor:
            drives.append(Studied(axis, machine, columns, partial(rows.of, axis.number)))
            found |= drive_results.results(drives[-1])
            checks |= drive_results.checks(drives[-1])
    for k in range(1, len(machine.clearances) + 1):
        found |= of_clearance(rows, k)
        checks[f"clear{k}_kept"] = partial(kept, rows, k)
    found |= of_drives(machine, drives) if drives else {}
    slow = checks_of_drives(machine, drives) if drives else {}
    each = {f"drive{one.axis.number}_{name}" for one in drives for name in ("highest", "binds")}
    every = ("about_highest", "about_binds") if drives else ()
    return Results(found | checks | slow, [*checks, *slow], {*slow, *each, *every})


def of_laws(machine: AnyMachine, found: Worked) -> Worked:
    """Enter the coefficients of laws; return the checks of their sheets."""
    checks: Worked = {}
    for one in named(machine.laws):
        if one.page.has_sheet:
            found |= {one.own(f"@{name}"): partial(getattr, one.law.coefficients, name) for name, *_ in COEFFICIENTS}
            for q in one.page.verdicts(one, machine.sizes):
                if not q.rule:
                    checks[one.own(q.name)] = partial(np.array, q.value)
    return checks


def cycles(rate: Column) -> Any:
    """Return the times of a cycle (s)."""
    return Column([turn_time(si(one, PER_MINUTE)) for one in rate.values], rate.places).each


class Rows:
    """The axes of a machine as its book cuts them, when they are asked for."""

    def __init__(self, machine: AnyMachine) -> None:
        self.machine = machine
        self._made: dict[int, AxisRows] = {}

    @cached_property
    def shelf(self) -> LawShelf:
        """The laws."""
        return LawShelf(self.machine.laws, self.machine.sizes, self.hands_over)

    @cached_property
    def whole(self) -> Whole:
        """The machine."""
        return Whole(self.machine, self.shelf.laws)

    @property
    def hands_over(self) -> bool:
        """Whether phases may hand velocity over."""
        return bool(self.machine.laws.of("LIN"))

    def of(self, number: int) -> AxisRows:
        """Return an axis by its number, from 1."""
        if number not in self._made:
            self._made[number] = AxisRows(self.whole, self.whole.axes[number - 1], self.shelf.stack)
        return self._made[number]

    @cached_property
    def apart(self) -> list[Apart]:
        """The clearances."""
        each = [self.of(axis.number) for axis in self.whole.axes]
        return [Apart(one, k, each) for k, one in enumerate(self.machine.clearances, 1)]


def of_axis(axis: MovingAxis, faster: Any) -> Worked:
    """Return the results of an axis alone, at rates that are so many times that of the machine."""
    i, given = axis.number, axis.given
    phases = {
        f"axis{i}.{name}.{k}": partial(of_move, axis, k - 1, figure, faster, GROWTH[name])
        for k in range(1, len(given.phases) + 1)
        for name, figure in (("v", "v_max"), ("a", "a_max"), ("j", "j_max"), ("rms", "a_rms"))
    }
    each = {
        f"{table}.{name}.{i}": partial(of_whole, axis, figure, faster, GROWTH[name])
        for table in ("axes", "axes_short")
        for name, figure in (("v", "fastest"), ("a", "hardest"))
    }
    return phases | each | {
        f"axes.travel.{i}": lambda: shown(axis.motion.lifts_sum, axis.unit),
    }  # fmt: skip


def checks_of_axis(axis: MovingAxis, rows: Rows) -> Worked:
    """Return the checks of an axis alone that its entries do not decide."""
    i, given = axis.number, axis.given
    found: Worked = {
        f"axis{i}_position": lambda: in_words(axis.motion.complete),
        f"axis{i}_smooth": lambda: in_words(not shortfalls(axis.motion, given.smoothness, given.repeats)),
        f"axis{i}_closes": lambda: in_words(axis.axis.closes),
    }
    ends = rows.of(i).ends if rows.hands_over else None
    return found | ({q.name: partial(np.array, q.value) for q in ends.checks(f"axis{i}", "")} if ends else {})


def of_move(axis: MovingAxis, k: int, figure: str, faster: Any, power: int) -> Any:
    """Return a figure of a phase, from 0; 0 of one that does not lift."""
    return at_rate(getattr(axis.moves[k], figure), faster, power) if k in axis.moves else 0.0


def of_whole(axis: MovingAxis, figure: str, faster: Any, power: int) -> Any:
    """Return a figure of the whole motion of an axis."""
    return at_rate(getattr(axis, figure), faster, power)


def of_clearance(rows: Rows, k: int) -> Worked:
    """Return the results of a clearance, from 1."""
    return {
        f"clearances.gap.{k}": lambda: rows.apart[k - 1].least,
        f"clearances.at.{k}": lambda: rows.apart[k - 1].over.shown(rows.apart[k - 1].place),
    }


def kept(rows: Rows, k: int) -> Any:
    """Return whether the gap of a clearance is left."""
    return in_words(rows.apart[k - 1].kept)


def checks_of_drives(machine: AnyMachine, drives: list[Studied]) -> Worked:
    """Return the checks of all drives together: the bus, and the choice for the axis that is named for it."""
    found: Worked = {"bus_fine": partial(bus_fine, machine, drives)}
    choice = machine.selection
    chosen = [one for one in drives if choice.axis and place_of(choice.axis, [one.axis.given.name]) == 0]
    return found | ({"sel_ok": partial(choice_found, machine, chosen[0])} if chosen else {})


def bus_fine(machine: AnyMachine, drives: list[Studied]) -> Any:
    """Return whether the samples tell the peak of the bus, of each design."""
    designs = [tuple(each) for each in zip(*lined([one.designs for one in drives]), strict=True)]
    fine: dict[Any, bool] = {}
    for design in dict.fromkeys(designs):
        views = [one.views[own] for one, own in zip(drives, design, strict=True)]
        fine[design] = Mains(views, machine.power).fine
    return in_words(np.array([fine[design] for design in designs]))


def lined(designs: list[list[Any]]) -> list[list[Any]]:
    """Return the designs of drives, of which some differ in nothing, as many of each."""
    count = max(map(len, designs))
    return [one if len(one) == count else one * count for one in designs]


def choice_found(machine: AnyMachine, drive: Studied) -> Any:
    """Return whether the catalogue has a pair for the axis that the sheet Selection looks at."""
    each = [Choosing(machine.selection, machine.sizes, [shaft_of(base)]).proposed is not None for base in drive.bases]
    return in_words(np.array(each)[drive.rates.places])


def of_drives(machine: AnyMachine, drives: list[Studied]) -> Worked:
    """Return the results of all drives together."""

    def whole() -> Means:
        return together([one.mains for one in drives])

    def year() -> Any:
        return shown(whole().energy_a_year(machine.power.hours), KWH)

    found: Worked = {
        "power_mains": lambda: shown(whole().mains, KW),
        "power_resistors": lambda: shown(whole().resistor, KW),
        "power_year": year,
        "about_year": year,
        "power_least": lambda: shown(whole().least, KW),
    }
    for k, one in enumerate(drives, 1):
        found |= {f"power.mains.{k}": partial(mains_of, one), f"power.resistor.{k}": partial(resistor_of, one)}
    return found | {"about_highest": partial(least_rate, drives), "about_binds": partial(binding, drives)}


def mains_of(one: Studied) -> Any:
    """Return the mean power of a drive from the mains (kW)."""
    return shown(one.mains.mains, KW)


def resistor_of(one: Studied) -> Any:
    """Return the mean power in its resistor (kW)."""
    return shown(one.mains.resistor, KW)


def least_rate(drives: list[Studied]) -> Any:
    """Return the highest rate at which all drives hold all limits (cycles/min)."""
    return np.min(np.broadcast_arrays(*(one.highest for one in drives)), axis=0)


def binding(drives: list[Studied]) -> Any:
    """Return the axis and the limit that bind there."""
    rates = np.array(np.broadcast_arrays(*(one.highest for one in drives)))
    words = [np.array([f"{one.axis.given.name}: {limit}" for limit in one.binds], dtype=object) for one in drives]
    return np.choose(rates.argmin(axis=0), np.broadcast_arrays(*words))


def most(machine: AnyMachine, keys: Collection[str]) -> dict[str, float]:
    """Return the greatest inertia ratio of the drives whose motor or reducer varies by these keys."""
    varied = {part(key) for key in keys}
    own = [k for k in range(len(machine.axes)) if varied & {f"axes.{k}.motor", f"axes.{k}.reducer"}]
    return {f"drive{k + 1}_inertias": machine.selection.inertia_ratio for k in own}


SCALING = Scaling(part, results, most)
