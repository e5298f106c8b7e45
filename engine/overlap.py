"""Overlap of two motions: how much longer the second may take when it begins before the first has ended.

A transfer (S2: the indexing mill) brings the part; a tool (S2: the die) enters when the part is there, dwells,
and is out before the next transfer. Angles are of the master shaft, in rad; the transfer begins at 0. Tools at several
stations are as many schedules over the same transfer: each meets the transfer, none another tool.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws import Dwell, Law
from engine.laws.base import Array, require_finite
from engine.laws.inverse import inverse
from engine.motion import Motion
from engine.timing import FULL_TURN, Axis, Diagram

Limit = Literal["clearance", "cycle"]
ROUNDING = 1e-9  # of the clearance


@dataclass(frozen=True)
class Transfer:
    """The first motion: a law over ``stroke`` (m) in ``angle`` (rad), once a cycle, beginning at 0.

    Raises ValueError unless the stroke is above 0 and the angle between 0 and 2π.
    """

    law: Law
    stroke: float
    angle: float

    def __post_init__(self) -> None:
        _require_positive(transfer_stroke=self.stroke, transfer_angle=self.angle)
        if self.angle >= FULL_TURN:
            raise ValueError(f"the transfer takes {math.degrees(self.angle):g} degrees; expected less than 360")


@dataclass(frozen=True)
class Tool:
    """The second motion: in over ``stroke`` (m), at the part for the angle ``dwell`` (rad), out again.

    ``law_out`` is the law of the way out, that of the way in if None.
    Raises ValueError unless the stroke is above 0 and the dwell at least 0.
    """

    law: Law
    stroke: float
    dwell: float
    law_out: Law | None = None

    def __post_init__(self) -> None:
        _require_positive(tool_stroke=self.stroke)
        require_finite(dwell=self.dwell)
        if self.dwell < 0.0:
            raise ValueError(f"the tool dwells for {math.degrees(self.dwell):g} degrees; expected 0 or more")

    @property
    def out(self) -> Law:
        """The law of the way out."""
        return self.law if self.law_out is None else self.law_out


@dataclass(frozen=True)
class Passage:
    """What one part leaves to the other.

    ``remaining``: share of the transfer's stroke that may be missing, at either end, while the tool is in
    (S2: 0.65 %). ``clearance`` (m): travel of the tool before it would touch the transfer (S2: 20 mm).
    ``margin`` (m): what of it is to stay free (S2: 1 mm). ``allowance`` (rad): taken off the tool's angles
    for the setting of the cam (S2: 5°). ``split``: share of the free angle for the way in.
    Raises ValueError unless 0 ≤ remaining < 1/2, 0 ≤ margin ≤ clearance, allowance ≥ 0 and 0 < split < 1.
    """

    remaining: float
    clearance: float
    margin: float = 0.0
    allowance: float = 0.0
    split: float = 0.5

    def __post_init__(self) -> None:
        require_finite(clearance=self.clearance, margin=self.margin, allowance=self.allowance)
        if not 0.0 <= self.remaining < 0.5:
            raise ValueError(f"remaining is {self.remaining:g} of the stroke; expected at least 0 and less than 0.5")
        if not 0.0 <= self.margin <= self.clearance:
            raise ValueError(f"margin is {self.margin:g} m; expected 0 to the clearance, {self.clearance:g} m")
        if self.allowance < 0.0:
            raise ValueError(f"allowance is {math.degrees(self.allowance):g} degrees; expected 0 or more")
        if not 0.0 < self.split < 1.0:
            raise ValueError(f"split is {self.split:g}; expected more than 0 and less than 1")


class Positions(NamedTuple):
    """Travel of the transfer and of the tool, in m, from where each begins."""

    transfer: Array
    tool: Array


@dataclass(frozen=True)
class Schedule:
    """Both motions over one turn of the master shaft.

    ``way_in`` and ``way_out`` are the tool's angles, ``arrival`` the angle at which it is at the part;
    ``limit`` says what keeps the tool from taking longer.
    """

    transfer: Transfer
    tool: Tool
    way_in: float
    way_out: float
    arrival: float
    limit: Limit = "clearance"

    @property
    def edges(self) -> tuple[float, float, float, float]:
        """Angles at which the tool sets off, arrives, leaves and is back; not reduced to one turn."""
        leaves = self.arrival + self.tool.dwell
        return self.arrival - self.way_in, self.arrival, leaves, leaves + self.way_out

    @property
    def diagram(self) -> Diagram:
        """The timing diagram, its angle counted from the tool's arrival: there no movement wraps."""
        offset = (FULL_TURN - self.arrival) % FULL_TURN
        feed = _motion([(Dwell(), 0.0, offset), (self.transfer.law, self.transfer.stroke, self.transfer.angle)])
        return Diagram([Axis("transfer", feed, feed=True), Axis("tool", self._tool_motion)])

    @property
    def _tool_motion(self) -> Motion:
        h = self.tool.stroke
        rest = FULL_TURN - self.tool.dwell - self.way_in - self.way_out
        phases = [
            (Dwell(), 0.0, self.tool.dwell),
            (self.tool.out, -h, self.way_out),
            (Dwell(), 0.0, rest),
            (self.tool.law, h, self.way_in),
        ]
        return _motion(phases, position=h)

    def positions(self, angle: ArrayLike) -> Positions:
        """Return the travel of both parts at any angle of the master shaft (rad); the transfer's of one cycle."""
        at = np.asarray(angle, dtype=np.float64)
        feed = _motion([(self.transfer.law, self.transfer.stroke, self.transfer.angle)])
        return Positions(feed.at(at % FULL_TURN).y, self._tool_motion.at((at - self.arrival) % FULL_TURN).y)

    def peak_acceleration(self, rate: float) -> float:
        """Return the tool's largest acceleration, C_a h/t_m², in m/s², at ``rate`` cycles per second.

        Source: S2, 'Cycloid Cam Profile Analysis', a_max = 2π h_m/t_m² (cycloidal).
        """
        ways = ((self.tool.law, self.way_in), (self.tool.out, self.way_out))
        return max(law.coefficients.ca * self.tool.stroke / movement_time(angle, rate) ** 2 for law, angle in ways)


