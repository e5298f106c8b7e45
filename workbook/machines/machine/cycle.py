"""The sheet Cycle: every axis over one turn of the master shaft, sample by sample."""

from __future__ import annotations

from workbook.book.declare import FIRST, Book, Quantity, calc, constant, result
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.timing import LANE_SHARE
from workbook.machines.machine.view import Whole
from workbook.motion.exported import Exportable, Later
from workbook.motion.sampled import POSITION, derivative, finding

TOLD = "MIN([theta],360-2*timing_eps)"
"""the end of the turn has the left limit"""
CYCLES = "ROUND(({0}-[axes_taken.late.{1}]-{2})/360,0)"
"""how many cycles of its phases an axis has begun before"""
LANE = "={1}+IF({3}>{2},timing_lane*({0}-{2})/({3}-{2}),0)"


def cycle_sheet(book: Book, machine: Whole, axes: list[AxisRows]) -> None:
    """Declare the sheet."""
    over = machine.over
    sheet = book.sheet("Cycle", f"Every axis over {over.cycle}, sample by sample; what charts show.")
    samples = len(machine.angles)
    columns = [column for one in axes for column in results(one)]
    lanes = [in_lane(one, len(axes) + len(machine.lanes)) for one in axes]
    workings = [column for one in axes for column in found(one)]
    theta = calc("theta", over.angle, "θ", "°", "=[k]*360/[cycle.k.last]",
                 machine.angles, format="0.0##")  # fmt: skip
    time = calc("time", over.name, over.symbol, over.unit, "=[k]*timing_cycle/[cycle.k.last]", machine.times,
                format=over.format)  # fmt: skip
    inner = [column for one in axes for column in geometric(one)] if over.measured else []
    sheet.table(
        "cycle", f"The axes over the {over.name}", samples,
        time if over.measured else theta,
        *columns, *lanes,
        constant("k", "sample", "k", "", list(range(samples))),
        *([theta] if over.measured else []), *inner,
        *workings,
    )  # fmt: skip
    sheet.print_columns, sheet.widths = 19, {FIRST: 14}


def geometric(one: AxisRows) -> list[Quantity]:
    """Return the derivatives of an axis by the master angle."""
    axis, i, base = one.axis, one.axis.number, one.axis.base
    _, y1, y2, y3 = axis.at(one.machine.samples)
    label, shown_as, size = f"axis {i}:", calc if one.machine.over.measured else result, axis.motion.size

    def of(order: int) -> str:
        return derivative(one.pieces, order, str(i))

    return [
        shown_as(f"g{i}", f"{label} geometric velocity", "y'", f"{base}/rad", f"={of(1)}", y1, scale=size(1),
                 source="dy/du"),
        shown_as(f"gg{i}", f"{label} geometric acceleration", "y''", f"{base}/rad²", f"={of(2)}", y2,
                 scale=size(2), source="d²y/du²"),
        shown_as(f"ggg{i}", f"{label} geometric jerk", "y'''", f"{base}/rad³",
                 f"={of(3)}", y3, scale=size(3), source="d³y/du³, between jumps"),
    ]  # fmt: skip


def results(one: AxisRows) -> list[Quantity]:
    """Return the motion of an axis, geometric and in time, or by the abscissa whose length is entered alone."""
    axis, i, unit, over = one.axis, one.axis.number, one.axis.given.unit, one.machine.over
    lift, (_, first, second, _), (velocity, acceleration, _) = over.lift(unit), over.symbols, over.rates(unit)
    y = axis.at(one.machine.samples).y
    timed = axis.motion.at_speed(axis.told(one.machine.samples).x, axis.speed)
    label = f"axis {i}:"

    place = derivative(one.pieces, 0, str(i))
    shown_y = f"=({place})*1000" if unit == "mm" else f"=DEGREES({place})"
    return [
        result(f"y{i}", f"{label} position", "y", unit,
               f"{shown_y}+{CYCLES.format('[theta]', i, f'[p{i}]')}*[axes.travel.{i}]", shown(y, axis.unit),
               source=POSITION),
        *([] if over.measured else geometric(one)),
        result(f"t{i}", f"{label} velocity", first, velocity, f"=[g{i}]*timing_omega{lift.shown}",
               axis.rate(timed.v), scale=axis.size(1), source="y' ω" if over.paced else "dy/dx"),
        result(f"tt{i}", f"{label} acceleration", second, acceleration, f"=[gg{i}]*timing_omega^2{lift.shown}",
               axis.rate(timed.a), scale=axis.size(2), source="y'' ω²" if over.paced else "d²y/dx²"),
    ]  # fmt: skip


def in_lane(one: AxisRows, of: int) -> Quantity:
    """Return the axis as the timing diagram shows it: the first at the top."""
    axis, i = one.axis, one.axis.number
    begun = f"{CYCLES.format('[theta]', i, f'[p{i}]')}*[axes.travel.{i}]"
    formula = LANE.format(f"[y{i}]-{begun}", of - i, f"[axes.low.{i}]", f"[axes.high.{i}]")
    return calc(f"lane{i}", f"axis {i}: in the diagram", "", "",
                formula, axis.lane(one.machine.samples, of - i, LANE_SHARE))  # fmt: skip


def exportable(one: AxisRows) -> Exportable:
    """Return an axis as the sheet Export may have it."""
    axis, i, unit = one.axis, one.axis.number, one.axis.given.unit
    over = one.machine.over
    units = (over.unit, unit, f"{unit}/{over.unit}", f"{unit}/{over.unit}²")
    later = Later(f"[axes_taken.late.{i}]", "timing_eps", f"[axes.travel.{i}]", axis.told, axis.motion.lifts_sum)
    return Exportable(axis.given.name, f"=[axes.name.{i}]", one.pieces, units,
                      (over.shown(shown(1.0, DEGREE)), shown(1.0, axis.unit)),
                      "*1000" if unit == "mm" else "*180/PI()", axis.motion.size, later, over=over)  # fmt: skip


def found(one: AxisRows) -> list[Quantity]:
    """Return where the samples of an axis lie: at which angle of its phases, in which piece."""
    axis, i, late = one.axis, one.axis.number, f"[axes_taken.late.{one.axis.number}]"
    told = axis.told(one.machine.samples)
    return [
        calc(f"p{i}", f"axis {i}: angle of its phases", "", "°",
             f"=[theta]-{late}-360*INT(({TOLD}-{late}+timing_eps)/360)", shown(told.x, DEGREE), format="0.0##",
             source="θ − shift − 360 n", scale=360.0),
        *finding(one.pieces, f"p{i}", told.x, f"axis {i}: ", str(i)),
    ]  # fmt: skip
