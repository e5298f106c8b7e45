"""The sheets of a composed motion: phases over any abscissa, their junctions and pieces; behind them samples."""

from __future__ import annotations

from engine.motion import Junction
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount
from workbook.laws import phases as joined
from workbook.machines.composer.phases import PER, PER2, PER3, phases
from workbook.machines.composer.view import Composition
from workbook.motion.asked import ABOUT as CONTINUOUS
from workbook.motion.cells import Cells, PieceRows
from workbook.motion.ends import Ends, ends_tables
from workbook.motion.pieces import ABOUT, TITLE, pieces_in_all, pieces_table, room_check
from workbook.motion.sampled import POSITION, derivative, finding
from workbook.motion.smooth import Asked, Joints

PICTURES = (4, 15, 26)
"""the rows in which charts begin"""
UNITS = ('move_y&"/"&move_x', 'move_y&"/"&move_x&"²"', 'move_y&"/"&move_x&"³"')


def cells(hands_over: bool) -> Cells:
    """Return where the motion stands; ``hands_over`` where phases may hand velocity over."""
    return Cells(
        "phases", "move_pieces", "move_pieces_all", "move_total", "lift", "x",
        ends="phase_ends" if hands_over else "", peaks=("v", "a"),
    )  # fmt: skip


def handing(machine: Composition, rows: PieceRows) -> Ends | None:
    """Return what phases take from their neighbours; None in a book without straight lines."""
    return (
        Ends(rows, machine.joined, machine.given.phases, "move_count", wraps='move_cycle="closes"',
             periodic=machine.repeats)
        if rows.at.ends else None
    )  # fmt: skip


def motion_sheet(book: Book, machine: Composition, rows: PieceRows) -> None:
    """Declare the sheet: units and results at the top, the motion beside them, phases, junctions, pieces."""
    sheet = book.sheet("Motion", "Phases joined over any abscissa: position, velocity and acceleration per unit of it.")
    sheet.heading("Enter: units and cycle here, the phases in the table below")
    entries(sheet, machine)
    sheet.heading("Results")
    results(sheet, machine)
    sheet.row += 1
    joints, ends = Joints.of(rows, machine.motion, asked(machine)), handing(machine, rows)
    checks(sheet, machine, joints, ends)
    draw(sheet)
    sheet.heading(
        "Phases", "As in S3: a law, a lift and a duration each; the position is carried on from phase to phase."
    )
    phases(sheet, machine, rows, ends)
    sheet.heading("Junctions", "What jumps where one phase hands over to the next: after less before.")
    junctions(sheet, machine)
    sheet.not_printed_below()
    pieces(sheet, machine, rows, joints, ends)
    sheet.print_columns = 17


def cycle_sheet(book: Book, machine: Composition, rows: PieceRows) -> None:
    """Declare the sheet of the sampled motion."""
    sheet = book.sheet("Cycle", "The motion sample by sample; what charts show.")
    samples(sheet, machine, rows)
    sheet.print_columns, sheet.widths = 10, {FIRST: 14}


def pieces(sheet: Sheet, machine: Composition, rows: PieceRows, joints: Joints, ends: Ends | None) -> None:
    """Declare the motion as pieces."""
    sheet.heading(f"Workings: {TITLE.lower()}", ABOUT)
    sheet.rows(
        pieces_in_all(rows),
        joints.order(),
    )  # fmt: skip
    sheet.row += 1
    room = machine.room
    columns, taken = joints.columns(room), ends.taken(room) if ends else []
    columns += ends.turns.of_pieces(room) if ends else []
    pieces_table(sheet, TITLE, rows, room, machine.motion.size, *columns, taken=taken)
    ends_tables(sheet, [("", ends)] if ends else [])


def asked(machine: Composition) -> Asked:
    """Return how smooth the motion must be."""
    x = machine.given.abscissa_unit
    return Asked(
        machine.given.smoothness, "move_smooth", "move_order", ("MAX([phases.v])", "MAX([phases.a])"),
        ('" "&move_x', f" {x}"), tuple(zip(UNITS, machine.units, strict=True)), wraps='move_cycle="closes"',
        periodic=machine.repeats,
    )  # fmt: skip