def movement_time(angle: float, rate: float) -> float:
    """Return t_m = B_m/(2π n), in s, of an angle (rad) at n cycles per second (S2: t_m = 10 B_m/N, in degrees and 1/h).

    Raises ValueError unless both are above 0.
    """
    _require_positive(angle=angle, rate=rate)
    return angle / (FULL_TURN * rate)


def one_after_the_other(transfer: Transfer, tool: Tool, split: float = 0.5) -> Schedule:
    """Return the schedule without overlap: in, dwell and out in what the transfer leaves of the turn.

    Raises ValueError where nothing is left. Source: S2, (360 − 150 − 100)/2 = 55°.
    """
    free = _free(transfer.angle, tool)
    return Schedule(transfer, tool, free * split, free * (1.0 - split), transfer.angle + free * split)


def blocked(transfer: Transfer, passage: Passage) -> tuple[float, float]:
    """Return the angles (rad) between which the transfer is too far from its ends for the tool to be in.

    Their difference is S2's effective angle: 150° − 2 · 15° = 120°.
    """
    share = np.array([passage.remaining, 1.0 - passage.remaining])
    begin, end = inverse(transfer.law, share) * transfer.angle
    return float(begin), float(end)


def overlap(transfer: Transfer, tool: Tool, passage: Passage) -> Schedule:
    """Return the schedule with the longest ways in and out of the tool that the passage allows.

    The free angle F = 2π − effective angle − dwell is split; when the transfer comes to its place, the tool
    may have gone s = (clearance − margin)/stroke, at ξ, so the way in is F_in/(1 − ξ), less the allowance
    (S2: 70°/0.56 = 125°, 120° with the allowance of 5°). The way out is the same in reverse.
    Raises ValueError where no angle is left. Source: S2, 'Cycloid Cam Profile Analysis'.
    """
    begin, end = blocked(transfer, passage)
    free = _free(end - begin, tool)
    way_in, way_out, capped = _ways(free, tool, passage, np.array([passage.margin]))
    if min(way_in[0], way_out[0]) <= 0.0:
        raise ValueError(f"an allowance of {math.degrees(passage.allowance):g} degrees leaves the tool no angle")
    arrival = end + free * passage.split
    limit: Limit = "cycle" if capped[0] else "clearance"
    return Schedule(transfer, tool, float(way_in[0]), float(way_out[0]), arrival, limit)


class Clearance(NamedTuple):
    """Free travel (m) between tool and transfer over the cycle."""

    free: Array
    """at each angle; infinite while the transfer is in place, where the tool may be in"""
    minimum: float
    """exact, not of the samples"""
    collides: bool
    """less than 0 is free somewhere"""
    keeps_margin: bool


