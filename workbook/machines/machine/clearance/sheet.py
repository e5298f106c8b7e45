"""The sheet Clearances: how near axes come to each other that must stay apart, and where."""

import numpy as np

from engine.laws.base import Array
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.sentence import Said, amount
from workbook.entries.phase import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.clearance.gap import Apart
from workbook.motion.pieces import finding, sampled

ABOUT = (
    "The gap is worked out where a piece of either axis begins or has its middle; between two of these places it is "
    "taken as a parabola, by the slope at the first, and worked out at the lowest point of all parabolas."
)
AT = 3
"""decimals of a place in a sentence"""
EXACT = "at most 0.1 % of what both axes move above the exact one"
AXES = "ab"
OF = "first axis: ", "second axis: "
"""what the names of their columns end with, and their labels begin with"""
LOWEST = (("theta", "nearest"), ("angle", "near"))
"""the columns of an angle, and of whether the gap is least there: of points, and of parabolas"""
PLACE = (
    "IF([clear{n}_least.gap.first]<=[clear{n}_least.gap.last]+check_zero*[gaps.size.{n}],"
    "[clear{n}_least.theta.first],[clear{n}_least.theta.last])"
)
PRINTED = 12
"""columns: what is entered, and the least gaps"""


def clearances_sheet(book: Book, apart: list[Apart]) -> None:
    """Declare the sheet, where there are clearances."""
    if not apart:
        return
    about = f"Axes that must stay apart: the least gap over a {apart[0].over.period}, and where it is."
    sheet = book.sheet("Clearances", about)
    sheet.heading("Enter")
    sheet.note("gap = offset + factor · position + factor · position, in the unit of the first axis.")
    table(sheet, apart)
    sheet.checks(*(kept(one) for one in apart))
    sheet.not_printed_below()
    for one in apart:
        sheet.heading(f"Workings: clearance {one.number}", ABOUT)
        least(sheet, one)
        points(sheet, one)
        cuts(sheet, one)
    sheet.print_columns, sheet.folded = PRINTED, PRINTED + 1


def table(sheet: Sheet, apart: list[Apart]) -> None:
    """Declare what is entered, and the least gaps."""

    def axis(end: int) -> list[str]:
        return [f"=[axes.name.{one.rows[end].axis.number}]" for one in apart]

    def each(formula: str) -> list[str]:
        numbers = [(one.number, *(rows.axis.number for rows in one.rows)) for one in apart]
        return [f"={formula.format(n=n, i=i, j=j)}" for n, i, j in numbers]

    def scale(end: int, factor: str) -> list[str]:
        units = [one.rows[end].axis.given.unit for one in apart]
        return [f"=[{factor}]*1000" if unit == "mm" else f"=DEGREES([{factor}])" for unit in units]

    over, units = apart[0].over, {one.unit for one in apart}
    unit = units.pop() if len(units) == 1 else "mm, °"
    high = "MAX(ABS([axes.low.{0}]),ABS([axes.high.{0}]))"
    size = f"ABS([offset])+ABS([factor1])*{high.format('{i}')}+ABS([factor2])*{high.format('{j}')}"
    entered = sheet.table(
        "clearances", "Clearances", len(apart),
        given("name", "clearance", "", "", [one.given.name for one in apart], "clearances.*.name"),
        constant("k", "number", "k", "", [one.number for one in apart]),
        calc("first", "axis", "", "", axis(0), [one.rows[0].axis.given.name for one in apart], align="left"),
        given("factor1", "factor", "", "", [one.given.first_factor for one in apart], "clearances.*.first_factor",
              format="0.0##"),
        calc("second", "and axis", "", "", axis(1), [one.rows[1].axis.given.name for one in apart], align="left"),
        given("factor2", "factor", "", "", [one.given.second_factor for one in apart], "clearances.*.second_factor",
              format="0.0##"),
        given("offset", "offset", "", unit, [one.given.offset for one in apart], "clearances.*.offset", format="0.0##"),
        given("least", "gap to be left", "", unit, [one.given.least for one in apart], "clearances.*.least",
              format="0.0##"),
        result("gap", "least gap", "", unit, each("MIN([clear{n}_least.gap])"), [one.least for one in apart],
               scale=max(one.size for one in apart), source=EXACT),
        result("at", "at", over.symbol, over.unit, each(over.told(PLACE)),
               [over.shown(one.place) for one in apart], scale=over.length, format=over.format),
    )  # fmt: skip
    sheet.workings(
        entered, "gaps", "Workings", PRINTED + 2,
        calc("size", "size of the gap, at most", "", unit, each(size), [one.size for one in apart]),
        calc("k1", "its own unit in 1 m or rad", "", "", scale(0, "factor1"), [one.scales[0] for one in apart],
             source="times the first factor"),
        calc("k2", "likewise of the other axis", "", "", scale(1, "factor2"), [one.scales[1] for one in apart],
             source="times the second factor"),
    )  # fmt: skip
    sheet.rows(*(calc(one.name, f"Clearance {one.number}", "", "", f"=[clearances.name.{one.number}]",
                      one.given.name, align="left") for one in apart))  # fmt: skip


