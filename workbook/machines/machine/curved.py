"""A motor's peak torque that falls beyond a speed, in cells: the reserve below its curve, and what a rate asks of it.

Only in books that know such motors, as their catalogue has one; in others a check refuses one that is entered later.
"""

from __future__ import annotations

from typing import NamedTuple

from engine.machine.falling import CLEAR, PARTS
from workbook.book.declare import Quantity, Sheet, calc, check, result
from workbook.book.sentence import NOTHING, Said, amount
from workbook.drive.motor import falling_table, limits_table
from workbook.entries.units import PER_RPM, RPM, shown
from workbook.machines.machine.stretched import Stretched

PLACE = f"([z0]+([z4]-[z0])*({PARTS}*[fine.at]-1)/{PARTS - 1})"
WIDTH = f"(([ue]-[ub])/{PARTS - 1})"
SLOPE = "MAX(ABS([g1]),ABS([g1]+[s1]),ABS([g1]+[s1]+[s2]))"
BETWEEN = f"{SLOPE}*ABS([per])*[nm]*{WIDTH}^2/8+ABS([per])*[jm]*(ABS([s1])+ABS([s2]))*{WIDTH}/4"
"""by how much the torque can be larger between two places than at them"""
TOLD = "COUNT(INDEX([motors.end],MAX(1,@motor_row)))"
DROP = "MAX(0,@motor_peak-INDEX([motors.end],MAX(1,@motor_row)))"
LEVEL = (
    "its peak torque falls beyond a speed, and this book knows none that does: give it to the description, and build"
)
PEAK = "MAX(@tmax,0-@tmin)"
WORDS = "line of the motor's curve"
EXACT, AT_LEAST = "exact, over the whole cycle", "at least: there may be 0.1 % of its peak more"


class Line(NamedTuple):
    """The formulas of what the line of a falling curve must be at no speed (Nm), and of the speed that it falls over.

    ``sink`` is the fall times that speed (rpm); ``source`` says how near the first is.
    """

    most: str
    fast: str
    sink: float
    source: str


def line_of(view: Stretched) -> Line:
    """Return them of a drive of a constant ratio."""
    return Line("MAX([@st.cv_0])", "@turning*60/(2*PI())", view.pace.against.sink, AT_LEAST)


def curve_rows(view: Stretched, line: Line) -> list[Quantity]:
    """Return the rows of the curve of the motor in use."""
    if not view.knows_falling:
        return []
    falling = view.driven.falling
    return [
        calc("@knee", "Motor: its peak torque holds up to", "n_1", "rpm",
             "=IF(@motor_row=0,0,INDEX([motors.knee],MAX(1,@motor_row))+0)", shown(falling.knee, RPM),
             source="0: up to its largest speed"),
        calc("@fall", "Motor: fall of its peak torque beyond", "f", "Nm/rpm",
             f"=IF(@motor_row=0,0,IF({TOLD}=0,0,{DROP}/(@motor_nmax-@knee)))", shown(falling.fall, PER_RPM)),
        calc("@corner", "Motor: the falling line at no speed", "", "Nm", "=IF(@fall=0,0,@motor_peak+@fall*@knee)",
             view.corner, source="T_max + f n_1; 0: it does not fall"),
        calc("@sink", "Its fall for a speed of 1", "", "Nm", f"=@fall*{line.fast}", line.sink),
    ]  # fmt: skip


def asked(view: Stretched, x: str, same: str) -> str:
    """Return the formula of what the line must be at no speed for a stretch, at an x."""
    y, v = f"{x}*[per]*{view.acceleration(PLACE)}", f"[dir]*{view.velocity(PLACE)}"
    torque = f"[b0]+[g1]*{y}+[s1]*({y}>[y1])*({y}-[y1])+[s2]*({y}>[y2])*({y}-[y2])"
    sink = f"@sink*SQRT({x})"
    most = f"SUMPRODUCT(MAX((({torque})^2)^0.5+{sink}*{v}))+{x}*({BETWEEN})+{sink}*[jm]*{WIDTH}^2/8"
    return f"=IF(OR([on]=0,@fall=0),0,{same}IF([dir]=0,ABS([hold]),{most})))"


def curve_column(view: Stretched, trial: int, x: str = "1", same: str = "(") -> list[Quantity]:
    """Return the column of what the line must be at no speed at a trial; 0 is the present rate."""
    if not view.knows_falling:
        return []
    values = view.pace.against.asked(view.pace.trials[trial].x)
    return [
        calc(f"cv_{trial}", f"trial {trial}: {WORDS}" if trial else WORDS, "", "Nm", asked(view, x, same),
             view.rowed(values), scale=view.driven.sizes.torque, source="least that it must be at no speed")
    ]  # fmt: skip


def spare(view: Stretched, line: Line) -> list[Quantity]:
    """Return the result of what is left below the curve."""
    if not view.knows_falling:
        return []
    return [
        result("@spare", "Least reserve below the motor's curve", "", "Nm",
               f"=MIN(@motor_peak-{PEAK},IF(@fall=0,@motor_peak,@corner-{line.most}))", view.spare,
               scale=max(view.driven.demand.torque.peak, 1e-3), source=line.source)
    ]  # fmt: skip


def curve_check(view: Stretched, line: Line, mends: Said = NOTHING) -> Quantity:
    """Return the check that the torque stays below the curve; that the curve is level where the book knows no other."""
    called, holds = view.driven.called, view.below_curve
    if not view.knows_falling:
        return check("@ok_curve", f"{called}: the motor's peak torque holds up to its largest speed",
                     f"IF(@motor_row=0,0,IF({TOLD}=0,0,{DROP}))=0", holds, says=Said(f'"{LEVEL}"', LEVEL))  # fmt: skip
    too_much = f"{line.most}-@corner", view.line_asked - view.corner
    says = amount(*too_much, "", " Nm more than the motor has at its speed")
    return check("@ok_curve", f"{called}: torque below the motor's curve", f"OR(@fall=0,{line.most}<=@corner)", holds,
                 says=says.then(mends))  # fmt: skip


def at_rest(view: Stretched) -> list[Quantity]:
    """Return the rows of a drive of a constant ratio next to no rate."""
    none = "IF(@fall=0,0,SUMPRODUCT(MAX(([@st.dir]<>0)*([@st.b0]^2)^0.5+([@st.dir]=0)*([@st.hold]^2)^0.5)))"
    return lowest_rows(view, none, view.pace.against.most(0.0)) if view.knows_falling else []


def lowest_rows(view: Stretched, none: str, rest: float) -> list[Quantity]:
    """Return the rows of what the line must be next to no rate, and of what the highest rate holds it to be."""
    driven, share = view.driven, f"{CLEAR:.0E}".replace("E-0", "E-")
    lowest = driven.falling.lowest(driven.motor.peak_torque) if driven.falling.fall else 0.0
    return [
        calc("@curve0", "Line of the motor's curve at no rate", "", "Nm", f"={none}", rest,
             scale=driven.sizes.torque),
        calc("@lowest", "The highest rate keeps it below", "", "Nm", f"=@corner*(1-{share})", lowest,
             source="0: it does not fall"),
    ]  # fmt: skip


def corners_table(sheet: Sheet, view: Stretched, backward: str) -> None:
    """Declare the limits of the motor as the chart draws them."""
    motor, falling, lowest = view.driven.motor, view.driven.falling, min(0.0, *view.ways)
    if view.knows_falling:
        falling_table(sheet, motor.falling_corners(lowest, *falling), backward)
    else:
        limits_table(sheet, motor.corners(lowest), backward)
