"""The table of the motion on the sheet Actuator."""

from __future__ import annotations

from engine.laws import Law
from engine.laws.base import Array
from engine.laws.piece_extremes import extremes_of
from workbook.book.declare import Sheet, calc, constant, given, result
from workbook.book.rows import filled
from workbook.entries.phase import AT_REST
from workbook.laws import phases as joined
from workbook.machines.actuator.view import Sized
from workbook.motion.cells import Cells, PieceRows
from workbook.motion.pieces import phase_columns
from workbook.motion.smooth import Asked, Joints

AT = Cells("phases", "act_pieces", "act_pieces_all", "act_time", x="s")
FILL = (
    "Phases of the motion: fill one row each, in order; S4's profile of thirds is TVP, "
    "its break points stand on the sheet TVP"
)
PARTS = (
    ("acc", "torque accelerating", "T_acc", "at the largest a"),
    ("level", "torque uniform", "T_ss", "at a = 0; in a dwell"),
    ("dec", "torque decelerating", "T_dec", "at the lowest a"),
)


def joints(machine: Sized, rows: PieceRows) -> Joints:
    """Return the joints of the motion's pieces, and how smooth they must be."""
    base = "m" if machine.kind.travels else "rad"
    units = tuple((f'IF(act_travels=1,"m/{s}","rad/{s}")', f"{base}/{s}") for s in ("s", "s²", "s³"))
    asked = Asked(
        machine.given.smoothness, "act_smooth", "act_order", ("MAX([phases.v])", "MAX([phases.amax])"), ('" s"', " s"),
        units,
    )  # fmt: skip
    return Joints.of(rows, machine.sizing.motion, asked)


def motion(sheet: Sheet, machine: Sized, rows: PieceRows) -> None:
    """Declare the phases: what is entered, what each asks for, and to the right the workings."""
    n, entered, phases, sides = machine.sizes.phases, machine.given.phases, machine.phases, machine.sides
    laws, lifts = [p.law for p in entered], [p.lift for p in entered]
    moved, total = machine.sizing.motion, machine.sizing.motion.total
    torques = list(zip(*machine.part_torques, strict=True))
    sheet.book.name("phases", phase_times="duration")
    sheet.table(
        "phases", FILL, n,
        calc("kind", "phase", "", "", joined.kind("duration"), joined.kinds(moved.phases, n)),
        given("law", "law", "", "", filled(laws, n, None), "actuator.phases.*.law", choices="=law_code"),
        given("lift", "lift", "h", "mm or °", filled(lifts, n, None), "actuator.phases.*.lift", format="0.0##"),
        given("duration", "duration", "t", "s",
              filled([p.duration for p in entered], n, None), "actuator.phases.*.duration", format="0.0##"),
        result("v", "largest speed", "v", "",
               joined.VELOCITY, filled([p.y1_max for p in phases], n),
               scale=sides.speed, source="C_v h/t; m/s, or rad/s"),
        result("amax", "largest acceleration", "a", "",
               joined.ACCELERATION, filled([p.y2_max for p in phases], n), scale=sides.acceleration,
               source="C_a h/t²; m/s², or rad/s²"),
        result("jmax", "largest jerk", "j", "",
               joined.JERK, joined.jerks(filled([p.y3_max for p in phases], n)), scale=moved.size(3),
               source="C_j h/t³; m/s³, or rad/s³"),
        *(result(name, words, symbol, "Nm",
                 f"=INDEX([extremes.torque],3*([k]-1)+{j + 1})", torques[j], scale=sides.torque, source=source)
          for j, (name, words, symbol, source) in enumerate(PARTS)),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "", joined.LAW_NUMBER, filled(machine.numbers, n, 1), format="0"),
        calc("low", "lowest velocity of the law", "", "",
             "=INDEX(law_v_low,[no])", filled([lowest(p.law) for p in phases], n)),
        calc("h", "lift used", "h", "",
             "=[lift]*@unit", filled([p.lift for p in phases], n), scale=sides.lift, source="in m, or rad"),
        calc("span", "duration used", "t", "s",
             '=IF([kind]="spare",0,[duration])', filled([p.duration for p in phases], n), scale=total),
        calc("begin", "begins at", "", "s",
             '=IF([kind]="spare",2*@time,IF([k]=1,0,[begin-1]+[span-1]))',
             filled(moved.edges[:-1], n, total + total), scale=total, source="spare rows: out of reach"),
        calc("y0", "start position", "x_0", "",
             "=IF([k]=1,0,[y0-1]+[h-1])", filled(moved.at(moved.edges[:-1]).y, n, moved.lifts_sum), scale=sides.lift,
             source="lifts before, in m or rad"),
        calc("per", "acceleration for a = 1", "h/t²", "",
             "=IF([span]>0,[h]/[span]^2,0)", machine.of_moves(lambda move: move.per), scale=sides.acceleration),
        calc("dir", "direction", "", "",
             '=IF([kind]="spare",0,SIGN([h]))', machine.of_moves(lambda move: move.direction), format="0"),
        calc("way", "way", "Σ|x|", "", "=ABS([h]*INDEX(law_s1,[no]))", machine.of_moves(lambda move: move.way),
             scale=sides.lift, source="in m or rad"),
        calc("base", "resists", "", "N or Nm",
             '=IF([kind]="spare",0,IF([dir]=0,@hold,@steady+@rubbing*[dir]))', resists(machine), scale=sides.force),
        *phase_columns(rows),
        rules=[AT_REST],
    )  # fmt: skip


def resists(machine: Sized) -> list[float]:
    """Return what resists at the load in each phase (N or Nm), nothing in the spare rows."""
    found: Array = machine.drive.resisting([move.direction for move in machine.sizing.moves])
    return filled(found, machine.sizes.phases)


def lowest(law: Law) -> float:
    """Return the lowest velocity of a law."""
    return extremes_of(law.as_pieces(), law.start.v).v[0]
