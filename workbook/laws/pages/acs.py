"""Constant acceleration, symmetric."""

from engine.laws import Law
from workbook.book.declare import Quantity, constant
from workbook.laws.page import LawPage, PieceRow


def _parameters(law: Law) -> list[Quantity]:
    return [
        constant("ACS_half", "Share of the rise that accelerates", "ξ_1", "", 0.5, source="symmetric: S3, figure 1"),
    ]


PAGE = LawPage(
    code="ACS",
    title="Constant acceleration, symmetric",
    source="S3, figure 1",
    pieces=(
        PieceRow("acceleration", "s = ½ C_a ξ²", "=ACS_half", c0="=ACS_ca_max"),
        PieceRow("deceleration", "s = 1 − ½ C_a (1 − ξ)²", "=1-ACS_half", c0="=ACS_ca_min"),
    ),
    values=lambda law: [
        (0.5, law.coefficients.ca_max, 0, 0, 0, 0),
        (0.5, law.coefficients.ca_min, 0, 0, 0, 0),
    ],
    parameters=_parameters,
    coefficients={
        "cv": ("=1/ACS_half", "from ∫v dξ = 1: triangle of height C_v"),
        "ca_max": ("=ACS_cv/ACS_half", "C_v / ξ_1"),
        "ca_min": ("=-ACS_cv/(1-ACS_half)", "−C_v / (1 − ξ_1)"),
        "ca_rms": ("=SQRT(ACS_half*ACS_ca_max^2+(1-ACS_half)*ACS_ca_min^2)", "√∫a² dξ"),
        "cj": ('="∞"', "the acceleration jumps"),
        "va_max": ("=ACS_cv*ACS_ca_max", "at ξ_1"),
        "va_min": ("=ACS_cv*ACS_ca_min", "at ξ_1"),
    },
)
