"""Cycloidal (CIC): S2, movement equation; S3."""

from __future__ import annotations

from math import pi, sqrt
from typing import ClassVar

import numpy as np

from engine.laws.base import Array, Coefficients, Law


class Cycloidal(Law):
    """One full sine of acceleration: s = ξ − sin(2πξ)/2π, v = 1 − cos 2πξ, a = 2π sin 2πξ, j = 4π² cos 2πξ (S2)."""

    code: ClassVar[str] = "CIC"
    name: ClassVar[str] = "Cycloidal"

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        x = 2 * pi * xi
        sine, cosine = np.sin(x), np.cos(x)
        return xi - sine / (2 * pi), 1 - cosine, 2 * pi * sine, 4 * pi**2 * cosine

    def _coefficients(self) -> Coefficients:
        peak = 3 * sqrt(3) / 2 * pi  # 2π (1 − cos x) sin x at x = 2π/3
        return Coefficients(
            cv=2, ca_max=2 * pi, ca_min=-2 * pi, ca_rms=pi * sqrt(2), cj=4 * pi**2, va_max=peak, va_min=-peak
        )
