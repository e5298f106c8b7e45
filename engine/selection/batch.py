"""Many motors behind many reducers on one load, at the points of its cycle: found for all of them at once. SI units.

Each is what :class:`engine.drive.drive_points.DrivePoints` says of it alone.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.drive_points import TIED
from engine.drive.results import Energy
from engine.laws.base import Array
from engine.selection.point_load import Gears, PointLoad


class Limits(NamedTuple):
    """Peak torque of each motor (Nm), up to which speed (rad/s), its fall beyond (Nm s), copper losses (W/(Nm)²)."""

    peak: Array
    knee: Array
    fall: Array
    copper: Array


class Extremes(NamedTuple):
    """Lowest and highest torque (Nm) and power (W) of each motor, and what is left below its curve (Nm)."""

    torque_low: Array
    torque: Array
    power_low: Array
    power: Array
    spare: Array

    @property
    def peak(self) -> Array:
        """The largest size of the torque (Nm)."""
        return np.maximum(self.torque, -self.torque_low)


@dataclass(frozen=True)
class DriveBatch:
    """Motors with their reducers on a load; ``limits`` are the motors'."""

    load: PointLoad
    gears: Gears
    limits: Limits

    def _parts(self) -> Iterator[tuple[slice, Array, Array, Array]]:
        """Yield some at a time, with their torques (Nm), speeds (rad/s) and powers (W): motors down, points across."""
        speed = self.load.load.speed.ravel()
        for some in self.gears.parts(speed.size):
            one = Gears(*(values[some] for values in self.gears))
            torque, fast = self.load.torques(one), one.ratio[:, None] * speed
            yield some, torque, fast, torque * (fast + self.limits.copper[some, None] * torque)

    @cached_property
    def extremes(self) -> Extremes:
        """Peaks over the cycle."""
        place, found = self.load.load.x, []
        for some, torque, speed, power in self._parts():
            peak, knee, fall, _ = (values[some, None] for values in self.limits)
            left = peak - fall * np.maximum(0.0, np.abs(speed) - knee) - np.abs(torque)
            each = (-tops(-torque, place), tops(torque, place), -tops(-power, place), tops(power, place))
            found.append((*each, left.min(axis=1)))
        return Extremes(*(np.concatenate(values) for values in zip(*found, strict=True)))

    def works(self, time: float) -> Energy:
        """Return the work of each over a cycle of so long (s)."""
        share = self.load.load.share.ravel() * time
        each = [[np.maximum(way * power, 0.0) @ share for way in (1.0, -1.0)] for *_, power in self._parts()]
        return Energy(*(np.concatenate(values) for values in zip(*each, strict=True)))


def tops(values: Array, place: Array) -> Array:
    """Return the largest of each row of values at the points, as :func:`engine.drive.drive_points.peak` finds it.

    ``place`` is an array of intervals by points, each row of values its points in a line.
    """
    rows, width, x = np.arange(len(values)), place.shape[1], place.ravel()
    limit = values.max(axis=1) - TIED * np.abs(values).max(axis=1)
    k: NDArray[np.intp] = (values >= limit[:, None]).argmax(axis=1)
    inner = (k % width != 0) & (k % width != width - 1)
    middle = np.where(inner, k, 1)
    y = [values[rows, middle + side] for side in (-1, 0, 1)]
    before, after = x[middle] - x[middle - 1], x[middle + 1] - x[middle]
    rise, fall = (y[1] - y[0]) / before, (y[1] - y[2]) / after
    bend = inner & (rise + fall != 0.0)
    over = np.where(bend, 4.0 * (rise + fall) * (before + after), 1.0)
    lean = (rise * after - fall * before) ** 2 / over
    return np.asarray(values[rows, k] + np.where(bend, lean, 0.0))


def mean_power(works: Energy, time: Array) -> Array:
    """Return the mean power at the shafts of motors over cycles of so long (W)."""
    return np.asarray((works.driving - works.regenerated) / time)
