"""The table of a machine's axes on the sheet Timing: what each must do, what it comes to, also at another rate."""

import math
from typing import Any

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import FIRST, Quantity, Sheet
from workbook.entries.facts import table_of
from workbook.fields.units import PER_MINUTE, shown, si
from workbook.machines.machine.entries import Axis
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)


def units(machine: MachineView, order: int = 0) -> str:
    """Return the units of the positions of all axes (order 0), or of a derivative, as they are shown."""
    each = dict.fromkeys(axis.given.unit for axis in machine.axes)
    return ", ".join((unit, *machine.over.rates(unit))[order] for unit in each)


def axes_table(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Declare the names of the axes, what each must do and what it comes to; shifts as taken behind so many columns."""
    axes, over, unit = machine.axes, machine.over, units(machine)
    entry = table_of(Axis).columns([axis.typed for axis in axes], "axes", len(axes))
    size = max(shown(axis.motion.size(0), axis.unit) for axis in axes)
    lows, highs = ([shown(axis.motion.reach[end], axis.unit) for axis in axes] for end in (0, 1))
    travels = [shown(axis.motion.lifts_sum, axis.unit) for axis in axes]
    numbers, parts = [axis.number for axis in axes], in_units(axes)
    speed, acceleration = (units(machine, order) for order in (1, 2))
    sheet.row += 1
    cell = CELLS["axes"].sharing(unit=unit, i=numbers)
    table = cell.place(
        sheet,
        entry("group"),
        cell("k", numbers),
        entry("name"),
        entry("closes"),
        entry("smooth"),
        entry("shift", place=over.unit, format=over.format),
        entry("position", unit=unit),
        cell("travel", travels, scale=max(greatest_lifts(axes)) or 1.0, **parts),
        cell("low", lows, scale=size, **parts),
        cell("high", highs, scale=size, **parts),
        cell("v", [axis.max_velocity for axis in axes], symbol=over.symbols[1], unit=speed),
        cell("a", [axis.max_acceleration for axis in axes], symbol=over.symbols[2], unit=acceleration),
        *extremes_compared(machine),
    )
    sheet.workings(table, "axes_taken", "Workings", FIRST + columns + 1, *taken(machine))


def in_units(axes: list[MovingAxis]) -> dict[str, list[Any]]:
    """Return parts of formulas: the number of each axis, and what turns m or rad into the unit of its entries."""
    travels = [axis.given.unit == "mm" for axis in axes]
    return {
        "i": [axis.number for axis in axes],
        "opens": ["" if travel else "DEGREES(" for travel in travels],
        "closes": ["*1000" if travel else ")" for travel in travels],
    }


def greatest_lifts(axes: list[MovingAxis]) -> list[float]:
    """Return the greatest size of a lift of each axis, in its unit."""
    return [max(abs(shown(phase.lift, axis.unit)) for phase in axis.motion.phases) for axis in axes]


def taken(machine: MachineView) -> list[Quantity]:
    """Return the columns of what the cells compute with: shift, begin, greatest lift, jumps of the position."""
    cell, axes, over, unit = CELLS["axes_taken"], machine.axes, machine.over, units(machine)
    lifts, parts = greatest_lifts(axes), in_units(axes)
    begins = [si(axis.given.position, axis.unit) for axis in axes]
    base = ", ".join(dict.fromkeys(axis.base for axis in axes))
    to_base = ["[position]/1000" if axis.given.unit == "mm" else "RADIANS([position])" for axis in axes]
    last = [over.degrees_formula(f"MAX([axis{axis.number}.stop])") for axis in axes]
    jumps = [shown(axis.missing_lift, axis.unit) for axis in axes]
    gaps = [shown(axis.motion.gap, axis.unit) for axis in axes]
    return [
        cell("late", [axis.given.shift for axis in axes], degrees=over.degrees_formula("[shift]")),
        cell("y0", begins, unit=base, to_base=to_base),
        cell("lift", lifts, unit=unit, **parts),
        cell("lack", jumps, unit=unit, scale=max(lifts) or 1.0, **parts),
        cell("gap", gaps, unit=unit, last=last, scale=max(lifts) or 1.0, **parts),
    ]


def compared_rate(machine: MachineView) -> float | None:
    """Return the rate (cycles/min) at which extremes are shown too, if it is entered."""
    return getattr(machine.given.master, "compare_rate", None)


def rate_to_compare(machine: MachineView) -> list[Quantity]:
    """Return the rows of the rate at which extremes are shown too, if it is entered."""
    cell, rate = CELLS["rate_to_compare"], compared_rate(machine)
    if rate is None:
        return []
    return [cell("timing_compared", rate), cell("omega_compared", math.tau * si(rate, PER_MINUTE))]


def extremes_compared(machine: MachineView) -> list[Quantity]:
    """Return the columns of the greatest velocity and acceleration at the rate to compare at, if it is entered."""
    cell = CELLS["extremes_compared"]
    rate, axes, symbols = compared_rate(machine), machine.axes, machine.over.symbols
    if rate is None:
        return []
    faster = rate / machine.given.per_minute
    return [
        cell("vc", [a.max_velocity * faster for a in axes], symbols=symbols, unit=units(machine, 1)),
        cell("ac", [a.max_acceleration * faster**2 for a in axes], symbols=symbols, unit=units(machine, 2)),
    ]
