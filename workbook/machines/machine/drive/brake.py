"""A motor's brake in cells: the dwells that it holds, which are no shorter than it takes to close and open.

Only the sheet of a drive whose description has the brake's figures has these: else a brake holds in every dwell.
"""

import numpy as np

from workbook.book.declare import Quantity, calc, check, result
from workbook.book.rows import filled
from workbook.book.sentence import exceeding
from workbook.machines.machine.drive.view import DriveView


def held(view: DriveView) -> str:
    """Return the formula of 1 at a point where the brake holds the shaft, in dwells long enough for it, else 0."""
    return "1-[free]" if view.brakes else "([dir]=0)*@brake"


def held_at_tried(view: DriveView) -> str:
    """Return the formula of 1 at a point where the brake holds the shaft at the rate that is tried, else 0."""
    lasts = "INDEX([@iv.dwell],[iv])>=(@brake_least-check_zero)*@times"
    return f"([dir]=0)*({lasts})*@brake" if view.brakes else held(view)


def workings(view: DriveView) -> list[Quantity]:
    """Return the rows of the shortest dwell that it holds, and of the intervals in motion."""
    return [
        calc("@brake_least", "Shortest dwell that the brake holds", "", "s", "=(@brake_closing+@brake_opening)/1000",
             view.driven.brake.time, "to close and to open"),
        calc("@moving", "Intervals in motion", "", "", "=SUMPRODUCT(([@iv.len]>=eps)*([@iv.dir]<>0))",
             int((view.cycle.direction != 0.0).sum()), format="0"),
    ]  # fmt: skip


def of_intervals(view: DriveView, spare: str) -> list[Quantity]:
    """Return the columns of the dwell that an interval belongs to; ``spare`` is the condition of a spare row."""
    cycle = view.cycle
    moves = cycle.direction != 0.0
    before = (np.cumsum(moves) - moves) % max(1, int(moves.sum()))
    count = "SUMPRODUCT(([@iv.k]<[k])*([@iv.dir]<>0))"
    dwell = "([@iv.before]=[before])*([@iv.dir]=0)*[@iv.len]"
    return [
        calc("before", "intervals in motion before it", "", "", f"=IF(OR({spare},{count}=@moving),0,{count})",
             filled(before.tolist(), view.rows, 0), "0: all, or none; as many: one dwell", format="0"),
        calc("dwell", "time of its dwell", "t_d", "s",
             f"=IF({spare},[dwell-1],IF([dir]<>0,0,RADIANS(SUMPRODUCT({dwell}))/@omega))",
             view.by_interval(cycle.dwells), "spare rows: as above", scale=view.time),
        calc("held", "held by the brake", "", "",
             f"=IF({spare},[held-1],([dir]=0)*([dwell]>=@brake_least-check_zero)*@brake)",
             view.by_interval(view.load.braked[:, 0].astype(float)), "1 yes, 0 no", format="0"),
    ]  # fmt: skip


def of_points(view: DriveView) -> list[Quantity]:
    """Return the columns of whether the motor is free of the brake, and of what it then drives."""
    free = np.where(view.load.braked, 0.0, 1.0)
    return [
        calc("free", "free of the brake", "", "", "=1-IF([dir]=0,INDEX([@iv.held],[iv]),0)", view.by_point(free),
             "0 where it holds", format="0"),
        calc("Sm", "output torque of the reducer, by the motor", "", "Nm", "=[S]*[free]",
             view.by_point(view.load.output_torque * free), scale=view.scales.behind),
    ]  # fmt: skip


def torque(view: DriveView) -> Quantity:
    """Return the result of what the brake holds."""
    return result("@brake_load", "Brake torque, highest", "T_B", "Nm",
                  "=SUMPRODUCT(MAX((1-[@pt.free])*ABS([@pt.S])))*@out1", view.points.brake_torque,
                  "in the dwells that it holds", scale=view.scales.torque)  # fmt: skip


def holds(view: DriveView) -> Quantity:
    """Return the check of the brake's holding torque."""
    load, most = view.points.brake_torque, view.driven.brake.torque
    return check("@ok_brake", f"{view.driven.called}: the brake holds the load at rest", "@brake_load<=@brake_torque",
                 load <= most, says=exceeding("@brake_load", "@brake_torque", "Nm", load, most))  # fmt: skip
