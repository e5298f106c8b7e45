"""The rule of losses: which way power flows through a stage, and what its efficiency does to the torque."""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array

Method = Literal["physical", "document"]
"""losses that help to brake, or S4's way: always against the motor"""

STANDSTILL = 1e-9
"""rad/s (m/s of a load that travels); a slower shaft counts as standing"""

NEAR = 1e-9
"""Nm (N at a load that travels); a load that drives with less counts as driven, or rounding would choose the side"""


def direction(speed: ArrayLike) -> Array:
    """Return 1 for a shaft that turns forward, −1 backward, 0 for one that stands."""
    w = np.asarray(speed, dtype=np.float64)
    return np.where(np.abs(w) < STANDSTILL, 0.0, np.sign(w))


def gives_back(torque: ArrayLike, direction: ArrayLike, near: float = NEAR) -> NDArray[np.bool_]:
    """Return whether what is behind a stage drives it: a torque (Nm, or N) against the direction of motion.

    ``torque`` is what it must be driven with, ``direction`` 1, −1, or 0 at rest, where nothing flows back.
    """
    return np.asarray(np.asarray(torque) * np.asarray(direction) < -near)


def loss_factor(
    torque: ArrayLike, direction: ArrayLike, efficiency: float, method: Method = "physical", near: float = NEAR,
    back_efficiency: float | None = None,
) -> Array:  # fmt: skip
    """Return f, by which a stage multiplies the torque behind it.

    1/η where power flows to the load and at rest; where the load drives, the efficiency backward, η where none is
    given. A stage whose efficiency backward is 0 or less locks itself: it must be driven then, and at rest it holds the
    load by itself, f = 0. With the document's method 1/η always.
    Source: S1, 'Feeding group', last equation, where f = 1; S4, problem 1, where inertia and torque behind the screw
    are over η; S5, step 7.
    """
    if method == "document":
        return np.full(np.broadcast(torque, direction).shape, 1.0 / efficiency)
    back = efficiency if back_efficiency is None else back_efficiency
    forward = np.where(np.asarray(direction) == 0.0, held_factor(efficiency, back), 1.0 / efficiency)
    return np.where(gives_back(torque, direction, near), back, forward)


def held_factor(efficiency: float, back_efficiency: float) -> float:
    """Return f at rest: as if the motor drove; 0 of a stage that locks itself."""
    return 0.0 if back_efficiency <= 0.0 else 1.0 / efficiency
