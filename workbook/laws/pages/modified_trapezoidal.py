"""Modified trapezoidal acceleration with seven durations."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from engine.laws.modified_trapezoidal import CLASSIC, ModifiedTrapezoidal
from engine.laws.pulse import K, Quarter
from workbook.book.declare import Quantity, calc
from workbook.book.sentence import figure
from workbook.entries.types import SUM_TOLERANCE, DesignError, Share
from workbook.laws.family import LawCheck, LawSheet, Page, Parameter, PieceRow, ShapeFormulas


class SevenDurations(LawSheet):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = Field(default=list(CLASSIC))

    def design_faults(self) -> Iterator[DesignError]:
        """Yield durations that do not fill the rise, and a law that cannot start or stop."""
        total = sum(self.durations)
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("durations", f"they sum to {figure(total)}; expected 1", "sum", list(CLASSIC))
        if not (sum(self.durations[:3]) and sum(self.durations[4:])):
            yield DesignError("durations", "stages 1 to 3, or 5 to 7, are all 0", "lasts", list(CLASSIC))


KINDS = ("sine", "constant", "sine", "uniform velocity", "sine", "constant", "sine")
SUM_IS_1 = "shares of the rise that sum to 1; zeros are allowed"
STROKE = "k(1−k)d1² + k d1 d2 + d2²/2 + (k d1 + d2)d3 + k²d3²"


def _workings(law: ModifiedTrapezoidal) -> list[Quantity]:
    (rise, fall), (drive, brake) = law.lobes, law.quarters
    return [
        calc("@k", "Mean of a quarter sine", "k", "", "=2/PI()", K, source="2/π"),
        calc("@m", "Velocity gained for A = 1", "m", "",
             "=@k*@d1+@d2+@k*@d3", rise.velocity, source="k d1 + d2 + k d3"),
        calc("@n", "Velocity lost for B = 1", "n", "",
             "=@k*@d5+@d6+@k*@d7", fall.velocity, source="k d5 + d6 + k d7"),
        calc("@sa", "Stroke of stages 1 to 3 for A = 1", "S_a", "",
             "=@k*(1-@k)*@d1^2+@k*@d1*@d2+@d2^2/2+(@k*@d1+@d2)*@d3+(@k*@d3)^2", rise.travel, source=STROKE),
        calc("@sd", "Stroke of stages 5 to 7 for B = 1", "S_d", "",
             "=@k*(1-@k)*@d7^2+@k*@d7*@d6+@d6^2/2+(@k*@d7+@d6)*@d5+(@k*@d5)^2", fall.travel,
             source="the same from the end: d7, d6, d5"),
        *_power("@drive", "driving", ("=@ca_max*(@k*@d1+@d2)", "=@ca_max*@k*@d3"), drive),
        *_power("@brake", "braking", ("=-@ca_min*(@k*@d7+@d6)", "=-@ca_min*@k*@d5"), brake),
    ]  # fmt: skip


def _power(name: str, side: str, formulas: tuple[str, str], quarter: Quarter) -> list[Quantity]:
    """Return the rows that find the greatest v·a, which falls on the quarter sine next to the uniform velocity."""
    return [
        calc(f"{name}_v", f"Velocity at the quarter sine, {side}", "v₂", "",
             formulas[0], quarter.velocity, source="A(k d1 + d2), or the same from the end"),
        calc(f"{name}_g", f"Velocity gained on it, {side}", "G", "",
             formulas[1], quarter.gain, source="A k d3; velocity v₂ + G sin x, acceleration A cos x"),
        calc(f"{name}_sin", f"Where v·a is greatest, {side}", "sin x", "",
             f"=2*{name}_g/({name}_v+SQRT({name}_v^2+8*{name}_g^2))", quarter.sin, source="2G sin²x + v₂ sin x = G"),
    ]  # fmt: skip


def _omega(k: int) -> str:
    return f"=IF(@d{k}>0,PI()/(2*@d{k}),0)"


PAGE = Page(
    title="Modified trapezoidal acceleration",
    source="S1, seven parameters; S3, figure 2",
    entries=SevenDurations,
    made=lambda entered: ModifiedTrapezoidal(entered.durations),
    parameters=tuple(
        Parameter(f"@d{k}", f"Duration of stage {k}: {kind}", f"d{k}", f"durations.{i}", f"stage {k}",
                  source=SUM_IS_1 if k == 1 else "")
        for i, (k, kind) in enumerate(zip(range(1, 8), KINDS, strict=True))
    ),
    variations=(
        {"durations": [0.1, 0.2, 0.15, 0.05, 0.12, 0.25, 0.13]},
        {"durations": [0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0]},
        {"durations": [0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2]},
        {"durations": [0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0]},
        {"durations": [0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1]},
        {"durations": [0.15, 0.1, 0.0, 0.2, 0.0, 0.3, 0.25]},
    ),
    checks=(
        LawCheck("@sum", "the seven durations sum to 1", "ABS(SUM([@pieces.d])-1)<check_zero", "sum",
                 '"they sum to "&ROUND(SUM([@pieces.d]),9)&"; expected 1"'),
        LawCheck("@lasts", "the law starts and stops", "MIN(@d1+@d2+@d3,@d5+@d6+@d7)>0", "lasts",
                 '"stages 1 to 3, or 5 to 7, are all 0"'),
    ),
    pieces=(
        PieceRow("1 · sine rising", "a = A sin(πu / 2d1)", "=@d1", P="=@ca_max", omega=_omega(1)),
        PieceRow("2 · constant", "a = A", "=@d2", c0="=@ca_max"),
        PieceRow("3 · sine falling", "a = A cos(πu / 2d3)", "=@d3", P="=@ca_max", omega=_omega(3), phi="=PI()/2"),
        PieceRow("4 · uniform velocity", "a = 0", "=@d4"),
        PieceRow("5 · sine falling", "a = −B sin(πu / 2d5)", "=@d5", P="=@ca_min", omega=_omega(5)),
        PieceRow("6 · constant", "a = −B", "=@d6", c0="=@ca_min"),
        PieceRow("7 · sine rising", "a = −B cos(πu / 2d7)", "=@d7", P="=@ca_min", omega=_omega(7), phi="=PI()/2"),
    ),
    workings=_workings,
    coefficients={
        "cv": ("=@ca_max*@m", "A m"),
        "ca_max": ("=1/(@sa+@m*@d4+@m*@sd/@n)", "A: from s(1) = 1 with A m = B n"),
        "ca_min": ("=-@ca_max*@m/@n", "−B = −A m/n"),
        "ca_rms": ("=SQRT(@ca_max^2*(@d1/2+@d2+@d3/2)+@ca_min^2*(@d5/2+@d6+@d7/2))",
                   "√(A²(d1/2 + d2 + d3/2) + B²(d5/2 + d6 + d7/2))"),
        "cj": ("=IF(MIN(@d1,@d3,@d5,@d7)>0,PI()/2*MAX(@ca_max/MIN(@d1,@d3),-@ca_min/MIN(@d5,@d7)),\"∞\")",
               "π/2 · greatest of A/d1, A/d3, B/d5, B/d7; ∞ with a zero sine stage"),
        "va_max": ("=@ca_max*SQRT(1-@drive_sin^2)*(@drive_v+@drive_g*@drive_sin)", "A cos x (v₂ + G sin x)"),
        "va_min": ("=@ca_min*SQRT(1-@brake_sin^2)*(@brake_v+@brake_g*@brake_sin)", "−B cos x (v₂ + G sin x)"),
    },
    fastest="=@d1+@d2+@d3",
    shapes=ShapeFormulas(flat_up="=@d2", flat_down="=@d6", sine_up="=@d1+@d3", sine_down="=@d5+@d7"),
)  # fmt: skip
