"""Choice of motor and reducer: α, β and the range of transmission ratios that each motor accepts. SI units.

τ = ω_L/ω_M throughout. Misprints of S5 mended here: T²_M,rms and T*²_L,rms without the square, τ_min with the
plus and τ_max with the minus in (14) and (18), τ_opt with J_r for J_L, (20) without the root over k − 1.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drivetrain import Load, Motor
from engine.drivetrain.lossless import LosslessCycle, at_shaft
from engine.laws.base import Array
from engine.motion import Phase

AT_REST = 1e-9
"""of the mean velocity of a phase"""


@dataclass(frozen=True)
class Task:
    """What the load asks for, at its own shaft, over a cycle.

    ``acceleration_rms`` ω̇_L,rms (rad/s²), ``torque_rms`` T*_L,rms (Nm) of the generalized load torque
    T*_L = T_L + J_L ω̇_L, ``power_rate_mean`` (ω̇_L T*_L)_mean (Nm rad/s²), ``max_speed`` ω_L,max (rad/s).
    Raises ValueError unless the acceleration, the torque and the speed are above 0, and |mean| ≤ ω̇_rms T*_rms.
    Source: S5, eqs. (14), (15).
    """

    acceleration_rms: float
    torque_rms: float
    power_rate_mean: float
    max_speed: float

    def __post_init__(self) -> None:
        for name in ("acceleration_rms", "torque_rms", "max_speed"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) > 0.0):
                raise ValueError(f"load: {name} is {getattr(self, name):g}; expected a finite number above 0")
        bound = self.acceleration_rms * self.torque_rms
        if not abs(self.power_rate_mean) <= bound * (1.0 + 1e-9):
            raise ValueError(f"load: power_rate_mean is {self.power_rate_mean:g}; expected −{bound:g} to {bound:g}")

    @classmethod
    def inertial(cls, inertia: float, acceleration_rms: float, max_speed: float) -> Task:
        """Return the task of a purely inertial load J_L (kg m²): T*_L = J_L ω̇_L. Source: S5, before eq. (17)."""
        torque = inertia * acceleration_rms
        return cls(acceleration_rms, torque, acceleration_rms * torque, max_speed)

    @classmethod
    def of_samples(cls, time: ArrayLike, speed: ArrayLike, acceleration: ArrayLike, torque: ArrayLike) -> Task:
        """Return the task of samples over a cycle: ω_L, ω̇_L and T*_L at times (s), by the trapezoidal rule."""
        t, w, dw, load = (np.asarray(values, dtype=np.float64) for values in (time, speed, acceleration, torque))

        def mean(values: Array) -> float:
            return float(np.trapezoid(values, t)) / float(t[-1] - t[0])

        return cls(math.sqrt(mean(dw**2)), math.sqrt(mean(load**2)), mean(dw * load), float(np.abs(w).max()))

    @classmethod
    def of_load(cls, load: Load, phases: Sequence[Phase], radius: float = 1.0) -> Task:
        """Return the task of a load over phases (m and s on a wheel of ``radius`` (m), or rad), exact by the laws.

        As :class:`engine.drivetrain.lossless.LosslessCycle` has them.
        For phases that begin and end at rest. Raises ValueError where one does not, or no phases are given.
        """
        if not phases or not (math.isfinite(radius) and radius > 0.0):
            raise ValueError(f"{len(phases)} phases and radius {radius:g}; expected a phase and a radius above 0")
        for k, phase in enumerate(phases, 1):
            if phase.lift != 0.0 and max(abs(phase.law.start.v), abs(phase.law.end.v)) > AT_REST:
                raise ValueError(f"phase {k}: {phase.law.name} does not begin and end at rest")
        asked = LosslessCycle(load, at_shaft(phases, 1.0 / radius))
        fastest = max(p.law.coefficients.cv * abs(p.lift) / p.duration for p in phases) / radius
        return cls(asked.acceleration, asked.torque, asked.product, fastest)

    @property
    def load_factor(self) -> float:
        """β = 2 (ω̇_L,rms T*_L,rms + (ω̇_L T*_L)_mean), in Nm rad/s². Source: S5, eq. (15)."""
        return 2.0 * (self.acceleration_rms * self.torque_rms + self.power_rate_mean)

    def required_accelerating_factor(self, efficiency: float = 1.0) -> float:
        """Return β/η: a motor with a smaller α cannot do the task with any ratio.

        Source: S5, step 3 (η = 1); Giberti, Cinquemani, Legnani, 'Effects of transmission mechanical
        characteristics on the choice of a motor-reducer', Mechatronics 20 (2010).
        """
        return self.load_factor / efficiency


def accelerating_factor(rated_torque: ArrayLike, inertia: ArrayLike) -> Array:
    """Return α = T_M,N²/J_M (Nm rad/s²). Source: S5, eq. (15)."""
    return np.asarray(np.square(rated_torque, dtype=np.float64) / np.asarray(inertia, dtype=np.float64))


class Ranges(NamedTuple):
    """The transmission ratios that each motor accepts, arrays over the motors; NaN where a motor is rejected."""

    accelerating_factor: Array
    tau_min: Array
    tau_max: Array
    tau_opt: Array
    """at which the RMS torque is smallest; √(τ_min τ_max)"""
    tau_limit: Array
    """τ_M,lim: a smaller ratio drives the motor beyond its largest speed"""
    lowest: Array
    """max(τ_min, τ_M,lim)"""
    accepted: NDArray[np.bool_]
    """whether any ratio at all does"""


def ratio_ranges(
    task: Task, rated_torque: ArrayLike, inertia: ArrayLike, max_speed: ArrayLike, efficiency: float = 1.0
) -> Ranges:
    """Return the range of τ for each motor: T_M,N (Nm), J_M (kg m²), ω_M,max (rad/s).

    τ_min,max = √J_M/(2T) (√(α − β/η + 4 ω̇_rms T) ∓ √(α − β/η)), T = T*_L,rms/η; α < β/η is rejected.
    Raises ValueError unless 0 < η ≤ 1. Source: S5, eqs. (14)–(18), steps 3 and 4.
    """
    _require_efficiency(efficiency)
    rated, moment, fastest = np.broadcast_arrays(
        *(np.asarray(given, dtype=np.float64) for given in (rated_torque, inertia, max_speed))
    )
    alpha = accelerating_factor(rated, moment)
    torque = task.torque_rms / efficiency
    spare = alpha - task.required_accelerating_factor(efficiency)
    root = np.sqrt(np.where(spare >= 0.0, spare, np.nan))
    wide = np.sqrt(root**2 + 4.0 * task.acceleration_rms * torque)
    largest = np.sqrt(moment) / (2.0 * torque) * (wide + root)
    smallest = 2.0 * np.sqrt(moment) * task.acceleration_rms / (wide + root)  # without the difference of roots
    limit = task.max_speed / fastest
    lowest = np.maximum(smallest, limit)
    optimum = np.sqrt(moment * task.acceleration_rms / torque)
    return Ranges(alpha, smallest, largest, optimum, limit, lowest, lowest <= largest)


def ratio_spread(motor_inertia: float, load_inertia: float, k: ArrayLike) -> Array:
    """Return Δτ = τ_max − τ_min = 2 √(J_M/J_L) √(k − 1), k = α/β, of a purely inertial load; NaN where k < 1.

    Source: S5, eq. (20), with the root that it leaves out.
    """
    factor = np.asarray(k, dtype=np.float64)
    return np.asarray(
        2.0 * math.sqrt(motor_inertia / load_inertia) * np.sqrt(np.where(factor >= 1.0, factor - 1, np.nan))
    )


class RatioCurves(NamedTuple):
    """Range of τ of one motor against the load factor: figure 12 of S5."""

    load_factor: Array
    tau_min: Array
    tau_opt: Array
    tau_max: Array


def curves_against_load(motor: Motor, load_inertia: float, load_factors: ArrayLike) -> RatioCurves:
    """Return τ_min, τ_opt, τ_max of a motor for load factors β of a purely inertial load J_L; NaN beyond β = α.

    τ_min,max = √(J_M/J_L) (√(α/β) ∓ √(α/β − 1)). Source: S5, eq. (18) and figure 12.
    """
    beta = np.asarray(load_factors, dtype=np.float64)
    optimum = math.sqrt(motor.inertia / load_inertia)
    k = motor.rated_torque**2 / motor.inertia / beta
    k = np.where(k >= 1.0, k, np.nan)
    largest = optimum * (np.sqrt(k) + np.sqrt(k - 1.0))
    return RatioCurves(beta, optimum**2 / largest, np.full(beta.shape, optimum), largest)


def flying_load_factor(
    inertia: float,
    radius: float,
    line_speed: float,
    rms_coefficient: float,
    design_length: float,
    product_length: ArrayLike,
    tool_length: float,
) -> Array:
    """Return β = 4 J_L (C_a,rms v_L²/R_t)² (L_0 − L_p)²/(L_p (L_p − L_T)³). Source: S5, eq. (19)."""
    length = np.asarray(product_length, dtype=np.float64)
    shape = (design_length - length) ** 2 / (length * (length - tool_length) ** 3)
    return np.asarray(4.0 * inertia * (rms_coefficient * line_speed**2 / radius) ** 2 * shape)


def rms_torque(
    task: Task,
    motor_inertia: ArrayLike,
    ratio: ArrayLike,
    efficiency: ArrayLike = 1.0,
    reducer_inertia: ArrayLike = 0.0,
) -> Array:
    """Return T_M,rms (Nm), as if the motor always drove: (J_M + J_T) ω̇_L/τ + τ T*_L/η, squared and averaged.

    T_M,rms² = τ² T*_rms²/η² + (J_M + J_T)² ω̇_rms²/τ² + 2 (J_M + J_T) (T*_L ω̇_L)_mean/η; J_T at the motor's shaft.
    Source: S5, 'Model of dynamic system', with the squares it leaves out; step 7 for η and J_T.
    """
    inertia = np.asarray(motor_inertia, dtype=np.float64) + np.asarray(reducer_inertia, dtype=np.float64)
    tau, eta = np.asarray(ratio, dtype=np.float64), np.asarray(efficiency, dtype=np.float64)
    load, own = tau * task.torque_rms / eta, inertia * task.acceleration_rms / tau
    square = load**2 + own**2 + 2.0 * inertia * task.power_rate_mean / eta
    return np.asarray(np.sqrt(np.maximum(square, 0.0)))


def _require_efficiency(efficiency: float) -> None:
    if not 0.0 < efficiency <= 1.0:
        raise ValueError(f"efficiency is {efficiency:g}; expected more than 0 and at most 1")
