"""The sheet Timing: the axes over a turn of the master shaft, or over a cycle."""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series, colour
from workbook.book.declare import FIRST, Book, Quantity, Sheet, constant
from workbook.entries.abscissa import TAKEN
from workbook.entries.facts import entry_cells, table_of
from workbook.entries.phase import AT_REST
from workbook.fields.units import PER_MINUTE, shown, si
from workbook.machines.machine.entries import Axis
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.timing.cycle import CURVES, LANE_SHARE
from workbook.machines.machine.timing.phases import axis_checks, phase_columns, phase_workings
from workbook.machines.machine.timing.stops import stop_cell, stops_of
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)

TOP, DIAGRAM = 5, 10  # the row and the column that the diagram begins at
LANES, LANE_ROWS = 6, 3  # columns and rows of the lane of a curve
LABELS = 28.0  # width of the column of labels
SWITCH = "6B7280"  # the colour of bars of switches
NARROW = 6.0  # width of the columns over which charts lie, behind phases that hand over


def timing_sheet(book: Book, machine: MachineView, axes: list[AxisTables]) -> None:
    """Declare the sheet: what to enter, the diagram beside it, the axes, and the phases of each with its curves."""
    sheet = book.sheet("Timing", f"What the axes do over {machine.over.cycle}; between phases they rest.")
    columns = [phase_columns(tables) for tables in axes]
    behind = FIRST + len(columns[0])
    sheet.print_columns, sheet.folded = behind + LANES - 1, behind + LANES
    narrow = range(behind, behind + LANES) if machine.hands_over else ()
    sheet.widths = {FIRST: LABELS} | dict.fromkeys(narrow, NARROW)
    sheet.heading("Enter")
    rarely = rarely_changed(machine)
    sheet.rows(*pace(machine), *rarely, section="Rarely changed", first=next(iter(rarely), None))
    draw_diagram(sheet, machine, axes)
    axes_table(sheet, machine)
    phases_of_axes(sheet, machine, axes, columns)
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
    cell, near = CELLS["timing_sheet"], machine.near
    sheet.rows(cell("eps", near), cell("timing_end", 360.0 - 2.0 * near), cell("timing_lane", LANE_SHARE))


def rarely_changed(machine: MachineView) -> list[Quantity]:
    """Return gravity, and the limits and reserves of all drives, where there are any."""
    cell, given = CELLS["timing_sheet"], machine.given
    driven = any(axis.given.motor for axis in machine.axes)
    creeping = cell("creep_forces", given.creep_forces)
    limits = [creeping, *entry_cells(given.limits, "limits")] if driven else []
    return [*([cell("gravity", given.gravity)] if given.weighs else []), *limits]


def phases_of_axes(sheet: Sheet, machine: MachineView, axes: list[AxisTables], columns: list[list[Quantity]]) -> None:
    """Declare the phases of all axes, whose columns are given, in a table, and beside each axis its curves in lanes."""
    sheet.heading("Phases", "Fill one row each, in order; leave spare rows empty. Beside: the rates of each axis.")
    top, taken = sheet.row, sheet.folded + 1
    workings = with_all_units([phase_workings(tables) for tables in axes])
    sheet.heads("Workings", [q._replace(source="") for q in workings], taken)  # whose equations are with the cells
    sheet.row = top
    sheet.heads("", with_all_units(columns))
    for tables, own in zip(axes, columns, strict=True):
        top, i, unit = sheet.row, tables.axis.number, tables.axis.given.unit
        cell = CELLS["timing_sheet"]
        sheet.put(cell("axis{i}_name", tables.axis.given.name, i=i), sheet.row, FIRST)
        sheet.put(constant(f"axis{i}_unit", "Moves in", "", "", unit, align="left"), sheet.row, FIRST + 1)
        sheet.row += 1
        title = f"Phases of axis {i}"
        block = sheet.table(tables.name, title, tables.rows, *own, rules=[AT_REST], heads=False)
        sheet.workings(block, tables.taken, "Workings", taken, *phase_workings(tables))
        draw_lanes(sheet, machine, tables.axis, top, sheet.folded - LANES)


def with_all_units(each: list[list[Quantity]]) -> list[Quantity]:
    """Return the columns of the first of like tables, each with the units of all of them."""
    units = [", ".join(dict.fromkeys(q.unit for q in same if q.unit)) for same in zip(*each, strict=True)]
    return [q._replace(unit=unit) for q, unit in zip(each[0], units, strict=True)]


def pace(machine: MachineView) -> list[Quantity]:
    """Return the rows of a machine with a master shaft, or without it."""
    over, rate = machine.over, machine.given.per_minute
    if not over.measured:
        return [
            CELLS["pace"]("timing_rate", rate),
            CELLS["pace"]("timing_cycle", machine.time),
            CELLS["pace"]("omega", machine.speed),
            *compare_extremes(machine)[0],
        ]
    what, symbol, forces = ("Time", "t_c", " and process forces") if over.timed else ("Length", f"{over.symbol}_c", "")
    label = "Speed of a turn a cycle" if over.timed else f"A turn a cycle, per {over.unit}"
    cell = CELLS["pace 2"].sharing(what=what, symbol=symbol, unit=over.unit, forces=forces, over=over, label=label)
    return [
        cell("timing_cycle", over.length, format=over.format),
        constant("timing_unit", "Abscissa in", "", "", over.unit, align="left", source=over.name),
        *([cell("timing_rate", rate)] if over.timed else []),
        cell("omega", machine.speed),
        cell(TAKEN, over.length, format=over.format),
    ]


