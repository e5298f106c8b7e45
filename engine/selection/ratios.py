"""The transmission ratios that a motor accepts for a task: α against β, τ_min to τ_max, and RMS torques. SI units.

τ = ω_L/ω_M throughout. Misprints of S5 mended here: T²_M,rms without the square, τ_min with the plus and τ_max with
the minus in (14) and (18), τ_opt with J_r for J_L.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array
from engine.selection.task import Task


def accelerating_factor(rated_torque: ArrayLike, inertia: ArrayLike) -> Array:
    """Return α = T_M,N²/J_M (Nm rad/s²). Source: S5, eq. (15)."""
    return np.asarray(np.square(rated_torque, dtype=np.float64) / np.asarray(inertia, dtype=np.float64))


def best_ratio(task: Task, inertia: ArrayLike, efficiency: ArrayLike = 1.0) -> Array:
    """Return τ_opt = √(J ω̇_rms η/T*_rms), at which the RMS torque is smallest; J (kg m²) is all at the motor's shaft.

    NaN for a load that does not move. Source: S5, eq. (14) with its efficiency; (18), where it is √(J_M/J_L).
    """
    moment, eta = np.asarray(inertia, dtype=np.float64), np.asarray(efficiency, dtype=np.float64)
    if not task.moves:
        return np.full(np.broadcast_shapes(moment.shape, eta.shape), np.nan)
    return np.asarray(np.sqrt(moment * eta * task.acceleration_rms / task.torque_rms))


class Ranges(NamedTuple):
    """The transmission ratios that each motor accepts, arrays over the motors; NaN where a motor is too weak."""

    accelerating_factor: Array
    tau_min: Array
    tau_max: Array
    tau_opt: Array
    """at which the RMS torque is smallest; √(τ_min τ_max)"""
    tau_limit: Array
    """τ_M,lim: a smaller ratio drives the motor beyond its largest speed"""
    lowest: Array
    """max(τ_min, τ_M,lim); τ_M,lim of a motor that is too weak"""
    root: Array
    """√(α − β/η), of (14)"""
    wide: Array
    """√(α − β/η + 4 ω̇_rms T*_rms/η), of (14)"""
    strong: NDArray[np.bool_]
    """whether α ≥ β/η"""
    accepted: NDArray[np.bool_]
    """whether any ratio at all does"""


def ratio_ranges(
    task: Task, rated_torque: ArrayLike, inertia: ArrayLike, max_speed: ArrayLike, efficiency: float = 1.0
) -> Ranges:
    """Return the range of τ for each motor: T_M,N (Nm), J_M (kg m²), ω_M,max (rad/s).

    τ_min,max = √J_M/(2T) (√(α − β/η + 4 ω̇_rms T) ∓ √(α − β/η)), T = T*_L,rms/η; α < β/η is rejected.
    A load that does not move accepts no motor. Raises ValueError unless 0 < η ≤ 1.
    Source: S5, eqs. (14)–(18), steps 3 and 4; H. Giberti, S. Cinquemani, G. Legnani, Effects of transmission
    mechanical characteristics on the choice of a motor-reducer, Mechatronics 20 (2010).
    """
    if not 0.0 < efficiency <= 1.0:
        raise ValueError(f"efficiency is {efficiency:g}; expected more than 0 and at most 1")
    rated, moment, fastest = np.broadcast_arrays(
        *(np.asarray(given, dtype=np.float64) for given in (rated_torque, inertia, max_speed))
    )
    alpha = accelerating_factor(rated, moment)
    if not task.moves:
        nothing, none = np.full(alpha.shape, np.nan), np.zeros(alpha.shape, dtype=bool)
        return Ranges(alpha, nothing, nothing, nothing, nothing, nothing, nothing, nothing, none, none)
    spare = alpha - task.load_factor / efficiency
    root, wide, smallest, largest = _ends(spare, moment, task.acceleration_rms, task.torque_rms / efficiency)
    limit = task.max_speed / fastest
    lowest = np.fmax(smallest, limit)
    optimum = best_ratio(task, moment, efficiency)
    accepted = lowest <= largest
    return Ranges(alpha, smallest, largest, optimum, limit, lowest, root, wide, spare >= 0.0, accepted)


def _ends(spare: Array, inertia: ArrayLike, acceleration: ArrayLike, torque: ArrayLike) -> tuple[Array, ...]:
    """Return both roots of (14), τ_min and τ_max for the spare α − β/η, ω̇_rms and T*_rms/η; NaN below 0."""
    half, dw, load = np.sqrt(np.asarray(inertia)), np.asarray(acceleration), np.asarray(torque)
    root = np.sqrt(np.where(spare >= 0.0, spare, np.nan))
    wide = np.sqrt(root**2 + 4.0 * dw * load)
    smallest = 2.0 * half * dw / (wide + root)  # without the difference of roots
    return root, wide, smallest, half / (2.0 * load) * (wide + root)


class RatioCurves(NamedTuple):
    """Range of τ of one motor against the load factor, figure 12 of S5: arrays over its points."""

    share: Array
    """β/(η α), rising to 1, closer together near it"""
    load_factor: Array
    """β"""
    rate_factor: Array
    """√(β/β_now), on ω̇ and T* alike"""
    root: Array
    """√(α − β/η)"""
    wide: Array
    """√(α − β/η + 4 ω̇_rms T*_rms/η)"""
    tau_min: Array
    tau_opt: Array
    tau_max: Array


def ratio_curves(
    task: Task, rated_torque: float, inertia: float, efficiency: float, points: int, begin: tuple[float, float]
) -> RatioCurves:
    """Return the range of τ of a motor (T_M,N in Nm, J_M in kg m²) for a load driven slower and faster, up to β/η = α.

    The k-th share of α is 1 − (1 − s)(1 − k/(n − 1))², k from 0, s the task's own β/(η α), within ``begin``. Ratios
    are NaN, and the pace 0, for a load that does not move. Source: S5, figure 12, with (14) for a load of any kind.
    """
    alpha = float(accelerating_factor(rated_torque, inertia))
    first = max(begin[0], min(begin[1], task.load_factor / efficiency / alpha))
    share = 1.0 - (1.0 - first) * (1.0 - np.arange(points) / (points - 1)) ** 2
    beta, spare = share * efficiency * alpha, (1.0 - share) * alpha
    if not task.moves:
        nothing, root = np.full(points, np.nan), np.sqrt(spare)
        return RatioCurves(share, beta, np.zeros(points), root, root, nothing, nothing, nothing)
    pace = np.sqrt(beta / task.load_factor)
    torque = pace * task.torque_rms / efficiency
    root, wide, low, high = _ends(spare, inertia, pace * task.acceleration_rms, torque)
    return RatioCurves(share, beta, pace, root, wide, low, best_ratio(task, np.full(points, inertia), efficiency), high)
