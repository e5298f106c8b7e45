"""Cycloidal."""

from engine.laws.cycloidal import Cycloidal
from workbook.laws.family import Page, PieceRow, ShapeFormulas

PAGE = Page(
    title="Cycloidal",
    source="S2, movement equation; S3",
    made=lambda entered: Cycloidal(),
    pieces=(PieceRow("one full sine", "s = ξ − sin(2πξ)/2π", "=1", P="=@ca_max", omega="=2*PI()"),),
    coefficients={
        "cv": ("=1-COS(PI())", "v = 1 − cos 2πξ at ξ = ½"),
        "ca_max": ("=2*PI()", "a = 2π sin 2πξ at ξ = ¼"),
        "ca_min": ("=-@ca_max", "at ξ = ¾"),
        "ca_rms": ("=@ca_max/SQRT(2)", "of a sine"),
        "cj": ("=@ca_max*2*PI()", "j = 4π² cos 2πξ at the ends"),
        "va_max": ("=@ca_max*(1-COS(2*PI()/3))*SIN(2*PI()/3)", "2π (1 − cos x) sin x at x = 2π/3"),
        "va_min": ("=-@va_max", "by symmetry"),
    },
    fastest="=1/2",
    shapes=ShapeFormulas(sine_up="=1/2", sine_down="=1/2"),
)
