"""The sheet Actuator: mechanism, load, motion and motor; inertia, torque in each part of the cycle, reserve."""

from __future__ import annotations

from typing import get_args

from engine.drivetrain import KINDS
from engine.drivetrain.loads import GRAVITY
from engine.drivetrain.motor import rated_torque_needed
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, check, constant, given, result
from workbook.drive import losses
from workbook.drive.motor import limit_checks, limits_given, plane
from workbook.drive.stages import gears_table, parts_table, stages_table
from workbook.entries.units import RPM, shown
from workbook.machines.actuator.entries import Kind
from workbook.machines.actuator.tables import AT, joints, motion
from workbook.machines.actuator.view import Sized
from workbook.motion.asked import ABOUT as CONTINUOUS
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import room_check
from workbook.motion.smooth import Joints

SCOPE = "act_"
CHART_ROWS = 16
"""of each of its three charts: all of them stand on the first printed page"""
BELOW_CHARTS = 66  # the row from which the sheet is free in its whole width


def actuator_sheet(book: Book, machine: Sized, rows: PieceRows) -> None:
    """Declare the sheet."""
    e, sizes, chain = machine.given, machine.sizes, machine.mechanism
    sheet = book.sheet("Actuator", "What a cycle of moves asks of the motor behind a mechanism.")
    with sheet.scoped(SCOPE):
        entries(sheet, machine)
        outcome(sheet, machine)
        reserve(sheet, machine)
        verdicts(sheet, machine, joints(machine, rows))
        draw(sheet)
        sheet.row = max(sheet.row, BELOW_CHARTS)
        sheet.heading("Enter, continued")
        motion(sheet, machine, rows)
        gears_table(sheet, e.gears, sizes.gears, "actuator.gears")
        parts_table(sheet, e.parts, machine.parts, chain, e.method, sizes.rotors, "actuator.parts")
        workings(sheet, machine)
        stages_table(sheet, chain, "INDEX([@mechanisms.element],@no)", "@wheel", "IF(@travels=1,@eta_out,1)")
        mechanisms(sheet)
    sheet.print_columns = 18


def entries(sheet: Sheet, machine: Sized) -> None:
    """Declare what the engineer enters; phases, gears and rotating parts follow in tables below."""
    e = machine.given
    out, load, motor = e.output, e.load, e.motor
    sheet.heading("Enter", "Phases of the motion, gears and rotating parts stand in the tables below the charts.")
    sheet.rows(
        given("@mechanism", "Mechanism", "", "",
              e.mechanism, "actuator.mechanism", source="entries that it does not use may stay as they are"),
        given("@turns", "Lead screw: turns per mm", "P", "rev/mm",
              out.turns, "actuator.output.turns", format="0.0##", source="S4: 0.5"),
        given("@diameter", "Roller, pinion, pulley: diameter", "D", "mm",
              out.diameter, "actuator.output.diameter", format="0.0##", source="S4's conveyor: 300"),
        given("@eta_out", "Efficiency of screw, roller, pinion, pulley", "η", "",
              out.efficiency, "actuator.output.efficiency", format="0.0##", source="S4's screw: 0.45"),
        given("@method", "Losses", "", "",
              e.method, "actuator.method", source="document: over η always (S4); physical: times η if driven"),
        given("@holding", "In a dwell the load is held by", "", "",
              e.holding, "actuator.holding", source="S4 counts no torque there, as with a brake"),
        given("@smooth", "Must be continuous", "", "", e.smoothness, "actuator.smoothness", source=CONTINUOUS),
        given("@mass", "Load that travels: mass of one", "m", "kg",
              load.mass, "actuator.load.mass", format="0.0##", source="S4: 6; conveyor 15"),
        given("@count", "how many", "n", "",
              load.count, "actuator.load.count", format="0", source="S4: 1; conveyor 10"),
        given("@belt", "Mass of the belt", "m_b", "kg",
              load.belt, "actuator.load.belt", format="0.0##",
              source="conveyor, belt; its weight balances itself; S4: 10"),
        given("@friction", "Coefficient of friction", "μ", "",
              load.friction, "actuator.load.friction", format="0.0##", source="S4: 0.1; conveyor 0"),
        given("@slope", "Slope", "θ", "°",
              load.slope, "actuator.load.slope", format="0.0##",
              source="rising with positive travel; S4: 10, conveyor 20"),
        given("@force", "Process force", "F", "N",
              load.force, "actuator.load.force", format="0.0##", source="against positive travel, always"),
        given("@inertia", "Load that turns: inertia", "J", "kg m²",
              load.inertia, "actuator.load.inertia", source="rotary table, gear train"),
        given("@torque", "Torque against positive motion", "T", "Nm",
              load.torque, "actuator.load.torque", format="0.0##", source="always, like a weight"),
        given("@rub", "Friction torque", "T_f", "Nm",
              load.friction_torque, "actuator.load.friction_torque", format="0.0##", source="opposes the motion"),
        given("@motor_j", "Motor: inertia", "J_m", "kg m²",
              motor.inertia, "actuator.motor.inertia", source="empty: by the ratio"),
        given("@motor_ratio", "inertia ratio machine : motor", "", "",
              motor.inertia_ratio, "actuator.motor.inertia_ratio", format="0.0##", source="S4: 4; conveyor 1"),
        *limits_given(motor, "actuator.motor"),
        given("@temp", "temperature of its surroundings", "ϑ", "°C",
              motor.temperature, "actuator.motor.temperature", format="0.0##", source="S4's conveyor: 35"),
        given("@temp_rated", "its rated torque holds at", "ϑ_N", "°C",
              motor.rated_at, "actuator.motor.rated_at", format="0.0##", source="S4: 25"),
        given("@temp_limit", "largest temperature of its winding", "ϑ_max", "°C",
              motor.limit, "actuator.motor.limit", format="0.0##",
              source="175 follows from S4: 0.147 Nm fall to 0.142 at 35 °C"),
    )  # fmt: skip


