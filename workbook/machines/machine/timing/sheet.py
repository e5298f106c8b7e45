"""The sheet Timing: the axes over a turn of the master shaft, or over a cycle."""

import math
from typing import Any

from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series, colour
from workbook.book.declare import FIRST, Book, Quantity, Sheet, constant
from workbook.entries.abscissa import TAKEN, unit_cell_name
from workbook.entries.facts import entry_cells, table_of
from workbook.fields.units import PER_MINUTE, shown, si
from workbook.machines.machine.entries import Axis
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.timing.cycle import CURVES, LANE_SHARE
from workbook.machines.machine.timing.phases import axis_checks, phase_columns, phases_table
from workbook.machines.machine.timing.stops import stop_cell, stops_of
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)
MARKS = {"mm": "mm", "°": "deg"}

# the row and the column that the diagram begins at; rows of the other charts
TOP, DIAGRAM, CURVE_ROWS = 5, 11, 12
LABELS = 28.0  # width of the column of labels
RATES = 11.0  # width of the columns of velocity, acceleration and jerk, whose units are long
LEAST, COMPARED, PASSING = 13, 15, 16
"""columns that are printed: of the axes, of axes at two rates, of phases that hand over at speed"""


def timing_sheet(book: Book, machine: MachineView, axes: list[AxisTables]) -> None:
    """Declare the sheet: what to enter at the top, the diagram beside it, the phases of each axis below."""
    cell = CELLS["timing_sheet"]
    sheet = book.sheet("Timing", f"The axes over {machine.over.cycle}: phases, movements, timing diagram.")
    sheet.heading("Enter")
    weight = cell("gravity", machine.given.gravity)
    driven = any(axis.given.motor for axis in machine.axes)
    creeping = cell("creep_forces", machine.given.creep_forces)
    limits = [creeping, *entry_cells(machine.given.limits, "limits")] if driven else []
    sheet.rows(*pace(machine), *([weight] if machine.given.weighs else []), *limits)
    columns = COMPARED if compared_rate(machine) else LEAST
    columns = PASSING if machine.hands_over else columns
    draw_diagram(sheet, machine, columns)
    draw_curves(sheet, machine, columns)
    axes_table(sheet, machine, columns)
    phases_heads(sheet, axes)
    for tables in axes:
        i, unit = tables.axis.number, tables.axis.given.unit
        sheet.put(cell("axis{i}_name", tables.axis.given.name, i=i), sheet.row, FIRST)
        sheet.put(constant(f"axis{i}_{MARKS[unit]}", "Moves in", "", "", unit, align="left"), sheet.row, FIRST + 1)
        sheet.row += 1
        phases_table(sheet, tables)
    stops = [stop_cell(stop) for tables in axes for stop in stops_of(tables.axis)]
    if stops:
        sheet.heading("Hard stops")
        sheet.rows(*stops)
    sheet.not_printed_below()
    sheet.heading("Checks of the axes")
    for tables, verdict in zip(axes, tuple(sheet.later), strict=True):
        sheet.checks(verdict)
        axis_checks(sheet, tables)
    sheet.heading("Workings")
    sheet.rows(
        cell("eps", machine.near), cell("timing_end", 360.0 - 2.0 * machine.near), cell("timing_lane", LANE_SHARE)
    )
    sheet.widths = {FIRST: LABELS} | dict.fromkeys(range(FIRST + columns - 4, FIRST + columns), RATES)
    sheet.print_columns, sheet.folded = FIRST + columns - 1, FIRST + columns


def phases_heads(sheet: Sheet, axes: list[AxisTables]) -> None:
    """Write the heads over the phases of all axes, with the units of each."""
    each = [phase_columns(tables) for tables in axes]
    units = [", ".join(dict.fromkeys(q.unit for q in same if q.unit)) for same in zip(*each, strict=True)]
    sheet.heading("Phases", "Fill one row each, in order; between them an axis rests; leave spare rows empty.")
    sheet.heads("", [q._replace(unit=unit) for q, unit in zip(each[0], units, strict=True)])


def pace(machine: MachineView) -> list[Quantity]:
    """Return the rows of a machine with a master shaft, or without it."""
    over, rate = machine.over, machine.given.per_minute
    if not over.measured:
        return [
            CELLS["pace"]("timing_rate", rate),
            CELLS["pace"]("timing_cycle", machine.time),
            CELLS["pace"]("omega", machine.speed),
            *rate_to_compare(machine),
        ]
    what, symbol, forces = ("Time", "t_c", " and process forces") if over.timed else ("Length", f"{over.symbol}_c", "")
    label = "Speed of a turn a cycle" if over.timed else f"A turn a cycle, per {over.unit}"
    cell = CELLS["pace 2"].sharing(what=what, symbol=symbol, unit=over.unit, forces=forces, over=over, label=label)
    return [
        cell("timing_cycle", over.length, format=over.format),
        constant(unit_cell_name(over.unit), "Abscissa in", "", "", over.unit, align="left", source=over.name),
        *([cell("timing_rate", rate)] if over.timed else []),
        cell("omega", machine.speed),
        cell(TAKEN, over.length, format=over.format),
    ]


def draw_diagram(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Place the timing diagram beside the entries: a lane for each axis over the master angle."""
    count, over = len(machine.given.switches), machine.over
    n = len(machine.axes) + count
    lines = [curve(a, over.column, "lane") for a in machine.axes]
    lines += [Series(f"=switch{i}_name", f"[switch_lanes.x{i}]", f"[switch_lanes.y{i}]") for i in range(1, count + 1)]
    bars = ", bars where a switch is on" if count else ""
    about = f"Timing diagram: rises, rests and returns of each axis over {over.cycle}{bars}"
    chart = Chart("Timing diagram", over.title, "", tuple(lines), about, over.axis(30), (0, n, 1), lanes=True)
    height = max(12, 5 + n + n // 2)
    sheet.chart(chart, DIAGRAM, TOP, FIRST + columns - DIAGRAM, height)
    sheet.row = max(sheet.row, TOP + height)


def curve(axis: MovingAxis, x: str, column: str) -> Series:
    """Return a line of an axis over the cycle, by the columns of its samples."""
    i = axis.number
    return Series(f"=axis{i}_name", f"[cycle{i}.{x}]", f"[cycle{i}.{column}]", color=colour(i))


def draw_curves(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Place charts of velocity, acceleration and jerk: a row for travelling axes, another for turning."""
    sheet.row += 1
    over, moving = machine.over, dict.fromkeys(axis.given.unit for axis in machine.axes)
    for unit in moving:
        of = {"mm": ", travelling", "°": ", turning"}[unit] if len(moving) > 1 else ""
        charts: list[Chart] = []
        for (column, word), symbol, shown_in in zip(CURVES.items(), over.symbols[1:], over.rates(unit), strict=True):
            lines = tuple(curve(axis, over.column, column) for axis in machine.axes if axis.given.unit == unit)
            title = f"{word.capitalize()}{of}"
            about = f"{title} over the {over.name}, a line for each axis"
            charts.append(Chart(title, over.title, f"{symbol} [{shown_in}]", lines, about, over.axis(60)))
        for k, chart in enumerate(charts):
            first, last = (FIRST + columns * part // len(charts) for part in (k, k + 1))
            sheet.chart(chart, first, sheet.row, last - first, CURVE_ROWS)
        sheet.row += CURVE_ROWS


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
