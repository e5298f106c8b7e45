"""The phases of one axis on the Timing sheet: what is entered, what each movement comes to, and the checks."""

from collections.abc import Callable
from typing import Any

from engine.motion import Phase
from workbook.book.declare import Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount, first_text
from workbook.entries.abscissa import Abscissa
from workbook.entries.phase import AT_REST
from workbook.entries.units import shown
from workbook.laws import sampling
from workbook.laws.page import finite
from workbook.laws.sampling import ACCELERATION, JERK, LAW_NUMBER, RMS, VELOCITY
from workbook.machines.machine.entries import OPEN_DRIVE
from workbook.machines.machine.motion.tables import AxisRows
from workbook.motion.asked import entries
from workbook.motion.pieces import room_check


def phases_table(sheet: Sheet, one: AxisRows) -> None:
    """Declare the phases of an axis."""
    measured, geometric = one.machine.over.measured, geometric_extremes(one)
    sheet.table(
        one.name, f"Phases of axis {one.axis.number}: fill one row each, in order; between them it rests; "
        "leave spare rows empty", one.rows,
        *entered(one), *passing(one), reached(one), *([] if measured else geometric), *extremes(one),
        *used(one), *(geometric if measured else []), *faults(one),
        rules=[AT_REST],
    )  # fmt: skip


def entry(one: AxisRows, name: str) -> list[Any]:
    """Return what is entered in a column, and nothing in spare rows."""
    return filled([getattr(p, name) for p in one.axis.typed.phases], one.rows, None)


def moving(one: AxisRows, figure: Callable[[Phase], float | str]) -> list[float | str]:
    """Return a figure of each phase that moves, 0 of the others."""
    moves = one.axis.moves
    return [figure(moves[k]) if k in moves else 0.0 for k in range(one.rows)]


def doubled(formula: str) -> str:
    """Return a formula that takes a figure of the same row, of which phases stand in every second."""
    return formula.replace(",[k])", ",2*[k])")


def own(one: AxisRows, column: str, formula: str) -> str:
    """Return a formula of each phase: that of its own ends, if phases of the book hand over, or the law's."""
    return doubled(one.ends.own(column, formula)) if one.ends else formula


def entered(one: AxisRows) -> list[Quantity]:
    """Return what kind of phase it is, and the entries of each."""
    over, key = one.machine.over, f"axes.{one.axis.number - 1}.phases.*"
    return [
        calc("kind", "phase", "", "", doubled(sampling.kind("stop", one.at.ends)),
             sampling.kinds(one.axis.phases, one.rows)),
        given("start", "from", "", over.unit, entry(one, "start"), f"{key}.start", format=over.format),
        given("stop", "to", "", over.unit, entry(one, "stop"), f"{key}.stop", format=over.format),
        given("lift", "lift", "h", one.axis.given.unit, entry(one, "lift"), f"{key}.lift", format="0.0##"),
        given("law", "law", "", "", entry(one, "law"), f"{key}.law", choices="=law_code"),
    ]  # fmt: skip


def passing(one: AxisRows) -> list[Quantity]:
    """Return the entries of where phases meet, and the kind of both ends; none where all of them begin at rest."""
    if not one.ends:
        return []
    n, over, kinds = one.rows, one.machine.over, [both.kinds for _, both in one.ends.phases]
    units, symbols = (one.at.unit(1), one.at.unit(2)), ("y'", "y''")
    if over.measured:
        units, symbols = over.rates(one.axis.given.unit)[:2], over.symbols[1:3]

    def end(name: str, word: str, values: list[str]) -> Quantity:
        return result(name, f"kind of its {word}", "", "", f"=INDEX([{one.name}_kinds.{name}],2*[k])",
                      filled(values, n, ""), align="center",
                      source="R rest, G velocity, U reversal, B both")  # fmt: skip

    return [
        *entries(entry(one, "velocity"), entry(one, "acceleration"), f"axes.{one.axis.number - 1}.phases.*",
                 units, symbols),
        end("begins", "begin", [begin for begin, _ in kinds]), end("ends", "end", [end for _, end in kinds]),
    ]  # fmt: skip


def reached(one: AxisRows) -> Quantity:
    """Return the position at the end of each phase; of spare rows nothing."""
    axis, n, lacks = one.axis, one.rows, f"[{one.name}_steps.h]"
    ends = [shown(axis.motion.ends[k].end.y, axis.unit) for k in axis.entered]
    y = f"INDEX([{one.name}_steps.y0],2*[k])+INDEX({lacks},2*[k])-[lack]"
    formula = f"({y})*1000" if axis.given.unit == "mm" else f"DEGREES({y})"
    return result("y", "position at its end", "y", axis.given.unit, f'=IF([kind]="spare",0,{formula})',
                  filled(ends, n), scale=shown(axis.motion.size(0), axis.unit), source="lifts up to it")  # fmt: skip


