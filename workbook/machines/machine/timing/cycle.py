"""The sheets Cycle: each axis over one turn of the master shaft, sample by sample."""

from functools import partial

from workbook.book.again import again
from workbook.book.declare import FIRST, Book, Quantity, calc, constant, result
from workbook.entries.texts import sheet_title
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.motion.tables import AxisRows
from workbook.machines.machine.timing.sheet import LANE_SHARE
from workbook.machines.machine.view import Whole
from workbook.motion.exported import Exportable, Later
from workbook.motion.pieces import POSITION, finding, sampled

RATES = (
    ("v", "velocity", "omega", "y' ω", "dy/dx"),
    ("a", "acceleration", "omega^2", "y'' ω²", "d²y/dx²"),
    ("j", "jerk", "omega^3", "y''' ω³, between jumps", "d³y/dx³, between jumps"),
)
"""of each derivative: its column, what it is called, its factor, and its equation over time and over all else"""

EARLIER = "([theta]-@late-[p])*@lap"
"""the travel of the turns that its phases have ended before"""


def cycle_sheets(book: Book, machine: Whole, axes: list[AxisRows]) -> None:
    """Declare a sheet for each axis."""
    for one in axes:
        floor = len(axes) + len(machine.lanes) - one.axis.number
        again(book, "cycle sheets", (one, floor), partial(cycle_sheet, book, machine, one, floor))


def cycle_sheet(book: Book, machine: Whole, one: AxisRows, floor: int) -> None:
    """Declare the sheet of an axis; ``floor`` is the height of its lane in the timing diagram."""
    over, i, samples, told = machine.over, one.axis.number, len(machine.angles), one.axis.told(machine.samples)
    title = sheet_title(f"Cycle {i}", [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"Axis {i} over {over.cycle}, sample by sample; what charts show.")
    with sheet.scoped(f"cycle{i}_"):
        sheet.rows(calc("@name", "Axis", "", "", f"=[axes.name.{i}]", one.axis.given.name, align="left"),
                   *whole(one, floor))  # fmt: skip
        sheet.row += 1
        theta = constant("theta", over.angle, "θ", "°", machine.angles.tolist(), format="0.0##")
        time = calc("time", over.name, over.symbol, over.unit, "=[theta]/360*timing_cycle", over.shown(machine.angles),
                    format=over.format)  # fmt: skip
        sheet.table(
            f"cycle{i}", f"The axis over the {over.name}", samples,
            time if over.measured else theta,
            *results(one),
            calc("lane", "in the diagram", "", "", f"=@floor+@scale*([y]-{EARLIER})",
                 one.axis.lane(machine.samples, floor, LANE_SHARE)),
            *([theta] if over.measured else []),
            calc("p", "angle of its phases", "", "°",
                 "=[theta]-@late-360*INT((MIN([theta],timing_end)-@late+eps)/360)", shown(told.x, DEGREE),
                 format="0.0##", source="θ − shift, less whole turns; the end has the left limit", scale=360.0),
            *finding(one.pieces, "p", told.x),
        )  # fmt: skip
    sheet.unprinted, sheet.widths = True, {FIRST: 14}


def whole(one: AxisRows, floor: int) -> list[Quantity]:
    """Return what is the same at all samples of an axis: its shift, what a cycle goes on by, and its lane."""
    axis, i, unit = one.axis, one.axis.number, one.axis.given.unit
    low, high = (shown(end, axis.unit) for end in axis.motion.reach)
    by_lift = LANE_SHARE / (high - low) if high > low else 0.0
    lowest, highest = f"[axes.low.{i}]", f"[axes.high.{i}]"
    return [
        calc("@late", "Its phases begin later by", "", "°", f"=[axes_taken.late.{i}]+0", axis.given.shift),
        calc("@lap", "Travel of a cycle by its angle", "", f"{unit}/°", f"=[axes.travel.{i}]/360",
             shown(axis.motion.lifts_sum, axis.unit) / 360.0, scale=shown(axis.motion.size(0), axis.unit) / 360.0),
        calc("@scale", "Height by lift", "", f"1/{unit}",
             f"=IF({highest}>{lowest},timing_lane/({highest}-{lowest}),0)", by_lift),
        calc("@floor", "Height of position 0", "", "", f"={floor}-@scale*{lowest}",
             floor - by_lift * low, scale=1.0),
    ]  # fmt: skip


def results(one: AxisRows) -> list[Quantity]:
    """Return the motion of an axis in time, or by the abscissa whose length is entered alone."""
    axis, unit, over = one.axis, one.axis.given.unit, one.machine.over
    timed = axis.motion.at_speed(axis.told(one.machine.samples).x, axis.speed)
    y, lift = sampled(one.pieces, 0), over.lift(unit).shown
    rates = zip(RATES, over.symbols[1:], over.rates(unit), timed[1:], strict=True)
    return [
        result("y", "position", "y", unit, f"={f'1000*({y})' if unit == 'mm' else f'DEGREES({y})'}+{EARLIER}",
               shown(axis.at(one.machine.samples).y, axis.unit), source=POSITION),
        *(result(name, words, symbol, shown_in, f"={factor}*({sampled(one.pieces, order)}){lift}", axis.rate(values),
                 scale=axis.size(order), source=paced if over.paced else by_x)
          for order, ((name, words, factor, paced, by_x), symbol, shown_in, values) in enumerate(rates, 1)),
    ]  # fmt: skip


def exportable(one: AxisRows) -> Exportable:
    """Return an axis as the sheet Export may have it."""
    axis, i, unit = one.axis, one.axis.number, one.axis.given.unit
    over = one.machine.over
    units = (over.unit, unit, f"{unit}/{over.unit}", f"{unit}/{over.unit}²")
    later = Later(f"[axes_taken.late.{i}]", "eps", f"[axes.travel.{i}]", axis.told, axis.motion.lifts_sum)
    return Exportable(axis.given.name, f"=[axes.name.{i}]", one.pieces, units,
                      (over.shown(shown(1.0, DEGREE)), shown(1.0, axis.unit)),
                      "*1000" if unit == "mm" else "*180/PI()", axis.motion.size, later, over=over)  # fmt: skip
