"""Schedules of transfer and tool: one after the other, and overlapping as far as the passage allows."""

import math
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array
from engine.laws.inverse import HEIGHT
from engine.overlap.schedule import ANGLE_TOLERANCE, Limit, Passage, Schedule, Tool, Transfer, within_turn
from engine.timing import FULL_TURN


def one_after_the_other(transfer: Transfer, tool: Tool, split: float = 0.5) -> Schedule:
    """Return the schedule without overlap: the tool moves while the transfer rests. S2, (360 − 150 − 100)/2 = 55°."""
    free = free_angle(transfer.angle, tool)
    return Schedule(transfer, tool, free * split, free * (1.0 - split), transfer.angle + free * split)


@lru_cache(maxsize=256)
def blocked_angles(transfer: Transfer, passage: Passage) -> tuple[float, float]:
    """Return the angles (rad) between which the transfer is in the way of the tool (S2: 15° and 135°)."""
    begin, end = transfer.inverted(transfer.law, np.array(passage.shares)) * transfer.angle
    return float(begin), float(end)


class FreeAngles(NamedTuple):
    """Angles that a transfer and the passage leave for the tool's movements (rad)."""

    begin: float  # where the transfer begins to be in the way
    end: float  # where it ceases to be
    free_in: float  # F_in, for the way in while the transfer is not in the way (S2: 140°/2 = 70°)
    free_out: float  # likewise for the way out
    both: float  # the turn less the tool's dwell, for both ways at most


def free_angles(transfer: Transfer, tool: Tool, passage: Passage) -> FreeAngles:
    """Return the angles left for the tool; raise ValueError if there are none."""
    begin, end = blocked_angles(transfer, passage)
    free = free_angle(end - begin, tool)
    return FreeAngles(begin, end, free * passage.split, free * (1.0 - passage.split), FULL_TURN - tool.dwell)


def remaining_shares(tool: Tool, passage: Passage, margin: Array) -> tuple[Array, Array]:
    """Return the shares 1 − ξ of the ways in and out that fall in the free angles, for margins (m): S2, 1 − 44 %."""
    gone = passage.travelled_share(tool.stroke, margin)
    return 1.0 - tool.inverted(tool.law, gone), tool.inverted(tool.out, 1.0 - gone)


