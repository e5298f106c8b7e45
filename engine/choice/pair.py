"""One pair of motor and reducer over the cycle: torque and speed of the motor, reserves, the checks. SI units."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from engine.choice.catalogue import Motors, Reducers
from engine.choice.curve import TorqueCurve
from engine.choice.ratios import best_ratio
from engine.choice.task import Task
from engine.drivetrain import STANDSTILL, LimitCheck, OperatingPoints, Stage, direction
from engine.laws.base import Array


@dataclass(frozen=True)
class LoadSamples:
    """A load over one cycle at its own shaft: time (s), ω_L (rad/s), ω̇_L (rad/s²), T*_L (Nm)."""

    time: Array
    speed: Array
    acceleration: Array
    torque: Array

    @property
    def cycle_time(self) -> float:
        """t_C in s"""
        return float(self.time[-1] - self.time[0])

    def torque_needed(self, factor: float = 1.0) -> float:
        """Return what a reducer must hold: ``factor`` times max |T*_L| (Nm), for shocks or many cycles an hour."""
        return factor * float(np.abs(self.torque).max())


@dataclass(frozen=True)
class Pair:
    """One motor of a catalogue with one reducer, by their places."""

    motors: Motors
    reducers: Reducers
    motor: int
    reducer: int

    @property
    def inertia(self) -> float:
        """J_M + J_T (kg m²) at the motor's shaft."""
        return float(self.motors.inertia[self.motor] + self.reducers.inertia[self.reducer])

    @property
    def ratio(self) -> float:
        """τ = ω_L/ω_M"""
        return float(self.reducers.ratio[self.reducer])

    @property
    def efficiency(self) -> float:
        """η"""
        return float(self.reducers.efficiency[self.reducer])

    @property
    def stage(self) -> Stage:
        """The reducer in the chain from motor to load."""
        return Stage("reducer", float(self.reducers.reduction[self.reducer]), self.efficiency)

    @property
    def curve(self) -> TorqueCurve:
        """Largest torque of the motor against its speed."""
        return self.motors.curve(self.motor)

    @property
    def rated_torque(self) -> float:
        """T_M,N in Nm"""
        return float(self.motors.rated_torque[self.motor])

    def balance(self, task: Task) -> float:
        """Return τ/τ_opt, with the reducer's efficiency and inertia; NaN for a load that does not move.

        Source: S5, eq. (18), step 7.
        """
        return self.ratio / float(best_ratio(task, self.inertia, self.efficiency))

    def points(self, load: LoadSamples) -> OperatingPoints:
        """Return speed, torque and power of the motor over the cycle.

        T_M = (J_M + J_T) ω̇_L/τ + τ T*_L f, f = 1/η where the load is driven or stands, η where it drives.
        Source: S5, step 7; f as in :mod:`engine.drivetrain.losses`.
        """
        own = self.inertia / self.ratio * load.acceleration
        torque = own + self.stage.before(load.torque, direction(load.speed))
        speed = load.speed / self.ratio
        return OperatingPoints(speed, torque, torque * speed, load.time)

    def margin(self, points: OperatingPoints) -> float:
        """Return T_M,N/T_M,rms; 0 where the motor has no torque at all."""
        return self.rated_torque / points.rms_torque if points.rms_torque > 0.0 else 0.0

    def reserve(self, points: OperatingPoints) -> Array:
        """Return how far |T_M| stays below the motor's curve at the speed of each instant (Nm); negative above."""
        return self.curve.at(points.speed) - np.abs(points.torque)

    def checks(self, points: OperatingPoints, load: LoadSamples, factor: float = 1.0) -> tuple[LimitCheck, ...]:
        """Return step 7's checks: RMS torque, torque below the curve, speeds, the reducer's torque.

        The second shows |T_M| and the curve where the reserve is least, and does not hold beyond the largest speed.
        ``factor``: as in :meth:`LoadSamples.torque_needed`. Source: S5, step 7.
        """
        fastest = float(self.motors.max_speed[self.motor])
        reserve = self.reserve(points)
        k = int(np.argmin(reserve))
        torque, below = float(np.abs(points.torque[k])), bool(reserve[k] >= 0.0) and points.max_speed <= fastest
        return (
            _check("RMS torque", points.rms_torque, self.rated_torque),
            LimitCheck("torque below the curve", torque, torque + float(reserve[k]), below),
            _check("motor speed", points.max_speed, fastest),
            _check("reducer input speed", points.max_speed, float(self.reducers.max_input_speed[self.reducer])),
            _check(
                "reducer output torque",
                load.torque_needed(factor),
                float(self.reducers.max_output_torque[self.reducer]),
            ),
        )


def square_steps(time: Array, torque: Array) -> Array:
    """Return ∫T² dt (Nm² s) of the step that leads to each sample, 0 at the first, by the trapezoidal rule."""
    square = torque**2
    return np.concatenate([[0.0], np.diff(time) * (square[1:] + square[:-1]) / 2.0])


def reverses(points: OperatingPoints) -> bool:
    """Return whether the motor turns backwards at any time."""
    return bool(points.speed.min() < -STANDSTILL)


def _check(name: str, value: float, limit: float) -> LimitCheck:
    return LimitCheck(name, value, limit, value <= limit)
