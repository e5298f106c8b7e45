"""Trapezoidal velocity with two break points."""

from typing import cast

from engine.laws import Law, TrapezoidalVelocity
from workbook.book.declare import Quantity, check, given
from workbook.laws.page import LawPage, PieceRow


def _parameters(law: Law) -> list[Quantity]:
    tvp = cast(TrapezoidalVelocity, law)
    return [
        given("TVP_av", "End of the acceleration", "α_v", "",
              tvp.rise_end, "laws.TVP.rise_end", format="0.0000",
              source="S1, asymmetric trapezoidal profile, as a share of α_s"),
        given("TVP_aw", "Begin of the deceleration", "α_w", "",
              tvp.fall_start, "laws.TVP.fall_start", format="0.0000", source="as a share of α_s; not before α_v"),
    ]  # fmt: skip


def _values(law: Law) -> list[tuple[float, ...]]:
    tvp, k = cast(TrapezoidalVelocity, law), law.coefficients
    first, second = tvp.rise_end, tvp.fall_start
    return [
        (first, k.ca_max, 0, 0, 0, 0),
        (second - first, 0, 0, 0, 0, 0),
        (1 - second, k.ca_min, 0, 0, 0, 0),
    ]


PAGE = LawPage(
    code="TVP",
    title="Trapezoidal velocity",
    source="S1, second and third slide of the asymmetric trapezoidal profile; S3, function TVP",
    pieces=(
        PieceRow("acceleration", "y'' = A, y' = Aα, y = ½Aα²", "=TVP_av", c0="=TVP_ca_max"),
        PieceRow("uniform velocity", "y'' = 0, y' = Aα_v, y = Aα_v(α − α_v/2)", "=TVP_aw-TVP_av"),
        PieceRow("deceleration", "y'' = −B, y' = Aα_v − B(α − α_w)", "=1-TVP_aw", c0="=TVP_ca_min"),
    ),
    values=_values,
    parameters=_parameters,
    coefficients={
        "cv": ("=TVP_ca_max*TVP_av", "A α_v"),
        "ca_max": ("=2/(TVP_av*(1-TVP_av+TVP_aw))", "A = 2h / (α_v (α_s − α_v + α_w))"),
        "ca_min": ("=-2/((1-TVP_aw)*(1-TVP_av+TVP_aw))", "−B = −2h / ((α_s − α_w)(α_s − α_v + α_w))"),
        "ca_rms": ("=SQRT(TVP_av*TVP_ca_max^2+(1-TVP_aw)*TVP_ca_min^2)", "√(α_v A² + (1 − α_w) B²)"),
        "cj": ('="∞"', "the acceleration jumps"),
        "va_max": ("=TVP_cv*TVP_ca_max", "at α_v"),
        "va_min": ("=TVP_cv*TVP_ca_min", "at α_w"),
    },
    checks=lambda law: [
        check(
            "TVP_order",
            "TVP: the break points follow each other",
            "AND(TVP_av>0,TVP_av<=TVP_aw,TVP_aw<1)",
            True,
        )
    ],
)
