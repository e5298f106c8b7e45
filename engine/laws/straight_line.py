"""Straight line (LIN)."""

import math
from dataclasses import dataclass

from engine.laws.base import Array, Coefficients, Law, Shapes
from engine.laws.entry import Claims, Entry, Vendors
from engine.laws.piece import Piece


@dataclass(frozen=True)
class StraightLine(Law):
    """s = ξ; v = 1: constant velocity. Against rest the velocity jumps, which its coefficients do not count.

    Source: LCamHdl, ProfileTypes, CONST_VELO.
    """

    code = "LIN"
    name = "Straight line"

    def _block(self, xi: Array) -> tuple[Array, float, float, float]:
        return xi, 1.0, 0.0, 0.0

    def _coefficients(self) -> Coefficients:
        return Coefficients(cv=1.0, ca_max=0.0, ca_min=0.0, ca_rms=0.0, cj=0.0, va_max=0.0, va_min=0.0)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece without acceleration, entered with the velocity 1."""
        return (Piece(1.0),)

    def shapes(self) -> Shapes:
        """Return no share of any."""
        return Shapes()


ENTRY = Entry(
    law=StraightLine,
    aliases=("constant velocity", "Gerade"),
    source="LCamHdl, ProfileTypes, CONST_VELO",
    vendors=Vendors(siemens="CONST_VELO (3)", twincat="POLYNOM1 (1)", codesys="Line", sew="LINEAR"),
    claims=Claims(
        order_ends=0,
        order_inside=math.inf,
        start=(0.0, 1.0),
        end=(1.0, 1.0),
        coefficients={"cv": "1"} | dict.fromkeys(("ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min"), "0"),
    ),
    example=StraightLine,
)
