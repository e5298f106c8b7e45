"""A motor at the points of its cycle: torque, speed and power, their means and peaks. SI units."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.quadrature import LoadPoints
from engine.laws.base import Array

TIED = 1e-9
"""of the largest size: what differs by less is as large"""


class Between(NamedTuple):
    """Places between points: the last point before each, counted from 0, and the share of the way to the next one."""

    point: NDArray[np.intp]
    share: Array

    def of(self, values: Array) -> Array:
        """Return a quantity there, by a straight line from point to point."""
        y = values.ravel()
        return np.asarray(y[self.point] + self.share * (y[self.point + 1] - y[self.point]))


def between(points: Array, places: Array, near: float) -> Between:
    """Return where places lie between points in order; one that is ``near`` the next point counts as at it."""
    x = points.ravel()
    point = np.searchsorted(x, np.minimum(places + near, x[-1] - near), side="right") - 1
    return Between(point, (places - x[point]) / (x[point + 1] - x[point]))


class Peak(NamedTuple):
    """The first largest of a quantity at points: where (counted from 0), there and beside it, and the parabola's top.

    ``before`` and ``after`` are how far its neighbours are; 0 where it is at an end of an interval.
    """

    at: int
    values: tuple[float, float, float]
    before: float
    after: float
    top: float


def peak(values: Array, place: Array) -> Peak:
    """Return the first largest of values over their places, and the top of the parabola through it and its neighbours.

    Arrays of intervals by points. Of values that differ by less than 1e-9 of the largest size the first counts. At an
    end of an interval the value itself is the top, and the largest value where it is not between the neighbours.
    """
    y, x = values.ravel(), place.ravel()
    limit = y.max() - TIED * np.abs(y).max()
    k = int((y >= limit).argmax())
    low, high = max(k - 1, 0), min(k + 1, y.size - 1)
    three = float(y[low]), float(y[k]), float(y[high])
    if k % values.shape[1] in (0, values.shape[1] - 1):
        return Peak(k, three, 0.0, 0.0, three[1])
    before, after = float(x[k] - x[low]), float(x[high] - x[k])
    rise, fall = (three[1] - three[0]) / before, (three[1] - three[2]) / after
    bend, lean = rise + fall, rise * after - fall * before
    if not (bend > 0.0 and -2.0 * before * bend <= lean <= 2.0 * after * bend):
        return Peak(k, three, before, after, float(y.max()))
    return Peak(k, three, before, after, three[1] + lean**2 / (4.0 * bend * (before + after)))


@dataclass(frozen=True)
class DrivePoints:
    """A motor and a reducer on a load at the points of its cycle."""

    load: LoadPoints

    @property
    def _drive(self) -> tuple[float, float]:
        drive = self.load.train.drive
        return drive.motor_inertia + drive.mechanism.on_shaft(0), self.load.train.gear

    @cached_property
    def torque(self) -> Array:
        """Torque of the motor (Nm); none where a brake holds."""
        inertia, ratio = self._drive
        found = self.load.at_motor(self.load.output_torque) + inertia * ratio * self.load.shaft_acceleration
        return np.where(self.load.braked, 0.0, found) + self.no_load

    @cached_property
    def standing(self) -> Array:
        """Torque of the motor without motion (Nm)."""
        return np.where(self.load.braked, 0.0, self.load.at_motor(self.load.output_torque_at_rest)) + self.no_load

    @property
    def brake_torque(self) -> float:
        """The largest torque that a brake holds in dwells, at the motor's shaft (Nm)."""
        return float(np.abs(np.where(self.load.braked, self.load.at_motor(self.load.output_torque), 0.0)).max())

    @property
    def no_load(self) -> Array:
        """Torque that opposes the motor's rotation, whatever the load (Nm)."""
        return self.load.train.drive.no_load * self.load.direction

    @property
    def speed(self) -> Array:
        """Speed of the motor (rad/s)."""
        return self._drive[1] * self.load.speed

    @property
    def power(self) -> Array:
        """Power of the motor (W), with the losses of its winding."""
        return self.torque * (self.speed + self.load.train.drive.copper * self.torque)

    def mean(self, values: Array) -> float:
        """Return the mean of a quantity over the cycle."""
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
        """Return the cubic mean of a torque weighted by speed, ³√(mean |ω||T|³/mean |ω|) (Nm); 0 where it stands."""
        weight = np.abs(self.speed)
        ways = self.mean(weight)
        return math.cbrt(self.mean(weight * np.abs(torque) ** 3) / ways) if ways else 0.0

    def top(self, values: Array) -> float:
        """Return the largest of a quantity over the cycle."""
        return peak(values, self.load.x).top

    def size(self, values: Array) -> float:
        """Return the largest size of a quantity over the cycle."""
        return max(self.top(values), self.top(-values))
