"""Constant acceleration, symmetric."""

from engine.laws.constant_acceleration import ConstantAcceleration
from workbook.book.declare import constant
from workbook.laws.family import Page, PieceRow, ShapeFormulas

PAGE = Page(
    title="Constant acceleration, symmetric",
    source="S3, figure 1",
    made=lambda entered: ConstantAcceleration(),
    constants=(
        constant("@half", "Share of the rise that accelerates", "ξ_1", "", 0.5, source="symmetric: S3, figure 1"),
    ),
    pieces=(
        PieceRow("acceleration", "s = ½ C_a ξ²", "=@half", c0="=@ca_max"),
        PieceRow("deceleration", "s = 1 − ½ C_a (1 − ξ)²", "=1-@half", c0="=@ca_min"),
    ),
    coefficients={
        "cv": ("=1/@half", "from ∫v dξ = 1: triangle of height C_v"),
        "ca_max": ("=@cv/@half", "C_v / ξ_1"),
        "ca_min": ("=-@cv/(1-@half)", "−C_v / (1 − ξ_1)"),
        "ca_rms": ("=SQRT(@half*@ca_max^2+(1-@half)*@ca_min^2)", "√∫a² dξ"),
        "cj": ('="∞"', "the acceleration jumps"),
        "va_max": ("=@cv*@ca_max", "at ξ_1"),
        "va_min": ("=@cv*@ca_min", "at ξ_1"),
    },
    fastest="=1/2",
    shapes=ShapeFormulas(flat_up="=[@pieces.d.1]", flat_down="=[@pieces.d.2]"),
)
