"""The power of several drives over a cycle, exact: from the mains, on a common DC bus and without one. SI units.

The second route to what the Power sheet takes from a table of points.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from engine.drive.cycle import DriveCycle, TorqueInterval, parts
from engine.drive.results import HOUR
from engine.drive.search import Function, crossed, extremes, integral
from engine.laws.base import Array

DEGREE = 24  # of the polynomial by which the bend of the power is measured
FINE = 64  # points an interval, at which it is


class Supply(NamedTuple):
    """Power (W): highest and mean from the mains, highest and mean in the brake resistors."""

    mains_peak: float
    mains_mean: float
    resistor_peak: float
    resistor_mean: float

    def energy_a_year(self, hours: float) -> float:
        """Return the energy from the mains (J) in a year of so many hours."""
        return self.mains_mean * hours * HOUR


@dataclass(frozen=True)
class Drivetrains:
    """Drives over one cycle, and the efficiency of their drives between the motors' shafts and the bus or the mains.

    A drive takes P/η where its motor drives, and gives back η P where the motor is driven. The times count from the
    begin of the cycle; shifts are in them. Raises ValueError for no cycles, cycles that differ, or an efficiency
    that cannot be.
    """

    drive_cycles: tuple[DriveCycle, ...]
    efficiency: float = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "cycles", tuple(self.drive_cycles))
        if not self.drive_cycles:
            raise ValueError("no cycles are given; expected at least one")
        times = [drive_cycle.time for drive_cycle in self.drive_cycles]
        if max(times) - min(times) > 1e-9 * max(times):
            raise ValueError(f"cycles of {min(times):.9g} s and {max(times):.9g} s are given; expected one time")
        if not 0.0 < self.efficiency <= 1.0:
            raise ValueError(f"efficiency is {self.efficiency:g}; expected more than 0 and at most 1")

    @property
    def time(self) -> float:
        """Time of the cycle (s)."""
        return self.drive_cycles[0].time

    @cached_property
    def sections(self) -> "tuple[Section, ...]":
        """The cycle, cut wherever the power of one drive changes its formula."""
        cuts = [0.0, self.time, *(cut for drive_cycle in self.drive_cycles for cut in _begins(drive_cycle))]
        placed = [_placed(drive_cycle) for drive_cycle in self.drive_cycles]
        return tuple(
            Section(low, high, self.efficiency, tuple(_of(one, 0.5 * (low + high)) for one in placed))
            for low, high in parts(cuts, self.time)
        )

    def grid(self, points: int) -> Array:
        """Return the times (s) at which the sum is known in a table: equal steps, and all breaks twice."""
        breaks = [section.low for section in self.sections] + [section.high for section in self.sections]
        return np.sort(np.concatenate([np.linspace(0.0, self.time, points + 1)[1:-1], breaks]))

    def supply(self, common: bool) -> Supply:
        """Return the power from the mains and in the resistors, exact: with a ``common`` bus, or each drive alone."""
        figures = []
        for sign in (1.0, -1.0):
            peak = 0.0
            for section in self.sections:
                peak = max(peak, section.peak(sign, common, peak))
            energy = math.fsum(section.energy(sign, common, peak) for section in self.sections)
            figures += [peak, energy / self.time]
        return Supply(*figures)

    def supply_on_grid(self, points: int, common: bool) -> Supply:
        """Return the same from values on a grid of equal steps and all breaks, joined by straight lines.

        None of the four figures is off by more than :meth:`grid_error`.
        """
        peaks, sums = np.zeros(2), np.zeros(2)
        for section in self.sections:
            t = self._within(section, points)
            lines = section.drawn(t)
            for line in [lines.sum(axis=0)] if common else []:
                peaks, sums = _drawn(t, line, peaks, sums)
            if not common:
                up, down = np.maximum(lines, 0.0).sum(axis=0), np.maximum(-lines, 0.0).sum(axis=0)
                peaks = np.maximum(peaks, [up.max(), down.max()])
                sums += sum(_areas(t, line) for line in lines)
        return Supply(float(peaks[0]), float(sums[0] / self.time), float(peaks[1]), float(sums[1] / self.time))

    def grid_error(self, points: int) -> float:
        """Return by how much figures on a grid are off at most (W): Σ max|P̈| δ²/8, δ the step, over the drives.

        Between breaks a straight line is off by no more than that, and so is what it has above 0 or below it.
        """
        return max(section.bend * self._step(section, points) ** 2 / 8.0 for section in self.sections)

    def _within(self, section: "Section", points: int) -> Array:
        step = self.time / points
        inner = step * np.arange(math.floor(section.low / step) + 1, math.ceil(section.high / step))
        return np.array([section.low, *inner[(inner > section.low) & (inner < section.high)], section.high])

    def _step(self, section: "Section", points: int) -> float:
        return min(self.time / points, section.high - section.low)


class Part(NamedTuple):
    """An interval of one cycle, and the time (s) at which its piece begins, within one cycle of the section's."""

    interval: TorqueInterval
    begin: float

    def power(self, t: Array) -> Array:
        """Return the power (W) of the motor."""
        return self.interval.power((t - self.begin) * self.interval.speed)


