"""Constant acceleration (ACS)."""

from dataclasses import dataclass

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import CONSTANT
from engine.laws.pulse_law import HalvedLaw


@dataclass(frozen=True)
class ConstantAcceleration(HalvedLaw):
    """a = 2/λ over the share λ of the time, −2/(1 − λ) over the rest; with λ = ½, s = 2ξ², then 1 − 2(1 − ξ)².

    ``share`` is λ, between 0 and 1, else ValueError.
    Source: S3, figure 1 and 'ACS'; S1 quotes its C_a = 4. With λ: LCamHdl, ProfileTypes, D_D_PARABOLA.
    """

    code = "ACS"
    name = "Constant acceleration"
    HALF = CONSTANT

    ends: Ends = REST


ENTRY = Entry(
    law=ConstantAcceleration,
    aliases=("constant acceleration symmetric", "symmetric constant acceleration", "parabolic"),
    source="S3, figure 1 and 'ACS'; S1, 'Timing diagram for a cutting machine' (C_a = 4)",
    vendors=Vendors(siemens="D_D_PARABOLA (7)"),
    claims=Claims(
        order_ends=1,
        order_inside=1,
        coefficients=formulas("cv = 2; ca_max = 4; ca_min = -4; ca_rms = 4; cj = inf; va_max = 8; va_min = -8"),
    ),
    example=ConstantAcceleration,
    others=(ConstantAcceleration(0.3),),
    beyond=(ConstantAcceleration(0.6, Ends(1.0, 0.4, -0.2)),),
)
