"""A transfer that brings the work, a tool, and the motions of both over a turn of the master shaft."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.chain import require_positive
from engine.laws import Dwell, Law
from engine.laws.base import BREAK_TOLERANCE, Array, require_finite
from engine.laws.inverse import inverse
from engine.motion import Motion
from engine.motion.pieces import MotionPiece, ScaledLaw
from engine.timing import FULL_TURN, shaft_speed

Limit = Literal["clearance", "cycle"]
ANGLE_TOLERANCE = FULL_TURN * BREAK_TOLERANCE  # rad: an angle this near to an event counts as on it
Inverse = Callable[[Law, Array], Array]  # ξ at which a law reaches heights: exact, or by points


@dataclass(frozen=True)
class Transfer:
    """The motion that brings the work, once a cycle from 0. Raises ValueError for figures outside the limits below."""

    law: Law
    stroke: float  # m, above 0
    angle: float  # of the movement (rad), above 0 and below 2π
    inverted: Inverse = inverse

    def __post_init__(self) -> None:
        require_positive("transfer", stroke=self.stroke, angle=self.angle)
        if self.angle >= FULL_TURN:
            raise ValueError(f"the transfer takes {math.degrees(self.angle):g} degrees; expected less than 360")

    def travel(self, angle: Array) -> Array:
        """Return its travel h_t s(ξ) (m) at angles from 0 to 2π; ξ is 1 from its arrival to the end of the cycle."""
        return self.stroke * self.law.s(np.minimum(angle / self.angle, 1.0))

    @property
    def parts(self) -> tuple[ScaledLaw, ScaledLaw]:
        """The movement, and the dwell to the end of the cycle (m, rad)."""
        moves = ScaledLaw(self.law, self.stroke, self.angle)
        return moves, ScaledLaw(Dwell(), 0.0, FULL_TURN - self.angle, self.angle, self.stroke * self.law.end.s)


@dataclass(frozen=True)
class Tool:
    """The motion of a tool: in, dwell at the part, out. Raises ValueError for figures outside the limits below."""

    law: Law  # of the way in
    stroke: float  # m, above 0
    dwell: float  # angle at the part (rad), 0 or more
    law_out: Law | None = None  # of the way out; None: that of the way in
    inverted: Inverse = inverse

    def __post_init__(self) -> None:
        require_positive("tool", stroke=self.stroke)
        require_finite(dwell=self.dwell)
        if self.dwell < 0.0:
            raise ValueError(f"the tool dwells for {math.degrees(self.dwell):g} degrees; expected 0 or more")

    @property
    def out(self) -> Law:
        """The law of the way out."""
        return self.law if self.law_out is None else self.law_out


@dataclass(frozen=True)
class Passage:
    """The free space between transfer and tool. Raises ValueError for figures outside the limits below."""

    remaining: float  # share of the transfer's stroke, at both ends, in which the tool may be in; 0 to ½ (S2: 0.65 %)
    clearance: float  # travel (m) of the tool before it would touch the transfer (S2: 20 mm)
    # part of the clearance that must stay free (m); 0 to the clearance (S2: 1 mm)
    margin: float = 0.0
    allowance: float = 0.0  # subtracted from the tool's angles for the setting of the cam (rad); 0 or more (S2: 5°)
    split: float = 0.5  # share of the free angle for the way in, between 0 and 1

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

    @property
    def shares(self) -> tuple[float, float]:
        """The shares of its stroke between which the transfer is in the way."""
        return self.remaining, 1.0 - self.remaining

    def travelled_share(self, stroke: float, margin: ArrayLike) -> Array:
        """Return the allowed travel of a tool as a share of its stroke (m), at most 1: S2, s = (20 − 1)/50 = 0.38."""
        return np.minimum((self.clearance - np.asarray(margin, dtype=np.float64)) / stroke, 1.0)


@dataclass(eq=False)
class Schedule:
    """The motion of a tool over a turn of the master shaft (rad)."""

    tool: Tool
    angle_in: float  # of the way in
    angle_out: float  # of the way out
    arrival: float  # angle at which the tool reaches the part
    limit: Limit = "clearance"  # why the tool cannot take longer

    def __post_init__(self) -> None:
        h, dwell, out, into = self.tool.stroke, self.tool.dwell, self.angle_out, self.angle_in
        leaves = self.arrival + dwell
        # angles at which the tool sets off, arrives, leaves and is back; not reduced to a turn
        self.edges = self.arrival - into, self.arrival, leaves, leaves + out
        stays, rests = (angle if angle > ANGLE_TOLERANCE else 0.0 for angle in (dwell, FULL_TURN - dwell - into - out))
        # from the tool's arrival (m, rad); a dwell or rest shorter than the tolerance counts as 0
        self.parts = (
            ScaledLaw(Dwell(), 0.0, stays, 0.0, h),
            ScaledLaw(self.tool.out, -h, out, dwell, h),
            ScaledLaw(Dwell(), 0.0, rests, dwell + out),
            ScaledLaw(self.tool.law, h, into, FULL_TURN - into),
        )

    @cached_property
    def motion(self) -> Motion:
        """The tool over a turn from its arrival, so that no movement runs over the end of the cycle."""
        return whole_turn(self.parts, self.tool.stroke)

    def since(self, angle: ArrayLike) -> Array:
        """Return the angles (rad) since the tool's arrival, within a turn, at angles of the master shaft (rad)."""
        return within_turn(np.asarray(angle, dtype=np.float64) - self.arrival)

    def travel(self, angle: ArrayLike) -> Array:
        """Return the tool's travel (m) at any angle of the master shaft (rad)."""
        return self.motion.at((np.asarray(angle, dtype=np.float64) - self.arrival) % FULL_TURN).y

    def rates(self, angle: ArrayLike, rate: float) -> tuple[Array, Array, Array]:
        """Return the tool's velocity, acceleration and jerk (m/s, m/s², m/s³) at angles (rad) and a rate (1/s)."""
        at, speed = self.motion.at(np.clip(self.since(angle), 0.0, FULL_TURN)), shaft_speed(rate)
        return at.y1 * speed, at.y2 * speed**2, at.y3 * speed**3

    def times(self, rate: float) -> tuple[float, float]:
        """Return the times (s) of the ways in and out at a rate (1/s)."""
        return movement_time(self.angle_in, rate), movement_time(self.angle_out, rate)

    def movement_peaks(self, rate: float) -> tuple[float, float]:
        """Return the peak accelerations C_a h/t_m² (m/s²) of the ways in and out at a rate (1/s); S2: 2π h_m/t_m²."""
        h, (way_in, way_out) = self.tool.stroke, self.times(rate)
        return self.tool.law.coefficients.ca * h / way_in**2, self.tool.out.coefficients.ca * h / way_out**2

    def peak_acceleration(self, rate: float) -> float:
        """Return the tool's peak acceleration (m/s²) at a rate (1/s)."""
        return max(self.movement_peaks(rate))

    def times_lower(self, before: "Schedule") -> float:
        """Return the peak acceleration of another schedule over its own, the same at any rate (S2: 4.154/0.804)."""
        return before.peak_acceleration(1.0) / self.peak_acceleration(1.0)


