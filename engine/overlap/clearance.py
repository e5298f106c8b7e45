"""What is free between tool and transfer: at each angle, and least, at the corners of the diagram."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array
from engine.overlap.parts import Passage
from engine.overlap.plan import blocked
from engine.overlap.points import HEIGHT
from engine.overlap.schedule import ANGLE_TOLERANCE, Schedule, turned
from engine.timing import FULL_TURN

NOUGHT = HEIGHT
"""of the clearance or the stroke: what is less below 0 is no collision, as heights are met by points of a law"""


class Corners(NamedTuple):
    """Where the clearance can be least, for between them the tool moves one way only: arrays of six.

    The transfer gets in the way, is in place; the tool sets off, arrives, leaves, is back.
    """

    raw: Array
    """rad, not reduced to one turn"""
    angle: Array
    """rad, within one turn"""
    inside: NDArray[np.bool_]
    """whether the transfer is in the way"""
    free: Array
    """clearance (m); where the transfer is not in the way, all of it"""


def corners(schedule: Schedule, passage: Passage) -> Corners:
    """Return the corners of the diagram."""
    begin, end = blocked(schedule.transfer, passage)
    raw = np.array([begin, end, *schedule.edges])
    angle = turned(raw)
    inside = (angle >= begin - ANGLE_TOLERANCE) & (angle <= end + ANGLE_TOLERANCE)
    gone = np.where(inside, schedule.travel(angle), 0.0)
    return Corners(raw, angle, inside, passage.clearance - gone)


class Clearance(NamedTuple):
    """Free travel (m) between tool and transfer over the cycle."""

    allowed: Array
    """how far the tool may go at each angle: the clearance while the transfer is in the way, else its stroke"""
    free: Array
    """that, less how far it has gone; below 0 they collide"""
    minimum: float
    """while the transfer is in the way; exact, not of the samples"""
    collides: bool
    """less than 0 is free somewhere"""
    meets_margin: bool


def clearance(schedule: Schedule, passage: Passage, angle: ArrayLike) -> Clearance:
    """Return what is free between the parts at angles of the master shaft (rad), and its minimum over the cycle."""
    at = np.asarray(angle, dtype=np.float64)
    allowed = allowed_travel(schedule, passage, at)
    minimum = float(corners(schedule, passage).free.min())
    tolerance = NOUGHT * max(passage.clearance, schedule.tool.stroke)
    free = allowed - schedule.travel(at)
    return Clearance(allowed, free, minimum, minimum < -tolerance, minimum >= passage.margin - tolerance)


def allowed_travel(schedule: Schedule, passage: Passage, angle: Array) -> Array:
    """Return how far the tool may go (m): the clearance while the transfer is in the way, else to the part."""
    begin, end = blocked(schedule.transfer, passage)
    at = angle % FULL_TURN
    away = (at > begin + ANGLE_TOLERANCE) & (at < end - ANGLE_TOLERANCE)
    return np.where(away, passage.clearance, schedule.tool.stroke)


def colliding(free: Array, stroke: Array) -> NDArray[np.bool_]:
    """Return where tools of these strokes (m) collide, by what is free (m)."""
    return free < -NOUGHT * stroke
