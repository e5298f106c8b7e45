"""Overlap of two motions: how much longer the second may take when it begins before the first has ended.

A transfer (S2: the indexing mill) brings the part; a tool (S2: the die) enters when the part is there, dwells,
and is out before the next transfer. Angles are of the master shaft, in rad; the transfer begins at 0. Tools at several
stations are as many schedules over the same transfer: each meets the transfer, none another tool.
"""

from engine.overlap.parts import Passage, Tool, Transfer
from engine.overlap.plan import (
    Clearance,
    Corners,
    MarginSweep,
    Room,
    blocked,
    clearance,
    colliding,
    corners,
    one_after_the_other,
    overlap,
    rests,
    room,
    sweep_margin,
)
from engine.overlap.points import HEIGHT, INTERVALS, REST, Between, Points, between, inverse_by_points, points_of
from engine.overlap.schedule import ANGLE_TOLERANCE, Rates, Schedule, movement_time

__all__ = [
    "ANGLE_TOLERANCE", "HEIGHT", "INTERVALS", "REST", "Between", "Clearance", "Corners", "MarginSweep", "Passage",
    "Points", "Rates", "Room", "Schedule", "Tool", "Transfer", "between", "blocked", "clearance", "colliding",
    "corners", "inverse_by_points", "movement_time", "one_after_the_other", "overlap", "points_of", "rests", "room",
    "sweep_margin",
]  # fmt: skip
