"""The sheets Timing and Cycle: the axes over one turn of the master shaft or a cycle, and each sample by sample."""

import math
from typing import Any

from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, calc, constant, given, result
from workbook.entries.abscissa import TAKEN, Abscissa, unit_cell_name
from workbook.fields.texts import sheet_title
from workbook.fields.units import DEGREE, PER_MINUTE, shown, si
from workbook.machines.machine.file_layout import COMPARED, switch_name, unit_name
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.timing.phases import axis_checks, phases_table
from workbook.machines.machine.timing.stops import stop_cell, stops_of
from workbook.machines.machine.view import MachineView, MovingAxis
from workbook.motion.exported import Exportable, ShiftCells
from workbook.motion.pieces import POSITION, finding, sampled
from workbook.selection.limits import limit_cells

LANE_SHARE = 0.8  # of the height of a lane that an axis takes. Source: S1, 'Timing diagram for a cutting machine'
PHASE, PHASE_MEASURED, PASSING = 13, 12, 4
"""columns of what is entered of a phase and comes out of it, over a length, and where movements hand over at speed"""
CURVES = (
    ("y", "position", "", "", ""),
    ("v", "velocity", "omega", "y' ω", "dy/dx"),
    ("a", "acceleration", "omega^2", "y'' ω²", "d²y/dx²"),
    ("j", "jerk", "omega^3", "y''' ω³, between jumps", "d³y/dx³, between jumps"),
)
"""a sampled axis: its column, what it is called; its factor, and its equation over time and over all else"""
EARLIER = "([theta]-@late-[p])*@lap"  # the travel of the turns that its phases have ended before


def timing_sheet(book: Book, machine: MachineView, axes: list[AxisTables]) -> None:
    """Declare the sheet: what to enter at the top, the diagram beside it, the phases of each axis below."""
    sheet = book.sheet("Timing", f"The axes over {machine.over.cycle}: phases, movements, timing diagram.")
    sheet.heading("Enter")
    weight = given(
        "gravity", "Gravity", "g", "m/s²", machine.given.gravity, "gravity", format="0.0####", source="of all drives"
    )
    driven = any(axis.given.motor for axis in machine.axes)
    limits = limit_cells(machine.given.limits) if driven else ()
    sheet.rows(*pace(machine), *([weight] if machine.given.weighs else []), *limits)
    columns = PHASE_MEASURED if machine.over.measured else PHASE
    columns += PASSING if any(one.ends is not None for one in axes) else 0
    draw_diagram(sheet, machine, columns)
    axes_table(sheet, machine, columns)
    for one in axes:
        i = one.axis.number
        sheet.heading(f"Axis {i}")
        sheet.rows(
            calc(f"axis{i}_name", "Name", "", "", f"=[axes.name.{i}]", one.axis.given.name, align="left"),
            constant(unit_name(i, one.axis.given.unit), "Moves in", "", "", one.axis.given.unit, align="left"),
            *map(stop_cell, stops_of(one.axis)),
        )
        phases_table(sheet, one)
        axis_checks(sheet, one)
    draw_curves(sheet, machine, columns)
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(
        calc("eps", "Tolerance of an angle", "ε", "°", "=360*break_eps", machine.near, format="0E+00",
             source="an angle this close to a phase's start is taken as the start"),
        calc("timing_end", "End of a cycle", "", "°", "=360-2*eps", 360.0 - 2.0 * machine.near, format="0.0##",
             source="just before it: at 360° a cycle ends, the next begins behind it"),
        constant("timing_lane", "Height of an axis in the diagram", "", "",
                 LANE_SHARE, format="0.0", source="as a share of its lane"),
    )  # fmt: skip
    sheet.print_columns, sheet.folded = FIRST + columns - 1, FIRST + columns


