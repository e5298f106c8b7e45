"""Sine, constant and cosine acceleration: the SCCA family (SCC)."""

from dataclasses import dataclass

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, formulas
from engine.laws.pulse import sine_edged
from engine.laws.pulse_law import SUM_TOLERANCE, PulseLaw, TwoPulses, require_part, require_share


@dataclass(frozen=True)
class SineConstantCosine(PulseLaw):
    """Sine edges at the dwells, constants, cosine edges inside, and a part at constant velocity.

    ``sine``, ``constant``, ``cosine`` and ``straight`` are their shares of the whole time, b, c, d and e: not
    negative, of sum 1 (within 1e-9), and not all of it straight. ``share`` is λ, the first pulse's share of what is
    not straight, between 0 and 1. Else ValueError. With λ = ½ and e = 0,
    C_a = 4π²/[(π² − 8)(b² − d²) − 2π(π − 2)b + π²].
    It contains constant acceleration (0, 1, 0), the modified trapezoid (¼, ½, ¼), simple harmonic (0, 0, 1),
    modified sine (¼, 0, ¾) and cycloidal motion (½, 0, ½).
    Source: Norton's SCCA family, as in PTC Creo, 'SCCA', and mechdesigner.support, 'Sine-Constant-Cosine'.
    """

    code = "SCC"
    name = "Sine-constant-cosine"

    sine: float = 1 / 3
    constant: float = 1 / 3
    cosine: float = 1 / 3
    straight: float = 0.0
    share: float = 0.5
    ends: Ends = REST

    def __post_init__(self) -> None:
        parts = {"sine": self.sine, "constant": self.constant, "cosine": self.cosine, "straight": self.straight}
        for name, value in parts.items():
            require_part(name, value)
        if abs(sum(parts.values()) - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the shares {', '.join(parts)} sum to {sum(parts.values()):.12g}; expected 1")
        if not self._bent > 0.0:
            raise ValueError("straight is 1; expected time to speed up and slow down")
        require_share("share", self.share)

    @property
    def _bent(self) -> float:
        return self.sine + self.constant + self.cosine

    def _pulses(self) -> TwoPulses:
        bent = self._bent
        pulse = sine_edged(self.sine / bent, self.constant / bent, self.cosine / bent)
        return TwoPulses(pulse, self.share * bent, self.straight, pulse, (1.0 - self.share) * bent)


ENTRY = Entry(
    law=SineConstantCosine,
    aliases=("SCCA",),
    source="PTC Creo, 'SCCA'; mechdesigner.support, 'Sine-Constant-Cosine'",
    claims=Claims(
        order_ends=2,
        order_inside=3,  # with λ = ½ and nothing straight; else 2
        where={"k": "(1/pi + 1/2)/3", "g": "1/(3*pi)", "y": "2*g/(k + sqrt(k**2 + 8*g**2))"},
        coefficients=formulas(
            "ca_max = 4*pi**2/(pi**2 - 2*pi*(pi - 2)/3); cv = ca_max*(2/(3*pi) + 1/6); ca_min = -ca_max; "
            "ca_rms = ca_max*sqrt(2/3); cj = 3*pi*ca_max; va_max = ca_max**2*(k + g*y)*sqrt(1 - y**2); "
            "va_min = -va_max"
        ),
    ),
    example=SineConstantCosine,
    others=(SineConstantCosine(0.1, 0.6, 0.3), SineConstantCosine(0.2, 0.0, 0.6, 0.2, 0.4)),
    beyond=(SineConstantCosine(0.1, 0.2, 0.3, 0.4, 0.6, Ends(1.0, -0.4, 0.9)),),
)
