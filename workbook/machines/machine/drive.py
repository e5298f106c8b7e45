"""The sheet Drive of one axis: mechanism, load, motor; torque and speed over the cycle, exact by the laws."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from engine.drivetrain.loads import GRAVITY
from engine.drivetrain.losses import loss_factor
from engine.machine.stationary import PLACES
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import total
from workbook.book.sentence import NOTHING, Said, exceeding
from workbook.drive.motor import limit_checks, plane, rms_point
from workbook.entries.titles import sheet_title
from workbook.entries.units import KG_CM2, KW, RPM, shown
from workbook.machines.machine import chosen, curved
from workbook.machines.machine.breaks import ACTS, breaks_table, turns_table, windows_check, windows_table
from workbook.machines.machine.chain import BELTED, TABLE
from workbook.machines.machine.driven import SCREW, Driven
from workbook.machines.machine.lines import lines
from workbook.machines.machine.loads import loads
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.pacing import highest, mending, pace_columns, pace_tables
from workbook.machines.machine.parts import parts_table
from workbook.machines.machine.powered import PEAKS, power_columns, power_peaks, power_rows
from workbook.machines.machine.selecting import behind
from workbook.machines.machine.stretched import Stretched
from workbook.machines.machine.stretches import stretches_table
from workbook.machines.machine.view import kind_name

CHART_COLUMN = 10
SIZES = {
    "lead screw": ("Lead of the screw", "P"),
    "conveyor": ("Diameter of the roller", "D"),
    "rack and pinion": ("Pitch diameter of the pinion", "D"),
    "belt": ("Pitch diameter of the pulley", "D"),
    "feed rollers": ("Radius of the rollers", "R"),
}
RATIOS = {"lead screw": "=2*PI()/(@size/1000)", "feed rollers": "=1/(@size/1000)"}
STRAIGHT = {
    "jtot": "=(@j0-@jm+@j1/@i1^2+@m/@i^2)*10000",
    "tmax": "=MAX(MAX([@st.tyb]),MAX([@st.tye]))",
    "tmin": "=MIN(MIN([@st.tyb]),MIN([@st.tye]))",
    "rms": f"=SQRT(MAX(0,{total('@st.square')}/(2*PI())))",
    "speed": "=ABS(@i)*MAX([axis{0}.v])*@faster*60/(2*PI())",
    "mean": "=ABS(@i)*@way*@faster/timing_cycle*60/(2*PI())",
    "smax": "=MAX(MAX(MAX([@st.ryb]),MAX([@st.rye])),0-MIN(MIN([@st.ryb]),MIN([@st.rye])))",
    "smean": f"=IF(@way>0,({total('@st.cube')}/@way)^(1/3),0)",
    "energy": f"={total('@st.drives')}",
    "returned": f"={total('@st.returns')}",
}
"""the results of a drive of constant ratios, by its stretches"""
BACKWARD = "MIN([@st.dir])<0"
"""whether the motor turns backward too"""
MACHINES, OWN = "the machine's rate", "a rate of its own"
UNSHAPED = (
    "a phase has a law whose pieces are neither a polynomial nor sines alone, or that turns back between its rests, or "
    "turns round too often"
)


def drive_sheet(book: Book, view: Stretched) -> None:
    """Declare the sheet."""
    one, driven = view.one, view.driven
    i, line = driven.number, curved.line_of(view)
    sheet = begun(book, driven)
    with sheet.scoped(f"drive{i}_"):
        entries(sheet, driven, size(driven))
        outcome(sheet, one, driven, STRAIGHT, [*curved.spare(view, line), *power_peaks(view, PEAKS), *highest(view)])
        sheet.checks(
            *checks(driven, mending(view)), curved.curve_check(view, line, mending(view)), laws_check(driven, one),
            *windows_check(view),
        )  # fmt: skip
        sheet.chart(plane("@cycle", "T"), column=CHART_COLUMN, row=5, width=8, height=22)
        tables(sheet, view)
        sheet.not_printed_below()
        sheet.heading("Motor and reducer in use")
        sheet.rows(*chosen.in_use(driven.motor_used, driven.reducer, driven.left))
        workings(sheet, one, driven, ratios(driven), way_of(view))
        cycle(sheet, view)
        lines(sheet, driven)
        turns_table(sheet, view)
        breaks_table(sheet, view)
        sheet.row += 1
        sheet.rows(*power_rows(view), *curved.curve_rows(view, line))
        stretches_table(sheet, view, *power_columns(view), *pace_columns(view), *behind.columns(view))
        pace_tables(sheet, view)
        behind.means(sheet, view)
        curved.corners_table(sheet, view, BACKWARD)
        rms_point(sheet, driven.demand.mean_speed, driven.demand.rms_torque)
    sheet.print_columns = 18


def begun(book: Book, driven: Driven) -> Sheet:
    """Return the sheet, called by the name that the axis had when the book was built."""
    title = sheet_title(driven.called, [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"The drive of axis {driven.number}: what its motion asks of the motor.")
    sheet.called = driven.called
    return sheet


def size(driven: Driven) -> list[Quantity]:
    """Return the row of the mechanism's size, if it has one."""
    m, key = driven.given, f"axes.{driven.number - 1}.mechanism"
    label, symbol = SIZES.get(m.kind, ("", ""))
    rows = [given("@size", label, symbol, "mm", m.size, f"{key}.size", format="0.0##")] if label else []
    if m.kind in BELTED:
        rows.append(given("@belt_mass", "Mass of the belt", "m_b", "kg", m.belt, f"{key}.belt", format="0.0##",
                          source="moves with the load; its own weight balances itself"))  # fmt: skip
    return rows


