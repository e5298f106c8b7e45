"""Results of a drive's cycle, exact and not from samples: peaks, RMS torque, energy; mean powers of a DC bus."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial, reduce
from itertools import pairwise
from operator import add
from typing import Any, NamedTuple

import numpy as np

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.search import crossings, extremes, integral
from engine.laws.base import Array
from engine.laws.extremes import Curve, zeros

# a quantity of a torque interval as a function of u
OfInterval = Callable[[TorqueInterval, Array], Array]
HOUR = 3600.0  # s


class Extreme(NamedTuple):
    """An extreme of a quantity over the cycle."""

    value: float
    phase: int  # number of the phase, from 0
    x: float  # abscissa of the unshifted motion


class Bounds(NamedTuple):
    """The lowest and the highest value of a quantity over the cycle; one-sided limits count."""

    lowest: Extreme
    highest: Extreme

    @property
    def peak(self) -> float:
        """The largest absolute value."""
        return max(abs(self.lowest.value), abs(self.highest.value))


class Energy(NamedTuple):
    """Energy at the shaft of a motor over a cycle (J); floats, or arrays over several drives."""

    driving: Any  # where the motor drives, 0 or more
    regenerated: Any  # where the motor is driven, 0 or more

    @property
    def net(self) -> Any:
        """∮ T dφ (J)."""
        return self.driving - self.regenerated

    def mean_bus_power(self, time: Any, efficiency: float) -> "MeanBusPower":
        """Return the mean powers of a drive on its own DC bus over a time (s): E/η drawn, η E regenerated."""
        return MeanBusPower(self.driving / efficiency / time, self.regenerated * efficiency / time)


@dataclass(frozen=True)
class DriveResults:
    """Peaks and means of a cycle: exact for constant ratios, else to about 1e-12."""

    drive_cycle: DriveCycle

    @cached_property
    def speed(self) -> Bounds:
        """Speed of the motor (rad/s)."""
        return self._bounds(
            TorqueInterval.motor_speed, lambda part: None if part.train.linkage else part.piece.curves[1]
        )

    @cached_property
    def torque(self) -> Bounds:
        """Torque of the motor (Nm)."""
        return self.shaft_torque(0)

    def shaft_torque(self, shaft: int, parts: Iterable[TorqueInterval] | None = None) -> Bounds:
        """Return the bounds of the torque (Nm) that drives a shaft: 0 is the motor's, 1 the reducer's output.

        Of ``parts`` of the cycle alone, if these are given.
        """
        return self._bounds(lambda part, u: part.torque(u, shaft), lambda part: part.curve(shaft), parts)

    @cached_property
    def power(self) -> Bounds:
        """Power (W) of the motor, with the losses of its winding."""
        return self._bounds(TorqueInterval.power, lambda _: None)

    @cached_property
    def rms_torque(self) -> float:
        """√(∫T² dt/t) over the cycle (Nm). Source: S4, T_RMS."""
        squares = self._total(lambda part, u: part.torque(u) ** 2, self.torque.peak**2)
        return math.sqrt(squares / self.drive_cycle.unshifted.total)

    @cached_property
    def mean_speed(self) -> float:
        """∫|ω| dt/t over the cycle (rad/s), at which the continuous torque limits the RMS torque."""
        return self._total(_turning, self.speed.peak) / self.drive_cycle.unshifted.total

    @cached_property
    def energy(self) -> Energy:
        """Energy of the motor over the cycle, with the losses of its winding."""
        scale = self.torque.peak * self.speed.peak
        each = []
        for interval in self.drive_cycle.torque_intervals:
            # copper losses alone change the power's sign within an interval
            reversals = crossings(interval.power, interval.samples) if interval.train.copper else []
            for low, high in pairwise([interval.low, *reversals, interval.high]):
                each.append(integral(interval.power, low, high, scale) / interval.speed)
        return Energy(math.fsum(e for e in each if e > 0.0), -math.fsum(e for e in each if e < 0.0))

    def mean_shaft_torque(self, shaft: int) -> float:
        """Return ³√(∫|ω||T|³ dt/∫|ω| dt) of a shaft (Nm), 0 at rest. Source: Harmonic Drive, T_av."""
        fastest, peak = self.speed.peak, self.shaft_torque(shaft).peak
        cubes = self._total(lambda part, u: np.abs(part.motor_speed(u) * part.torque(u, shaft) ** 3), fastest * peak**3)
        ways = self._total(_turning, fastest)
        return math.cbrt(cubes / ways) if ways else 0.0

    def _total(self, of: OfInterval, scale: float) -> float:
        """Return the integral of a quantity over the abscissa; ``scale`` is its largest absolute value."""
        intervals = self.drive_cycle.torque_intervals
        return math.fsum(integral(partial(of, part), part.low, part.high, scale) for part in intervals)

    def _bounds(
        self,
        of: OfInterval,
        curve: Callable[[TorqueInterval], Curve | None],
        parts: Iterable[TorqueInterval] | None = None,
    ) -> Bounds:
        """Return the bounds of a quantity: at ends of intervals, at zeros of its curve's slope, or by a search."""
        both_ends = []
        for part in self.drive_cycle.torque_intervals if parts is None else parts:
            over = curve(part)
            if over is None:
                inner = [extreme.x for extreme in extremes(partial(of, part), part.samples)]
            else:
                inner = [u for u in zeros(over.slope, part.piece.duration) if part.low < u < part.high]
            u = np.array([part.low, *inner, part.high])
            values = of(part, u)
            for k in (int(values.argmin()), int(values.argmax())):
                both_ends.append(Extreme(float(values[k]), part.piece.phase, part.piece.begin + float(u[k])))
        return Bounds(min(both_ends), max(both_ends, key=lambda extreme: extreme.value))


def _turning(interval: TorqueInterval, u: Array) -> Array:
    return np.abs(interval.motor_speed(u))


class MeanBusPower(NamedTuple):
    """Mean powers of a drive on its own DC bus (W); floats, or arrays over several designs."""

    mains: Any  # from the mains
    resistor: Any  # into the brake resistor

    def energy_a_year(self, hours: float) -> Any:
        """Return the energy from the mains (J) in a year of ``hours`` of operation."""
        return self.mains * hours * HOUR

    @property
    def net(self) -> Any:
        """Mean power that is neither returned nor lost in the resistor (W)."""
        return self.mains - self.resistor


def peak_bus_power(powers: tuple[float, float], efficiency: float) -> tuple[float, float]:
    """Return the peak powers from the mains, P/η, and into the resistor, η P (W), of a drive on its own DC bus.

    ``powers`` are the highest and the lowest at the motor's shaft (W).
    """
    return max(0.0, powers[0]) / efficiency, max(0.0, -powers[1]) * efficiency


def total_bus_power(powers: Sequence[MeanBusPower]) -> MeanBusPower:
    """Return the sum of mean powers over drives, in studies of arrays."""
    mains, resistor = zip(*powers, strict=True)
    # sum() of floats hangs on the Python's version
    return MeanBusPower(reduce(add, mains), reduce(add, resistor))
