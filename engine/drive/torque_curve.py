"""The largest torque of a servo-motor against its speed. SI units."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws.base import Array


class TorqueCurve(NamedTuple):
    """Largest torque (Nm) of a servo-motor against its speed (rad/s): corners, speeds rising from 0."""

    speed: Array
    torque: Array

    def at(self, speed: ArrayLike) -> Array:
        """Return T_M,max at a speed of either direction; 0 beyond the last corner."""
        return np.asarray(np.interp(np.abs(speed), self.speed, self.torque, right=0.0))
