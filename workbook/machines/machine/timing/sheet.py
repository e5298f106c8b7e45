"""The Timing sheet: the axes over one turn of the master shaft or a cycle, their phases, movements and diagram."""

from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, calc, constant, given, result
from workbook.entries.abscissa import TAKEN, in_unit
from workbook.entries.units import shown, si
from workbook.machines.machine.from_names import unit_name
from workbook.machines.machine.motion.tables import AxisRows
from workbook.machines.machine.switches.view import named
from workbook.machines.machine.timing.phases import axis_checks, phases_table
from workbook.machines.machine.view import MovingAxis, Whole

LANE_SHARE = 0.8
PHASE, PHASE_MEASURED, PASSING = 13, 12, 4
"""columns of what is entered of a phase and comes out of it, over a length, and where movements hand over at speed"""
CURVES = ("Position", "Velocity", "Acceleration")


def timing_sheet(book: Book, machine: Whole, axes: list[AxisRows]) -> None:
    """Declare the sheet: what to enter at the top, the diagram beside it, the phases of each axis below."""
    sheet = book.sheet("Timing", f"The axes over {machine.over.cycle}: phases, movements, timing diagram.")
    sheet.heading("Enter")
    weight = given("gravity", "Gravity", "g", "m/s²", machine.machine.gravity, "gravity", format="0.0####",
                   source="of all drives")  # fmt: skip
    sheet.rows(*(of_length(machine) if machine.over.measured else at_rate(machine)),
               *([weight] if machine.machine.weighs else []))  # fmt: skip
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
        )
        phases_table(sheet, one)
        axis_checks(sheet, one)
    draw_curves(sheet, machine, columns)
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(
        calc("eps", "Tolerance of an angle", "ε", "°",
             "=360*break_eps", machine.near, format="0E+00",
             source="an angle this close to a phase's start is taken as the start"),
        calc("timing_end", "End of a cycle", "", "°", "=360-2*eps", 360.0 - 2.0 * machine.near, format="0.0##",
             source="just before it: at 360° a cycle ends, the next begins behind it"),
        constant("timing_lane", "Height of an axis in the diagram", "", "",
                 LANE_SHARE, format="0.0", source="as a share of its lane"),
    )  # fmt: skip
    sheet.print_columns, sheet.folded = FIRST + columns - 1, FIRST + columns