def entries(sheet: Sheet, driven: Driven, size: list[Quantity]) -> None:
    """Declare what is entered of this mechanism, its load, reducer and motor.

    They are watched by two checks: the sentence of one would be too long for a cell.
    """
    m, key = driven.given, f"axes.{driven.number - 1}"
    sheet.heading("Enter")
    sheet.rows(
        calc("@axis", "Axis", "", "", f"=[axes.name.{driven.number}]", driven.entered.name, align="left",
             source="its sheet keeps the name that it was built with"),
        constant(kind_name(driven.number, m.kind), "Mechanism", "", "", m.kind, align="left"),
        given("@own_rate", "Rate that it is sized at, if not the machine's", "n", "cycles/min", driven.entered.rate,
              f"{key}.rate", format="0.0##", source="empty: the machine's"),
        *size,
        given("@eta2", "Efficiency of the mechanism", "η_2", "",
              m.efficiency, f"{key}.mechanism.efficiency", format="0.0##"),
        given("@method", "Losses", "", "", m.method, f"{key}.mechanism.method",
              source="physical: by the flow of power; document: over η always, as S4"),
        *loads(driven, key),
    )  # fmt: skip
    sheet.rows(*chosen.entries(driven.entered, key))


def tables(sheet: Sheet, view: Stretched) -> None:
    """Declare what is entered row by row: rotating parts, process forces."""
    sheet.heading("Enter: parts and process forces")
    parts_table(sheet, view.driven, view.one.machine.machine.sizes.rotors)
    windows_table(sheet, f"axes.{view.driven.number - 1}", view)