def draw_diagram(sheet: Sheet, machine: MachineView, axes: list[AxisTables]) -> None:
    """Place the timing diagram beside the entries: a lane for each axis over the master angle, and for each switch."""
    count, over = len(machine.given.switches), machine.over
    n = len(machine.axes) + count
    lines = [curve(axis, over.column, "lane") for axis in machine.axes]
    lines += map(draw_switch, range(1, count + 1))
    bars = ", bars where a switch is on" if count else ""
    about = f"Timing diagram: rises, rests and returns of each axis over {over.cycle}{bars}"
    chart = Chart("Timing diagram", over.title, "", tuple(lines), about, over.axis(60), (0, n, 1), lanes=True)
    chart = replace(chart, notes=tuple(note for tables in axes for note in note_movements(tables)))
    height = max(sheet.row - TOP, 5 + n + n // 2)
    sheet.chart(chart, DIAGRAM, TOP, sheet.folded - DIAGRAM, height)
    sheet.row = max(sheet.row, TOP + height)


def draw_switch(number: int) -> Series:
    """Return the bars of a switch over the cycle."""
    x, y = (f"[switch_lanes.{letter}{number}]" for letter in "xy")
    return Series(f"[switches.name.{number}]", x, y, color=SWITCH, thick=True)


def note_movements(tables: AxisTables) -> Iterator[Series]:
    """Yield the lift and the law of each movement of an axis, below its middle in the timing diagram."""
    name, i = tables.name, tables.axis.number
    for k in range(1, tables.rows + 1):
        x, y = f"[{name}_taken.place.{k}]", f"[cycle{i}_note.cycle{i}_note]"
        yield Series(f"[{name}.lift:law.{k}]", x, y, points=True, color=colour(i), is_note=True)


def curve(axis: MovingAxis, x: str, column: str) -> Series:
    """Return a line of an axis over the cycle, by the columns of its samples; its name has the unit."""
    i, name = axis.number, f"=axis{axis.number}_name:axis{axis.number}_unit"
    return Series(name, f"[cycle{i}.{x}]", f"[cycle{i}.{column}]", color=colour(i))


def draw_lanes(sheet: Sheet, machine: MachineView, axis: MovingAxis, top: int, column: int) -> None:
    """Place velocity, acceleration and jerk of an axis below each other, from a row on, each in its own scale."""
    over, i = machine.over, axis.number
    rates = zip(CURVES.items(), over.symbols[1:], over.rates(axis.given.unit), strict=True)
    height = max(LANE_ROWS, (sheet.row - top) // len(CURVES))
    for k, ((name, word), symbol, unit) in enumerate(rates):
        about = f"{word.capitalize()} of axis {i} over the {over.name}"
        line, title = curve(axis, over.column, name), f"{symbol} [{unit}]"
        lane = Chart(title, "", "", (line,), about, over.axis(60), legend=False, is_lane=True)
        sheet.chart(lane, column, top + k * height, LANES, height)
    sheet.row = max(sheet.row, top + height * len(CURVES))


def units(machine: MachineView, order: int = 0) -> str:
    """Return the units of the positions of all axes (order 0), or of a derivative, as they are shown."""
    each = dict.fromkeys(axis.given.unit for axis in machine.axes)
    return ", ".join((unit, *machine.over.rates(unit))[order] for unit in each)


def axes_table(sheet: Sheet, machine: MachineView) -> None:
    """Declare the names of the axes, what each must do and what it comes to; behind what is printed shifts as taken."""
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
        cell("travel", travels, scale=max(axis.greatest_lift for axis in axes) or 1.0, **parts),
        cell("low", lows, scale=size, **parts),
        cell("high", highs, scale=size, **parts),
        cell("v", [axis.max_velocity for axis in axes], symbol=over.symbols[1], unit=speed),
        cell("a", [axis.max_acceleration for axis in axes], symbol=over.symbols[2], unit=acceleration),
        *compare_extremes(machine)[1],
    )
    sheet.workings(table, "axes_taken", "Workings", sheet.folded + 1, *taken_columns(machine))


def in_units(axes: list[MovingAxis]) -> dict[str, list[Any]]:
    """Return parts of formulas: the number of each axis, and what turns m or rad into the unit of its entries."""
    travels = [axis.given.unit == "mm" for axis in axes]
    return {
        "i": [axis.number for axis in axes],
        "opens": ["" if travel else "DEGREES(" for travel in travels],
        "closes": ["*1000" if travel else ")" for travel in travels],
    }


def taken_columns(machine: MachineView) -> list[Quantity]:
    """Return the columns of what the cells compute with: shift, begin, greatest lift, jumps of the position."""
    cell, axes, over, unit = CELLS["axes_taken"], machine.axes, machine.over, units(machine)
    lifts, parts = [axis.greatest_lift for axis in axes], in_units(axes)
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


def compare_extremes(machine: MachineView) -> tuple[list[Quantity], list[Quantity]]:
    """Return the rows of a rate to show extremes at too, and the columns of these; none if it is not entered."""
    cell, axes, symbols = CELLS["compared"], machine.axes, machine.over.symbols
    rate = getattr(machine.given.master, "compare_rate", None)
    if rate is None:
        return [], []
    faster = rate / machine.given.per_minute
    (_, v_unit, a_unit) = (units(machine, k) for k in range(3))
    v, a = [axis.max_velocity for axis in axes], [axis.max_acceleration for axis in axes]
    return (
        [cell("timing_compared", rate), cell("omega_compared", math.tau * si(rate, PER_MINUTE))],
        [
            cell("vc", [x * faster for x in v], symbols=symbols, unit=v_unit),
            cell("ac", [x * faster**2 for x in a], symbols=symbols, unit=a_unit),
        ],
    )
