"""Sine, straight line, sine: from reversal to reversal."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from engine.laws.sine_straight_sine import SineStraightSine
from workbook.entries.types import DesignError
from workbook.laws.brief import BRIEF, too_brief
from workbook.laws.edged import SINE_IN, Stage, Stages, edged, law_of
from workbook.laws.family import Parameter
from workbook.laws.shared import EVEN, LEAST, SHARE, Shared


class Curved(Shared):
    """The share of the time that is curved, and the part of that which accelerates."""

    curved: Annotated[float, Field(ge=LEAST, le=1, allow_inf_nan=False)] = SineStraightSine.curved

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a stage that is next to none."""
        fits = self.model_dump() | {"curved": SineStraightSine.curved, "share": EVEN}
        law = SineStraightSine(curved=self.curved, share=self.share)
        yield from too_brief([piece.duration for piece in law.as_pieces()], "", fits)


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
    checks=(BRIEF,),
    variations=({"share": 0.4, "curved": 0.3}, {"share": 0.7, "curved": 1.0}, {"share": 0.55, "curved": 0.8}),
)  # fmt: skip
