"""The sheet Timing: the axes over a turn of the master shaft, or over a cycle."""

from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, calc, constant
from workbook.entries.abscissa import TAKEN, Abscissa, unit_cell_name
from workbook.entries.facts import entry_cells
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.timing.axes import axes_table, rate_to_compare
from workbook.machines.machine.timing.cycle import CURVES, LANE_SHARE
from workbook.machines.machine.timing.phases import axis_checks, phases_table
from workbook.machines.machine.timing.stops import stop_cell, stops_of
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)
MARKS = {"mm": "mm", "°": "deg"}

PHASE, PHASE_MEASURED, PASSING = 13, 12, 4
"""columns of what is entered of a phase and comes out of it, over a length, and where movements hand over at speed"""


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
    columns = PHASE_MEASURED if machine.over.measured else PHASE
    columns += PASSING if any(axis.ends is not None for axis in axes) else 0
    draw_diagram(sheet, machine, columns)
    axes_table(sheet, machine, columns)
    for tables in axes:
        i, unit = tables.axis.number, tables.axis.given.unit
        sheet.heading(f"Axis {i}")
        sheet.rows(
            cell("axis{i}_name", tables.axis.given.name, i=i),
            constant(f"axis{i}_{MARKS[unit]}", "Moves in", "", "", unit, align="left"),
            *map(stop_cell, stops_of(tables.axis)),
        )
        phases_table(sheet, tables)
        axis_checks(sheet, tables)
    draw_curves(sheet, machine, columns)
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(
        cell("eps", machine.near),
        cell("timing_end", 360.0 - 2.0 * machine.near),
        cell("timing_lane", LANE_SHARE),
    )
    sheet.print_columns, sheet.folded = FIRST + columns - 1, FIRST + columns


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
    return [
        CELLS["pace 2"](
            "timing_cycle",
            over.length,
            what=what,
            symbol=symbol,
            unit=over.unit,
            forces=forces,
            over=over,
            format=over.format,
        ),
        constant(unit_cell_name(over.unit), "Abscissa in", "", "", over.unit, align="left", source=over.name),
        *([CELLS["pace 2"]("timing_rate", rate)] if over.timed else []),
        CELLS["pace 2"](
            "omega",
            machine.speed,
            label="Speed of a turn a cycle" if over.timed else f"A turn a cycle, per {over.unit}",
            over=over,
            symbol=symbol,
        ),
        calc(
            TAKEN,
            f"{what} of a cycle, as taken",
            "",
            over.unit,
            "=IF(timing_cycle>0,timing_cycle,360)",
            over.length,
            format=over.format,
            source="by it places become degrees of that turn",
        ),
    ]


def draw_diagram(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Place the timing diagram: a lane for each axis over the master angle."""
    count, over = len(machine.given.switches), machine.over
    n = len(machine.axes) + count
    lines = [curve(a, over.column, "lane") for a in machine.axes]
    lines += [Series(f"=switch{i}_name", f"[switch_lanes.x{i}]", f"[switch_lanes.y{i}]") for i in range(1, count + 1)]
    bars = ", bars where a switch is on" if count else ""
    about = f"Timing diagram: rises, rests and returns of each axis over {over.cycle}{bars}"
    chart = Chart("Timing diagram", over.title, "", tuple(lines), about, over.axis(30), (0, n, 1), lanes=True)
    sheet.row += 1
    height = max(12, 5 + n + n // 2)
    sheet.chart(chart, FIRST, sheet.row, columns, height)
    sheet.row += height


def curve(axis: MovingAxis, x: str, column: str) -> Series:
    """Return a line of an axis over the cycle, by the columns of its samples."""
    i = axis.number
    return Series(f"=axis{i}_name", f"[cycle{i}.{x}]", f"[cycle{i}.{column}]")


def draw_curves(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Place charts of position, velocity and acceleration, a row for travelling axes, another for turning; of jerk."""
    sheet.heading("Position, velocity and acceleration over the cycle")
    over, moving = machine.over, dict.fromkeys(axis.given.unit for axis in machine.axes)
    for unit in moving:
        of = {"mm": " of travelling axes", "°": " of turning axes"}[unit] if len(moving) > 1 else ""
        charts = []
        for (column, word, *_), symbol, shown_in in zip(CURVES, over.symbols, (unit, *over.rates(unit)), strict=True):
            lines = tuple(curve(axis, over.column, column) for axis in machine.axes if axis.given.unit == unit)
            title = f"{word.capitalize()}{of}"
            about = f"{title} over the {over.name}, a line for each axis"
            charts.append(Chart(title, over.title, f"{symbol} [{shown_in}]", lines, about, over.axis(60)))
        sheet.chart_row(*charts[:3], width=(columns + 2) // 3, height=18)
    sheet.heading("Jerk of each axis over the cycle, between its jumps")
    jerks = [jerk_chart(axis, over) for axis in machine.axes]
    for k in range(0, len(jerks), 3):
        sheet.chart_row(*jerks[k : k + 3], width=(columns + 2) // 3, height=18)


def jerk_chart(axis: MovingAxis, over: Abscissa) -> Chart:
    """Return the chart of an axis' jerk."""
    title = f"Jerk of axis {axis.number}"
    y = f"{over.symbols[-1]} [{over.rates(axis.given.unit)[-1]}]"
    about = f"{title} over the {over.name}"
    return Chart(title, over.title, y, (curve(axis, over.column, "j"),), about, over.axis(60))
