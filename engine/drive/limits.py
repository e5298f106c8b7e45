"""Limits of a motor and a reducer, a cycle checked against them, and the highest rate within all. SI units."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.motor import LimitCheck, Motor
from engine.drive.results import DriveResults
from engine.drive.search import extremes
from engine.laws.base import Array

BELOW = "torque below the curve"
NEAR = 1e-9  # share by which equal rates may differ


@dataclass(frozen=True)
class ReducerLimits:
    """Limits of a reducer, by default infinite. Raises ValueError for one not above 0, or a factor below 1."""

    peak_torque: float = math.inf  # at its output (Nm), up to ``full_rate``; divided by ``cycle_factor`` beyond
    mean_torque: float = math.inf  # cubic mean at its output, weighted by speed (Nm)
    input_speed: float = math.inf  # rad/s
    full_rate: float = math.inf  # cycles per second
    cycle_factor: float = 1.0  # f_s

    def __post_init__(self) -> None:
        for name in ("peak_torque", "mean_torque", "input_speed", "full_rate"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"reducer: {name} is {getattr(self, name):g}; expected more than 0")
        if not self.cycle_factor >= 1.0:
            raise ValueError(f"reducer: cycle_factor is {self.cycle_factor:g}; expected 1 or more")

    def peak_at(self, rate: float) -> float:
        """Return the limit of the peak torque (Nm) at a rate (1/s)."""
        return self.peak_torque / float(cycle_factor_at(rate, self.full_rate, self.cycle_factor))


NO_LIMITS = ReducerLimits()


def cycle_factor_at(rate: ArrayLike, full_rate: ArrayLike, factor: ArrayLike) -> Array:
    """Return the divisor of reducers' peak torques: the cycle factor beyond their full rate, else 1.

    Parameters
    ----------
    rate, full_rate : array_like, 1/s
        Cycles per second, and those up to which the peak torque holds in full.
    factor : array_like
        f_s, 1 or more.

    Returns
    -------
    array
        Dimensionless.
    """
    return np.where(np.asarray(rate) > np.asarray(full_rate) * (1.0 + NEAR), factor, 1.0)


@dataclass(frozen=True)
class LimitChecks:
    """A cycle checked against the limits of a motor and a reducer."""

    drive_cycle: DriveCycle
    motor: Motor
    reducer: ReducerLimits = NO_LIMITS

    @cached_property
    def results(self) -> DriveResults:
        """Peaks and means of the cycle."""
        return DriveResults(self.drive_cycle)

    @cached_property
    def checks(self) -> tuple[LimitCheck, ...]:
        """A check for each finite limit: RMS torque and torque below the curve (Nm), speed (rad/s), the reducer's."""
        motor, reducer, found = self.motor, self.reducer, self.results
        asked: dict[str, tuple[float, Callable[[], float]]] = {
            "RMS torque": (self.continuous, lambda: found.rms_torque),
            BELOW: (motor.peak_torque, lambda: found.torque.peak),
            "motor speed": (motor.max_speed, lambda: found.speed.peak),
            "reducer input speed": (reducer.input_speed, lambda: found.speed.peak),
            "reducer peak torque": (reducer.peak_at(1.0 / self.drive_cycle.time), lambda: found.shaft_torque(1).peak),
            "reducer mean torque": (reducer.mean_torque, lambda: found.mean_shaft_torque(1)),
        }
        return tuple(
            self._below_curve if name == BELOW else LimitCheck(name, quantity(), limit)
            for name, (limit, quantity) in asked.items()
            if limit < math.inf
        )

    @property
    def ok(self) -> bool:
        """Whether every limit is held."""
        return all(check.ok for check in self.checks)

    @property
    def worst(self) -> LimitCheck:
        """The check whose limit is used most; one with an empty name if there are no limits."""
        return max(self.checks, key=lambda check: check.use, default=LimitCheck("", 0.0, math.inf))

    @cached_property
    def continuous(self) -> float:
        """The motor's continuous torque at the mean speed of the cycle (Nm)."""
        motor = self.motor
        level = motor.stall_torque <= motor.rated_torque
        return motor.rated_torque if level else float(motor.continuous(self.results.mean_speed))

    @cached_property
    def _below_curve(self) -> LimitCheck:
        """|T| and the curve, constant beyond the motor's largest speed, at the least reserve (Nm)."""
        motor = self.motor

        def worst(interval: TorqueInterval, least: float) -> tuple[float, float]:
            def excess(u: Array) -> Array:
                speed = np.minimum(np.abs(interval.motor_speed(u)), motor.max_speed)
                return np.abs(interval.torque(u)) - motor.peak_at(speed)

            ((found, u),) = extremes(excess, interval.samples, (1.0,), least)
            return found, float(np.abs(interval.torque(np.array([u])))[0])

        over, torque = -math.inf, 0.0
        for interval in self.drive_cycle.torque_intervals:
            over, torque = max((over, torque), worst(interval, over))
        return LimitCheck(BELOW, torque, torque - over)


FAR = 1e6  # factor of the present rate up to which, and down to whose inverse, the highest rate is searched
CLOSE = 1e-10  # relative tolerance of the highest rate


class HighestRate(NamedTuple):
    """The highest speed of the abscissa at which every check holds, and the limiting factor."""

    speed: float  # units of the abscissa per s; 0 below a millionth of the present one, infinite above a million times
    limit: str  # name of the limiting factor; empty if there is none


def highest_rate(checks: LimitChecks) -> HighestRate:
    """Return the highest rate of an axis.

    The search goes from the speed of the cycle upwards if all checks hold, else downwards, to the first change. At the
    speed found all checks hold; at 1 + 2e-10 times it the named one does not.
    """
    speed, way = checks.drive_cycle.speed, 2.0 if checks.ok else 0.5
    known = speed
    while at_speed(checks, way * known).ok == checks.ok:
        known *= way
        if not 1.0 / FAR < known / speed < FAR:
            return HighestRate(math.inf, "") if checks.ok else HighestRate(0.0, at_speed(checks, known).worst.name)
    from scipy.optimize import brentq  # slow to import, and most commands need no highest rate

    met = brentq(
        lambda rate: min(at_speed(checks, rate).worst.use, 2.0) - 1.0, *sorted((known, way * known)), rtol=CLOSE
    )
    return HighestRate(met * (1.0 - 2.0 * CLOSE), at_speed(checks, met * (1.0 + 2.0 * CLOSE)).worst.name)


def at_speed(checks: LimitChecks, speed: float) -> LimitChecks:
    """Return the checks of the same cycle at another speed of the abscissa (units per s)."""
    return replace(checks, drive_cycle=replace(checks.drive_cycle, speed=speed))
