"""Harmonic combination (HAC)."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from engine.laws.ends import REST, EndError, Ends, require_ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import FALLING_SINE, sine_edged
from engine.laws.pulse_law import PulseLaw, TwoPulses, require_share

REST_SIDE = sine_edged(0.25, 0.0, 0.75)


@dataclass(frozen=True)
class HarmonicCombination(PulseLaw):
    """A modified sine at one end, and at the other, where it turns round, a quarter of a sine.

    ``reversal`` says which end, "end" (rest to reversal, velocity to reversal) or "start". ``share`` is λ, between
    0 and 1; else ValueError. Where an acceleration is asked for at the reversal, λ is what gives it: so two such
    laws meet without a jump.
    Source: LCamHdl, ProfileTypes, D_R_, R_D_, C_R_ and R_C_HARMONIC_COMBI; camdoku of i-halbritter.
    """

    code = "HAC"
    name = "Harmonic combination"
    STAGES = (0, 2, 4, 6)

    share: float = 0.5
    reversal: Literal["start", "end"] = "end"
    ends: Ends = REST

    def __post_init__(self) -> None:
        require_share("share", self.share)
        if self.reversal not in ("start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'start' or 'end'")

    @property
    def _at_end(self) -> bool:
        return self.reversal == "end"

    def _pulses(self) -> TwoPulses:
        rise, fall = (REST_SIDE, FALLING_SINE) if self._at_end else (FALLING_SINE, REST_SIDE)
        return TwoPulses(rise, self.share, 0.0, fall, 1.0 - self.share)

    def between(self, ends: Ends) -> "HarmonicCombination":
        """Return the law between these ends; where an acceleration is asked for at the reversal, with another share.

        Raises EndError where no share between 0 and 1 gives that acceleration.
        """
        asked = -ends.a1 if self._at_end else ends.a0
        plain = replace(ends, a1=0.0) if self._at_end else replace(ends, a0=0.0)
        require_ends(self, plain, self.takes)
        law = self._with(plain)
        return replace(law, share=law._share_for(asked)) if asked else law

    def _share_for(self, height: float) -> float:
        """Return λ for which the quarter sine has this height.

        With the velocities v at the other end and v_r at the reversal, μ the share of the quarter sine, κ of the
        pulse at the other end and κ_r, w_r of the quarter sine::

            w_r B (κ_r − κ) μ² + [w_r B κ − (v − v_r)(1 − κ)] μ = H − v (1 − κ) − v_r κ
        """
        far, near = (self.ends.v0, self.ends.v1) if self._at_end else (self.ends.v1, self.ends.v0)
        lead, gain = REST_SIDE.lead, FALLING_SINE.gain * height
        left = self.ends.stroke - far * (1.0 - lead) - near * lead
        quadratic = (gain * (FALLING_SINE.lead - lead), gain * lead - (far - near) * (1.0 - lead), -left)
        found = [float(root.real) for root in np.roots(quadratic) if not root.imag and 0.0 < root.real < 1.0]
        if not found:
            raise EndError(f"no share between 0 and 1 gives a harmonic combination {height:g} at its reversal")
        best = min(found, key=lambda part: abs(part - 0.5))
        return 1.0 - best if self._at_end else best


ENTRY = Entry(
    law=HarmonicCombination,
    aliases=("harmonische Kombination",),
    source="LCamHdl, ProfileTypes, D_R_, R_D_, C_R_ and R_C_HARMONIC_COMBI",
    vendors=Vendors(siemens="D_R_HARMONIC_COMBINATION (20)"),
    claims=Claims(
        order_ends=1,
        order_inside=2,
        where={"d": "6 + pi/2", "y": "(sqrt(73) - 1)/12"},
        coefficients=formulas(
            "cv = 4*pi/d; ca_max = 4*pi**2/d; ca_min = -ca_max; ca_rms = 2*pi**2*sqrt(2)/d; cj = inf; "
            "va_max = ca_max**2/(4*pi)*(1 + 3*y)*sqrt(1 - y**2); va_min = cv*ca_min/2"
        ),
    ),
    example=HarmonicCombination,
    others=(HarmonicCombination(0.3), HarmonicCombination(0.6, "start")),
    beyond=(HarmonicCombination(0.4, "end", Ends(1.0, 0.7)), HarmonicCombination(0.4, "start", Ends(1.0, 0.1, 0.7))),
)
