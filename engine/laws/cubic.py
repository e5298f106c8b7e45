"""Cubic (CUB)."""

import math
from dataclasses import dataclass

from engine.laws.ended_polynomial import EndedCubic, HalvedPolynomial
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import LINE_DOWN


@dataclass(frozen=True)
class Cubic(HalvedPolynomial):
    """The cubic that starts and ends at rest: s = ξ²(3 − 2ξ); v = 6ξ(1 − ξ); a = 6 − 12ξ; j = −12.

    Source: S1, 'Cubic curve'; S3, 'CUB'. With the share λ, a falls from 3/λ to 0 and on to −3/(1 − λ): LCamHdl,
    ProfileTypes, POLY_3.
    """

    code = "CUB"
    name = "Cubic"
    HALF = LINE_DOWN
    ENDED = EndedCubic


ENTRY = Entry(
    law=Cubic,
    aliases=("cubic curve",),
    source="S1, 'Cubic curve'; S3, 'CUB'",
    vendors=Vendors(siemens="POLY_3 (4)", twincat="POLYNOM3 (3)", sew="POLYNOM_3"),
    claims=Claims(
        order_ends=1,
        order_inside=math.inf,
        coefficients=formulas(
            "cv = 3/2; ca_max = 6; ca_min = -6; ca_rms = sqrt(12); cj = inf; va_max = 2*sqrt(3); va_min = -2*sqrt(3)"
        ),
    ),
    example=Cubic,
    others=(Cubic(0.3),),
)
