"""Sine, straight line, sine: from reversal to reversal."""

from typing import Annotated

from pydantic import Field

from engine.laws.sine_straight_sine import SineStraightSine
from workbook.laws.edged import SINE_IN, Stage, Stages, edged, law_of
from workbook.laws.family import Parameter
from workbook.laws.shared import SHARE, Shared


class Curved(Shared):
    """The share of the time that is curved, and the part of that which accelerates."""

    curved: Annotated[float, Field(gt=0, le=1, allow_inf_nan=False)] = SineStraightSine.curved


STAGES = Stages({
    3: Stage(SINE_IN, "=@curved*@share"),
    4: Stage(None, "=1-@curved"),
    5: Stage(SINE_IN, "=@curved*(1-@share)"),
})  # fmt: skip

PAGE = edged(
    STAGES,
    title="Sine-straight-sine",
    source="LCamHdl, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286",
    entries=Curved,
    made=law_of(SineStraightSine, "curved", "share"),
    parameters=(
        SHARE,
        Parameter("@curved", "Share of the time that is curved", "c", "curved", "share of the sines",
                  source="1: simple harmonic"),
    ),
    variations=({"share": 0.4, "curved": 0.3}, {"share": 0.7, "curved": 1.0}, {"share": 0.55, "curved": 0.8}),
)  # fmt: skip
