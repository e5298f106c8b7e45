"""Timing of three axes over one turn of the master shaft: phases, diagram, checks and pieces; behind it samples."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from engine import timing as engine_timing
from engine.laws.base import Array
from engine.timing import lane, turn_time
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Quantity, Sheet, calc, constant, given, result
from workbook.entries.units import DEGREE, MM, shown, si
from workbook.machines.cutting.phases import joined, phases
from workbook.machines.cutting.view import Cutting
from workbook.motion.cells import Cells, PieceRows
from workbook.motion.ends import Ends, ends_tables
from workbook.motion.pieces import ABOUT, pieces_in_all, pieces_table
from workbook.motion.sampled import POSITION, derivative, finding
from workbook.motion.smooth import Asked, Joints

S1 = "S1, slide 'Timing diagram for a cutting machine'"
LANE_SHARE = 0.8
ABSCISSA = 14
"""width of the column of the master angle"""
LANE = "={1}+IF([axes.high.{0}]>[axes.low.{0}],timing_lane*([y{0}]-[axes.low.{0}])/([axes.high.{0}]-[axes.low.{0}]),0)"


def cells(i: int, hands_over: bool = False) -> Cells:
    """Return where the motion of an axis stands; ``hands_over`` where phases may hand velocity over."""
    return Cells(
        f"axis{i}", f"axis{i}_pieces", f"axis{i}_count", "360", "m", "rad", degrees=True, near="timing_eps",
        ends=f"axis{i}_ends" if hands_over else "",
    )  # fmt: skip


def handing(machine: Cutting, rows: Sequence[PieceRows]) -> list[Ends | None]:
    """Return what the phases of each axis take from their neighbours; None in a book without straight lines."""
    axes = zip(machine.machine.timing.axes, machine.joined, rows, strict=True)
    return [
        Ends(of_axis, found, axis.phases, f"COUNT([axis{i}.stop])",
             (f"INDEX([axes.name],{i})", axis.name))
        if of_axis.at.ends else None
        for i, (axis, found, of_axis) in enumerate(axes, 1)
    ]  # fmt: skip


def asked(machine: Cutting, i: int) -> Asked:
    """Return how smooth an axis must be."""
    units = tuple((f'"{unit}"', unit) for unit in ("m/rad", "m/rad²", "m/rad³"))
    axis, t = machine.machine.timing.axes[i - 1], f"axis{i}"
    return Asked(
        axis.smoothness, f"INDEX([axes.smooth],{i})", f"{t}_order", (f"MAX([{t}.y1])", f"MAX([{t}.y2])"),
        ('"°"', "°"), units, (f"INDEX([axes.name],{i})", axis.name),
    )  # fmt: skip


def timing_sheet(book: Book, machine: Cutting, rows: Sequence[PieceRows]) -> None:
    """Declare the sheet: what to enter at the top, the diagram beside it, then each axis's phases; below, pieces."""
    timing = machine.machine.timing
    sheet = book.sheet("Timing", "Three axes over one turn of the master shaft: phases, movements, timing diagram.")
    sheet.heading("Enter")
    sheet.rows(
        given("timing_rate", "Production rate", "n", "pieces/min",
              timing.rate, "timing.rate", format="0.0##", source="one piece a turn of the master shaft"),
        calc("timing_cycle", "Time of one turn", "t_c", "s",
             "=60/timing_rate", turn_time(machine.rate), source="60 / n"),
        calc("timing_omega", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()*timing_rate/60", machine.speed, source="2π n / 60"),
        calc("timing_eps", "Tolerance of an angle", "ε", "°",
             "=360*break_tolerance", shown(machine.axes[0].motion.tolerance, DEGREE), format="0E+00",
             source="an angle this close to a phase's start is taken as the start"),
        constant("timing_lane", "Height of an axis in the diagram", "", "",
                 LANE_SHARE, format="0.0", source="as a share of its lane"),
    )  # fmt: skip
    axes_table(sheet, machine)
    draw_diagram(sheet, range(1, len(timing.axes) + 1))
    sheet.row = max(sheet.row, 26)
    joints = [Joints.of(found, axis.motion, asked(machine, i))
              for i, (axis, found) in enumerate(zip(machine.axes, rows, strict=True), 1)]  # fmt: skip
    ends = handing(machine, rows)
    for i, (of_axis, of_joints, of_ends) in enumerate(zip(rows, joints, ends, strict=True), 1):
        phases(sheet, machine, i, of_axis, of_ends)
        joined(sheet, machine, i, of_joints, of_ends)
    draw_curves(sheet, range(1, len(timing.axes) + 1))
    sheet.not_printed_below()
    pieces(sheet, machine, rows, ends)
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
        constant("k", "number", "k", "", list(range(1, len(axes) + 1))),
        given("name", "axis", "", "", [a.name for a in axes], "timing.axes.*.name"),
        given("closes", "over a cycle", "", "",
              [a.closes for a in axes], "timing.axes.*.closes", source="returns to its position, or feeds on"),
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


def pieces(sheet: Sheet, machine: Cutting, rows: Sequence[PieceRows], ends: Sequence[Ends | None]) -> None:
    """Declare the motions as pieces."""
    sheet.heading("Workings: the motions as pieces", ABOUT)
    room = machine.room
    for i, (axis, of_axis, of_ends) in enumerate(zip(machine.axes, rows, ends, strict=True), 1):
        joints = Joints.of(of_axis, axis.motion, asked(machine, i))
        sheet.rows(pieces_in_all(of_axis), joints.order())
        columns, taken = joints.columns(room), of_ends.taken(room) if of_ends else []
        columns += of_ends.turns.of_pieces(room) if of_ends else []
        pieces_table(sheet, f"Pieces of axis {i}", of_axis, room, axis.motion.size, *columns, taken=taken)
    ends_tables(sheet, [(f"axis {i}", found) for i, found in enumerate(ends, 1) if found])


def cycle_sheet(book: Book, machine: Cutting, rows: Sequence[PieceRows]) -> None:
    """Declare the sheet of the motions over the cycle: results of the three axes, then the workings of each."""
    sheet = book.sheet("Cycle", "The three axes over one turn of the master shaft, sample by sample; what charts show.")
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
    sheet.print_columns, sheet.widths = 20, {FIRST: ABSCISSA}


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
        "Timing diagram", "master angle θ [°]", "",
        tuple(Series(f"=axis{i}_name", "[cycle.theta]", f"[cycle.lane{i}]") for i in numbers),
        "Timing diagram: rises, dwells and returns of each axis over one turn of the master shaft",
        (0, 360, 30), (0, 3, 1), lanes=True,
    )  # fmt: skip
    sheet.chart(chart, column=13, row=5, width=5, height=21)


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
        width=6, height=15,
    )  # fmt: skip
