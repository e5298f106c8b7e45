"""The results of a machine by the names of its book, without a book: of many motors, reducers and rates at once."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from engine.drive.results import together
from engine.motion.joining import shortfalls
from workbook.entries.texts import place_of
from workbook.entries.units import KW, shown
from workbook.laws.family import COEFFICIENTS
from workbook.laws.library import laws, named
from workbook.machines.machine.clearances import Apart
from workbook.machines.machine.drive.behind import shaft_of
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.exact import axes_of
from workbook.machines.machine.motion.tables import AxisRows
from workbook.machines.machine.power import KWH, Mains
from workbook.machines.machine.studies import drive_results
from workbook.machines.machine.studies.drives import ONE, Studied, cycles, in_words
from workbook.machines.machine.view import MovingAxis, Whole
from workbook.scaling import Column, Results, Scaling, Worked
from workbook.selection.choosing import Choosing

SCALES = re.compile(r"(axes\.\d+\.(?:motor|reducer))\.(?!holding$)\w+|((?:master|axes\.\d+)\.rate)")
MASTER = "master.rate"
GROWTH = {"v": ("y1_max", 1), "a": ("y2_max", 2), "j": ("y3_max", 3), "rms": ("y2_rms", 2)}
"""by column: a figure of a phase, and the power of the rate with which it grows"""


def part(key: str) -> str:
    """Return motor or reducer of an axis, or the rate, to which the entry at a key belongs; empty for all others."""
    found = SCALES.fullmatch(key)
    return (found[1] or found[2]) if found else ""


def results(machine: AnyMachine, columns: Mapping[str, Column]) -> Results:
    """Return the results of designs that differ in motors, reducers and rates, by the keys of these entries."""
    whole, rows = Whole(machine, laws(machine.laws)), cache(partial(axes_of, machine))
    rate = columns.get(MASTER, Column([machine.per_minute], ONE.places))
    faster = np.asarray(rate.each) / machine.per_minute
    found: Worked = {
        "about_rate": lambda: rate.each, "timing_rate": lambda: rate.each,
        "about_cycle": partial(cycles, rate), "timing_cycle": partial(cycles, rate),
    }  # fmt: skip
    checks = of_laws(machine, found)
    drives = []
    for axis in whole.axes:
        found |= of_axis(axis, faster)
        checks |= checks_of_axis(axis, rows() if machine.laws.of("LIN") else [])
        if axis.given.mechanism and axis.given.motor:
            drives.append(Studied(axis, machine, columns, partial(lambda i: rows()[i - 1], axis.number)))
            found |= drive_results.results(drives[-1])
            checks |= drive_results.checks(drives[-1])
    for k, given in enumerate(machine.clearances, 1):
        apart = cache(partial(lambda k, given: Apart(given, k, rows()), k, given))
        found |= of_clearance(apart, k)
        checks[f"clear{k}_kept"] = partial(lambda apart: in_words(apart().kept), apart)
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


def of_axis(axis: MovingAxis, faster: Any) -> Worked:
    """Return the results of an axis alone, at rates that are so many times that of the machine."""
    i = axis.number

    def of_move(k: int, figure: str, power: int) -> Any:
        return getattr(axis.moves[k], figure) * axis.speed**power * faster**power if k in axis.moves else 0.0

    def of_whole(figure: str, power: int) -> Any:
        return getattr(axis, figure) * faster**power

    found: Worked = {f"axes.travel.{i}": lambda: shown(axis.motion.lifts_sum, axis.unit)}
    for name, (figure, power) in GROWTH.items():
        found |= {f"axis{i}.{name}.{k + 1}": partial(of_move, k, figure, power) for k in range(len(axis.given.phases))}
    for table in ("axes", "axes_short"):
        found[f"{table}.v.{i}"] = partial(of_whole, "fastest", 1)
        found[f"{table}.a.{i}"] = partial(of_whole, "hardest", 2)
    return found


def checks_of_axis(axis: MovingAxis, rows: Sequence[AxisRows]) -> Worked:
    """Return the checks of an axis that its entries do not decide; ``rows`` are those of a book that hands over."""
    i, given = axis.number, axis.given
    found: Worked = {
        f"axis{i}_position": lambda: in_words(axis.motion.complete),
        f"axis{i}_smooth": lambda: in_words(not shortfalls(axis.motion, given.smoothness, given.repeats)),
        f"axis{i}_closes": lambda: in_words(axis.closes),
    }
    ends = rows[i - 1].ends if rows else None
    return found | ({q.name: partial(np.array, q.value) for q in ends.checks(f"axis{i}", "")} if ends else {})


def of_clearance(apart: Callable[[], Apart], k: int) -> Worked:
    """Return the results of a clearance, from 1."""
    return {
        f"clearances.gap.{k}": lambda: apart().least,
        f"clearances.at.{k}": lambda: apart().over.shown(apart().place),
    }


def checks_of_drives(machine: AnyMachine, drives: list[Studied]) -> Worked:
    """Return the checks of all drives together: the bus, and the choice for the axis that is named for it."""

    def bus_fine() -> Any:
        """Return whether the samples tell the peak of the bus; a drive of which nothing differs has one design."""
        count = max(len(one.designs) for one in drives)
        each = (one.designs if len(one.designs) == count else one.designs * count for one in drives)
        designs = [tuple(design) for design in zip(*each, strict=True)]
        fine = {}
        for design in dict.fromkeys(designs):
            views = [one.views[own] for one, own in zip(drives, design, strict=True)]
            fine[design] = Mains(views, machine.power).fine
        return in_words(np.array([fine[design] for design in designs]))

    def chosen(one: Studied) -> Any:
        """Return whether the catalogue has a pair for the axis that the sheet Selection looks at."""
        each = (Choosing(machine.selection, machine.sizes, [shaft_of(base)]) for base in one.bases)
        return in_words(np.array([choice.proposed is not None for choice in each])[one.rates.places])

    axis, found = machine.selection.axis, {"bus_fine": bus_fine}
    named = [one for one in drives if axis and place_of(axis, [one.axis.given.name]) == 0]
    return found | ({"sel_ok": partial(chosen, named[0])} if named else {})


def of_drives(machine: AnyMachine, drives: list[Studied]) -> Worked:
    """Return the results of all drives together."""
    whole = cache(lambda: together([one.mains for one in drives]))

    def year() -> Any:
        return shown(whole().energy_a_year(machine.power.hours), KWH)

    def mean(one: Studied, name: str) -> Any:
        return shown(getattr(one.mains, name), KW)

    def binding() -> Any:
        rates = np.array(np.broadcast_arrays(*(one.highest for one in drives)))
        words = [np.array([f"{one.axis.given.name}: {limit}" for limit in one.binds], dtype=object) for one in drives]
        return np.choose(rates.argmin(axis=0), np.broadcast_arrays(*words))

    found: Worked = {
        "power_mains": lambda: shown(whole().mains, KW),
        "power_resistors": lambda: shown(whole().resistor, KW),
        "power_year": year,
        "about_year": year,
        "power_least": lambda: shown(whole().least, KW),
        "about_highest": lambda: np.min(np.broadcast_arrays(*(one.highest for one in drives)), axis=0),
        "about_binds": binding,
    }
    for k, one in enumerate(drives, 1):
        found |= {f"power.{name}.{k}": partial(mean, one, name) for name in ("mains", "resistor")}
    return found


def most(machine: AnyMachine, keys: Collection[str]) -> dict[str, float]:
    """Return the greatest inertia ratio of the drives whose motor or reducer varies by these keys."""
    varied = {part(key) for key in keys}
    own = [k for k in range(len(machine.axes)) if varied & {f"axes.{k}.motor", f"axes.{k}.reducer"}]
    return {f"drive{k + 1}_inertias": machine.selection.inertia_ratio for k in own}


SCALING = Scaling(part, results, most)
