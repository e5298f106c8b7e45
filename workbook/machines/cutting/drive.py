"""The Drive sheet: inertia, load, motor and reducer of one axis; torque and power over the cycle."""

from __future__ import annotations

from math import pi, sqrt
from typing import Any

import numpy as np

from engine.drive import RETURNED, STANDSTILL
from engine.timing import shaft_speed
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, check, constant, given, result
from workbook.entries.units import PER_MINUTE, RPM
from workbook.machines.cutting.view import Cutting

S1 = "S1, slide 'Feeding group layout'"


def drive_sheet(book: Book, machine: Cutting) -> None:
    """Declare the sheet."""
    d = machine.machine.drive
    drive, rate = machine.drive, d.rate * PER_MINUTE
    omega = shaft_speed(rate)
    names = [a.name for a in machine.machine.timing.axes]
    sheet = book.sheet("Drive", f"Feeding group: inertia, load and motor of one axis, torque over the cycle ({S1}).")
    sheet.heading("What to enter")
    sheet.rows(
        given("drive_axis", "Axis that the drive moves", "", "",
              d.axis, "drive.axis", choices="=axis_name", source="its phases and laws come from Timing"),
        given("drive_rate", "Production rate", "n", "pieces/min",
              d.rate, "drive.rate", format="0.0##", source="of this sheet alone; S1: 100"),
        given("drive_force", "Resisting force", "F_r", "N", d.force, "drive.force", format="0.0##", source=S1),
        given("drive_radius", "Radius of the rollers", "R", "m", d.radius, "drive.radius", source=S1),
        given("drive_resists", "The load resists", "", "",
              d.resists, "drive.resists", source="always, or only while moving and against the motion"),
        given("drive_jm", "Inertia of motor and reducer", "J_m", "kg m²",
              d.motor.inertia, "drive.motor.inertia", source="ours: S1 leaves motor and ratio open"),
        given("drive_rated", "Rated torque of the motor", "T_N", "Nm",
              d.motor.rated_torque, "drive.motor.rated_torque", format="0.0##", source="ours"),
        given("drive_peak", "Peak torque of the motor", "T_max", "Nm",
              d.motor.peak_torque, "drive.motor.peak_torque", format="0.0##", source="ours"),
        given("drive_nmax", "Largest speed of the motor", "n_max", "rpm",
              d.motor.max_speed, "drive.motor.max_speed", format="0.0##", source="ours"),
        given("drive_ratio", "Reduction of the reducer", "i", "",
              d.motor.reduction, "drive.motor.reduction", format="0.0##", source="ours; ω_m / ω_r"),
        given("drive_eta", "Efficiency of the reducer", "η", "",
              d.motor.efficiency, "drive.motor.efficiency", format="0.0##",
              source="ours; 1 for S1's equation as printed"),
    )  # fmt: skip
    draw(sheet)
    inertia_table(sheet, machine)
    sheet.heading("Workings")
    load, inertia = d.force * d.radius, drive.load.inertia
    effective = d.motor.inertia * d.motor.reduction + inertia / d.motor.reduction
    sheet.rows(
        calc("drive_no", "Number of the axis on Timing", "", "",
             "=MATCH(drive_axis,axis_name,0)", names.index(d.axis) + 1, format="0"),
        calc("drive_tc", "Time of one turn", "t_c", "s", "=60/drive_rate", 1 / rate, source="60 / n"),
        calc("drive_omega", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()*drive_rate/60", omega, source="2π n / 60"),
        result("drive_jtot", "Inertia at the roller shaft", "J_tot", "kg m²",
               "=SUM([rotors.reflected])", inertia, source="Σ count · J · (ω_i/ω_1)²; S1: 4 J1 + 4 J2"),
        result("drive_cr", "Resisting torque", "C_r", "Nm", "=drive_force*drive_radius", load, source="F_r R"),
        calc("drive_tau", "Transmission ratio", "τ", "", "=1/drive_ratio", 1 / d.motor.reduction, source="ω_r / ω_m"),
        calc("drive_jeff", "Inertia felt by the motor, per ω̇_r", "", "kg m²",
             "=drive_jm/drive_tau+drive_tau*drive_jtot", effective, source="J_m/τ + τ J_tot"),
        constant("drive_still", "Slower than this counts as standing", "ω_0", "rad/s",
                 STANDSTILL, format="0E+00", source="at the roller shaft"),
        constant("drive_returned", "A load that gives back less counts as driven", "P_0", "W",
                 RETURNED, format="0E+00", source="at the roller shaft; rounding never decides the losses"),
    )  # fmt: skip
    outcome(sheet, machine)
    sheet.heading("Table over the cycle")
    table(sheet, machine, omega)
    limits(sheet, machine)
    sheet.print_columns = 18


def inertia_table(sheet: Sheet, machine: Cutting) -> None:
    """Declare the rotating parts: count, inertia, teeth; what each weighs at the roller shaft."""
    rotors, n = machine.machine.drive.rotors, machine.machine.sizes.rotors
    pad = n - len(rotors)

    def entered(name: str) -> list[Any]:
        return [getattr(r, name) for r in rotors] + [None] * pad

    ratios = [r.speed_ratio for r in machine.rotors] + [1.0] * pad
    reflected = [r.count * r.J * r.speed_ratio**2 for r in machine.rotors] + [0.0] * pad
    sheet.row += 1
    sheet.table(
        "rotors", f"Rotating parts ({S1}): leave the teeth empty for what turns with the rollers", n,
        given("name", "part", "", "", entered("name"), "drive.rotors.*.name"),
        given("count", "count", "", "", entered("count"), "drive.rotors.*.count", format="0"),
        given("inertia", "inertia of one", "J", "kg m²",
              entered("inertia"), "drive.rotors.*.inertia", format="0.0000##"),
        given("driver", "teeth of the driver", "n1", "",
              entered("teeth_driver"), "drive.rotors.*.teeth_driver", format="0"),
        given("driven", "teeth of the driven", "n2", "",
              entered("teeth_driven"), "drive.rotors.*.teeth_driven", format="0"),
        calc("speed", "speed ratio", "ω_i/ω_1", "",
             "=IF(COUNT([driver],[driven])=2,[driver]/[driven],1)", ratios, source="n1 / n2"),
        calc("reflected", "at the roller shaft", "J*", "kg m²",
             "=[count]*[inertia]*[speed]^2", reflected, source="count · J · (ω_i/ω_1)²"),
    )  # fmt: skip


def outcome(sheet: Sheet, machine: Cutting) -> None:
    """Declare peaks and RMS, and the checks against the motor's limits."""
    drive, motor = machine.drive, machine.machine.drive.motor
    points = operating(machine)
    torque, rpm = points["torque"], points["rpm"]
    rms = sqrt(float(np.mean((torque[1:] ** 2 + torque[:-1] ** 2) / 2)))
    lossless = rms_lossless(machine)
    peak = float(np.abs(torque).max())
    fastest = float(np.abs(rpm).max())
    sheet.heading("What comes out")
    sheet.rows(
        result("drive_tmax", "Largest torque of the motor", "C_m,max", "Nm",
               "=MAX([drive.torque])", float(torque.max()), source="driving"),
        result("drive_tmin", "Lowest torque of the motor", "C_m,min", "Nm",
               "=MIN([drive.torque])", float(torque.min()), source="braking", scale=peak),
        result("drive_rms", "RMS torque of the motor", "C_m,rms", "Nm",
               ("=SQRT((2*SUMPRODUCT([drive.torque],[drive.torque])-[drive.torque.first]^2"
                "-[drive.torque.last]^2)/(2*[drive.k.last]))"), rms,
               source="over the cycle, trapezoidal rule on the table"),
        calc("drive_rms1", "RMS torque without losses", "", "Nm",
             "=SQRT((drive_jeff*drive_wrms)^2+(drive_tau*drive_cr)^2*drive_share)", lossless["torque"],
             source="exact, from C_a,rms; to compare"),
        calc("drive_wrms", "RMS acceleration of the rollers", "ω̇_r,rms", "rad/s²",
             "=drive_omega^2/drive_radius*SQRT(SUMPRODUCT([drive_phases.square],[drive_phases.share]))",
             lossless["acceleration"], source="exact, from C_a,rms"),
        calc("drive_share", "Share of the cycle in which the load resists", "", "",
             '=IF(drive_resists="always",1,SUM([drive_phases.moving]))', lossless["share"]),
        result("drive_speed", "Largest speed of the motor", "n_m", "rpm",
               "=MAX(MAX([drive.rpm]),-MIN([drive.rpm]))", fastest, source=""),
        result("drive_pmax", "Largest power of the motor", "P_max", "W",
               "=MAX([drive.power])", float(points["power"].max()), source="C_m ω_m"),
        result("drive_pmin", "Lowest power of the motor", "P_min", "W",
               "=MIN([drive.power])", float(points["power"].min()), source="negative: the load drives the motor"),
        result("drive_inertias", "Inertia ratio", "", "",
               "=IF(drive_jm>0,drive_jtot*drive_tau^2/drive_jm,0)",
               drive.load.inertia * drive.transmission.ratio**2 / motor.inertia if motor.inertia else 0.0,
               source="load at the motor shaft / motor"),
    )  # fmt: skip
    sheet.checks(
        check(
            "drive_ok_rms",
            "Drive: RMS torque within the rated torque",
            "drive_rms<=drive_rated",
            rms <= motor.rated_torque,
        ),
        check(
            "drive_ok_peak",
            "Drive: peak torque within the motor's",
            "MAX(drive_tmax,-drive_tmin)<=drive_peak",
            peak <= motor.peak_torque,
        ),
        check(
            "drive_ok_speed",
            "Drive: speed within the motor's",
            "drive_speed<=drive_nmax",
            fastest <= motor.max_speed,
        ),
    )
    phases(sheet, machine)


def phases(sheet: Sheet, machine: Cutting) -> None:
    """Declare what each phase of the driven axis adds to the mean square."""
    n = machine.machine.sizes.phases
    squares, shares, moving = phase_shares(machine)

    def chosen(column: str) -> str:
        return "CHOOSE(drive_no," + ",".join(f"INDEX([axis{i}.{column}],[k])" for i in (1, 2, 3)) + ")"

    sheet.row += 1
    sheet.table(
        "drive_phases", "Phases of the driven axis", n,
        constant("k", "phase", "k", "", list(range(1, n + 1))),
        calc("square", "square of RMS y''", "", "m²/rad⁴",
             f"=({chosen('rms')}/timing_omega^2)^2", squares, source="(C_a,rms h/δ²)²"),
        calc("share", "share of the cycle", "δ/2π", "", f"={chosen('span')}/(2*PI())", shares),
        calc("moving", "share in motion", "", "", f"=IF({chosen('h')}=0,0,[share])", moving),
    )  # fmt: skip


def phase_shares(machine: Cutting) -> tuple[list[float], list[float], list[float]]:
    """Return the engine's mean square of y'', share of the cycle and share in motion of each phase."""
    motion, n = machine.driven.motion, machine.machine.sizes.phases
    rms = [p.law.coefficients.ca_rms * p.lift / p.duration**2 for p in motion.phases]
    shares = [p.duration / motion.total for p in motion.phases]
    moving = [share if p.lift else 0.0 for share, p in zip(shares, motion.phases, strict=True)]
    pad = [0.0] * (n - len(rms))
    return [r * r for r in rms] + pad, shares + pad, moving + pad


def rms_lossless(machine: Cutting) -> dict[str, float]:
    """Return the exact RMS torque for an efficiency of 1, and what it is made of."""
    d, drive = machine.machine.drive, machine.drive
    squares, shares, moving = phase_shares(machine)
    omega = shaft_speed(d.rate * PER_MINUTE)
    acceleration = omega**2 / d.radius * sqrt(float(np.dot(squares, shares)))
    share = 1.0 if d.resists == "always" else sum(moving)
    tau = drive.transmission.ratio
    inertial = (drive.motor.inertia / tau + tau * drive.load.inertia) * acceleration
    return {
        "acceleration": acceleration,
        "share": share,
        "torque": sqrt(inertial**2 + (tau * drive.load.torque) ** 2 * share),
    }


def operating(machine: Cutting) -> dict[str, np.ndarray]:
    """Return the engine's speeds, torques and power of the driven axis over the cycle."""
    d, drive = machine.machine.drive, machine.drive
    omega = shaft_speed(d.rate * PER_MINUTE)
    at = machine.driven.motion.at(np.deg2rad(machine.angles))
    w, dw = at.y1 * omega / d.radius, at.y2 * omega**2 / d.radius
    return {
        "y1": at.y1, "y2": at.y2, "w": w, "dw": dw,
        "load": drive.load_torque(w), "total": drive.total_load_torque(w, dw),
        "rpm": drive.motor_speed(w) / RPM, "torque": drive.motor_torque(w, dw), "power": drive.power(w, dw),
    }  # fmt: skip


def table(sheet: Sheet, machine: Cutting, omega: float) -> None:
    """Declare speeds, torques and power over the cycle."""
    p, n = operating(machine), len(machine.angles)
    loss = machine.drive.loss_factor(p["w"], p["dw"])

    def chosen(column: str) -> str:
        return "=CHOOSE(drive_no," + ",".join(f"INDEX([cycle.{column}{i}],[k]+1)" for i in (1, 2, 3)) + ")"

    sheet.table(
        "drive", "Speed, torque and power over the cycle", n,
        calc("theta", "master angle", "θ", "°", "=[k]*360/[drive.k.last]", machine.angles, format="0.0##"),
        calc("time", "time", "t", "s",
             "=[theta]/360*drive_tc", machine.angles / 360 * 2 * pi / omega, source="θ t_c / 360"),
        result("rpm", "motor speed", "n_m", "rpm", "=[w]/drive_tau*60/(2*PI())", p["rpm"], source="ω_r/τ"),
        result("torque", "motor torque", "C_m", "Nm",
               "=drive_jm/drive_tau*[dw]+drive_tau*[total]*[loss]", p["torque"], source="(J_m/τ)ω̇_r + τ C*_r f"),
        result("power", "motor power", "P", "W", "=[torque]*[w]/drive_tau", p["power"], source="C_m ω_m"),
        calc("y1", "geometric velocity", "y'", "m/rad", chosen("g"), p["y1"], source="from Timing"),
        calc("y2", "geometric acceleration", "y''", "m/rad²", chosen("gg"), p["y2"], source="from Timing"),
        calc("w", "roller speed", "ω_r", "rad/s", "=[y1]*drive_omega/drive_radius", p["w"], source="v/R"),
        calc("dw", "roller acceleration", "ω̇_r", "rad/s²", "=[y2]*drive_omega^2/drive_radius", p["dw"], source="a/R"),
        calc("load", "resisting torque", "C_r", "Nm",
             '=IF(drive_resists="always",drive_cr,IF(ABS([w])<drive_still,0,SIGN([w])*drive_cr))', p["load"]),
        calc("total", "load torque", "C*_r", "Nm", "=[load]+drive_jtot*[dw]", p["total"], source="C_r + J_tot ω̇_r"),
        calc("loss", "loss factor", "f", "",
             "=IF(OR(ABS([w])<drive_still,[total]*[w]+drive_returned>=0),1/drive_eta,drive_eta)", loss,
             source="1/η driving, η braking"),
        constant("k", "sample", "k", "", list(range(n))),
    )  # fmt: skip


def limits(sheet: Sheet, machine: Cutting) -> None:
    """Declare the corners of the motor's limits as the speed–torque chart draws them."""
    motor, points = machine.machine.drive.motor, operating(machine)
    reverse = bool(points["w"].min() < -STANDSTILL)
    left = -motor.max_speed if reverse else 0.0
    sides, heights = (0, 1, 1, 0, 0), (-1, -1, 1, 1, -1)
    sheet.table(
        "limits", "Limits of the motor, as drawn in the speed–torque chart", 5,
        constant("corner", "corner", "", "", [1, 2, 3, 4, 5]),
        constant("side", "right side", "", "", list(sides)),
        constant("up", "upper side", "", "", list(heights)),
        calc("rpm", "speed", "n", "rpm", "=IF([side]=1,drive_nmax,IF(MIN([drive.w])<-drive_still,-drive_nmax,0))",
             [motor.max_speed if s else left for s in sides]),
        calc("peak", "peak torque", "T_max", "Nm", "=[up]*drive_peak", [h * motor.peak_torque for h in heights]),
        calc("rated", "rated torque", "T_N", "Nm", "=[up]*drive_rated", [h * motor.rated_torque for h in heights]),
    )  # fmt: skip


def draw(sheet: Sheet) -> None:
    """Place the speed–torque chart and the torque over the cycle beside the figures."""
    points: tuple[Series, ...] = (
        Series("operating points", "[drive.rpm]", "[drive.torque]"),
        Series("peak torque and speed of the motor", "[limits.rpm]", "[limits.peak]", dashed=True),
        Series("rated torque", "[limits.rpm]", "[limits.rated]", dashed=True),
    )
    sheet.chart(
        Chart("Torque against speed of the motor", "motor speed n_m [rpm]", "motor torque C_m [Nm]", points,
              "Operating points of the motor over one cycle in the speed–torque plane, with the motor's limits"),
        column=11, row=5, width=8, height=22,
    )  # fmt: skip
    over_time = tuple(Series(n, "[drive.theta]", f"[drive.{c}]") for n, c in (("motor torque C_m [Nm]", "torque"),))
    sheet.chart(
        Chart("Torque of the motor over the cycle", "master angle θ [°]", "motor torque C_m [Nm]", over_time,
              "Torque of the motor over one turn of the master shaft", (0, 360, 30)),
        column=11, row=28, width=8, height=16,
    )  # fmt: skip
    power = (Series("power", "[drive.theta]", "[drive.power]"),)
    sheet.chart(
        Chart("Power of the motor over the cycle", "master angle θ [°]", "power P [W]", power,
              "Power of the motor over one turn of the master shaft", (0, 360, 30)),
        column=11, row=45, width=8, height=16,
    )  # fmt: skip
