"""A motor's brake in cells: the dwells that it holds, which are no shorter than it takes to close and open.

Only the sheet of a drive whose description has the brake's figures has these: else a brake holds in every dwell.
"""

import numpy as np

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.book.rows import filled
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)


def holding(view: DriveView, times: str = "") -> str:
    """Return the formula of 1 at a point where the brake holds the shaft, perhaps at so many times the rate, else 0.

    It holds in dwells long enough for it.
    """
    if not view.brakes:
        return "([dir]=0)*@brake"
    return f"([dir]=0)*(INDEX([@iv.dwell],[iv])>=(@brake_least-check_zero)*{times})*@brake" if times else "1-[free]"


def workings(view: DriveView) -> list[Quantity]:
    """Return the rows of the shortest dwell that it holds, and of the intervals in motion."""
    cell = CELLS["workings"]
    return [cell("@brake_least", view.driven.brake.time), cell("@moving", int((view.cycle.direction != 0.0).sum()))]


def of_intervals(view: DriveView, spare: str) -> list[Quantity]:
    """Return the columns of the dwell that an interval belongs to; ``spare`` is the condition of a spare row."""
    cell = CELLS["of_intervals"]
    cycle = view.cycle
    moves = cycle.direction != 0.0
    before = (np.cumsum(moves) - moves) % max(1, int(moves.sum()))
    return [
        cell("before", filled(before.tolist(), view.rows, 0), spare=spare),
        cell("dwell", view.by_interval(cycle.dwells), spare=spare, scale=view.time),
        cell("held", view.by_interval(view.load.braked[:, 0].astype(float)), spare=spare),
    ]


def of_points(view: DriveView) -> list[Quantity]:
    """Return the columns of whether the motor is free of the brake, and of what it then drives."""
    cell = CELLS["of_points"].sharing(**view.parts)
    free = np.where(view.load.braked, 0.0, 1.0)
    return [cell("free", view.by_point(free)), cell("Sm", view.by_point(view.load.output_torque * free))]


def torque(view: DriveView) -> Quantity:
    """Return the result of what the brake holds."""
    return CELLS["torque"]("@brake_load", view.points.brake_torque, scale=view.scales.torque)


def holds(view: DriveView) -> Quantity:
    """Return the check of the brake's holding torque."""
    load, most = view.points.brake_torque, view.driven.brake.torque
    return CELLS["holds"].limit("@ok_brake", load, most, called=view.driven.called)
