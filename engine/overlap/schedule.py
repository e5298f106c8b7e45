"""Both motions over one turn of the master shaft: when the tool goes in and out, how fast, where it is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws import Dwell, Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.motion import Motion
from engine.overlap.parts import Tool, Transfer, require_positive
from engine.timing import FULL_TURN, shaft_speed

Limit = Literal["clearance", "cycle"]
ANGLE_TOLERANCE = FULL_TURN * BREAK_TOLERANCE
"""rad: an angle this near to an event counts as on it"""
SHORTEST = 1e-9
"""rad: a phase of less is none"""
DWELL, OUT, REST, IN = 1, 2, 3, 4
"""the parts of a tool's cycle, from its arrival"""


class ToolState(NamedTuple):
    """What a tool does at each angle of the master shaft."""

    since: Array
    """angle since its arrival, within one turn (rad)"""
    part: NDArray[np.intp]
    """1 dwell, 2 way out, 3 rest, 4 way in"""
    xi: Array
    """abscissa of the law of its way; 0 at rest"""


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
    def ways(self) -> float:
        """The tool's angles in and out together (rad)."""
        return self.way_in + self.way_out

    @cached_property
    def motion(self) -> Motion:
        """The tool over one turn, counted from its arrival: there no movement wraps."""
        h = self.tool.stroke
        rest = FULL_TURN - self.tool.dwell - self.way_in - self.way_out
        phases = [
            (Dwell(), 0.0, self.tool.dwell),
            (self.tool.out, -h, self.way_out),
            (Dwell(), 0.0, rest),
            (self.tool.law, h, self.way_in),
        ]
        return filled_turn(phases, position=h)

    def state(self, angle: ArrayLike) -> ToolState:
        """Return what the tool does at angles of the master shaft (rad)."""
        since = turned(np.asarray(angle, dtype=np.float64) - self.arrival)
        leaves, arrives = self.tool.dwell, FULL_TURN - self.way_in
        part = 1 + np.sum([since + ANGLE_TOLERANCE >= x for x in (leaves, leaves + self.way_out, arrives)], axis=0)
        out, into = (since - leaves) / self.way_out, (since - arrives) / self.way_in
        return ToolState(since, part, np.clip(np.select([part == OUT, part == IN], [out, into], 0.0), 0.0, 1.0))

    def travel(self, angle: ArrayLike) -> Array:
        """Return how far the tool has gone (m) at any angle of the master shaft (rad)."""
        return self.motion.at((np.asarray(angle, dtype=np.float64) - self.arrival) % FULL_TURN).y

    def acceleration(self, angle: ArrayLike, rate: float) -> Array:
        """Return the tool's acceleration (m/s²) at angles of the master shaft (rad), at ``rate`` cycles per second."""
        since = np.clip(self.state(angle).since, 0.0, FULL_TURN)
        return self.motion.at_speed(since, shaft_speed(rate)).a

    def times(self, rate: float) -> tuple[float, float]:
        """Return the times (s) of the ways in and out at ``rate`` cycles per second."""
        return movement_time(self.way_in, rate), movement_time(self.way_out, rate)

    def way_peaks(self, rate: float) -> tuple[float, float]:
        """Return the largest accelerations of the ways in and out, C_a h/t_m², in m/s².

        Source: S2, 'Cycloid Cam Profile Analysis', a_max = 2π h_m/t_m² (cycloidal).
        """
        peaks = [
            law.coefficients.ca * self.tool.stroke / time**2
            for law, time in zip((self.tool.law, self.tool.out), self.times(rate), strict=True)
        ]
        return peaks[0], peaks[1]

    def peak_acceleration(self, rate: float) -> float:
        """Return the tool's largest acceleration in m/s², at ``rate`` cycles per second."""
        return max(self.way_peaks(rate))

    def times_lower(self, before: Schedule) -> float:
        """Return how many times lower its peak acceleration is than that of another schedule, at any rate.

        Source: S2, 4.154/0.804 = 5.17.
        """
        return before.peak_acceleration(1.0) / self.peak_acceleration(1.0)


def movement_time(angle: float, rate: float) -> float:
    """Return t_m = B_m/(2π n), in s, of an angle (rad) at n cycles per second (S2: t_m = 10 B_m/N, in degrees and 1/h).

    Raises ValueError unless both are above 0.
    """
    require_positive(angle=angle, rate=rate)
    return angle / (FULL_TURN * rate)


def turned(angle: Array) -> Array:
    """Return angles (rad) within one turn; what is just below a whole turn counts as on it."""
    return angle - FULL_TURN * np.floor(angle / FULL_TURN + BREAK_TOLERANCE)


def filled_turn(phases: list[tuple[Law, float, float]], position: float = 0.0) -> Motion:
    """Return the motion of these phases over one turn, without those of no length, filled up with a dwell."""
    kept = [phase for phase in phases if phase[2] > SHORTEST]
    edges = np.cumsum([0.0, *(duration for _, _, duration in kept)])
    if edges[-1] > FULL_TURN + SHORTEST:
        raise ValueError(f"the movements take {math.degrees(edges[-1]):g} degrees; expected at most 360")
    if edges[-1] < FULL_TURN - SHORTEST:
        kept.append((Dwell(), 0.0, FULL_TURN - float(edges[-1])))
        edges = np.append(edges, FULL_TURN)
    edges[-1] = FULL_TURN
    return Motion.from_edges(edges, [lift for _, lift, _ in kept], [law for law, _, _ in kept], position)