def kept(one: Apart) -> Quantity:
    """Return the check of a clearance."""
    n, after, unit = one.number, one.over.after, one.unit
    gap, entered, at = (f"[clearances.{name}.{n}]" for name in ("gap", "least", "at"))
    place = amount(gap, one.least, ": ", f" {unit} at ")
    says = f'[clearances.name.{n}]&{place.says}&ROUND({at},{AT})&"{after}; expected at least "&{entered}&" {unit}"'
    said = (
        f"{one.given.name}{place.said}{round(one.over.shown(one.place), AT):.15g}{after}; "
        f"expected at least {one.given.least:.15g} {unit}"
    )
    return check(f"clear{n}_kept", f"Clearance {n}: the gap is left", f"{gap}>={entered}-check_zero*[gaps.size.{n}]",
                 one.kept, says=Said(says, said))  # fmt: skip


def positions(one: Apart, end: int, angles: Array) -> list[Quantity]:
    """Return the columns of an axis' position at angles of the column theta: cycles begun, piece, u, position."""
    rows, mark, of = one.rows[end], AXES[end], OF[end]
    i, axis, told = rows.axis.number, rows.axis, one.told(end, angles)
    late, metres = f"[axes_taken.late.{i}]", axis.given.unit == "mm"
    place = sampled(rows.pieces, 0, mark)
    own = f"({place})*1000" if metres else f"DEGREES({place})"
    return [
        calc(f"n{mark}", f"{of}cycles of its phases begun before", "n_c", "",
             f"=INT((MIN([theta],timing_end)-{late}+eps)/360)", told.cycles, format="0"),
        calc(f"p{mark}", f"{of}angle of its phases", "", "°", f"=[theta]-{late}-360*[n{mark}]", shown(told.x, DEGREE),
             format="0.0##", scale=TURN, source="θ − shift − 360 n_c"),
        *finding(rows.pieces, f"p{mark}", told.x, of, mark),
        calc(f"y{mark}", f"{of}position", "y", axis.given.unit, f"={own}+[n{mark}]*[axes.travel.{i}]",
             one.positions(end, angles), scale=one.size),
    ]  # fmt: skip


def gap(one: Apart, angles: Array) -> Quantity:
    """Return the column of the gap at angles."""
    n = one.number
    entered = f"[clearances.offset.{n}]+[clearances.factor1.{n}]*[ya]+[clearances.factor2.{n}]*[yb]"
    return calc("gap", "gap", "", one.unit, f"={entered}", one.gaps(angles), scale=one.size,
                source="offset + factor · position + factor · position")  # fmt: skip


def least(sheet: Sheet, one: Apart) -> None:
    """Declare the positions of both axes, and the gap, at the lowest of the points and at that of the parabolas."""
    n = one.number
    at, angles = f"clear{n}_points", one.lowest_at
    lowest, between = (f"INDEX([{at}.{angle}],MATCH(1,[{at}.{near}],0))" for angle, near in LOWEST)
    sheet.table(
        f"clear{n}_least", "Where the gap is least", len(LOWEST),
        constant("k", "lowest", "", "", [1, 2], source="1 point, 2 parabola"),
        calc("theta", one.over.angle, "θ", "°", f"=IF([k]=1,{lowest},{between})", angles, scale=TURN, format="0.0##"),
        *positions(one, 0, angles), *positions(one, 1, angles), gap(one, angles),
    )  # fmt: skip


