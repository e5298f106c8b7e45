"""The sheet Actuator: mechanism, load, motion and motor; inertia, torque in each part of the cycle, reserve."""

from __future__ import annotations

from math import pi

from engine.mechanism import GRAVITY
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, check, constant, given, result
from workbook.entries.units import MM, RPM
from workbook.machines.actuator.entries import KINDS
from workbook.machines.actuator.flow import Sized
from workbook.machines.actuator.tables import gears, motion, parts, stages

BELOW_CHARTS = 66  # the row from which the sheet is free in its whole width


def actuator_sheet(book: Book, machine: Sized) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Actuator", "What a cycle of moves asks of the motor behind a mechanism.")
    entries(sheet, machine)
    outcome(sheet, machine)
    verdicts(sheet, machine)
    draw(sheet)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    sheet.heading("What to enter, continued")
    motion(sheet, machine)
    gears(sheet, machine)
    parts(sheet, machine)
    workings(sheet, machine)
    stages(sheet, machine)
    mechanisms(sheet)
    sheet.print_columns = 18


def entries(sheet: Sheet, machine: Sized) -> None:
    """Declare what the engineer enters; phases, gears and rotating parts follow in tables below."""
    e = machine.given
    out, load, motor = e.output, e.load, e.motor
    sheet.heading(
        "What to enter", "Phases of the motion, gears and rotating parts stand in the tables below the charts."
    )
    sheet.rows(
        given("act_mechanism", "Mechanism", "", "",
              e.mechanism, "actuator.mechanism", source="entries that it does not use may stay as they are"),
        given("act_turns", "Lead screw: turns per mm", "P", "rev/mm",
              out.turns, "actuator.output.turns", format="0.0##", source="S4: 0.5"),
        given("act_diameter", "Roller, pinion, pulley: diameter", "D", "mm",
              out.diameter, "actuator.output.diameter", format="0.0##", source="S4's conveyor: 300"),
        given("act_eta_out", "Efficiency of screw, roller, pinion, pulley", "η", "",
              out.efficiency, "actuator.output.efficiency", format="0.0##", source="S4's screw: 0.45"),
        given("act_method", "Losses", "", "",
              e.method, "actuator.method", source="document: over η always (S4); physical: times η if driven"),
        given("act_holding", "In a dwell the load is held by", "", "",
              e.holding, "actuator.holding", source="S4 counts no torque there, as with a brake"),
        given("act_mass", "Load that travels: mass of one", "m", "kg",
              load.mass, "actuator.load.mass", format="0.0##", source="S4: 6; conveyor 15"),
        given("act_count", "how many", "n", "",
              load.count, "actuator.load.count", format="0", source="S4: 1; conveyor 10"),
        given("act_belt", "Mass of the belt", "m_b", "kg",
              load.belt, "actuator.load.belt", format="0.0##",
              source="conveyor, belt; its weight balances itself; S4: 10"),
        given("act_friction", "Coefficient of friction", "μ", "",
              load.friction, "actuator.load.friction", format="0.0##", source="S4: 0.1; conveyor 0"),
        given("act_slope", "Slope", "θ", "°",
              load.slope, "actuator.load.slope", format="0.0##",
              source="rising with positive travel; S4: 10, conveyor 20"),
        given("act_force", "Process force", "F", "N",
              load.force, "actuator.load.force", format="0.0##", source="against positive travel, always"),
        given("act_inertia", "Load that turns: inertia", "J", "kg m²",
              load.inertia, "actuator.load.inertia", source="rotary table, gear train"),
        given("act_torque", "Torque against positive motion", "T", "Nm",
              load.torque, "actuator.load.torque", format="0.0##", source="always, like a weight"),
        given("act_rub", "Friction torque", "T_f", "Nm",
              load.friction_torque, "actuator.load.friction_torque", format="0.0##", source="opposes the motion"),
        given("act_motor_j", "Motor: inertia", "J_m", "kg m²",
              motor.inertia, "actuator.motor.inertia", source="empty: by the ratio"),
        given("act_motor_ratio", "inertia ratio machine : motor", "", "",
              motor.inertia_ratio, "actuator.motor.inertia_ratio", format="0.0##", source="S4: 4; conveyor 1"),
        given("act_motor_rated", "rated torque", "T_N", "Nm",
              motor.rated_torque, "actuator.motor.rated_torque", source="ours: S4 leaves the motor open"),
        given("act_motor_peak", "peak torque", "T_max", "Nm",
              motor.peak_torque, "actuator.motor.peak_torque", source="ours"),
        given("act_motor_nmax", "largest speed", "n_max", "rpm",
              motor.max_speed, "actuator.motor.max_speed", format="0.0##", source="ours"),
        given("act_temp", "temperature of its surroundings", "ϑ", "°C",
              motor.temperature, "actuator.motor.temperature", format="0.0##", source="S4's conveyor: 35"),
        given("act_temp_rated", "its rated torque holds at", "ϑ_N", "°C",
              motor.rated_at, "actuator.motor.rated_at", format="0.0##", source="S4: 25"),
        given("act_temp_limit", "largest temperature of its winding", "ϑ_max", "°C",
              motor.limit, "actuator.motor.limit", format="0.0##",
              source="175 follows from S4: 0.147 Nm fall to 0.142 at 35 °C"),
    )  # fmt: skip


