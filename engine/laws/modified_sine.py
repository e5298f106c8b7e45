"""Modified sine (MSN)."""

import math
from dataclasses import dataclass, replace

from engine.laws.ends import REST, EndError, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import sine_edged
from engine.laws.pulse_law import PulseLaw, TwoPulses, require_part, require_share

N = 2.0 * math.pi**2 / (4.0 + math.pi)
LATE = (3.0 * math.pi - 4.0) / (4.0 * math.pi)
"""κ of the pulse told backwards"""


@dataclass(frozen=True)
class ModifiedSine(PulseLaw):
    """Quarters of a sine: up over β₁λ, down over (1 − β₁)λ, and the like downwards with β₂ and μ = 1 − λ.

    ``share`` is λ, between 0 and 1; ``rise_edge`` and ``fall_edge`` are β₁ and β₂, the shares of either half that
    the edge at the dwell takes, from 0 to 1: ¼ in the modified sine, ½ in the cycloidal law, 0 in the simple
    harmonic one. Else ValueError.
    Source: Neklutin's modified sine, as in LCamHdl, ProfileTypes, D_D_MOD_SINE and, between velocities,
    C_C_MOD_SINE, D_C_MOD_SINE, C_D_MOD_SINE; mechdesigner.support, 'Modified-Sinusoid'.
    """

    code = "MSN"
    name = "Modified sine"
    STAGES = (0, 2, 4, 6)

    share: float = 0.5
    rise_edge: float = 0.25
    fall_edge: float = 0.25
    ends: Ends = REST

    def __post_init__(self) -> None:
        require_share("share", self.share)
        require_part("rise_edge", self.rise_edge)
        require_part("fall_edge", self.fall_edge)

    def _pulses(self) -> TwoPulses:
        rise = sine_edged(self.rise_edge, 0.0, 1.0 - self.rise_edge)
        fall = sine_edged(self.fall_edge, 0.0, 1.0 - self.fall_edge)
        return TwoPulses(rise, self.share, 0.0, fall, 1.0 - self.share)

    @classmethod
    def with_deceleration(cls, deceleration: float, ends: Ends) -> "ModifiedSine":
        """Return the classic law whose second pulse has the height B, by its share λ: the option Ca* of a cam editor.

        μ = [N(H − v0) − π(v1 − v0)/2]/[B + Nκ'(v1 − v0)], κ' = (3π − 4)/4π, N = 2π²/(4 + π).
        Raises EndError where no share between 0 and 1 does.
        Source: LCamHdl, types, 'Ca*'; CODESYS, SM3_CamBuilder, ModifiedSine.
        """
        gained = ends.v1 - ends.v0
        over = deceleration + N * LATE * gained
        late = (N * (ends.stroke - ends.v0) - math.pi / 2.0 * gained) / over if over else math.inf
        if not 0.0 < late < 1.0:
            raise EndError(f"no share between 0 and 1 gives a modified sine the deceleration {deceleration:g}")
        return replace(cls(1.0 - late), ends=ends)


ENTRY = Entry(
    law=ModifiedSine,
    aliases=("modified sinusoid", "modifizierte Sinuslinie"),
    source="LCamHdl, ProfileTypes, D_D_MOD_SINE; mechdesigner.support, 'Modified-Sinusoid'",
    vendors=Vendors(
        siemens="D_D_MOD_SINE (12)", twincat="MODSINUSLINIE (11)", codesys="ModifiedSine", sew="MODIFIED_SINE"
    ),
    claims=Claims(
        order_ends=2,
        order_inside=3,  # with λ = ½; else 2
        where={"n": "2*pi**2/(4 + pi)", "y": "(sqrt(73) - 1)/12"},  # the sine at which v·a is greatest
        coefficients=formulas(
            "cv = 4*pi/(4 + pi); ca_max = 2*n; ca_min = -ca_max; ca_rms = sqrt(2)*n; cj = 8*pi*n; "
            "va_max = n**2/pi*(1 + 3*y)*sqrt(1 - y**2); va_min = -va_max"
        ),
    ),
    example=ModifiedSine,
    others=(ModifiedSine(0.3), ModifiedSine(0.3, 0.25, 0.4), ModifiedSine(0.6, 0.0, 1.0)),
    beyond=(ModifiedSine(0.4, ends=Ends(1.0, 2.0, -0.5)),),
)
