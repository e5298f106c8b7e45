"""The schedules: one after the other, and with the longest ways in and out that the passage allows."""

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
    """Return the schedule without overlap, in what the transfer leaves of the turn: S2, (360 − 150 − 100)/2 = 55°."""
    free = free_angle(transfer.angle, tool)
    return Schedule(transfer, tool, free * split, free * (1.0 - split), transfer.angle + free * split)


@lru_cache(maxsize=256)
def blocked_angles(transfer: Transfer, passage: Passage) -> tuple[float, float]:
    """Return the angles (rad) between which the transfer is too far from its ends for a tool in (S2: 15° and 135°)."""
    begin, end = transfer.inverted(transfer.law, np.array(passage.shares)) * transfer.angle
    return float(begin), float(end)


class FreeAngles(NamedTuple):
    """What a transfer and the passage leave a tool: angles in rad."""

    begin: float  # from here the transfer is in the way
    end: float  # and to here
    free_in: float  # for the way in, as long as the tool is not at the part: F_in (S2: 140°/2 = 70°)
    free_out: float
    both: float  # for both ways at most, whatever the passage


def free_angles(transfer: Transfer, tool: Tool, passage: Passage) -> FreeAngles:
    """Return what is left to the tool; raise ValueError where that is nothing."""
    begin, end = blocked_angles(transfer, passage)
    free = free_angle(end - begin, tool)
    return FreeAngles(begin, end, free * passage.split, free * (1.0 - passage.split), FULL_TURN - tool.dwell)


def remaining_shares(tool: Tool, passage: Passage, margin: Array) -> tuple[Array, Array]:
    """Return the shares 1 − ξ of both ways while the transfer is in place, for margins (m): S2, 1 − 44 % = 56 %."""
    gone = passage.travelled_share(tool.stroke, margin)
    return 1.0 - tool.inverted(tool.law, gone), tool.inverted(tool.out, 1.0 - gone)


def tool_angles(
    left: FreeAngles, tool: Tool, passage: Passage, margin: Array
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return the angles in and out for each margin, and whether the cycle rather than the clearance limits one."""
    rest, free = np.array(remaining_shares(tool, passage, margin)), np.array([[left.free_in], [left.free_out]])
    most = left.both * np.array([[passage.split], [1.0 - passage.split]])
    way = np.divide(free, rest, out=np.full(rest.shape, np.inf), where=rest > 0.0)
    found = np.minimum(way, most) - passage.allowance
    if found.min() <= 0.0:
        raise ValueError(f"an allowance of {math.degrees(passage.allowance):g} degrees leaves the tool no angle")
    return found[0], found[1], (way > most).any(axis=0)


def overlap(transfer: Transfer, tool: Tool, passage: Passage) -> Schedule:
    """Return the schedule with the longest ways in and out of the tool that the passage allows.

    The free angle F = 2π − effective angle − dwell is split; when the transfer comes to its place, the tool
    may have gone s = (clearance − margin)/stroke, at ξ, so the way in is F_in/(1 − ξ), less the allowance
    (S2: 70°/0.56 = 125°, 120° with the allowance of 5°). The way out is the same in reverse.
    Raises ValueError where no angle is left. Source: S2, 'Cycloid Cam Profile Analysis'.
    """
    left = free_angles(transfer, tool, passage)
    way_in, way_out, capped = tool_angles(left, tool, passage, np.array([passage.margin]))
    limit: Limit = "cycle" if capped[0] else "clearance"
    return Schedule(transfer, tool, float(way_in[0]), float(way_out[0]), left.end + left.free_in, limit)


def free_angle(occupied: float, tool: Tool) -> float:
    """Return what an occupied angle and the dwell leave of the turn (rad); raise ValueError where that is nothing."""
    free = FULL_TURN - occupied - tool.dwell
    if free <= 0.0:
        taken, dwell = math.degrees(occupied), math.degrees(tool.dwell)
        raise ValueError(f"transfer ({taken:g} degrees) and dwell ({dwell:g} degrees) leave the tool no angle of 360")
    return free


class MarginSweep(NamedTuple):
    """What a margin costs: arrays over the margins."""

    margin: Array
    angle_in: Array
    angle_out: Array
    acceleration: Array  # m/s²
    ratio: Array  # of the peak acceleration without overlap to that with it


def sweep_margin(transfer: Transfer, tool: Tool, passage: Passage, margins: ArrayLike, rate: float) -> MarginSweep:
    """Return what each margin (m), from 0 to the clearance, costs at a rate (1/s). Raises ValueError for others."""
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
"""of the clearance or the stroke: what is less below 0 is no collision, as heights are met by points of a law"""


class CriticalAngles(NamedTuple):
    """Where it can be least: the transfer gets in the way, is in place; the tool sets off, arrives, leaves, is back."""

    raw: Array  # rad, not reduced to one turn
    angle: Array  # rad, within one turn
    inside: NDArray[np.bool_]  # whether the transfer is in the way
    free: Array  # clearance (m); where the transfer is not in the way, all of it


def critical_angles(schedule: Schedule, passage: Passage) -> CriticalAngles:
    """Return the corners of the diagram."""
    begin, end = blocked_angles(schedule.transfer, passage)
    raw = np.array([begin, end, *schedule.edges])
    angle = within_turn(raw)
    inside = (angle >= begin - ANGLE_TOLERANCE) & (angle <= end + ANGLE_TOLERANCE)
    gone = np.where(inside, schedule.travel(angle), 0.0)
    return CriticalAngles(raw, angle, inside, passage.clearance - gone)


class Clearance(NamedTuple):
    """Free travel (m) between tool and transfer over the cycle."""

    allowed: Array
    """how far the tool may go at each angle: the clearance while the transfer is in the way, else its stroke"""
    free: Array  # that, less how far it has gone; below 0 they collide
    minimum: float  # while the transfer is in the way; exact, not of the samples
    collides: bool  # less than 0 is free somewhere
    meets_margin: bool


def clearance(schedule: Schedule, passage: Passage, angle: ArrayLike) -> Clearance:
    """Return what is free between the parts at angles of the master shaft (rad), and its minimum over the cycle."""
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
    """Return where tools of these strokes (m) collide, by what is free (m)."""
    return free < -COLLISION_TOLERANCE * stroke
