"""The sheet Clearances: how near axes come to each other that must stay apart, exact by the motions' pieces."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from engine.motion.nearing import NODES, Nearing
from engine.motion.turning import PARTS
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.sentence import Said, rounded
from workbook.book.sentence import shown as figure
from workbook.entries.turn import TURN
from workbook.machines.machine.apart import GRID, Apart, begins
from workbook.motion.sampled import derivative

ABOUT = (
    "The turn is cut where a piece of either axis begins, and into {} parts: in each the gap has one lowest place at "
    "most. Where its slope turns from falling to rising, that place is narrowed by counting points."
)
LATE = "([{0}]-[axes_taken.late.{1}])"
FINER = ("", "/100", "/10000")
PRINTED = 12
"""columns: what is entered, and the least gaps"""


def clearances_sheet(book: Book, apart: list[Apart]) -> None:
    """Declare the sheet, where there are clearances."""
    if not apart:
        return
    sheet = book.sheet(
        "Clearances", f"Axes that must stay apart: the least gap over a {apart[0].over.period}, and where it is."
    )
    sheet.heading("Enter")
    sheet.note("gap = offset + factor · position + factor · position, in the unit of the first axis.")
    table(sheet, apart)
    sheet.checks(*(kept(one) for one in apart))
    sheet.not_printed_below()
    for one in apart:
        sheet.heading(f"Workings: clearance {one.number}", ABOUT.format(NODES))
        breaks(sheet, one)
        stretches(sheet, one)
    sheet.print_columns, sheet.folded = PRINTED, PRINTED + 1


def table(sheet: Sheet, apart: list[Apart]) -> None:
    """Declare what is entered, and the least gaps."""

    def axis(end: int) -> list[str]:
        return [f"=[axes.name.{one.rows[end].axis.number}]" for one in apart]

    def each(formula: str) -> list[str]:
        return [
            f"={formula.format(n=one.number, i=one.rows[0].axis.number, j=one.rows[1].axis.number)}" for one in apart
        ]

    def scale(end: int, factor: str) -> list[str]:
        units = [one.rows[end].axis.given.unit for one in apart]
        return [f"=[{factor}]*1000" if unit == "mm" else f"=DEGREES([{factor}])" for unit in units]

    over = apart[0].over
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
        given("offset", "offset", "", "", [one.given.offset for one in apart], "clearances.*.offset", format="0.0##"),
        given("least", "gap to be left", "", "", [one.given.least for one in apart], "clearances.*.least",
              format="0.0##"),
        result("gap", "least gap", "", "", each("MIN([clear{n}_st.least])"), [one.gap.least for one in apart],
               scale=max(one.size for one in apart), source="exact, in the unit of the first axis"),
        result("at", "at", over.symbol, over.unit,
               each(over.told("INDEX([clear{n}_st.place],MATCH(1,[clear{n}_st.near],0))")),
               [over.shown(one.place) for one in apart], scale=over.length, format=over.format),
    )  # fmt: skip
    sheet.workings(
        entered, "gaps", "Workings", PRINTED + 2,
        calc("size", "size of the gap, at most", "", "", each(size), [one.size for one in apart]),
        calc("k1", "its own unit in 1 m or rad", "", "", scale(0, "factor1"), [one.scales[0] for one in apart],
             source="times the first factor"),
        calc("k2", "likewise of the other axis", "", "", scale(1, "factor2"), [one.scales[1] for one in apart],
             source="times the second factor"),
        calc("steep", "slope of the gap, at most", "", "",
             each("ABS([k1])*MAX([axis{i}.y1])+ABS([k2])*MAX([axis{j}.y1])"), [one.steep for one in apart]),
    )  # fmt: skip
    sheet.rows(*(calc(one.name, f"Clearance {one.number}", "", "", f"=[clearances.name.{one.number}]",
                      one.given.name, align="left") for one in apart))  # fmt: skip


def kept(one: Apart) -> Quantity:
    """Return the check of a clearance."""
    n = one.number
    gap, least, at = (f"[clearances.{name}.{n}]" for name in ("gap", "least", "at"))
    lacking, unit = f"{least}-{gap}", one.rows[0].axis.given.unit
    says = f'[clearances.name.{n}]&": "&{figure(gap)}&" {unit} at "&{figure(at)}&"{one.over.after}, "&{figure(lacking)}'
    short = rounded(one.given.least - one.gap.least)
    said = (
        f"{one.given.name}: {rounded(one.gap.least)} {unit} at {rounded(one.over.shown(one.place))}{one.over.after}, "
    )
    condition = f"{gap}>={least}-check_zero*[gaps.size.{n}]"
    return check(f"clear{n}_kept", f"Clearance {n}: the gap is left", condition, one.kept,
                 says=Said(f'{says}&" {unit} too little"', f"{said}{short} {unit} too little"))  # fmt: skip


def place_of(k: int, one: Nearing) -> float:
    """Return the lowest place of a stretch after a round."""
    return one.places[k]


def breaks(sheet: Sheet, one: Apart) -> None:
    """Declare where a stretch can begin."""
    formulas = []
    for rows in one.rows:
        i = rows.axis.number
        for r in range(1, len(begins(rows)) + 1):
            told = f"([axis{i}_pieces.begin.{r}]+[axes_taken.late.{i}])"
            formulas.append(f"={told}-360*INT(({told}+timing_eps)/360)")
    formulas += [f"={at:.15g}+0" for at in (*GRID, TURN)]
    sheet.table(
        f"clear{one.number}_breaks", "Where a stretch can begin", len(formulas),
        constant("n", "number", "", "", list(range(1, len(formulas) + 1))),
        calc("at", one.over.angle, "θ", "°", formulas, one.breaks, scale=TURN, format="0.0##"),
    )  # fmt: skip


def found(one: Apart, end: int) -> list[Quantity]:
    """Return which cycle and which piece of an axis each stretch has, and where it begins in it."""
    rows, mark = one.rows[end], ("1", "2")[end]
    i, told = rows.axis.number, one.told(end)
    angle = f"([b]+[e])/2-[axes_taken.late.{i}]"
    begin = f"INDEX([axis{i}_pieces.begin],[q{mark}])"
    return [
        calc(f"n{mark}", "cycles", "n", "", f"=INT(({angle}+timing_eps)/360)", [one[0] for one in told], format="0"),
        calc(f"q{mark}", "piece", "q", "", f"=MATCH({angle}-360*[n{mark}],[axis{i}_pieces.begin],1)",
             [one[1] for one in told], format="0"),
        calc(f"u{mark}", "from", "u", "rad", f"=RADIANS([b]-[axes_taken.late.{i}]-360*[n{mark}]-{begin})",
             [one[2] for one in told], scale=1.0),
    ]  # fmt: skip


def stretches(sheet: Sheet, one: Apart) -> None:
    """Declare the stretches, each with its least gap."""
    n, of = one.number, one.of
    first, second = (rows.axis.number for rows in one.rows)
    breaks_at = f"[clear{n}_breaks.at]"
    same, lost = f"check_zero*[gaps.size.{n}]", f"check_zero*[gaps.steep.{n}]"
    begin = ["=0*[k]", *("=IF([e-1]>=360-timing_eps,[b-1],[e-1])" for _ in range(1, one.room))]

    def both(order: int) -> Callable[[str], str]:
        def at(w: str) -> str:
            each = [derivative(rows.pieces, order, mark, f"([u{mark}]+{w})")
                    for rows, mark in zip(one.rows, "12", strict=True)]  # fmt: skip
            return f"[gaps.k1.{n}]*({each[0]})+[gaps.k2.{n}]*({each[1]})"

        return at

    slope = both(1)
    moved = f"[clearances.factor1.{n}]*[n1]*[axes.travel.{first}]+[clearances.factor2.{n}]*[n2]*[axes.travel.{second}]"

    def gap(w: str) -> str:
        return f"[clearances.offset.{n}]+{moved}+{both(0)(w)}"

    def narrower(k: int) -> str:
        at, step = ("" if k == 0 else f"[w{k}]+"), f"[h]{FINER[k]}"
        count = f"MIN({PARTS - 1},SUMPRODUCT(({slope(f'({at}{step}*[grid.at])')}<0-{lost})*1))"
        return f"=IF([x]=0,0,{at}{step}*({count}{'+0.5' if k == 2 else ''})/{PARTS})"

    size = one.size
    sheet.table(
        f"clear{n}_st", "Stretches", one.room,
        constant("k", "stretch", "k", "", list(range(1, one.room + 1))),
        calc("b", "begins at", "θ", "°", begin, one.ends(0), scale=TURN, format="0.0##"),
        calc("e", "ends at", "θ", "°", f"=SMALL({breaks_at},SUMPRODUCT(({breaks_at}<=[b]+timing_eps)*1)+1)",
             one.ends(1), scale=TURN, format="0.0##"),
        *found(one, 0), *found(one, 1),
        calc("h", "width", "", "rad", "=RADIANS([e]-[b])", of(lambda p: p.high - p.low), scale=1.0),
        calc("s0", "slope at its begin", "", "", f"={slope('0')}", of(lambda p: p.slopes[0]), scale=one.steep),
        calc("s1", "at its end", "", "", f"={slope('[h]')}", of(lambda p: p.slopes[1]), scale=one.steep),
        calc("x", "has a lowest place inside", "", "", f"=IF(AND([s0]<0-{lost},[s1]>{lost}),1,0)",
             of(lambda p: int(p.turns)), format="0"),
        *(calc(f"w{k + 1}", "where" if k == 2 else "not before", "", "rad", narrower(k),
               of(partial(place_of, k)), scale=1.0) for k in range(len(FINER))),
        calc("g0", "gap at its begin", "", "", f"={gap('0')}", of(lambda p: p.gaps[0]), scale=size),
        calc("g1", "at its end", "", "", f"={gap('[h]')}", of(lambda p: p.gaps[1]), scale=size),
        calc("gm", "inside", "", "", f"={gap('[w3]')}", of(lambda p: p.gaps[2]), scale=size),
        calc("least", "least", "", "", "=MIN([g0],[g1],[gm])", of(lambda p: p.least), scale=size),
        calc("near", "is the least of all", "", "", f"=IF([least]<=[clearances.gap.{n}]+{same},1,0)", of(one.near),
             format="0"),
        calc("place", "there", "θ", "°",
             f"=IF([gm]<MIN([g0],[g1])-{same},[b]+DEGREES([w3]),IF([g1]<[g0]-{same},[e],[b]))",
             of(one.where), scale=TURN, format="0.0##"),
    )  # fmt: skip
