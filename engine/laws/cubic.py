"""Cubic (CUB): S1, S3."""

from __future__ import annotations

from math import inf, sqrt
from typing import ClassVar

from engine.laws.base import Array, Coefficients, Law


class Cubic(Law):
    """The cubic at rest at both ends: s = 3ξ² − 2ξ³, v = 6ξ(1 − ξ), a = 6 − 12ξ, j = −12 (S3, law CUB)."""

    code: ClassVar[str] = "CUB"
    name: ClassVar[str] = "Cubic"

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        return xi * xi * (3 - 2 * xi), 6 * xi * (1 - xi), 6 - 12 * xi, 0 * xi - 12

    def _coefficients(self) -> Coefficients:
        peak = 2 * sqrt(3)  # 36 ξ (1 − ξ)(1 − 2ξ) at ξ = (3 − √3)/6
        return Coefficients(
            cv=1.5, ca_max=6, ca_min=-6, ca_rms=2 * sqrt(3), cj=inf, va_max=peak, va_min=-peak
        )