def outcome(
    sheet: Sheet, one: AxisRows, driven: Driven, formulas: dict[str, str], rates: Sequence[Quantity] = ()
) -> None:
    """Declare what the cycle asks of the motor, and the highest rate."""
    found, motor = driven.demand, driven.reserve
    torque = max(found.torque.peak, 1e-3)
    fastest, own = shown(found.speed.peak, RPM), driven.entered.rate
    sheet.heading("Results")
    sheet.rows(
        calc("@sized", "Sized at", "", "", f'=IF(@own_rate="","{MACHINES}","{OWN}")',
             OWN if own else MACHINES, align="right"),
        calc("@rate", "the rate", "n", "cycles/min", '=IF(@own_rate="",timing_rate,@own_rate)',
             own or one.machine.machine.per_minute),
        result("@jtot", "Inertia at the motor, without it", "J_tot", "kg cm²", formulas["jtot"],
               shown(driven.inertia, KG_CM2), source="Σ J/i², load and parts"),
        result("@inertias", "Inertia ratio", "", "",
               "=IF(@jm>0,@jtot/10000/@jm,0)", driven.inertia_ratio, source="load at the motor's shaft / motor"),
        result("@tmax", "Highest torque of the motor", "T_max", "Nm",
               formulas["tmax"],
               found.torque.highest.value, scale=torque, source="exact: at the laws' extremes of acceleration"),
        result("@tmin", "Lowest torque of the motor", "T_min", "Nm",
               formulas["tmin"],
               found.torque.lowest.value, scale=torque),
        result("@rms", "RMS torque of the motor", "T_rms", "Nm",
               formulas["rms"],
               found.rms_torque, scale=torque, source="exact, from the motion's pieces: not from samples"),
        result("@speed", "Largest speed of the motor", "n", "rpm",
               formulas["speed"].format(driven.number), fastest, source="C_v h/t, through the ratio"),
        result("@mean", "Mean speed of the motor", "n_mean", "rpm", formulas["mean"], shown(found.mean_speed, RPM),
               scale=max(fastest, 1e-3), source="of |n| over the cycle; with T_rms the RMS point"),
        result("@res_rms", "Reserve of RMS torque", "", "",
               "=IF(@rms>0,@motor_rated/@rms,0)", motor.rms_torque.reserve, source="1 or more"),
        result("@res_peak", "Reserve of peak torque", "", "",
               "=IF(MAX(@tmax,0-@tmin)>0,@motor_peak/MAX(@tmax,0-@tmin),0)", motor.peak_torque.reserve),
        result("@res_speed", "Reserve of speed", "", "", "=IF(@speed>0,@motor_nmax/@speed,0)", motor.speed.reserve),
        result("@smax", "Largest torque behind the reducer", "", "Nm",
               formulas["smax"],
               driven.reducer_checks[0].value, scale=driven.sizes.behind),
        result("@smean", "Mean torque behind the reducer", "", "Nm",
               formulas["smean"], driven.reducer_checks[1].value,
               scale=driven.sizes.behind, source="³√(∫|ω||S|³ dt/∫|ω| dt)"),
        result("@energy", "Energy that the motor drives with", "E", "J", formulas["energy"],
               found.energy.driving, scale=driven.scales.work, source="at its shaft, a cycle"),
        result("@returned", "Energy that comes back to it", "", "J", formulas["returned"],
               found.energy.regenerated, scale=driven.scales.work),
        result("@power", "Mean power at its shaft", "P", "kW", "=(@energy-@returned)/timing_cycle*@faster/1000",
               shown(found.mean_power, KW), scale=shown(driven.scales.power, KW)),
        *rates,
    )  # fmt: skip


def checks(driven: Driven, mends: Said = NOTHING) -> list[Quantity]:
    """Return the checks against the limits of motor and reducer."""
    return [
        *limit_checks(driven.reserve, driven.called, mends=mends),
        *reducer_checks(driven, mends),
        chosen.told(driven.number, driven.called),
        chosen.cool(driven.number, driven.called),
    ]


def laws_check(driven: Driven, one: AxisRows) -> Quantity:
    """Return the check that the sheet knows the motion's pieces."""
    number = driven.number
    return check("@ok_laws", f"{driven.called}: the laws are of stages that this sheet integrates", known(driven, one),
                 True, "for the RMS torque", f":shaped{number}", f'"{UNSHAPED}"')  # fmt: skip


def known(driven: Driven, one: AxisRows) -> str:
    """Return the condition under which the stretches know all of the motion's pieces; they do any of two sines.

    Phases pass the points of a table of positions once: none of them may turn round.
    """
    number = driven.number
    table, powers = f"axis{number}_pieces", one.pieces.powers
    curved = "+".join(f"([{table}.c{n}]<>0)" for n in range(3, powers))
    often = f"(([{table}.om]*[{table}.d])^2>({PLACES}*PI()*(1+check_zero))^2)"
    mixed = f"SUMPRODUCT(([{table}.A]<>0)*({curved}+{often}))"
    turns = one.ends.turning_round() if one.ends and driven.given.kind == TABLE else []
    return "+".join([mixed, *turns, total("@st.back")]) + "+IF(MAX([@st.e])<360,1,0)=0"


