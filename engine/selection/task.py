"""The task of a load at its own shaft, its load factor β, and the transmission ratios a motor accepts. SI units.

τ = ω_L/ω_M throughout. Misprints of S5, corrected here: T²_M,rms and T*²_L,rms lack the square, τ_min has the plus and
τ_max the minus in (14) and (18), τ_opt has J_r for J_L.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive import Load, Motor
from engine.laws.base import Array
from engine.motion import Motion, Phase
from engine.selection.catalogue import Motors

AT_REST = 1e-9  # share of the mean velocity of a phase: a slower end is at rest
NOTHING = 1e-9  # rad/s², Nm, rad/s: a smaller acceleration, torque or speed is rounding


@dataclass(frozen=True)
class Task:
    """The task of a load at its shaft over a cycle: S5, eqs. (14), (15). Raises ValueError for impossible figures."""

    acceleration_rms: float  # ω̇_L,rms (rad/s²)
    torque_rms: float  # T*_L,rms (Nm), of the generalized load torque T*_L = T_L + J_L ω̇_L
    power_rate_mean: float  # (ω̇_L T*_L)_mean (Nm rad/s²)
    max_speed: float  # ω_L,max (rad/s)

    def __post_init__(self) -> None:
        for name in ("acceleration_rms", "torque_rms", "max_speed"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) >= 0.0):
                raise ValueError(f"load: {name} is {getattr(self, name):g}; expected a finite number, 0 or more")
        bound = self.acceleration_rms * self.torque_rms
        if not abs(self.power_rate_mean) <= bound * (1.0 + 1e-9):
            raise ValueError(f"load: power_rate_mean is {self.power_rate_mean:g}; expected −{bound:g} to {bound:g}")

    @classmethod
    def of_load(cls, load: Load, phases: Sequence[Phase]) -> "Task":
        """Return the exact task of a load over phases in s and rad.

        Its friction resists in movements, its torque always. Resisting and accelerating torque do not correlate, as
        neither ∫ω̇ dt nor ∫ sign(ω) ω̇ dt, the gains of ω and |ω|, differ from 0 over a cycle.
        Raises ValueError if a phase does not begin and end at rest, or no phases are given.
        """
        if not phases:
            raise ValueError("0 phases; expected one or more")
        for k, phase in enumerate(phases, 1):
            if phase.lift != 0.0 and max(abs(phase.law.start.v), abs(phase.law.end.v)) > AT_REST:
                raise ValueError(f"phase {k}: {phase.law.name} does not begin and end at rest")
        motion = Motion(phases)
        held = [load.torque + load.friction * np.sign(p.lift) for p in phases]
        square = math.fsum(p.duration * float(torque) ** 2 for p, torque in zip(phases, held, strict=True))
        fastest = max(p.law.coefficients.cv * abs(p.lift) / p.duration for p in phases)
        torque = math.sqrt((load.inertia * motion.y2_rms) ** 2 + square / motion.total)
        return cls(motion.y2_rms, torque, load.inertia * motion.y2_rms**2, fastest)

    @property
    def moves(self) -> bool:
        """Whether the load accelerates and has a torque; else no motor can be selected for it."""
        return min(self.acceleration_rms, self.torque_rms, self.max_speed) > NOTHING

    @property
    def load_factor(self) -> float:
        """β = 2 (ω̇_L,rms T*_L,rms + (ω̇_L T*_L)_mean), in Nm rad/s²; 0 of a load that does not move: S5, eq. (15)."""
        return 2.0 * (self.acceleration_rms * self.torque_rms + self.power_rate_mean) if self.moves else 0.0

    def best_ratio(self, inertia: ArrayLike, efficiency: float = 1.0) -> Array:
        """Return τ_opt = √(J ω̇_rms η/T*_rms), at which the RMS torque is smallest; J (kg m²) is on the motor's shaft.

        NaN for a load that does not move. Source: S5, eq. (14) with its efficiency; (18), where it is √(J_M/J_L).
        """
        moment = np.asarray(inertia, dtype=np.float64)
        if not self.moves:
            return np.full(moment.shape, np.nan)
        return np.asarray(np.sqrt(moment * efficiency * self.acceleration_rms / self.torque_rms))

    def ratio_ranges(self, motors: Motors, efficiency: float = 1.0) -> "Ranges":
        """Return the range of τ for each motor, by the efficiency η of the transmission.

        τ_min,max = √J_M/(2T) (√(α − β/η + 4 ω̇_rms T) ∓ √(α − β/η)), T = T*_L,rms/η; α < β/η is rejected.
        A load that does not move accepts no motor. Raises ValueError unless 0 < η ≤ 1.
        Source: S5, eqs. (14)–(18), steps 3 and 4; H. Giberti, S. Cinquemani, G. Legnani, Effects of transmission
        mechanical characteristics on the choice of a motor-reducer, Mechatronics 20 (2010).
        """
        if not 0.0 < efficiency <= 1.0:
            raise ValueError(f"efficiency is {efficiency:g}; expected more than 0 and at most 1")
        alpha = accelerating_factor(motors.rated_torque, motors.inertia)
        known = 1.0 if self.moves else np.nan
        spare = known * (alpha - self.load_factor / efficiency)
        torque = known * self.torque_rms / efficiency
        root, wide, smallest, largest = _ends(spare, motors.inertia, self.acceleration_rms, torque)
        limit = known * self.max_speed / motors.max_speed
        lowest = np.fmax(smallest, limit)
        optimum = self.best_ratio(motors.inertia, efficiency)
        accepted = lowest <= largest
        return Ranges(alpha, smallest, largest, optimum, limit, lowest, root, wide, spare >= 0.0, accepted)

    def ratio_curves(self, motor: Motor, efficiency: float, points: int, begin: tuple[float, float]) -> "RatioCurves":
        """Return the range of τ of a motor for the load at other rates, up to β/η = α.

        The k-th of n points is at β/(η α) = 1 − (1 − s)(1 − k/(n − 1))², k from 0, s the task's own value, clipped. For
        a load that does not move the ratios are NaN and the rate factors 0. Source: S5, figure 12 and (14).

        Parameters
        ----------
        motor : Motor
        efficiency : float
            η of the transmission.
        points : int
            n, 2 or more.
        begin : tuple of two float
            The least and the largest share β/(η α) at which the curves may begin.
        """
        alpha = float(accelerating_factor(motor.rated_torque, motor.inertia))
        first = max(begin[0], min(begin[1], self.load_factor / efficiency / alpha))
        share = 1.0 - (1.0 - first) * (1.0 - np.arange(points) / (points - 1)) ** 2
        beta, spare = share * efficiency * alpha, (1.0 - share) * alpha
        if not self.moves:
            nothing, root = np.full(points, np.nan), np.sqrt(spare)
            return RatioCurves(share, beta, np.zeros(points), root, root, nothing, nothing, nothing)
        pace = np.sqrt(beta / self.load_factor)
        torque = pace * self.torque_rms / efficiency
        root, wide, low, high = _ends(spare, motor.inertia, pace * self.acceleration_rms, torque)
        best = self.best_ratio(np.full(points, motor.inertia), efficiency)
        return RatioCurves(share, beta, pace, root, wide, low, best, high)


def accelerating_factor(rated_torque: ArrayLike, inertia: ArrayLike) -> Array:
    """Return α = T_M,N²/J_M (Nm rad/s²) from Nm and kg m². Source: S5, eq. (15)."""
    return np.asarray(np.square(rated_torque, dtype=np.float64) / np.asarray(inertia, dtype=np.float64))


class Ranges(NamedTuple):
    """The transmission ratios that each motor accepts, arrays over the motors; NaN if a motor is too weak."""

    accelerating_factor: Array  # α (Nm rad/s²)
    tau_min: Array
    tau_max: Array
    tau_opt: Array  # at which the RMS torque is smallest; √(τ_min τ_max)
    tau_limit: Array  # τ_M,lim, below which the motor would exceed its largest speed
    lowest: Array  # max(τ_min, τ_M,lim); τ_M,lim of a motor that is too weak
    root: Array  # √(α − β/η), of (14)
    wide: Array  # √(α − β/η + 4 ω̇_rms T*_rms/η), of (14)
    strong: NDArray[np.bool_]  # whether α ≥ β/η
    accepted: NDArray[np.bool_]  # whether the motor accepts any ratio


class RatioCurves(NamedTuple):
    """The range of τ of a motor against the load factor, figure 12 of S5: arrays over the points of the curves."""

    share: Array  # β/(η α), rising to 1
    load_factor: Array  # β (Nm rad/s²)
    rate_factor: Array  # √(β/β_now), factor of both ω̇ and T*
    root: Array  # √(α − β/η)
    wide: Array  # √(α − β/η + 4 ω̇_rms T*_rms/η)
    tau_min: Array
    tau_opt: Array
    tau_max: Array


def _ends(spare: Array, inertia: ArrayLike, acceleration: ArrayLike, torque: ArrayLike) -> tuple[Array, ...]:
    """Return both roots of (14), τ_min and τ_max, from α − β/η, J, ω̇_rms and T*_rms/η; NaN if α − β/η < 0."""
    half, dw, load = np.sqrt(np.asarray(inertia)), np.asarray(acceleration), np.asarray(torque)
    root = np.sqrt(np.where(spare >= 0.0, spare, np.nan))
    wide = np.sqrt(root**2 + 4.0 * dw * load)
    smallest = 2.0 * half * dw / (wide + root)  # the difference of the roots would lose digits
    return root, wide, smallest, half / (2.0 * load) * (wide + root)
