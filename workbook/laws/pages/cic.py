"""Cycloidal."""

from math import pi

from workbook.laws.page import LawPage, PieceRow

PAGE = LawPage(
    code="CIC",
    title="Cycloidal",
    source="S2, movement equation; S3",
    pieces=(PieceRow("one full sine", "s = ξ − sin(2πξ)/2π", "=1", P="=CIC_ca_max", omega="=2*PI()"),),
    values=lambda law: [(1, 0, 0, law.coefficients.ca_max, 2 * pi, 0)],
    parameters=lambda law: [],
    coefficients={
        "cv": ("=1-COS(PI())", "v = 1 − cos 2πξ at ξ = ½"),
        "ca_max": ("=2*PI()", "a = 2π sin 2πξ at ξ = ¼"),
        "ca_min": ("=-CIC_ca_max", "at ξ = ¾"),
        "ca_rms": ("=CIC_ca_max/SQRT(2)", "of a sine"),
        "cj": ("=CIC_ca_max*2*PI()", "j = 4π² cos 2πξ at the ends"),
        "va_max": ("=CIC_ca_max*(1-COS(2*PI()/3))*SIN(2*PI()/3)", "2π (1 − cos x) sin x at x = 2π/3"),
        "va_min": ("=-CIC_va_max", "by symmetry"),
    },
)