def pace(machine: MachineView) -> list[Quantity]:
    """Return the rows of a machine with a master shaft, or of one without."""
    over, rate = machine.over, machine.given.per_minute
    if not over.measured:
        return [
            given("timing_rate", "Production rate", "N", "cycles/min", rate, "master.rate", format="0.0##",
                  source="one a turn of the master shaft"),
            calc("timing_cycle", "Time of one turn", "t_c", "s", "=60/timing_rate", machine.time, source="60 / n"),
            calc("omega", "Speed of the master shaft", "ω", "rad/s", "=2*PI()*timing_rate/60", machine.speed,
                 source="2π n / 60"),
            *rate_to_compare(machine),
        ]  # fmt: skip
    what, symbol, forces = ("Time", "t_c", " and process forces") if over.timed else ("Length", f"{over.symbol}_c", "")
    return [
        given("timing_cycle", f"{what} of a cycle", symbol, over.unit, over.length, "master.cycle",
              format=over.format, source=f"phases, shifts, switches{forces} are in {over.unit} of it"),
        constant(unit_cell_name(over.unit), "Abscissa in", "", "", over.unit, align="left", source=over.name),
        *([calc("timing_rate", "Production rate", "N", "cycles/min", "=60/timing_cycle", rate, source="60 / t_c")]
          if over.timed else []),
        calc("omega", "Speed of a turn a cycle" if over.timed else f"A turn a cycle, per {over.unit}", "ω",
             f"rad/{over.unit}", "=2*PI()/timing_cycle", machine.speed,
             source=f"2π / {symbol}; workings count a cycle as one turn, of 360°"),
        calc(TAKEN, f"{what} of a cycle, as taken", "", over.unit, "=IF(timing_cycle>0,timing_cycle,360)", over.length,
             format=over.format, source="by it places become degrees of that turn"),
    ]  # fmt: skip


def units(machine: MachineView, order: int = 0) -> str:
    """Return the units of the positions of all axes (order 0), or of a derivative, as they are shown."""
    each = dict.fromkeys(axis.given.unit for axis in machine.axes)
    return ", ".join((unit, *machine.over.rates(unit))[order] for unit in each)


