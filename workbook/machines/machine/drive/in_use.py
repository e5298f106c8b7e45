"""Motor and reducer of a drive: by name from the sheet Catalogue, or as entered; one entry decides, the name."""

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeVar

from engine.drive import Motor, derating
from engine.drive.limits import ReducerLimits
from engine.drive.motor import TorqueFall
from workbook.book.declare import Quantity, calc, check, entries_of, given
from workbook.fields.texts import place_of
from workbook.fields.units import KG_CM2, KW, PER_HOUR, RPM, shown, si
from workbook.machines.machine.drive_entries import NEEDED, UNTOLD, AxisMotor
from workbook.machines.machine.entries import Axis
from workbook.selection.catalogue import FULL_CYCLES, MotorRow, ReducerRow
from workbook.selection.entries import Limits, Products
from workbook.selection.limits import LIMITS

P = TypeVar("P", MotorRow, ReducerRow)
MOTOR = (
    ("inertia", "inertia", "J_m", "kg cm²", "with its brake", "@jm", "inertia"),
    ("stall_torque", "stall torque", "T_0", "Nm", "empty: the rated one", "@motor_stall", "stall"),
    ("rated_torque", "rated torque", "T_N", "Nm", "continuous, at the rated speed", "@motor_rated", "rated"),
    ("rated_speed", "rated speed", "n_N", "rpm", "empty: the largest speed", "@motor_nn", "nn"),
    ("peak_torque", "peak torque", "T_M,max", "Nm", "", "@motor_peak", "peak"),
    ("max_speed", "largest speed", "n_M,max", "rpm", "", "@motor_nmax", "nmax"),
)
REDUCER = (
    ("ratio", "ratio", "i_1", "", "motor over mechanism; 1 if empty", "@i1", "i"),
    ("efficiency", "efficiency", "η_1", "", "1 if empty", "@eta1", "eta"),
    ("inertia", "inertia at the input", "J_G", "kg cm²", "", "@j_reducer", "inertia"),
    ("no_load_torque", "no-load torque", "T_nl", "Nm", "at the motor, against its rotation", "@no_load", "t012"),
    ("peak_torque", "largest output torque", "", "Nm", "empty: no limit", "@reducer_peak", "tmax"),
    ("full_cycles", "full-torque cycles an hour", "Z_h", "1/h", "empty: 1,000", "@reducer_full", "full"),
    ("cycle_factor", "cycle factor beyond these", "f_s", "", "divides that torque; empty: 1", "@reducer_fs", "fs"),
    ("mean_torque", "largest mean output torque", "", "Nm", "empty: no limit", "@reducer_mean", "t2n"),
    ("max_speed", "largest input speed", "", "rpm", "empty: no limit", "@reducer_nmax", "nmax"),
)
"""of each entry: words, symbol, unit and a note, the cell that is used, and the column of the catalogue"""
DERATING = 'IF(@temperature="",1,MIN(1,SQRT((@winding-@temperature)/(@winding-@rated_at))))'
ZERO = dict.fromkeys(("peak_torque", "mean_torque", "max_speed"), "0: no limit") | {"full_cycles": "0: not given"}
AT_LEAST = {"cycle_factor": "MAX(1,{0})"}  # what counts of an entry that may be empty
SOURCES = {
    "rated_torque": "at its temperature, over its reserve", "peak_torque": "over its reserve",
    "stall_torque": "at its temperature, over the reserve, T_N at least", "max_speed": "over its reserve",
}  # fmt: skip
IN_SI = {"kg cm²": ("kg m²", "({})/10000")}
"""of the units of what is entered in others, for the formulas behind: the unit, and what a formula stands in"""


def named(rows: Sequence[P], name: str) -> tuple[int, P | None]:
    """Return the row, from 1, of the product of a name, and the product; 0 and None where nothing is named."""
    place = place_of(name, [row.name for row in rows])
    return place + 1, rows[place] if place >= 0 else None


class MotorInUse(NamedTuple):
    """The motor that a drive has, in the units of entries but for its inertia, in kg m²; 0 if no speed is given.

    ``losses`` are those of its winding at the rated torque, in kW; ``copper`` over the square of the torque (W/(Nm)²).
    """

    row: int
    inertia: float
    rated_torque: float
    peak_torque: float
    max_speed: float
    stall_torque: float
    rated_speed: float
    rated_given: float
    losses: float
    copper: float

    @property
    def motor(self) -> Motor:
        """The engine's motor."""
        fastest, rated = si(self.max_speed, RPM), si(self.rated_speed, RPM)
        return Motor(self.inertia, self.rated_torque, self.peak_torque, fastest, self.stall_torque, rated)


