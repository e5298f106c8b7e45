"""The Cycle sheet: tool, shaft and load over a cycle, from the end of a cut to the end of the next, by pieces."""

import numpy as np

from engine.flying.pieces import cut_joints, cut_parts, cut_pieces, rates_of
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Sheet
from workbook.fields.units import DEGREE, MM, RPM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.flying.view import CutterView
from workbook.motion.cells import Cells, PieceRows, last_before, rows_of_parts
from workbook.motion.pieces import ABOUT, POSITION, finding, phase_table_columns, pieces_in_all, pieces_table, sampled
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints

CELLS = cell_tables(__file__)

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
    cell = CELLS["cycle"]
    sheet = book.sheet("Cycle", "The tool over one cycle: it re-positions first, then works at line speed.")
    sheet.unprinted = True
    cut, t = machine.cut, machine.times
    at, load = cut.at(t), machine.load
    radius = machine.tool.radius
    speed, acceleration = at.speed / radius, at.acceleration / radius
    sheet.row += 1
    sheet.table(
        "cycle",
        f"Tool, shaft and load at {len(t) - 1} equal steps",
        len(t),
        cell("t", t),
        cell("s", shown(at.position, MM), sampled=sampled(rows, 0), source=POSITION),
        cell("v", at.speed, sampled=sampled(rows, 1)),
        cell("a", at.acceleration, sampled=sampled(rows, 2)),
        cell("j", at.jerk, sampled=sampled(rows, 3)),
        cell("n", shown(speed, RPM)),
        cell("w", speed),
        cell("dw", acceleration),
        cell("torque", load.torque + load.inertia * acceleration),
        cell("angle", shown(at.position / radius, DEGREE)),
        cell("product", shown(cut.line_speed * t, MM)),
        cell("line", machine.line),
        cell("k", list(range(len(t)))),
        *finding(rows, "t", t),
    )
    motion_tables(sheet, machine, rows, stack)


def motion_tables(sheet: Sheet, machine: CutterView, rows: PieceRows, stack: Pieces) -> None:
    """Declare the parts of the cycle, and the pieces of the tool's motion."""
    sheet.heading("Workings: the tool's motion as pieces", ABOUT)
    sheet.note(WHERE)
    at, law = np.array([machine.cut.fastest]), machine.law
    position, velocity = stack.columns({"s": law.s(at), "v": law.v(at)}, "sv")
    sheet.table(
        "standing",
        "The law where it is fastest",
        1,
        CELLS["standing"]("xi", at),
        *stack.finding("fly_no", machine.number, "xi", at),
        position,
        velocity._replace(symbol="s'"),  # v is the tool's, in m/s
    )
    parts = cut_parts(machine.cut)
    of = [part.scaled for part in parts]
    first, none = "=MATCH(fly_no,piece_number,0)", "=MATCH(1,piece_number,0)"
    sheet.table(
        AT.phases,
        "The parts of the cycle",
        len(PARTS),
        CELLS["motion_tables"]("what", list(PARTS)),
        CELLS["motion_tables"]("k", [1, 2, 3, 4]),
        CELLS["motion_tables"]("h", [part.h for part in of], formula=["=fly_h1/1000", "=0", "=fly_h1/1000", "=0"]),
        CELLS["motion_tables"](
            "span", [part.duration for part in of], formula=["=fly_tm", "=fly_wait", "=fly_tm", "=fly_tt"]
        ),
        CELLS["motion_tables"]("begin", [part.x for part in of], formula=["=0", "=fly_stop", "=fly_wait", "=fly_tr"]),
        CELLS["motion_tables"](
            "opens", [part.begin for part in parts], formula=["=0", "=fly_stop", "=fly_stop+fly_wait", "=fly_tr"]
        ),
        CELLS["motion_tables"]("drift", [part.drift for part in of], formula=["=fly_v", "=0", "=fly_v", "=fly_v"]),
        CELLS["motion_tables"](
            "y0",
            [part.y for part in of],
            formula=[
                "=0",
                "=IF(fly_waits=1,fly_v*fly_stop+fly_h1/1000*[standing.s.1],0)",
                "=0",
                "=fly_v*fly_tm+fly_h1/1000*INDEX(law_s1,fly_no)",
            ],
        ),
        *phase_table_columns(
            rows,
            [first, none, f"={last_before('fly_no', f'MIN({SPLIT}+2*break_eps,1)')}", none],
            [
                f"={last_before('fly_no', SPLIT)}-[first]+1",
                "=fly_waits",
                f"=IF(fly_waits=1,{last_before('fly_no', '1')}-[first]+1,0)",
                "=IF([span]>0,1,0)",
            ],
        ),
    )
    joints = joints_of(machine, rows)
    sheet.rows(pieces_in_all(rows), *joints.order())
    sheet.row += 1
    pieces_table(sheet, "Pieces of the tool's motion", rows, machine.room, machine.cut.size)
    sheet.row += 1
    joints.table(sheet, "What jumps where each piece begins", machine.room)
