"""Modified trapezoid by its share, also from rest to reversal (MTS)."""

from dataclasses import dataclass
from typing import Literal

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import sine_edged
from engine.laws.pulse_law import PulseLaw, TwoPulses, require_part, require_share

CLASSIC = sine_edged(0.25, 0.5, 0.25)


@dataclass(frozen=True)
class TrapezoidByShare(PulseLaw):
    """The pulses ¼-½-¼ of the modified trapezoid over λ and over 1 − λ; or one of them cut off at a reversal.

    ``share`` is λ, between 0 and 1. At a ``reversal``, "start" or "end" (else "none"), the pulse stands at its
    height: ``edge`` of its duration, from 0 to 1, is a quarter of a sine at the inner end, the rest constant.
    Else ValueError. The vendors do not publish ``edge``; with ½ and λ = ½ both pulses are of one height.
    Source: LCamHdl, ProfileTypes, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D; SolidWorks, modified trapezoid (⅛, ⅜, ⅝, ⅞).
    """

    code = "MTS"
    name = "Modified trapezoid by share"
    STAGES = (0, 1, 2, 4, 5, 6)

    share: float = 0.5
    reversal: Literal["none", "start", "end"] = "none"
    edge: float = 0.5
    ends: Ends = REST

    def __post_init__(self) -> None:
        require_share("share", self.share)
        require_part("edge", self.edge)
        if self.reversal not in ("none", "start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'none', 'start' or 'end'")

    def _pulses(self) -> TwoPulses:
        cut = sine_edged(0.0, 1.0 - self.edge, self.edge)
        rise, fall = (cut if self.reversal == end else CLASSIC for end in ("start", "end"))
        return TwoPulses(rise, self.share, 0.0, fall, 1.0 - self.share)


ENTRY = Entry(
    law=TrapezoidByShare,
    aliases=("modifiziertes Beschleunigungstrapez",),
    source="LCamHdl, ProfileTypes, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D",
    vendors=Vendors(siemens="D_D_MOD_ACCEL_TRAPEZOID (11)", twincat="BESCHLTRAPEZ (13)"),
    claims=Claims(
        order_ends=2,
        order_inside=3,  # with λ = ½; else 2
        where={"y": "2/(1 + pi + sqrt((1 + pi)**2 + 8))"},
        coefficients=formulas(
            "cv = 2; ca_max = 8*pi/(2 + pi); ca_min = -ca_max; ca_rms = ca_max*sqrt(3)/2; cj = 4*pi*ca_max; "
            "va_max = ca_max**2/(4*pi)*(1 + pi + y)*sqrt(1 - y**2); va_min = -va_max"
        ),
    ),
    example=TrapezoidByShare,
    others=(TrapezoidByShare(0.3), TrapezoidByShare(0.5, "end"), TrapezoidByShare(0.3, "start", 0.7)),
    beyond=(TrapezoidByShare(0.4, ends=Ends(1.0, 0.6, 1.1)),),
)