def at_rate(machine: Whole) -> list[Quantity]:
    """Return the rows of a machine with a master shaft."""
    return [
        given("timing_rate", "Production rate", "N", "cycles/min",
              machine.machine.per_minute, "master.rate", format="0.0##", source="one a turn of the master shaft"),
        calc("timing_cycle", "Time of one turn", "t_c", "s", "=60/timing_rate", machine.time, source="60 / n"),
        calc("omega", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()*timing_rate/60", machine.speed, source="2π n / 60"),
    ]  # fmt: skip


def of_length(machine: Whole) -> list[Quantity]:
    """Return the rows of a machine without one."""
    over, forces = machine.over, " and process forces" if machine.over.paced else ""
    what, symbol = ("Time", "t_c") if over.paced else ("Length", f"{over.symbol}_c")
    return [
        given("timing_cycle", f"{what} of a cycle", symbol, over.unit, over.length, "master.cycle",
              format=over.format, source=f"phases, shifts, switches{forces} are in {over.unit} of it"),
        constant(in_unit(over.unit), "Abscissa in", "", "", over.unit, align="left", source=over.name),
        *([calc("timing_rate", "Production rate", "N", "cycles/min", "=60/timing_cycle", machine.machine.per_minute,
                source="60 / t_c")] if over.paced else []),
        calc("omega", "Speed of a turn a cycle" if over.paced else f"A turn a cycle, per {over.unit}", "ω",
             f"rad/{over.unit}", "=2*PI()/timing_cycle", machine.speed,
             source=f"2π / {symbol}; workings count a cycle as one turn, of 360°"),
        calc(TAKEN, f"{what} of a cycle, as taken", "", over.unit, "=IF(timing_cycle>0,timing_cycle,360)", over.length,
             format=over.format, source="by it places become degrees of that turn"),
    ]  # fmt: skip


def units(machine: Whole, order: int = 0) -> str:
    """Return the units of the positions of all axes (order 0), or of a derivative, as they are shown."""
    each = dict.fromkeys(axis.given.unit for axis in machine.axes)
    return ", ".join((unit, *machine.over.rates(unit))[order] for unit in each)


def axes_table(sheet: Sheet, machine: Whole, columns: int) -> None:
    """Declare the names of the axes, what each must do and what it comes to; shifts as taken behind so many columns."""
    axes, n, over = machine.axes, len(machine.axes), machine.over

    def each(formula: str) -> list[str]:
        return [f"={outward(axis, formula.format(f'axis{axis.number}'))}" for axis in axes]

    _, y1, y2, _ = over.symbols

    def of(column: str) -> list[str]:
        return [f"=MAX([axis{axis.number}.{column}])" for axis in axes]

    unit, size = units(machine), max(shown(a.motion.size(0), a.unit) for a in axes)
    sheet.row += 1
    table = sheet.table(
        "axes", "Axes", n,
        given("group", "group", "", "", [a.given.group for a in axes], "axes.*.group"),
        constant("k", "number", "k", "", [a.number for a in axes]),
        given("name", "axis", "", "", [a.given.name for a in axes], "axes.*.name"),
        given("closes", "over a cycle", "", "", [a.given.closes for a in axes], "axes.*.closes",
              source="returns to its position, feeds on, or open"),
        given("smooth", "must be continuous", "", "", [a.given.smoothness for a in axes], "axes.*.smoothness",
              source="velocity, acceleration, jerk"),
        given("shift", "shift", "", over.unit, [a.typed.shift for a in axes], "axes.*.shift", format=over.format,
              source="later than its phases say"),
        given("position", "begins at", "y_0", unit, [a.given.position for a in axes], "axes.*.position",
              format="0.0##"),
        result("travel", "travel a cycle", "Σh", unit,
             each("SUM([{0}.h])"), [shown(a.motion.lifts_sum, a.unit) for a in axes]),
        result("low", "lowest position", "", unit,
             each("MIN([{0}_steps.low])"), [shown(a.motion.reach[0], a.unit) for a in axes], scale=size),
        result("high", "highest position", "", unit,
             each("MAX([{0}_steps.high])"), [shown(a.motion.reach[1], a.unit) for a in axes], scale=size),
        result("v", "greatest velocity", y1, units(machine, 1), of("v"), [a.fastest for a in axes]),
        result("a", "greatest acceleration", y2, units(machine, 2), of("a"), [a.hardest for a in axes]),
    )  # fmt: skip
    sheet.workings(
        table, "axes_taken", "Workings", FIRST + columns + 1,
        calc("late", "shift, as taken", "", "°", f"={over.in_degrees('[shift]')}+0",
             [a.given.shift for a in axes], format="0.0##"),
        calc("y0", "begin, as taken", "y_0", ", ".join(dict.fromkeys(a.base for a in axes)),
             ["=[position]/1000" if a.given.unit == "mm" else "=RADIANS([position])" for a in axes],
             [si(a.given.position, a.unit) for a in axes], source="conversion"),
        *gaps(machine),
    )  # fmt: skip


def gaps(machine: Whole) -> list[Quantity]:
    """Return the columns of each axis' greatest lift, what a law leaves of one, and where the cycle ends."""
    axes, last, unit = machine.axes, machine.over.in_degrees("MAX([{0}.stop])"), units(machine)
    lift = "MAX(MAX([{0}.h]),0-MIN([{0}.h]))"
    lack = "MAX(MAX([{0}.lack]),0-MIN([{0}.lack]))"
    gap = f"SUM([{{0}}.h])-IF(360-{last}>check_zero,0,INDEX([{{0}}.lack],COUNT([{{0}}.stop])))"

    def each(formula: str) -> list[str]:
        named = [formula.format(f"axis{axis.number}") for axis in axes]
        return [f"={outward(axis, f'({text})')}" for axis, text in zip(axes, named, strict=True)]

    lifts = [max(abs(phase.lift) for phase in a.motion.phases) for a in axes]
    most = [shown(one, a.unit) for one, a in zip(lifts, axes, strict=True)]
    return [
        calc("lift", "greatest lift", "h", unit, each(lift), most),
        calc("lack", "largest jump of y", "Δy", unit, each(lack), [shown(a.lack, a.unit) for a in axes],
             scale=max(most) or 1.0),
        calc("gap", "ends from its begin", "", unit, each(gap), [shown(a.motion.gap, a.unit) for a in axes],
             scale=max(most) or 1.0),
    ]  # fmt: skip


def outward(axis: MovingAxis, formula: str) -> str:
    """Return the formula that shows in the unit of an axis' entries what is in m or rad."""
    return f"{formula}*1000" if axis.given.unit == "mm" else f"DEGREES({formula})"


def draw_diagram(sheet: Sheet, machine: Whole, columns: int) -> None:
    """Place the timing diagram: one lane an axis over the master angle."""
    n = len(machine.axes) + len(machine.lanes)
    over = machine.over
    lines = [sampled(a, over.column, "lane") for a in machine.axes]
    lines += [
        Series(f"={named(one.number)}", f"[switch_lanes.x{one.number}]", f"[switch_lanes.y{one.number}]")
        for one in machine.lanes
    ]
    bars = ", bars where a switch is on" if machine.lanes else ""
    chart = Chart(
        "Timing diagram", over.title, "", tuple(lines),
        f"Timing diagram: rises, rests and returns of each axis over {over.cycle}{bars}",
        over.axis(30), (0, n, 1), lanes=True,
    )  # fmt: skip
    sheet.row += 1
    height = max(12, 5 + n + n // 2)
    sheet.chart(chart, FIRST, sheet.row, columns, height)
    sheet.row += height


def sampled(axis: MovingAxis, x: str, column: str) -> Series:
    """Return a line of an axis over the cycle, by the columns of its samples."""
    i = axis.number
    return Series(f"=axis{i}_name", f"[cycle{i}.{x}]", f"[cycle{i}.{column}]")


def draw_curves(sheet: Sheet, machine: Whole, columns: int) -> None:
    """Place the charts of position, velocity and acceleration: a row for travelling axes, one for turning axes."""
    sheet.heading("Position, velocity and acceleration over the cycle")
    over, symbols = machine.over, ("y", *machine.over.symbols[1:])
    moving = dict.fromkeys(axis.given.unit for axis in machine.axes)
    groups = {unit: [axis for axis in machine.axes if axis.given.unit == unit] for unit in moving}
    for unit, axes in groups.items():
        of = {"mm": " of travelling axes", "°": " of turning axes"}.get(unit, "") if len(groups) > 1 else ""
        charts = []
        for column, word, symbol, shown_in in zip("yva", CURVES, symbols, (unit, *over.rates(unit)), strict=False):
            lines = tuple(sampled(axis, over.column, column) for axis in axes)
            about = f"{word}{of} over the {over.name}, a line for each axis"
            charts.append(Chart(f"{word}{of}", over.title, f"{symbol} [{shown_in}]", lines, about, over.axis(60)))
        sheet.chart_row(*charts, width=(columns + 2) // 3, height=18)