def entries(sheet: Sheet, machine: Composition) -> None:
    """Declare what holds for the motion as a whole, and how its units are written."""
    m = machine.given
    x, y = m.abscissa_unit, m.lift_unit
    sheet.rows(
        given("move_x", "Unit of the abscissa", "x", "",
              x, "motion.abscissa_unit", align="center", source="°, s, mm …: durations are in it"),
        given("move_y", "Unit of the lift", "y", "",
              y, "motion.lift_unit", align="center", source="mm, ° …: lifts are in it"),
        given("move_start", "Start position", "y_0", "lift", m.position, "motion.position", format="0.0####"),
        given("move_cycle", "The cycle", "", "",
              m.cycle, "motion.cycle", align="center", source="closes: it repeats; open: it does not"),
        given("move_smooth", "Must be continuous", "", "",
              m.smoothness, "motion.smoothness", align="center", source=CONTINUOUS),
        calc("move_title_x", "Abscissa, with its unit", "", "",
             '="x ["&move_x&"]"', f"x [{x}]", align="center", source="written x in the headers below"),
        calc("move_title_y", "Position, with its unit", "", "",
             '="y ["&move_y&"]"', f"y [{y}]", align="center", source="written lift"),
        calc("move_title_v", "Velocity, with its unit", "", "",
             """="y' ["&move_y&"/"&move_x&"]\"""", f"y' [{y}/{x}]", align="center", source="written lift/x"),
        calc("move_title_a", "Acceleration, with its unit", "", "",
             """="y'' ["&move_y&"/"&move_x&"²]\"""", f"y'' [{y}/{x}²]", align="center", source="written lift/x²"),
    )  # fmt: skip


def results(sheet: Sheet, machine: Composition) -> None:
    """Declare what the motion as a whole comes to; velocity and acceleration exactly, from the laws' coefficients."""
    motion, (h, v, a, _), y = machine.motion, machine.motion.sizes, machine.samples.y
    jump = max((abs(j.jump_a) for j in machine.junctions), default=0.0)
    sheet.rows(
        result("move_total", "Length of the abscissa", "Σδ", "x",
               "=SUM([phases.span])", motion.total, source="sum of the durations"),
        calc("move_count", "Phases", "", "", "=COUNT([phases.duration])", len(motion.phases), format="0"),
        calc("move_points", "Samples", "N", "",
             "=COUNT([motion.k])", len(y), format="0", source="sizes.cycle + 1 in the description"),
        result("move_travel", "Travel", "Σh", "lift",
               "=SUM([phases.h])", motion.lifts_sum, scale=h, source="sum of the lifts"),
        result("move_gap", "What the cycle does not close by", "", "lift",
               "=INDEX([phases.y1],move_count)-move_start", motion.gap, format="0.0000##", scale=h,
               source="y(end) − y(start)"),
        result("move_low", "Lowest position", "y_min", "lift", "=MIN([phases.low])", motion.reach[0], scale=h),
        result("move_high", "Highest position", "y_max", "lift", "=MAX([phases.high])", motion.reach[1], scale=h),
        result("move_v", "Greatest velocity", "|y'|_max", PER,
               "=MAX([phases.v])", motion.peaks.y1, scale=v, source="C_v |h|/δ"),
        result("move_a", "Greatest acceleration", "|y''|_max", PER2,
               "=MAX([phases.a])", motion.peaks.y2, scale=a, source="C_a |h|/δ²"),
        result("move_j", "Greatest jerk", "|y'''|_max", PER3,
               '=IF(COUNTIF([phases.j],"∞")>0,"∞",MAX([phases.j]))', *joined.jerks([motion.peaks.y3]),
               scale=motion.size(3), source="C_j |h|/δ³; ∞ where the acceleration jumps"),
        result("move_rms", "RMS acceleration over the whole", "y''_rms", PER2,
               "=SQRT(SUMPRODUCT([phases.rms],[phases.rms],[phases.span])/move_total)", motion.y2_rms, scale=a,
               source="√(Σ y''²_rms δ / Σδ)"),
        result("move_jump", "Greatest jump of acceleration", "Δy''", PER2,
               "=MAX(MAX([junctions.jump_a]),-MIN([junctions.jump_a]))", jump, format="0.0000##", scale=a,
               source="reported, no fault"),
    )  # fmt: skip


def checks(sheet: Sheet, machine: Composition, joints: Joints, ends: Ends | None) -> None:
    """Declare the checks of the motion."""
    motion = machine.motion
    lack = max(abs(phase.lack) for phase in motion.phases)
    jump = max((abs(joint.jump_v) for joint in machine.junctions), default=0.0)
    sheet.checks(
        check("move_ok_position", "No jump of position between phases",
              f"{greatest('phases.lack')}<=check_zero*{greatest('phases.h')}", motion.complete,
              "each law reaches its lift", says=amount(greatest("phases.lack"), lack, "a lift lacks ", "")),
        room_check("move_ok_pieces", joints.rows.at),
        check("move_ok_velocity", "No jump of velocity",
              f"{greatest('junctions.jump_v')}<=check_zero*move_v", motion.smooth(machine.repeats),
              "of a closed cycle, also from its end to its start",
              says=amount(greatest("junctions.jump_v"), jump, "y' jumps by ", ": see the junctions")),
        *(ends.checks("move_ok", "") if ends else []),
        joints.check("move_ok_smooth", "As smooth as asked"),
        check("move_ok_closes", "The cycle closes in position",
              f'OR(move_cycle="open",ABS(move_gap)<=check_zero*{greatest("phases.h")})', machine.axis.closes,
              "or is open", says=amount("move_gap", motion.gap, "it ends ", " from where it begins")),
    )  # fmt: skip


