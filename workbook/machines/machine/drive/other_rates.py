"""The columns of a drive's points at other rates: at standstill, at the rate that is tried, and creeping."""

import numpy as np

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.machines.machine.drive import brake, by_angle, stages
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

LOSS2 = "IF([dir]=0,@hold2,IF({0}*[dir]<0,@back2,1/@eta2))*{0}"
CONSTANT = "IF([dir]=0,@held2,IF({0}*[dir]<0,@in2,@out2))*{0}"
"""output torque of the reducer by a force, of a constant ratio; LOSS2 is without the ratio"""


def by_inertia(view: DriveView) -> tuple[str, str]:
    """Return the formulas of the torques of inertia on the mechanism's shaft, and at the motor's."""
    if view.varies:
        return ("@j1*[al]", f"@j0*@i1{stages.between(view.driven)}*[al]")
    return ("@j1i2*[a]", "@j0i*[a]")


def behind(view: DriveView) -> str:
    """Return the formula of the output torque of the reducer by a force, without inertia."""
    return f"{LOSS2}/[g]" if view.varies else CONSTANT


def standing(view: DriveView) -> list[Quantity]:
    """Return the columns for the highest rate: torques without motion, what of the curve grows with the rate."""
    points, load, of, driven = view.points, view.load, view.by_point, view.driven
    before, output = stages.output(view, load.shaft_torques_at_rest, behind(view), "", "[R]", stages.REST)
    cell = CELLS["standing"].sharing(**view.parts)
    columns = [
        *before,
        cell("S0", of(load.output_torque_at_rest), output=output),
        cell("T0", of(points.standing), held=brake.holding(view)),
    ]
    if not view.knows_falling:
        return columns
    level = np.stack([0.0 * points.torque] * 2)
    forward, backward = points.falling_use(driven.motor) if driven.motor.falling.fall > 0.0 else level

    def use(grows: str, left: str) -> str:
        square = f"(@fall*[n])^2+4*({grows})*({left})"
        return f"=IF(@fall=0,0,IF({square}<0,0,((@fall*ABS([n])+SQRT({square}))/2/({left}))^2))"

    return [
        *columns,
        cell("left", of(points.reserve(driven.motor))),
        cell("uc", of(forward), formula=use("[T]-[T0]", "@corner-[T0]")),
        cell("ub", of(backward), formula=use("[T0]-[T]", "@corner+[T0]")),
    ]


def at_another_rate(view: DriveView, end: str) -> list[Quantity]:
    """Return the columns of the torques at another rate: forces of inertia grow with its square.

    Their names end in ``end``, by :data:`stages.OTHER_RATES`. A drive creeps with its process forces, or empty.
    """
    (rate, times), creeps = stages.OTHER_RATES[end], end == stages.CREEPING
    then = view.creeping if creeps else view.search.points_tried
    empty = by_angle.resisting(view, "@steady", "@rub")
    resists = f'IF(creep_forces="on",[R],{empty})' if creeps else "[R]"
    of, driven = view.by_point, view.driven
    inertia, motor_inertia = by_inertia(view)
    speed, viscous = "[dx]*[vs]" if view.slides else "[v]", driven.entered.load.viscous is not None
    resisted = f"+@viscous*{speed}*({times}-{times}^2)" if viscous else ""
    source = "F_r + (F − F_r − c ẏ) x + c ẏ √x" if viscous else "F_r + (F − F_r) x"
    before, output = stages.output(view, then.load.shaft_torques, behind(view), inertia, f"[F{end}]", end)
    own = {"times": times, "end": end, "rate": rate, "resists": resists, "resisted": resisted}
    cell = CELLS["at another rate"].sharing(**view.parts, **own)
    return [
        cell("F{end}", of(then.load.force), unit=driven_unit(view), source=source),
        *before,
        cell("S{end}", of(then.load.output_torque), output=output),
        cell("T{end}", of(then.torque), held=brake.holding(view, times), own_inertia=motor_inertia),
    ]


def driven_unit(view: DriveView) -> str:
    """Return the unit of the force at the load."""
    return "N" if view.driven.axis.base == "m" else "Nm"
