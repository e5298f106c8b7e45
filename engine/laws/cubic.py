"""Cubic (CUB)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from engine.laws.base import Array, Coefficients, Law, Shapes
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece


@dataclass(frozen=True)
class Cubic(Law):
    """The cubic that starts and ends at rest: s = ξ²(3 − 2ξ); v = 6ξ(1 − ξ); a = 6 − 12ξ; j = −12.

    Source: S1, 'Cubic curve'; S3, 'CUB'.
    """

    code = "CUB"
    name = "Cubic"

    def _block(self, xi: Array) -> tuple[Array, Array, Array, float]:
        return xi * xi * (3.0 - 2.0 * xi), 6.0 * xi * (1.0 - xi), 6.0 - 12.0 * xi, -12.0

    def _coefficients(self) -> Coefficients:
        power = 2.0 * math.sqrt(3.0)  # 36 ξ(1 − ξ)(1 − 2ξ) at ξ = (3 − √3)/6
        return Coefficients(
            cv=1.5,
            ca_max=6.0,
            ca_min=-6.0,
            ca_rms=math.sqrt(12.0),
            cj=math.inf,
            va_max=power,
            va_min=-power,
        )

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one cubic, a = 6 − 12u."""
        return (Piece(1.0, (6.0, -12.0, 0.0, 0.0)),)

    def shapes(self) -> Shapes:
        """Return the straight line, half of it on either side of the middle."""
        return Shapes(ramp_up=0.5, ramp_down=0.5)


ENTRY = Entry(
    law=Cubic,
    aliases=("cubic curve",),
    source="S1, 'Cubic curve'; S3, 'CUB'",
    claims=Claims(
        order_ends=1,
        order_inside=math.inf,
        coefficients={
            "cv": "3/2",
            "ca_max": "6",
            "ca_min": "-6",
            "ca_rms": "sqrt(12)",
            "cj": "inf",
            "va_max": "2*sqrt(3)",
            "va_min": "-2*sqrt(3)",
        },
    ),
    example=Cubic,
)
