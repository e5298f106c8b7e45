"""The limits of a motor and of a reducer, and how near a cycle comes to each. SI units."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.motor import LimitCheck, Motor, TorqueCurve
from engine.drive.results import DriveResults
from engine.drive.search import Function, largest
from engine.laws.base import Array

BELOW = "torque below the curve"
NEAR = 1e-9
"""by which share a rate may be above another and count as the same"""


@dataclass(frozen=True)
class ReducerLimits:
    """Largest peak and mean torque (Nm) behind the first stage, and largest speed before it (rad/s).

    The peak torque holds up to ``full_rate`` cycles (1/s), beyond over ``cycle_factor``. The mean is the cubic one,
    weighted by speed (:meth:`engine.drive.results.DriveResults.mean_shaft_torque`). No limit is given by infinity.
    Raises ValueError for a limit that is not above 0, or a factor below 1.
    """

    peak_torque: float = math.inf
    mean_torque: float = math.inf
    input_speed: float = math.inf
    full_rate: float = math.inf
    cycle_factor: float = 1.0

    def __post_init__(self) -> None:
        for name in ("peak_torque", "mean_torque", "input_speed", "full_rate"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"reducer: {name} is {getattr(self, name):g}; expected more than 0")
        if not self.cycle_factor >= 1.0:
            raise ValueError(f"reducer: cycle_factor is {self.cycle_factor:g}; expected 1 or more")

    def peak_at(self, rate: float) -> float:
        """Return the largest peak torque (Nm) at so many cycles (1/s)."""
        return self.peak_torque / float(factor_at(rate, self.full_rate, self.cycle_factor))


def factor_at(rate: ArrayLike, full_rate: ArrayLike, factor: ArrayLike) -> Array:
    """Return what reducers' peak torques are divided by at so many cycles (1/s): a factor beyond ``full_rate``."""
    return np.where(np.asarray(rate) > np.asarray(full_rate) * (1.0 + NEAR), factor, 1.0)


@dataclass(frozen=True)
class Limits:
    """What a drive must hold: the motor's limits and its peak torque's curve, a reducer's, the greatest inertia ratio.

    The inertia ratio J_machine/J_m is taken where it is greatest: behind a ratio that changes it changes with it.
    """

    motor: Motor
    curve: TorqueCurve | None = None
    reducer: ReducerLimits = field(default_factory=ReducerLimits)
    inertia_ratio: float = math.inf

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
        """RMS torque, torque below the curve, speed, the reducer's three, inertia ratio; each in the limit's unit."""
        return tuple(self._checked(name) for name in self._limits)

    @property
    def ok(self) -> bool:
        """Whether every limit is held."""
        return all(check.ok for check in self._limiting)

    @property
    def worst(self) -> LimitCheck | None:
        """The check whose limit is used most; None without any limit."""
        return max(self._limiting, key=lambda check: check.use, default=None)

    @property
    def _limits(self) -> dict[str, float]:
        motor, reducer = self.limits.motor, self.limits.reducer
        return {
            "RMS torque": self.continuous,
            BELOW: float(self.limits.peak_curve.torque.max()),
            "motor speed": min(motor.max_speed, float(self.limits.peak_curve.speed[-1])),
            "reducer input speed": reducer.input_speed,
            "reducer peak torque": reducer.peak_at(1.0 / self.drive_cycle.time),
            "reducer mean torque": reducer.mean_torque,
            "inertia ratio": self.limits.inertia_ratio,
        }

    @cached_property
    def continuous(self) -> float:
        """What the motor can give all the time at the mean speed of the cycle (Nm)."""
        motor = self.limits.motor
        level = motor.stall_torque <= motor.rated_torque
        return motor.rated_torque if level else float(motor.continuous(self.results.mean_speed))

    @cached_property
    def _limiting(self) -> tuple[LimitCheck, ...]:
        """The checks of what has a limit."""
        return tuple(self._checked(name) for name, limit in self._limits.items() if limit < math.inf)

    def _checked(self, name: str) -> LimitCheck:
        if name == BELOW:
            return self._below_curve
        values: dict[str, Callable[[], float]] = {
            "RMS torque": lambda: self.results.rms_torque,
            "motor speed": lambda: self.results.speed.peak,
            "reducer input speed": lambda: self.results.speed.peak,
            "reducer peak torque": lambda: self.results.shaft_torque(1).peak,
            "reducer mean torque": lambda: self.results.mean_shaft_torque(1),
            "inertia ratio": lambda: self.inertia_ratio,
        }
        value, limit = values[name](), self._limits[name]
        return LimitCheck(name, value, limit, value <= limit)

    @cached_property
    def inertia_ratio(self) -> float:
        """Largest J_machine/J_m over the cycle; 0 of a motor without inertia."""
        train = self.drive_cycle.train
        own = train.drive.motor_inertia
        if not own or not train.inertia_varies:
            return train.drive.inertia_ratio
        return self.machine_inertia / own

    @cached_property
    def machine_inertia(self) -> float:
        """The largest inertia of all behind the motor at its shaft over the cycle (kg m²)."""
        found = (
            largest(_machine_inertia(one), one.low, one.high, one.nodes)[0] for one in self.drive_cycle.torque_intervals
        )
        return max(found)

    @cached_property
    def _below_curve(self) -> LimitCheck:
        """|T| and the curve where the reserve is least; beyond its last corner the curve is taken to go on level.

        The speed has a check of its own.
        """
        curve = self.limits.peak_curve
        if self._limits[BELOW] == math.inf:
            return LimitCheck(BELOW, self.results.torque.peak, math.inf, True)

        last = float(curve.speed[-1])

        def worst(one: TorqueInterval, least: float) -> tuple[float, float]:
            def lack(u: Array) -> Array:
                return np.asarray(np.abs(one.torque(u)) - curve.at(np.clip(one.motor_speed(u), -last, last)))

            lacking, u = largest(lack, one.low, one.high, one.nodes, least)
            return lacking, float(np.abs(one.torque(np.array([u])))[0])

        lacking, torque = -math.inf, 0.0
        for one in self.drive_cycle.torque_intervals:
            lacking, torque = max((lacking, torque), worst(one, lacking))
        return LimitCheck(BELOW, torque, torque - lacking, lacking <= 0.0)


def _machine_inertia(one: TorqueInterval) -> Function:
    """Return the inertia of all behind the motor at its shaft (kg m²) as a function of u."""
    drive = one.train.drive
    m = drive.mechanism
    fixed = math.fsum(m.at_motor(m.on_shaft(k), k) for k in range(m.last))

    def inertia(u: Array) -> Array:
        return np.asarray(fixed + m.on_shaft(m.last) * (one.train.travel(one.load(u).y) / one.train.gear) ** 2)

    return inertia
