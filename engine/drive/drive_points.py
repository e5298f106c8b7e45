"""A motor at the points of its cycle: torque, speed and power, their means and peaks."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drive.drivetrain import Drivetrain
from engine.drive.mechanisms.variable_ratio import PositionTable
from engine.drive.motor import Motor
from engine.drive.quadrature import LoadPoints
from engine.laws.base import Array

TIED = 1e-9  # share of the largest absolute value by which equal peaks may differ
SEEN = 1e-4  # share of the gap between neighbours: a peak so near to its point needs no second look


class Peak(NamedTuple):
    """The first of the largest values of a quantity at points."""

    at: int  # number of the point, from 0
    values: tuple[float, float, float]  # at the point before it, there, and at the point after it
    before: float  # distance of the point before it; 0 at an end of an interval
    after: float  # distance of the point after it; likewise
    top: float  # maximum of the parabola through the three values
    offset: float = 0.0  # how far behind the point that is; 0 where the point itself is the largest

    @property
    def second_offset(self) -> float:
        """How far behind the point a second look is taken; 0 where the top is so near that none is needed."""
        return self.offset if abs(self.offset) > SEEN * (self.before + self.after) else 0.0


def peak(values: Array, place: Array) -> Peak:
    """Return the first of the largest values, with the maximum of the parabola through it and its neighbours.

    ``values`` and their abscissae ``place`` have the shape (intervals, 9). At an end of an interval the value itself is
    the maximum; so is the largest value if the parabola's maximum lies beyond the neighbours.
    """
    y, x = values.ravel(), place.ravel()
    limit = y.max() - TIED * np.abs(y).max()
    k = int((y >= limit).argmax())
    low, high = max(k - 1, 0), min(k + 1, y.size - 1)
    is_end = k % values.shape[1] in (0, values.shape[1] - 1)
    gaps = (0.0, 0.0) if is_end else (float(x[k] - x[low]), float(x[high] - x[k]))
    found = peak_between(k, (float(y[low]), float(y[k]), float(y[high])), gaps)
    return found._replace(top=max(found.top, float(y.max())))


def peak_between(at: int, values: tuple[float, float, float], gaps: tuple[float, float]) -> Peak:
    """Return the maximum of the parabola through three values, the second that of point ``at``, with gaps between."""
    before, after = gaps
    if min(gaps) > 0.0:
        rise, fall = (values[1] - values[0]) / before, (values[1] - values[2]) / after
        bend, lean = rise + fall, rise * after - fall * before
        if bend > 0.0 and -2.0 * before * bend <= lean <= 2.0 * after * bend:
            top = values[1] + lean**2 / (4.0 * bend * (before + after))
            return Peak(at, values, before, after, top, lean / (2.0 * bend))
    return Peak(at, values, before, after, values[1])


def second_look(first: Peak, there: float) -> Peak:
    """Return the peak of the parabola through the top of a first one, where the quantity is known, and neighbours.

    Parameters
    ----------
    first : Peak
    there : float
        The quantity at the first's offset from its point; that of the result is from there.
    """
    (low, middle, high), offset = first.values, first.second_offset
    if offset > 0.0:
        return peak_between(first.at, (middle, there, high), (offset, first.after - offset))
    return peak_between(first.at, (low, there, middle), (first.before + offset, -offset))


@dataclass(frozen=True)
class DrivePoints:
    """A motor and a reducer on a load at the points of its cycle: arrays of shape (intervals, 9)."""

    load: LoadPoints

    @property
    def _drive(self) -> tuple[float, float]:
        train = self.load.train
        return train.motor_inertia + train.mechanism.on_shaft(0), train.gear

    @cached_property
    def torque(self) -> Array:
        """Torque of the motor (Nm); the no-load torque alone where a brake holds."""
        inertia, ratio = self._drive
        torque = self.load.at_motor(self.load.output_torque) + inertia * ratio * self.load.shaft_acceleration
        return np.where(self.load.braked, 0.0, torque) + self.no_load

    @cached_property
    def standing(self) -> Array:
        """Torque of the motor without inertia and viscous friction (Nm)."""
        return np.where(self.load.braked, 0.0, self.load.at_motor(self.load.output_torque_at_rest)) + self.no_load

    @property
    def brake_torque(self) -> float:
        """The largest torque that a brake holds in dwells, at the motor's shaft (Nm)."""
        return float(np.abs(np.where(self.load.braked, self.load.at_motor(self.load.output_torque), 0.0)).max())

    @property
    def shortest_braked_dwell(self) -> float:
        """The shortest dwell that a brake holds (s), or infinite."""
        dwells = self.load.dwell[self.load.braked & (self.load.dwell > 0.0)]
        return float(dwells.min(initial=np.inf))

    @property
    def holding_torque(self) -> float:
        """The largest torque that the motor gives at rest (Nm)."""
        return float(np.abs(np.where(self.load.direction == 0.0, self.torque, 0.0)).max())

    @property
    def no_load(self) -> Array:
        """No-load torque, with the sign of the motion (Nm)."""
        return self.load.train.no_load * self.load.direction

    @property
    def speed(self) -> Array:
        """Speed of the motor (rad/s)."""
        return self._drive[1] * self.load.speed

    @property
    def power(self) -> Array:
        """Power of the motor (W), with the losses of its winding."""
        return self.torque * (self.speed + self.load.train.copper * self.torque)

    def mean(self, values: Array) -> float:
        """Return the mean of a quantity over the cycle, in its unit."""
        return float((self.load.share * values).sum())

    @property
    def rms_torque(self) -> float:
        """Return √(mean T²) (Nm)."""
        return math.sqrt(self.mean(self.torque**2))

    @property
    def mean_speed(self) -> float:
        """Mean of |ω| over the cycle (rad/s)."""
        return self.mean(np.abs(self.speed))

    def cubic_mean(self, torque: Array) -> float:
        """Return the cubic mean of a torque weighted by speed, ³√(mean |ω||T|³/mean |ω|) (Nm); 0 without motion."""
        weight = np.abs(self.speed)
        mean_speed = self.mean(weight)
        return math.cbrt(self.mean(weight * np.abs(torque) ** 3) / mean_speed) if mean_speed else 0.0

    def top(self, values: Array) -> float:
        """Return the largest value of a quantity over the cycle, by :func:`peak`."""
        return peak(values, self.load.x).top

    def size(self, values: Array) -> float:
        """Return the largest absolute value of a quantity over the cycle."""
        return max(self.top(values), self.top(-values))

    def reserve(self, motor: Motor) -> Array:
        """Return the rest of a motor's peak torque at each point (Nm)."""
        return motor.peak_at(self.speed) - np.abs(self.torque)

    def falling_use(self, motor: Motor) -> Array:
        """Return at each point the use 1/r² of a motor's peak torque T that falls: |S + r² I| + f r |ω| = T + f ω_1.

        It has two rows, for positive and negative torque, of the first r that reaches the line; 0 if none does. See
        :func:`engine.drive.rate_estimates.by_points` for S and I.
        """
        way = np.array([1.0, -1.0])[:, None, None]
        left = motor.falling.corner(motor.peak_torque) - way * self.standing
        sink = motor.falling.fall * np.abs(self.speed)
        square = sink**2 + 4.0 * way * (self.torque - self.standing) * left
        return np.where(square < 0.0, 0.0, ((sink + np.sqrt(np.maximum(square, 0.0))) / (2.0 * left)) ** 2)


class Bounds(NamedTuple):
    """By how much results at the points may be off the exact engine's: what sheets state, judges and tests read.

    Shares of the largest torque, of the speed, of the largest power, of energies together, measured on random machines
    of each kind, with hand-overs at speed, laws that swing, process forces, losses.
    """

    peak_torque: float = 5e-3  # highest and lowest, of motor and reducer
    rms_torque: float = 1e-3
    mean_torque: float = 2e-3  # cubic mean behind the reducer
    speed: float = 5e-3  # the largest
    mean_speed: float = 1e-3
    peak_power: float = 0.03  # highest and lowest
    mean_power: float = 0.01
    energy: float = 0.03  # driven, and regenerated, of both together


USUAL = Bounds()
TABLE = Bounds(peak_torque=2e-2, rms_torque=1.5e-2, mean_torque=1e-2, speed=1e-2)
"""of a table of positions, whose ratio bends at each of its points"""
BY_ANGLE = Bounds(peak_torque=2.5e-2)  # of an axis that turns most of the way in one interval


def stated_bounds(train: Drivetrain) -> Bounds:
    """Return the bounds of a drivetrain."""
    if isinstance(train.linkage, PositionTable):
        return TABLE
    return BY_ANGLE if train.by_angle else USUAL
