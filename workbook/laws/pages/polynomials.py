"""Pages of the polynomials."""

from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from workbook.laws.edged import LINE_IN, Stage, edged
from workbook.laws.family import Page, PieceRow
from workbook.laws.shared import POLYNOMIAL, SHARED

CUBIC = edged(
    {3: Stage(LINE_IN, "=@share"), 5: Stage(LINE_IN, "=1-@share")},
    source="S1, S3: the cubic that starts and ends at rest; with λ: LCamHdl, POLY_3",
    **SHARED,
    law=Cubic,
    way=POLYNOMIAL.format(3),
)

POLYNOMIAL_345 = Page(
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

POLYNOMIAL_4567 = Page(
    source="LCamHdl, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'",
    **SHARED,
    law=Polynomial4567,
    pieces=(
        PieceRow("a rises", "s = 2λ S(ξ/2λ), S = 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷", "=@share*(1-1/SQRT(5))",
                 c2="=105/(2*@share^3)", c3="=0-105/@share^4", c4="=525/(8*@share^5)", c5="=0-105/(8*@share^6)"),
        PieceRow("a falls", "the same from its peak, x = (5 − √5)/10", "=@share/SQRT(5)",
                 c0="=42/(5*SQRT(5)*@share)", c2="=0-21*SQRT(5)/(2*@share^3)", c4="=105*SQRT(5)/(8*@share^5)",
                 c5="=0-105/(8*@share^6)"),
        PieceRow("−a rises", "s = 1 − 2μ S((1 − ξ)/2μ), μ = 1 − λ", "=(1-@share)/SQRT(5)",
                 c1="=0-105/(8*(1-@share)^2)", c3="=105/(4*(1-@share)^4)", c5="=0-105/(8*(1-@share)^6)"),
        PieceRow("−a falls", "the same from its peak", "=(1-@share)*(1-1/SQRT(5))",
                 c0="=0-42/(5*SQRT(5)*(1-@share))", c2="=21*SQRT(5)/(2*(1-@share)^3)",
                 c4="=0-105*SQRT(5)/(8*(1-@share)^5)", c5="=0-105/(8*(1-@share)^6)"),
    ),
    coefficients={
        "cv": ("=35/16", "S' = 140x³(1 − x)³ at x = ½"),
        "ca_max": ("=42/(5*SQRT(5)*@share)", "S''/2λ at x = (5 − √5)/10"),
        "ca_min": ("=0-42/(5*SQRT(5)*(1-@share))", "by symmetry, over 2μ"),
        "ca_rms": ("=SQRT(70/(11*@share*(1-@share)))", "√(70/11λμ)"),
        "cj": ("=105/(8*MIN(@share,1-@share)^2)", "S'''/4λ² or /4μ² in the middle"),
        "va_max": ("=58800/2048*(10/11)^5/(SQRT(11)*@share)", "S'S''/2λ at x = (11 − √11)/22"),
        "va_min": ("=0-58800/2048*(10/11)^5/(SQRT(11)*(1-@share))", "by symmetry, over 2μ"),
    },
    fastest="=@share",
    way=POLYNOMIAL.format(7),
)  # fmt: skip

PAGES = (CUBIC, POLYNOMIAL_345, POLYNOMIAL_4567)
