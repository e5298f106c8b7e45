"""Double harmonic (DHM): the law of two sines."""

import math
from dataclasses import dataclass
from typing import Literal

from engine.laws.family import Law, Vendors
from engine.laws.piece import Piece, reversed_pieces
from engine.laws.piece_extremes import at_peaks

HALF_PI = math.pi / 2.0
FROM_REST = Piece(
    1.0,
    amplitude=2.0 * HALF_PI**2,
    omega=math.pi,
    phase=HALF_PI,
    amplitude2=-2.0 * HALF_PI**2,
    omega2=math.tau,
    phase2=HALF_PI,
)


@dataclass(frozen=True)
class DoubleHarmonic(Law):
    """s = sin⁴(πξ/2), from rest to a reversal: a = (π²/2)(cos πξ − cos 2πξ).

    At its end v = 0 and a = −π²: its mirror image has to follow, never a dwell. ``reversal`` says which end turns
    round, "end" or "start" (s = 1 − cos⁴(πξ/2)); else ValueError. Its beginning is as smooth as that of the
    polynomial 4-5-6-7.
    Source: LCamHdl, ADD_PROFILE, D_R_DOUBLE_HARMONIC and R_D_DOUBLE_HARMONIC; saltire.com, cam functions.
    """

    code = "DHM"
    name = "Double harmonic"
    source = "LCamHdl, ADD_PROFILE, D_R_DOUBLE_HARMONIC; saltire.com, cam functions"
    vendors = Vendors(siemens="D_R_DOUBLE_HARMONIC (60)")

    reversal: Literal["start", "end"] = "end"

    def __post_init__(self) -> None:
        if self.reversal not in ("start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'start' or 'end'")

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece of two sines."""
        return (FROM_REST,) if self.reversal == "end" else reversed_pieces((FROM_REST,))

    def monotone_pieces(self) -> tuple[Piece, ...]:
        """Return two pieces, which meet where the acceleration at the end at rest is largest: cos πξ = ¼."""
        return tuple(at_peaks(self.as_pieces()[0]))
