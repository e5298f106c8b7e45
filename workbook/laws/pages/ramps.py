"""Pages of laws whose velocity rises on a ramp, stays, and falls on a ramp."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from workbook.book.cell_tables import cell_tables
from workbook.book.sentence import figure
from workbook.fields.types import DesignError
from workbook.laws import family, seven_stages
from workbook.laws.edged import edged, stages_in
from workbook.laws.family import LawSheet, Page, checks_in, coefficients_in, parameters_in, pieces_in, variations_in

CELLS = cell_tables(__file__)

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
            problem = f"brakes from {figure(self.fall_start)}, before {figure(self.rise_end)}"
            yield DesignError("", problem, fits)
        stages = (self.rise_end, self.fall_start - self.rise_end, 1 - self.fall_start)
        yield from family.too_brief(stages, "", fits)


BREAKS, CHECKS = parameters_in(CELLS["break points"]), (*checks_in(CELLS["order"]), family.BRIEF)

TRAPEZOIDAL_VELOCITY = Page(
    source="S1, second and third slide of the asymmetric trapezoidal profile; S3, function TVP",
    entries=BreakPoints,
    law=TrapezoidalVelocity,
    parameters=BREAKS,
    variations=variations_in(__file__, "break points: variations"),
    checks=CHECKS,
    pieces=pieces_in(CELLS["trapezoidal velocity: pieces"]),
    coefficients=coefficients_in(CELLS["trapezoidal velocity: coefficients"]),
    fastest="=@av",
    end_mode="=1",
    early=1,
)

SINE_RAMPS = edged(
    stages_in(__file__, "sine ramps: stages"),
    source="CODESYS, SML_RampType, Sin2; mechdesigner.support, 'Cycloidal CV'",
    law=SineRamps,
    entries=family.parameters_of(SineRamps, BreakPoints, rise_end=RiseEnd, fall_start=FallStart),
    parameters=BREAKS,
    variations=TRAPEZOIDAL_VELOCITY.variations,
    checks=CHECKS,
)

S_CURVE = edged(
    stages_in(__file__, "S-curve: stages"),
    source="TwinCAT NC, set-point generator with seven phases",
    law=SCurve,
    parameters=seven_stages.DURATIONS,
    entries=family.parameters_of(SCurve, seven_stages.SevenDurations, durations=seven_stages.Seven),
    variations=variations_in(__file__, "S-curve: variations"),
    checks=seven_stages.LASTING,
)
