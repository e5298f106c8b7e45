"""Dwell (DWL): S3."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from engine.laws.base import Array, Coefficients, Law


class Dwell(Law):
    """No motion: s = v = a = j = 0 (S3, law Dwell)."""

    code: ClassVar[str] = "DWL"
    name: ClassVar[str] = "Dwell"

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        return np.zeros_like(xi), np.zeros_like(xi), np.zeros_like(xi), np.zeros_like(xi)

    def _coefficients(self) -> Coefficients:
        return Coefficients(0, 0, 0, 0, 0, 0, 0)
