"""Polynomial 4-5-6-7 (PO7)."""

import math
from dataclasses import dataclass

from engine.laws.ended_polynomial import EndedSeptic, HalvedPolynomial
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import HALF_4567


@dataclass(frozen=True)
class Polynomial4567(HalvedPolynomial):
    """s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷; v = 140ξ³(1 − ξ)³; a = 420ξ² − 1680ξ³ + 2100ξ⁴ − 840ξ⁵.

    Source: LCamHdl, ProfileTypes, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'.
    """

    code = "PO7"
    name = "Polynomial 4-5-6-7"
    TAKES = "vaj"
    HALF = HALF_4567
    ENDED = EndedSeptic


ENTRY = Entry(
    law=Polynomial4567,
    aliases=("4-5-6-7", "septic", "polynomial of degree 7", "Polynom 7. Grades"),
    source="LCamHdl, ProfileTypes, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'",
    vendors=Vendors(siemens="POLY_7 (6), of two sextics", twincat="POLYNOM7 (7)", codesys="Poly7", sew="POLYNOM_7"),
    claims=Claims(
        order_ends=3,
        order_inside=math.inf,
        coefficients=formulas(
            "cv = 35/16; ca_max = 84/(5*sqrt(5)); ca_min = -ca_max; ca_rms = sqrt(280/11); cj = 105/2; "
            "va_max = 58800/1024*(10/11)**5/sqrt(11); va_min = -va_max"
        ),
    ),
    example=Polynomial4567,
    others=(Polynomial4567(0.3),),
)
