"""A motor on a mechanism: what torque, speed and power the motion of a load asks of it. SI units."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike

from engine.drivetrain.chain import Mechanism, require_not_negative
from engine.drivetrain.losses import Method, direction, require_method
from engine.drivetrain.motor import OperatingPoints
from engine.laws.base import Array

Holding = Literal["motor", "brake"]


class ShaftSamples(NamedTuple):
    """Speed (rad/s), acceleration (rad/s²) and the torque (Nm) that drives a shaft, sample by sample.

    At a load that travels m/s, m/s² and N.
    """

    speed: Array
    acceleration: Array
    torque: Array


@dataclass(frozen=True)
class Drive:
    """A mechanism, the inertia of the motor that drives it (kg m²), and how losses and rest are counted.

    ``method`` physical: each stage's losses count against the motor where it drives and help it where the
    load drives (at rest, as if it drove). ``document``: S4's, inertia and torque behind a stage always over η.
    ``holding``: who holds the load at rest; S4 counts no torque there, as with a brake.
    Raises ValueError for a negative inertia or another word.
    """

    mechanism: Mechanism
    motor_inertia: float
    method: Method = "physical"
    holding: Holding = "motor"

    def __post_init__(self) -> None:
        require_not_negative("motor", inertia=self.motor_inertia)
        require_method(self.method)
        if self.holding not in get_args(Holding):
            raise ValueError(f"holding is {self.holding!r}; expected 'motor' or 'brake'")

    @property
    def total_inertia(self) -> float:
        """J_T = J_m + Σ J_i at the motor's shaft (kg m²), over η with the document's method."""
        return self.motor_inertia + self.mechanism.inertia(self.method)

    @property
    def inertia_ratio(self) -> float:
        """J_machine/J_m, at the motor's shaft; 0 for a motor without inertia."""
        return self.mechanism.inertia(self.method) / self.motor_inertia if self.motor_inertia else 0.0

    def effective_inertia(self, shaft: int = 0) -> float:
        """Return the motor's torque per unit of a shaft's acceleration (kg m²), without losses.

        At the shaft behind a reducer J_m/τ + τ J_tot. Source: S1, 'Feeding group', last equation.
        """
        return (self.motor_inertia + self.mechanism.inertia()) * self.mechanism.ratio_to(shaft)

    @property
    def held_torque(self) -> float:
        """Torque of the motor (Nm) at rest."""
        return float(self.torque(0.0, 0.0))

    def resisting(self, direction: ArrayLike) -> Array:
        """Return what resists at the load (Nm, or N) in a direction (−1, 0, 1); at rest, what the motor holds."""
        return self._held(self.mechanism.load.resisting(direction), direction)

    def torques(self, acceleration: ArrayLike, direction: ArrayLike) -> list[Array]:
        """Return the torque (or force) that each shaft must be driven with, from the motor's to the load's.

        For accelerations of the load (m/s² or rad/s²) in a direction (−1, 0, 1), without the motor's own inertia.
        """
        found = self.mechanism.torques(acceleration, direction, self.method)
        return [self._held(found[0], direction), *found[1:]]

    def torque(self, acceleration: ArrayLike, direction: ArrayLike) -> Array:
        """Return the motor's torque (Nm) at accelerations of the load (m/s² or rad/s²) in a direction (−1, 0, 1).

        T_m = J_m ω̇ + T(0), T(k) = J_k ω̇_k + f T(k + 1)/i, f = 1/η where power flows to the load, η where it
        flows back. Source: S1, 'Feeding group', C_m = (J_m/τ) ω̇_r + τ (C_r + J_tot ω̇_r), and
        S4, T_m = T_R + J_T θ̈_m, where f is always 1/η.
        """
        own = self.motor_inertia * self.mechanism.ratio * np.asarray(acceleration, dtype=np.float64)
        found: Array = self.torques(acceleration, direction)[0] + own
        return found

    def shafts(self, speed: ArrayLike, acceleration: ArrayLike, going: ArrayLike) -> list[ShaftSamples]:
        """Return what each shaft does, from the motor's to the load's; the first without the motor's own inertia.

        For speeds (m/s or rad/s) and accelerations of the load, ``going`` its direction (−1, 0, 1).
        """
        m, found = self.mechanism, enumerate(self.torques(acceleration, going))
        return [ShaftSamples(m.turning(k, speed), m.turning(k, acceleration), torque) for k, torque in found]

    def operating_points(
        self, speed: ArrayLike, acceleration: ArrayLike, going: ArrayLike | None = None, time: ArrayLike | None = None
    ) -> OperatingPoints:
        """Return speed, torque and power of the motor for speeds and accelerations of the load.

        ``going`` is the direction of its motion (−1, 0, 1), by default that of the speed.
        """
        v = np.asarray(speed, dtype=np.float64)
        torque = self.torque(acceleration, direction(v) if going is None else going)
        at = None if time is None else np.asarray(time, dtype=np.float64)
        w = self.mechanism.ratio * v
        return OperatingPoints(w, torque, torque * w, at)

    def _held(self, torque: Array, direction: ArrayLike) -> Array:
        """Return a torque as it is, or none at rest where a brake holds."""
        return np.where(np.asarray(direction) == 0.0, 0.0, torque) if self.holding == "brake" else np.asarray(torque)


def motor_inertia(mechanism: Mechanism, inertia_ratio: float, method: Method = "physical") -> float:
    """Return the motor's inertia J_machine/ratio (kg m²) for a ratio J_machine/J_motor.

    Raises ValueError unless the ratio is above 0. Source: S4, 'inertia ratio between the machine and the motor'.
    """
    if not (math.isfinite(inertia_ratio) and inertia_ratio > 0.0):
        raise ValueError(f"inertia ratio is {inertia_ratio:g}; expected a finite number above 0")
    return mechanism.inertia(method) / inertia_ratio