def outcome(sheet: Sheet, machine: Sized) -> None:
    """Declare inertia, speed, torque and reserve."""
    m, s, motor = machine.mechanism, machine.sizing, machine.given.motor
    inertia = m.inertia(losses=machine.documented)
    per = 1 / m.ratio / m.efficiency
    rms, peak, speed = machine.rms_torque, s.peak_torque, s.max_speed
    left = motor.rated_torque * machine.derating
    torque, forwards = machine.torque_scale, m.steady + m.rubbing
    sheet.heading("What comes out", "The document's own figures beside these, and its misprints: sheet S4.")
    sheet.rows(
        result("act_jmach", "Inertia of the machine at the motor", "J_machine", "kg m²",
               "=SUM([parts.at_motor])+act_jload+act_jbelt", inertia, source="by S4's way of losses: over η"),
        result("act_jm", "Inertia of the motor", "J_m", "kg m²",
               '=IF(act_motor_j="",act_jmach/act_motor_ratio,act_motor_j)', machine.motor_inertia, scale=inertia,
               source="entered, or J_machine / ratio"),
        result("act_jtotal", "Inertia in all", "J_T", "kg m²", "=act_jm+act_jmach", s.total_inertia),
        result("act_ratio", "Inertia ratio machine : motor", "", "",
               "=IF(act_jm>0,act_jmach/act_jm,0)", inertia / machine.motor_inertia if machine.motor_inertia else 0.0),
        result("act_tf", "Friction at the motor", "T_f", "Nm",
               "=act_rubbing/act_i/act_eta", m.rubbing * per, scale=torque, source="over η, as when driving"),
        result("act_tl", "Weight and force at the motor", "T_l", "Nm",
               "=act_steady/act_i/act_eta", m.steady * per, scale=torque, source="over η, as when driving"),
        result("act_tr", "Both, moving forward", "T_R", "Nm", "=act_tf+act_tl", forwards * per, scale=torque),
        result("act_vmax", "Largest speed of the load", "v", "m/s or rad/s",
               "=MAX([phases.v])", speed / m.ratio, scale=machine.speed_scale),
        result("act_wmax", "Largest speed of the motor", "ω_m", "rad/s",
               "=act_i*act_vmax", speed, scale=machine.speed_scale * m.ratio),
        result("act_nmax", "the same in rpm", "n_m", "rpm",
               "=act_wmax*60/(2*PI())", speed / RPM, scale=machine.speed_scale * m.ratio / RPM),
        result("act_alpha", "Largest acceleration of the motor", "ω̇_m", "rad/s²",
               "=act_i*MAX([phases.amax])", s.max_acceleration, scale=machine.acceleration_scale * m.ratio),
        result("act_thigh", "Highest torque of the motor", "", "Nm",
               "=MAX([extremes.torque])", max(machine.part_torques), scale=torque),
        result("act_tlow", "Lowest torque of the motor", "", "Nm",
               "=MIN([extremes.torque])", min(machine.part_torques), scale=torque),
        result("act_peak", "Peak torque", "T_max", "Nm", "=MAX(act_thigh,0-act_tlow)", peak, scale=torque),
        result("act_rms", "RMS torque over the cycle", "T_RMS", "Nm",
               ("=SQRT(MAX(0,SUM([turns.square])+2*act_jm*act_i*SUM([turns.product])+(act_jm*act_i)^2"
                "*SUM([turns.grown]))/act_time)"), rms, scale=torque, source="exact, not from samples: sheet RMS"),
        result("act_derate", "Derating with temperature", "", "",
               "=MIN(1,SQRT((act_temp_limit-act_temp)/(act_temp_limit-act_temp_rated)))", machine.derating,
               source="√((ϑ_max − ϑ)/(ϑ_max − ϑ_N))"),
        result("act_rated_left", "Continuous torque that is left", "T_N,ϑ", "Nm", "=act_motor_rated*act_derate", left),
        result("act_needed", "Rated torque that the motor must have", "", "Nm",
               "=IF(act_derate>0,act_rms/act_derate,0)", rms / machine.derating if machine.derating else 0.0,
               scale=torque, source="T_RMS over the derating"),
        result("act_res_rms", "Reserve: continuous over RMS torque", "", "",
               "=IF(act_rms>0,act_rated_left/act_rms,0)", left / rms if rms else 0.0,
               source="1 or more; 0 where none is asked for"),
        result("act_res_peak", "Reserve: peak torque", "", "",
               "=IF(act_peak>0,act_motor_peak/act_peak,0)", motor.peak_torque / peak if peak else 0.0),
        result("act_res_speed", "Reserve: speed", "", "",
               "=IF(act_nmax>0,act_motor_nmax/act_nmax,0)", machine.motor_speed / speed if speed else 0.0),
    )  # fmt: skip