def greatest(column: str) -> str:
    """Return the formula of the largest size in a column."""
    return f"MAX(MAX([{column}]),-MIN([{column}]))"


def junctions(sheet: Sheet, machine: Composition) -> None:
    """Declare the junction behind each phase: what jumps there; behind the last one, the cycle's wrap."""
    motion, n, used = machine.motion, machine.sizes.phases, len(machine.motion.phases)
    h, v, a, _ = motion.sizes
    found = {j.before: j for j in machine.junctions}
    kinds = filled([*filled([], used - 1, "joint"), "wrap" if machine.repeats else "end"], n, "spare")
    nexts = filled(range(2, used + 1), n, 1)

    def jump(name: str) -> list[float]:
        return [getattr(found.get(k, NOTHING), name) for k in range(n)]

    sheet.table(
        "junctions", "Behind each phase one; the wrap joins the end of a closed cycle to its start", n,
        calc("kind", "junction", "", "", KIND, kinds),
        result("x", "at", "", "x",
               "=INDEX([phases.end],[k])", filled(motion.edges[1:], n, motion.total), format="0.0####",
               scale=motion.total),
        result("jump_y", "jump of position", "Δy", "lift",
               JUMP_Y, jump("jump_y"), format="0.0000##", scale=h, source="at the wrap: y(end) − y(start)"),
        result("jump_v", "jump of velocity", "Δy'", PER, JUMP.format("v"), jump("jump_v"), format="0.0000##", scale=v),
        result("jump_a", "jump of acceleration", "Δy''", PER2,
               JUMP.format("a"), jump("jump_a"), format="0.0000##", scale=a, source="reported, no fault"),
        constant("k", "behind phase", "k", "", list(range(1, n + 1))),
        calc("next", "before phase", "", "", "=IF([k]<move_count,[k]+1,1)", nexts, format="0"),
        blank='[kind]="spare"',
    )  # fmt: skip


NOTHING = Junction(0.0, 0, 0, 0.0, 0.0, 0.0)
KIND = '=IF([k]<move_count,"joint",IF([k]>move_count,"spare",IF(move_cycle="closes","wrap","end")))'
JUMP_Y = '=IF([kind]="joint",INDEX([phases.y0],[next])-INDEX([phases.y1],[k]),IF([kind]="wrap",move_gap,0))'
JUMP = '=IF(OR([kind]="joint",[kind]="wrap"),INDEX([phases.{0}0],[next])-INDEX([phases.{0}1],[k]),0)'


def samples(sheet: Sheet, machine: Composition, rows: PieceRows) -> None:
    """Declare the sampled motion: results, then how each sample finds its piece."""
    x, at, (h, v, a, j) = machine.abscissa, machine.samples, machine.motion.sizes
    sheet.table(
        "motion", f"Position, velocity and acceleration at N = {len(x)} equal steps", len(x),
        calc("at", "abscissa", "x", "x",
             "=[k]*move_total/[motion.k.last]", x, format="0.0##", scale=machine.motion.total),
        result("y", "position", "y", "lift", f"={derivative(rows, 0)}", at.y, scale=h, source=POSITION),
        result("y1", "velocity", "y'", PER, f"={derivative(rows, 1)}", at.y1, scale=v, source="dy/du"),
        result("y2", "acceleration", "y''", PER2, f"={derivative(rows, 2)}", at.y2, scale=a, source="d²y/du²"),
        result("y3", "jerk", "y'''", PER3, f"={derivative(rows, 3)}", at.y3, scale=j, source="d³y/du³, between jumps"),
        constant("k", "sample", "k", "", list(range(len(x)))),
        *finding(rows, "at", x),
    )  # fmt: skip


def curve(title: str, column: str, what: str) -> Chart:
    """Return the chart of one column of the table over the abscissa; its axes are titled by the units entered."""
    line = Series(title, "[motion.at]", f"[motion.{column}]")
    return Chart(
        title, "=move_title_x", f"=move_title_{what}", (line,), f"{title} of the composed motion over its abscissa"
    )


def draw(sheet: Sheet) -> None:
    """Place position, velocity and acceleration one below the other, beside what is entered and what comes out."""
    curves = curve("Position", "y", "y"), curve("Velocity", "y1", "v"), curve("Acceleration", "y2", "a")
    for row, one in zip(PICTURES, curves, strict=True):
        sheet.chart(one, column=10, row=row, width=8, height=11)
