"""The phases of one axis on the Timing sheet: what is entered, what each movement comes to, and the checks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from engine.timing import Movement
from workbook.book.declare import Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount
from workbook.entries.phase import AT_REST
from workbook.entries.units import shown
from workbook.laws import phases as joined
from workbook.laws.phases import ACCELERATION, JERK, LAW_NUMBER, RMS, VELOCITY, jerks
from workbook.machines.machine.handing import doubled
from workbook.machines.machine.motion import AxisRows
from workbook.motion.pieces import room_check
from workbook.motion.through import entries


def phases_table(sheet: Sheet, one: AxisRows) -> None:
    """Declare the phases of an axis."""
    axis, n, base, unit = one.axis, one.machine.machine.sizes.phases, one.axis.base, one.axis.given.unit
    entered, phases, laws = axis.given.phases, axis.phases, [p.law for p in axis.given.phases]
    key = f"axes.{axis.number - 1}.phases.*"

    def entry(name: str) -> list[Any]:
        return filled([getattr(p, name) for p in entered], n, None)

    def of(figure: Callable[[Movement], float]) -> list[float]:
        return [figure(axis.moves[k]) if k in axis.moves else 0.0 for k in range(n)]

    handed, at, steps = one.ends, one.at, f"{one.name}_steps"

    def own(column: str, formula: str) -> str:
        return doubled(handed.own(column, formula)) if handed else formula

    def ends(name: str, word: str, values: list[str]) -> Quantity:
        return result(name, f"kind of its {word}", "", "", f"=INDEX([{steps}.{name}],2*[k])", values, align="center",
                      source="R rest, G velocity, U reversal, B both")  # fmt: skip

    lacking, mean = "=[h]*(1-INDEX(law_s1,[no]))", f"={RMS}"
    passing: list[Quantity] = []
    if handed:
        lacking, mean = doubled(handed.other(lacking, "0")), doubled(handed.own("rms", mean))
        kinds = [both.kinds for _, both in handed.numbered]
        passing = [
            *entries(entry("velocity"), entry("acceleration"), key, (at.unit(1), at.unit(2))),
            ends("begins", "begin", filled([begin for begin, _ in kinds], n, "")),
            ends("ends", "end", filled([end for _, end in kinds], n, "")),
        ]
    sheet.table(
        one.name, f"Phases of axis {axis.number}: fill one row each, in order; between them it rests; "
        "leave spare rows empty", n,
        calc("kind", "phase", "", "", doubled(joined.kind("stop", at.ends)), joined.kinds(phases, n)),
        given("start", "from", "", "°", entry("start"), f"{key}.start", format="0.0##"),
        given("stop", "to", "", "°", entry("stop"), f"{key}.stop", format="0.0##"),
        given("lift", "lift", "h", unit, entry("lift"), f"{key}.lift", format="0.0##"),
        given("law", "law", "", "", entry("law"), f"{key}.law", choices="=law_code"),
        *passing,
        result("y1", "geometric velocity", "y'", f"{base}/rad",
               own("vmax", VELOCITY), of(lambda m: m.y1_max), source="C_v h/δ"),
        result("y2", "geometric acceleration", "y''", f"{base}/rad²",
               own("amax", ACCELERATION), of(lambda m: m.y2_max), source="C_a h/δ²"),
        result("y3", "geometric jerk", "y'''", f"{base}/rad³",
               own("jmax", JERK), jerks(of(lambda m: m.y3_max)), source="C_j h/δ³"),
        result("v", "velocity", "ẏmax", f"{base}/s", "=[y1]*timing_omega", of(lambda m: m.v_max), source="y' ω"),
        result("a", "acceleration", "ÿmax", f"{base}/s²",
               "=[y2]*timing_omega^2", of(lambda m: m.a_max), source="y'' ω²"),
        result("j", "jerk", "j_max", f"{base}/s³",
               '=IF(ISNUMBER([y3]),[y3]*timing_omega^3,"∞")', jerks(of(lambda m: m.j_max)), source="y''' ω³"),
        result("rms", "RMS acceleration", "ÿrms", f"{base}/s²",
               f"{mean}*timing_omega^2", of(lambda m: m.a_rms), source="C_a,rms h/δ² ω²"),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "",
             LAW_NUMBER, joined.law_numbers(laws, one.machine.machine.laws, n), format="0"),
        calc("h", "lift", "h", base, "=[lift]/1000" if unit == "mm" else "=RADIANS([lift])",
             filled([p.lift for p in phases], n), source="conversion"),
        calc("span", "duration", "δ", "rad",
             '=IF([stop]="",0,RADIANS([stop]-[start]))', filled([p.duration for p in phases], n), source="conversion"),
        calc("begin", "begins at", "", "°",
             '=IF([stop]="",360,[start])', filled([p.start for p in entered], n, 360.0), format="0.0##",
             source="spare rows: the end"),
        calc("end", "ends at", "", "°",
             '=IF([stop]="",360,[stop])', filled([p.stop for p in entered], n, 360.0), format="0.0##"),
        calc("gap", "rest before", "", "°",
             "=[begin]-IF([k]=1,0,[end-1])", gaps(one), scale=360.0),
        calc("backwards", "runs backwards", "", "",
             '=IF([stop]="",0,IF([stop]>[start],0,1))', 0, format="0;;", source="1 where it does"),
        calc("early", "begins too early", "", "",
             '=IF([stop]="",0,IF([gap]<0-check_zero,1,0))', 0, format="0;;", source="1 where it does"),
        calc("lack", "jump of y", "Δy", base,
             lacking, filled([p.lack for p in phases], n), source="at its end: the law's lack"),
        rules=[AT_REST],
    )  # fmt: skip


def gaps(one: AxisRows) -> list[float]:
    """Return how long the axis rests before each phase, in degrees; before the first spare row, behind the last."""
    phases, n = one.axis.given.phases, one.machine.machine.sizes.phases
    begins, ends = filled([p.start for p in phases], n, 360.0), [0.0, *filled([p.stop for p in phases], n, 360.0)]
    return [begin - end for begin, end in zip(begins, ends, strict=False)]


ENDS = "ROUND(INDEX([{0}.stop],{1}),9)"
BACKWARDS = (
    f'" ends at "&{ENDS}&"°, "&ROUND(INDEX([{{0}}.start],{{1}})-INDEX([{{0}}.stop],{{1}}),9)&"° before it begins"'
)
EARLY = (
    '" begins at "&ROUND(INDEX([{0}.start],{1}),9)&"°, "&ROUND(0-INDEX([{0}.gap],{1}),9)'
    '&"° before row "&({1}-1)&" ends"'
)


def in_row(one: AxisRows, column: str, says: str) -> str:
    """Return the formula of a sentence on the first phase of an axis in which ``column`` is 1."""
    row = f"MATCH(1,[{one.name}.{column}],0)"
    return f'[axes.name.{one.axis.number}]&" row "&{row}&{says.format(one.name, row)}'


def axis_checks(sheet: Sheet, one: AxisRows) -> None:
    """Declare the checks of one axis; each calls it by its number, as it may get another name."""
    axis, t, i = one.axis, one.name, one.axis.number
    motion, unit, key, label = axis.motion, axis.given.unit, f"axes.{i - 1}", f"Axis {i}"
    greatest = f"MAX(MAX([{t}.h]),-MIN([{t}.h]))"
    lack = f"MAX(MAX([{t}.lack]),-MIN([{t}.lack]))"
    ends = f"IF(360-MAX([{t}.stop])>check_zero,0,INDEX([{t}.lack],COUNT([{t}.stop])))"
    gap = f"SUM([{t}.h])-{ends}"

    def outward(formula: str) -> str:
        return f"({formula})*1000" if unit == "mm" else f"DEGREES({formula})"

    sheet.checks(
        check(f"{t}_forward", f"{label}: every phase runs forward", f"SUM([{t}.backwards])=0", True,
              rule=f"{key}:forward", says=in_row(one, "backwards", BACKWARDS)),
        check(f"{t}_follows", f"{label}: no phase begins before the one above ends", f"SUM([{t}.early])=0", True,
              rule=f"{key}:follows", says=in_row(one, "early", EARLY)),
        check(f"{t}_position", f"{label}: no jump of position", f"{lack}<=check_zero*{greatest}", motion.complete,
              says=amount(outward(lack), shown(axis.lack, axis.unit), "a lift lacks ", f" {unit}")),
        room_check(f"{t}_room", one.at, i, label),
        *(one.ends.checks(t, f"{label}: ") if one.ends else []),
        one.joints.check(f"{t}_smooth", f"{label}: as smooth as asked"),
        check(f"{t}_closes", f"{label}: the cycle closes",
              f'OR([axes.closes.{i}]="feed",ABS({gap})<=check_zero*{greatest})', axis.axis.closes,
              "in position, or, as a feed, in velocity",
              says=amount(outward(gap), shown(motion.gap, axis.unit), "it ends ", f" {unit} from where it begins")),
    )  # fmt: skip
