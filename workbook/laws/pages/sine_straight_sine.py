"""Sine, straight line, sine: from reversal to reversal."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from engine.laws.sine_straight_sine import SineStraightSine
from workbook.entries.types import DesignError
from workbook.laws.edged import SINE_IN, Stage, edged
from workbook.laws.family import Parameter
from workbook.laws.shared import BRIEF, EVEN, LEAST, SHARE, Shared, too_brief


class Curved(Shared):
    """The share of the time that is curved, and the part of that which accelerates."""

    curved: Annotated[float, Field(ge=LEAST, le=1, allow_inf_nan=False)] = SineStraightSine.curved

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a stage that is next to none."""
        fits = self.model_dump() | {"curved": SineStraightSine.curved, "share": EVEN}
        law = SineStraightSine(curved=self.curved, share=self.share)
        yield from too_brief([piece.duration for piece in law.as_pieces()], "", fits)


PAGE = edged(
    {
        3: Stage(SINE_IN, "=@curved*@share"),
        4: Stage(None, "=1-@curved"),
        5: Stage(SINE_IN, "=@curved*(1-@share)"),
    },
    source="LCamHdl, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286",
    entries=Curved,
    law=SineStraightSine,
    parameters=(
        SHARE,
        Parameter("@curved", "Share of the time that is curved", "c", "curved", "share of the sines",
                  source="1: simple harmonic"),
    ),
    checks=(BRIEF,),
    variations=({"share": 0.4, "curved": 0.3}, {"share": 0.7, "curved": 1.0}, {"share": 0.55, "curved": 0.8}),
)  # fmt: skip
