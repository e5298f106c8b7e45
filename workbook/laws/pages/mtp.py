"""Modified trapezoidal acceleration with seven durations."""

from math import pi, sqrt
from typing import cast

from engine.laws import Law, ModifiedTrapezoidal
from workbook.book.declare import Quantity, calc, check, given
from workbook.laws.page import LawPage, PieceRow

LOBE = "={k}*(1-{k})*{0}^2+{k}*{0}*{1}+{1}^2/2+({k}*{0}+{1})*{2}+({k}*{2})^2"
SINE = "=2*{0}_g/({0}_v+SQRT({0}_v^2+8*{0}_g^2))"
POWER = "{0}*SQRT(1-{1}_sin^2)*({1}_v+{1}_g*{1}_sin)"


def _parameters(law: Law) -> list[Quantity]:
    durations = cast(ModifiedTrapezoidal, law).durations
    kinds = ("sine", "constant", "sine", "uniform velocity", "sine", "constant", "sine")
    return [
        given(f"MTP_d{k + 1}", f"Duration of stage {k + 1}: {kind}", f"d{k + 1}", "", durations[k], f"laws.MTP.durations.{k}", format="0.0000",
              source="shares of the rise that sum to 1; zeros are allowed" if k == 0 else "")
        for k, kind in enumerate(kinds)
    ]  # fmt: skip


def _workings(law: Law) -> list[Quantity]:
    mtp, k = cast(ModifiedTrapezoidal, law), law.coefficients
    ends = [sum(mtp.durations[: i + 1]) for i in range(7)]
    a, b = k.ca_max, -k.ca_min
    speed = [float(law.v(min(x, 1.0))) for x in ends]
    return [
        calc("MTP_k", "Mean of a quarter sine", "k", "", "=2/PI()", 2 / pi, source="2/π"),
        calc("MTP_m", "Velocity gained for A = 1", "m", "",
             "=MTP_k*MTP_d1+MTP_d2+MTP_k*MTP_d3", k.cv / a, source="k d1 + d2 + k d3"),
        calc("MTP_n", "Velocity lost for B = 1", "n", "",
             "=MTP_k*MTP_d5+MTP_d6+MTP_k*MTP_d7", k.cv / b, source="k d5 + d6 + k d7"),
        calc("MTP_sa", "Stroke of stages 1 to 3 for A = 1", "S_a", "",
             LOBE.format("MTP_d1", "MTP_d2", "MTP_d3", k="MTP_k"), law.s(min(ends[2], 1.0)) / a,
             source="k(1−k)d1² + k d1 d2 + d2²/2 + (k d1 + d2)d3 + k²d3²"),
        calc("MTP_sd", "Stroke of stages 5 to 7 for B = 1", "S_d", "",
             LOBE.format("MTP_d7", "MTP_d6", "MTP_d5", k="MTP_k"), (1 - law.s(min(ends[3], 1.0))) / b,
             source="the same from the end: d7, d6, d5"),
        *_power("MTP_drive", "driving", "MTP_ca_max", ("MTP_d1", "MTP_d2", "MTP_d3"), speed[1], k.cv - speed[1]),
        *_power("MTP_brake", "braking", "-MTP_ca_min", ("MTP_d7", "MTP_d6", "MTP_d5"), speed[4], k.cv - speed[4]),
    ]  # fmt: skip


def _power(name: str, side: str, amplitude: str, stages: tuple[str, str, str], v: float, g: float) -> list[Quantity]:
    """Return the rows that find the greatest v·a, which falls on the quarter sine next to the uniform velocity."""
    first, plain, quarter = stages
    return [
        calc(f"{name}_v", f"Velocity at the quarter sine, {side}", "v₂", "",
             f"={amplitude}*(MTP_k*{first}+{plain})", v, source="A(k d1 + d2), or the same from the end"),
        calc(f"{name}_g", f"Velocity gained on it, {side}", "G", "",
             f"={amplitude}*MTP_k*{quarter}", g, source="A k d3; velocity v₂ + G sin x, acceleration A cos x"),
        calc(f"{name}_sin", f"Where v·a is greatest, {side}", "sin x", "",
             SINE.format(name), 2 * g / (v + sqrt(v * v + 8 * g * g)), source="2G sin²x + v₂ sin x = G"),
    ]  # fmt: skip


