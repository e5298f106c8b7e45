"""Simple harmonic (SHM)."""

import math
from dataclasses import dataclass

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import FALLING_SINE
from engine.laws.pulse_law import HalvedLaw


@dataclass(frozen=True)
class SimpleHarmonic(HalvedLaw):
    """s = (1 − cos πξ)/2; with the share λ, a quarter of a cosine over λ and one of a sine over 1 − λ.

    It begins and ends with an acceleration: a law from reversal to reversal. Raises ValueError unless λ, the
    ``share``, is between 0 and 1. Source: LCamHdl, ProfileTypes, D_D_BASIC_SINE, R_R_BASIC_SINE.
    """

    code = "SHM"
    name = "Simple harmonic"
    STAGES = (2, 4)
    HALF = FALLING_SINE

    ends: Ends = REST


ENTRY = Entry(
    law=SimpleHarmonic,
    aliases=("harmonic", "basic sine", "einfache Sinuslinie"),
    source="LCamHdl, ProfileTypes, D_D_BASIC_SINE, R_R_BASIC_SINE",
    vendors=Vendors(siemens="D_D_BASIC_SINE (9)", twincat="SINUSLINIE (10)", sew="SINE"),
    claims=Claims(
        order_ends=1,
        order_inside=math.inf,
        coefficients=formulas(
            "cv = pi/2; ca_max = pi**2/2; ca_min = -ca_max; ca_rms = pi**2/(2*sqrt(2)); cj = inf; "
            "va_max = pi**3/8; va_min = -va_max"
        ),
    ),
    example=SimpleHarmonic,
    others=(SimpleHarmonic(0.3),),
    beyond=(SimpleHarmonic(0.6, Ends(1.0, 0.3, 1.2)),),
)