def clearance(schedule: Schedule, passage: Passage, angle: ArrayLike) -> Clearance:
    """Return what is free between the parts at angles of the master shaft (rad), and its minimum over the cycle."""
    at = np.asarray(angle, dtype=np.float64)
    begin, end = blocked(schedule.transfer, passage)
    turned = at % FULL_TURN
    away = (turned > begin) & (turned < end)
    free = np.where(away, passage.clearance - schedule.positions(at).tool, np.inf)
    corners = np.array([begin, end, *(edge % FULL_TURN for edge in schedule.edges)])
    inside = corners[(corners >= begin) & (corners <= end)]
    minimum = passage.clearance - float(schedule.positions(inside).tool.max())
    tolerance = ROUNDING * max(passage.clearance, schedule.tool.stroke)
    return Clearance(free, minimum, minimum < -tolerance, minimum >= passage.margin - tolerance)


class MarginSweep(NamedTuple):
    """What a margin costs: arrays over the margins."""

    margin: Array
    way_in: Array
    way_out: Array
    acceleration: Array
    """m/s²"""
    ratio: Array
    """of the peak acceleration without overlap to that with it"""


def sweep_margin(transfer: Transfer, tool: Tool, passage: Passage, margins: ArrayLike, rate: float) -> MarginSweep:
    """Return the tool's angles, peak acceleration and gain for each margin (m), at ``rate`` cycles per second.

    Raises ValueError where a margin is not from 0 to the clearance, or no angle is left.
    """
    margin = np.asarray(margins, dtype=np.float64)
    for extreme in (margin.min(), margin.max()):
        replace(passage, margin=float(extreme))
    begin, end = blocked(transfer, passage)
    way_in, way_out, _ = _ways(_free(end - begin, tool), tool, passage, margin)
    if min(way_in.min(), way_out.min()) <= 0.0:
        raise ValueError(f"an allowance of {math.degrees(passage.allowance):g} degrees leaves the tool no angle")
    scale = tool.stroke * (FULL_TURN * rate) ** 2
    peaks = [law.coefficients.ca * scale / way**2 for law, way in ((tool.law, way_in), (tool.out, way_out))]
    acceleration = np.maximum(*peaks)
    before = one_after_the_other(transfer, tool, passage.split).peak_acceleration(rate)
    return MarginSweep(margin, way_in, way_out, acceleration, before / acceleration)


def _free(occupied: float, tool: Tool) -> float:
    free = FULL_TURN - occupied - tool.dwell
    if free <= 0.0:
        taken, dwell = math.degrees(occupied), math.degrees(tool.dwell)
        raise ValueError(f"transfer ({taken:g} degrees) and dwell ({dwell:g} degrees) leave the tool no angle of 360")
    return free


def _ways(free: float, tool: Tool, passage: Passage, margin: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return the angles in and out for each margin, and whether the cycle rather than the clearance limits one."""
    gone = np.minimum((passage.clearance - margin) / tool.stroke, 1.0)
    rest_in = 1.0 - inverse(tool.law, gone)
    rest_out = inverse(tool.out, 1.0 - gone)
    room = FULL_TURN - tool.dwell
    found, capped = [], np.zeros(margin.shape, dtype=np.bool_)
    for share, rest in ((passage.split, rest_in), (1.0 - passage.split, rest_out)):
        way = np.divide(free * share, rest, out=np.full(rest.shape, np.inf), where=rest > 0.0)
        capped |= way > room * share
        found.append(np.minimum(way, room * share) - passage.allowance)
    return found[0], found[1], capped


def _motion(phases: list[tuple[Law, float, float]], position: float = 0.0) -> Motion:
    """Return the motion of these phases over one turn, without those of no length, filled up with a dwell."""
    kept = [phase for phase in phases if phase[2] > ROUNDING]
    edges = np.cumsum([0.0, *(duration for _, _, duration in kept)])
    if edges[-1] > FULL_TURN + ROUNDING:
        raise ValueError(f"the movements take {math.degrees(edges[-1]):g} degrees; expected at most 360")
    if edges[-1] < FULL_TURN - ROUNDING:
        kept.append((Dwell(), 0.0, FULL_TURN - float(edges[-1])))
        edges = np.append(edges, FULL_TURN)
    edges[-1] = FULL_TURN
    return Motion.from_edges(edges, [lift for _, lift, _ in kept], [law for law, _, _ in kept], position)


def _require_positive(**quantities: float) -> None:
    for name, value in quantities.items():
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{name.replace('_', ' ')} is {value:g}; expected a finite number above 0")