def tool_angles(
    left: FreeAngles, tool: Tool, passage: Passage, margin: Array
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return the tool's angles in and out (rad) for margins (m), and whether the cycle limits one of them."""
    rest, free = np.array(remaining_shares(tool, passage, margin)), np.array([[left.free_in], [left.free_out]])
    most = left.both * np.array([[passage.split], [1.0 - passage.split]])
    way = np.divide(free, rest, out=np.full(rest.shape, np.inf), where=rest > 0.0)
    found = np.minimum(way, most) - passage.allowance
    if found.min() <= 0.0:
        raise ValueError(f"an allowance of {math.degrees(passage.allowance):g} degrees leaves the tool no angle")
    return found[0], found[1], (way > most).any(axis=0)


def overlap(transfer: Transfer, tool: Tool, passage: Passage) -> Schedule:
    """Return the schedule with the longest ways in and out of the tool that the passage allows.

    The free angle F = 2π − (angle with the transfer in the way) − dwell is split. When the transfer leaves the way, the
    tool may have gone s = (clearance − margin)/stroke, at ξ, so the way in is F_in/(1 − ξ), less the allowance
    (S2: 70°/0.56 = 125°, 120° with the allowance of 5°). The way out is the same in reverse.
    Raises ValueError if no angle is left. Source: S2, 'Cycloid Cam Profile Analysis'.
    """
    left = free_angles(transfer, tool, passage)
    way_in, way_out, capped = tool_angles(left, tool, passage, np.array([passage.margin]))
    limit: Limit = "cycle" if capped[0] else "clearance"
    return Schedule(transfer, tool, float(way_in[0]), float(way_out[0]), left.end + left.free_in, limit)


def free_angle(occupied: float, tool: Tool) -> float:
    """Return the turn less an occupied angle and the tool's dwell (rad); raise ValueError if nothing is left."""
    free = FULL_TURN - occupied - tool.dwell
    if free <= 0.0:
        taken, dwell = math.degrees(occupied), math.degrees(tool.dwell)
        raise ValueError(f"transfer ({taken:g} degrees) and dwell ({dwell:g} degrees) leave the tool no angle of 360")
    return free


class MarginSweep(NamedTuple):
    """The overlapping schedule against the margin, arrays of one shape."""

    margin: Array  # m
    angle_in: Array  # rad
    angle_out: Array  # rad
    acceleration: Array  # peak of the tool (m/s²)
    ratio: Array  # of the peak without overlap to that with it


def sweep_margin(transfer: Transfer, tool: Tool, passage: Passage, margins: ArrayLike, rate: float) -> MarginSweep:
    """Return the schedule at each margin (m) and a rate (1/s). Raises ValueError outside 0 to the clearance."""
    margin = np.asarray(margins, dtype=np.float64)
    for extreme in (margin.min(), margin.max()):
        replace(passage, margin=float(extreme))
    way_in, way_out, _ = tool_angles(free_angles(transfer, tool, passage), tool, passage, margin)
    scale = tool.stroke * (FULL_TURN * rate) ** 2
    peaks = [law.coefficients.ca * scale / way**2 for law, way in ((tool.law, way_in), (tool.out, way_out))]
    acceleration = np.maximum(*peaks)
    before = one_after_the_other(transfer, tool, passage.split).peak_acceleration(rate)
    return MarginSweep(margin, way_in, way_out, acceleration, before / acceleration)


COLLISION_TOLERANCE = HEIGHT
"""share of the clearance or the stroke by which free travel may be below 0: the inverse by points is no more exact"""


class CriticalAngles(NamedTuple):
    """Angles of the least free travel: transfer into and out of the way, tool off, arrived, leaving and back."""

    raw: Array  # rad, not reduced to one turn
    angle: Array  # rad, within one turn
    inside: NDArray[np.bool_]  # whether the transfer is in the way
    free: Array  # free travel (m); the clearance if the transfer is not in the way


def critical_angles(schedule: Schedule, passage: Passage) -> CriticalAngles:
    """Return the angles at which the free travel of a schedule can be least."""
    begin, end = blocked_angles(schedule.transfer, passage)
    raw = np.array([begin, end, *schedule.edges])
    angle = within_turn(raw)
    inside = (angle >= begin - ANGLE_TOLERANCE) & (angle <= end + ANGLE_TOLERANCE)
    gone = np.where(inside, schedule.travel(angle), 0.0)
    return CriticalAngles(raw, angle, inside, passage.clearance - gone)


class Clearance(NamedTuple):
    """Free travel (m) between tool and transfer over the cycle."""

    allowed: Array  # travel allowed at each angle: the clearance while the transfer is in the way, else the stroke
    free: Array  # the allowed less the tool's travel; below 0 they collide
    minimum: float  # while the transfer is in the way; exact, not of the samples
    collides: bool  # whether the minimum is below 0
    meets_margin: bool  # whether the minimum is at least the margin


def clearance(schedule: Schedule, passage: Passage, angle: ArrayLike) -> Clearance:
    """Return the free travel at angles of the master shaft (rad), and its minimum over the cycle."""
    at = np.asarray(angle, dtype=np.float64)
    begin, end = blocked_angles(schedule.transfer, passage)
    turned_at = at % FULL_TURN
    away = (turned_at > begin + ANGLE_TOLERANCE) & (turned_at < end - ANGLE_TOLERANCE)
    allowed = np.where(away, passage.clearance, schedule.tool.stroke)
    minimum = float(critical_angles(schedule, passage).free.min())
    tolerance = COLLISION_TOLERANCE * max(passage.clearance, schedule.tool.stroke)
    free = allowed - schedule.travel(at)
    return Clearance(allowed, free, minimum, minimum < -tolerance, minimum >= passage.margin - tolerance)


def colliding(free: Array, stroke: Array) -> NDArray[np.bool_]:
    """Return whether tools of these strokes (m) collide at a free travel (m)."""
    return free < -COLLISION_TOLERANCE * stroke
