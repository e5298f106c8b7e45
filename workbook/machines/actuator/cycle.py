"""The sheet Cycle of an actuator: the load carried through each stage to the motor, over time."""

from __future__ import annotations

import numpy as np

from engine.laws.base import Array
from workbook.book.chart import Series
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.entries.units import RPM
from workbook.laws import phases as joined
from workbook.laws.sampling import Pieces
from workbook.machines.actuator.flow import Sized

FIND = (
    "=MATCH(MIN([time]/act_time+break_tolerance,1-break_tolerance),[phases.share],1)",
    "=MAX(0,([time]-INDEX([phases.begin],[p]))/INDEX([phases.span],[p]))",
    "=INDEX([phases.no],[p])",
)
LOSSY = '=IF(OR(act_method="document",[{0}]*[dir]>=0),[{0}]/[stages.eta.{1}],[{0}]*[stages.eta.{1}])/[stages.ratio.{1}]'
PARTS = ("accelerating", "uniform, or dwell", "decelerating")


def cycle_sheet(book: Book, machine: Sized, pieces: Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Cycle", "The load carried through each stage to the motor, over one cycle.")
    sheet.heading(
        "Workings",
        "From stage to stage T(k) = f T(k + 1)/i + J ω̇: f = 1/η where power flows to the load, η where it flows back.",
    )
    extremes(sheet, machine)
    limits(sheet, machine)
    sheet.heading(
        "Table over the cycle",
        "The load, ω_L, ω̇_L and T*_L, is that at the shaft which the motor is coupled to, without the motor.",
    )
    cycle(sheet, machine, pieces)
    sheet.print_columns = 12


def cascade(machine: Sized, acceleration: Array, direction: Array, used: Array) -> list[Quantity]:
    """Return the columns from the load's force or torque to the torque T* at the motor's shaft."""
    last, i = len(machine.mechanism.stages), machine.mechanism.ratio
    found = machine.shaft_torques(acceleration, direction, used)
    scales = [machine.force_scale / i * machine.mechanism.ratio_to(k) for k in range(last + 1)]
    made = [
        calc(f"t{last}", "at the load", "F, T", "N or Nm",
             "=[base]+[stages.own.last]*[acc]", found[last], scale=scales[last], source="resists + m a, J ω̇"),
    ]  # fmt: skip
    for k in reversed(range(last)):
        name = "into the mechanism" if k == 0 else f"behind gear {k}"
        own = f"+[stages.own.{k}]*act_i/[stages.to.{k}]*[acc]" if k else "+act_j0*act_i*[acc]"
        column = "total" if k == 0 else f"t{k}"
        behind = f"t{k + 1}"
        made.append(calc(column, name, "T*_L" if k == 0 else f"T_{k}", "Nm",
                         LOSSY.format(behind, k + 1) + own, found[k], scale=scales[k],
                         source="f T/i + J ω̇"))  # fmt: skip
    return made


def extremes(sheet: Sheet, machine: Sized) -> None:
    """Declare the torque in each part of each phase: at the law's extremes of acceleration, and without any."""
    n = machine.sizes.phases
    rows = [(k, part) for k in range(n) for part in range(3)]
    moves = machine.moves
    a = np.array([moves[k].extremes[part] for k, part in rows])
    direction = np.array([moves[k].direction for k, _ in rows])
    used = np.array([1.0 if k < len(machine.phases) else 0.0 for k, _ in rows])
    columns = cascade(machine, a, direction, used)
    torque = columns[-1].value + machine.motor_inertia * machine.mechanism.ratio * a
    pick = "CHOOSE([part],INDEX(law_ca_max,INDEX([phases.no],[p])),0,INDEX(law_ca_min,INDEX([phases.no],[p])))"
    sheet.table(
        "extremes", "Torque in the parts of the phases: at the law's extremes of acceleration, and without any", len(rows),
        constant("what", "part", "", "", [PARTS[part] for _, part in rows], align="left"),
        constant("p", "phase", "", "", [k + 1 for k, _ in rows]),
        result("torque", "motor torque", "T_m", "Nm",
               "=[total]+act_jm*act_i*[acc]", torque, scale=machine.torque_scale, source="T*_L + J_m ω̇"),
        calc("acc", "load acceleration", "a", "",
             f"=INDEX([phases.per],[p])*{pick}", a, scale=machine.acceleration_scale,
             source="C_a h/t²; m/s², or rad/s²"),
        calc("dir", "direction", "", "", "=INDEX([phases.dir],[p])", direction, format="0"),
        calc("base", "resists", "", "N or Nm",
             "=INDEX([phases.base],[p])", machine.resisting(direction, used), scale=machine.force_scale),
        *columns,
        constant("part", "part", "", "", [part + 1 for _, part in rows]),
    )  # fmt: skip


def limits(sheet: Sheet, machine: Sized) -> None:
    """Declare the corners of the motor's limits and the level of the RMS torque, as the charts draw them."""
    motor, sizing = machine.given.motor, machine.sizing
    top, left = motor.max_speed, -motor.max_speed if machine.returns else 0.0
    rated = motor.rated_torque * machine.derating
    sides, heights = (0, 1, 1, 0, 0), (-1, -1, 1, 1, -1)
    total = sizing.motion.total
    sheet.table(
        "limits", "Limits of the motor, as drawn in the charts", 5,
        constant("side", "right side", "", "", list(sides)),
        constant("up", "upper side", "", "", list(heights)),
        calc("rpm", "speed", "n", "rpm", "=IF([side]=1,act_motor_nmax,IF(MIN([phases.dir])<0,0-act_motor_nmax,0))",
             [top if s else left for s in sides]),
        calc("peak", "peak torque", "T_max", "Nm", "=[up]*act_motor_peak", [h * motor.peak_torque for h in heights]),
        calc("rated", "continuous torque", "T_N", "Nm", "=[up]*act_rated_left", [h * rated for h in heights]),
        calc("time", "time", "t", "s", "=[side]*act_time", [s * total for s in sides], scale=total),
        calc("rms", "RMS torque", "T_RMS", "Nm", "=act_rms", [machine.rms_torque] * 5, scale=machine.torque_scale),
    )  # fmt: skip


def cycle(sheet: Sheet, machine: Sized, pieces: Pieces) -> None:
    """Declare the table over the cycle."""
    motion, t, i = machine.sizing.motion, machine.time, machine.mechanism.ratio
    at, index = motion.at(t), motion.phase_index(t)
    direction = np.array([m.direction for m in machine.moves])[index]
    columns = cascade(machine, at.y2, direction, np.ones(len(t)))
    load = columns.pop()
    torque = load.value + machine.motor_inertia * i * at.y2
    v, a = machine.speed_scale, machine.acceleration_scale
    sheet.table(
        "cycle", "Load and motor over the cycle", len(t),
        calc("time", "time", "t", "s", "=[k]*act_time/[cycle.k.last]", t, format="0.0000", scale=motion.total),
        result("y", "position of the load", "x", "mm or °",
               "=(INDEX([phases.y0],[p])+INDEX([phases.h],[p])*[s])/act_unit", at.y / machine.unit,
               scale=machine.lift_scale / machine.unit, source="x_0 + h s"),
        result("rpm", "motor speed", "n_m", "rpm", "=[w]*60/(2*PI())", at.y1 * i / RPM, scale=v * i / RPM),
        result("torque", "motor torque", "T_m", "Nm",
               "=[total]+act_jm*[dw]", torque, scale=machine.torque_scale, source="T*_L + J_m ω̇_L"),
        result("power", "motor power", "P", "W",
               "=[torque]*[w]", torque * at.y1 * i, scale=machine.torque_scale * v * i, source="T_m ω_L"),
        result("w", "load speed", "ω_L", "rad/s", "=act_i*[vel]", i * at.y1, scale=i * v, source="i v"),
        result("dw", "load acceleration", "ω̇_L", "rad/s²", "=act_i*[acc]", i * at.y2, scale=i * a, source="i a"),
        Quantity("total", "load torque", "T*_L", "Nm",
                 "result", load.formula, load.value, source="T_L + J_L ω̇_L", scale=load.scale),
        constant("k", "sample", "k", "", list(range(len(t)))),
        calc("vel", "speed of the load", "v", "",
             "=INDEX([phases.h],[p])/INDEX([phases.span],[p])*[v]", at.y1, scale=v, source="h v/t; m/s, or rad/s"),
        calc("acc", "acceleration of the load", "a", "",
             "=INDEX([phases.per],[p])*[a]", at.y2, scale=a, source="h a/t²; m/s², or rad/s²"),
        calc("dir", "direction", "", "", "=INDEX([phases.dir],[p])", direction, format="0"),
        calc("base", "resists", "", "N or Nm",
             "=INDEX([phases.base],[p])", machine.resisting(direction, np.ones(len(t))), scale=machine.force_scale),
        *columns,
        *joined.located(motion, t, pieces, FIND, ("last begin not above t", "(t − begin)/duration")),
    )  # fmt: skip


def over_time(name: str, column: str) -> Series:
    """Return a line of the table over time."""
    return Series(name, "[cycle.time]", f"[cycle.{column}]")
