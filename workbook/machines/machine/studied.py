"""The results of a machine by the names of its book, without a book: of many motors, reducers and rates at once."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cached_property, partial
from typing import Any

import numpy as np

from engine.machine.bus import Means, together
from engine.machine.geared import constant
from engine.motion.smoothness import shortfalls
from engine.timing import at_rate, ratio_of, turn_time
from workbook.entries.units import KW, PER_MINUTE, shown, si
from workbook.laws.family import COEFFICIENTS
from workbook.laws.library import laws, named
from workbook.laws.shelf import LawShelf
from workbook.machines.machine.apart import Apart
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.power import KWH
from workbook.machines.machine.studied_drives import ONE, EachStudied, Studied, told
from workbook.machines.machine.truth import share_off
from workbook.machines.machine.view import MovingAxis, Whole
from workbook.scaling import Column, Results, Scaling, Worked

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
    whole = Whole(machine, laws(machine.laws))
    rows = Rows(machine)
    rate = columns.get(MASTER, Column([machine.per_minute], ONE.places))
    faster = ratio_of(rate.each, machine.per_minute)
    found: Worked = {
        "about_rate": lambda: rate.each, "timing_rate": lambda: rate.each,
        "about_cycle": partial(cycles, rate), "timing_cycle": partial(cycles, rate),
    }  # fmt: skip
    for one in named(machine.laws):
        if one.page.has_sheet:
            found |= {one.own(f"@{name}"): partial(getattr, one.law.coefficients, name) for name, *_ in COEFFICIENTS}
    drives = []
    for axis in whole.axes:
        found |= of_axis(axis, faster)
        if axis.given.mechanism and axis.given.motor:
            drives.append(drive_of(axis, rows, columns))
            found |= drives[-1].results
    for k in range(1, len(machine.clearances) + 1):
        found |= of_clearance(rows, k)
    return found | (of_drives(machine, drives) if drives else {})


def cycles(rate: Column) -> Any:
    """Return the times of a cycle (s)."""
    return Column([turn_time(si(one, PER_MINUTE)) for one in rate.values], rate.places).each


class Rows:
    """The axes of a machine as its book cuts them, when they are asked for."""

    def __init__(self, machine: AnyMachine) -> None:
        self.machine = machine

    @cached_property
    def each(self) -> list[AxisRows]:
        """The axes."""
        shelf = LawShelf(self.machine.laws, self.machine.sizes, bool(self.machine.laws.of("LIN")))
        whole = Whole(self.machine, shelf.laws)
        return [AxisRows(whole, axis, shelf.stack) for axis in whole.axes]

    def of(self, number: int) -> AxisRows:
        """Return an axis by its number, from 1."""
        return self.each[number - 1]

    @cached_property
    def apart(self) -> list[Apart]:
        """The clearances."""
        return [Apart(one, k, self.each) for k, one in enumerate(self.machine.clearances, 1)]


def drive_of(axis: MovingAxis, rows: Rows, columns: Mapping[str, Column]) -> Studied:
    """Return the drive of an axis with many motors and reducers, at many rates."""
    kind = Studied if constant(Driven(axis, rows.machine.selection).course) else EachStudied
    return kind(axis, rows.machine, columns, partial(rows.of, axis.number))


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
        f"axis{i}_smooth": lambda: told(not shortfalls(axis.motion, given.smoothness, given.repeats)),
        f"axis{i}_closes": lambda: told(axis.axis.closes),
    }  # fmt: skip


def of_move(axis: MovingAxis, k: int, figure: str, faster: Any, power: int) -> Any:
    """Return a figure of a phase, from 0; 0 of one that does not lift."""
    return at_rate(getattr(axis.moves[k], figure), faster, power) if k in axis.moves else 0.0


def of_whole(axis: MovingAxis, figure: str, faster: Any, power: int) -> Any:
    """Return a figure of the whole motion of an axis."""
    return at_rate(getattr(axis, figure), faster, power)


def of_clearance(rows: Rows, k: int) -> Worked:
    """Return the results of a clearance, from 1."""
    return {
        f"clearances.gap.{k}": lambda: rows.apart[k - 1].gap.least,
        f"clearances.at.{k}": lambda: rows.apart[k - 1].over.shown(rows.apart[k - 1].place),
        f"clear{k}_kept": lambda: told(rows.apart[k - 1].kept),
    }


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


SCALING = Scaling(part, results, share_off)
