"""The drive of an axis: reflected inertia, load, transmission, motor; torque, power and limits. SI units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array, require_finite
from engine.motion import Phase

STANDSTILL = 1e-9
"""rad/s at the load shaft; a slower shaft counts as standing"""
RETURNED = 1e-6
"""W at the load shaft; a load that gives back less counts as driven, or rounding would choose the side of the losses"""


@dataclass(frozen=True)
class Inertia:
    """``count`` equal parts of inertia ``J`` (kg m²); ``speed_ratio`` is ω_i/ω_1, 1 the load shaft.

    Raises ValueError for a negative count or inertia.
    """

    name: str
    count: float
    J: float
    speed_ratio: float = 1.0

    def __post_init__(self) -> None:
        _not_negative(self.name, count=self.count, J=self.J)
        require_finite(speed_ratio=self.speed_ratio)

    @property
    def reflected(self) -> float:
        """Inertia at the load shaft, count · J · (ω_i/ω_1)², in kg m²."""
        return self.count * self.J * self.speed_ratio**2


def reflected_inertia(parts: Sequence[Inertia]) -> float:
    """Return J_tot = Σ count · J · (ω_i/ω_1)², in kg m² at the load shaft.

    Source: S1, 'Feeding group layout', J_tot = 4 J1 + 4 J2.
    """
    return math.fsum(part.reflected for part in parts)


@dataclass(frozen=True)
class Load:
    """Inertia J_tot (kg m²) and resisting torque C_r = F_r R (Nm) at the load shaft.

    ``always``: the torque acts in one direction, also at rest, like a weight. ``moving``: it opposes the
    motion, C_r sign(ω_r), and is zero at standstill, like friction.
    Raises ValueError for a negative inertia or another word. Source: S1, 'Feeding group'.
    """

    inertia: float
    torque: float
    resists: Literal["always", "moving"] = "always"

    def __post_init__(self) -> None:
        _not_negative("load", inertia=self.inertia)
        require_finite(torque=self.torque)
        if self.resists not in ("always", "moving"):
            raise ValueError(f"resists is {self.resists!r}; expected 'always' or 'moving'")


@dataclass(frozen=True)
class Transmission:
    """Transmission ratio τ = ω_r/ω_m (load to motor) and efficiency η.

    Raises ValueError unless τ > 0 and 0 < η ≤ 1.
    """

    ratio: float
    efficiency: float = 1.0

    def __post_init__(self) -> None:
        require_finite(ratio=self.ratio)
        if not self.ratio > 0.0:
            raise ValueError(f"ratio is {self.ratio:g}; expected more than 0")
        if not 0.0 < self.efficiency <= 1.0:
            raise ValueError(f"efficiency is {self.efficiency:g}; expected more than 0 and at most 1")


@dataclass(frozen=True)
class Motor:
    """Inertia (kg m²), rated and peak torque (Nm) and largest speed (rad/s); no limit is given by infinity.

    Raises ValueError for a negative inertia or a limit that is not above 0.
    """

    inertia: float
    rated_torque: float = math.inf
    peak_torque: float = math.inf
    max_speed: float = math.inf

    def __post_init__(self) -> None:
        _not_negative("motor", inertia=self.inertia)
        for name in ("rated_torque", "peak_torque", "max_speed"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"motor: {name} is {getattr(self, name):g}; expected more than 0")


@dataclass(frozen=True)
class OperatingPoints:
    """Speed (rad/s), torque (Nm) and power (W) at the motor shaft, sample by sample.

    ``time`` (s) of each sample, or None for equal steps.
    """

    speed: Array
    torque: Array
    power: Array
    time: Array | None = field(default=None)

    @property
    def peak_torque(self) -> float:
        """max |C_m|"""
        return float(np.abs(self.torque).max())

    @property
    def highest_torque(self) -> float:
        """Largest C_m, with its sign."""
        return float(self.torque.max())

    @property
    def lowest_torque(self) -> float:
        """Lowest C_m, with its sign."""
        return float(self.torque.min())

    @property
    def max_speed(self) -> float:
        """max |ω_m|"""
        return float(np.abs(self.speed).max())

    @property
    def rms_torque(self) -> float:
        """sqrt(∫C_m² dt / t), by the trapezoidal rule on the samples."""
        time = np.arange(len(self.torque), dtype=np.float64) if self.time is None else self.time
        return math.sqrt(float(np.trapezoid(self.torque**2, time)) / float(time[-1] - time[0]))


@dataclass(frozen=True)
class Drive:
    """Load, transmission and motor in line; speeds ω_r and accelerations ω̇_r are those of the load shaft."""

    load: Load
    transmission: Transmission
    motor: Motor

    @property
    def effective_inertia(self) -> float:
        """J_m/τ + τ J_tot (kg m²): the motor's torque per unit of ω̇_r, without losses."""
        return self.motor.inertia / self.transmission.ratio + self.transmission.ratio * self.load.inertia

    def load_torque(self, w_r: ArrayLike) -> Array:
        """Return the resisting torque C_r (Nm) at the speed ω_r (rad/s)."""
        w = np.asarray(w_r, dtype=np.float64)
        if self.load.resists == "always":
            return np.full(w.shape, self.load.torque)
        return self.load.torque * np.where(_stands(w), 0.0, np.sign(w))

    def total_load_torque(self, w_r: ArrayLike, dw_r: ArrayLike) -> Array:
        """Return C*_r = C_r + J_tot ω̇_r (Nm). Source: S1, 'Feeding group'."""
        return self.load_torque(w_r) + self.load.inertia * np.asarray(dw_r, dtype=np.float64)

    def loss_factor(self, w_r: ArrayLike, dw_r: ArrayLike) -> Array:
        """Return f: 1/η where the motor drives the load, C*_r ω_r ≥ 0, or the shaft stands; else η.

        Where the load drives the motor, the losses help to brake.
        """
        w, eta = np.asarray(w_r, dtype=np.float64), self.transmission.efficiency
        driven = (self.total_load_torque(w, dw_r) * w >= -RETURNED) | _stands(w)
        return np.where(driven, 1.0 / eta, eta)

    def motor_torque(self, w_r: ArrayLike, dw_r: ArrayLike) -> Array:
        """Return C_m = (J_m/τ) ω̇_r + τ C*_r f (Nm), f the loss factor.

        Source: S1, 'Feeding group', last equation, where f = 1.
        """
        tau = self.transmission.ratio
        inertial = self.motor.inertia / tau * np.asarray(dw_r, dtype=np.float64)
        return inertial + tau * self.total_load_torque(w_r, dw_r) * self.loss_factor(w_r, dw_r)

    def motor_speed(self, w_r: ArrayLike) -> Array:
        """Return ω_m = ω_r/τ (rad/s)."""
        return np.asarray(w_r, dtype=np.float64) / self.transmission.ratio

    def power(self, w_r: ArrayLike, dw_r: ArrayLike) -> Array:
        """Return the motor's power C_m ω_m (W), negative where it brakes."""
        return self.motor_torque(w_r, dw_r) * self.motor_speed(w_r)

    def operating_points(self, w_r: ArrayLike, dw_r: ArrayLike, time: ArrayLike | None = None) -> OperatingPoints:
        """Return speed, torque and power at the motor for samples of ω_r (rad/s) and ω̇_r (rad/s²)."""
        torque, speed = self.motor_torque(w_r, dw_r), self.motor_speed(w_r)
        at = None if time is None else np.asarray(time, dtype=np.float64)
        return OperatingPoints(speed, torque, torque * speed, at)