def _values(law: Law) -> list[tuple[float, ...]]:
    durations, k = cast(ModifiedTrapezoidal, law).durations, law.coefficients
    a, b = k.ca_max, -k.ca_min
    w = [pi / (2 * x) if x > 0 else 0.0 for x in durations]
    kinds = ((0, a, 0), (a, 0, 0), (0, a, pi / 2), (0, 0, 0), (0, -b, 0), (-b, 0, 0), (0, -b, pi / 2))
    return [
        (x, c0, 0, p, w[i] if i % 2 == 0 else 0, phi)
        for i, (x, (c0, p, phi)) in enumerate(zip(durations, kinds, strict=True))
    ]


def _omega(k: int) -> str:
    return f"=IF(MTP_d{k}>0,PI()/(2*MTP_d{k}),0)"


PAGE = LawPage(
    code="MTP",
    title="Modified trapezoidal acceleration",
    source="S1, seven parameters; S3, figure 2",
    pieces=(
        PieceRow("1 · sine rising", "a = A sin(πu / 2d1)", "=MTP_d1", P="=MTP_ca_max", omega=_omega(1)),
        PieceRow("2 · constant", "a = A", "=MTP_d2", c0="=MTP_ca_max"),
        PieceRow(
            "3 · sine falling",
            "a = A cos(πu / 2d3)",
            "=MTP_d3",
            P="=MTP_ca_max",
            omega=_omega(3),
            phi="=PI()/2",
        ),
        PieceRow("4 · uniform velocity", "a = 0", "=MTP_d4"),
        PieceRow("5 · sine falling", "a = −B sin(πu / 2d5)", "=MTP_d5", P="=MTP_ca_min", omega=_omega(5)),
        PieceRow("6 · constant", "a = −B", "=MTP_d6", c0="=MTP_ca_min"),
        PieceRow(
            "7 · sine rising",
            "a = −B cos(πu / 2d7)",
            "=MTP_d7",
            P="=MTP_ca_min",
            omega=_omega(7),
            phi="=PI()/2",
        ),
    ),
    values=_values,
    parameters=_parameters,
    workings=_workings,
    coefficients={
        "cv": ("=MTP_ca_max*MTP_m", "A m"),
        "ca_max": ("=1/(MTP_sa+MTP_m*MTP_d4+MTP_m*MTP_sd/MTP_n)", "A: from s(1) = 1 with A m = B n"),
        "ca_min": ("=-MTP_ca_max*MTP_m/MTP_n", "−B = −A m/n"),
        "ca_rms": (
            "=SQRT(MTP_ca_max^2*(MTP_d1/2+MTP_d2+MTP_d3/2)+MTP_ca_min^2*(MTP_d5/2+MTP_d6+MTP_d7/2))",
            "√(A²(d1/2 + d2 + d3/2) + B²(d5/2 + d6 + d7/2))",
        ),
        "cj": (
            "=IF(MIN(MTP_d1,MTP_d3,MTP_d5,MTP_d7)>0,PI()/2*MAX(MTP_ca_max/MIN(MTP_d1,MTP_d3),"
            '-MTP_ca_min/MIN(MTP_d5,MTP_d7)),"∞")',
            "π/2 · greatest of A/d1, A/d3, B/d5, B/d7; ∞ with a zero sine stage",
        ),
        "va_max": ("=" + POWER.format("MTP_ca_max", "MTP_drive"), "A cos x (v₂ + G sin x)"),
        "va_min": ("=" + POWER.format("MTP_ca_min", "MTP_brake"), "−B cos x (v₂ + G sin x)"),
    },
    checks=lambda law: [
        check("MTP_sum", "MTP: the seven durations sum to 1", "ABS(SUM([MTP_pieces.d])-1)<check_zero", True)
    ],
)
