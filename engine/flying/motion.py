"""The tool over a cycle: its motion, that of its shaft, and where the cycle is."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array

MOVES, WAITS, WORKS = 1, 2, 3
"""the parts of a cycle"""


class CycleState(NamedTuple):
    """Where the cycle is at each time."""

    part: NDArray[np.intp]
    """1 moves by its law, 2 waits at standstill, 3 works at line speed"""
    waited: Array
    """s"""
    xi: Array
    """abscissa of the law"""


class ToolMotion(NamedTuple):
    """Motion of the tool along its path over a cycle: m, m/s, m/s², m/s³."""

    position: Array
    speed: Array
    acceleration: Array
    jerk: Array

    def at_shaft(self, radius: float) -> "ShaftMotion":
        """Return the motion of the shaft, whose tool goes ``radius`` (m) a rad: s/R_t, v/R_t, a/R_t."""
        return ShaftMotion(self.position / radius, self.speed / radius, self.acceleration / radius)


class ShaftMotion(NamedTuple):
    """Motion of the tool's shaft over a cycle: rad, rad/s, rad/s²."""

    angle: Array
    speed: Array
    acceleration: Array


def generalized_torque(torque: float, inertia: float, acceleration: Array) -> Array:
    """Return T*_L = T_L + J_L ω̇_L (Nm) at the tool's shaft: of a load torque (Nm) and an inertia (kg m²).

    Source: S5, 'Model of dynamic system'.
    """
    return torque + inertia * acceleration
