"""Constant acceleration, symmetric (ACS)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array, Coefficients, Law, Shapes
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece


@dataclass(frozen=True)
class ConstantAcceleration(Law):
    """a = 4 over the first half of the rise, a = −4 over the second; s = 2ξ², then 1 − 2(1 − ξ)².

    Source: S3, figure 1 and 'ACS'; S1 quotes its C_a = 4.
    """

    code = "ACS"
    name = "Constant acceleration"

    def _block(self, xi: Array) -> tuple[Array, Array, Array, float]:
        late = xi >= 0.5 - BREAK_TOLERANCE
        t = np.where(late, 1.0 - xi, xi)  # to the nearer end
        travel = 2.0 * t * t
        return np.where(late, 1.0 - travel, travel), 4.0 * t, np.where(late, -4.0, 4.0), 0.0

    def _coefficients(self) -> Coefficients:
        return Coefficients(cv=2.0, ca_max=4.0, ca_min=-4.0, ca_rms=4.0, cj=math.inf, va_max=8.0, va_min=-8.0)

    @property
    def breaks(self) -> tuple[float, ...]:
        """The middle, at which a turns round."""
        return (0.5,)

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the two halves, a = 4 and a = −4."""
        return Piece(0.5, (4.0, 0.0, 0.0, 0.0)), Piece(0.5, (-4.0, 0.0, 0.0, 0.0))

    def shapes(self) -> Shapes:
        """Return two constants of half the time each."""
        return Shapes(flat_up=0.5, flat_down=0.5)


ENTRY = Entry(
    law=ConstantAcceleration,
    aliases=("constant acceleration symmetric", "symmetric constant acceleration", "parabolic"),
    source="S3, figure 1 and 'ACS'; S1, 'Timing diagram for a cutting machine' (C_a = 4)",
    claims=Claims(
        order_ends=1,
        order_inside=1,
        coefficients={
            "cv": "2",
            "ca_max": "4",
            "ca_min": "-4",
            "ca_rms": "4",
            "cj": "inf",
            "va_max": "8",
            "va_min": "-8",
        },
    ),
    example=ConstantAcceleration,
)
