"""Sine, straight line, sine: from reversal to reversal (SGS)."""

from dataclasses import dataclass

from engine.laws.base import require_finite
from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import FALLING_SINE
from engine.laws.pulse_law import PulseLaw, TwoPulses, require_share


@dataclass(frozen=True)
class SineStraightSine(PulseLaw):
    """A quarter of a cosine over cλ, a straight line over 1 − c, a quarter of a sine over c(1 − λ).

    ``curved`` is c, more than 0 and at most 1 (1 is the simple harmonic law), ``share`` λ, between 0 and 1; else
    ValueError. V = π/(π − (π − 2)c). It begins and ends with an acceleration: it is meant for reversals.
    Source: LCamHdl, ProfileTypes, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286 (C, 0.5 by default).
    """

    code = "SGS"
    name = "Sine-straight-sine"
    STAGES = (2, 3, 4)

    curved: float = 0.5
    share: float = 0.5
    ends: Ends = REST

    def __post_init__(self) -> None:
        require_finite(curved=self.curved)
        if not 0.0 < self.curved <= 1.0:
            raise ValueError(f"curved is {self.curved:g}; expected a share of more than 0 and at most 1")
        require_share("share", self.share)

    def _pulses(self) -> TwoPulses:
        late = self.curved * (1.0 - self.share)
        return TwoPulses(FALLING_SINE, self.curved * self.share, 1.0 - self.curved, FALLING_SINE, late)


ENTRY = Entry(
    law=SineStraightSine,
    aliases=("modified velocity trapezoid", "Sinus-Gerade-Kombination"),
    source="LCamHdl, ProfileTypes, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286",
    vendors=Vendors(siemens="R_R_MOD_VELO_TRAPEZOID (14)", twincat="SINUS_GERADE_KOMBI (16)"),
    claims=Claims(
        order_ends=1,
        order_inside=2,
        coefficients=formulas(
            "cv = 2*pi/(2 + pi); ca_max = 2*pi*cv; ca_min = -ca_max; ca_rms = pi*cv; cj = inf; "
            "va_max = ca_max*cv/2; va_min = -va_max"
        ),
    ),
    example=SineStraightSine,
    others=(SineStraightSine(0.3, 0.4), SineStraightSine(1.0)),
    beyond=(SineStraightSine(0.3, 0.4, Ends(1.0, 0.5, 0.2)),),
)
