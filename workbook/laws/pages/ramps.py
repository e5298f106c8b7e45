"""Pages of laws whose velocity rises on a ramp, stays, and falls on a ramp."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from workbook.book.sentence import figure
from workbook.fields.types import DesignError
from workbook.laws import family, seven_stages
from workbook.laws.edged import FLAT, HALF_SINE, LINE_IN, LINE_OUT, Stage, edged
from workbook.laws.family import LawCheck, LawSheet, Page, Parameter, PieceRow

RiseEnd = Annotated[float, Field(gt=0, le=1)]
FallStart = Annotated[float, Field(ge=0, lt=1)]


class BreakPoints(LawSheet):
    """Break points of the trapezoidal velocity profile as shares of the rise: S1's α_v/α_s and α_w/α_s."""

    rise_end: RiseEnd = TrapezoidalVelocity.rise_end
    fall_start: FallStart = TrapezoidalVelocity.fall_start

    def design_faults(self) -> Iterator[DesignError]:
        """Yield break points that do not follow each other."""
        fits = self.model_dump() | {name: getattr(TrapezoidalVelocity, name) for name in ("rise_end", "fall_start")}
        if self.fall_start < self.rise_end:
            said = f"brakes from {figure(self.fall_start)}, before {figure(self.rise_end)}"
            yield DesignError("", said, "order", fits)
        stages = (self.rise_end, self.fall_start - self.rise_end, 1 - self.fall_start)
        yield from family.too_brief(stages, "", fits)


BEFORE = '"brakes from "&ROUND(@aw,9)&", before "&ROUND(@av,9)'
ORDER = LawCheck("@order", "the break points follow each other", "@av<=@aw", "order", BEFORE)

TRAPEZOIDAL_VELOCITY = Page(
    source="S1, second and third slide of the asymmetric trapezoidal profile; S3, function TVP",
    entries=BreakPoints, law=TrapezoidalVelocity,
    parameters=(
        Parameter("@av", "End of the acceleration", "α_v", "rise_end", "end of acceleration",
                  source="S1, asymmetric trapezoidal profile, as a share of α_s"),
        Parameter("@aw", "Begin of the deceleration", "α_w", "fall_start", "start of deceleration",
                  source="as a share of α_s; not before α_v"),
    ),
    variations=tuple({"rise_end": (15 + 7 * k) / 100, "fall_start": (60 + 5 * k) / 100} for k in range(6)),
    checks=(ORDER, family.BRIEF),
    pieces=(
        PieceRow("acceleration", "y'' = A, y' = Aα, y = ½Aα²", "=@av", c0="=@ca_max"),
        PieceRow("uniform velocity", "y'' = 0, y' = Aα_v, y = Aα_v(α − α_v/2)", "=@aw-@av"),
        PieceRow("deceleration", "y'' = −B, y' = Aα_v − B(α − α_w)", "=1-@aw", c0="=@ca_min"),
    ),
    coefficients={
        "cv": ("=@ca_max*@av", "A α_v"),
        "ca_max": ("=2/(@av*(1-@av+@aw))", "A = 2h / (α_v (α_s − α_v + α_w))"),
        "ca_min": ("=-2/((1-@aw)*(1-@av+@aw))", "−B = −2h / ((α_s − α_w)(α_s − α_v + α_w))"),
        "ca_rms": ("=SQRT(@av*@ca_max^2+(1-@aw)*@ca_min^2)", "√(α_v A² + (1 − α_w) B²)"),
        "cj": ('="∞"', "the acceleration jumps"),
        "va_max": ("=@cv*@ca_max", "at α_v"),
        "va_min": ("=@cv*@ca_min", "at α_w"),
    },
    fastest="=@av", end_mode="=1", early=1,
)  # fmt: skip


SINE_RAMPS = edged(
    {2: Stage(HALF_SINE, "=@av"), 4: Stage(None, "=@aw-@av"), 6: Stage(HALF_SINE, "=1-@aw")},
    source="CODESYS, SML_RampType, Sin2; mechdesigner.support, 'Cycloidal CV'", law=SineRamps,
    entries=family.parameters_of(SineRamps, BreakPoints, rise_end=RiseEnd, fall_start=FallStart),
    parameters=TRAPEZOIDAL_VELOCITY.parameters, variations=TRAPEZOIDAL_VELOCITY.variations,
    checks=(ORDER, family.BRIEF),
)  # fmt: skip


S_CURVE = edged(
    dict(enumerate(map(Stage, (LINE_OUT, FLAT, LINE_IN, None, LINE_IN, FLAT, LINE_OUT)), 1)),
    source="TwinCAT NC, set-point generator with seven phases", law=SCurve, parameters=seven_stages.DURATIONS,
    entries=family.parameters_of(SCurve, seven_stages.SevenDurations, durations=seven_stages.Seven),
    variations=seven_stages.lasting(
        [0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2], [0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25],
        [0.0, 0.2, 0.2, 0.1, 0.3, 0.2, 0.0], [0.1, 0.15, 0.05, 0.3, 0.0, 0.2, 0.2],
    ),
    checks=seven_stages.LASTING,
)  # fmt: skip
