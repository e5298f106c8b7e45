"""Trapezoidal velocity (TVP), symmetric or not."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array, Coefficients, Law, Shapes, require_finite
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece


@dataclass(frozen=True)
class TrapezoidalVelocity(Law):
    """Constant acceleration A up to ξ = α_v, uniform velocity A α_v, constant deceleration B from ξ = α_w on.

    A = 2/(α_v (1 − α_v + α_w)), B = 2/((1 − α_w)(1 − α_v + α_w)).
    ``rise_end`` is α_v and ``fall_start`` α_w, both as shares of the rise (α_s = 1):
    0 < α_v ≤ α_w < 1, else ValueError.
    Source: S1, 'Asymmetric trapezoidal speed profile', equations of A and B; S3, function TVP (e_v = 1/3).
    """

    code = "TVP"
    name = "Trapezoidal velocity"

    rise_end: float = 1 / 3
    fall_start: float = 2 / 3

    def __post_init__(self) -> None:
        require_finite(rise_end=self.rise_end, fall_start=self.fall_start)
        if not 0.0 < self.rise_end <= self.fall_start < 1.0:
            raise ValueError(
                f"rise_end is {self.rise_end:g} and fall_start {self.fall_start:g}; "
                "expected 0 < rise_end <= fall_start < 1"
            )

    @property
    def acceleration(self) -> float:
        """A: the constant acceleration up to α_v."""
        return 2.0 / (self.rise_end * (1.0 - self.rise_end + self.fall_start))

    @property
    def deceleration(self) -> float:
        """B: the constant deceleration from α_w on, positive."""
        return 2.0 / ((1.0 - self.fall_start) * (1.0 - self.rise_end + self.fall_start))

    def _block(self, xi: Array) -> tuple[Array, Array, Array, float]:
        up, down = self.acceleration, self.deceleration
        top = up * self.rise_end
        fall = xi >= self.fall_start - BREAK_TOLERANCE
        rise = xi < self.rise_end - BREAK_TOLERANCE
        t = 1.0 - xi
        s = np.where(
            rise,
            up / 2 * xi * xi,
            np.where(fall, 1.0 - down / 2 * t * t, top * (xi - self.rise_end / 2)),
        )
        v = np.where(rise, up * xi, np.where(fall, down * t, top))
        return s, v, np.where(rise, up, np.where(fall, -down, 0.0)), 0.0

    def _coefficients(self) -> Coefficients:
        up, down = self.acceleration, self.deceleration
        top = up * self.rise_end
        square = self.rise_end * up**2 + (1.0 - self.fall_start) * down**2
        return Coefficients(
            cv=top,
            ca_max=up,
            ca_min=-down,
            ca_rms=math.sqrt(square),
            cj=math.inf,
            va_max=top * up,
            va_min=-top * down,
        )

    @property
    def breaks(self) -> tuple[float, ...]:
        """The break points α_v and α_w."""
        return self.rise_end, self.fall_start

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return acceleration A, uniform velocity, deceleration B."""
        return (
            Piece(self.rise_end, (self.acceleration, 0.0, 0.0, 0.0)),
            Piece(self.fall_start - self.rise_end),
            Piece(1.0 - self.fall_start, (-self.deceleration, 0.0, 0.0, 0.0)),
        )

    def shapes(self) -> Shapes:
        """Return a constant of α_v and one of 1 − α_w."""
        return Shapes(flat_up=self.rise_end, flat_down=1.0 - self.fall_start)


ENTRY = Entry(
    law=TrapezoidalVelocity,
    aliases=(
        "trapezoidal speed",
        "asymmetric trapezoidal",
        "asymmetric trapezoidal speed profile",
        "s-shape",
    ),
    source="S1, 'Asymmetric trapezoidal speed profile'; S3, function TVP",
    claims=Claims(
        order_ends=1,
        order_inside=1,
        coefficients={
            "cv": "3/2",
            "ca_max": "9/2",
            "ca_min": "-9/2",
            "ca_rms": "9/2*sqrt(2/3)",
            "cj": "inf",
            "va_max": "27/4",
            "va_min": "-27/4",
        },
    ),
    example=TrapezoidalVelocity,
    others=(TrapezoidalVelocity(0.1, 0.7), TrapezoidalVelocity(0.45, 0.45), TrapezoidalVelocity(0.02, 0.98)),
)
