"""Trapezoidal velocity with ramps of a squared sine."""

from typing import Annotated

from pydantic import Field

from engine.laws.sine_ramps import SineRamps
from workbook.laws.edged import HALF_SINE, Stage, edged
from workbook.laws.pages.trapezoidal_velocity import ORDER, BreakPoints
from workbook.laws.pages.trapezoidal_velocity import PAGE as TRAPEZOID


class SmoothRamps(BreakPoints):
    """Where the first ramp ends and the second begins, as shares of the rise."""

    rise_end: Annotated[float, Field(gt=0, le=1)] = SineRamps.rise_end
    fall_start: Annotated[float, Field(ge=0, lt=1)] = SineRamps.fall_start


PAGE = edged(
    {
        2: Stage(HALF_SINE, "=@av"),
        4: Stage(None, "=@aw-@av"),
        6: Stage(HALF_SINE, "=1-@aw"),
    },
    source="CODESYS, SML_RampType, Sin2; mechdesigner.support, 'Cycloidal CV'",
    entries=SmoothRamps,
    law=SineRamps,
    parameters=TRAPEZOID.parameters,
    variations=TRAPEZOID.variations,
    checks=(ORDER,),
)