def reducer_checks(driven: Driven, mends: Said) -> list[Quantity]:
    """Return the checks of the reducer's limits."""
    label, (torque, mean, speed) = f"{driven.called}: ", driven.reducer_checks
    fastest, limit = shown(speed.value, RPM), driven.reducer.max_speed
    return [
        check("@ok_reducer_peak", f"{label}torque within the reducer's", "OR(@reducer_peak=0,@smax<=@reducer_peak)",
              torque.ok, says=exceeding("@smax", "@reducer_peak", "Nm", torque.value, driven.reducer.peak_torque)
              .then(mends)),
        check("@ok_reducer_mean", f"{label}mean torque within the reducer's",
              "OR(@reducer_mean=0,@smean<=@reducer_mean)", mean.ok,
              says=exceeding("@smean", "@reducer_mean", "Nm", mean.value, driven.reducer.mean_torque)
              .then(mends)),
        check("@ok_reducer_speed", f"{label}speed within the reducer's", "OR(@reducer_nmax=0,@speed<=@reducer_nmax)",
              speed.ok, says=exceeding("@speed", "@reducer_nmax", "rpm", fastest, limit).then(mends)),
    ]  # fmt: skip


def ratios(driven: Driven) -> list[Quantity]:
    """Return the rows of the ratios."""
    travels, m = driven.travels, driven.mechanism
    ratio = RATIOS.get(driven.given.kind, "=2/(@size/1000)") if travels else "=1"
    return [
        calc("@i2", "Ratio of the mechanism", "i_2", "rad/m" if travels else "",
             ratio, m.ratio_from(1), source="2π/P of a screw" if driven.given.kind == SCREW else ""),
        calc("@i", "Motor over load", "i", "rad/m" if travels else "", "=@i1*@i2", m.ratio, source="i_1 i_2"),
    ]  # fmt: skip


def lossy(driven: Driven) -> list[Quantity]:
    """Return the rows of the factors of reducer and mechanism where the load drives them."""
    stages = driven.mechanism.stages
    factors = [float(loss_factor(-1.0, 1.0, stage.efficiency, driven.given.method)) for stage in stages]
    return [
        calc(f"@back{k}", f"Factor of the {name}, load driving", f"f_{k}", "",
             f'=IF(@method="document",1/@eta{k},@eta{k})', factor, source="η; by S4 1/η, as where it is driven")
        for k, (name, factor) in enumerate(zip(("reducer", "mechanism"), factors, strict=True), 1)
    ]  # fmt: skip


def way_of(view: Stretched) -> Quantity:
    """Return the row of the way; where phases hand over, one may move there and back."""
    driven, h = view.driven, f"[axis{view.driven.number}.h]"
    formula = f"={total('@st.w')}" if view.one.ends else f"=SUMPRODUCT({h}*(({h}>0)-({h}<0)))"
    return calc("@way", "Way of the axis, there and back", "Σ|h|", "m" if driven.travels else "rad", formula, view.way)


