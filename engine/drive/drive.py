"""A motor on a mechanism: what torque, speed and power the motion of a load asks of it. SI units."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.brake import Brake
from engine.drive.chain import Mechanism, require_not_negative
from engine.drive.losses import Method, require_method
from engine.laws.base import Array

Holding = Literal["motor", "brake"]
ANY = Brake()


@dataclass(frozen=True)
class Drive:
    """A mechanism, the motor that drives it, and how losses and rest are counted.

    Parameters
    ----------
    mechanism : Mechanism
        From the motor's shaft to the load.
    motor_inertia : float, kg m²
        0 or more.
    method : {"physical", "document"}
        Each stage's losses count against the motor where it drives and help it where the load drives (at rest, as if it
        drove); or S4's, inertia and torque at the output of a stage always over η.
    holding : {"motor", "brake"}
        What holds the load at rest; S4 counts no torque there, as with a brake.
    no_load : float, Nm
        Torque at the motor's shaft that opposes its rotation, whatever the load; 0 or more.
    copper : float, W/(Nm)²
        Losses of its winding over the square of its torque, P_N/T_N²; 0 or more.
    brake : Brake
        The one that holds, if a brake does; by default it holds any torque, in any dwell.

    Raises
    ------
    ValueError
        For what is negative, or another word.
    """

    mechanism: Mechanism
    motor_inertia: float
    method: Method = "physical"
    holding: Holding = "motor"
    no_load: float = 0.0
    copper: float = 0.0
    brake: Brake = ANY

    def __post_init__(self) -> None:
        require_not_negative("motor", inertia=self.motor_inertia, no_load=self.no_load, copper=self.copper)
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

    def torques(self, acceleration: ArrayLike, direction: ArrayLike) -> list[Array]:
        """Return the torque (or force) that each shaft must be driven with, from the motor's to the load's.

        For accelerations of the load (m/s² or rad/s²) in a direction (−1, 0, 1), without the motor's own inertia.
        """
        found = self.mechanism.torques(acceleration, direction, self.method)
        return [self._held(found[0], direction), *found[1:]]

    def torque(self, acceleration: ArrayLike, direction: ArrayLike) -> Array:
        """Return the motor's torque (Nm) at accelerations of the load (m/s² or rad/s²) in a direction (−1, 0, 1).

        T_m = J_m ω̇ + T_nl + T(0), T(k) = J_k ω̇_k + f T(k + 1)/i, f = 1/η where power flows to the load, η where it
        flows back. Source: S1, 'Feeding group', C_m = (J_m/τ) ω̇_r + τ (C_r + J_tot ω̇_r), and
        S4, T_m = T_R + J_T θ̈_m, where f is always 1/η.
        """
        own = self.motor_inertia * self.mechanism.ratio * np.asarray(acceleration, dtype=np.float64)
        return np.asarray(self.torques(acceleration, direction)[0] + own + self.no_load * np.asarray(direction))

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
