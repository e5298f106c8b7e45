"""The sheet Clearances: axes that must stay apart, their gap over the cycle, and where it is least."""

from dataclasses import replace

import numpy as np

from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.rows import filled
from workbook.book.sentence import CheckSentence, amount
from workbook.drive.motor import PEAK
from workbook.entries.facts import table_of
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import PAIRS, ClearanceEntry, FreePosition
from workbook.machines.machine.gap import PARTS, PARTS_BY_PAIRS, ClearanceView, FreePositions
from workbook.motion.pieces import at_sample, workings_at

CELLS = cell_tables(__file__)

BY_TABLE = (
    "With pairs below, the free position of the second axis takes the place of the first one's position, on straight "
    "lines between the pairs; the gap is in the unit of the second axis."
)
AT = 3  # decimals of a place in a sentence
PLACE = (
    "IF([clear{n}_least.gap.first]<=[clear{n}_least.gap.last]+check_zero*[gaps.size.{n}],"
    "[clear{n}_least.theta.first],[clear{n}_least.theta.last])"
)
HIGH = "MAX(ABS([axes.low.{0}]),ABS([axes.high.{0}]))"
PRINTED = 12  # columns: what is entered, and the least gaps


def clearances_sheet(book: Book, gaps: list[ClearanceView]) -> None:
    """Declare the sheet, where there are clearances."""
    if not gaps:
        return
    period = gaps[0].over.period
    sheet = book.sheet("Clearances", f"Axes that must stay apart: the least gap over a {period}, and where it is.")
    sheet.heading("Enter", "gap = offset + factor · position + factor · position, in the unit of the first axis.")
    if any(gap.table for gap in gaps):
        sheet.note(BY_TABLE)
    table(sheet, gaps)
    for gap in gaps:
        if gap.table:
            pairs(sheet, gap, gap.table)
    sheet.checks(*map(clearance_check, gaps), *(covered_check(gap, gap.table) for gap in gaps if gap.table))
    sheet.heading("The gap over the cycle", "With a dot where it is least; dashed what must be left.")
    for k in range(0, len(gaps), 2):
        drawn = [*map(gap_chart, gaps[k : k + 2])]
        sheet.chart_row(*drawn, width=PRINTED // len(drawn))
    sheet.not_printed_below()
    for gap in gaps:
        sheet.heading(f"Workings: clearance {gap.number}", ABOUT)
        least(sheet, gap)
        points(sheet, gap)
        cuts(sheet, gap)
    sheet.widths = {PRINTED - 2: 24}  # of the least gaps, whose note is long
    sheet.print_columns, sheet.folded = PRINTED, PRINTED + 1


def table(sheet: Sheet, gaps: list[ClearanceView]) -> None:
    """Declare what is entered, and the least gaps."""
    cell, over, units = CELLS["clearances"], gaps[0].over, {gap.unit for gap in gaps}
    unit = units.pop() if len(units) == 1 else "mm, °"
    entry = table_of(ClearanceEntry).columns([gap.given for gap in gaps], "clearances", len(gaps))
    size = max(gap.size for gap in gaps)
    place = [over.shown_formula(PLACE.format(n=gap.number)) for gap in gaps]
    cell = cell.sharing(symbol=over.symbol, unit=over.unit, length=over.length, n=[gap.number for gap in gaps])
    entered = cell.place(
        sheet,
        entry("name"),
        cell("k", [gap.number for gap in gaps]),
        axis_name("first", gaps, 0),
        entry("factor1"),
        axis_name("second", gaps, 1),
        entry("factor2"),
        entry("offset", unit=unit),
        entry("least", unit=unit),
        cell("gap", [gap.least for gap in gaps], unit=unit, scale=size),
        cell("at", [over.shown(gap.place) for gap in gaps], place=place, format=over.format),
    )
    cell = CELLS["gaps"]
    sheet.workings(
        entered,
        "gaps",
        "Workings",
        PRINTED + 2,
        cell("size", [gap.size for gap in gaps], unit=unit, formula=[*map(size_formula, gaps)]),
        in_si("k1", gaps, 0),
        in_si("k2", gaps, 1),
    )


def axis_name(column: str, gaps: list[ClearanceView], end: int) -> Quantity:
    """Return the column of the names of the first (0) or the second (1) axes."""
    axes = [gap.rows[end].axis for gap in gaps]
    formulas = [f"=[axes.name.{axis.number}]" for axis in axes]
    return CELLS["clearances"](column, [axis.given.name for axis in axes], formula=formulas)


def in_si(column: str, gaps: list[ClearanceView], end: int) -> Quantity:
    """Return the column of the factors of an axis, by what 1 m or rad of it is in its own unit."""
    factor, of = f"[factor{end + 1}]", {"mm": "={}*1000", "°": "=DEGREES({})"}
    formulas = [of[gap.rows[end].axis.given.unit].format(factor) for gap in gaps]
    return CELLS["gaps"](column, [gap.scales[end] for gap in gaps], formula=formulas)


def size_formula(gap: ClearanceView) -> str:
    """Return the formula of the largest size that a gap may have."""
    (i, j), pairs = (rows.axis.number for rows in gap.rows), f"[clear{gap.number}_pairs.free]"
    first = f"MAX(MAX({pairs}),0-MIN({pairs}))" if gap.table else HIGH.format(i)
    return f"=ABS([offset])+ABS([factor1])*{first}+ABS([factor2])*{HIGH.format(j)}"


def gap_chart(gap: ClearanceView) -> Chart:
    """Return the chart of a gap at its points over the turn, where it is least, and the gap to be left."""
    n, at, low = gap.number, f"clear{gap.number}_points", f"clear{gap.number}_least"
    first, last = f"[{at}.theta.1]", f"[{at}.theta.{len(gap.angles)}]"
    limit = Series("gap to be left", first, f"[clearances.least.{n}]", points=True, right=last)
    lines = (
        Series("gap", f"[{at}.theta]", f"[{at}.gap]"),
        Series("least gap", f"[{low}.theta]", f"[{low}.gap]", points=True, marker="circle"),
        replace(limit, dashed=True, color=PEAK),
    )
    about = f"Clearance {n} at the points of the sheet over the turn, where it is least, and the gap to be left"
    axes = f"{gap.over.angle} θ [°]", f"gap [{gap.unit}]"
    return Chart(f"[clearances.name.{n}]", *axes, lines, about, (0, TURN, 60), legend=False)


def pairs(sheet: Sheet, gap: ClearanceView, table: FreePositions) -> None:
    """Declare the pairs of a clearance: what is entered, and the lines between them."""
    n, units = gap.number, [rows.axis.given.unit for rows in gap.rows]
    column = table_of(FreePosition).columns(gap.given.pairs, f"clearances.{n - 1}.pairs", PAIRS)
    after = [(f"[clear{n}_pairs.at.{k}]", f"[clear{n}_pairs.free.{k}]") for k in range(2, PAIRS + 1)]
    slopes = [f"IF(COUNT({at})=1,({free}-[free])/({at}-[at]),0)" for at, free in after]
    sheet.row += 1
    per, steepest = f"{units[1]}/{units[0]}", float(np.abs(table.slopes).max())
    begins = filled(table.at.tolist(), PAIRS, float(table.at[-1]))
    falls = filled(table.slopes.tolist(), PAIRS, 0.0)
    cell = CELLS["pairs"].sharing(unit=units[0], n=n, near=table.near)
    cell.place(
        sheet,
        column("at", unit=units[0]),
        column("free", unit=units[1]),
        cell("begin", begins, scale=float(np.ptp(table.at))),
        cell("slope", falls, unit=per, line=[*slopes, "0*[k]"], scale=steepest),
    )
    sheet.rows(cell("clear{n}_pairs_used", len(table.at)), cell("clear{n}_near", table.near))


def covered_check(gap: ClearanceView, table: FreePositions) -> Quantity:
    """Return the check that the table covers the travel of the first axis."""
    cell = CELLS["covered_check"]
    n, axis = gap.number, gap.rows[0].axis
    low, high = shown(np.array(axis.motion.reach), axis.unit).tolist()
    is_covered = bool(low >= table.at[0] - table.near and high <= table.at[-1] + table.near)
    return cell("clear{n}_covered", is_covered, n=n, number=axis.number)


def clearance_check(gap: ClearanceView) -> Quantity:
    """Return the check of a clearance."""
    cell = CELLS["clearance_check"]
    n, after, unit = gap.number, gap.over.after, gap.unit
    least, entered, at = (f"[clearances.{name}.{n}]" for name in ("gap", "least", "at"))
    place = amount(least, gap.least, ": ", f" {unit} at ")
    says = f'[clearances.name.{n}]&{place.says}&ROUND({at},{AT})&"{after}; expected at least "&{entered}&" {unit}"'
    sentence = f"{round(gap.over.shown(gap.place), AT):.15g}{after}; expected at least {gap.given.least:.15g} {unit}"
    words = CheckSentence(says, f"{gap.given.name}{place.text}{sentence}")
    return cell("clear{n}_kept", gap.is_left, n=n, says=words)


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


def at_angles(gap: ClearanceView, angles: Array) -> list[Quantity]:
    """Return the columns of both axes at angles of the column theta: piece, u, position; and the gap."""
    cell = CELLS["at_angles"].sharing(size=gap.size)
    cells, n = [], gap.number
    for rows, mark, of, y in zip(gap.rows, MARKS, OF, gap.positions(angles), strict=True):
        axis, unshifted = rows.axis, rows.axis.unshifted(si(angles, DEGREE))
        late, place = f"[axes_taken.late.{axis.number}]", at_sample(rows.pieces, 0, mark)
        own = f"({place})*1000" if axis.given.unit == "mm" else f"DEGREES({place})"
        each = cell.sharing(mark=mark, of=of, late=late, number=axis.number)
        cells += [
            each("p{mark}", shown(unshifted.x, DEGREE)),
            *workings_at(rows.pieces, f"p{mark}", unshifted.x, of, mark),
            each("y{mark}", y, unit=axis.given.unit, own=own),
        ]
    first = "[ya]"
    if gap.table:
        y, first = gap.positions(angles)[0], "[free]"
        cells += [cell("line", gap.table.row(y) + 1.0, n=n), cell("free", gap.table.position(y), unit=gap.unit, n=n)]
    return [*cells, cell("gap", gap.gaps(angles), unit=gap.unit, n=n, first=first)]


def least(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare the positions of both axes, and the gap, at the lowest of the points and at that of the parabolas."""
    cell = CELLS["least"].sharing(n=gap.number, angle=gap.over.angle, column=["gap", "low"])
    cell.place(
        sheet,
        cell("k", [1, 2]),
        cell("point", [row + 1 for row in gap.lowest_rows]),
        cell("theta", gap.lowest_at, scale=TURN),
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
        place, most = at_sample(rows.pieces, 1, mark), rows.axis.motion.size(1)
        unit = rows.at.unit(1)
        speeds.append(cell("v{mark}", values, mark=mark, of=of, unit=unit, sampled=place, scale=most))
    cell.place(
        sheet,
        cell("theta", angles, angle=gap.over.angle, last_part=last_part, scale=TURN),
        *at_angles(gap, angles),
        *speeds,
        cell("slope", gap.slopes, of_first=of_first, scale=float(np.abs(gap.slopes).max())),
        cell("fall", low.fall, scale=size),
        cell("share", low.share),
        cell("low", low.gap, scale=size),
    )


def cuts(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare where the pieces of both axes begin, and further parts of them, from 0 to 360°."""
    cell = CELLS["cuts"]
    cells = []
    names = PARTS_OF[gap.parts]
    for end, (rows, mark, of) in enumerate(zip(gap.rows, MARKS, OF, strict=True)):
        i = rows.axis.number
        begin, span = (f"INDEX([axis{i}_pieces.{name}],[r])" for name in ("begin", "d"))
        if rows.room < len(gap.cuts(end)[0]):
            begin, span = f"IF([r]>{rows.room},360,{begin})", f"IF([r]>{rows.room},0,{span})"
        places = [f"{begin}+[axes_taken.late.{i}]"]
        places += [f"[begin{mark}]+DEGREES({span}*{k}/{gap.parts})" for k in range(1, gap.parts)]
        cells += [
            cell("{name}{mark}", values, name=name, mark=mark, of=of, words=words, place=place)
            for (name, words), place, values in zip(names, places, gap.cuts(end), strict=True)
        ]
    cell.sharing(number=gap.number).place(sheet, *cells)