def verdicts(sheet: Sheet, machine: Sized) -> None:
    """Declare the checks."""
    reserve = machine.reserve
    rises = "OR(COUNTIF([phases.no],OWN_no)=0,MIN([own_samples.v])>=0-check_zero)"
    cool = "AND(act_temp<act_temp_limit,act_temp_rated<act_temp_limit)"
    sheet.checks(
        check("act_ok_rms", "RMS torque within the continuous torque", "act_rms<=act_rated_left", reserve["RMS torque"],
              "derated by the temperature"),
        check("act_ok_peak", "Peak torque within the motor's", "act_peak<=act_motor_peak", reserve["peak torque"]),
        check("act_ok_speed", "Speed within the motor's", "act_nmax<=act_motor_nmax", reserve["speed"]),
        check("act_ok_rows", "Every phase lasts", 'COUNTIF([phases.span],">0")=COUNT([phases.duration])', True),
        check("act_ok_rises", "The laws never move backwards", rises, True,
              "an own law may not, or driving and braking mix"),
        check("act_ok_shafts", "Every part turns behind a gear that is there", "MAX([parts.on])<=COUNT([gears.ratio])",
              True),
        check("act_ok_temp", "The motor is cooler than its limit", cool, True),
    )  # fmt: skip


def workings(sheet: Sheet, machine: Sized) -> None:
    """Declare the load, and what the mechanism makes of it."""
    m, load = machine.mechanism, machine.given.load
    number = list(KINDS).index(machine.given.mechanism) + 1
    base = "m" if machine.travels else "rad"
    last, documented = len(m.stages), machine.documented
    reflected = {p.name: m.reflected(p, documented) for p in m.parts if p.shaft == last}
    moved = machine.slide.mass if machine.travels else load.inertia
    belt = load.belt if machine.has_belt else 0.0
    sheet.heading("Workings: the load")
    sheet.rows(
        constant("act_g", "Gravity", "g", "m/s²", GRAVITY, source="S4's torques were worked out with 9.8"),
        calc("act_no", "Number of the mechanism", "", "",
             "=MATCH(act_mechanism,[mechanisms.name],0)", number, format="0"),
        calc("act_travels", "Its load travels (1) or turns (0)", "", "",
             "=INDEX([mechanisms.travels],act_no)", int(machine.travels), format="0"),
        calc("act_unit", "A unit of lift in m or rad", "", "",
             "=IF(act_travels=1,1/1000,RADIANS(1))", MM if machine.travels else pi / 180, source="mm, or degrees"),
        calc("act_title_v", "Speed, with its unit", "", "",
             '="speed v ["&IF(act_travels=1,"m/s","rad/s")&"]"', f"speed v [{base}/s]", align="center"),
        calc("act_wheel", "Ratio of the last element", "", "rad/m or 1",
             '=IF(act_travels=0,1,IF(act_no=1,2*PI()*act_turns*1000,2/(act_diameter/1000)))', machine.wheel,
             source="2πP; 2/D; 1"),
        calc("act_m", "Mass in all", "m", "kg", '=act_mass*IF(act_count="",1,act_count)', machine.slide.mass),
        calc("act_load", "What is moved", "", "kg or kg m²", "=IF(act_travels=1,act_m,act_inertia)", moved),
        calc("act_moved_belt", "and the belt", "", "kg", "=IF(INDEX([mechanisms.belt],act_no)=1,act_belt,0)+0", belt),
        calc("act_steady", "What resists always", "", "N or Nm",
             "=IF(act_travels=1,act_force+act_m*act_g*SIN(RADIANS(act_slope)),act_torque)", m.steady,
             scale=machine.force_scale, source="F + m g sin θ; T"),
        calc("act_rubbing", "What opposes the motion", "", "N or Nm",
             "=IF(act_travels=1,act_friction*act_m*act_g*ABS(COS(RADIANS(act_slope))),act_rub)+0", m.rubbing,
             scale=machine.force_scale, source="μ m g cos θ; T_f"),
        calc("act_hold", "What the motor holds in a dwell", "", "N or Nm",
             '=IF(act_holding="brake",0,act_steady)', machine.hold, scale=machine.force_scale),
        calc("act_i", "Ratio of motor to load", "i", "rad/m or 1", "=[stages.to.last]", m.ratio),
        calc("act_eta", "Efficiency in all", "η", "", "=[stages.eta_to.last]", m.efficiency),
        calc("act_over", "Losses on inertia", "", "",
             '=IF(act_method="document",act_eta,1)', m.efficiency if documented else 1.0,
             source="η as S4 has it; 1 physically"),
        calc("act_jload", "Inertia of the load at the motor", "J_load", "kg m²",
             "=act_load/act_i^2/act_over", reflected["load"], source="m/(η i²)"),
        calc("act_jbelt", "Inertia of the belt at the motor", "J_conv", "kg m²",
             "=act_moved_belt/act_i^2/act_over", reflected.get("belt", 0.0), source="m_b/(η i²)"),
        calc("act_j0", "Inertia on the motor's shaft, without it", "J_0", "kg m²",
             "=SUMPRODUCT(([parts.on]=0)*[parts.total])", m.on_shaft(0)),
        calc("act_time", "Time of the cycle", "t_c", "s", "=SUM([phases.span])", machine.sizing.motion.total),
    )  # fmt: skip