def rms_lossless(drive: Drive, phases: Sequence[Phase], radius: float) -> float:
    """Return the exact RMS torque (Nm) of the motor over the phases, for η = 1, from the laws' coefficients.

    C_m,rms² = (J_m/τ + τ J_tot)² ⟨ω̇²⟩ + 2 (J_m/τ + τ J_tot) τ ⟨ω̇ C_r⟩ + τ² ⟨C_r²⟩

    A phase of lift h (m) in the duration t (s), on a wheel of ``radius`` R (m), adds C_a,rms² (h/R)²/t³ to
    ∫ω̇² dt, and C_r times its gain of ω (of |ω|, where the load resists only while moving) to ∫ω̇ C_r dt.
    The transmission's efficiency is left out; a movement is taken to stand still at single instants only.
    Raises ValueError for no phases or a radius that is not above 0.
    """
    if not phases or not (math.isfinite(radius) and radius > 0.0):
        raise ValueError(f"{len(phases)} phases and radius {radius:g}; expected a phase and a radius above 0")
    time = math.fsum(p.duration for p in phases)
    square = math.fsum((p.law.coefficients.ca_rms * p.lift / radius) ** 2 / p.duration**3 for p in phases)
    always = drive.load.resists == "always"
    gained = math.fsum(_speed_gain(p, signed=always) / radius for p in phases)
    resisting = time if always else math.fsum(p.duration for p in phases if p.lift != 0.0)
    inertia, torque = drive.effective_inertia, drive.transmission.ratio * drive.load.torque
    total = inertia**2 * square + 2.0 * inertia * torque * gained + torque**2 * resisting
    return math.sqrt(max(total, 0.0) / time)


class LimitCheck(NamedTuple):
    """A quantity against the motor's limit, in the limit's unit."""

    name: str
    value: float
    limit: float
    ok: bool


def checks(points: OperatingPoints, motor: Motor) -> tuple[LimitCheck, ...]:
    """Return RMS torque, peak torque and speed, each against the motor's limit."""
    found = (
        ("RMS torque", points.rms_torque, motor.rated_torque),
        ("peak torque", points.peak_torque, motor.peak_torque),
        ("speed", points.max_speed, motor.max_speed),
    )
    return tuple(LimitCheck(name, value, limit, value <= limit) for name, value, limit in found)


def _speed_gain(phase: Phase, signed: bool) -> float:
    per = phase.lift / phase.duration
    begin, end = per * phase.law.start.v, per * phase.law.end.v
    return end - begin if signed else abs(end) - abs(begin)


def _stands(w: Array) -> NDArray[np.bool_]:
    return np.abs(w) < STANDSTILL


def _not_negative(where: str, **quantities: float) -> None:
    for name, value in quantities.items():
        if not (math.isfinite(value) and value >= 0.0):
            raise ValueError(f"{where}: {name} is {value:g}; expected a finite number, 0 or more")
