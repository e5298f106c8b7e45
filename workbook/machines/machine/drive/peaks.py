"""Peaks of a drive: sought beside the largest points of its quantities, where the drive is worked out once more.

A key is a column, 1 for the highest or −1 for the lowest, and a rank. Of rank 2 is, of speeds, the largest point of the
other intervals: of two peaks nearly alike, the one with the lower point may be the higher, by 1.5 % in drawn drives, a
torque's by 0.01 %. Of torques and powers it is a second look, beside the top of the first parabola: without it a torque
was up to 1.2 % low, a power 5.7 %.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from engine.drive.drive_points import DrivePoints, Peak, peak, second_look
from engine.drive.drivetrain import Drivetrain
from engine.drive.quadrature import QuadratureCycle
from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.fields.units import KW, RPM

PEAKED: dict[str, Callable[[DrivePoints], Array]] = {
    "T": lambda points: points.torque,
    "S": lambda points: points.load.output_torque,
    "P": lambda points: points.power,
    "n": lambda points: points.speed,
}
"""the quantities whose peaks are sought, by their columns"""
PEAK_UNITS = {"T": 1.0, "S": 1.0, "P": KW, "n": RPM}  # of these on the sheet
WAYS = (1, -1)
Key = tuple[str, int, int]


class Peaks:
    """The peaks of a drive at the points of a cycle."""

    def __init__(self, cycle: QuadratureCycle, points: DrivePoints, train: Drivetrain, varies: bool) -> None:
        self.cycle, self.points, self.train, self.varies = cycle, points, train, varies

    def upward(self, name: str, way: int) -> Array:
        """Return a column at the points; −1 times it, where its lowest value is sought."""
        return way * PEAKED[name](self.points)

    @cached_property
    def beside_points(self) -> dict[Key, Peak]:
        """The peaks beside points."""
        x = self.points.load.x
        keys = [(name, way, 1) for name in PEAKED if name != "n" or self.varies for way in WAYS]
        found = {key: peak(self.upward(*key[:2]), x) for key in keys}
        for way in WAYS if self.varies else ():
            others = self.upward("n", way).copy()
            others[found["n", way, 1].at // POINTS] = 0.0
            found["n", way, 2] = peak(others, x)
        return found

    @cached_property
    def again(self) -> dict[Key, Peak]:
        """The second look at torques and powers."""
        there = self.worked_out((first.at, first.offset) for first in self.beside_points.values())
        found = {}
        for row, ((name, way, _), first) in enumerate(self.beside_points.items()):
            if name != "n":
                found[name, way, 2] = second_look(first, float(way * PEAKED[name](there)[row, 0]))
        return found

    @cached_property
    def places(self) -> dict[Key, tuple[int, float]]:
        """The number of a point and how far behind it the drive is worked out once more, a row each."""
        beside = {key: (peak.at, peak.offset) for key, peak in self.beside_points.items()}
        for (name, way, _), second in self.again.items():
            beside[name, way, 2] = second.at, beside[name, way, 1][1] + second.offset
        return beside

    @property
    def rows(self) -> dict[Key, int]:
        """The number of the row of each place, from 1."""
        return {key: row for row, key in enumerate(self.places, 1)}

    def worked_out(self, places: Iterable[tuple[int, float]]) -> DrivePoints:
        """Return the drive at places beside points, a row each."""
        numbers, offsets = zip(*places, strict=True)
        at = np.array(numbers)[:, None]
        load = self.cycle.points_at(at // POINTS, self.points.load.x.ravel()[at] + np.array(offsets)[:, None], 0.0 * at)
        return DrivePoints(replace(load, train=self.train))

    @cached_property
    def there(self) -> DrivePoints:
        """The drive at :attr:`places`."""
        return self.worked_out(self.places.values())

    @property
    def intervals(self) -> NDArray[np.int_]:
        """The number of the interval of each row, from 0, of shape (rows, 1)."""
        return np.array([[at // POINTS] for at, _ in self.places.values()])

    @cached_property
    def tops(self) -> dict[Key, float]:
        """The larger of each peak and of its point, or of the first look; −1 times the lowest."""
        found: dict[Key, float] = {}
        for row, (key, (at, _)) in enumerate(self.places.items()):
            name, way, _ = key
            before = found[name, way, 1] if key in self.again else self.upward(name, way).flat[at]
            found[key] = max(float(before), float(way * PEAKED[name](self.there)[row, 0]))
        return found

    def top(self, name: str, way: int = 1) -> float:
        """Return the highest value of a column, or −1 times the lowest."""
        return max(value for key, value in self.tops.items() if key[:2] == (name, way))

    def size(self, name: str) -> float:
        """Return the largest absolute value of a column."""
        return max(self.top(name, way) for way in WAYS)
