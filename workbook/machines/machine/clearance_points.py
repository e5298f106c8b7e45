"""Workings of the sheet Clearances: the gap at points of the cycle, and the lowest points of parabolas between them."""

import numpy as np

from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.gap import PARTS, PARTS_BY_PAIRS, ClearanceView
from workbook.motion.pieces import finding, sampled

CELLS = cell_tables(__file__)

ABOUT = (
    "The gap is worked out where a piece of either axis begins or has its middle, with pairs also at its quarters; "
    "between two of these places it is taken as a parabola, by the slope at the first, and worked out at the lowest "
    "point of all parabolas."
)
BEGIN, MIDDLE = ("begin", "a piece begins"), ("middle", "its middle")
PARTS_OF = {
    PARTS: (BEGIN, MIDDLE),
    PARTS_BY_PAIRS: (BEGIN, ("first", "its first quarter"), MIDDLE, ("last", "its last")),
}
MARKS, OF = "ab", ("first axis: ", "second axis: ")
"""what the names of both axes' columns end with, and their labels begin with"""


def gap_workings(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare the workings of a clearance."""
    sheet.heading(f"Workings: clearance {gap.number}", ABOUT)
    least(sheet, gap)
    points(sheet, gap)
    cuts(sheet, gap)


def at_angles(gap: ClearanceView, angles: Array) -> list[Quantity]:
    """Return the columns of both axes at angles of the column theta: cycles begun, piece, u, position; and the gap."""
    cell = CELLS["at_angles"].sharing(size=gap.size)
    cells, n = [], gap.number
    for rows, mark, of, y in zip(gap.rows, MARKS, OF, gap.positions(angles), strict=True):
        axis, unshifted = rows.axis, rows.axis.unshifted(si(angles, DEGREE))
        late, place = f"[axes_taken.late.{axis.number}]", sampled(rows.pieces, 0, mark)
        own = f"({place})*1000" if axis.given.unit == "mm" else f"DEGREES({place})"
        cells += [
            cell("n{mark}", unshifted.cycles, mark=mark, of=of, late=late),
            cell("p{mark}", shown(unshifted.x, DEGREE), mark=mark, of=of, late=late),
            *finding(rows.pieces, f"p{mark}", unshifted.x, of, mark),
            cell("y{mark}", y, mark=mark, of=of, unit=axis.given.unit, own=own, number=axis.number),
        ]
    first = "[ya]"
    if gap.table:
        y, first = gap.positions(angles)[0], "[free]"
        cells += [cell("line", gap.table.row(y) + 1.0, n=n), cell("free", gap.table.position(y), unit=gap.unit, n=n)]
    return [*cells, cell("gap", gap.gaps(angles), unit=gap.unit, n=n, first=first)]


def least(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare the positions of both axes, and the gap, at the lowest of the points and at that of the parabolas."""
    cell = CELLS["least"]
    cell.sharing(number=gap.number).place(
        sheet,
        cell("k", [1, 2]),
        cell("theta", gap.lowest_at, angle=gap.over.angle, n=gap.number, scale=TURN),
        *at_angles(gap, gap.lowest_at),
    )


def points(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare the gap and its slope at points of the cycle, and the lowest point of the parabola before each."""
    n, angles, low, size = gap.number, gap.angles, gap.lowest, gap.size
    last_part = PARTS_OF[gap.parts][-1][0]
    of_first = f"*INDEX([clear{n}_pairs.slope],[line])" if gap.table else ""
    cell = CELLS["points"].sharing(n=n, unit=gap.unit)
    speeds = []
    for mark, of, rows, values in zip(MARKS, OF, gap.rows, gap.velocities, strict=True):
        place, most = sampled(rows.pieces, 1, mark), rows.axis.motion.size(1)
        speeds.append(cell("v{mark}", values, mark=mark, of=of, unit=rows.at.unit(1), sampled=place, scale=most))
    cell.place(
        sheet,
        cell("theta", angles, angle=gap.over.angle, last_part=last_part, scale=TURN),
        *at_angles(gap, angles),
        *speeds,
        cell("slope", gap.slopes, of_first=of_first, scale=float(np.abs(gap.slopes).max())),
        cell("fall", low.fall, scale=size),
        cell("rise", low.rise, scale=size),
        cell("share", low.share),
        cell("low", low.gap, scale=size),
        cell("nearest", gap.near(gap.gaps(angles))),
        cell("near", gap.near(low.gap)),
        cell("angle", low.angle, scale=TURN),
    )


def cuts(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare where the pieces of both axes begin, and further parts of them, from 0 to 360°."""
    cell = CELLS["cuts"]
    cells = []
    names = PARTS_OF[gap.parts]
    for end, (rows, mark, of) in enumerate(zip(gap.rows, MARKS, OF, strict=True)):
        i = rows.axis.number
        places = [f"INDEX([axis{i}_pieces.begin],[r])+[axes_taken.late.{i}]"]
        span = f"DEGREES(INDEX([axis{i}_pieces.d],[r])"
        places += [f"[begin{mark}]+{span}*{k}/{gap.parts})" for k in range(1, gap.parts)]
        cells += [
            cell("{name}{mark}", values, name=name, mark=mark, of=of, words=words, place=place)
            for (name, words), place, values in zip(names, places, gap.cuts(end), strict=True)
        ]
    cell.sharing(number=gap.number).place(sheet, *cells)
