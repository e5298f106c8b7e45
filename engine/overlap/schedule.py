"""Both motions over one turn of the master shaft: when the tool goes in and out, how fast, where it is."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws import Dwell, Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.motion import Motion
from engine.motion.pieces import MotionPiece, Scaled, pieces_of
from engine.overlap.parts import Tool, Transfer, require_positive
from engine.timing import FULL_TURN, shaft_speed

Limit = Literal["clearance", "cycle"]
ANGLE_TOLERANCE = FULL_TURN * BREAK_TOLERANCE  # rad: an angle this near to an event counts as on it


class Rates(NamedTuple):
    """Velocity (m/s), acceleration (m/s²) and jerk (m/s³) of a tool."""

    velocity: Array
    acceleration: Array
    jerk: Array


@dataclass(frozen=True)
class Schedule:
    """Both motions over one turn of the master shaft.

    ``way_in`` and ``way_out`` are the tool's angles, ``arrival`` the angle at which it is at the part;
    ``limit`` says what keeps the tool from taking longer.
    """

    transfer: Transfer
    tool: Tool
    angle_in: float
    angle_out: float
    arrival: float
    limit: Limit = "clearance"

    @property
    def edges(self) -> tuple[float, float, float, float]:
        """Angles at which the tool sets off, arrives, leaves and is back; not reduced to one turn."""
        leaves = self.arrival + self.tool.dwell
        return self.arrival - self.angle_in, self.arrival, leaves, leaves + self.angle_out

    @property
    def angles(self) -> float:
        """The tool's angles in and out together (rad)."""
        return self.angle_in + self.angle_out

    @cached_property
    def motion(self) -> Motion:
        """The tool over one turn, counted from its arrival: there no movement wraps."""
        phases = [(part.law, part.h, part.duration) for part in self.parts]
        return filled_turn(phases, position=self.tool.stroke)

    @property
    def parts(self) -> tuple[Scaled, Scaled, Scaled, Scaled]:
        """Dwell, way out, rest and way in (m, rad) from the tool's arrival; below the tolerance of an angle none."""
        h, dwell, out, into = self.tool.stroke, self.tool.dwell, self.angle_out, self.angle_in
        rest = FULL_TURN - dwell - into - out
        return (
            Scaled(Dwell(), 0.0, lasting(dwell), 0.0, h),
            Scaled(self.tool.out, -h, out, dwell, h),
            Scaled(Dwell(), 0.0, lasting(rest), dwell + out),
            Scaled(self.tool.law, h, into, FULL_TURN - into),
        )

    @property
    def pieces(self) -> list[MotionPiece]:
        """The same motion as pieces."""
        return pieces_of_parts(self.parts)

    def since(self, angle: ArrayLike) -> Array:
        """Return the angles since the tool's arrival, within one turn, at angles of the master shaft (rad)."""
        return turned(np.asarray(angle, dtype=np.float64) - self.arrival)

    def travel(self, angle: ArrayLike) -> Array:
        """Return how far the tool has gone (m) at any angle of the master shaft (rad)."""
        return self.motion.at((np.asarray(angle, dtype=np.float64) - self.arrival) % FULL_TURN).y

    def rates(self, angle: ArrayLike, rate: float) -> Rates:
        """Return the tool's velocity, acceleration and jerk at angles (rad), at ``rate`` cycles per second."""
        at, speed = self.motion.at(np.clip(self.since(angle), 0.0, FULL_TURN)), shaft_speed(rate)
        return Rates(at.y1 * speed, at.y2 * speed**2, at.y3 * speed**3)

    def times(self, rate: float) -> tuple[float, float]:
        """Return the times (s) of the ways in and out at ``rate`` cycles per second."""
        return movement_time(self.angle_in, rate), movement_time(self.angle_out, rate)

    def movement_peaks(self, rate: float) -> tuple[float, float]:
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
        return max(self.movement_peaks(rate))

    def times_lower(self, before: "Schedule") -> float:
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


def lasting(angle: float) -> float:
    """Return an angle (rad), 0 for one that is next to none."""
    return angle if angle > ANGLE_TOLERANCE else 0.0


def pieces_of_parts(parts: Sequence[Scaled], whole: bool = False) -> list[MotionPiece]:
    """Return the pieces of the parts that last; ``whole`` ones are not cut where the acceleration is largest."""
    return [piece for k, part in enumerate(parts) if part.duration for piece in pieces_of(part, k, whole)]


def size_of_parts(parts: Sequence[Scaled]) -> Callable[[int], float]:
    """Return what gives, for n, the largest |h|/δⁿ of the parts that move."""
    moving = [(abs(part.h), part.rate) for part in parts if part.h]
    return lambda order: max(h * rate**order for h, rate in moving)


def turned(angle: Array) -> Array:
    """Return angles (rad) within one turn; what is just below a whole turn counts as on it."""
    return angle - FULL_TURN * np.floor(angle / FULL_TURN + BREAK_TOLERANCE)


def filled_turn(phases: list[tuple[Law, float, float]], position: float = 0.0) -> Motion:
    """Return the motion of these phases over one turn, without those of no length, filled up with a dwell."""
    kept = [phase for phase in phases if phase[2] > 0.0]
    edges = np.cumsum([0.0, *(duration for _, _, duration in kept)])
    if edges[-1] > FULL_TURN + ANGLE_TOLERANCE:
        raise ValueError(f"the movements take {math.degrees(edges[-1]):g} degrees; expected at most 360")
    if edges[-1] < FULL_TURN - ANGLE_TOLERANCE:
        kept.append((Dwell(), 0.0, FULL_TURN - float(edges[-1])))
        edges = np.append(edges, FULL_TURN)
    edges[-1] = FULL_TURN
    return Motion.from_edges(edges, [lift for _, lift, _ in kept], [law for law, _, _ in kept], position)
