"""Schedules of transfer and tool: in succession, and overlapping as far as the passage allows."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array
from engine.laws.inverse import HEIGHT
from engine.overlap.schedule import ANGLE_TOLERANCE, Limit, Passage, Schedule, Tool, Transfer, within_turn
from engine.timing import FULL_TURN


class FreeAngles(NamedTuple):
    """Angles that a transfer and the passage leave for the tool's movements (rad)."""

    begin: float  # where the transfer begins to be in the way (S2: 15°)
    end: float  # where it ceases to be (S2: 135°)
    free_in: float  # F_in, for the way in while the transfer is not in the way (S2: 140°/2 = 70°)
    free_out: float  # likewise for the way out
    both: float  # the turn less the tool's dwell, for both ways at most


class MarginSweep(NamedTuple):
    """The overlapping schedule against the margin, arrays of equal shape."""

    margin: Array  # m
    angle_in: Array  # rad
    angle_out: Array  # rad
    acceleration: Array  # peak of the tool (m/s²)
    ratio: Array  # of the peak without overlap to that with it


COLLISION_TOLERANCE = HEIGHT
"""share of the clearance or the stroke by which free travel may be below 0: the inverse by points is no more exact"""


class CriticalAngles(NamedTuple):
    """Angles of the least free travel: transfer into and out of the way, tool off, arrived, leaving and back."""

    raw: Array  # rad, not reduced to a turn
    angle: Array  # rad, within a turn
    inside: NDArray[np.bool_]  # whether the transfer is in the way
    free: Array  # free travel (m); the clearance if the transfer is not in the way


class Clearance(NamedTuple):
    """Free travel (m) between tool and transfer over the cycle."""

    allowed: Array  # travel allowed at each angle: the clearance while the transfer is in the way, else the stroke
    free: Array  # the allowed less the tool's travel; below 0 they collide
    minimum: float  # while the transfer is in the way; exact, not of the samples
    collides: bool  # whether the minimum is below 0
    meets_margin: bool  # whether the minimum is at least the margin