def outcome(sheet: Sheet, machine: Sized) -> None:
    """Declare inertia, torque and speed."""
    m, s, sides, drive = machine.mechanism, machine.sizing, machine.sides, machine.drive
    inertia, torques = m.inertia(drive.method), [torque for row in machine.part_torques for torque in row]
    sheet.heading("Results", "The document's own figures beside these, and its misprints: sheet S4.")
    sheet.rows(
        result("@jmach", "Inertia of the machine at the motor", "J_machine", "kg m²",
               "=SUM([@parts.at_motor])+@jload+@jbelt", inertia, source="by S4's way of losses: over η"),
        result("@jm", "Inertia of the motor", "J_m", "kg m²",
               '=IF(@motor_j="",@jmach/@motor_ratio,@motor_j)', machine.motor_inertia, scale=inertia,
               source="entered, or J_machine / ratio"),
        result("@jtotal", "Inertia in all", "J_T", "kg m²", "=@jm+@jmach", drive.total_inertia),
        result("@ratio", "Inertia ratio machine : motor", "", "", "=IF(@jm>0,@jmach/@jm,0)", drive.inertia_ratio),
        result("@tf", "Friction at the motor", "T_f", "Nm",
               "=@rubbing/@i/@eta", m.driving(m.load.friction), scale=sides.torque, source="over η, as when driving"),
        result("@tl", "Weight and force at the motor", "T_l", "Nm",
               "=@steady/@i/@eta", m.driving(m.load.torque), scale=sides.torque, source="over η, as when driving"),
        result("@tr", "Both, moving forward", "T_R", "Nm",
               "=@tf+@tl", m.driving(float(m.load.resisting(1.0))), scale=sides.torque),
        result("@vmax", "Largest speed of the load", "v", "m/s or rad/s",
               "=MAX([phases.v])", s.load_speed, scale=sides.speed),
        result("@wmax", "Largest speed of the motor", "ω_m", "rad/s",
               "=@i*@vmax", s.max_speed, scale=sides.motor_speed),
        result("@speed", "the same in rpm", "n_m", "rpm",
               "=@wmax*60/(2*PI())", shown(s.max_speed, RPM), scale=shown(sides.motor_speed, RPM)),
        result("@mean", "Mean speed of the motor", "n_mean", "rpm",
               "=@i*SUM([phases.way])/@time*60/(2*PI())",
               shown(s.mean_speed, RPM), scale=shown(sides.motor_speed, RPM),
               source="of |n| over the cycle; with T_RMS the RMS point"),
        result("@alpha", "Largest acceleration of the motor", "ω̇_m", "rad/s²",
               "=@i*MAX([phases.amax])", s.max_acceleration, scale=sides.motor_acceleration),
        result("@tmax", "Highest torque of the motor", "", "Nm",
               "=MAX([extremes.torque])", max(torques), scale=sides.torque),
        result("@tmin", "Lowest torque of the motor", "", "Nm",
               "=MIN([extremes.torque])", min(torques), scale=sides.torque),
        result("@peak", "Peak torque", "T_max", "Nm", "=MAX(@tmax,0-@tmin)", s.peak_torque, scale=sides.torque),
        result("@rms", "RMS torque over the cycle", "T_RMS", "Nm",
               ("=SQRT(MAX(0,SUM([turns.square])+2*@jm*@i*SUM([turns.product])+(@jm*@i)^2"
                "*SUM([turns.grown]))/@time)"), machine.rms_torque, scale=sides.torque,
               source="exact, not from samples: sheet RMS"),
    )  # fmt: skip


