"""What a cycle asks of motor, gears and mains: peaks, RMS torque, energy, mean power, exact and not from samples."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.search import extremes, integral
from engine.laws.base import Array
from engine.laws.ladder import Curve, zeros

OfInterval = Callable[[TorqueInterval, Array], Array]  # a quantity of a torque interval at its u
HOUR = 3600.0  # s


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
    """Energy at the shaft of a motor, or of several, over a cycle (J): what drives, what comes back, both 0 or more."""

    driving: Any
    regenerated: Any

    @property
    def net(self) -> Any:
        """∮ T dφ."""
        return self.driving - self.regenerated


@dataclass(frozen=True)
class DriveResults:
    """What a cycle asks for. Everything is exact for constant ratios; else right to about 1e-12."""

    drive_cycle: DriveCycle

    @cached_property
    def speed(self) -> Bounds:
        """Speed of the motor (rad/s)."""
        return self._bounds(TorqueInterval.motor_speed, lambda one: None if one.train.linkage else one.piece.curves[1])

    @cached_property
    def torque(self) -> Bounds:
        """Torque of the motor (Nm)."""
        return self.shaft_torque(0)

    def shaft_torque(self, shaft: int) -> Bounds:
        """Return the torque (Nm) that drives a shaft; behind the motor's, of what a stage gives."""
        return self._bounds(lambda one, u: one.torque(u, shaft), lambda one: one.curve(shaft))

    @cached_property
    def power(self) -> Bounds:
        """Power (W) of the motor, with the losses of its winding."""
        return self._bounds(TorqueInterval.power, lambda _: None)

    @cached_property
    def rms_torque(self) -> float:
        """sqrt(∫T² dt/t) over the cycle (Nm). Source: S4, T_RMS."""
        squares = self._total(lambda one, u: one.torque(u) ** 2, self.torque.peak**2)
        return math.sqrt(squares / self.drive_cycle.unshifted.total)

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
        """Return ³√(∫|ω||T|³ dt/∫|ω| dt) of a shaft (Nm), 0 at rest: Harmonic Drive, average output torque T_av."""
        fastest, peak = self.speed.peak, self.shaft_torque(shaft).peak
        cubes = self._total(lambda one, u: np.abs(one.motor_speed(u) * one.torque(u, shaft) ** 3), fastest * peak**3)
        ways = self._total(_turning, fastest)
        return math.cbrt(cubes / ways) if ways else 0.0

    def _total(self, of: OfInterval, scale: float) -> float:
        """Return the integral over the abscissa of a quantity that grows to a scale."""
        each = ((partial(of, one), one.low, one.high) for one in self.drive_cycle.torque_intervals)
        return math.fsum(integral(*one, scale) for one in each)

    def _bounds(self, of: OfInterval, curve: Callable[[TorqueInterval], Curve | None]) -> Bounds:
        """Return the extremes of a quantity: at ends of intervals, where its curve over u is level, or by a search."""
        ends = []
        for one in self.drive_cycle.torque_intervals:
            if (over := curve(one)) is None:
                inner = [found.x for found in extremes(partial(of, one), one.low, one.high, one.nodes)]
            else:
                inner = [u for u in zeros(over.derivative(), one.piece.duration) if one.low < u < one.high]
            u = np.array([one.low, *inner, one.high])
            values = of(one, u)
            for k in (int(values.argmin()), int(values.argmax())):
                ends.append(Extreme(float(values[k]), one.piece.phase, one.piece.begin + float(u[k])))
        return Bounds(min(ends), max(ends, key=lambda end: end.value))


def _turning(one: TorqueInterval, u: Array) -> Array:
    return np.abs(one.motor_speed(u))


class MeanBusPower(NamedTuple):
    """Mean power (W) of a drive, or of designs of it, on a DC bus of its own: from the mains, in the brake resistor."""

    mains: Any
    resistor: Any

    def energy_a_year(self, hours: float) -> Any:
        """Return the energy from the mains (J) in a year of so many hours."""
        return self.mains * hours * HOUR

    @property
    def net(self) -> Any:
        """What is used up on the way (W)."""
        return self.mains - self.resistor

    @property
    def least(self) -> Any:
        """The least mean power from the mains, if all that comes back were kept and used."""
        return np.maximum(0.0, self.net)


def mean_bus_power(energy: Energy, time: Any, efficiency: float) -> MeanBusPower:
    """Return the means of an energy at a motor's shaft, exact: E/η where it drives, η E where it is driven."""
    return MeanBusPower(energy.driving / efficiency / time, energy.regenerated * efficiency / time)


class PeakBusPower(NamedTuple):
    """Largest power (W): from the mains, and into the brake resistor, of a drive that shares its DC bus with none."""

    mains: float
    resistor: float


def peak_bus_power(highest: float, lowest: float, efficiency: float) -> PeakBusPower:
    """Return them from the highest and the lowest power at a motor's shaft (W)."""
    return PeakBusPower(max(0.0, highest) / efficiency, max(0.0, -lowest) * efficiency)


def total_bus_power(found: Sequence[MeanBusPower]) -> MeanBusPower:
    """Return the sums over drives."""
    return MeanBusPower(sum(one.mains for one in found), sum(one.resistor for one in found))
