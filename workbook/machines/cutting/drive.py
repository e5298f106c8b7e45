"""The drive of one axis: inertia, load, motor and reducer; behind it torque and power over the cycle."""

from __future__ import annotations

from typing import Any

from engine.drivetrain.cycle import Move
from engine.drivetrain.losses import rounding_of
from workbook.book.chart import Chart, Series
from workbook.book.declare import FIRST, Book, Sheet, calc, constant, given, result
from workbook.book.rows import filled
from workbook.drive import losses
from workbook.drive.entries import GEARED
from workbook.drive.motor import limit_checks, limits_given, limits_table, plane, rms_point
from workbook.entries.texts import place_of
from workbook.entries.units import KW, RPM, shown
from workbook.machines.cutting.view import ROLLERS, Cutting

S1 = "S1, slide 'Feeding group layout'"
SCOPE = "drive_"


def drive_sheet(book: Book, machine: Cutting) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Drive", f"Feeding group: inertia, load and motor of one axis, torque over the cycle ({S1}).")
    with sheet.scoped(SCOPE):
        entries(sheet, machine)
        draw(sheet)
        inertia_table(sheet, machine)
        workings(sheet, machine)
        outcome(sheet, machine)
        phases(sheet, machine)
        sheet.not_printed_below()
        sheet.heading("Workings: as drawn in the charts")
        limits_table(sheet, machine.motor.corners(float(machine.samples.speed.min())), "MIN([drive.w])<0-@still")
        rms_point(sheet, machine.samples.motor.mean_speed, machine.samples.motor.rms_torque)
    sheet.print_columns = 18
    sheet.one_page = True


def drive_cycle_sheet(book: Book, machine: Cutting) -> None:
    """Declare the sheet of the drive over the cycle."""
    sheet = book.sheet("Drive cycle", "The drive over one turn of the master shaft, sample by sample.")
    with sheet.scoped(SCOPE):
        table(sheet, machine)
    sheet.print_columns, sheet.widths = 15, {FIRST: 14}


def entries(sheet: Sheet, machine: Cutting) -> None:
    """Declare what the engineer enters; the rotating parts follow in a table."""
    d = machine.machine.drive
    sheet.heading("Enter")
    sheet.rows(
        given("@axis", "Axis that the drive moves", "", "",
              d.axis, "drive.axis", choices="=axis_name", source="its phases and laws come from Timing"),
        given("@rate", "Production rate", "n", "pieces/min",
              d.rate, "drive.rate", format="0.0##", source="of this sheet alone; S1: 100"),
        given("@force", "Resisting force", "F_r", "N", d.force, "drive.force", format="0.0##", source=S1),
        given("@radius", "Radius of the rollers", "R", "m", d.radius, "drive.radius", source=S1),
        given("@resists", "The load resists", "", "",
              d.resists, "drive.resists", source="always, or only while moving and against the motion"),
        given("@jm", "Inertia of motor and reducer", "J_m", "kg m²",
              d.motor.inertia, "drive.motor.inertia", source="example value: S1 leaves motor and ratio open"),
        *limits_given(d.motor, "drive.motor"),
        given("@ratio", "Reduction of the reducer", "i", "",
              d.motor.reduction, "drive.motor.reduction", format="0.0##", source="example value; ω_m / ω_r"),
        given("@eta", "Efficiency of the reducer", "η", "",
              d.motor.efficiency, "drive.motor.efficiency", format="0.0##",
              source="example value; 1 for S1's equation as printed"),
    )  # fmt: skip


def inertia_table(sheet: Sheet, machine: Cutting) -> None:
    """Declare the rotating parts: count, inertia, teeth; what each weighs at the roller shaft."""
    rotors, n = machine.machine.drive.rotors, machine.machine.sizes.rotors

    def entered(name: str) -> list[Any]:
        return filled([getattr(r, name) for r in rotors], n, None)

    sheet.row += 1
    sheet.table(
        "rotors", f"Rotating parts ({S1}): leave the teeth empty for what turns with the rollers", n,
        given("name", "part", "", "", entered("name"), "drive.rotors.*.name"),
        constant("k", "number", "k", "", list(range(1, n + 1))),
        given("count", "count", "", "", entered("count"), "drive.rotors.*.count", format="0"),
        given("inertia", "inertia of one", "J", "kg m²",
              entered("inertia"), "drive.rotors.*.inertia", format="0.0000##"),
        given("driver", "teeth of the driver", "n1", "",
              entered("teeth_driver"), "drive.rotors.*.teeth_driver", format="0"),
        given("driven", "teeth of the driven", "n2", "",
              entered("teeth_driven"), "drive.rotors.*.teeth_driven", format="0"),
        calc("speed", "speed ratio", "ω_i/ω_1", "",
             "=IF(COUNT([driver],[driven])=2,[driver]/[driven],1)",
             filled([part.speed_ratio for part in machine.parts], n, 1.0), source="n1 / n2"),
        calc("reflected", "at the roller shaft", "J*", "kg m²",
             "=[count]*[inertia]*[speed]^2",
             filled([part.reflected for part in machine.parts], n), source="count · J · (ω_i/ω_1)²"),
        rules=[GEARED],
    )  # fmt: skip