class ReducerInUse(NamedTuple):
    """The reducer that a drive has, in the units of entries but for its inertia, in kg m²; a limit of 0 is none."""

    row: int
    ratio: float
    efficiency: float
    inertia: float
    no_load_torque: float
    peak_torque: float
    full_cycles: float
    cycle_factor: float
    mean_torque: float
    max_speed: float

    @property
    def limits(self) -> ReducerLimits:
        """Its limits."""
        peak, mean, fastest = (limit or math.inf for limit in (self.peak_torque, self.mean_torque, self.max_speed))
        full = si(self.full_cycles or FULL_CYCLES, PER_HOUR)
        return ReducerLimits(peak, mean, si(fastest, RPM), full, self.cycle_factor)


def motor_in_use(axis: Axis, products: Products, limits: Limits) -> MotorInUse:
    """Return the motor of an axis, its limits over their reserves. Raises ValueError where it has none."""
    if axis.motor is None:
        raise ValueError(f"{axis.name} has no motor")
    row, found = named(products.motors, axis.motor.name)
    given, left = found or axis.motor, left_of(axis.motor)
    inertia, rated, peak, fastest = (float(getattr(given, name)) for name in NEEDED)
    lasting = left / limits.rms_reserve
    stall = max(rated, given.stall_torque or 0.0) * lasting
    speed = given.rated_speed or 0.0
    own = axis.motor.copper_losses
    losses = (given.copper_losses if own is None else own) or 0.0
    used = rated * lasting, peak / limits.peak_reserve, fastest / limits.speed_reserve, stall, speed or fastest, speed
    return MotorInUse(row, si(inertia, KG_CM2), *used, losses, si(losses, KW) / rated**2)


def falling_of(name: str, products: Products, reserve: float) -> TorqueFall:
    """Return how the peak torque of a motor of the catalogue falls, over its reserve; of one entered, not at all."""
    _, found = named(products.motors, name)
    if found is None or found.full_torque_to is None or found.end_torque is None:
        return TorqueFall()
    knee, fastest = si(found.full_torque_to, RPM), si(found.max_speed, RPM)
    return TorqueFall.between((knee, found.peak_torque / reserve), (fastest, found.end_torque / reserve))


def left_of(motor: AxisMotor) -> float:
    """Return the share of its rated torque that a motor can give at the temperature around it."""
    return 1.0 if motor.temperature is None else derating(motor.temperature, motor.limit, motor.rated_at)


def reducer_in_use(axis: Axis, products: Products, limits: Limits) -> ReducerInUse:
    """Return the reducer of an axis, its peak torque over the factor; one of ratio 1 where nothing is entered."""
    row, found = named(products.reducers, axis.reducer.name)
    used = found or axis.reducer
    ratio, peak = (found.reduction, found.max_torque) if found else (axis.reducer.ratio, axis.reducer.peak_torque)
    return ReducerInUse(row, ratio, used.efficiency, si(used.inertia or 0.0, KG_CM2), used.no_load_torque or 0.0,
                        (peak or 0.0) / limits.torque_factor,
                        used.full_cycles or 0.0, used.cycle_factor or 1.0, used.mean_torque or 0.0,
                        used.max_speed or 0.0)  # fmt: skip


UNUSED = "not used"  # what is entered of a product that has the catalogue's figures


def entries(axis: Axis, key: str) -> list[Quantity]:
    """Return the rows of what is entered of reducer and motor."""
    rows: list[Quantity] = []
    for kind, figures in (("reducer", REDUCER), ("motor", MOTOR)):
        entered, named = getattr(axis, kind), f"{kind.capitalize()}, as entered: "
        cell = entries_of(entered, f"{key}.{kind}")
        rows += [
            given(f"@{kind}_name", f"{kind.capitalize()} of the catalogue", "", "", entered.name or None,
                  f"{key}.{kind}.name", choices=f"={kind}_name", align="left",
                  source="leave empty to enter the figures below"),
            calc(f"@own_{kind}", f"{named}the figures below are", "", "",
                 f'=IF(@{kind}_name="","used","{UNUSED}")', UNUSED if entered.name else "used", align="right"),
            *(cell(f"@own_{kind}_{name}", named + words, symbol, unit, name, source,
                   format="General" if unit in IN_SI else "0.0##")
              for name, words, symbol, unit, source, *_ in figures),
        ]  # fmt: skip
    motor, limit = axis.motor or AxisMotor(), entries_of(axis.limits, f"{key}.limits")
    cell, brake = entries_of(motor, f"{key}.motor"), entries_of(motor.brake, f"{key}.motor.brake")
    return [
        *rows,
        cell("@losses_rated", "Copper losses of the motor at the rated torque", "P_Cu", "kW", "copper_losses",
             "empty: as the catalogue has it, or none", format=""),
        cell("@holding", "At rest the load is held by", "", "", "holding", "the motor, or a brake"),
        *([] if motor.brake is None else [
            brake("@brake_torque", "Brake: torque that it holds", "T_B,N", "Nm", "torque", "at the motor's shaft"),
            brake("@brake_closing", "Brake: time to close", "", "ms", "closing"),
            brake("@brake_opening", "Brake: time to open", "", "ms", "opening",
                  "the motor holds in dwells shorter than both together"),
        ]),
        cell("@temperature", "Ambient temperature of the motor", "ϑ", "°C", "temperature", "empty: as rated"),
        cell("@rated_at", "Ambient temperature of the rated torque", "ϑ_N", "°C", "rated_at"),
        cell("@winding", "Largest temperature of the winding", "ϑ_max", "°C", "limit", "155 °C of class F"),
        *(limit(f"@own_{name}", f"{words}, if not the machine's", symbol, "", name, "empty: the machine's")
          for name, words, symbol, _ in LIMITS),
    ]  # fmt: skip


