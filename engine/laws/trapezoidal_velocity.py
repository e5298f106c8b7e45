"""Trapezoidal velocity (TVP), asymmetric in general: S1, slides on the asymmetric trapezoidal speed profile."""

from __future__ import annotations

from math import inf, sqrt
from typing import ClassVar

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array, Coefficients, Law


class TrapezoidalVelocity(Law):
    """Constant acceleration A up to α_v, uniform velocity up to α_w, constant deceleration B to the end.

    With α_s = 1 and h = 1 (S1, second system of equations)::

        A = 2 / (α_v (1 − α_v + α_w)),   B = 2 / ((1 − α_w)(1 − α_v + α_w)),   A/B = (1 − α_w)/α_v

    ``rise_end`` is α_v, ``fall_start`` α_w. S3's TVP is the symmetric case with e_v = 1/3.
    Raises ValueError unless 0 < α_v ≤ α_w < 1.
    """

    code: ClassVar[str] = "TVP"
    name: ClassVar[str] = "Trapezoidal velocity"

    def __init__(self, rise_end: float = 1 / 3, fall_start: float = 2 / 3) -> None:
        if not 0 < rise_end <= fall_start < 1:
            raise ValueError(
                f"trapezoidal velocity: expected 0 < rise_end <= fall_start < 1, found {rise_end:g} and {fall_start:g}"
            )
        self.rise_end, self.fall_start = rise_end, fall_start
        width = 1 - rise_end + fall_start
        self.acceleration = 2 / (rise_end * width)
        self.deceleration = 2 / ((1 - fall_start) * width)

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        a, b, first, second = self.acceleration, self.deceleration, self.rise_end, self.fall_start
        early, late = xi < first - BREAK_TOLERANCE, xi >= second - BREAK_TOLERANCE
        rest, top = 1 - xi, a * first
        s = np.where(early, a / 2 * xi * xi, np.where(late, 1 - b / 2 * rest * rest, top * (xi - first / 2)))
        v = np.where(early, a * xi, np.where(late, b * rest, top))
        return s, v, np.where(early, a, np.where(late, -b, 0.0)), np.zeros_like(xi)

    def _coefficients(self) -> Coefficients:
        a, b, first, second = self.acceleration, self.deceleration, self.rise_end, self.fall_start
        top = a * first
        rms = sqrt(first * a**2 + (1 - second) * b**2)
        return Coefficients(cv=top, ca_max=a, ca_min=-b, ca_rms=rms, cj=inf, va_max=top * a, va_min=-top * b)