def mechanisms(sheet: Sheet) -> None:
    """Declare the mechanisms that can be chosen."""
    elements, travels, belts = zip(*KINDS.values(), strict=True)
    sheet.table(
        "mechanisms", "Mechanisms", len(KINDS),
        constant("name", "mechanism", "", "", list(KINDS), align="left"),
        constant("element", "last element", "", "", list(elements)),
        constant("travels", "load travels", "", "", [int(x) for x in travels]),
        constant("belt", "a belt moves with it", "", "", [int(x) for x in belts]),
    )  # fmt: skip


def draw(sheet: Sheet) -> None:
    """Place the charts beside the figures."""

    def line(name: str, x: str, y: str, dashed: bool = False) -> Series:
        return Series(name, f"[{x}]", f"[{y}]", dashed=dashed)

    torque = (
        line("motor torque", "cycle.time", "cycle.torque"),
        line("RMS torque", "limits.time", "limits.rms", True),
        line("continuous torque of the motor", "limits.time", "limits.rated", True),
    )
    plane = (
        line("operating points", "cycle.rpm", "cycle.torque"),
        line("peak torque and speed of the motor", "limits.rpm", "limits.peak", True),
        line("continuous torque", "limits.rpm", "limits.rated", True),
    )
    for row, chart in (
        (5, Chart("Torque of the motor over time", "time t [s]", "motor torque T_m [Nm]", torque,
                  "Torque of the motor over one cycle, with its RMS value and the motor's continuous torque")),
        (25, Chart("Torque against speed of the motor", "motor speed n_m [rpm]", "motor torque T_m [Nm]", plane,
                   "Operating points of the motor over one cycle in the speed–torque plane, with the motor's limits")),
        (45, Chart("Speed of the load over time", "time t [s]", "=act_title_v",
                   (line("speed", "cycle.time", "cycle.vel"),), "Speed of the load over one cycle")),
    ):  # fmt: skip
        sheet.chart(chart, column=11, row=row, width=8, height=19)
