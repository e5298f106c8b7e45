"""A drive's load at points of its cycle: nine Gauss-Lobatto points of each interval of its motion. SI units.

An interval is a piece of the motion, cut where a process force begins or ends and where the motion turns round. Peaks
are those of the points, corrected by the parabola through the largest and its neighbours; means are weighted sums.
Peaks are exact at a constant ratio without viscous friction, if the acceleration is monotone in each piece; else they
are right to the bound that the sheets state. :class:`engine.drive.results.DriveResults` is exact.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain, dwell_times
from engine.laws.base import Array
from engine.laws.points import POINTS, SHARES, WEIGHTS
from engine.motion.pieces import MotionPiece
from engine.motion.profile import CamProfile

STANDSTILL = 1e-9  # share of the largest speed: a slower load is at rest


class Interval(NamedTuple):
    """A part of a cycle on a piece, with constant process forces."""

    begin: float  # abscissa of the unshifted motion
    end: float
    piece: int  # number of the piece, from 0

    @property
    def middle(self) -> float:
        """Abscissa of its middle."""
        return (self.begin + self.end) / 2.0


@dataclass(frozen=True)
class LoadPoints:
    """A load and the mechanism's shaft at the points of a cycle: arrays of shape (intervals, 9)."""

    train: Drivetrain
    x: Array  # abscissa of the unshifted motion
    position: Array  # of the load (m or rad)
    velocity: Array  # of the load (m/s or rad/s)
    acceleration: Array  # of the load (m/s² or rad/s²)
    direction: Array  # 1, −1, or 0 at rest
    steady: Array  # resisting force against positive motion, also at rest (N or Nm)
    friction: Array  # resisting force against the motion (N or Nm)
    first: Array  # φ' of the mechanism (rad/m or 1)
    second: Array  # φ'' (rad/m² or 1/rad)
    share: Array  # weight of the point in a mean over the cycle; sum 1
    dwell: Array  # duration of the dwell that the point belongs to (s); 0 if it moves

    def at_rate(self, factor: float) -> "LoadPoints":
        """Return the points at another rate, ``factor`` times the present rate."""
        velocity, acceleration = self.velocity * factor, self.acceleration * factor**2
        return replace(self, velocity=velocity, acceleration=acceleration, dwell=self.dwell / factor)

    @property
    def empty(self) -> "LoadPoints":
        """The points without process forces."""
        train = replace(self.train, windows=())
        steady, moving = (np.full(self.x.shape, train.force(way).level) for way in (0.0, 1.0))
        return replace(self, train=train, steady=steady, friction=moving - steady)

    @property
    def resisting(self) -> Array:
        """Resisting force at the load (N or Nm); of a load by angle the torque at its axis."""
        by_angle = self.train.by_angle
        if by_angle is None:
            return self.steady + self.direction * self.friction
        first, _ = self.slopes
        return first * self.steady + np.abs(first) * self.direction * self.friction + by_angle.weight(self.position)

    @cached_property
    def slopes(self) -> tuple[Array, Array]:
        """Derivatives x' and x'' of a load by angle (m/rad, m/rad²); 1 and 0 of others."""
        by_angle, y = self.train.by_angle, self.position
        return by_angle.slopes(y) if by_angle else (np.ones(y.shape), np.zeros(y.shape))

    @property
    def moving(self) -> tuple[Array, Array]:
        """Velocity and acceleration of the load itself; of a load by angle x' φ̇ and x' φ̈ + x'' φ̇² (m/s, m/s²)."""
        first, second = self.slopes
        return first * self.velocity, first * self.acceleration + second * self.velocity**2

    @cached_property
    def force(self) -> Array:
        """Driving force at the load, m a + c v + resisting force (N or Nm); by angle the torque at its axis."""
        m, (velocity, acceleration) = self.train.mechanism, self.moving
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

    @property
    def output_ratio(self) -> float:
        """Speed of the shaft behind the first stage, the reducer, over that of the mechanism's shaft."""
        return math.prod(stage.ratio for stage in self.train.mechanism.stages[1:-1])

    @cached_property
    def shaft_torques(self) -> list[Array]:
        """Torques that drive the shafts (Nm) from the first stage's output, the reducer's, to the mechanism's."""
        return self._driving(self.force, 1.0)

    @cached_property
    def shaft_torques_at_rest(self) -> list[Array]:
        """The same without inertia and viscous friction (Nm)."""
        return self._driving(self.resisting, 0.0)

    @property
    def output_torque(self) -> Array:
        """Torque that drives the shaft behind the first stage, the reducer (Nm)."""
        return self.shaft_torques[0]

    @property
    def output_torque_at_rest(self) -> Array:
        """The same without inertia and viscous friction (Nm)."""
        return self.shaft_torques_at_rest[0]

    def _driving(self, force: Array, moved: float) -> list[Array]:
        """Return the torques on all shafts for a force at the load (Nm), f T/i + ``moved`` · J ω̇ ± T_f."""
        m, torque, torques = self.train.mechanism, force, list[Array]()
        for k in range(m.last - 1, 0, -1):
            ratio = self.first if k == m.last - 1 else m.stages[k].ratio
            gear = math.prod(stage.ratio for stage in m.stages[k : m.last - 1])
            torque = self._through(k, torque) / ratio + moved * m.on_shaft(k) * gear * self.shaft_acceleration
            torque = torque + m.friction_on(k) * self.direction
            torques.insert(0, torque)
        return torques or [force]

    def _through(self, stage: int, torque: Array) -> Array:
        """Return a torque at the output of a stage (a number from 0) times its factor of losses."""
        losses = self.train.mechanism.stages[stage]
        return losses.factor(torque, self.direction, self.train.method) * torque

    def at_motor(self, behind: Array) -> Array:
        """Return a torque at the reducer's output as torque at the motor's shaft, f S/i (Nm)."""
        m = self.train.mechanism
        return self._through(0, behind) / (self.first if m.last == 1 else m.stages[0].ratio)

    @property
    def braked(self) -> NDArray[np.bool_]:
        """Whether a brake holds the motor's shaft."""
        return self.train.brake.holds(self.direction, self.dwell) & (self.train.holding == "brake")