@dataclass(frozen=True)
class Section:
    """A part of the cycle (s) in which the power of every drive is smooth and keeps its sign."""

    low: float
    high: float
    efficiency: float
    parts: tuple[Part, ...]

    def drawn(self, t: Array) -> Array:
        """Return what each drive draws (W, a row each), below 0 what it gives back."""
        power = np.array([part.power(t) for part in self.parts])
        return np.where(power > 0.0, power / self.efficiency, power * self.efficiency)

    def total(self, sign: float, common: bool) -> Function:
        """Return what all take from the mains (``sign`` 1) or give to resistors (−1), as a function of time (W).

        On a common bus it is below 0 where the others' power does.
        """
        if common:
            return lambda t: np.asarray(sign * self.drawn(t).sum(axis=0))
        return lambda t: np.asarray(np.maximum(sign * self.drawn(t), 0.0).sum(axis=0))

    def peak(self, sign: float, common: bool, least: float) -> float:
        """Return its largest value (W); any value below ``least`` where it stays below that."""
        return extremes(self.total(sign, common), self._samples, (1.0,), least)[0].value

    def energy(self, sign: float, common: bool, scale: float) -> float:
        """Return the integral (J) of what it has above 0; ``scale`` is the largest power of the cycle."""
        function = self.total(sign, common)
        cuts = [self.low, *crossed(function, self._samples), self.high]
        middles = function(np.array([0.5 * (a + b) for a, b in pairwise(cuts)]))
        above = [ends for ends, middle in zip(pairwise(cuts), middles, strict=True) if middle > 0.0]
        return math.fsum(integral(function, a, b, scale) for a, b in above)

    @cached_property
    def bend(self) -> float:
        """Σ max|P̈| of the drives (W/s²), measured by a polynomial through each."""
        width = self.high - self.low
        t = self.low + width * (1.0 - np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))) / 2.0
        x = 2.0 * (t - self.low) / width - 1.0
        second = chebyshev.chebder(chebyshev.chebfit(x, self.drawn(t).T, DEGREE), 2)
        found = chebyshev.chebval(np.linspace(-1.0, 1.0, FINE), second)
        return float(np.abs(found).max(axis=1).sum()) * (2.0 / width) ** 2

    @property
    def _samples(self) -> Array:
        return np.linspace(self.low, self.high, max(part.interval.samples.size for part in self.parts))


def _areas(t: Array, line: Array) -> Array:
    """Return the integrals of what straight lines between points have above 0, and below."""
    width, a, b = np.diff(t), line[:-1], line[1:]
    span = np.abs(a) + np.abs(b)
    share = np.divide(width, 2.0 * span, out=np.zeros_like(width), where=span > 0.0)
    one_side = a * b >= 0.0
    return np.array(
        [
            float(np.where(one_side, width * (x + y) / 2.0, share * (x**2 + y**2)).sum())
            for x, y in ((np.maximum(a, 0.0), np.maximum(b, 0.0)), (np.maximum(-a, 0.0), np.maximum(-b, 0.0)))
        ]
    )


def _drawn(t: Array, line: Array, peaks: Array, sums: Array) -> tuple[Array, Array]:
    return np.maximum(peaks, [line.max(), -line.min()]), sums + _areas(t, line)


def _time(drive_cycle: DriveCycle, interval: TorqueInterval, u: float) -> float:
    """Return the time (s) in the cycle of a place in an interval."""
    x = interval.piece.begin + u - drive_cycle.unshifted.begin + drive_cycle.shift
    return float(x / drive_cycle.speed % drive_cycle.time)


def _begins(drive_cycle: DriveCycle) -> list[float]:
    return [_time(drive_cycle, one, u) for one in drive_cycle.torque_intervals for u in (one.low, *one.power_reversals)]


def _placed(drive_cycle: DriveCycle) -> list[tuple[float, DriveCycle, TorqueInterval]]:
    """Return the intervals with the times of their begins, in order of time."""
    found = [
        (_time(drive_cycle, interval, interval.low), drive_cycle, interval) for interval in drive_cycle.torque_intervals
    ]
    return sorted(found, key=lambda one: one[0])


def _of(placed: Sequence[tuple[float, DriveCycle, TorqueInterval]], t: float) -> Part:
    """Return the interval of a cycle in which a time lies; before the first of the cycle, it is the last."""
    behind = [one for one in placed if one[0] <= t]
    begin, drive_cycle, interval = behind[-1] if behind else placed[-1]
    start = begin if behind else begin - drive_cycle.time
    return Part(interval, start - interval.low / interval.speed)
