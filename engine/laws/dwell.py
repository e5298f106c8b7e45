"""Dwell."""

import math
from dataclasses import dataclass

from engine.laws.base import Array, Coefficients, Law, Shapes
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece


@dataclass(frozen=True)
class Dwell(Law):
    """Rest: s = v = a = j = 0 throughout. Source: S3, function motionlaw."""

    code = "DWL"
    name = "Dwell"

    def _block(self, xi: Array) -> tuple[float, float, float, float]:
        return 0.0, 0.0, 0.0, 0.0

    def _coefficients(self) -> Coefficients:
        return Coefficients(cv=0.0, ca_max=0.0, ca_min=0.0, ca_rms=0.0, cj=0.0, va_max=0.0, va_min=0.0)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece without acceleration."""
        return (Piece(1.0),)

    def shapes(self) -> Shapes:
        """Return no share of any."""
        return Shapes()


ENTRY = Entry(
    law=Dwell,
    aliases=("rest",),
    source="S3, function motionlaw, 'Dwell'",
    claims=Claims(
        order_ends=math.inf,
        order_inside=math.inf,
        end=(0.0, 0.0),
        coefficients=dict.fromkeys(("cv", "ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min"), "0"),
    ),
    example=Dwell,
)
