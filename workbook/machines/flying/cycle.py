"""The Cycle sheet: tool, shaft and load over one cycle, from the end of one cut to the end of the next."""

from __future__ import annotations

from workbook.book.declare import Book, calc, constant, result
from workbook.entries.units import DEGREE, MM, RPM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.flying.motion import motion_tables
from workbook.machines.flying.view import Flying
from workbook.motion.cells import PieceRows
from workbook.motion.sampled import POSITION, finding, sampled


def cycle_sheet(book: Book, machine: Flying, rows: PieceRows, stack: Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Cycle", "The tool over one cycle: it re-positions first, then works at line speed.")
    cut, at, shaft, t, scale = machine.cut, machine.samples, machine.shaft, machine.times, machine.scales
    mm = shown(scale.length, MM)
    sheet.row += 1
    sheet.table(
        "cycle", f"Tool, shaft and load at {len(t) - 1} equal steps", len(t),
        calc("t", "time", "t", "s", "=[k]*fly_tc/[cycle.k.last]", t, format="0.0000", scale=cut.cycle_time),
        result("s", "position of the tool", "s", "mm",
               f"=({sampled(rows, 0)})*1000", shown(at.position, MM), scale=mm, source=POSITION),
        result("v", "its speed", "v", "m/s",
               f"={sampled(rows, 1)}", at.speed, scale=scale.speed, source="ds/dt"),
        result("a", "its acceleration", "a", "m/s²",
               f"={sampled(rows, 2)}", at.acceleration, scale=scale.acceleration, source="d²s/dt²"),
        result("j", "its jerk", "j", "m/s³",
               f"={sampled(rows, 3)}", at.jerk, scale=cut.size(3), source="d³s/dt³, between jumps"),
        result("n", "speed of the shaft", "n", "rpm",
               "=[w]*60/(2*PI())", shown(shaft.speed, RPM), scale=shown(scale.angular_speed, RPM)),
        result("w", "speed of the shaft", "ω_L", "rad/s",
               "=[v]*1000/fly_r", shaft.speed, scale=scale.angular_speed, source="v/R_t"),
        result("dw", "its acceleration", "ω̇_L", "rad/s²",
               "=[a]*1000/fly_r", shaft.acceleration, scale=scale.angular_acceleration, source="a/R_t"),
        result("torque", "generalized load torque", "T*_L", "Nm",
               "=fly_torque+fly_j*[dw]", machine.torque, scale=scale.torque, source="T_L + J_L ω̇_L"),
        result("angle", "angle of the shaft", "θ", "°",
               "=DEGREES([s]/fly_r)", shown(shaft.angle, DEGREE), scale=shown(scale.angle, DEGREE),
               source="s/R_t"),
        calc("product", "position of the product", "", "mm",
             "=fly_v*[t]*1000", shown(cut.product_position(t), MM), scale=mm, source="v_L t"),
        calc("line", "line speed", "v_L", "m/s", "=fly_v", machine.line),
        constant("k", "sample", "k", "", list(range(len(t)))),
        *finding(rows, "t", t),
    )  # fmt: skip
    motion_tables(sheet, machine, rows, stack)
