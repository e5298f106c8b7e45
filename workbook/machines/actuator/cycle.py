"""The sheet Cycle of an actuator: the load carried through each stage to the motor, over time."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from workbook.book.declare import Book, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.drive.motor import limits_table, rms_point
from workbook.drive.stages import through
from workbook.entries.units import RPM, shown
from workbook.machines.actuator.tables import AT, joints, resists
from workbook.machines.actuator.view import Sized
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import ABOUT, TITLE, pieces_in_all, pieces_table
from workbook.motion.sampled import POSITION, derivative, finding

PARTS = ("accelerating", "uniform, or dwell", "decelerating")
EXTREMES = "Torque in the parts of the phases: at the law's extremes of acceleration, and without any"


def cycle_sheet(book: Book, machine: Sized, rows: PieceRows) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Cycle", "The load carried through each stage to the motor, over one cycle.")
    with sheet.scoped("act_"):
        sheet.note("The load, ω_L, ω̇_L and T*_L, is at the shaft that the motor is coupled to, without the motor.")
        cycle(sheet, machine, rows)
        sheet.heading(
            "Workings",
            "From stage to stage T(k) = f T(k + 1)/i + J ω̇: "
            "f = 1/η where power flows to the load, η where it flows back.",
        )
        extremes(sheet, machine)
        limits(sheet, machine)
        found = joints(machine, rows)
        sheet.heading(f"Workings: {TITLE.lower()}", ABOUT)
        sheet.rows(
            pieces_in_all(rows),
            found.order(),
        )  # fmt: skip
        sheet.row += 1
        pieces_table(sheet, TITLE, rows, machine.room, machine.sizing.motion.size, *found.columns(machine.room))
    sheet.print_columns = 12


def extremes(sheet: Sheet, machine: Sized) -> None:
    """Declare the torque in each part of each phase: at the law's extremes of acceleration, and without any."""
    n, sides, moves = machine.sizes.phases, machine.sides, machine.sizing.moves
    rows = [(k, part) for k in range(n) for part in range(len(PARTS))]

    def spread(values: list[float]) -> list[float]:
        return [values[k] for k, _ in rows]

    def of_shaft(k: int) -> np.ndarray:
        found = [machine.drive.torques(move.extremes, move.direction)[k] for move in moves]
        return np.array(filled(found, n, np.zeros(len(PARTS)))).ravel()

    accelerations = np.array(filled([move.extremes for move in moves], n, (0.0, 0.0, 0.0))).ravel()
    torques = [torque for row in machine.part_torques for torque in row]
    pick = "CHOOSE([part],INDEX(law_ca_max,INDEX([phases.no],[p])),0,INDEX(law_ca_min,INDEX([phases.no],[p])))"
    sheet.table(
        "extremes", EXTREMES, len(rows),
        constant("what", "part", "", "", [PARTS[part] for _, part in rows], align="left"),
        constant("p", "phase", "", "", [k + 1 for k, _ in rows]),
        result("torque", "motor torque", "T_m", "Nm",
               "=[total]+@jm*@i*[acc]", torques, scale=sides.torque, source="T*_L + J_m ω̇"),
        calc("acc", "load acceleration", "a", "",
             f"=INDEX([phases.per],[p])*{pick}", accelerations, scale=sides.acceleration,
             source="C_a h/t²; m/s², or rad/s²"),
        calc("dir", "direction", "", "",
             "=INDEX([phases.dir],[p])", spread(machine.of_moves(lambda move: move.direction)), format="0"),
        calc("base", "resists", "", "N or Nm",
             "=INDEX([phases.base],[p])", spread(resists(machine)), scale=sides.force),
        *through([of_shaft(k) for k in range(machine.mechanism.last + 1)], sides),
        constant("part", "part", "", "", [part + 1 for _, part in rows]),
        blank='INDEX(phase_times,[p])=""',
    )  # fmt: skip


def limits(sheet: Sheet, machine: Sized) -> None:
    """Declare the corners of the motor's limits and the level of the RMS torque, as the charts draw them."""
    total, lowest = machine.sizing.motion.total, min(machine.of_moves(lambda move: move.direction))
    corners = machine.motor.corners(lowest)
    limits_table(
        sheet, corners, "MIN([phases.dir])<0", "@rated_left",
        calc("time", "time", "t", "s",
             "=[side]*@time", np.where(corners.right, total, 0.0), scale=total),
        calc("rms", "RMS torque", "T_RMS", "Nm", "=@rms", machine.rms_torque, scale=machine.sides.torque),
    )  # fmt: skip
    rms_point(sheet, machine.sizing.mean_speed, machine.rms_torque)


def cycle(sheet: Sheet, machine: Sized, rows: PieceRows) -> None:
    """Declare the table over the cycle."""
    t, sides, drive = machine.time, machine.sides, machine.drive
    at, going = machine.sizing.motion.at(t), machine.sizing.going(t)
    shafts = drive.shafts(at.y1, at.y2, going)
    motor = drive.operating_points(at.y1, at.y2, going)
    *columns, load = through([shaft.torque for shaft in shafts], sides)
    sheet.table(
        "cycle", "Load and motor over the cycle", len(t),
        calc("time", "time", "t", "s", "=[k]*@time/[cycle.k.last]", t, format="0.0000", scale=sides.time),
        result("y", "position of the load", "x", "mm or °",
               f"=({derivative(rows, 0)})/@unit", shown(at.y, machine.unit), scale=shown(sides.lift, machine.unit),
               source=POSITION),
        result("rpm", "motor speed", "n_m", "rpm",
               "=[w]*60/(2*PI())", shown(motor.speed, RPM), scale=shown(sides.motor_speed, RPM)),
        result("torque", "motor torque", "T_m", "Nm",
               "=[total]+@jm*[dw]", motor.torque, scale=sides.torque, source="T*_L + J_m ω̇_L"),
        result("power", "motor power", "P", "W", "=[torque]*[w]", motor.power, scale=sides.power, source="T_m ω_L"),
        result("w", "load speed", "ω_L", "rad/s", "=@i*[vel]", shafts[0].speed, scale=sides.motor_speed, source="i v"),
        result("dw", "load acceleration", "ω̇_L", "rad/s²",
               "=@i*[acc]", shafts[0].acceleration, scale=sides.motor_acceleration, source="i a"),
        replace(load, label="load torque", role="result", source="T_L + J_L ω̇_L"),
        constant("k", "sample", "k", "", list(range(len(t)))),
        calc("vel", "speed of the load", "v", "",
             f"={derivative(rows, 1)}", at.y1, scale=sides.speed, source="dx/dt; m/s, or rad/s"),
        calc("acc", "acceleration of the load", "a", "",
             f"={derivative(rows, 2)}", at.y2, scale=sides.acceleration, source="d²x/dt²; m/s², or rad/s²"),
        calc("jerk", "jerk of the load", "j", "",
             f"={derivative(rows, 3)}", at.y3, scale=machine.sizing.motion.size(3), source="d³x/dt³, between jumps"),
        calc("p", "phase", "", "", f"={AT.of_piece('p', 'q')}", machine.sizing.motion.phase_index(t) + 1, format="0"),
        calc("dir", "direction", "", "", "=INDEX([phases.dir],[p])", going, format="0"),
        calc("base", "resists", "", "N or Nm",
             "=INDEX([phases.base],[p])", drive.resisting(going), scale=sides.force),
        *columns,
        *finding(rows, "time", t),
    )  # fmt: skip
