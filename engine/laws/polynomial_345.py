"""Polynomial 3-4-5 (PO5)."""

import math
from dataclasses import dataclass

from engine.laws.ended_polynomial import EndedQuintic, HalvedPolynomial
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import HALF_345


@dataclass(frozen=True)
class Polynomial345(HalvedPolynomial):
    """s = 10ξ³ − 15ξ⁴ + 6ξ⁵; v = 30ξ²(1 − ξ)²; a = 60ξ − 180ξ² + 120ξ³.

    Source: LCamHdl, ProfileTypes, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'.
    """

    code = "PO5"
    name = "Polynomial 3-4-5"
    TAKES = "va"
    HALF = HALF_345
    ENDED = EndedQuintic


ENTRY = Entry(
    law=Polynomial345,
    aliases=("3-4-5", "quintic", "polynomial of degree 5", "Polynom 5. Grades"),
    source="LCamHdl, ProfileTypes, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'",
    vendors=Vendors(siemens="POLY_5 (5)", twincat="POLYNOM5 (5)", codesys="Poly5", sew="POLYNOM_5"),
    claims=Claims(
        order_ends=2,
        order_inside=math.inf,
        coefficients=formulas(
            "cv = 15/8; ca_max = 10/sqrt(3); ca_min = -ca_max; ca_rms = sqrt(120/7); cj = 60; "
            "va_max = 6075/(343*sqrt(7)); va_min = -va_max"
        ),
    ),
    example=Polynomial345,
    others=(Polynomial345(0.3),),
)
