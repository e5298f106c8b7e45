"""Cubic."""

from engine.laws.cubic import Cubic
from workbook.laws.family import Page, PieceRow, ShapeFormulas

PAGE = Page(
    title="Cubic",
    source="S1, S3: the cubic that starts and ends at rest",
    made=lambda entered: Cubic(),
    pieces=(PieceRow("one cubic", "s = 3ξ² − 2ξ³", "=1", c0="=@ca_max", c1="=@ca_min-@ca_max"),),
    coefficients={
        "cv": ("=6*(1/2)*(1-1/2)", "v = 6ξ(1 − ξ) at ξ = ½"),
        "ca_max": ("=6*(1-2*0)", "a = 6(1 − 2ξ) at ξ = 0"),
        "ca_min": ("=6*(1-2*1)", "a = 6(1 − 2ξ) at ξ = 1"),
        "ca_rms": ("=@ca_max/SQRT(3)", "of a straight line through 0"),
        "cj": ('="∞"', "the acceleration jumps at the ends"),
        "va_max": ("=2*SQRT(3)", "36ξ(1 − ξ)(1 − 2ξ) at ξ = (3 − √3)/6"),
        "va_min": ("=-@va_max", "by symmetry"),
    },
    fastest="=1/2",
    shapes=ShapeFormulas(ramp_up="=1/2", ramp_down="=1/2"),
)