@dataclass(frozen=True)
class Station:
    """A tool at a station of a transfer: its schedules, and what is free between both. Source: S2.

    Each result raises ValueError where transfer, dwell and allowance leave the tool no angle.
    """

    transfer: Transfer
    tool: Tool
    passage: Passage

    def one_after_the_other(self) -> Schedule:
        """Return the schedule without overlap: the tool moves while the transfer rests; S2: (360 − 250)/2 = 55°."""
        split, moved = self.passage.split, self.transfer.angle
        free = self._free(moved)
        return Schedule(self.tool, free * split, free * (1.0 - split), moved + free * split)

    def overlapping(self) -> Schedule:
        """Return the schedule with the longest ways in and out of the tool that the passage allows.

        The free angle F = 2π − (angle with the transfer in the way) − dwell is split. When the transfer leaves the way,
        the tool may have gone s = (clearance − margin)/stroke, at ξ, so the way in is F_in/(1 − ξ), less the allowance
        (S2: 70°/0.56 = 125°, 120° with the allowance of 5°). The way out is the same in reverse.
        """
        way_in, way_out, capped = self._ways(np.array([self.passage.margin]))
        limit: Limit = "cycle" if capped[0] else "clearance"
        arrival = self.left.end + self.left.free_in
        return Schedule(self.tool, float(way_in[0]), float(way_out[0]), arrival, limit)

    @cached_property
    def left(self) -> FreeAngles:
        """The angles left for the tool."""
        at = self.transfer.inverted(self.transfer.law, np.array(self.passage.shares)) * self.transfer.angle
        begin, end = at.tolist()
        free, split = self._free(end - begin), self.passage.split
        return FreeAngles(begin, end, free * split, free * (1.0 - split), FULL_TURN - self.tool.dwell)

    def remaining_shares(self, margin: Array) -> tuple[Array, Array]:
        """Return the shares 1 − ξ of the ways in and out in the free angles, for margins (m): S2, 1 − 44 %."""
        gone = self.passage.travelled_share(self.tool.stroke, margin)
        return 1.0 - self.tool.inverted(self.tool.law, gone), self.tool.inverted(self.tool.out, 1.0 - gone)

    def sweep(self, margins: ArrayLike, rate: float) -> MarginSweep:
        """Return the schedule at each margin (m) and a rate (1/s). Raises ValueError outside 0 to the clearance."""
        margin = np.asarray(margins, dtype=np.float64)
        for extreme in (margin.min(), margin.max()):
            replace(self.passage, margin=float(extreme))
        way_in, way_out, _ = self._ways(margin)
        scale = self.tool.stroke * (FULL_TURN * rate) ** 2
        pairs = (self.tool.law, way_in), (self.tool.out, way_out)
        acceleration = np.maximum(*(law.coefficients.ca * scale / way**2 for law, way in pairs))
        before = self.one_after_the_other().peak_acceleration(rate)
        return MarginSweep(margin, way_in, way_out, acceleration, before / acceleration)

    def critical_angles(self, schedule: Schedule) -> CriticalAngles:
        """Return the angles at which the free travel of a schedule of transfer and tool can be least."""
        raw = np.array([self.left.begin, self.left.end, *schedule.edges])
        angle = within_turn(raw)
        inside = (angle >= self.left.begin - ANGLE_TOLERANCE) & (angle <= self.left.end + ANGLE_TOLERANCE)
        gone = np.where(inside, schedule.travel(angle), 0.0)
        return CriticalAngles(raw, angle, inside, self.passage.clearance - gone)

    def clearance(self, schedule: Schedule, angle: ArrayLike) -> Clearance:
        """Return the free travel of a schedule at angles of the master shaft (rad), and its minimum over the cycle."""
        at = np.asarray(angle, dtype=np.float64)
        turned_at = at % FULL_TURN
        away = (turned_at > self.left.begin + ANGLE_TOLERANCE) & (turned_at < self.left.end - ANGLE_TOLERANCE)
        allowed = np.where(away, self.passage.clearance, self.tool.stroke)
        minimum = float(self.critical_angles(schedule).free.min())
        tolerance = COLLISION_TOLERANCE * max(self.passage.clearance, self.tool.stroke)
        free = allowed - schedule.travel(at)
        return Clearance(allowed, free, minimum, minimum < -tolerance, minimum >= self.passage.margin - tolerance)

    def _free(self, occupied: float) -> float:
        """Return the turn less an occupied angle and the tool's dwell (rad)."""
        free = FULL_TURN - occupied - self.tool.dwell
        if free <= 0.0:
            taken, dwell = math.degrees(occupied), math.degrees(self.tool.dwell)
            message = f"transfer ({taken:g} degrees) and dwell ({dwell:g} degrees) leave the tool no angle of 360"
            raise ValueError(message)
        return free

    def _ways(self, margin: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Return the tool's angles in and out (rad) for margins (m), and whether the cycle limits any of them."""
        rest, split = np.array(self.remaining_shares(margin)), self.passage.split
        free, most = (
            np.array([[self.left.free_in], [self.left.free_out]]),
            self.left.both * np.array([[split], [1.0 - split]]),
        )
        way = np.divide(free, rest, out=np.full(rest.shape, np.inf), where=rest > 0.0)
        ways = np.minimum(way, most) - self.passage.allowance
        if ways.min() <= 0.0:
            raise ValueError(
                f"an allowance of {math.degrees(self.passage.allowance):g} degrees leaves the tool no angle"
            )
        return ways[0], ways[1], (way > most).any(axis=0)


def colliding(free: Array, stroke: Array) -> NDArray[np.bool_]:
    """Return whether tools of these strokes (m) collide at a free travel (m)."""
    return free < -COLLISION_TOLERANCE * stroke
