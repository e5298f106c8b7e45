"""Trapezoidal velocity with ramps of a squared sine (SRT)."""

from dataclasses import dataclass

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import HALF_SINE
from engine.laws.pulse_law import PulseLaw, TwoPulses
from engine.laws.trapezoidal_velocity import require_breaks


@dataclass(frozen=True)
class SineRamps(PulseLaw):
    """v = V sin²(πξ/2α) up to ξ = α = ``rise_end``, V, and the same mirrored from ``fall_start`` on, over δ.

    a = (πV/2α) sin(πu/α), V = 2/(1 + β) with β the time at V. 0 < rise_end ≤ fall_start < 1, else ValueError.
    Source: CODESYS, SML_RampType, Sin2; mechdesigner.support, 'Cycloidal CV'.
    """

    code = "SRT"
    name = "Sine-ramp trapezoid"

    rise_end: float = 0.25
    fall_start: float = 0.75
    ends: Ends = REST

    def __post_init__(self) -> None:
        require_breaks(self.rise_end, self.fall_start)

    def _pulses(self) -> TwoPulses:
        return TwoPulses(HALF_SINE, self.rise_end, self.fall_start - self.rise_end, HALF_SINE, 1.0 - self.fall_start)


ENTRY = Entry(
    law=SineRamps,
    aliases=("modified trapezoidal velocity", "cycloidal with constant velocity", "sin² ramp"),
    source="CODESYS, SML_RampType, Sin2; mechdesigner.support, 'Cycloidal CV'",
    vendors=Vendors(codesys="SML_RT_Sin2, of ramps"),
    claims=Claims(
        order_ends=2,
        order_inside=2,
        coefficients=formulas(
            "cv = 4/3; ca_max = 8*pi/3; ca_min = -ca_max; ca_rms = 4*pi/3; cj = 32*pi**2/3; "
            "va_max = 4*sqrt(3)*pi/3; va_min = -va_max"
        ),
    ),
    example=SineRamps,
    others=(SineRamps(0.2, 0.7), SineRamps(0.4, 0.4)),
    beyond=(SineRamps(0.2, 0.7, Ends(1.0, 1.5, -0.3)),),
)