def geometric_extremes(one: AxisRows) -> list[Quantity]:
    """Return the largest y', y'' and y''' of each phase: workings only of a machine without a rate."""
    base, shown_as = one.axis.base, calc if one.machine.over.measured else result
    return [
        shown_as("y1", "geometric velocity", "y'", f"{base}/rad",
                 own(one, "vmax", VELOCITY), moving(one, lambda m: m.y1_max), source="C_v h/δ"),
        shown_as("y2", "geometric acceleration", "y''", f"{base}/rad²",
                 own(one, "amax", ACCELERATION), moving(one, lambda m: m.y2_max), source="C_a h/δ²"),
        shown_as("y3", "geometric jerk", "y'''", f"{base}/rad³",
                 own(one, "jmax", JERK), moving(one, lambda m: finite(m.y3_max)), source="C_j h/δ³"),
    ]  # fmt: skip


def extremes(one: AxisRows) -> list[Quantity]:
    """Return what each movement comes to; over a cycle whose length is entered also how long it lasts."""
    axis, over = one.axis, one.machine.over
    symbols, units, lift = over.extremes, over.rates(axis.given.unit), over.lift(axis.given.unit).shown
    source = ("C_v h/t", "C_a h/t²", "C_j h/t³", "C_a,rms h/t²")
    if not over.measured:
        source = ("y' ω", "y'' ω²", "y''' ω³", "C_a,rms h/δ² ω²")
    elif not over.paced:
        source = ("C_v h/δ", "C_a h/δ²", "C_j h/δ³", "C_a,rms h/δ²")
    mean = doubled(one.ends.own("rms", f"={RMS}")) if one.ends else f"={RMS}"
    return [
        result("v", "velocity", symbols[0], units[0], f"=[y1]*omega{lift}",
               moving(one, lambda m: axis.rate(m.y1_max * axis.speed)), source=source[0]),
        result("a", "acceleration", symbols[1], units[1], f"=[y2]*omega^2{lift}",
               moving(one, lambda m: axis.rate(m.y2_max * axis.speed**2)), source=source[1]),
        result("j", "jerk", symbols[2], units[2],
               f'=IF(ISNUMBER([y3]),[y3]*omega^3{lift},"∞")',
               moving(one, lambda m: finite(axis.rate(m.y3_max * axis.speed**3))), source=source[2]),
        result("rms", "RMS acceleration", symbols[3], units[1], f"{mean}*omega^2{lift}",
               moving(one, lambda m: axis.rate(m.y2_rms * axis.speed**2)), source=source[3]),
        *([
            result("lasts", "duration", over.lasting, over.unit, '=IF([stop]="",0,[stop]-[start])',
                   filled([over.shown(p.stop - p.start) for p in axis.given.phases], one.rows), scale=over.length),
            result("rests", "rest before", "", over.unit, f"={over.told('[gap]')}",
                   [over.shown(gap) for gap in gaps(one)], scale=over.length),
        ] if over.measured else []),
    ]  # fmt: skip


def used(one: AxisRows) -> list[Quantity]:
    """Return law, lift and angles of each phase as the cells compute with them."""
    n, phases, over, turned = one.rows, one.axis.phases, one.machine.over, one.axis.given.phases
    start, stop = over.in_degrees("[start]"), over.in_degrees("[stop]")
    laws = filled([one.machine.machine.laws.number(p.law) for p in turned], n, 1)
    return [
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "", LAW_NUMBER, laws, format="0"),
        calc("h", "lift", "h", one.axis.base, "=[lift]/1000" if one.axis.given.unit == "mm" else "=RADIANS([lift])",
             filled([p.lift for p in phases], n), source="conversion"),
        calc("span", "duration", "δ", "rad", f'=IF([stop]="",0,RADIANS({stop}-{start}))',
             filled([p.duration for p in phases], n), source="conversion"),
        calc("begin", "begins at", "", "°", f'=IF([stop]="",360,{start})', filled([p.start for p in turned], n, 360.0),
             scale=360.0, format="0.0##", source="spare rows: the end"),
        calc("end", "ends at", "", "°", f'=IF([stop]="",360,{stop})', filled([p.stop for p in turned], n, 360.0),
             scale=360.0, format="0.0##"),
    ]  # fmt: skip


def faults(one: AxisRows) -> list[Quantity]:
    """Return what is wrong with each phase, and the rest before it."""
    over, lacking = one.machine.over, "=[h]*(1-INDEX(law_s1,[no]))"
    if one.ends:
        lacking = doubled(one.ends.other(lacking, "0"))
    return [
        calc("gap", "rest before", "", "°", "=[begin]-IF([k]=1,0,[end-1])", gaps(one), scale=360.0),
        calc("backwards", "runs backwards", "", "", BACKWARDS.format(over.after), "", source="empty where it does not"),
        calc("early", "begins too early", "", "", EARLY.format(over.after, over.told("0-[gap]")), "",
             source="empty where it does not"),
        *([beyond(over)] if over.measured else []),
        calc("lack", "jump of y", "Δy", one.axis.base, lacking,
             filled([p.lack for p in one.axis.phases], one.rows),
             source="at its end: the law's lack"),
    ]  # fmt: skip


