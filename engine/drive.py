"""The drive of one axis: reflected inertia, load torque, inverse dynamics, limits of the motor (S1, feeding group)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

STANDSTILL = 1e-9
"""rad/s at the load shaft; slower than this counts as standing, so that rounding never decides the power's sign."""


def _positive(what: str, value: float, zero: bool = False) -> None:
    if not (value >= 0 if zero else value > 0):
        raise ValueError(f"{what}: expected a number {'of at least' if zero else 'above'} 0, found {value:g}")


@dataclass(frozen=True)
class Inertia:
    """``count`` parts of moment of inertia ``J`` (kg m²) that turn ``speed_ratio`` times as fast as the load shaft."""

    name: str
    count: float
    J: float
    speed_ratio: float = 1.0

    def __post_init__(self) -> None:
        _positive(f"count of {self.name}", self.count, zero=True)
        _positive(f"inertia of {self.name}", self.J, zero=True)

    @property
    def reflected(self) -> float:
        """The inertia at the load shaft: count · J · (ω_i/ω_1)²."""
        return self.count * self.J * self.speed_ratio**2


def reflected_inertia(parts: Sequence[Inertia]) -> float:
    """Return J_tot = Σ count · J · (ω_i/ω_1)² in kg m², from equal kinetic energies (S1, 'equivalent J')."""
    return sum(part.reflected for part in parts)


@dataclass(frozen=True)
class Load:
    """What turns with the load shaft: ``inertia`` J_tot (kg m²) and ``torque`` C_r = F_r R (Nm).

    ``always``: the torque acts in one direction, also at rest. ``moving``: it opposes the motion, and is
    zero at rest.
    """

    inertia: float
    torque: float
    resists: Literal["always", "moving"] = "always"

    def __post_init__(self) -> None:
        _positive("inertia of the load", self.inertia, zero=True)
        if self.resists not in ("always", "moving"):
            raise ValueError(f"the load resists 'always' or 'moving', not {self.resists!r}")


@dataclass(frozen=True)
class Transmission:
    """A reducer of constant ``ratio`` τ = ω_r/ω_m and ``efficiency`` η in (0, 1]."""

    ratio: float
    efficiency: float = 1.0

    def __post_init__(self) -> None:
        _positive("transmission ratio", self.ratio)
        if not 0 < self.efficiency <= 1:
            raise ValueError(f"efficiency: expected more than 0 and at most 1, found {self.efficiency:g}")


@dataclass(frozen=True)
class Motor:
    """A motor: ``inertia`` J_m (kg m²), ``rated_torque`` and ``peak_torque`` (Nm), ``max_speed`` (rad/s)."""

    inertia: float
    rated_torque: float
    peak_torque: float
    max_speed: float

    def __post_init__(self) -> None:
        _positive("inertia of the motor", self.inertia, zero=True)
        _positive("rated torque", self.rated_torque)
        _positive("peak torque", self.peak_torque)
        _positive("largest speed", self.max_speed)


class OperatingPoints(NamedTuple):
    """Speed (rad/s), torque (Nm) and power (W) of the motor, one for each sample."""

    speed: Any
    torque: Any
    power: Any


@dataclass(frozen=True)
class LimitCheck:
    """One limit of the motor: what is used of it, and whether that fits."""

    name: str
    value: float
    limit: float

    @property
    def ok(self) -> bool:
        """Whether the limit holds."""
        return self.value <= self.limit


@dataclass(frozen=True)
class Drive:
    """Load, reducer and motor; speeds ``w`` (rad/s) and accelerations ``dw`` (rad/s²) are the load shaft's."""

    load: Load
    transmission: Transmission
    motor: Motor

    @property
    def effective_inertia(self) -> float:
        """What the motor feels per unit of ω̇_r without losses: J_m/τ + τ J_tot, in kg m²."""
        tau = self.transmission.ratio
        return self.motor.inertia / tau + tau * self.load.inertia

    def load_torque(self, w: ArrayLike) -> Any:
        """Return C_r in Nm: constant, or against the motion and zero at rest."""
        speed = np.asarray(w, dtype=np.float64)
        if self.load.resists == "always":
            return np.full_like(speed, self.load.torque)
        return np.where(np.abs(speed) < STANDSTILL, 0.0, np.sign(speed) * self.load.torque)

    def total_load_torque(self, w: ArrayLike, dw: ArrayLike) -> Any:
        """Return C*_r = C_r + J_tot ω̇_r in Nm (S1)."""
        return self.load_torque(w) + self.load.inertia * np.asarray(dw, dtype=np.float64)

    def loss_factor(self, w: ArrayLike, dw: ArrayLike) -> Any:
        """Return 1/η where the motor drives the load, η where the load drives the motor."""
        speed, eta = np.asarray(w, dtype=np.float64), self.transmission.efficiency
        drives = (self.total_load_torque(w, dw) * speed >= 0) | (np.abs(speed) < STANDSTILL)
        return np.where(drives, 1 / eta, eta)

    def motor_torque(self, w: ArrayLike, dw: ArrayLike) -> Any:
        """Return C_m = (J_m/τ) ω̇_r + τ C*_r f in Nm, with f the loss factor (S1's equation has f = 1)."""
        tau = self.transmission.ratio
        inertial = self.motor.inertia / tau * np.asarray(dw, dtype=np.float64)
        return inertial + tau * self.total_load_torque(w, dw) * self.loss_factor(w, dw)

    def motor_speed(self, w: ArrayLike) -> Any:
        """Return ω_m = ω_r/τ in rad/s."""
        return np.asarray(w, dtype=np.float64) / self.transmission.ratio

    def power(self, w: ArrayLike, dw: ArrayLike) -> Any:
        """Return C_m ω_m in W; negative where the motor brakes."""
        return self.motor_torque(w, dw) * self.motor_speed(w)

    def operating_points(self, w: ArrayLike, dw: ArrayLike) -> OperatingPoints:
        """Return speed, torque and power of the motor, S1's torque-against-rpm plot."""
        return OperatingPoints(self.motor_speed(w), self.motor_torque(w, dw), self.power(w, dw))

    def rms_lossless(self, dw_rms: float, resisting_share: float = 1.0) -> float:
        """Return the exact RMS torque in Nm for η = 1, of a cycle whose phases start and end at rest.

        √((J_m/τ + τ J_tot)² ω̇²_rms + τ² C_r² φ), with ω̇_rms over the whole cycle and φ the share of it in
        which the load resists; the mixed term vanishes, as each phase gives back the speed it took.
        """
        return sqrt(
            (self.effective_inertia * dw_rms) ** 2
            + (self.transmission.ratio * self.load.torque) ** 2 * resisting_share
        )


def rms(values: ArrayLike) -> float:
    """Return the root mean square of equally spaced samples that include both ends, by the trapezoidal rule."""
    squares = np.asarray(values, dtype=np.float64) ** 2
    if squares.size < 2:
        raise ValueError("the RMS of a cycle needs at least two samples")
    return sqrt(float(np.mean((squares[1:] + squares[:-1]) / 2)))


def checks(points: OperatingPoints, motor: Motor) -> tuple[LimitCheck, ...]:
    """Return the three checks of a motor: RMS within rated torque, peak torque, largest speed (S5, conditions of [6])."""
    return (
        LimitCheck("RMS torque", rms(points.torque), motor.rated_torque),
        LimitCheck("peak torque", float(np.max(np.abs(points.torque))), motor.peak_torque),
        LimitCheck("speed", float(np.max(np.abs(points.speed))), motor.max_speed),
    )
