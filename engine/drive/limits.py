"""The limits of a motor and of a reducer, how near a cycle comes to each, and the highest rate within all. SI units."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.motor import LimitCheck, Motor, TorqueCurve
from engine.drive.results import DriveResults
from engine.drive.search import extremes
from engine.laws.base import Array

BELOW = "torque below the curve"
NEAR = 1e-9  # by which share a rate may be above another and count as the same


@dataclass(frozen=True)
class ReducerLimits:
    """Limits of a reducer, infinite where none is given. Raises ValueError for one not above 0, or a factor below 1."""

    peak_torque: float = math.inf  # behind the first stage (Nm), up to ``full_rate``; beyond over ``cycle_factor``
    mean_torque: float = math.inf  # the cubic one, weighted by speed (Nm)
    input_speed: float = math.inf  # rad/s, before the first stage
    full_rate: float = math.inf  # cycles (1/s)
    cycle_factor: float = 1.0

    def __post_init__(self) -> None:
        for name in ("peak_torque", "mean_torque", "input_speed", "full_rate"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"reducer: {name} is {getattr(self, name):g}; expected more than 0")
        if not self.cycle_factor >= 1.0:
            raise ValueError(f"reducer: cycle_factor is {self.cycle_factor:g}; expected 1 or more")

    def peak_at(self, rate: float) -> float:
        """Return the largest peak torque (Nm) at so many cycles (1/s)."""
        return self.peak_torque / float(cycle_factor_at(rate, self.full_rate, self.cycle_factor))


def cycle_factor_at(rate: ArrayLike, full_rate: ArrayLike, factor: ArrayLike) -> Array:
    """Return what reducers' peak torques are divided by at so many cycles (1/s): a factor beyond ``full_rate``."""
    return np.where(np.asarray(rate) > np.asarray(full_rate) * (1.0 + NEAR), factor, 1.0)


@dataclass(frozen=True)
class Limits:
    """What a drive must hold: the motor's limits and its peak torque's curve, and a reducer's."""

    motor: Motor
    curve: TorqueCurve | None = None
    reducer: ReducerLimits = field(default_factory=ReducerLimits)

    @property
    def peak_curve(self) -> TorqueCurve:
        """The curve as it is given, or the motor's peak torque up to its largest speed."""
        if self.curve is not None:
            return self.curve
        return TorqueCurve(np.array([0.0, self.motor.max_speed]), np.array([self.motor.peak_torque] * 2))


@dataclass(frozen=True)
class LimitChecks:
    """A cycle against limits: every check, and which of them counts most."""

    drive_cycle: DriveCycle
    limits: Limits

    @cached_property
    def results(self) -> DriveResults:
        """What the cycle asks for."""
        return DriveResults(self.drive_cycle)

    @cached_property
    def checks(self) -> tuple[LimitCheck, ...]:
        """What has a limit of RMS torque, torque below the curve, speed, the reducer's three; each in its unit."""
        motor, reducer, curve, found = self.limits.motor, self.limits.reducer, self.limits.peak_curve, self.results
        asked: dict[str, tuple[float, Callable[[], float]]] = {
            "RMS torque": (self.continuous, lambda: found.rms_torque),
            BELOW: (float(curve.torque.max()), lambda: found.torque.peak),
            "motor speed": (min(motor.max_speed, float(curve.speed[-1])), lambda: found.speed.peak),
            "reducer input speed": (reducer.input_speed, lambda: found.speed.peak),
            "reducer peak torque": (reducer.peak_at(1.0 / self.drive_cycle.time), lambda: found.shaft_torque(1).peak),
            "reducer mean torque": (reducer.mean_torque, lambda: found.mean_shaft_torque(1)),
        }
        limited = {name: (of, limit) for name, (limit, of) in asked.items() if limit < math.inf}
        return tuple(
            self._below_curve if name == BELOW else LimitCheck(name, of(), limit)
            for name, (of, limit) in limited.items()
        )

    @property
    def ok(self) -> bool:
        """Whether every limit is held."""
        return all(check.ok for check in self.checks)

    @property
    def worst(self) -> LimitCheck:
        """The check whose limit is used most; one of no name without any limit."""
        return max(self.checks, key=lambda check: check.use, default=LimitCheck("", 0.0, math.inf))

    @cached_property
    def continuous(self) -> float:
        """What the motor can give all the time at the mean speed of the cycle (Nm)."""
        motor = self.limits.motor
        level = motor.stall_torque <= motor.rated_torque
        return motor.rated_torque if level else float(motor.continuous(self.results.mean_speed))

    @cached_property
    def _below_curve(self) -> LimitCheck:
        """|T| and the curve where the reserve is least; beyond its last corner it goes on level: speed has a check."""
        curve = self.limits.peak_curve
        last = float(curve.speed[-1])

        def worst(one: TorqueInterval, least: float) -> tuple[float, float]:
            def lack(u: Array) -> Array:
                return np.asarray(np.abs(one.torque(u)) - curve.at(np.clip(one.motor_speed(u), -last, last)))

            ((lacking, u),) = extremes(lack, one.low, one.high, one.nodes, (1.0,), least)
            return lacking, float(np.abs(one.torque(np.array([u])))[0])

        lacking, torque = -math.inf, 0.0
        for one in self.drive_cycle.torque_intervals:
            lacking, torque = max((lacking, torque), worst(one, lacking))
        return LimitCheck(BELOW, torque, torque - lacking)


FAR = 1e6  # times the rate that is asked about: no further is looked, up or down
CLOSE = 1e-10  # of the rate: how near to the highest rate is near enough


class HighestRate(NamedTuple):
    """The highest speed of the abscissa at which every check holds, and what binds there."""

    speed: float  # 1/s; 0 where one fails at a millionth of that asked about, infinite where none does at a million
    axis: str  # that binds
    limit: str  # that binds; no name where none does


def highest_rate(axes: Mapping[str, LimitChecks]) -> HighestRate:
    """Return the highest rate of axes that are driven by one shaft, or in one time.

    It is looked for from the speed of each cycle: upwards where all hold, downwards where one does not, to the first
    change. At the speed found all hold, and a little above it the named limit does not.
    """
    found = ((name, *highest_rate_of_axis(checks)) for name, checks in axes.items())
    each = [HighestRate(speed, name, limit) for name, speed, limit in found if limit]
    return min(each, default=HighestRate(math.inf, "", ""))


def highest_rate_of_axis(checks: LimitChecks) -> tuple[float, str]:
    """Return the highest speed of one axis, and the limiting factor."""
    speed, way = checks.drive_cycle.speed, 2.0 if checks.ok else 0.5
    known = speed
    while at_speed(checks, way * known).ok == checks.ok:
        known *= way
        if not 1.0 / FAR < known / speed < FAR:
            return (math.inf, "") if checks.ok else (0.0, at_speed(checks, known).worst.name)
    from scipy.optimize import brentq  # slow to import, and most commands need no highest rate

    met = brentq(
        lambda rate: min(at_speed(checks, rate).worst.use, 2.0) - 1.0, *sorted((known, way * known)), rtol=CLOSE
    )
    return met * (1.0 - 2.0 * CLOSE), at_speed(checks, met * (1.0 + 2.0 * CLOSE)).worst.name


def at_speed(checks: LimitChecks, speed: float) -> LimitChecks:
    """Return the same cycle and limits at another speed of the abscissa."""
    return LimitChecks(replace(checks.drive_cycle, speed=speed), checks.limits)
