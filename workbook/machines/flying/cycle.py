"""The Cycle sheet: tool, shaft and load over one cycle, from the end of one cut to the end of the next, by pieces."""

import numpy as np

from engine.flying.pieces import cut_joints, cut_parts, cut_pieces, rates_of
from workbook.book.declare import Book, Sheet, calc, constant, result
from workbook.fields.units import DEGREE, MM, RPM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.flying.view import CutterView
from workbook.motion.cells import Cells, PieceRows, last_before, rows_of_parts
from workbook.motion.pieces import ABOUT, POSITION, finding, phase_table_columns, pieces_in_all, pieces_table, sampled
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints

AT = Cells("stretches", "tool_pieces", "fly_pieces", "fly_tc", "m", "s", drifts=True, opens=True)
SPLIT = "IF(fly_waits=1,fly_peak,1)"
PARTS = ("moves by its law", "waits", "moves on", "works at line speed")
WHERE = "The parts of the cycle: beside the law the tool moves at line speed, which stands in the column drift."


def rows_of(machine: CutterView, stack: Pieces) -> PieceRows:
    """Return the pieces of the tool's motion."""
    cut, parts = machine.cut, cut_parts(machine.cut)
    begun = [part.first for part in parts]
    return rows_of_parts(AT, [part.scaled for part in parts], cut_pieces(cut), stack, cut.cycle_time, begun)


def joints_of(machine: CutterView, rows: PieceRows) -> Joints:
    """Return the joints of the tool's pieces, and how smooth it must be."""
    smooth, largest = machine.given.smoothness, ("MAX(ABS(fly_low),ABS(fly_high))", "fly_a")
    quickest = f"[{AT.phases}.rate.1]"
    required = RequiredSmoothness(smooth, "fly_smooth", "fly_order", largest, " s", names=PARTS, quickest=quickest)
    return Joints(rows, required, cut_joints(machine.cut, smooth), rates_of(machine.cut))


def cycle_sheet(book: Book, machine: CutterView, rows: PieceRows, stack: Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Cycle", "The tool over one cycle: it re-positions first, then works at line speed.")
    cut, t = machine.cut, machine.times
    at, load = cut.at(t), machine.load
    radius = machine.tool.radius
    speed, acceleration = at.speed / radius, at.acceleration / radius
    sheet.row += 1
    sheet.table(
        "cycle", f"Tool, shaft and load at {len(t) - 1} equal steps", len(t),
        calc("t", "time", "t", "s", "=[k]*fly_tc/[cycle.k.last]", t, format="0.0000"),
        result("s", "position of the tool", "s", "mm", f"=({sampled(rows, 0)})*1000", shown(at.position, MM), POSITION),
        result("v", "its speed", "v", "m/s", f"={sampled(rows, 1)}", at.speed, "ds/dt"),
        result("a", "its acceleration", "a", "m/s²", f"={sampled(rows, 2)}", at.acceleration, "d²s/dt²"),
        result("j", "its jerk", "j", "m/s³", f"={sampled(rows, 3)}", at.jerk, "d³s/dt³, between jumps"),
        result("n", "speed of the shaft", "n", "rpm", "=[w]*60/(2*PI())", shown(speed, RPM)),
        result("w", "speed of the shaft", "ω_L", "rad/s", "=[v]*1000/fly_r", speed, "v/R_t"),
        result("dw", "its acceleration", "ω̇_L", "rad/s²", "=[a]*1000/fly_r", acceleration, "a/R_t"),
        result("torque", "generalized load torque", "T*_L", "Nm", "=fly_torque+fly_j*[dw]",
               load.torque + load.inertia * acceleration, "T_L + J_L ω̇_L"),
        result("angle", "angle of the shaft", "θ", "°", "=DEGREES([s]/fly_r)", shown(at.position / radius, DEGREE),
               "s/R_t"),
        calc("product", "position of the product", "", "mm", "=fly_v*[t]*1000", shown(cut.line_speed * t, MM), "v_L t"),
        calc("line", "line speed", "v_L", "m/s", "=fly_v", machine.line),
        constant("k", "sample", "k", "", list(range(len(t)))),
        *finding(rows, "t", t),
    )  # fmt: skip
    motion_tables(sheet, machine, rows, stack)


def motion_tables(sheet: Sheet, machine: CutterView, rows: PieceRows, stack: Pieces) -> None:
    """Declare the parts of the cycle, and the pieces of the tool's motion."""
    sheet.heading("Workings: the tool's motion as pieces", ABOUT)
    sheet.note(WHERE)
    at, law = np.array([machine.cut.fastest]), machine.law
    sheet.table(
        "standing", "The law where it is fastest", 1,
        calc("xi", "abscissa", "ξ_v", "", "=fly_peak", at),
        *stack.finding("fly_no", machine.number, "xi", at),
        *stack.columns({"s": law.s(at), "v": law.v(at)}, "sv"),
    )  # fmt: skip
    parts = cut_parts(machine.cut)
    of = [part.scaled for part in parts]
    first, none = "=MATCH(fly_no,piece_number,0)", "=MATCH(1,piece_number,0)"
    sheet.table(
        AT.phases, "The parts of the cycle", len(PARTS),
        constant("what", "the tool", "", "", list(PARTS), align="left"),
        constant("k", "row", "k", "", [1, 2, 3, 4]),
        calc("h", "displacement by the law", "h", "m",
             ["=fly_h1/1000", "=0", "=fly_h1/1000", "=0"], [one.h for one in of]),
        calc("span", "time of the law", "t", "s",
             ["=fly_tm", "=fly_wait", "=fly_tm", "=fly_tt"], [one.duration for one in of]),
        calc("begin", "its time starts at", "", "s",
             ["=0", "=fly_stop", "=fly_wait", "=fly_tr"], [one.x for one in of]),
        calc("opens", "begins at", "", "s",
             ["=0", "=fly_stop", "=fly_stop+fly_wait", "=fly_tr"], [part.begin for part in parts]),
        calc("drift", "drift", "v", "m/s", ["=fly_v", "=0", "=fly_v", "=fly_v"], [one.drift for one in of]),
        calc("y0", "position there", "s", "m",
             ["=0", "=IF(fly_waits=1,fly_v*fly_stop+fly_h1/1000*[standing.s.1],0)", "=0",
              "=fly_v*fly_tm+fly_h1/1000*INDEX(law_s1,fly_no)"],
             [one.y for one in of]),
        *phase_table_columns(
            rows,
            [first, none, f"={last_before('fly_no', f'MIN({SPLIT}+2*break_eps,1)')}", none],
            [f"={last_before('fly_no', SPLIT)}-[first]+1", "=fly_waits",
             f"=IF(fly_waits=1,{last_before('fly_no', '1')}-[first]+1,0)", "=IF([span]>0,1,0)"],
        ),
    )  # fmt: skip
    joints = joints_of(machine, rows)
    sheet.rows(pieces_in_all(rows), *joints.order())
    sheet.row += 1
    pieces_table(sheet, "Pieces of the tool's motion", rows, machine.room, machine.cut.size)
    sheet.row += 1
    joints.table(sheet, "What jumps where each piece begins", machine.room)
