"""The largest torque of a servo-motor against its speed. SI units."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws.base import Array


class Outline(NamedTuple):
    """The limits of a motor as a closed line about the torque–speed plane, corner by corner."""

    speed: Array
    """rad/s"""
    peak: Array
    """Nm"""
    rated: Array
    """Nm"""


class TorqueCurve(NamedTuple):
    """Largest torque (Nm) of a servo-motor against its speed (rad/s): corners, speeds rising from 0."""

    speed: Array
    torque: Array

    def at(self, speed: ArrayLike) -> Array:
        """Return T_M,max at a speed of either direction; 0 beyond the last corner."""
        return np.asarray(np.interp(np.abs(speed), self.speed, self.torque, right=0.0))

    def outline(self, rated_torque: float, reverses: bool) -> Outline:
        """Return the limits, clockwise from the upper left: those of the other direction where the motor reverses,
        else down the line of rest."""
        right, top = self.speed[1:], self.torque[1:]
        left = -right if reverses else np.zeros(right.shape)
        speed = np.concatenate([left[::-1], right, right[::-1], left, left[-1:]])
        peak = np.concatenate([top[::-1], top, -top[::-1], -top, top[-1:]])
        above = np.arange(speed.size) < 2 * right.size
        above[-1] = True
        return Outline(speed, peak, np.where(above, rated_torque, -rated_torque))