def movement_time(angle: float, rate: float) -> float:
    """Return t_m = B_m/(2π n) (s) of an angle (rad) at a rate n (1/s), both above 0; S2: 10 B_m/N in ° and 1/h."""
    require_positive("movement", angle=angle, rate=rate)
    return angle / (FULL_TURN * rate)


def pieces_of_parts(parts: Sequence[ScaledLaw], whole: bool = False) -> list[MotionPiece]:
    """Return the pieces of the parts of any duration; ``whole`` ones are not cut at peaks of the acceleration."""
    return [piece for k, part in enumerate(parts) if part.duration for piece in part.pieces(k, whole)]


def size_of_parts(parts: Sequence[ScaledLaw]) -> Callable[[int], float]:
    """Return the function of n that gives the largest |h|/δⁿ of the parts that move."""
    moving = [(abs(part.h), part.rate) for part in parts if part.h]
    return lambda order: max(h * rate**order for h, rate in moving)


def within_turn(angle: Array) -> Array:
    """Return angles (rad) reduced to a turn; an angle just below a full turn counts as 0."""
    return angle - FULL_TURN * np.floor(angle / FULL_TURN + BREAK_TOLERANCE)


def whole_turn(parts: Sequence[ScaledLaw], position: float = 0.0) -> Motion:
    """Return the motion of the parts of any duration, which fill a turn; raise ValueError if they take more."""
    lasting = [part for part in parts if part.duration > 0.0]
    edges = np.cumsum([0.0, *(part.duration for part in lasting)])
    if edges[-1] > FULL_TURN + ANGLE_TOLERANCE:
        raise ValueError(f"the movements take {math.degrees(edges[-1]):g} degrees; expected at most 360")
    edges[-1] = FULL_TURN
    return Motion.from_edges(edges, [part.h for part in lasting], [part.law for part in lasting], position)
