"""Laws without pulses (DWL, LIN), of a pulse and its mirror image (ACS, CIC, SHM), and of two sines (DHM)."""

import math
from dataclasses import dataclass
from typing import ClassVar, Literal

from engine.laws.extremes import at_peaks
from engine.laws.family import Law, Vendors
from engine.laws.piece import Piece, reversed_pieces
from engine.laws.pulse_law import CONSTANT, FALLING_SINE, HALF_SINE, Pulse, PulseLaw, TwoPulses, require_shares


@dataclass(frozen=True)
class Dwell(Law):
    """Rest: s = v = a = j = 0 throughout. Source: S3, function motionlaw."""

    code = "DWL"
    number = 1
    name = "Dwell"
    aliases = ("rest",)
    source = "S3, function motionlaw, 'Dwell'"

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return a piece without acceleration."""
        return (Piece(1.0),)


@dataclass(frozen=True)
class StraightLine(Law):
    """s = ξ, v = 1: constant velocity. Next to a dwell the velocity jumps, which its coefficients do not count."""

    code = "LIN"
    number = 8
    name = "Straight line"
    aliases = ("constant velocity", "linear", "Gerade")
    source = "LCamHdl, ProfileTypes, CONST_VELO"
    vendors = Vendors(siemens="CONST_VELO (3)", twincat="POLYNOM1 (1)", codesys="Line", sew="LINEAR")

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return a piece without acceleration."""
        return (Piece(1.0),)

    @property
    def entry_velocity(self) -> float:
        """Velocity at ξ = 0: 1."""
        return 1.0


@dataclass(frozen=True)
class HalvedLaw(PulseLaw):
    """A pulse over the share λ of the time, and its mirror image over the rest."""

    STAGES = (0, 2)
    HALF: ClassVar[Pulse]

    share: float = 0.5  # λ, between 0 and 1, else ValueError

    def __post_init__(self) -> None:
        require_shares(share=self.share)

    def _pulses(self) -> TwoPulses:
        return TwoPulses(self.HALF, self.share, 0.0, self.HALF, 1.0 - self.share)


@dataclass(frozen=True)
class ConstantAcceleration(HalvedLaw):
    """a = 2/λ over the share λ of the time, −2/(1 − λ) over the rest; with λ = ½, s = 2ξ², then 1 − 2(1 − ξ)²."""

    code = "ACS"
    number = 2
    name = "Constant acceleration"
    aliases = ("constant acceleration symmetric", "symmetric constant acceleration", "parabolic", "parabola")
    source = "S3, figure 1 and 'ACS'; S1, 'Timing diagram for a cutting machine' (C_a = 4)"
    vendors = Vendors(siemens="D_D_PARABOLA (7)")
    HALF = CONSTANT


@dataclass(frozen=True)
class Cycloidal(HalvedLaw):
    """a = (π/λ) sin(πξ/λ) over the share λ of the time, −(π/μ) sin(π(ξ − λ)/μ) over the rest, μ = 1 − λ.

    With λ = ½, a = 2π sin 2πξ; v = 1 − cos 2πξ; s = ξ − sin(2πξ)/2π. With λ: LCamHdl, D_D_INCLINED_SINE.
    """

    code = "CIC"
    number = 4
    name = "Cycloidal"
    aliases = ("cycloid", "cyc", "Sinoide", "geneigte Sinuslinie")
    source = "S1, 'Cycloidal curve'; S3, 'CIC'"
    vendors = Vendors(
        siemens="D_D_INCLINED_SINE (10)", twincat="BESTEHORN (12)", codesys="InclinedSine", sew="INCLINED_SINE"
    )
    HALF = HALF_SINE


@dataclass(frozen=True)
class SimpleHarmonic(HalvedLaw):
    """s = (1 − cos πξ)/2, between reversals; with λ, a quarter of a cosine over λ and of a sine over 1 − λ."""

    code = "SHM"
    number = 9
    name = "Simple harmonic"
    aliases = ("harmonic", "simple harmonic motion", "basic sine", "einfache Sinuslinie")
    source = "LCamHdl, ProfileTypes, D_D_BASIC_SINE, R_R_BASIC_SINE"
    vendors = Vendors(siemens="D_D_BASIC_SINE (9)", twincat="SINUSLINIE (10)", sew="SINE")
    STAGES = (2, 4)
    HALF = FALLING_SINE


PEAK, COSINE = math.pi**2 / 2.0, math.pi / 2.0
FROM_REST = Piece(1.0, (0.0,) * 4, PEAK, math.pi, COSINE, -PEAK, math.tau, COSINE)


@dataclass(frozen=True)
class DoubleHarmonic(Law):
    """s = sin⁴(πξ/2), from rest to a reversal: a = (π²/2)(cos πξ − cos 2πξ).

    At its end v = 0 and a = −π², so its mirror image has to follow, never a dwell. It begins as smoothly as the
    polynomial 4-5-6-7.
    """

    code = "DHM"
    number = 10
    name = "Double harmonic"
    aliases = ("double harmonic motion", "doppelt harmonisch")
    source = "LCamHdl, ADD_PROFILE, D_R_DOUBLE_HARMONIC; saltire.com, cam functions"
    vendors = Vendors(siemens="D_R_DOUBLE_HARMONIC (60)")

    # which end turns round; at the start, s = 1 − cos⁴(πξ/2)
    reversal: Literal["start", "end"] = "end"

    def __post_init__(self) -> None:
        if self.reversal not in ("start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'start' or 'end'")

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return a piece of two sines."""
        return (FROM_REST,) if self.reversal == "end" else reversed_pieces((FROM_REST,))

    def monotone_pieces(self) -> tuple[Piece, ...]:
        """Return two pieces, which meet where the acceleration at the end at rest is largest: cos πξ = ¼."""
        return tuple(at_peaks(self.as_pieces()[0]))