def beyond(over: Abscissa) -> Quantity:
    """Return the column of how far a row from ``start`` to ``stop`` goes on beyond the cycle, in words."""
    last = "MAX([start],[stop])"
    late = f'=IF(OR([stop]="",{over.in_degrees(last)}-360<=check_zero),"",{going_beyond(last, over)})'
    return calc("beyond", "goes beyond the cycle", "", "", late, "", source="empty where it does not", align="left")


def going_beyond(last: str, over: Abscissa) -> str:
    """Return the formula of how far something goes on beyond the cycle."""
    at, by = (f"ROUND({x},9)" for x in (last, f"{last}-{over.told('360')}"))
    return f'"goes to "&{at}&"{over.after}, "&{by}&"{over.after} beyond the cycle"'


def gaps(one: AxisRows) -> list[float]:
    """Return how long the axis rests before each phase, in degrees; before the first spare row, behind the last."""
    phases, n = one.axis.given.phases, one.rows
    begins, ends = filled([p.start for p in phases], n, 360.0), [0.0, *filled([p.stop for p in phases], n, 360.0)]
    return [begin - end for begin, end in zip(begins, ends, strict=False)]


BACKWARDS = (
    '=IF([stop]="","",IF([stop]>[start],"",'
    '"ends at "&ROUND([stop],9)&"{0}, "&ROUND([start]-[stop],9)&"{0} before it begins"))'
)
EARLY = (
    '=IF([stop]="","",IF([gap]<0-check_zero,'
    '"begins at "&ROUND([start],9)&"{0}, "&ROUND({1},9)&"{0} before row "&([k]-1)&" ends",""))'
)


def none_in(one: AxisRows, column: str) -> str:
    """Return the condition that no row of an axis has a message in a column."""
    return f'COUNTIF([{one.name}.{column}],"?*")=0'


def in_row(one: AxisRows, column: str) -> str:
    """Return the formula of a sentence: the first message in a column of an axis, and its row."""
    row = first_text(f"[{one.name}.{column}]")
    return f'[axes.name.{one.axis.number}]&" row "&{row}&" "&INDEX([{one.name}.{column}],{row})'


def axis_checks(sheet: Sheet, one: AxisRows) -> None:
    """Declare the checks of one axis; each calls it by its number, as it may get another name.

    That phases end with the cycle is one where an entry says how long that is; that it repeats, where it has a drive.
    """
    axis, t, i = one.axis, one.name, one.axis.number
    motion, unit, label, over = axis.motion, axis.given.unit, f"Axis {i}", one.machine.over
    lift, lack, gap = (f"[axes_taken.{name}.{i}]" for name in ("lift", "lack", "gap"))
    sheet.checks(
        check(f"{t}_forward", f"{label}: every phase runs forward", none_in(one, "backwards"), True,
              rule=over.rule("axes", i, "forward"), says=in_row(one, "backwards")),
        check(f"{t}_follows", f"{label}: no phase begins before the one above ends", none_in(one, "early"), True,
              rule=over.rule("axes", i, "follows"), says=in_row(one, "early")),
        *([check(f"{t}_within", f"{label}: no phase goes on beyond the cycle", none_in(one, "beyond"), True,
                 rule=over.rule("axes", i, "within"), says=in_row(one, "beyond"))] if over.measured else []),
        check(f"{t}_position", f"{label}: no jump of position", f"{lack}<=check_zero*{lift}", motion.complete,
              says=amount(lack, shown(axis.lack, axis.unit), "a lift lacks ", f" {unit}")),
        room_check(f"{t}_room", one.at, i, label, f"2*COUNT([drive{i}_windows.start])" if axis.given.motor else ""),
        *(one.ends.checks(t, f"{label}: ") if one.ends else []),
        one.joints.check(f"{t}_smooth", f"{label}: as smooth as asked"),
        check(f"{t}_closes", f"{label}: the cycle closes",
              f'OR([axes.closes.{i}]<>"position",ABS({gap})<=check_zero*{lift})', axis.closes,
              "in position, or, as a feed, in velocity, or is open",
              says=amount(gap, shown(motion.gap, axis.unit), "it ends ", f" {unit} from where it begins")),
        *([] if axis.given.motor is None else [
            check(f"{t}_repeats", f"{label}: its cycle repeats, as its drive needs", f'[axes.closes.{i}]<>"open"', True,
                  rule=f"axes.{i - 1}:repeats", says=f'[axes.name.{i}]&" {OPEN_DRIVE}"')]),
    )  # fmt: skip
