"""The columns of a drive's points at other rates: at standstill, and at the rate that is tried."""

import numpy as np

from workbook.book.declare import Quantity, calc
from workbook.machines.machine.drive import brake, stages
from workbook.machines.machine.drive.view import DriveView

LOSS2 = "IF([dir]=0,@hold2,IF({0}*[dir]<0,@back2,1/@eta2))*{0}"
LOSS1 = "IF({0}*[dir]<0,@in1,@out1)*{0}"
CONSTANT = "IF([dir]=0,@held2,IF({0}*[dir]<0,@in2,@out2))*{0}"
"""output torque of the reducer by a force, of a constant ratio; LOSS2 is without the ratio"""


def by_inertia(view: DriveView) -> tuple[str, str]:
    """Return the formulas of the torques of inertia on the mechanism's shaft, and at the motor's."""
    return ("@j1*[al]", f"@j0*@i1{stages.between(view.driven)}*[al]") if view.varies else ("@j1i2*[a]", "@j0i*[a]")


def behind(view: DriveView) -> str:
    """Return the formula of the output torque of the reducer by a force, without inertia."""
    return f"{LOSS2}/[g]" if view.varies else CONSTANT


def standing(view: DriveView) -> list[Quantity]:
    """Return the columns for the highest rate: torques without motion, what of the curve grows with the rate."""
    points, load, size, of, driven = view.points, view.load, view.scales, view.by_point, view.driven
    before, output = stages.output(view, behind(view), "", "[R]", stages.REST)
    columns = [
        *before,
        calc("S0", "output torque of the reducer, without inertia", "T_1,s", "Nm", output,
             of(load.output_torque_at_rest), "F_r/(η_2 φ')", scale=size.behind),
        calc("T0", "torque of the motor, without inertia", "T_s", "Nm",
             f"=IF({brake.held(view)},0,{LOSS1.format('[S0]')}+@no_load*[dir])", of(points.standing),
             "T_1,s/(η_1 i_1) ± T_nl", scale=size.torque),
    ]  # fmt: skip
    if not view.knows_falling:
        return columns
    level = np.stack([0.0 * points.torque] * 2)
    forward, backward = points.falling_use(driven.motor) if driven.motor.falling.fall > 0.0 else level

    def use(grows: str, left: str) -> str:
        square = f"(@fall*[n])^2+4*({grows})*({left})"
        return f"=IF(@fall=0,0,IF({square}<0,0,((@fall*ABS([n])+SQRT({square}))/2/({left}))^2))"

    return [
        *columns,
        calc("left", "left below the motor's curve", "", "Nm", "=@motor_peak-@fall*MAX(0,ABS([n])-@knee)-ABS([T])",
             of(points.reserve(driven.motor)), "T_max − f (n − n_1) − |T|",
             scale=size.torque),
        calc("uc", "share of the curve", "", "", use("[T]-[T0]", "@corner-[T0]"), of(forward), "of torques forward",
             scale=1.0),
        calc("ub", "share of the curve", "", "", use("[T0]-[T]", "@corner+[T0]"), of(backward), "of torques backward",
             scale=1.0),
    ]  # fmt: skip


def tried(view: DriveView) -> list[Quantity]:
    """Return the columns of the torques at the rate that is tried: forces of inertia grow with its square."""
    then, of, size, driven = view.search.points_tried, view.by_point, view.scales, view.driven
    force, resisted, (inertia, motor_inertia) = "([R]+([F]-[R])*@times^2)", [], by_inertia(view)
    if driven.entered.load.viscous is not None:
        speed = "[dx]*[vs]" if view.slides else "[v]"
        formula = f"=[R]+([F]-[R])*@times^2+@viscous*{speed}*(@times-@times^2)"
        resisted = [calc("FN", "force at the rate that is tried", "F_N", driven_unit(view), formula,
                         of(then.load.force), "F_r + (F − F_r − c ẏ) x + c ẏ √x", scale=size.force)]  # fmt: skip
        force = "[FN]"
    held, (before, output) = brake.held_at_tried(view), stages.output(view, behind(view), inertia, force, stages.TRIED)
    return [
        *resisted,
        *before,
        calc("SN", "output torque of the reducer, at the rate that is tried", "T_1,N", "Nm", output,
             of(then.load.output_torque), scale=size.behind),
        calc("TN", "torque of the motor, at the rate that is tried", "T_N", "Nm",
             f"=IF({held},0,{LOSS1.format('[SN]')}+{motor_inertia}*@times^2+@no_load*[dir])", of(then.torque),
             scale=size.torque),
    ]  # fmt: skip


def driven_unit(view: DriveView) -> str:
    """Return the unit of the force at the load."""
    return "N" if view.driven.axis.base == "m" else "Nm"
