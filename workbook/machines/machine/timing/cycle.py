"""The sheet Cycle of an axis: its motion sample by sample, which charts show and cam tables export."""

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import FIRST, Book, Quantity
from workbook.fields.texts import sheet_title
from workbook.fields.units import DEGREE, shown
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.view import MachineView
from workbook.motion.exported import Exportable, ShiftCells
from workbook.motion.pieces import POSITION, at_sample, workings_at

CELLS = cell_tables(__file__)

LANE_SHARE, BELOW, NOTE = 0.54, 0.4, 0.17  # of a lane's height: an axis, what is below it, its texts
CURVES = {"v": "velocity", "a": "acceleration", "j": "jerk"}
"""the rates of a sampled axis by their columns, and what they are called"""


def cycle_sheet(book: Book, machine: MachineView, tables: AxisTables, floor: int) -> None:
    """Declare the sheet of an axis; ``floor`` is the height of its lane in the timing diagram."""
    over, axis, i = machine.over, tables.axis, tables.axis.number
    unshifted = tables.axis.unshifted(machine.samples)
    title = sheet_title(f"Cycle {i}", [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"Axis {i} over {over.cycle}, sample by sample; what charts show.")
    size = shown(axis.motion.size(0), axis.unit)
    unit, lowest, highest = axis.given.unit, f"[axes.low.{i}]", f"[axes.high.{i}]"
    low, high = (shown(end, axis.unit) for end in axis.motion.reach)
    by_lift = LANE_SHARE / (high - low) if high > low else 0.0
    low_end = floor + BELOW
    lane = low_end + by_lift * (shown(axis.motion.at(unshifted.x).y, axis.unit) - low)
    cell = CELLS["cycle_sheet"].sharing(i=i, unit=unit, lowest=lowest)
    with sheet.scoped(f"cycle{i}_"):
        sheet.rows(
            cell("@name", axis.given.name),
            cell("@late", axis.given.shift),
            cell("@lap", shown(axis.motion.lifts_sum, axis.unit) / 360.0, scale=size / 360.0),
            cell("@scale", by_lift, highest=highest),
            cell("@floor", low_end - by_lift * low, floor=low_end, scale=1.0),
            cell("@note", floor + NOTE),
        )
        sheet.row += 1
        theta = cell("theta", machine.angles.tolist(), label=over.angle)
        time = cell("time", over.shown(machine.angles), **over.words)
        cell.sharing(name=over.name).place(
            sheet,
            time if over.measured else theta,
            *results(tables),
            cell("lane", lane),
            *([theta] if over.measured else []),
            cell("p", shown(unshifted.x, DEGREE), scale=360.0),
            *workings_at(tables.pieces, "p", unshifted.x),
        )
    sheet.not_printed_below()
    sheet.unprinted, sheet.widths = "workings" not in book.print_also, {FIRST: 14}


def results(tables: AxisTables) -> list[Quantity]:
    """Return the motion of an axis in time, or by the abscissa whose length is entered alone."""
    axis, unit, over = tables.axis, tables.axis.given.unit, tables.machine.over
    timed = axis.motion.at_speed(axis.unshifted(tables.machine.samples).x, axis.speed)
    y, lift = at_sample(tables.pieces, 0), over.lift(unit).shown
    either = f"1000*({y})" if unit == "mm" else f"DEGREES({y})"
    position = shown(axis.at(tables.machine.samples).y, axis.unit)
    table = CELLS["rates"].sharing(symbols=over.symbols, units=tuple(over.rates(unit)), lift=lift)

    def rate(name: str, order: int, source: str) -> Quantity:
        own = {"source": source} if over.timed else {}
        place = at_sample(tables.pieces, order)
        return table(name, axis.rate(timed[order]), sampled=place, scale=axis.size(order), **own)

    return [
        CELLS["results"]("y", position, unit=unit, either=either, source=POSITION),
        rate("v", 1, "y' ω"),
        rate("a", 2, "y'' ω²"),
        rate("j", 3, "y''' ω³, between jumps"),
    ]


def exportable(tables: AxisTables) -> Exportable:
    """Return an axis as the sheet Export may have it."""
    axis, i, unit = tables.axis, tables.axis.number, tables.axis.given.unit
    over = tables.machine.over
    units = (over.unit, unit, f"{unit}/{over.unit}", f"{unit}/{over.unit}²")
    later = ShiftCells(f"[axes_taken.late.{i}]", "eps", f"[axes.travel.{i}]", axis.unshifted, axis.motion.lifts_sum)
    return Exportable(
        axis.given.name,
        f"=[axes.name.{i}]",
        tables.pieces,
        units,
        (over.shown(shown(1.0, DEGREE)), shown(1.0, axis.unit)),
        "*1000" if unit == "mm" else "*180/PI()",
        axis.motion.size,
        later,
        over=over,
    )