def points(sheet: Sheet, one: Apart) -> None:
    """Declare the gap and its slope at points of the cycle, and the lowest point of the parabola before each."""
    n, angles, low = one.number, one.angles, one.lowest
    at, size, first = f"[clear{n}_cuts.begina:middleb]", one.size, "=IF([k]=1,0,{})"
    lost, last, end = f"check_zero*[gaps.size.{n}]", len(angles), f"MAX([clear{n}_points.k])"
    sheet.table(
        f"clear{n}_points", "The gap over the turn", last,
        constant("k", "point", "k", "", list(range(1, last + 1))),
        calc("theta", one.over.angle, "θ", "°", f"=IF([k]={end},360,MAX(0,SMALL({at},MAX(1,[k]-1))*([k]>1)))",
             angles, scale=TURN, format="0.0##", source="0, the places below in their order, 360"),
        *positions(one, 0, angles), *positions(one, 1, angles), gap(one, angles),
        *(calc(f"v{mark}", f"{of}geometric velocity", "y'", rows.at.unit(1), f"={sampled(rows.pieces, 1, mark)}",
               values, scale=rows.axis.motion.size(1))
          for mark, of, rows, values in zip(AXES, OF, one.rows, one.velocities, strict=True)),
        calc("slope", "slope of the gap", "", f"{one.unit}/rad", f"=[gaps.k1.{n}]*[va]+[gaps.k2.{n}]*[vb]", one.slopes,
             scale=float(np.abs(one.slopes).max()), source="factor · y' + factor · y'"),
        calc("fall", "by the slope before, it rises", "g_0", one.unit,
             first.format("[slope-1]*RADIANS([theta]-[theta-1])"), low.fall, scale=size),
        calc("rise", "it rises", "g_1", one.unit, first.format("[gap]-[gap-1]"), low.rise, scale=size),
        calc("share", "lowest at this share of the way", "z", "",
             f"=IF(AND([fall]<0-{lost},[fall]<2*[rise]),[fall]/(2*([fall]-[rise])),1)", low.share,
             source="g_0/(2(g_0 − g_1)) between both points, else 1"),
        calc("low", "lowest gap on the way", "", one.unit, "=IF([share]<1,[gap-1]+[fall]*[share]/2,[gap])", low.gap,
             scale=size, source="gap before + g_0 z/2"),
        *(calc(near, f"{words} is the least of all", "", "",
               f"=IF([{name}]<=MIN([clear{n}_points.{name}])+{lost},1,0)", one.near(values), format="0")
          for near, name, words, values in (("nearest", "gap", "gap", one.gaps(angles)),
                                            ("near", "low", "lowest gap", low.gap))),
        calc("angle", "lowest at", "θ", "°", "=IF([share]<1,[theta-1]+[share]*([theta]-[theta-1]),[theta])",
             low.angle, scale=TURN, format="0.0##"),
    )  # fmt: skip


def cuts(sheet: Sheet, one: Apart) -> None:
    """Declare where the pieces of both axes begin and have their middle, from 0 to 360°."""
    columns = []
    for end, rows in enumerate(one.rows):
        i, mark, of = rows.axis.number, AXES[end], OF[end]
        begin, middle = one.cuts(end)
        late = f"INDEX([axis{i}_pieces.begin],[r])+[axes_taken.late.{i}]"
        half = f"[begin{mark}]+DEGREES(INDEX([axis{i}_pieces.d],[r])/2)"
        columns += [
            calc(f"begin{mark}", f"{of}a piece begins", "θ", "°", f"={late}-360*INT(({late}+eps)/360)", begin,
                 scale=TURN, format="0.0##"),
            calc(f"middle{mark}", f"{of}its middle", "θ", "°", f"={half}-360*INT(({half}+eps)/360)", middle,
                 scale=TURN, format="0.0##"),
        ]  # fmt: skip
    room = one.rows[0].machine.room
    sheet.table(
        f"clear{one.number}_cuts", "The pieces of both axes over the turn", room,
        constant("r", "piece", "k", "", list(range(1, room + 1))), *columns,
    )  # fmt: skip
