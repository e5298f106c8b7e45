"""Cycloidal (CIC)."""

import math
from dataclasses import dataclass

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import HALF_SINE
from engine.laws.pulse_law import HalvedLaw


@dataclass(frozen=True)
class Cycloidal(HalvedLaw):
    """a = (π/λ) sin(πξ/λ) over the share λ of the time, −(π/μ) sin(π(ξ − λ)/μ) over the rest, μ = 1 − λ.

    With λ = ½, a = 2π sin 2πξ; v = 1 − cos 2πξ; s = ξ − sin(2πξ)/2π. ``share`` is λ, between 0 and 1, else
    ValueError. Source: S3, 'CIC'. With λ: LCamHdl, ProfileTypes, D_D_INCLINED_SINE.
    """

    code = "CIC"
    name = "Cycloidal"
    HALF = HALF_SINE

    ends: Ends = REST


ENTRY = Entry(
    law=Cycloidal,
    aliases=("cycloid",),
    source="S1, 'Cycloidal curve'; S3, 'CIC'",
    vendors=Vendors(
        siemens="D_D_INCLINED_SINE (10)", twincat="BESTEHORN (12)", codesys="InclinedSine", sew="INCLINED_SINE"
    ),
    claims=Claims(
        order_ends=2,
        order_inside=math.inf,
        coefficients=formulas(
            "cv = 2; ca_max = 2*pi; ca_min = -2*pi; ca_rms = pi*sqrt(2); cj = 4*pi**2; "
            "va_max = 3*sqrt(3)*pi/2; va_min = -3*sqrt(3)*pi/2"
        ),
    ),
    example=Cycloidal,
    others=(Cycloidal(0.3),),
    beyond=(Cycloidal(0.6, Ends(1.0, 0.8, -0.3)),),
)
