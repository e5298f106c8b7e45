"""The sheet Clearances: axes that must stay apart, their gap over the cycle, and where it is least."""

import numpy as np

from engine.laws.base import Array
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, columns_of, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import CheckSentence, amount
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import PAIRS
from workbook.machines.machine.file_layout import pairs_name
from workbook.machines.machine.gap import PARTS, PARTS_BY_PAIRS, ClearanceView, FreePositions
from workbook.motion.pieces import finding, sampled

ABOUT = (
    "The gap is worked out where a piece of either axis begins or has its middle, with pairs also at its quarters; "
    "between two of these places it is taken as a parabola, by the slope at the first, and worked out at the lowest "
    "point of all parabolas."
)
BY_TABLE = (
    "With pairs below, the free position of the second axis takes the place of the first one's position, on straight "
    "lines between the pairs; the gap is in the unit of the second axis."
)
BEGIN, MIDDLE = ("begin", "a piece begins"), ("middle", "its middle")
PARTS_OF = {
    PARTS: (BEGIN, MIDDLE),
    PARTS_BY_PAIRS: (BEGIN, ("first", "its first quarter"), MIDDLE, ("last", "its last")),
}
STATED = (
    "at most 0.1 % of what both axes move above the exact one, by pairs a quarter; build and verify judge the exact one"
)
AT = 3  # decimals of a place in a sentence
MARKS, OF = "ab", ("first axis: ", "second axis: ")
"""what the names of both axes' columns end with, and their labels begin with"""
PLACE = (
    "IF([clear{n}_least.gap.first]<=[clear{n}_least.gap.last]+check_zero*[gaps.size.{n}],"
    "[clear{n}_least.theta.first],[clear{n}_least.theta.last])"
)
HIGH = "MAX(ABS([axes.low.{0}]),ABS([axes.high.{0}]))"
SIZE_BY_TABLE = (
    f"ABS([offset])+ABS([factor1])*MAX(MAX([clear{{n}}_pairs.free]),0-MIN([clear{{n}}_pairs.free]))"
    f"+ABS([factor2])*{HIGH.format('{j}')}"
)
SIZE = f"ABS([offset])+ABS([factor1])*{HIGH.format('{i}')}+ABS([factor2])*{HIGH.format('{j}')}"
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
    sheet.heading("The gap over the cycle")
    for k in range(0, len(gaps), 2):
        sheet.chart_row(*map(gap_chart, gaps[k : k + 2]), width=PRINTED // 2)
    sheet.not_printed_below()
    for gap in gaps:
        sheet.heading(f"Workings: clearance {gap.number}", ABOUT)
        least(sheet, gap)
        points(sheet, gap)
        cuts(sheet, gap)
    sheet.print_columns, sheet.folded = PRINTED, PRINTED + 1


def table(sheet: Sheet, gaps: list[ClearanceView]) -> None:
    """Declare what is entered, and the least gaps."""
    over, units, axes = gaps[0].over, {gap.unit for gap in gaps}, [[rows.axis for rows in gap.rows] for gap in gaps]
    unit = units.pop() if len(units) == 1 else "mm, °"

    def entry(column: str, label: str, unit: str, name: str) -> Quantity:
        values = [getattr(gap.given, name) for gap in gaps]
        return given(column, label, "", unit, values, f"clearances.*.{name}", format="0.0##")

    def named(end: int, column: str, label: str) -> Quantity:
        formulas = [f"=[axes.name.{both[end].number}]" for both in axes]
        return calc(column, label, "", "", formulas, [both[end].given.name for both in axes], align="left")

    def scale(end: int, label: str, which: str) -> Quantity:
        factor, at = f"[factor{end + 1}]", f"k{end + 1}"
        formulas = [f"={factor}*1000" if both[end].given.unit == "mm" else f"=DEGREES({factor})" for both in axes]
        return calc(at, label, "", "", formulas, [gap.scales[end] for gap in gaps], source=f"times the {which} factor")

    def each(formula: str, by_table: str = "") -> list[str]:
        numbers = zip(gaps, axes, strict=True)
        return [f"={((gap.table and by_table) or formula).format(n=gap.number, i=i.number, j=j.number)}"
                for gap, (i, j) in numbers]  # fmt: skip

    entered = sheet.table(
        "clearances", "Clearances", len(gaps),
        given("name", "clearance", "", "", [gap.given.name for gap in gaps], "clearances.*.name"),
        constant("k", "number", "k", "", [gap.number for gap in gaps]),
        named(0, "first", "axis"), entry("factor1", "factor", "", "first_factor"),
        named(1, "second", "and axis"), entry("factor2", "factor", "", "second_factor"),
        entry("offset", "offset", unit, "offset"), entry("least", "gap to be left", unit, "least"),
        result("gap", "least gap", "", unit, each("MIN([clear{n}_least.gap])"), [gap.least for gap in gaps],
               scale=max(gap.size for gap in gaps), source=STATED),
        result("at", "at", over.symbol, over.unit, each(over.shown_formula(PLACE)),
               [over.shown(gap.place) for gap in gaps], scale=over.length, format=over.format),
    )  # fmt: skip
    sheet.workings(
        entered, "gaps", "Workings", PRINTED + 2,
        calc("size", "size of the gap, at most", "", unit, each(SIZE, SIZE_BY_TABLE), [gap.size for gap in gaps]),
        scale(0, "its own unit in 1 m or rad", "first"), scale(1, "likewise of the other axis", "second"),
    )  # fmt: skip
    sheet.rows(*(calc(gap.name, f"Clearance {gap.number}", "", "", f"=[clearances.name.{gap.number}]",
                      gap.given.name, align="left") for gap in gaps))  # fmt: skip


def gap_chart(gap: ClearanceView) -> Chart:
    """Return the chart of a gap at its points over the turn, with the gap to be left."""
    at, least = f"clear{gap.number}_points", f"clear{gap.number}_least"
    over = Series(f"={gap.name}", f"[{at}.theta]", f"[{at}.gap]")
    lines = over, Series("least gap", f"[{least}.theta]", f"[{least}.gap]", points=True, marker="circle")
    title = f"Clearance {gap.number}"
    about = f"{title} at the points of the sheet over the turn, and where it is least"
    return Chart(title, f"{gap.over.angle} θ [°]", f"gap [{gap.unit}]", lines, about, (0, TURN, 60))


def pairs(sheet: Sheet, gap: ClearanceView, table: FreePositions) -> None:
    """Declare the pairs of a clearance: what is entered, and the lines between them."""
    n, units = gap.number, [rows.axis.given.unit for rows in gap.rows]
    column = columns_of(gap.given.pairs, f"clearances.{n - 1}.pairs", PAIRS)
    after = [(f"[clear{n}_pairs.at.{k}]", f"[clear{n}_pairs.free.{k}]") for k in range(2, PAIRS + 1)]
    slopes = [f"=IF(COUNT({at})=1,({free}-[free])/({at}-[at]),0)" for at, free in after]
    sheet.row += 1
    sheet.table(
        f"clear{n}_pairs", f"Clearance {n}: how far the second axis is free; leave spare rows empty", PAIRS,
        constant("k", "pair", "k", "", list(range(1, PAIRS + 1))),
        column("at", "position of the first axis", "", units[0], "at", "rises strictly", format="0.0##"),
        column("free", "free position of the second", "", units[1], "free", format="0.0##"),
        calc("begin", "a line begins at", "", units[0], f"=IF(COUNT([at])=1,[at],MAX([clear{n}_pairs.at]))",
             filled(table.at.tolist(), PAIRS, float(table.at[-1])), scale=float(np.ptp(table.at))),
        calc("slope", "slope to the next", "", f"{units[1]}/{units[0]}", [*slopes, "=0*[k]"],
             filled(table.slopes.tolist(), PAIRS, 0.0), scale=float(np.abs(table.slopes).max())),
    )  # fmt: skip
    sheet.rows(
        calc(pairs_name(n), f"Pairs of clearance {n}", "", "", f"=COUNT([clear{n}_pairs.at])", len(table.at),
             format="0"),
        calc(f"clear{n}_near", "So near below a pair counts as at it", "", units[0],
             f"=check_zero*(MAX([clear{n}_pairs.at])-MIN([clear{n}_pairs.at]))", table.near, format="0E+00",
             scale=table.near),
    )  # fmt: skip


def covered_check(gap: ClearanceView, table: FreePositions) -> Quantity:
    """Return the check that the table covers the travel of the first axis."""
    n, axis = gap.number, gap.rows[0].axis
    near, at = f"clear{n}_near", f"[clear{n}_pairs.at]"
    ends = [f"[axes.{end}.{axis.number}]" for end in ("low", "high")]
    low, high = shown(np.array(axis.motion.reach), axis.unit).tolist()
    is_covered = bool(low >= table.at[0] - table.near and high <= table.at[-1] + table.near)
    return check(f"clear{n}_covered", f"Clearance {n}: the pairs cover the travel of the first axis",
                 f"AND({ends[0]}>=MIN({at})-{near},{ends[1]}<=MAX({at})+{near})", is_covered)  # fmt: skip


def clearance_check(gap: ClearanceView) -> Quantity:
    """Return the check of a clearance."""
    n, after, unit = gap.number, gap.over.after, gap.unit
    least, entered, at = (f"[clearances.{name}.{n}]" for name in ("gap", "least", "at"))
    place = amount(least, gap.least, ": ", f" {unit} at ")
    says = f'[clearances.name.{n}]&{place.says}&ROUND({at},{AT})&"{after}; expected at least "&{entered}&" {unit}"'
    said = f"{round(gap.over.shown(gap.place), AT):.15g}{after}; expected at least {gap.given.least:.15g} {unit}"
    return check(f"clear{n}_kept", f"Clearance {n}: the gap is left", f"{least}>={entered}-check_zero*[gaps.size.{n}]",
                 gap.is_left, says=CheckSentence(says, f"{gap.given.name}{place.said}{said}"))  # fmt: skip


def gap_slope(n: int) -> str:
    """Return the formula of the slope of the line on which the first axis of a clearance with pairs is."""
    return f"INDEX([clear{n}_pairs.slope],[line])"


def at_angles(gap: ClearanceView, angles: Array) -> list[Quantity]:
    """Return the columns of both axes at angles of the column theta: cycles begun, piece, u, position; and the gap."""
    found, n = [], gap.number
    for rows, mark, of, y in zip(gap.rows, MARKS, OF, gap.positions(angles), strict=True):
        axis, told = rows.axis, rows.axis.unshifted(si(angles, DEGREE))
        late, place = f"[axes_taken.late.{axis.number}]", sampled(rows.pieces, 0, mark)
        own = f"({place})*1000" if axis.given.unit == "mm" else f"DEGREES({place})"
        found += [
            calc(f"n{mark}", f"{of}cycles of its phases begun before", "n_c", "",
                 f"=INT((MIN([theta],timing_end)-{late}+eps)/360)", told.cycles, format="0"),
            calc(f"p{mark}", f"{of}angle of its phases", "", "°", f"=[theta]-{late}-360*[n{mark}]",
                 shown(told.x, DEGREE), format="0.0##", scale=TURN, source="θ − shift − 360 n_c"),
            *finding(rows.pieces, f"p{mark}", told.x, of, mark),
            calc(f"y{mark}", f"{of}position", "y", axis.given.unit, f"={own}+[n{mark}]*[axes.travel.{axis.number}]",
                 y, scale=gap.size),
        ]  # fmt: skip
    first = "[ya]"
    if gap.table:
        y, first = gap.positions(angles)[0], "[free]"
        line, at = f"MATCH([ya]+clear{n}_near,[clear{n}_pairs.begin],1)", f"[clear{n}_pairs.at.first]"
        found += [
            calc("line", "line of the table", "", "", f"=IF([ya]<{at},1,MIN({pairs_name(n)}-1,{line}))",
                 gap.table.row(y) + 1.0, format="0"),
            calc("free", "free position of the second", "", gap.unit,
                 f"=INDEX([clear{n}_pairs.free],[line])+{gap_slope(n)}*([ya]-INDEX([clear{n}_pairs.at],[line]))",
                 gap.table.position(y), scale=gap.size),
        ]  # fmt: skip
    entered = f"[clearances.offset.{n}]+[clearances.factor1.{n}]*{first}+[clearances.factor2.{n}]*[yb]"
    return [*found, calc("gap", "gap", "", gap.unit, f"={entered}", gap.gaps(angles), scale=gap.size,
                         source="offset + factor · position + factor · position")]  # fmt: skip


def least(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare the positions of both axes, and the gap, at the lowest of the points and at that of the parabolas."""
    first = f"INDEX([clear{gap.number}_points.{{}}],MATCH(1,[clear{gap.number}_points.{{}}],0))".format
    place = f"=IF([k]=1,{first('theta', 'nearest')},{first('angle', 'near')})"
    sheet.table(
        f"clear{gap.number}_least", "Where the gap is least", 2,
        constant("k", "lowest", "", "", [1, 2], source="1 point, 2 parabola"),
        calc("theta", gap.over.angle, "θ", "°", place, gap.lowest_at, scale=TURN, format="0.0##"),
        *at_angles(gap, gap.lowest_at),
    )  # fmt: skip


def points(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare the gap and its slope at points of the cycle, and the lowest point of the parabola before each."""
    n, angles, low = gap.number, gap.angles, gap.lowest
    at, size, first = f"[clear{n}_cuts.begina:{PARTS_OF[gap.parts][-1][0]}b]", gap.size, "=IF([k]=1,0,{})"
    by = f"*{gap_slope(n)}" if gap.table else ""
    lost, last, end = f"check_zero*[gaps.size.{n}]", len(angles), f"MAX([clear{n}_points.k])"
    sheet.table(
        f"clear{n}_points", "The gap over the turn", last,
        constant("k", "point", "k", "", list(range(1, last + 1))),
        calc("theta", gap.over.angle, "θ", "°", f"=IF([k]={end},360,MAX(0,SMALL({at},MAX(1,[k]-1))*([k]>1)))",
             angles, scale=TURN, format="0.0##", source="0, the places below in their order, 360"),
        *at_angles(gap, angles),
        *(calc(f"v{mark}", f"{of}geometric velocity", "y'", rows.at.unit(1), f"={sampled(rows.pieces, 1, mark)}",
               values, scale=rows.axis.motion.size(1))
          for mark, of, rows, values in zip(MARKS, OF, gap.rows, gap.velocities, strict=True)),
        calc("slope", "slope of the gap", "", f"{gap.unit}/rad", f"=[gaps.k1.{n}]*[va]{by}+[gaps.k2.{n}]*[vb]",
             gap.slopes, scale=float(np.abs(gap.slopes).max()), source="factor · y' + factor · y'"),
        calc("fall", "by the slope before, it rises", "g_0", gap.unit,
             first.format("[slope-1]*RADIANS([theta]-[theta-1])"), low.fall, scale=size),
        calc("rise", "it rises", "g_1", gap.unit, first.format("[gap]-[gap-1]"), low.rise, scale=size),
        calc("share", "lowest at this share of the way", "z", "",
             f"=IF(AND([fall]<0-{lost},[fall]<2*[rise]),[fall]/(2*([fall]-[rise])),1)", low.share,
             source="g_0/(2(g_0 − g_1)) between both points, else 1"),
        calc("low", "lowest gap on the way", "", gap.unit, "=IF([share]<1,[gap-1]+[fall]*[share]/2,[gap])", low.gap,
             scale=size, source="gap before + g_0 z/2"),
        *(calc(near, f"{words} is the least of all", "", "",
               f"=IF([{name}]<=MIN([clear{n}_points.{name}])+{lost},1,0)", gap.near(values), format="0")
          for near, name, words, values in (("nearest", "gap", "gap", gap.gaps(angles)),
                                            ("near", "low", "lowest gap", low.gap))),
        calc("angle", "lowest at", "θ", "°", "=IF([share]<1,[theta-1]+[share]*([theta]-[theta-1]),[theta])",
             low.angle, scale=TURN, format="0.0##"),
    )  # fmt: skip


def cuts(sheet: Sheet, gap: ClearanceView) -> None:
    """Declare where the pieces of both axes begin, and further parts of them, from 0 to 360°."""
    columns, room = [], gap.rows[0].machine.room
    names = PARTS_OF[gap.parts]
    for end, (rows, mark, of) in enumerate(zip(gap.rows, MARKS, OF, strict=True)):
        i = rows.axis.number
        places = [f"INDEX([axis{i}_pieces.begin],[r])+[axes_taken.late.{i}]"]
        span = f"DEGREES(INDEX([axis{i}_pieces.d],[r])"
        places += [f"[begin{mark}]+{span}*{k}/{gap.parts})" for k in range(1, gap.parts)]
        columns += [
            calc(f"{name}{mark}", f"{of}{words}", "θ", "°", f"={place}-360*INT(({place}+eps)/360)", values, scale=TURN,
                 format="0.0##")
            for (name, words), place, values in zip(names, places, gap.cuts(end), strict=True)
        ]  # fmt: skip
    sheet.table(f"clear{gap.number}_cuts", "The pieces of both axes over the turn", room,
                constant("r", "piece", "k", "", list(range(1, room + 1))), *columns)  # fmt: skip
