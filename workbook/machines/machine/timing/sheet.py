"""The sheet Timing: the axes over a turn of the master shaft, or over a cycle."""

from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series, colour
from workbook.book.declare import FIRST, Book, Quantity, Sheet, constant
from workbook.entries.abscissa import TAKEN, unit_cell_name
from workbook.entries.facts import entry_cells
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.timing.axes import axes_table, compared_rate, rate_to_compare
from workbook.machines.machine.timing.cycle import CURVES, LANE_SHARE
from workbook.machines.machine.timing.phases import axis_checks, phase_columns, phases_table
from workbook.machines.machine.timing.stops import stop_cell, stops_of
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)
MARKS = {"mm": "mm", "°": "deg"}

# the row and the column that the diagram begins at; rows of the other charts
TOP, DIAGRAM, CURVE_ROWS = 5, 11, 12
LABELS = 32.0  # width of the column of labels
RATES = 12.5  # width of the columns of velocity, acceleration and jerk, whose units are long
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
    sheet.widths = {FIRST: LABELS} | dict.fromkeys(range(FIRST + 8, FIRST + 12), RATES)
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
