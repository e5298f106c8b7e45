"""Laws without acceleration: the dwell (DWL) and the straight line (LIN)."""

from dataclasses import dataclass

from engine.laws.base import Array, Coefficients, Law, Vendors
from engine.laws.piece import Piece


@dataclass(frozen=True)
class Dwell(Law):
    """Rest: s = v = a = j = 0 throughout. Source: S3, function motionlaw."""

    code = "DWL"
    name = "Dwell"
    aliases = ("rest",)
    source = "S3, function motionlaw, 'Dwell'"

    def _block(self, xi: Array) -> tuple[float, float, float, float]:
        return 0.0, 0.0, 0.0, 0.0

    def _coefficients(self) -> Coefficients:
        return Coefficients(cv=0.0, ca_max=0.0, ca_min=0.0, ca_rms=0.0, cj=0.0, va_max=0.0, va_min=0.0)

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece without acceleration."""
        return (Piece(1.0),)


@dataclass(frozen=True)
class StraightLine(Law):
    """s = ξ; v = 1: constant velocity. Against rest the velocity jumps, which its coefficients do not count."""

    code = "LIN"
    name = "Straight line"
    aliases = ("constant velocity", "Gerade")
    source = "LCamHdl, ProfileTypes, CONST_VELO"
    vendors = Vendors(siemens="CONST_VELO (3)", twincat="POLYNOM1 (1)", codesys="Line", sew="LINEAR")

    def _block(self, xi: Array) -> tuple[Array, float, float, float]:
        return xi, 1.0, 0.0, 0.0

    def _coefficients(self) -> Coefficients:
        return Coefficients(cv=1.0, ca_max=0.0, ca_min=0.0, ca_rms=0.0, cj=0.0, va_max=0.0, va_min=0.0)

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece without acceleration, entered with the velocity 1."""
        return (Piece(1.0),)