def workings(sheet: Sheet, machine: Cutting) -> None:
    """Declare times, inertia and load at the roller shaft."""
    chain, names = machine.mechanism, [a.name for a in machine.machine.timing.axes]
    sheet.heading("Workings")
    sheet.rows(
        calc("@no", "Number of the axis on Timing", "", "",
             "=MATCH(@axis,axis_name,0)", place_of(machine.machine.drive.axis, names) + 1, format="0"),
        calc("@tc", "Time of one turn", "t_c", "s", "=60/@rate", machine.asked.time, source="60 / n"),
        calc("@omega", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()*@rate/60", machine.drive_speed, source="2π n / 60"),
        result("@jtot", "Inertia at the roller shaft", "J_tot", "kg m²",
               "=SUM([rotors.reflected])", chain.on_shaft(ROLLERS), source="Σ count · J · (ω_i/ω_1)²; S1: 4 J1 + 4 J2"),
        result("@cr", "Resisting torque", "C_r", "Nm",
               "=@force*@radius", float(chain.referred(machine.machine.drive.force, ROLLERS)), source="F_r R"),
        calc("@tau", "Transmission ratio", "τ", "", "=1/@ratio", chain.stages[0].transmission, source="ω_r / ω_m"),
        calc("@jeff", "Inertia felt by the motor, per ω̇_r", "", "kg m²",
             "=@jm/@tau+@tau*@jtot", machine.drive.effective_inertia(ROLLERS), source="J_m/τ + τ J_tot"),
        losses.standstill(),
        calc("@near", "Overhauling torque taken as resisting, up to", "R_0", "Nm",
             "=check_zero*MAX(1,MAX([drive.total]),0-MIN([drive.total]))", rounding_of(machine.samples.load),
             format="0E+00", source="rounding never decides the losses"),
    )  # fmt: skip


def outcome(sheet: Sheet, machine: Cutting) -> None:
    """Declare peaks and RMS, and the checks against the motor's limits."""
    points, asked, drive = machine.samples.motor, machine.asked, machine.drive
    tau = machine.mechanism.stages[0].transmission
    power = shown(max(points.highest_power, -points.lowest_power, 1e-3), KW)
    sheet.heading("Results")
    sheet.rows(
        result("@tmax", "Largest torque of the motor", "C_m,max", "Nm",
               "=MAX([drive.torque])", points.highest_torque, source="driving"),
        result("@tmin", "Lowest torque of the motor", "C_m,min", "Nm",
               "=MIN([drive.torque])", points.lowest_torque, source="braking", scale=points.peak_torque),
        result("@rms", "RMS torque of the motor", "C_m,rms", "Nm",
               ("=SQRT((2*SUMPRODUCT([drive.torque],[drive.torque])-[drive.torque.first]^2"
                "-[drive.torque.last]^2)/(2*[drive.k.last]))"), points.rms_torque,
               source="over the cycle, trapezoidal rule on the table"),
        calc("@rms1", "RMS torque without losses", "", "Nm",
             "=SQRT((@jeff*@wrms)^2+(@tau*@cr)^2*@share)",
             asked.rms_torque(drive.effective_inertia(ROLLERS), tau), source="exact, from C_a,rms; to compare"),
        calc("@wrms", "RMS acceleration of the rollers", "ω̇_r,rms", "rad/s²",
             "=@omega^2/@radius*SQRT(SUMPRODUCT([drive_phases.square],[drive_phases.share]))",
             asked.acceleration, source="exact, from C_a,rms"),
        calc("@share", "Share of the cycle in which the load resists", "", "",
             '=IF(@resists="always",1,SUM([drive_phases.moving]))',
             1.0 if machine.machine.drive.resists == "always" else asked.moving),
        result("@speed", "Largest speed of the motor", "n_m", "rpm",
               "=MAX(MAX([drive.rpm]),-MIN([drive.rpm]))", shown(points.max_speed, RPM), source=""),
        result("@mean", "Mean speed of the motor", "n_mean", "rpm",
               ("=(2*SUMPRODUCT([drive.rpm]*(([drive.rpm]>0)-([drive.rpm]<0)))-ABS([drive.rpm.first])"
                "-ABS([drive.rpm.last]))/(2*[drive.k.last])"), shown(points.mean_speed, RPM),
               source="of |n|, by the same rule; with C_m,rms the RMS point"),
        result("@pmax", "Largest power of the motor", "P_max", "kW",
               "=MAX([drive.power])", shown(points.highest_power, KW), source="C_m ω_m", scale=power),
        result("@pmin", "Lowest power of the motor", "P_min", "kW",
               "=MIN([drive.power])", shown(points.lowest_power, KW), source="negative: the load drives the motor",
               scale=power),
        result("@inertias", "Inertia ratio", "", "",
               "=IF(@jm>0,@jtot*@tau^2/@jm,0)", drive.inertia_ratio, source="load at the motor shaft / motor"),
    )  # fmt: skip
    sheet.checks(*limit_checks(machine.reserve, "Drive"))


def phases(sheet: Sheet, machine: Cutting) -> None:
    """Declare what each phase of the driven axis adds to the mean square."""
    n, asked = machine.machine.sizes.phases, machine.asked
    squares = [Move(phase).mean_square for phase in machine.driven.motion.phases]

    def chosen(column: str) -> str:
        return "CHOOSE(@no," + ",".join(f"INDEX([axis{i}.{column}],[k])" for i in (1, 2, 3)) + ")"

    still = f'{chosen("kind")}="dwell"' if machine.hands_over else f"{chosen('h')}=0"
    sheet.row += 1
    sheet.table(
        "drive_phases", "Phases of the driven axis", n,
        constant("k", "phase", "k", "", list(range(1, n + 1))),
        calc("square", "square of RMS y''", "", "m²/rad⁴",
             f"=({chosen('rms')}/timing_omega^2)^2", filled(squares, n), source="(C_a,rms h/δ²)²"),
        calc("share", "share of the cycle", "δ/2π", "", f"={chosen('span')}/(2*PI())", filled(asked.shares, n)),
        calc("moving", "share in motion", "", "", f"=IF({still},0,[share])", filled(asked.moving_shares, n)),
        blank="[share]=0",
    )  # fmt: skip


def table(sheet: Sheet, machine: Cutting) -> None:
    """Declare speeds, torques and power over the cycle."""
    x, n = machine.samples, len(machine.angles)

    def chosen(column: str) -> str:
        return "=CHOOSE(@no," + ",".join(f"INDEX([cycle.{column}{i}],[k]+1)" for i in (1, 2, 3)) + ")"

    sheet.table(
        "drive", "Speed, torque and power over the cycle", n,
        calc("theta", "master angle", "θ", "°", "=[k]*360/[drive.k.last]", machine.angles, format="0.0##"),
        calc("time", "time", "t", "s", "=[theta]/360*@tc", machine.times, source="θ t_c / 360"),
        result("rpm", "motor speed", "n_m", "rpm",
               "=[w]/@tau*60/(2*PI())", shown(x.motor.speed, RPM), source="ω_r/τ"),
        result("torque", "motor torque", "C_m", "Nm",
               "=@jm/@tau*[dw]+@tau*[total]*[loss]", x.motor.torque, source="(J_m/τ)ω̇_r + τ C*_r f"),
        result("power", "motor power", "P", "kW", "=[torque]*[w]/@tau/1000", shown(x.motor.power, KW),
               source="C_m ω_m"),
        calc("y1", "geometric velocity", "y'", "m/rad", chosen("g"), x.geometric.y1, source="from Timing"),
        calc("y2", "geometric acceleration", "y''", "m/rad²", chosen("gg"), x.geometric.y2, source="from Timing"),
        calc("w", "roller speed", "ω_r", "rad/s", "=[y1]*@omega/@radius", x.speed, source="v/R"),
        calc("dw", "roller acceleration", "ω̇_r", "rad/s²", "=[y2]*@omega^2/@radius", x.acceleration, source="a/R"),
        calc("dir", "direction", "", "", f"={losses.direction('[w]')}", x.direction, format="0"),
        calc("load", "resisting torque", "C_r", "Nm", '=IF(@resists="always",@cr,[dir]*@cr)', x.resisting),
        calc("total", "load torque", "C*_r", "Nm", "=[load]+@jtot*[dw]", x.load, source="C_r + J_tot ω̇_r"),
        calc("loss", "loss factor", "f", "",
             f"={losses.loss_factor('[total]', '[dir]', '@eta')}", x.loss, source="1/η driving, η braking"),
        constant("k", "sample", "k", "", list(range(n))),
    )  # fmt: skip


def draw(sheet: Sheet) -> None:
    """Place the speed–torque chart and the torque over the cycle beside the figures."""
    sheet.chart(plane("drive", "C_m"), column=11, row=5, width=8, height=22)
    over_time = tuple(Series(n, "[drive.theta]", f"[drive.{c}]") for n, c in (("motor torque C_m [Nm]", "torque"),))
    sheet.chart(
        Chart("Torque of the motor over the cycle", "master angle θ [°]", "motor torque C_m [Nm]", over_time,
              "Torque of the motor over one turn of the master shaft", (0, 360, 30)),
        column=11, row=28, width=8, height=16,
    )  # fmt: skip
    power = (Series("power", "[drive.theta]", "[drive.power]"),)
    sheet.chart(
        Chart("Power of the motor over the cycle", "master angle θ [°]", "power P [kW]", power,
              "Power of the motor over one turn of the master shaft", (0, 360, 30)),
        column=11, row=45, width=8, height=16,
    )  # fmt: skip
