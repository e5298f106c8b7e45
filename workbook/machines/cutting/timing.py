"""The Timing sheet: three axes over one turn of the master shaft, their movements, diagram and checks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from engine import timing as engine_timing
from engine.laws.base import Array
from engine.timing import Movement, lane, turn_time
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount
from workbook.entries.phase import AT_REST
from workbook.entries.units import DEGREE, MM, shown, si
from workbook.laws import phases as joined_phases
from workbook.laws.phases import ACCELERATION, AT_END, HIGH, JERK, LAW_NUMBER, LOW, RMS, VELOCITY, jerks
from workbook.machines.cutting.view import Cutting
from workbook.motion.cells import Cells, PieceRows
from workbook.motion.pieces import ABOUT, phase_columns, pieces_in_all, pieces_table, room_check
from workbook.motion.sampled import POSITION, derivative, finding
from workbook.motion.smooth import Asked, Joints

S1 = "S1, slide 'Timing diagram for a cutting machine'"
LANE_SHARE = 0.8
CARRIED = "=IF([span]>0,INDEX(law_{0},[no])*[h]/[span]{1},IF([k]=1,0,[{0}-1]))"
LANE = "={1}+IF([axes.high.{0}]>[axes.low.{0}],timing_lane*([y{0}]-[axes.low.{0}])/([axes.high.{0}]-[axes.low.{0}]),0)"


def cells(i: int) -> Cells:
    """Return where the motion of an axis stands."""
    return Cells(f"axis{i}", f"axis{i}_pieces", f"axis{i}_count", "360", "m", "rad", degrees=True, near="timing_eps")


def asked(machine: Cutting, i: int) -> Asked:
    """Return how smooth an axis must be."""
    units = tuple((f'"{unit}"', unit) for unit in ("m/rad", "m/rad²", "m/rad³"))
    axis, t = machine.machine.timing.axes[i - 1], f"axis{i}"
    return Asked(
        axis.smoothness, f"INDEX([axes.smooth],{i})", f"{t}_order", (f"MAX([{t}.y1])", f"MAX([{t}.y2])"),
        ('"°"', "°"), units, (f"INDEX([axes.name],{i})", axis.name),
    )  # fmt: skip


def timing_sheet(book: Book, machine: Cutting, rows: Sequence[PieceRows]) -> None:
    """Declare the sheet: what to enter at the top, the diagram beside it, the table over the cycle below."""
    timing = machine.machine.timing
    sheet = book.sheet("Timing", "Three axes over one turn of the master shaft: phases, movements, timing diagram.")
    sheet.heading("What to enter")
    sheet.rows(
        given("timing_rate", "Production rate", "n", "pieces/min",
              timing.rate, "timing.rate", format="0.0##", source="one piece a turn of the master shaft"),
        calc("timing_cycle", "Time of one turn", "t_c", "s",
             "=60/timing_rate", turn_time(machine.rate), source="60 / n"),
        calc("timing_omega", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()*timing_rate/60", machine.speed, source="2π n / 60"),
        calc("timing_eps", "Tolerance of an angle", "ε", "°",
             "=360*break_tolerance", shown(machine.axes[0].motion.tolerance, DEGREE), format="0E+00",
             source="an angle this near to a phase's begin counts as on it"),
        constant("timing_lane", "Height of an axis in the diagram", "", "",
                 LANE_SHARE, format="0.0", source="as a share of its lane"),
    )  # fmt: skip
    axes_table(sheet, machine)
    draw_diagram(sheet, range(1, len(timing.axes) + 1))
    sheet.row = max(sheet.row, 26)
    joints = [Joints(found, axis.motion, asked(machine, i))
              for i, (axis, found) in enumerate(zip(machine.axes, rows, strict=True), 1)]  # fmt: skip
    for i, (of_axis, of_joints) in enumerate(zip(rows, joints, strict=True), 1):
        phases(sheet, machine, i, of_axis)
        joined(sheet, machine, i, of_joints)
    draw_curves(sheet, range(1, len(timing.axes) + 1))
    sheet.heading("Table over the cycle")
    cycle(sheet, machine, rows)
    sheet.heading("Workings: the motions as pieces", ABOUT)
    room = machine.room
    for i, (axis, of_axis, of_joints) in enumerate(zip(machine.axes, rows, joints, strict=True), 1):
        sheet.rows(pieces_in_all(of_axis), of_joints.order())
        columns = of_joints.columns(room)
        pieces_table(sheet, f"Pieces of axis {i}", of_axis, room, axis.motion.size, *columns)
    sheet.print_columns = 17


def axes_table(sheet: Sheet, machine: Cutting) -> None:
    """Declare the names of the axes and what each comes to."""
    axes = machine.machine.timing.axes
    moves = [axis.movements(machine.speed) for axis in machine.axes]
    lows, highs = zip(*(shown(np.array(axis.motion.reach), MM).tolist() for axis in machine.axes), strict=True)

    def each(formula: str) -> list[str]:
        return [formula.format(i) for i in range(1, len(axes) + 1)]

    sheet.row += 1
    sheet.table(
        "axes", "Axes", len(axes),
        given("group", "group", "", "", [a.group for a in axes], "timing.axes.*.group"),
        given("name", "axis", "", "", [a.name for a in axes], "timing.axes.*.name"),
        given("closes", "closes in", "", "",
              [a.closes for a in axes], "timing.axes.*.closes", source="a feed does not come back"),
        given("smooth", "must be continuous", "", "",
              [a.smoothness for a in axes], "timing.axes.*.smoothness", source="velocity, acceleration, jerk"),
        calc("travel", "travel a cycle", "Σh", "mm",
             each("=SUM([axis{0}.lift])"), [shown(axis.motion.lifts_sum, MM) for axis in machine.axes]),
        calc("low", "lowest position", "", "mm", each("=MIN([axis{0}.low])*1000"), list(lows)),
        calc("high", "highest position", "", "mm", each("=MAX([axis{0}.high])*1000"), list(highs)),
        result("v", "greatest velocity", "ẏ_max", "m/s",
               each("=MAX([axis{0}.v])"), [max((m.v_max for m in found), default=0.0) for found in moves]),
        result("a", "greatest acceleration", "ÿ_max", "m/s²",
               each("=MAX([axis{0}.a])"), [max((m.a_max for m in found), default=0.0) for found in moves]),
    )  # fmt: skip


def phases(sheet: Sheet, machine: Cutting, i: int, rows: PieceRows) -> None:
    """Declare the phases of one axis: what is entered, what each movement comes to, how the phases join."""
    axis, engine_axis, n = machine.machine.timing.axes[i - 1], machine.axes[i - 1], machine.machine.sizes.phases
    motion, moves = engine_axis.motion, {m.phase: m for m in engine_axis.movements(machine.speed)}
    begins, ends = zip(*motion.ends, strict=True)
    lows, highs = zip(*motion.reaches, strict=True)
    *inner, wrap = motion.junctions()
    junctions = [wrap, *inner]  # each where its phase begins
    laws = [p.law for p in axis.phases]
    key = f"timing.axes.{i - 1}.phases.*"

    def entered(name: str) -> list[Any]:
        return filled([getattr(p, name) for p in axis.phases], n, None)

    def of(figure: Callable[[Movement], float]) -> list[float]:
        return [figure(moves[k]) if k in moves else 0.0 for k in range(n)]

    sheet.heading(f"Axis {i}")
    sheet.rows(
        calc(f"axis{i}_name", "Axis and its group", "", "",
             f'=INDEX([axes.name],{i})&", "&INDEX([axes.group],{i})', f"{axis.name}, {axis.group}", align="left"),
    )  # fmt: skip
    sheet.table(
        f"axis{i}", f"Phases of axis {i}: fill one row each, in order; leave spare rows empty", n,
        calc("kind", "phase", "", "",
             joined_phases.kind("stop"), joined_phases.kinds(laws, [p.lift for p in axis.phases], n)),
        given("start", "from", "", "°", entered("start"), f"{key}.start", format="0.0##"),
        given("stop", "to", "", "°", entered("stop"), f"{key}.stop", format="0.0##"),
        given("lift", "lift", "h", "mm", entered("lift"), f"{key}.lift", format="0.0##"),
        given("law", "law", "", "", entered("law"), f"{key}.law", choices="=law_code"),
        result("y1", "geometric velocity", "y'max", "m/rad", VELOCITY, of(lambda m: m.y1_max), source="C_v h/δ"),
        result("y2", "geometric acceleration", "y''max", "m/rad²",
               ACCELERATION, of(lambda m: m.y2_max), source="C_a h/δ²"),
        result("y3", "geometric jerk", "y'''max", "m/rad³", JERK, jerks(of(lambda m: m.y3_max)), source="C_j h/δ³"),
        result("v", "velocity", "ẏmax", "m/s", "=[y1]*timing_omega", of(lambda m: m.v_max), source="y' ω"),
        result("a", "acceleration", "ÿmax", "m/s²", "=[y2]*timing_omega^2", of(lambda m: m.a_max), source="y'' ω²"),
        result("j", "jerk", "j_max", "m/s³",
               '=IF(ISNUMBER([y3]),[y3]*timing_omega^3,"∞")', jerks(of(lambda m: m.j_max)), source="y''' ω³"),
        result("rms", "RMS acceleration", "ÿrms", "m/s²",
               f"={RMS}*timing_omega^2", of(lambda m: m.a_rms), source="C_a,rms h/δ² ω²"),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "",
             LAW_NUMBER, joined_phases.law_numbers(laws, machine.machine.laws, n), format="0"),
        calc("h", "lift", "h", "m",
             "=[lift]/1000", filled([p.lift for p in motion.phases], n), source="conversion"),
        calc("span", "duration", "δ", "rad",
             '=IF([stop]="",0,RADIANS([stop]-[start]))', filled([p.duration for p in motion.phases], n),
             source="conversion"),
        calc("begin", "begins at", "", "°",
             '=IF([stop]="",360,[start])', filled([p.start for p in axis.phases], n, 360.0), format="0.0##"),
        calc("y0", "position at begin", "y_0", "m",
             "=IF([k]=1,0,[y0-1]+[h-1])", filled([begin.y for begin in begins], n, motion.lifts_sum),
             source="lifts before"),
        *(calc(name, f"{word} position", "", "m", formula.format(0), filled(values, n))
          for name, word, formula, values in (("low", "lowest", LOW, lows), ("high", "highest", HIGH, highs))),
        calc("gap", "gap before", "", "°",
             '=IF([stop]="",0,[start]-IF([k]=1,0,[stop-1]))', filled([], n), scale=360.0),
        calc("backwards", "runs backwards", "", "",
             '=IF([stop]="",0,IF([stop]>[start],0,1))', 0, format="0;;", source="1 where it does"),
        calc("parted", "does not follow on", "", "",
             "=IF(ABS([gap])<check_zero,0,1)", 0, format="0;;", source="1 where it does not"),
        calc("v0", "y' at begin", "", "m/rad",
             AT_END.format("v0", ""), filled([begin.y1 for begin in begins], n)),
        calc("v1", "y' at end", "", "m/rad",
             CARRIED.format("v1", ""), filled([end.y1 for end in ends], n, ends[-1].y1),
             source="carried over spare rows"),
        calc("a0", "y'' at begin", "", "m/rad²",
             AT_END.format("a0", "^2"), filled([begin.y2 for begin in begins], n)),
        calc("a1", "y'' at end", "", "m/rad²",
             CARRIED.format("a1", "^2"), filled([end.y2 for end in ends], n, ends[-1].y2),
             source="carried over spare rows"),
        calc("jump_y", "jump of y", "Δy", "m",
             "=[h]*(1-INDEX(law_s1,[no]))", filled([p.lack for p in motion.phases], n),
             source="at its end: the law's lack"),
        calc("jump_v", "jump of y'", "Δy'", "m/rad",
             f"=IF([span]>0,[v0]-IF([k]=1,[axis{i}.v1.last],[v1-1]),0)",
             filled([j.jump_v for j in junctions], n), source="at its begin"),
        calc("jump_a", "jump of y''", "Δy''", "m/rad²",
             f"=IF([span]>0,[a0]-IF([k]=1,[axis{i}.a1.last],[a1-1]),0)",
             filled([j.jump_a for j in junctions], n), source="reported, no fault"),
        *phase_columns(rows),
        rules=[AT_REST],
    )  # fmt: skip


ENDS = "ROUND(INDEX([{0}.stop],{1}),9)"
BACKWARDS = (
    f'" ends at "&{ENDS}&"°, "&ROUND(INDEX([{{0}}.start],{{1}})-INDEX([{{0}}.stop],{{1}}),9)&"° before it begins"'
)
PARTED = (
    '" begins at "&ROUND(INDEX([{0}.start],{1}),9)&"°, "&ROUND(ABS(INDEX([{0}.gap],{1})),9)'
    '&IF(INDEX([{0}.gap],{1})>0,"° after ","° before ")&IF({1}=1,"0°","row "&({1}-1)&" ends")'
)
UNFILLED = (
    '" ends at "&ROUND(MAX([{0}.stop]),9)&"°, "&ROUND(ABS(360-MAX([{0}.stop])),9)'
    '&IF(MAX([{0}.stop])<360,"° before 360°","° after 360°")'
)


def in_row(i: int, column: str, says: str) -> str:
    """Return the formula of a sentence on the first phase of an axis in which ``column`` is 1."""
    row = f"MATCH(1,[axis{i}.{column}],0)"
    return f'INDEX([axes.name],{i})&" row "&{row}&{says.format(f"axis{i}", row)}'


def joined(sheet: Sheet, machine: Cutting, i: int, joints: Joints) -> None:
    """Declare the checks of one axis."""
    axis, t = machine.axes[i - 1], f"axis{i}"
    motion, name, key = axis.motion, f"Axis {i}", f"timing.axes.{i - 1}"

    lack = max(abs(phase.lack) for phase in motion.phases)
    jump = max(abs(joint.jump_v) for joint in motion.junctions())

    def greatest(column: str) -> str:
        return f"MAX(MAX([{t}.{column}]),-MIN([{t}.{column}]))"

    gap = f"SUM([{t}.h])-INDEX([{t}.jump_y],COUNT([{t}.stop]))"
    sheet.checks(
        check(f"{t}_forward", f"{name}: every phase runs forward", f"SUM([{t}.backwards])=0", True,
              rule=f"{key}:forward", says=in_row(i, "backwards", BACKWARDS)),
        check(f"{t}_follows", f"{name}: the phases follow on", f"SUM([{t}.parted])=0", True,
              rule=f"{key}:follows", says=in_row(i, "parted", PARTED)),
        check(f"{t}_fills", f"{name}: the phases fill the cycle", f"ABS(MAX([{t}.stop])-360)<check_zero", True,
              rule=f"{key}:fills", says=f"INDEX([axes.name],{i})&{UNFILLED.format(t)}"),
        check(f"{t}_position", f"{name}: no jump of position",
              f"{greatest('jump_y')}<=check_zero*{greatest('h')}", motion.complete,
              says=amount(f"{greatest('jump_y')}*1000", shown(lack, MM), "a lift lacks ", " mm")),
        room_check(f"{t}_room", cells(i), i, name),
        check(f"{t}_velocity", f"{name}: no jump of velocity",
              f"{greatest('jump_v')}<=check_zero*MAX([{t}.y1])", motion.smooth(),
              says=amount(greatest("jump_v"), jump, "y' jumps by ", " m/rad: see jump of y'")),
        joints.check(f"{t}_smooth", f"{name}: as smooth as asked"),
        check(f"{t}_closes", f"{name}: the cycle closes",
              f'OR(INDEX([axes.closes],{i})="feed",ABS({gap})<=check_zero*{greatest("h")})', axis.closes,
              "in position, or, as a feed, in velocity",
              says=amount(f"({gap})*1000", shown(motion.gap, MM), "it ends ", " mm from where it begins")),
    )  # fmt: skip


def cycle(sheet: Sheet, machine: Cutting, rows: Sequence[PieceRows]) -> None:
    """Declare the table over the cycle: results of the three axes, then the workings of each."""
    at = si(machine.angles, DEGREE)
    numbered = list(enumerate(machine.axes, 1))
    results = [
        column
        for (i, axis), found in zip(numbered, rows, strict=True)
        for column in moved(i, axis, found, at, machine.speed)
    ]
    lanes = [in_lane(i, axis, at, len(numbered) - i) for i, axis in numbered]
    workings = [
        column
        for (i, axis), found in zip(numbered, rows, strict=True)
        for column in finding(found, "theta", at, f"axis {i}, ", str(i))
    ]
    sheet.table(
        "cycle", "Position, velocity, acceleration of the three axes over the master angle", len(at),
        calc("theta", "master angle", "θ", "°", "=[k]*360/[cycle.k.last]", machine.angles, format="0.0##"),
        *results, *lanes,
        constant("k", "sample", "k", "", list(range(len(at)))),
        *workings,
    )  # fmt: skip


def moved(i: int, axis: engine_timing.Axis, rows: PieceRows, at: Array, speed: float) -> list[Quantity]:
    """Return the results of one axis: position, geometric and in time."""
    geometric, timed, name = axis.motion.at(at), axis.motion.at_speed(at, speed), f"axis {i}"

    def of(order: int) -> str:
        return derivative(rows, order, str(i))

    return [
        result(f"y{i}", f"{name} position", "y", "mm",
               f"=({of(0)})*1000", shown(geometric.y, MM), source=POSITION),
        result(f"g{i}", f"{name} geometric velocity", "y'", "m/rad",
               f"={of(1)}", geometric.y1, source="dy/du"),
        result(f"gg{i}", f"{name} geometric acceleration", "y''", "m/rad²",
               f"={of(2)}", geometric.y2, source="d²y/du²"),
        result(f"ggg{i}", f"{name} geometric jerk", "y'''", "m/rad³",
               f"={of(3)}", geometric.y3, source="d³y/du³, between jumps"),
        result(f"t{i}", f"{name} velocity", "ẏ", "m/s", f"=[g{i}]*timing_omega", timed.v, source="y' ω"),
        result(f"tt{i}", f"{name} acceleration", "ÿ", "m/s²", f"=[gg{i}]*timing_omega^2", timed.a, source="y'' ω²"),
    ]  # fmt: skip


def in_lane(i: int, axis: engine_timing.Axis, at: Array, floor: int) -> Quantity:
    """Return the axis as the timing diagram shows it."""
    values = lane(axis.motion.at(at).y, axis.motion.reach, floor, LANE_SHARE)
    return calc(f"lane{i}", f"axis {i} in the diagram", "", "", LANE.format(i, floor), values)


def draw_diagram(sheet: Sheet, numbers: range) -> None:
    """Place the timing diagram: one lane an axis over the master angle."""
    chart = Chart(
        "Timing diagram", "master angle θ [°]", "axes, the first at the top",
        tuple(Series(f"=axis{i}_name", "[cycle.theta]", f"[cycle.lane{i}]") for i in numbers),
        "Timing diagram: rises, dwells and returns of each axis over one turn of the master shaft",
        (0, 360, 30), (0, 3, 1), hide_y=True,
    )  # fmt: skip
    sheet.chart(chart, column=10, row=5, width=8, height=21)


def draw_curves(sheet: Sheet, numbers: range) -> None:
    """Place the charts of y, y', y'' of the three axes."""
    sheet.heading("Position, geometric velocity and acceleration over the cycle")
    kinds = (
        ("y", "y [mm]", "Position"),
        ("g", "y' [m/rad]", "Geometric velocity"),
        ("gg", "y'' [m/rad²]", "Geometric acceleration"),
    )
    sheet.chart_row(
        *(Chart(title, "master angle θ [°]", label,
                tuple(Series(f"=axis{i}_name", "[cycle.theta]", f"[cycle.{column}{i}]") for i in numbers),
                f"{title} of the three axes over the master angle", (0, 360, 60))
          for column, label, title in kinds),
        width=6, height=18,
    )  # fmt: skip
