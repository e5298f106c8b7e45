"""A drive at points of its cycle: the ends of each interval of its motion, and fixed shares between. SI units.

An interval is a piece of the motion, or what lies of it between edges of process forces. Peaks are those of the points,
corrected by the parabola through the largest and its neighbours; means are weighted sums (rule of Gauss and Lobatto).
Exact at constant ratio without viscous friction for peaks, where the acceleration is monotone in each piece; else right
to the bound that the sheets state. :class:`engine.drive.results.DriveResults` is the exact way.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain, dwell_times
from engine.laws.base import Array
from engine.laws.points import POINTS, SHARES, WEIGHTS
from engine.motion.pieces import CamProfile, MotionPiece

STANDSTILL = 1e-9  # of the greatest speed: a slower load stands


class Interval(NamedTuple):
    """A part of a cycle of one piece (a number from 0) and steady process forces, in the unshifted abscissa."""

    begin: float
    end: float
    piece: int

    @property
    def middle(self) -> float:
        """The point in its middle."""
        return (self.begin + self.end) / 2.0


@dataclass(frozen=True)
class LoadPoints:
    """A load and the mechanism's shaft at the points of a cycle: arrays of intervals by points."""

    train: Drivetrain
    x: Array
    position: Array  # of the load (m or rad)
    velocity: Array  # of the load (m or rad, per s)
    acceleration: Array  # of the load (per s²)
    direction: Array  # 1, −1, or 0 at rest
    steady: Array  # resists always (N or Nm)
    friction: Array  # resists motion (N or Nm)
    first: Array  # φ' of the mechanism
    second: Array  # φ''
    share: Array  # what a point counts in a mean over the cycle
    dwell: Array  # time (s) of the dwell that it belongs to; 0 where it moves

    @property
    def resisting(self) -> Array:
        """What resists at the load without motion (N or Nm); of a load by angle at its axis."""
        by_angle = self.train.by_angle
        if by_angle is None:
            return self.steady + self.direction * self.friction
        first, _ = self.slopes
        return first * self.steady + np.abs(first) * self.direction * self.friction + by_angle.weight(self.position)

    @cached_property
    def slopes(self) -> tuple[Array, Array]:
        """Derivatives x' and x'' of a load by angle; 1 and 0 of another."""
        by_angle, y = self.train.by_angle, self.position
        return by_angle.slopes(y) if by_angle else (np.ones(y.shape), np.zeros(y.shape))

    @property
    def moving(self) -> tuple[Array, Array]:
        """Velocity and acceleration of the load itself: of one by angle x' φ̇, x' φ̈ + x'' φ̇²."""
        first, second = self.slopes
        return first * self.velocity, first * self.acceleration + second * self.velocity**2

    @cached_property
    def force(self) -> Array:
        """What drives the load (N or Nm): m a + c v + what resists; of a load by angle at its axis."""
        m, (velocity, acceleration) = self.train.drive.mechanism, self.moving
        moved = m.on_shaft(m.last) * acceleration + self.train.viscous * velocity
        return self.slopes[0] * moved + self.resisting

    @property
    def speed(self) -> Array:
        """Speed of the mechanism's shaft (rad/s)."""
        return self.first * self.velocity

    @property
    def shaft_acceleration(self) -> Array:
        """Acceleration of the mechanism's shaft (rad/s²), φ'' v² + φ' a."""
        return self.second * self.velocity**2 + self.first * self.acceleration

    @cached_property
    def output_torque(self) -> Array:
        """Torque that drives the shaft behind the first stage, the reducer (Nm)."""
        return self._driving(self.force, 1.0)

    @cached_property
    def output_torque_at_rest(self) -> Array:
        """The same without motion (Nm)."""
        return self._driving(self.resisting, 0.0)

    def _driving(self, force: Array, moved: float) -> Array:
        """Return the torque of the shaft behind the first stage (Nm) for a force at the load, f T/i + J ω̇."""
        m, torque = self.train.drive.mechanism, force
        for k in range(m.last - 1, 0, -1):
            ratio = self.first if k == m.last - 1 else m.stages[k].ratio
            gear = math.prod(stage.ratio for stage in m.stages[k : m.last - 1])
            torque = self._through(k, torque) / ratio + moved * m.on_shaft(k) * gear * self.shaft_acceleration
        return torque

    def _through(self, stage: int, torque: Array) -> Array:
        """Return a torque behind a stage times its factor of losses."""
        one = self.train.drive.mechanism.stages[stage]
        return one.factor(torque, self.direction, self.train.drive.method, 0.0) * torque

    def at_motor(self, behind: Array) -> Array:
        """Return a torque behind the reducer at the motor's shaft (Nm), f S/i."""
        m = self.train.drive.mechanism
        return self._through(0, behind) / (self.first if m.last == 1 else m.stages[0].ratio)

    @property
    def braked(self) -> NDArray[np.bool_]:
        """Where a brake holds the motor's shaft."""
        drive = self.train.drive
        return drive.brake.holds(self.direction, self.dwell) & (drive.holding == "brake")