class Interpolation(NamedTuple):
    """Places between points."""

    point: NDArray[np.intp]  # number of the last point before each place, from 0
    share: Array  # of the step to the next point

    def of(self, values: Array) -> Array:
        """Return a quantity at the places, interpolated linearly between its values at the points."""
        y = values.ravel()
        return np.asarray(y[self.point] + self.share * (y[self.point + 1] - y[self.point]))


@dataclass(frozen=True)
class QuadratureCycle:
    """A drive's cycle, cut into intervals with nine points each."""

    drive_cycle: DriveCycle
    pieces: Sequence[MotionPiece]  # of its motion
    near: float  # distance within which cuts count as the same, in units of the abscissa
    # further cuts: where the motion turns round, or its acceleration, inside a piece
    inside: Sequence[float] = ()

    @cached_property
    def intervals(self) -> list[Interval]:
        """The intervals between begins of pieces, edges of forces, even steps, and cuts inside pieces, in order."""
        motion, shift = self.drive_cycle.unshifted, self.drive_cycle.shift
        train = self.drive_cycle.train
        edges = [edge for window in train.windows for edge in (window.begin, window.end)]
        inner = [(edge - shift - motion.begin + self.near) % motion.total + motion.begin - self.near for edge in edges]
        steps = train.by_angle.steps if train.by_angle else 1
        inner += [motion.begin + motion.total * k / steps for k in range(1, steps)]
        end, begins = motion.begin + motion.total, [piece.begin for piece in self.pieces]
        cuts = [*begins, *inner, *self.inside]
        apart = [cut for k, cut in enumerate(cuts) if all(abs(cut - other) >= self.near for other in [*cuts[:k], end])]
        places = [*sorted(apart), end]
        middles = (np.array(places[:-1]) + np.array(places[1:])) / 2.0
        numbers = np.searchsorted(np.array(begins), middles, side="right") - 1
        return [Interval(*bounds) for bounds in zip(places[:-1], places[1:], numbers.tolist(), strict=True)]

    @cached_property
    def direction(self) -> Array:
        """The direction of motion in the middle of each interval: 1, −1, or 0 at rest."""
        middles = np.array([interval.middle for interval in self.intervals])
        _, v, _ = self._moved(np.arange(len(middles)), middles)
        return np.where(np.abs(v) > self.still, np.sign(v), 0.0)

    @cached_property
    def dwells(self) -> Array:
        """Duration (s) of the dwell that each interval belongs to; 0 if it moves."""
        durations = np.array([interval.end - interval.begin for interval in self.intervals])
        return dwell_times(durations / self.drive_cycle.speed, self.direction)

    @property
    def still(self) -> float:
        """Speed up to which the load counts as at rest (m/s or rad/s)."""
        return STANDSTILL * self.drive_cycle.unshifted.fastest * self.drive_cycle.speed

    @cached_property
    def levels(self) -> tuple[Array, Array]:
        """Resisting forces in each interval (N or Nm): against positive motion, and against the motion."""
        cycle = self.drive_cycle
        acting = [
            cycle.train.acting(interval.middle + cycle.shift, cycle.unshifted.total) for interval in self.intervals
        ]
        steady, moving = (np.array([cycle.train.force(way, loads).level for loads in acting]) for way in (0.0, 1.0))
        return steady, moving - steady

    def points(self) -> LoadPoints:
        """Return the points of all intervals. Raises OutOfReachError if the mechanism cannot reach a position."""
        begin = np.array([interval.begin for interval in self.intervals])[:, None]
        end = np.array([interval.end for interval in self.intervals])[:, None]
        number = np.arange(len(begin))[:, None] + np.zeros(POINTS, dtype=np.intp)
        share = (end - begin) / self.drive_cycle.unshifted.total * WEIGHTS
        place = begin + (end - begin) * SHARES
        return self.points_at(number, place, share)

    def points_at(self, number: NDArray[np.intp], place: Array, share: Array) -> LoadPoints:
        """Return the load at places.

        Parameters
        ----------
        number : array of int
            The interval of each place, from 0.
        place : array, of the shape of ``number``
            Abscissae of the unshifted motion.
        share : array, of the same shape
            What each counts in a mean over the cycle.

        Raises
        ------
        OutOfReachError
            If the mechanism cannot reach a position.
        """
        y, v, a = self._moved(number, place)
        steady, friction = (level[number] for level in self.levels)
        direction = self.direction[number]
        first, second = self.drive_cycle.train.ratio(y)
        dwell = self.dwells[number]
        return LoadPoints(
            self.drive_cycle.train, place, y, v, a, direction, steady, friction, first, second, share, dwell
        )

    def interpolation_at(self, points: Array, places: Array) -> Interpolation:
        """Return the places between rising points; a place within ``near`` of the next point counts as that point."""
        x = points.ravel()
        point = np.searchsorted(x, np.minimum(places + self.near, x[-1] - self.near), side="right") - 1
        return Interpolation(point, (places - x[point]) / (x[point + 1] - x[point]))

    def _moved(self, number: NDArray[np.intp], place: Array) -> list[Array]:
        """Return position, velocity and acceleration of the motion at places, by the numbers of their intervals."""
        piece = np.array([interval.piece for interval in self.intervals])[number]
        w = self.drive_cycle.speed
        # also of pieces without duration, as cells show them
        names = ("begin", "origin", "c", "sines")
        every = CamProfile(*(np.array([getattr(each, name) for each in self.pieces]) for name in names))
        powers = every.taylor(place.ravel(), piece.ravel(), 3)
        return [factor * row.reshape(place.shape) for factor, row in zip((1.0, w, 2.0 * w**2), powers, strict=True)]
