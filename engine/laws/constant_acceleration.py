"""Constant acceleration, symmetric (ACS): S3, figure 1."""

from __future__ import annotations

from math import inf
from typing import ClassVar

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array, Coefficients, Law


class ConstantAcceleration(Law):
    """Constant acceleration over the first half of the rise, the same deceleration over the second.

    s = 2ξ² before ξ = ½, 1 − 2(1 − ξ)² after; v = 4ξ, 4(1 − ξ); a = ±4 (S3, figure 1; S1 quotes C_a = 4).
    """

    code: ClassVar[str] = "ACS"
    name: ClassVar[str] = "Constant acceleration, symmetric"

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        late = xi >= 0.5 - BREAK_TOLERANCE
        rest = np.where(late, 1 - xi, xi)  # time from the nearer end
        half = 2 * rest * rest
        return np.where(late, 1 - half, half), 4 * rest, np.where(late, -4.0, 4.0), np.zeros_like(xi)

    def _coefficients(self) -> Coefficients:
        return Coefficients(cv=2, ca_max=4, ca_min=-4, ca_rms=4, cj=inf, va_max=8, va_min=-8)
