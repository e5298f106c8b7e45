"""A motor on a mechanism: what torque, speed and power the motion of a load asks of it. SI units."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive.chain import Mechanism, Method, require_not_negative
from engine.laws.base import Array

Holding = Literal["motor", "brake"]
SAME = 1e-9
"""s; a dwell that is shorter than the brake's time by less is as long"""


@dataclass(frozen=True)
class Brake:
    """A brake that holds the motor's shaft in dwells, with a torque (Nm) that is above 0.

    ``time`` (s, 0 or more) is what it takes to close and to open; the motor holds in a shorter dwell.
    Raises ValueError for a figure outside these limits.
    """

    torque: float = math.inf
    time: float = 0.0

    def __post_init__(self) -> None:
        if not self.torque > 0.0:
            raise ValueError(f"brake: torque is {self.torque:g}; expected more than 0")
        if not 0.0 <= self.time < math.inf:
            raise ValueError(f"brake: time is {self.time:g}; expected a finite number, 0 or more")

    def holds(self, direction: ArrayLike, dwell: ArrayLike) -> NDArray[np.bool_]:
        """Return where it holds: in directions (1, −1, or 0 at rest) of dwells that last so long (s)."""
        return np.logical_and(np.equal(direction, 0.0), np.greater_equal(dwell, self.time - SAME))


ANY = Brake()


@dataclass(frozen=True)
class Drive:
    """A mechanism, the motor that drives it, of an inertia (kg m²), and how losses and rest are counted.

    ``method`` is "physical", where each stage's losses count against the motor where it drives and help it where the
    load drives (at rest, as if it drove), or "document", S4's: inertia and torque at the output of a stage always over
    η. ``holding`` says what holds the load at rest, "motor" or "brake"; S4 counts no torque there, as with a brake.
    ``no_load`` (Nm) opposes the rotation of the motor's shaft, whatever the load. ``copper`` (W/(Nm)²) is the losses of
    its winding over the square of its torque, P_N/T_N². The ``brake`` by default holds any torque, in any dwell.
    Raises ValueError for what is negative, or another word.
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
        for name, words in (("method", get_args(Method)), ("holding", get_args(Holding))):
            if getattr(self, name) not in words:
                raise ValueError(f"{name} is {getattr(self, name)!r}; expected {' or '.join(map(repr, words))}")

    @property
    def total_inertia(self) -> float:
        """J_T = J_m + Σ J_i at the motor's shaft (kg m²), over η with the document's method."""
        return self.motor_inertia + self.mechanism.inertia(self.method)

    def torque(self, acceleration: ArrayLike, direction: ArrayLike) -> Array:
        """Return the motor's torque (Nm) at accelerations of the load (m/s² or rad/s²) in a direction (−1, 0, 1).

        T_m = J_m ω̇ + T_nl + T(0), T(k) = J_k ω̇_k + f T(k + 1)/i, f = 1/η where power flows to the load, η where it
        flows back. Source: S1, 'Feeding group', C_m = (J_m/τ) ω̇_r + τ (C_r + J_tot ω̇_r), and
        S4, T_m = T_R + J_T θ̈_m, where f is always 1/η.
        """
        own = self.motor_inertia * self.mechanism.ratio * np.asarray(acceleration, dtype=np.float64)
        first, *_ = self.mechanism.torques(acceleration, direction, self.method)
        braked = (np.asarray(direction) == 0.0) & (self.holding == "brake")
        return np.asarray(np.where(braked, 0.0, first) + own + self.no_load * np.asarray(direction))


def dwell_times(durations: Array, direction: Array) -> Array:
    """Return how long the dwell lasts (s) that each part of a cycle belongs to, by its duration and direction.

    Of parts at rest that follow each other, also across the end of the cycle, the sum; 0 of a part that moves.
    """
    moves = direction != 0.0
    before = np.cumsum(moves) % max(1, int(moves.sum()))
    return np.where(moves, 0.0, np.bincount(before, weights=np.where(moves, 0.0, durations))[before])