def workings(sheet: Sheet, one: AxisRows, driven: Driven, ratios: list[Quantity], *more: Quantity) -> None:
    """Declare ratios, inertias and what resists, and more rows."""
    m, load = driven.mechanism, driven.load
    travels = driven.travels
    steady = "=@force+@mass*@g*SIN(RADIANS(@slope))" if travels else "=@torque+0"
    rubbing = "=@friction*@mass*@g*ABS(COS(RADIANS(@slope)))" if travels else "=@friction_torque+0"
    moved = "=@mass+@belt_mass" if driven.given.kind in BELTED else "=@mass+0" if travels else "=@inertia/10000"
    gravity = [constant("@g", "Gravity", "g", "m/s²", GRAVITY)] if travels else []
    base = "kg" if travels else "kg m²"
    force = "N" if travels else "Nm"

    def on(shaft: str) -> str:
        return f'SUMPRODUCT(([@parts.shaft]="{shaft}")*[@parts.all])/10000'

    sheet.heading("Workings: the chain")
    sheet.rows(
        constant("@built", "Axis, named when the book was built", "", "", driven.entered.called, align="left",
                 source="its sheet and its checks keep this name"),
        *gravity,
        calc("@faster", "Its rate over the machine's", "", "", "=@rate/timing_rate",
             shown(driven.axis.speed, one.axis.speed)),
        calc("@m", "What is moved", "m", base, moved, m.on_shaft(m.last)),
        *ratios,
        calc("@j0", "Inertia on the motor's shaft, with it", "J_0", "kg m²",
             f"=@jm+@j_reducer+{on('motor')}", driven.at_motor, source="motor, reducer, parts"),
        calc("@j1", "Inertia on the mechanism's shaft", "J_1", "kg m²", f"={on('mechanism')}", m.on_shaft(1)),
        *lossy(driven),
        calc("@steady", "What resists always", "", force, steady, load.torque, scale=driven.sizes.force,
             source="F + m g sin θ" if travels else ""),
        calc("@rub", "What opposes the motion", "", force, rubbing, load.friction, scale=driven.sizes.force,
             source="μ m g cos θ" if travels else ""),
        calc("@vmax", "Greatest geometric velocity", "y'max", "", f"=MAX([axis{driven.number}.y1])",
             driven.fastest),
        calc("@hard", "Greatest acceleration", "", "", f"=[axes.a.{driven.number}]*@faster^2", driven.axis.hardest),
        *more,
    )  # fmt: skip


def cycle(sheet: Sheet, view: Stretched) -> None:
    """Declare speed and torque over the cycle, for the chart."""
    one, driven = view.one, view.driven
    i, at, near = driven.number, one.machine.samples, one.axis.motion.tolerance
    going, angles = view.going(at), np.minimum(at + near, one.axis.motion.total - near)
    reached = f"MIN(INDEX([cycle{i}.p],[k]+1)+timing_eps,360-timing_eps)"
    speed, torque, behind, force = driven.samples(one.axis.told(at).x, going, angles)
    acts = ACTS.format(x=f"MIN(INDEX([cycle{i}.theta],[k]+1)+timing_eps,360-timing_eps)")
    sheet.heading("Table over the cycle")
    sheet.table(
        "@cycle", "Speed and torque of the motor over the cycle", len(going),
        result("rpm", "motor speed", "n", "rpm", f"=@i*@faster*INDEX([cycle{i}.v],[k]+1)*60/(2*PI())",
               shown(speed, RPM)),
        result("torque", "motor torque", "T", "Nm",
               '=IF(AND([dir]=0,@holding="brake"),0,IF([behind]*[dir]<0,@back1,1/@eta1)*[behind]/@i1'
               f"+@j0*@i*@faster^2*INDEX([cycle{i}.a],[k]+1))",
               torque, scale=driven.sizes.torque, source="f T_1/i_1 + J_0 i ÿ"),
        calc("dir", "direction", "", "",
             f"=INDEX([@st.dir],MATCH({reached},[@st.b],1))", going, format="0", source="of the stretch"),
        calc("force", "at the load", "F", "",
             f"=@steady+[dir]*@rub+SUMPRODUCT({acts}*([@windows.always]+[dir]*[@windows.moving]))"
             f"+@m*@faster^2*INDEX([cycle{i}.a],[k]+1)", force, scale=driven.sizes.force,
             source="with process forces"),
        calc("behind", "torque of the mechanism's shaft", "T_1", "Nm",
             f"=IF([force]*[dir]<0,@back2,1/@eta2)*[force]/@i2+@j1*@i2*@faster^2*INDEX([cycle{i}.a],[k]+1)", behind,
             scale=driven.sizes.behind, source="f F/i_2 + J_1 i_2 ÿ"),
        constant("k", "sample", "k", "", list(range(len(going)))),
    )  # fmt: skip