def reserve(sheet: Sheet, machine: Sized) -> None:
    """Declare what the motor's limits leave."""
    found = machine.reserve
    sheet.rows(
        result("@derate", "Derating with temperature", "", "",
               "=MIN(1,SQRT((@temp_limit-@temp)/(@temp_limit-@temp_rated)))", machine.derating,
               source="√((ϑ_max − ϑ)/(ϑ_max − ϑ_N))"),
        result("@rated_left", "Continuous torque that is left", "T_N,ϑ", "Nm",
               "=@motor_rated*@derate", machine.motor.rated_torque),
        result("@needed", "Rated torque that the motor must have", "", "Nm",
               "=IF(@derate>0,@rms/@derate,0)", rated_torque_needed(machine.rms_torque, machine.derating),
               scale=machine.sides.torque, source="T_RMS over the derating"),
        result("@res_rms", "Reserve: continuous over RMS torque", "", "",
               "=IF(@rms>0,@rated_left/@rms,0)", found.rms_torque.reserve,
               source="1 or more; 0 where none is asked for"),
        result("@res_peak", "Reserve: peak torque", "", "",
               "=IF(@peak>0,@motor_peak/@peak,0)", found.peak_torque.reserve),
        result("@res_speed", "Reserve: speed", "", "",
               "=IF(@speed>0,@motor_nmax/@speed,0)", found.speed.reserve),
    )  # fmt: skip


SHAFTS = (
    '"row "&MATCH(MAX([@parts.on]),[@parts.on],0)&": behind "&ROUND(MAX([@parts.on]),9)&" gears, of "'
    "&COUNT([@gears.ratio])"
)
BACK = '"a law moves backwards: see its sheet, or Laws"'
HOT = 'ROUND(MAX(@temp,@temp_rated),9)&" °C; expected less than the limit, "&ROUND(@temp_limit,9)&" °C"'
SIZE = "IF(@no=1,@turns,@diameter)"


def verdicts(sheet: Sheet, machine: Sized, found: Joints) -> None:
    """Declare the checks."""
    rises = "MIN([phases.low])>=0-check_zero"
    cool = "AND(@temp<@temp_limit,@temp_rated<@temp_limit)"
    sheet.checks(
        *limit_checks(machine.reserve, "", "@rated_left", "continuous torque", "derated by the temperature"),
        room_check("@ok_pieces", AT),
        found.check("@ok_smooth", "The motion is as smooth as asked"),
        check("@ok_rises", "The laws never move backwards", rises, True,
              "an own law may not, or driving and braking mix", ":rises", BACK),
        check("@ok_shafts", "Every part turns behind a gear that is there",
              "MAX([@parts.on])<=COUNT([@gears.ratio])", True, "", "actuator:shafts", SHAFTS),
        check("@ok_temp", "The motor is cooler than its limit", cool, True, "", "actuator.motor:cool", HOT),
        check("@ok_inertia", "The motor's inertia is known", "COUNT(@motor_j,@motor_ratio)>0", True, "",
              "actuator.motor:inertia", '"neither the motor\'s inertia nor a ratio is entered"'),
        check("@ok_size", "The last element has its size", f"OR(@travels=0,ISNUMBER({SIZE}))", True, "",
              ":size", '"a "&@mechanism&" has no "&IF(@no=1,"turns per mm","diameter")'),
    )  # fmt: skip


