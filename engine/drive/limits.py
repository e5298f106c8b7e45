"""Limits of a motor and a reducer; a cycle checked against them, also creeping as a machine starts up. SI units."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.drive_points import DrivePoints
from engine.drive.motor import LimitCheck, Motor
from engine.drive.results import DriveResults
from engine.drive.search import extremes
from engine.laws.base import Array

PEAK_TORQUE, REDUCER_TORQUE = "peak torque", "reducer peak torque"
BELOW, CYCLES = "torque below the curve", "reducer torque at its cycles"
"""names of limits: of a peak torque that falls with speed, of a reducer's beyond its cycles an hour"""
NAMES = ("RMS torque", BELOW, "motor speed", "reducer input speed", REDUCER_TORQUE, "reducer mean torque")
NEAR = 1e-9  # share by which equal rates may differ


@dataclass(frozen=True)
class ReducerLimits:
    """Limits of a reducer, by default infinite. Raises ValueError for a limit not above 0, or a factor below 1."""

    # at its output (Nm), up to ``full_rate``; divided by ``cycle_factor`` beyond
    peak_torque: float = math.inf
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
        return self.of(NAMES)

    def of(self, names: Iterable[str]) -> tuple[LimitCheck, ...]:
        """Return the checks of the finite ones of some limits."""
        motor, reducer, results = self.motor, self.reducer, self.results
        asked: dict[str, tuple[float, Callable[[], float]]] = {
            "RMS torque": (motor.rated_torque, lambda: results.rms_torque),
            BELOW: (motor.peak_torque, lambda: results.torque.peak),
            "motor speed": (motor.max_speed, lambda: results.speed.peak),
            "reducer input speed": (reducer.input_speed, lambda: results.speed.peak),
            REDUCER_TORQUE: (reducer.peak_at(1.0 / self.drive_cycle.time), lambda: results.shaft_torque(1).peak),
            "reducer mean torque": (reducer.mean_torque, lambda: results.mean_shaft_torque(1)),
        }
        return tuple(
            self._below_curve
            if name == BELOW
            else LimitCheck(name, quantity(), self.continuous if name == "RMS torque" else limit)
            for name, (limit, quantity) in ((name, asked[name]) for name in names)
            if limit < math.inf
        )

    @property
    def ok(self) -> bool:
        """Whether every limit is held."""
        return all(check.ok for check in self.checks)

    @property
    def worst(self) -> LimitCheck:
        """The check whose limit is used most; a check with an empty name if there are no limits."""
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

            ((extreme, u),) = extremes(excess, interval.samples, (1.0,), least)
            return extreme, float(np.abs(interval.torque(np.array([u])))[0])

        over, torque = -math.inf, 0.0
        for interval in self.drive_cycle.torque_intervals:
            over, torque = max((over, torque), worst(interval, over))
        return LimitCheck(BELOW, torque, torque - over)


def at_speed(checks: LimitChecks, speed: float) -> LimitChecks:
    """Return the checks of the same cycle at another speed of the abscissa (units per s)."""
    return replace(checks, drive_cycle=replace(checks.drive_cycle, speed=speed))


CREEP_RATE = 1.0 / 60.0  # cycles per second


def creep_factor(time: float) -> float:
    """Return the rate of creeping over that of a cycle of a time (s): at most 1."""
    return min(1.0, CREEP_RATE * time)


def creeping(checks: LimitChecks, loaded: bool) -> LimitChecks:
    """Return the checks of the same drive creeping, exact; its process forces act if it is ``loaded``."""
    cycle = checks.drive_cycle
    train = cycle.train if loaded else replace(cycle.train, windows=())
    return replace(checks, drive_cycle=replace(cycle, train=train, speed=cycle.speed * creep_factor(cycle.time)))


def creep_checks(points: DrivePoints, motor: Motor, reducer: ReducerLimits, rate: float) -> tuple[LimitCheck, ...]:
    """Return the torques of a drive at the points of its cycle against their limits.

    Parameters
    ----------
    points : DrivePoints
        While it creeps.
    motor : Motor
        Of a peak torque that falls with speed, what it has fallen counts as torque.
    reducer : ReducerLimits
    rate : float, 1/s
        Cycles per second, creeping.

    Returns
    -------
    tuple of LimitCheck
        RMS torque and peak torque of the motor, peak and mean torque behind the reducer (Nm).
    """
    behind = points.load.output_torque
    peak = float((abs(points.torque) + motor.falling.fallen(points.speed)).max())
    return (
        LimitCheck("RMS torque", points.rms_torque, float(motor.continuous(points.mean_speed))),
        LimitCheck(PEAK_TORQUE, peak, motor.peak_torque),
        LimitCheck(REDUCER_TORQUE, float(abs(behind).max()), reducer.peak_at(rate)),
        LimitCheck("reducer mean torque", points.cubic_mean(behind), reducer.mean_torque),
    )
