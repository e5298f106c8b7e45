"""What a cycle asks of its motor and its gears: peaks, RMS torque and energy, exact and not from samples. SI units."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.drive.curves import position, trimmed
from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.search import Function, extremes, integral
from engine.laws.base import Array
from engine.laws.ladder import zeros


class Extreme(NamedTuple):
    """A value, the phase (from 0) and the place x of the unshifted motion where it is reached."""

    value: float
    phase: int
    x: float


class Bounds(NamedTuple):
    """The lowest and the highest of a quantity over the cycle; one-sided limits count."""

    lowest: Extreme
    highest: Extreme

    @property
    def peak(self) -> float:
        """The largest size."""
        return max(abs(self.lowest.value), abs(self.highest.value))


class Energy(NamedTuple):
    """Energy at a motor's shaft over a cycle (J): what it drives with, and what comes back to it, both 0 or more."""

    driving: float
    regenerated: float

    @property
    def net(self) -> float:
        """∮ T dφ."""
        return self.driving - self.regenerated


class Energies(NamedTuple):
    """The same of several motors, one value each."""

    driving: Array
    regenerated: Array


@dataclass(frozen=True)
class DriveResults:
    """What a cycle asks for. Everything is exact for constant ratios; else right to about 1e-12."""

    drive_cycle: DriveCycle

    @cached_property
    def speed(self) -> Bounds:
        """Speed of the motor (rad/s)."""
        return _bounds(
            (one, u, one.motor_speed(u)) for one in self.drive_cycle.torque_intervals for u in (_speed_candidates(one),)
        )

    @cached_property
    def torque(self) -> Bounds:
        """Torque of the motor (Nm)."""
        return self.shaft_torque(0)

    def shaft_torque(self, shaft: int) -> Bounds:
        """Return the torque (Nm) that drives a shaft; behind the motor's, of what a stage gives."""
        return _bounds(
            (one, u, one.torque(u, shaft))
            for one in self.drive_cycle.torque_intervals
            for u in (_torque_candidates(one, shaft),)
        )

    @property
    def brake_torque(self) -> float:
        """The largest torque that a brake holds in dwells, at the motor's shaft (Nm)."""
        return max(one.brake_torque for one in self.drive_cycle.torque_intervals)

    @cached_property
    def power(self) -> Bounds:
        """Power (W) of the motor, with the losses of its winding."""
        return _bounds(
            (one, u, one.power(u)) for one in self.drive_cycle.torque_intervals for u in (_searched(one, one.power),)
        )

    @cached_property
    def rms_torque(self) -> float:
        """sqrt(∫T² dt/t) over the cycle (Nm). Source: S4, T_RMS."""
        scale = self.torque.peak**2

        def square(one: TorqueInterval) -> Function:
            return lambda u: one.torque(u) ** 2

        return math.sqrt(self._total(square, scale) / self.drive_cycle.unshifted.total)

    @cached_property
    def mean_speed(self) -> float:
        """∫|ω| dt/t over the cycle (rad/s): where the RMS torque is held to the continuous limit."""
        return self._total(_turning, self.speed.peak) / self.drive_cycle.unshifted.total

    @cached_property
    def energy(self) -> Energy:
        """Energy of the motor over the cycle, with the losses of its winding."""
        scale = self.torque.peak * self.speed.peak
        parts = [
            (one, *ends)
            for one in self.drive_cycle.torque_intervals
            for ends in pairwise([one.low, *one.power_reversals, one.high])
        ]
        each = [integral(one.power, low, high, scale) / one.speed for one, low, high in parts]
        return Energy(math.fsum(e for e in each if e > 0.0), -math.fsum(e for e in each if e < 0.0))

    def mean_shaft_torque(self, shaft: int) -> float:
        """Return the cubic mean of a shaft's torque, weighted by its speed (Nm); 0 where it stands all the time.

        ³√(∫|ω| |T|³ dt/∫|ω| dt). Source: Harmonic Drive, engineering data, average output torque T_av.
        """
        fastest, peak = self.speed.peak, self.shaft_torque(shaft).peak

        def cube(one: TorqueInterval) -> Function:
            return lambda u: np.abs(one.motor_speed(u) * one.torque(u, shaft) ** 3)

        cubes, ways = self._total(cube, fastest * peak**3), self._total(_turning, fastest)
        return math.cbrt(cubes / ways) if ways else 0.0

    def _total(self, function: Callable[[TorqueInterval], Function], scale: float) -> float:
        """Return the integral over the abscissa of a function of each interval that grows to a scale."""
        return math.fsum(integral(function(one), one.low, one.high, scale) for one in self.drive_cycle.torque_intervals)


def _turning(one: TorqueInterval) -> Function:
    return lambda u: np.abs(one.motor_speed(u))


def _bounds(found: Iterable[tuple[TorqueInterval, Array, Array]]) -> Bounds:
    ends = [
        Extreme(float(values[k]), one.piece.phase, one.piece.begin + float(u[k]))
        for one, u, values in found
        for k in (int(values.argmin()), int(values.argmax()))
    ]
    return Bounds(min(ends), max(ends, key=lambda end: end.value))


def _speed_candidates(one: TorqueInterval) -> Array:
    """Return where the motor can be fastest: at the ends and where y'' is 0; where the ratio changes, by a search."""
    if one.train.linkage:
        return _searched(one, one.motor_speed)
    acceleration = trimmed(position(one.piece).derivative().derivative())
    return np.array([one.low, *_within(one, zeros(acceleration, one.piece.duration)), one.high])


def _torque_candidates(one: TorqueInterval, shaft: int) -> Array:
    """Return where a torque can be largest: at the ends and where its slope is 0; where the ratio changes, searched."""
    curve = one.curve(shaft)
    if curve is None:
        return _searched(one, lambda u: one.torque(u, shaft))
    return np.array([one.low, *_within(one, zeros(trimmed(curve.derivative()), one.piece.duration)), one.high])


def _within(one: TorqueInterval, places: Iterable[float]) -> list[float]:
    return [u for u in places if one.low < u < one.high]


def _searched(one: TorqueInterval, function: Function) -> Array:
    lowest, highest = extremes(function, one.low, one.high, one.nodes)
    return np.array([one.low, lowest.x, highest.x, one.high])
