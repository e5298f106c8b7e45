"""A motor's peak torque that falls beyond a speed. SI units."""

import math
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array


class Falling(NamedTuple):
    """The speed beyond which a peak torque falls (rad/s), and by how much (Nm s): 0 where it does not."""

    knee: float = 0.0
    fall: float = 0.0

    @classmethod
    def between(cls, knee: float, peak_torque: float, fastest: float, end_torque: float) -> "Falling":
        """Return how a peak torque (Nm) falls from a knee to another torque at the largest speed (rad/s).

        Not at all where the second is not smaller, or the knee not below that speed.
        """
        return cls(knee, max(0.0, peak_torque - end_torque) / (fastest - knee)) if knee < fastest else cls()

    def corner(self, peak_torque: float) -> float:
        """Return the falling line at no speed (Nm); no limit where it does not fall."""
        return peak_torque + self.fall * self.knee if self.fall else math.inf

    def reserve(self, peak_torque: float, torque: Array, speed: Array) -> Array:
        """Return what a motor of a peak torque (Nm) has left at speeds (rad/s) at which it gives torques (Nm)."""
        curve = peak_torque - self.fall * np.maximum(0.0, np.abs(speed) - self.knee)
        return np.asarray(curve - np.abs(torque))
