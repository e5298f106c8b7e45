"""The sheets Cycle: each axis over one turn of the master shaft, sample by sample."""

from __future__ import annotations

from workbook.book.declare import FIRST, Book, Quantity, calc, constant, result
from workbook.entries.titles import sheet_title
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.timing import LANE_SHARE
from workbook.machines.machine.view import Whole
from workbook.motion.exported import Exportable, Later
from workbook.motion.sampled import POSITION, finding, sampled

CYCLES = "ROUND(({0}-[axes_taken.late.{1}]-{2})/360,0)"
"""how many cycles of its phases an axis has begun before"""


def cycle_sheets(book: Book, machine: Whole, axes: list[AxisRows]) -> None:
    """Declare a sheet for each axis."""
    for one in axes:
        cycle_sheet(book, machine, one, len(axes) + len(machine.lanes) - one.axis.number)


def cycle_sheet(book: Book, machine: Whole, one: AxisRows, floor: int) -> None:
    """Declare the sheet of an axis; ``floor`` is the height of its lane in the timing diagram."""
    over, i, samples = machine.over, one.axis.number, len(machine.angles)
    title = sheet_title(f"Cycle {i}", [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"Axis {i} over {over.cycle}, sample by sample; what charts show.")
    sheet.rows(calc(f"cycle{i}_name", "Axis", "", "", f"=[axes.name.{i}]", one.axis.given.name, align="left"))
    sheet.row += 1
    theta = calc("theta", over.angle, "θ", "°", f"=[k]*360/[cycle{i}.k.last]", machine.angles, format="0.0##")
    time = calc("time", over.name, over.symbol, over.unit, f"=[k]*timing_cycle/[cycle{i}.k.last]", machine.times,
                format=over.format)  # fmt: skip
    sheet.table(
        f"cycle{i}", f"The axis over the {over.name}", samples,
        time if over.measured else theta,
        *results(one), in_lane(one, floor),
        constant("k", "sample", "k", "", list(range(samples))),
        *([theta, *geometric(one)] if over.measured else []),
        *found(one),
    )  # fmt: skip
    sheet.unprinted, sheet.widths = True, {FIRST: 14}


def geometric(one: AxisRows) -> list[Quantity]:
    """Return the derivatives of an axis by the master angle."""
    axis, base = one.axis, one.axis.base
    _, y1, y2, y3 = axis.at(one.machine.samples)
    shown_as, size = calc if one.machine.over.measured else result, axis.motion.size

    def of(order: int) -> str:
        return f"={sampled(one.pieces, order)}"

    return [
        shown_as("g", "geometric velocity", "y'", f"{base}/rad", of(1), y1, scale=size(1), source="dy/du"),
        shown_as("gg", "geometric acceleration", "y''", f"{base}/rad²", of(2), y2, scale=size(2), source="d²y/du²"),
        shown_as("ggg", "geometric jerk", "y'''", f"{base}/rad³", of(3), y3, scale=size(3),
                 source="d³y/du³, between jumps"),
    ]  # fmt: skip


def results(one: AxisRows) -> list[Quantity]:
    """Return the motion of an axis, geometric and in time, or by the abscissa whose length is entered alone."""
    axis, i, unit, over = one.axis, one.axis.number, one.axis.given.unit, one.machine.over
    lift, (_, first, second, _), (velocity, acceleration, _) = over.lift(unit), over.symbols, over.rates(unit)
    y = axis.at(one.machine.samples).y
    timed = axis.motion.at_speed(axis.told(one.machine.samples).x, axis.speed)
    place = sampled(one.pieces, 0)
    shown_y = f"=({place})*1000" if unit == "mm" else f"=DEGREES({place})"
    return [
        result("y", "position", "y", unit, f"{shown_y}+[n]*[axes.travel.{i}]", shown(y, axis.unit), source=POSITION),
        *([] if over.measured else geometric(one)),
        result("v", "velocity", first, velocity, f"=[g]*timing_omega{lift.shown}",
               axis.rate(timed.v), scale=axis.size(1), source="y' ω" if over.paced else "dy/dx"),
        result("a", "acceleration", second, acceleration, f"=[gg]*timing_omega^2{lift.shown}",
               axis.rate(timed.a), scale=axis.size(2), source="y'' ω²" if over.paced else "d²y/dx²"),
    ]  # fmt: skip


def in_lane(one: AxisRows, floor: int) -> Quantity:
    """Return the axis as the timing diagram shows it: the first at the top."""
    i, lane = one.axis.number, one.axis.lane(one.machine.samples, floor, LANE_SHARE)
    low, high = f"[axes.low.{i}]", f"[axes.high.{i}]"
    share = f"([y]-[n]*[axes.travel.{i}]-{low})/({high}-{low})"
    return calc("lane", "in the diagram", "", "", f"={floor}+IF({high}>{low},timing_lane*{share},0)", lane)


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
    """Return where the samples of an axis lie: in which cycle, at which angle of its phases, in which piece."""
    late, told = f"[axes_taken.late.{one.axis.number}]", one.axis.told(one.machine.samples)
    return [
        calc("n", "cycles of its phases begun before", "c", "",
             f"=INT((MIN([theta],360-2*timing_eps)-{late}+timing_eps)/360)", told.cycles, format="0",
             source="the end of the turn has the left limit"),
        calc("p", "angle of its phases", "", "°", f"=[theta]-{late}-360*[n]", shown(told.x, DEGREE), format="0.0##",
             source="θ − shift − 360 n", scale=360.0),
        *finding(one.pieces, "p", told.x),
    ]  # fmt: skip