@dataclass(frozen=True)
class QuadratureCycle:
    """A drive's cycle whose motion is these pieces, cut into intervals; cuts that are ``near`` are one."""

    drive_cycle: DriveCycle
    pieces: Sequence[MotionPiece]
    near: float

    @cached_property
    def intervals(self) -> list[Interval]:
        """The intervals between begins of pieces, edges of forces, even steps; of cuts that are ``near`` the first."""
        motion, shift = self.drive_cycle.unshifted, self.drive_cycle.shift
        train = self.drive_cycle.train
        edges = [edge for window in train.windows for edge in (window.begin, window.end)]
        turned = [(edge - shift - motion.begin + self.near) % motion.total + motion.begin - self.near for edge in edges]
        steps = train.by_angle.steps if train.by_angle else 1
        turned += [motion.begin + motion.total * k / steps for k in range(1, steps)]
        end, begins = motion.begin + motion.total, [piece.begin for piece in self.pieces]
        cuts = [*begins, *turned]
        kept = [cut for k, cut in enumerate(cuts) if all(abs(cut - one) >= self.near for one in [*cuts[:k], end])]
        places = [*sorted(kept), end]
        middles = (np.array(places[:-1]) + np.array(places[1:])) / 2.0
        numbers = np.searchsorted(np.array(begins), middles, side="right") - 1
        return [Interval(*one) for one in zip(places[:-1], places[1:], numbers.tolist(), strict=True)]

    @cached_property
    def direction(self) -> Array:
        """The direction in the middle of each interval: 1, −1 or 0 at rest."""
        middles = np.array([one.middle for one in self.intervals])
        _, v, _ = self._moved(np.arange(len(middles)), middles)
        return np.where(np.abs(v) > self.still, np.sign(v), 0.0)

    @cached_property
    def dwells(self) -> Array:
        """The time (s) of the dwell that each interval belongs to; 0 where it moves."""
        lasts = np.array([one.end - one.begin for one in self.intervals]) / self.drive_cycle.speed
        return dwell_times(lasts, self.direction)

    @property
    def still(self) -> float:
        """The speed up to which the load counts as at rest (m/s or rad/s)."""
        return STANDSTILL * self.drive_cycle.unshifted.fastest * self.drive_cycle.speed

    @cached_property
    def levels(self) -> tuple[Array, Array]:
        """What resists in each interval always, and against motion (N or Nm)."""
        force, at = self.drive_cycle.train.force, self.drive_cycle.shift
        each = [
            [force(way, one.middle + at, self.drive_cycle.unshifted.total).level for way in (0.0, 1.0)]
            for one in self.intervals
        ]
        steady, moving = np.array(each).T
        return steady, moving - steady

    def points(self) -> LoadPoints:
        """Return the points of all intervals. Raises OutOfReachError where the mechanism cannot bring its load."""
        begin, end = (np.array([getattr(one, name) for one in self.intervals])[:, None] for name in ("begin", "end"))
        number = np.arange(len(begin))[:, None] + np.zeros(POINTS, dtype=np.intp)
        share, place = (end - begin) / self.drive_cycle.unshifted.total * WEIGHTS, begin + (end - begin) * SHARES
        y, v, a = self._moved(number, place)
        direction = np.where(np.abs(v) > self.still, np.sign(v), self.direction[number])
        steady, friction = (level[number] for level in self.levels)
        first, second = self.drive_cycle.train.ratio(y)
        dwell = self.dwells[number]
        return LoadPoints(
            self.drive_cycle.train, place, y, v, a, direction, steady, friction, first, second, share, dwell
        )

    def _moved(self, number: NDArray[np.intp], place: Array) -> list[Array]:
        """Return position, velocity and acceleration of the motion at places, each in an interval."""
        piece, w = np.array([one.piece for one in self.intervals])[number], self.drive_cycle.speed
        names = ("begin", "origin", "c", "sines")  # of all pieces: cells show those without duration too
        every = CamProfile(*(np.array([getattr(one, name) for one in self.pieces]) for name in names))
        powers = every.taylor(place.ravel(), piece.ravel(), 3)
        return [by * one.reshape(place.shape) for by, one in zip((1.0, w, 2.0 * w**2), powers, strict=True)]