def axes_table(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Declare the names of the axes, what each must do and what it comes to; shifts as taken behind so many columns."""
    axes, over, unit = machine.axes, machine.over, units(machine)
    size = max(shown(a.motion.size(0), a.unit) for a in axes)
    most = [max(abs(shown(phase.lift, a.unit)) for phase in a.motion.phases) for a in axes]

    def entry(name: str, label: str, key: str, symbol: str = "", unit: str = "", **more: Any) -> Quantity:
        return given(name, label, symbol, unit, [getattr(a.typed, key) for a in axes], f"axes.*.{key}", **more)

    sheet.row += 1
    table = sheet.table(
        "axes", "Axes", len(axes),
        entry("group", "group", "group"),
        constant("k", "number", "k", "", [a.number for a in axes]),
        entry("name", "axis", "name"),
        entry("closes", "over a cycle", "closes", source="returns to its position, feeds on, or open"),
        entry("smooth", "must be continuous", "smoothness", source="velocity, acceleration, jerk"),
        entry("shift", "shift", "shift", "", over.unit, format=over.format, source="later than its phases say"),
        entry("position", "begins at", "position", "y_0", unit, format="0.0##"),
        result("travel", "travel a cycle", "Σh", unit, each(axes, "SUM([{0}.h])"),
               [shown(a.motion.lifts_sum, a.unit) for a in axes], scale=max(most) or 1.0),
        *(result(name, f"{name}est position", "", unit, each(axes, f"{end}([{{0}}_steps.{name}])"),
                 [shown(a.motion.reach[k], a.unit) for a in axes], scale=size)
          for k, (name, end) in enumerate((("low", "MIN"), ("high", "MAX")))),
        *(result(name, f"greatest {word}", over.symbols[order], units(machine, order),
                 [f"=MAX([axis{axis.number}.{name}])" for axis in axes], values)
          for order, (name, word, values) in enumerate((("v", "velocity", [a.max_velocity for a in axes]),
                                                        ("a", "acceleration", [a.max_acceleration for a in axes])), 1)),
        *extremes_compared(machine),
    )  # fmt: skip
    last = over.degrees_formula("MAX([{0}.stop])")
    gap = f"(SUM([{{0}}.h])-IF(360-{last}>check_zero,0,INDEX([{{0}}.lack],COUNT([{{0}}.stop]))))"
    sheet.workings(
        table, "axes_taken", "Workings", FIRST + columns + 1,
        calc("late", "shift, as taken", "", "°", f"={over.degrees_formula('[shift]')}+0",
             [a.given.shift for a in axes], format="0.0##"),
        calc("y0", "begin, as taken", "y_0", ", ".join(dict.fromkeys(a.base for a in axes)),
             ["=[position]/1000" if a.given.unit == "mm" else "=RADIANS([position])" for a in axes],
             [si(a.given.position, a.unit) for a in axes], source="conversion"),
        calc("lift", "greatest lift", "h", unit, each(axes, "(MAX(MAX([{0}.h]),0-MIN([{0}.h])))"), most),
        calc("lack", "largest jump of y", "Δy", unit, each(axes, "(MAX(MAX([{0}.lack]),0-MIN([{0}.lack])))"),
             [shown(a.missing_lift, a.unit) for a in axes], scale=max(most) or 1.0),
        calc("gap", "ends from its begin", "", unit, each(axes, gap), [shown(a.motion.gap, a.unit) for a in axes],
             scale=max(most) or 1.0),
    )  # fmt: skip


def compared_rate(machine: MachineView) -> float | None:
    """Return the rate (cycles/min) at which extremes are shown too, of a machine that has one."""
    return None if machine.over.measured else machine.given.master.compare_rate


def rate_to_compare(machine: MachineView) -> list[Quantity]:
    """Return the rows of the rate at which extremes are shown too, if one is entered."""
    rate = compared_rate(machine)
    return [] if rate is None else [
        given(COMPARED, "Compare at a rate of", "N_c", "cycles/min", rate, "master.compare_rate", format="0.0##",
              source="velocity and acceleration of each axis there, below"),
        calc("omega_compared", "Speed of the master shaft there", "ω_c", "rad/s", f"=2*PI()*{COMPARED}/60",
             math.tau * si(rate, PER_MINUTE), source="2π N_c / 60"),
    ]  # fmt: skip


def extremes_compared(machine: MachineView) -> list[Quantity]:
    """Return the columns of the greatest velocity and acceleration at the rate to compare at, if one is entered."""
    rate, axes, symbols = compared_rate(machine), machine.axes, machine.over.symbols
    if rate is None:
        return []
    faster = rate / machine.given.per_minute
    return [
        result("vc", "greatest velocity, at the rate to compare", symbols[1], units(machine, 1),
               f"=[v]*{COMPARED}/timing_rate", [a.max_velocity * faster for a in axes]),
        result("ac", "greatest acceleration, at the rate to compare", symbols[2], units(machine, 2),
               f"=[a]*({COMPARED}/timing_rate)^2", [a.max_acceleration * faster**2 for a in axes]),
    ]  # fmt: skip


def each(axes: list[MovingAxis], formula: str) -> list[str]:
    """Return for each axis a formula with its name, which shows in the unit of its entries what is in m or rad."""
    texts = [(axis, formula.format(f"axis{axis.number}")) for axis in axes]
    return [f"={text}*1000" if axis.given.unit == "mm" else f"=DEGREES({text})" for axis, text in texts]


def draw_diagram(sheet: Sheet, machine: MachineView, columns: int) -> None:
    """Place the timing diagram: one lane an axis over the master angle."""
    count, over = len(machine.given.switches), machine.over
    n = len(machine.axes) + count
    lines = [curve(a, over.column, "lane") for a in machine.axes]
    lines += [Series(f"={switch_name(i)}", f"[switch_lanes.x{i}]", f"[switch_lanes.y{i}]") for i in range(1, count + 1)]
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
    """Place charts of position, velocity and acceleration: a row for travelling axes, one for turning; and of jerk."""
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


def cycle_sheet(book: Book, machine: MachineView, tables: AxisTables, floor: int) -> None:
    """Declare the sheet of an axis; ``floor`` is the height of its lane in the timing diagram."""
    over, axis, i, told = machine.over, tables.axis, tables.axis.number, tables.axis.unshifted(machine.samples)
    title = sheet_title(f"Cycle {i}", [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"Axis {i} over {over.cycle}, sample by sample; what charts show.")
    unit, lowest, highest = axis.given.unit, f"[axes.low.{i}]", f"[axes.high.{i}]"
    low, high = (shown(end, axis.unit) for end in axis.motion.reach)
    by_lift = LANE_SHARE / (high - low) if high > low else 0.0
    lane = floor + by_lift * (shown(axis.motion.at(told.x).y, axis.unit) - low)
    with sheet.scoped(f"cycle{i}_"):
        sheet.rows(
            calc("@name", "Axis", "", "", f"=[axes.name.{i}]", axis.given.name, align="left"),
            calc("@late", "Its phases begin later by", "", "°", f"=[axes_taken.late.{i}]+0", axis.given.shift),
            calc("@lap", "Travel of a cycle by its angle", "", f"{unit}/°", f"=[axes.travel.{i}]/360",
                 shown(axis.motion.lifts_sum, axis.unit) / 360.0, scale=shown(axis.motion.size(0), axis.unit) / 360.0),
            calc("@scale", "Height by lift", "", f"1/{unit}",
                 f"=IF({highest}>{lowest},timing_lane/({highest}-{lowest}),0)", by_lift),
            calc("@floor", "Height of position 0", "", "", f"={floor}-@scale*{lowest}", floor - by_lift * low,
                 scale=1.0),
        )  # fmt: skip
        sheet.row += 1
        theta = constant("theta", over.angle, "θ", "°", machine.angles.tolist(), format="0.0##")
        time = calc("time", over.name, over.symbol, over.unit, "=[theta]/360*timing_cycle", over.shown(machine.angles),
                    format=over.format)  # fmt: skip
        sheet.table(
            f"cycle{i}", f"The axis over the {over.name}", len(machine.angles),
            time if over.measured else theta,
            *results(tables),
            calc("lane", "in the diagram", "", "", f"=@floor+@scale*([y]-{EARLIER})", lane),
            *([theta] if over.measured else []),
            calc("p", "angle of its phases", "", "°",
                 "=[theta]-@late-360*INT((MIN([theta],timing_end)-@late+eps)/360)", shown(told.x, DEGREE),
                 format="0.0##", source="θ − shift, less whole turns; the end has the left limit", scale=360.0),
            *finding(tables.pieces, "p", told.x),
        )  # fmt: skip
    sheet.unprinted, sheet.widths = True, {FIRST: 14}


def results(tables: AxisTables) -> list[Quantity]:
    """Return the motion of an axis in time, or by the abscissa whose length is entered alone."""
    axis, unit, over = tables.axis, tables.axis.given.unit, tables.machine.over
    timed = axis.motion.at_speed(axis.unshifted(tables.machine.samples).x, axis.speed)
    y, lift = sampled(tables.pieces, 0), over.lift(unit).shown
    rates = zip(CURVES[1:], over.symbols[1:], over.rates(unit), timed[1:], strict=True)
    return [
        result("y", "position", "y", unit, f"={f'1000*({y})' if unit == 'mm' else f'DEGREES({y})'}+{EARLIER}",
               shown(axis.at(tables.machine.samples).y, axis.unit), source=POSITION),
        *(result(name, words, symbol, shown_in, f"={factor}*({sampled(tables.pieces, order)}){lift}", axis.rate(values),
                 scale=axis.size(order), source=paced if over.timed else by_x)
          for order, ((name, words, factor, paced, by_x), symbol, shown_in, values) in enumerate(rates, 1)),
    ]  # fmt: skip


def exportable(tables: AxisTables) -> Exportable:
    """Return an axis as the sheet Export may have it."""
    axis, i, unit, over = tables.axis, tables.axis.number, tables.axis.given.unit, tables.machine.over
    units = (over.unit, unit, f"{unit}/{over.unit}", f"{unit}/{over.unit}²")
    later = ShiftCells(f"[axes_taken.late.{i}]", "eps", f"[axes.travel.{i}]", axis.unshifted, axis.motion.lifts_sum)
    return Exportable(axis.given.name, f"=[axes.name.{i}]", tables.pieces, units,
                      (over.shown(shown(1.0, DEGREE)), shown(1.0, axis.unit)),
                      "*1000" if unit == "mm" else "*180/PI()", axis.motion.size, later, over=over)  # fmt: skip