def workings(sheet: Sheet, machine: Sized) -> None:
    """Declare the load, and what the mechanism makes of it."""
    m, moved, method, sides = machine.mechanism, machine.load, machine.drive.method, machine.sides
    base = "m" if machine.kind.travels else "rad"
    sheet.not_printed_below()
    sheet.heading("Workings: the load")
    sheet.rows(
        constant("@g", "Gravity", "g", "m/s²", GRAVITY, source="S4's torques were worked out with 9.8"),
        calc("@no", "Number of the mechanism", "", "",
             "=MATCH(@mechanism,[@mechanisms.name],0)", get_args(Kind).index(machine.kind.name) + 1, format="0"),
        calc("@travels", "Its load travels (1) or turns (0)", "", "",
             "=INDEX([@mechanisms.travels],@no)", int(machine.kind.travels), format="0"),
        calc("@unit", "A unit of lift in m or rad", "", "",
             "=IF(@travels=1,1/1000,RADIANS(1))", machine.unit, source="mm, or degrees"),
        calc("@title_v", "Speed, with its unit", "", "",
             '="speed v ["&IF(@travels=1,"m/s","rad/s")&"]"', f"speed v [{base}/s]", align="center"),
        calc("@wheel", "Ratio of the last element", "", "rad/m or 1",
             "=IF(@travels=0,1,IF(@no=1,2*PI()*@turns*1000,2/(@diameter/1000)))", m.stages[-1].ratio,
             source="2πP; 2/D; 1"),
        calc("@m", "Mass in all", "m", "kg", '=@mass*IF(@count="",1,@count)', machine.mass),
        calc("@load", "What is moved", "", "kg or kg m²", "=IF(@travels=1,@m,@inertia)", moved.inertia),
        calc("@moved_belt", "and the belt", "", "kg", "=IF(INDEX([@mechanisms.belt],@no)=1,@belt,0)+0", machine.belt),
        calc("@steady", "What resists always", "", "N or Nm",
             "=IF(@travels=1,@force+@m*@g*SIN(RADIANS(@slope)),@torque)", moved.torque, scale=sides.force,
             source="F + m g sin θ; T"),
        calc("@rubbing", "What opposes the motion", "", "N or Nm",
             "=IF(@travels=1,@friction*@m*@g*ABS(COS(RADIANS(@slope))),@rub)+0", moved.friction, scale=sides.force,
             source="μ m g cos θ; T_f"),
        calc("@hold", "What the motor holds in a dwell", "", "N or Nm",
             '=IF(@holding="brake",0,@steady)', float(machine.drive.resisting(0.0)), scale=sides.force),
        calc("@i", "Ratio of motor to load", "i", "rad/m or 1", "=[@stages.to.last]", m.ratio),
        calc("@eta", "Efficiency in all", "η", "", "=[@stages.eta_to.last]", m.efficiency),
        calc("@over", "Losses on inertia", "", "",
             '=IF(@method="document",@eta,1)', m.efficiency if method == "document" else 1.0,
             source="η as S4 has it; 1 physically"),
        calc("@jload", "Inertia of the load at the motor", "J_load", "kg m²",
             "=@load/@i^2/@over", m.at_motor(moved.inertia, m.last, method), source="m/(η i²)"),
        calc("@jbelt", "Inertia of the belt at the motor", "J_conv", "kg m²",
             "=@moved_belt/@i^2/@over", m.at_motor(machine.belt, m.last, method), source="m_b/(η i²)"),
        calc("@j0", "Inertia on the motor's shaft, without it", "J_0", "kg m²",
             "=SUMPRODUCT(([@parts.on]=0)*[@parts.total])", m.on_shaft(0)),
        calc("@time", "Time of the cycle", "t_c", "s", "=SUM([phases.span])", machine.sizing.motion.total),
        losses.nearly(),
    )  # fmt: skip


def mechanisms(sheet: Sheet) -> None:
    """Declare the mechanisms that can be chosen."""
    kinds = [KINDS[name] for name in get_args(Kind)]
    sheet.table(
        "@mechanisms", "Mechanisms", len(kinds),
        constant("name", "mechanism", "", "", [kind.name for kind in kinds], align="left"),
        constant("element", "last element", "", "", [kind.element for kind in kinds]),
        constant("travels", "load travels", "", "", [int(kind.travels) for kind in kinds]),
        constant("belt", "a belt moves with it", "", "", [int(kind.belt) for kind in kinds]),
    )  # fmt: skip


def draw(sheet: Sheet) -> None:
    """Place the charts beside the figures."""
    torque = (
        Series("motor torque", "[cycle.time]", "[cycle.torque]"),
        Series("RMS torque", "[@limits.time]", "[@limits.rms]", dashed=True),
        Series("continuous torque of the motor", "[@limits.time]", "[@limits.rated]", dashed=True),
    )
    speed = (Series("speed", "[cycle.time]", "[cycle.vel]"),)
    for row, chart in (
        (5, Chart("Torque of the motor over time", "time t [s]", "motor torque T_m [Nm]", torque,
                  "Torque of the motor over one cycle, with its RMS value and the motor's continuous torque")),
        (5 + CHART_ROWS, plane("cycle", "T_m", "continuous torque")),
        (5 + CHART_ROWS + CHART_ROWS, Chart("Speed of the load over time", "time t [s]", f"={SCOPE}title_v", speed,
                   "Speed of the load over one cycle")),
    ):  # fmt: skip
        sheet.chart(chart, column=11, row=row, width=8, height=CHART_ROWS - 1)
