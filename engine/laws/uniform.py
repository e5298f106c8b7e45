"""Laws without acceleration: the dwell (DWL) and the straight line (LIN)."""

from dataclasses import dataclass

from engine.laws.family import Law, Vendors
from engine.laws.piece import Piece


@dataclass(frozen=True)
class Dwell(Law):
    """Rest: s = v = a = j = 0 throughout. Source: S3, function motionlaw."""

    code = "DWL"
    name = "Dwell"
    aliases = ("rest",)
    source = "S3, function motionlaw, 'Dwell'"

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

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece without acceleration."""
        return (Piece(1.0),)

    @property
    def entry(self) -> float:
        """The velocity 1."""
        return 1.0
