"""The phases of an axis on the Timing sheet: what is entered, what each comes to, how they join."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from engine.timing import Movement
from workbook.book.declare import Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount
from workbook.entries.phase import AT_REST
from workbook.entries.units import MM, shown
from workbook.laws import phases as joined_phases
from workbook.laws.phases import ACCELERATION, AT_END, HIGH, JERK, LAW_NUMBER, LOW, RMS, VELOCITY, jerks
from workbook.machines.cutting.view import Cutting
from workbook.motion.cells import PieceRows
from workbook.motion.ends import Ends
from workbook.motion.pieces import phase_columns, room_check
from workbook.motion.smooth import Joints
from workbook.motion.through import entries

CARRIED = "=IF([span]>0,INDEX(law_{0},[no])*[h]/[span]{1},IF([k]=1,0,[{0}-1]))"


def phases(sheet: Sheet, machine: Cutting, i: int, rows: PieceRows, handed: Ends | None) -> None:
    """Declare the phases of one axis: what is entered, what each movement comes to, how the phases join."""
    axis, engine_axis, n = machine.machine.timing.axes[i - 1], machine.axes[i - 1], machine.machine.sizes.phases
    motion, moves = engine_axis.motion, {m.phase: m for m in engine_axis.movements(machine.speed)}
    begins, ends = zip(*motion.ends, strict=True)
    lows, highs = zip(*motion.reaches, strict=True)
    *inner, wrap = motion.junctions()
    junctions = [wrap, *inner]  # each where its phase begins
    laws = [p.law for p in axis.phases]
    key = f"timing.axes.{i - 1}.phases.*"

    def entered(name: str) -> list[Any]:
        return filled([getattr(p, name) for p in axis.phases], n, None)

    def of(figure: Callable[[Movement], float]) -> list[float]:
        return [figure(moves[k]) if k in moves else 0.0 for k in range(n)]

    def own(column: str, formula: str) -> str:
        return handed.own(column, formula) if handed else formula

    def at_end(derivative: str, end: int, power: str, carried: str) -> str:
        if handed is None:
            return (CARRIED if carried else AT_END).format(f"{derivative}{end}", power)
        return f"=IF([span]>0,{handed.at_end(derivative, end)},{carried or 0})"

    lacking = "=[h]*(1-INDEX(law_s1,[no]))"
    if handed:
        lacking = handed.other(lacking, "0")
    mean = own("rms", f"={RMS}")
    sheet.heading(f"Axis {i}")
    sheet.rows(
        calc(f"axis{i}_name", f"Axis {i} and its group", "", "",
             f'=INDEX([axes.name],{i})&", "&INDEX([axes.group],{i})', f"{axis.name}, {axis.group}", align="left"),
    )  # fmt: skip
    sheet.table(
        f"axis{i}", f"Phases of axis {i}: fill one row each, in order; leave spare rows empty", n,
        calc("kind", "phase", "", "",
             joined_phases.kind("stop", rows.at.ends), joined_phases.kinds(motion.phases, n)),
        given("start", "from", "", "°", entered("start"), f"{key}.start", format="0.0##"),
        given("stop", "to", "", "°", entered("stop"), f"{key}.stop", format="0.0##"),
        given("lift", "lift", "h", "mm", entered("lift"), f"{key}.lift", format="0.0##"),
        given("law", "law", "", "", entered("law"), f"{key}.law", choices="=law_code"),
        *(entries(entered("velocity"), entered("acceleration"), key, ("m/rad", "m/rad²")) if handed else []),
        *(handed.kinds() if handed else []),
        result("y1", "geometric velocity", "y'", "m/rad",
               own("vmax", VELOCITY), of(lambda m: m.y1_max), source="C_v h/δ"),
        result("y2", "geometric acceleration", "y''", "m/rad²",
               own("amax", ACCELERATION), of(lambda m: m.y2_max), source="C_a h/δ²"),
        result("y3", "geometric jerk", "y'''", "m/rad³",
               own("jmax", JERK), jerks(of(lambda m: m.y3_max)), source="C_j h/δ³"),
        result("v", "velocity", "ẏmax", "m/s", "=[y1]*timing_omega", of(lambda m: m.v_max), source="y' ω"),
        result("a", "acceleration", "ÿmax", "m/s²", "=[y2]*timing_omega^2", of(lambda m: m.a_max), source="y'' ω²"),
        result("j", "jerk", "j_max", "m/s³",
               '=IF(ISNUMBER([y3]),[y3]*timing_omega^3,"∞")', jerks(of(lambda m: m.j_max)), source="y''' ω³"),
        result("rms", "RMS acceleration", "ÿrms", "m/s²",
               f"{mean}*timing_omega^2", of(lambda m: m.a_rms), source="C_a,rms h/δ² ω²"),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "",
             LAW_NUMBER, joined_phases.law_numbers(laws, machine.machine.laws, n), format="0"),
        calc("h", "lift", "h", "m",
             "=[lift]/1000", filled([p.lift for p in motion.phases], n), source="conversion"),
        calc("span", "duration", "δ", "rad",
             '=IF([stop]="",0,RADIANS([stop]-[start]))', filled([p.duration for p in motion.phases], n),
             source="conversion"),
        calc("begin", "begins at", "", "°",
             '=IF([stop]="",360,[start])', filled([p.start for p in axis.phases], n, 360.0), format="0.0##"),
        calc("y0", "start position", "y_0", "m",
             "=IF([k]=1,0,[y0-1]+[h-1])", filled([begin.y for begin in begins], n, motion.lifts_sum),
             source="lifts before"),
        *(calc(name, f"{word} position", "", "m", own(name, formula.format(0)), filled(values, n))
          for name, word, formula, values in (("low", "lowest", LOW, lows), ("high", "highest", HIGH, highs))),
        calc("gap", "gap before", "", "°",
             '=IF([stop]="",0,[start]-IF([k]=1,0,[stop-1]))', filled([], n), scale=360.0),
        calc("backwards", "runs backwards", "", "",
             '=IF([stop]="",0,IF([stop]>[start],0,1))', 0, format="0;;", source="1 where it does"),
        calc("parted", "does not follow on", "", "",
             "=IF(ABS([gap])<check_zero,0,1)", 0, format="0;;", source="1 where it does not"),
        calc("v0", "y' at its start", "", "m/rad",
             at_end("v", 0, "", ""), filled([begin.y1 for begin in begins], n)),
        calc("v1", "y' at end", "", "m/rad",
             at_end("v", 1, "", "IF([k]=1,0,[v1-1])"), filled([end.y1 for end in ends], n, ends[-1].y1),
             source="carried over spare rows"),
        calc("a0", "y'' at its start", "", "m/rad²",
             at_end("a", 0, "^2", ""), filled([begin.y2 for begin in begins], n)),
        calc("a1", "y'' at end", "", "m/rad²",
             at_end("a", 1, "^2", "IF([k]=1,0,[a1-1])"), filled([end.y2 for end in ends], n, ends[-1].y2),
             source="carried over spare rows"),
        calc("jump_y", "jump of y", "Δy", "m",
             lacking, filled([p.lack for p in motion.phases], n),
             source="at its end: the law's lack"),
        calc("jump_v", "jump of y'", "Δy'", "m/rad",
             f"=IF([span]>0,[v0]-IF([k]=1,[axis{i}.v1.last],[v1-1]),0)",
             filled([j.jump_v for j in junctions], n), source="at its begin"),
        calc("jump_a", "jump of y''", "Δy''", "m/rad²",
             f"=IF([span]>0,[a0]-IF([k]=1,[axis{i}.a1.last],[a1-1]),0)",
             filled([j.jump_a for j in junctions], n), source="reported, no fault"),
        *phase_columns(rows),
        rules=[AT_REST],
    )  # fmt: skip


ENDS = "ROUND(INDEX([{0}.stop],{1}),9)"
BACKWARDS = (
    f'" ends at "&{ENDS}&"°, "&ROUND(INDEX([{{0}}.start],{{1}})-INDEX([{{0}}.stop],{{1}}),9)&"° before it begins"'
)
PARTED = (
    '" begins at "&ROUND(INDEX([{0}.start],{1}),9)&"°, "&ROUND(ABS(INDEX([{0}.gap],{1})),9)'
    '&IF(INDEX([{0}.gap],{1})>0,"° after ","° before ")&IF({1}=1,"0°","row "&({1}-1)&" ends")'
)
UNFILLED = (
    '" ends at "&ROUND(MAX([{0}.stop]),9)&"°, "&ROUND(ABS(360-MAX([{0}.stop])),9)'
    '&IF(MAX([{0}.stop])<360,"° before 360°","° after 360°")'
)


def in_row(i: int, column: str, says: str) -> str:
    """Return the formula of a sentence on the first phase of an axis in which ``column`` is 1."""
    row = f"MATCH(1,[axis{i}.{column}],0)"
    return f'INDEX([axes.name],{i})&" row "&{row}&{says.format(f"axis{i}", row)}'


def joined(sheet: Sheet, machine: Cutting, i: int, joints: Joints, ends: Ends | None) -> None:
    """Declare the checks of one axis."""
    axis, t = machine.axes[i - 1], f"axis{i}"
    motion, name, key = axis.motion, f"Axis {i}", f"timing.axes.{i - 1}"

    lack = max(abs(phase.lack) for phase in motion.phases)
    jump = max(abs(joint.jump_v) for joint in motion.junctions())

    def greatest(column: str) -> str:
        return f"MAX(MAX([{t}.{column}]),-MIN([{t}.{column}]))"

    gap = f"SUM([{t}.h])-INDEX([{t}.jump_y],COUNT([{t}.stop]))"
    sheet.checks(
        check(f"{t}_forward", f"{name}: every phase runs forward", f"SUM([{t}.backwards])=0", True,
              rule=f"{key}:forward", says=in_row(i, "backwards", BACKWARDS)),
        check(f"{t}_follows", f"{name}: the phases follow on", f"SUM([{t}.parted])=0", True,
              rule=f"{key}:follows", says=in_row(i, "parted", PARTED)),
        check(f"{t}_fills", f"{name}: the phases fill the cycle", f"ABS(MAX([{t}.stop])-360)<check_zero", True,
              rule=f"{key}:fills", says=f"INDEX([axes.name],{i})&{UNFILLED.format(t)}"),
        check(f"{t}_position", f"{name}: no jump of position",
              f"{greatest('jump_y')}<=check_zero*{greatest('h')}", motion.complete,
              says=amount(f"{greatest('jump_y')}*1000", shown(lack, MM), "a lift lacks ", " mm")),
        room_check(f"{t}_room", joints.rows.at, i, name),
        check(f"{t}_velocity", f"{name}: no jump of velocity",
              f"{greatest('jump_v')}<=check_zero*MAX([{t}.y1])", motion.smooth(),
              says=amount(greatest("jump_v"), jump, "y' jumps by ", " m/rad: see jump of y'")),
        *(ends.checks(t, f"{name}: ") if ends else []),
        joints.check(f"{t}_smooth", f"{name}: as smooth as asked"),
        check(f"{t}_closes", f"{name}: the cycle closes",
              f'OR(INDEX([axes.closes],{i})="feed",ABS({gap})<=check_zero*{greatest("h")})', axis.closes,
              "in position, or, as a feed, in velocity",
              says=amount(f"({gap})*1000", shown(motion.gap, MM), "it ends ", " mm from where it begins")),
    )  # fmt: skip