def in_use(motor: MotorInUse, reducer: ReducerInUse, left: float, limits: Limits) -> list[Quantity]:
    """Return the rows of the figures that the drive uses, limits over their reserves."""

    def figure(of: MotorInUse | ReducerInUse, row: tuple[str, ...], formula: str, source: str = "") -> Quantity:
        name, words, symbol, unit, _, cell, _ = row
        (base, made), product = IN_SI.get(unit, (unit, "{}")), "Motor" if of is motor else "Reducer"
        return calc(cell, f"{product}: {words}", symbol, base, f"={made.format(formula)}", getattr(of, name), source)

    rows = [
        calc(f"@{kind}_row", f"{kind.capitalize()}: row of the catalogue", "", "",
             f'=IF(@{kind}_name="",0,MATCH(@{kind}_name,[{kind}s.name],0))', row, "0: as entered", format="0")
        for kind, row in (("reducer", reducer.row), ("motor", motor.row))
    ]  # fmt: skip
    for row in REDUCER:
        name, column, own = row[0], row[-1], f"@own_reducer_{row[0]}"
        entered = f'IF({own}="",1,{own})' if name in ("ratio", "efficiency") else f"{own}+0"
        listed = f"IF(@reducer_row=0,{entered},INDEX([reducers.{column}],@reducer_row)+0)"
        listed += "/@torque_factor" if name == "peak_torque" else ""
        rows.append(figure(reducer, row, AT_LEAST.get(name, "{0}").format(listed), ZERO.get(name, "")))
    listed_motor = {
        name: f"IF(@motor_row=0,@own_motor_{name},INDEX([motors.{column}],@motor_row))" for name, *_, column in MOTOR
    }
    used = {
        "rated_torque": f"{listed_motor['rated_torque']}*@derate/@rms_reserve",
        "stall_torque": f"MAX(@motor_rated,{listed_motor['stall_torque']}*@derate/@rms_reserve)",
        "rated_speed": "IF(@nn_given=0,@motor_nmax*@speed_reserve,@nn_given)",
        "peak_torque": f"{listed_motor['peak_torque']}/@peak_reserve",
        "max_speed": f"{listed_motor['max_speed']}/@speed_reserve",
    }
    return [
        *(calc(f"@{name}", words, symbol, "", f'=IF(@own_{name}="",limits_{name},@own_{name})', getattr(limits, name),
               "of all drives, or its own") for name, words, symbol, _ in LIMITS),
        *rows,
        calc("@derate", "Motor: share of the rated torque at the ambient temperature", "", "", f"={DERATING}", left,
             "√((ϑ_max − ϑ)/(ϑ_max − ϑ_N)), at most 1; S4, problem 2"),
        calc("@nn_given", "Motor: rated speed as it is given", "", "rpm", f"={listed_motor['rated_speed']}+0",
             motor.rated_given, "0: not given"),
        *(figure(motor, row, used.get(row[0], f"{listed_motor[row[0]]}+0"), SOURCES.get(row[0], "")) for row in MOTOR),
        calc("@losses", "Motor: copper losses at the rated torque", "P_Cu", "kW",
             '=IF(@losses_rated<>"",@losses_rated,IF(@motor_row=0,0,INDEX([motors.pcu],@motor_row)))+0', motor.losses,
             "0: none are counted"),
        calc("@copper", "Motor: copper losses over the square of the torque", "", "kW/N²m²",
             "=IF(@losses*@motor_rated=0,0,@losses/(@motor_rated*@rms_reserve/@derate)^2)",
             shown(motor.copper, KW), "P_Cu/T_N²"),
    ]  # fmt: skip


HOT = 'ROUND(MAX(@temperature,@rated_at),9)&" °C; expected less than the limit, "&ROUND(@winding,9)&" °C"'


def checks(number: int, called: str) -> list[Quantity]:
    """Return the checks that the motor is named, or entered, and cooler than its winding may get."""
    figures, key = ",".join(f"@own_motor_{name}" for name in NEEDED), f"axes.{number - 1}.motor"
    return [
        check("@ok_told", f"{called}: a motor is named or entered",
              f'OR(@motor_name<>"",COUNT({figures})={len(NEEDED)})', True, rule=f"{key}:told", says=f'"{UNTOLD}"'),
        check("@ok_cool", f"{called}: ambient temperature below the limit",
              "MAX(@temperature,@rated_at)<@winding", True, rule=f"{key}:cool", says=HOT),
    ]  # fmt: skip
