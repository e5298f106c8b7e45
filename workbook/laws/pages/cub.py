"""Cubic."""

from workbook.laws.page import LawPage, PieceRow

PAGE = LawPage(
    code="CUB",
    title="Cubic",
    source="S1, S3: the cubic that starts and ends at rest",
    pieces=(PieceRow("one cubic", "s = 3ξ² − 2ξ³", "=1", c0="=CUB_ca_max", c1="=CUB_ca_min-CUB_ca_max"),),
    values=lambda law: [(1, law.coefficients.ca_max, law.coefficients.ca_min - law.coefficients.ca_max, 0, 0, 0)],
    parameters=lambda law: [],
    coefficients={
        "cv": ("=6*(1/2)*(1-1/2)", "v = 6ξ(1 − ξ) at ξ = ½"),
        "ca_max": ("=6*(1-2*0)", "a = 6(1 − 2ξ) at ξ = 0"),
        "ca_min": ("=6*(1-2*1)", "a = 6(1 − 2ξ) at ξ = 1"),
        "ca_rms": ("=CUB_ca_max/SQRT(3)", "of a straight line through 0"),
        "cj": ('="∞"', "the acceleration jumps at the ends"),
        "va_max": ("=2*SQRT(3)", "36ξ(1 − ξ)(1 − 2ξ) at ξ = (3 − √3)/6"),
        "va_min": ("=-CUB_va_max", "by symmetry"),
    },
)
