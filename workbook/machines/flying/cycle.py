"""The Cycle sheet: tool, shaft and load over a cycle, from the end of a cut to the end of the next, by pieces."""

import numpy as np

from engine.flying.pieces import cut_joints, cut_parts, cut_pieces, rates_of
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Book, Sheet
from workbook.fields.units import DEGREE, MM, RPM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.flying.view import CutterView
from workbook.motion import pieces
from workbook.motion.cells import Cells, PieceRows, last_before, rows_of_parts
from workbook.motion.requirements import RequiredSmoothness
from workbook.motion.smooth import Joints

CELLS = cell_tables(__file__)

AT = Cells("stretches", "tool_pieces", "fly_pieces", "fly_tc", "m", "s", drifts=True, opens=True)
SPLIT = "IF(fly_waits=1,fly_peak,1)"
PARTS = formulas_by_row(__file__, "parts of the cycle")
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
    required = RequiredSmoothness(
        smooth, "fly_smooth", "fly_order", largest, " s", names=tuple(PARTS["what"]), quickest=quickest
    )
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
    cell.sharing(steps=len(t) - 1).place(
        sheet,
        cell("t", t),
        cell("s", shown(at.position, MM), sampled=pieces.sampled(rows, 0), source=pieces.POSITION),
        cell("v", at.speed, sampled=pieces.sampled(rows, 1)),
        cell("a", at.acceleration, sampled=pieces.sampled(rows, 2)),
        cell("j", at.jerk, sampled=pieces.sampled(rows, 3)),
        cell("n", shown(speed, RPM)),
        cell("w", speed),
        cell("dw", acceleration),
        cell("torque", load.torque + load.inertia * acceleration),
        cell("angle", shown(at.position / radius, DEGREE)),
        cell("product", shown(cut.line_speed * t, MM)),
        cell("line", machine.line),
        cell("k", list(range(len(t)))),
        *pieces.finding(rows, "t", t),
    )
    motion_tables(sheet, machine, rows, stack)


def motion_tables(sheet: Sheet, machine: CutterView, rows: PieceRows, stack: Pieces) -> None:
    """Declare the parts of the cycle, and the pieces of the tool's motion."""
    sheet.heading("Workings: the tool's motion as pieces", pieces.ABOUT)
    sheet.note(WHERE)
    at, law = np.array([machine.cut.fastest]), machine.law
    position, velocity = stack.columns({"s": law.s(at), "v": law.v(at)}, "sv")
    CELLS["standing"].place(
        sheet,
        CELLS["standing"]("xi", at),
        *stack.finding("fly_no", machine.number, "xi", at),
        position,
        velocity._replace(symbol="s'"),  # v is the tool's, in m/s
    )
    parts = cut_parts(machine.cut)
    of = [part.scaled for part in parts]
    figures = {
        "h": [part.h for part in of],
        "span": [part.duration for part in of],
        "begin": [part.x for part in of],
        "opens": [part.begin for part in parts],
        "drift": [part.drift for part in of],
        "y0": [part.y for part in of],
    }
    cell = CELLS["motion_tables"]
    first, none = "=MATCH(fly_no,piece_number,0)", "=MATCH(1,piece_number,0)"
    cell.place(
        sheet,
        cell("what", PARTS["what"]),
        cell("k", [1, 2, 3, 4]),
        *(cell(name, values, formula=PARTS[name]) for name, values in figures.items()),
        *pieces.phase_table_columns(
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
    sheet.rows(pieces.pieces_in_all(rows), *joints.order())
    sheet.row += 1
    pieces.pieces_table(sheet, "Pieces of the tool's motion", rows, machine.room, machine.cut.size)
    sheet.row += 1
    joints.table(sheet, "What jumps where each piece begins", machine.room)
