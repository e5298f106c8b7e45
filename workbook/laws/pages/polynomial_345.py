"""Polynomial 3-4-5."""

from engine.laws.polynomial_345 import Polynomial345
from workbook.laws.family import Page, PieceRow
from workbook.laws.shared import POLYNOMIAL, SHARED

PAGE = Page(
    source="LCamHdl, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'",
    **SHARED,
    law=Polynomial345,
    pieces=(
        PieceRow("a rises", "s = 2λ S(ξ/2λ), S = 10x³ − 15x⁴ + 6x⁵", "=@share*(1-1/SQRT(3))",
                 c1="=15/@share^2", c2="=0-45/(2*@share^3)", c3="=15/(2*@share^4)"),
        PieceRow("a falls", "the same from its peak, x = (3 − √3)/6", "=@share/SQRT(3)",
                 c0="=5/(SQRT(3)*@share)", c2="=0-15*SQRT(3)/(2*@share^3)", c3="=15/(2*@share^4)"),
        PieceRow("−a rises", "s = 1 − 2μ S((1 − ξ)/2μ), μ = 1 − λ", "=(1-@share)/SQRT(3)",
                 c1="=0-15/(2*(1-@share)^2)", c3="=15/(2*(1-@share)^4)"),
        PieceRow("−a falls", "the same from its peak", "=(1-@share)*(1-1/SQRT(3))",
                 c0="=0-5/(SQRT(3)*(1-@share))", c2="=15*SQRT(3)/(2*(1-@share)^3)", c3="=15/(2*(1-@share)^4)"),
    ),
    coefficients={
        "cv": ("=15/8", "S' = 30x²(1 − x)² at x = ½"),
        "ca_max": ("=5/(SQRT(3)*@share)", "S''/2λ at x = (3 − √3)/6"),
        "ca_min": ("=0-5/(SQRT(3)*(1-@share))", "by symmetry, over 2μ"),
        "ca_rms": ("=SQRT(30/(7*@share*(1-@share)))", "√(30/7λμ)"),
        "cj": ("=15/MIN(@share,1-@share)^2", "S'''/4λ² or /4μ² at an end"),
        "va_max": ("=6075/(686*SQRT(7)*@share)", "S'S''/2λ at x = (7 − √7)/14"),
        "va_min": ("=0-6075/(686*SQRT(7)*(1-@share))", "by symmetry, over 2μ"),
    },
    fastest="=@share",
    way=POLYNOMIAL.format(5),
)  # fmt: skip
