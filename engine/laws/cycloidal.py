"""Cycloidal (CIC)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from engine.laws.base import Array, Coefficients, Law, Shapes
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece

TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Cycloidal(Law):
    """a = 2π sin 2πξ; v = 1 − cos 2πξ; s = ξ − sin(2πξ)/2π. Source: S3, 'CIC'."""

    code = "CIC"
    name = "Cycloidal"

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        sin, cos = np.sin(TURN * xi), np.cos(TURN * xi)
        return xi - sin / TURN, 1.0 - cos, TURN * sin, TURN**2 * cos

    def _coefficients(self) -> Coefficients:
        power = TURN * 3.0 * math.sqrt(3.0) / 4.0  # 2π sin θ (1 − cos θ) at θ = 2π/3
        return Coefficients(
            cv=2.0,
            ca_max=TURN,
            ca_min=-TURN,
            ca_rms=TURN / math.sqrt(2.0),
            cj=TURN**2,
            va_max=power,
            va_min=-power,
        )

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one full sine, a = 2π sin 2πu."""
        return (Piece(1.0, amplitude=TURN, omega=TURN),)

    def shapes(self) -> Shapes:
        """Return two quarters of the sine on either side of the middle."""
        return Shapes(sine_up=0.5, sine_down=0.5)


ENTRY = Entry(
    law=Cycloidal,
    aliases=("cycloid",),
    source="S1, 'Cycloidal curve'; S3, 'CIC'",
    claims=Claims(
        order_ends=2,
        order_inside=math.inf,
        coefficients={
            "cv": "2",
            "ca_max": "2*pi",
            "ca_min": "-2*pi",
            "ca_rms": "pi*sqrt(2)",
            "cj": "4*pi**2",
            "va_max": "3*sqrt(3)*pi/2",
            "va_min": "-3*sqrt(3)*pi/2",
        },
    ),
    example=Cycloidal,
)
