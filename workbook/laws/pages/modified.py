"""Pages of laws of pulses with edges of a sine."""

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from engine.laws import modified as engine
from workbook.book.cell_tables import cell_tables
from workbook.book.sentence import figure
from workbook.fields.types import SUM_TOLERANCE, DesignError, Share
from workbook.laws import family, seven_stages
from workbook.laws.edged import edged, stages_in
from workbook.laws.family import checks_in, parameters_in, variations_in

CELLS = cell_tables(__file__)

MODIFIED_TRAPEZOIDAL = edged(
    stages_in(__file__, "modified trapezoid: stages"),
    titled="Modified trapezoidal acceleration",
    source="S1, seven parameters; S3, figure 2",
    entries=seven_stages.SevenDurations,
    law=engine.ModifiedTrapezoidal,
    parameters=seven_stages.DURATIONS,
    variations=variations_in(__file__, "modified trapezoid: variations"),
    checks=seven_stages.LASTING,
)


TRAPEZOID_BY_SHARE = edged(
    stages_in(__file__, "trapezoid by share: stages"),
    source="LCamHdl, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D",
    law=engine.TrapezoidByShare,
    entries=family.parameters_of(
        engine.TrapezoidByShare, share=family.Between, reversal=Literal["none", "start", "end"], edge=Share
    ),
    parameters=(family.SHARE, *parameters_in(CELLS["trapezoid by share"])),
    variations=variations_in(__file__, "trapezoid by share: variations"),
)


MODIFIED_SINE = edged(
    stages_in(__file__, "modified sine: stages"),
    source="LCamHdl, D_D_MOD_SINE",
    law=engine.ModifiedSine,
    entries=family.parameters_of(
        engine.ModifiedSine, family.Staged, share=family.Between, rise_edge=Share, fall_edge=Share
    ),
    parameters=(family.SHARE, *parameters_in(CELLS["modified sine"])),
    variations=variations_in(__file__, "modified sine: variations"),
    checks=(family.BRIEF,),
)

PARTS = ("sine", "constant", "cosine", "straight")


class Parts(family.Staged):
    """The shares of the time of sine edges, constants, cosine edges and a straight line; they sum to 1."""

    def design_faults(self) -> Iterator[DesignError]:
        """Yield shares that do not fill the rise, and a law that cannot start or stop."""
        *curved, straight = (getattr(self, part) for part in PARTS)
        total = math.fsum([*curved, straight])
        fits = self.model_dump() | {part: self.usual[part] for part in PARTS}
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("", f"they sum to {figure(total)}; expected 1", fits)
        if not max(curved):
            yield DesignError("", "all of the time is straight", fits)
        if abs(total - 1) <= SUM_TOLERANCE and max(curved):
            yield from super().design_faults()


SINE_CONSTANT_COSINE = edged(
    stages_in(__file__, "sine, constant, cosine: stages"),
    titled="Sine-constant-cosine (SCCA)",
    source="PTC Creo, 'SCCA'; mechdesigner.support, 'Sine-Constant-Cosine'",
    law=engine.SineConstantCosine,
    entries=family.parameters_of(engine.SineConstantCosine, Parts, share=family.Between, **dict.fromkeys(PARTS, Share)),
    parameters=(*parameters_in(CELLS["parts"]), family.SHARE),
    variations=variations_in(__file__, "sine, constant, cosine: variations"),
    checks=(*checks_in(CELLS["parts: checks"]), family.BRIEF),
)


HARMONIC_COMBINATION = edged(
    stages_in(__file__, "harmonic combination: stages"),
    source="LCamHdl, D_R_ and R_D_HARMONIC_COMBI",
    law=engine.HarmonicCombination,
    entries=family.parameters_of(engine.HarmonicCombination, share=family.Between, reversal=family.Reversal),
    parameters=(family.SHARE, family.REVERSAL),
    variations=variations_in(__file__, "harmonic combination: variations"),
)


Curved = Annotated[float, Field(ge=family.LEAST, le=1, allow_inf_nan=False)]
SINE_STRAIGHT_SINE = edged(
    stages_in(__file__, "sine, straight, sine: stages"),
    source="LCamHdl, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286",
    law=engine.SineStraightSine,
    entries=family.parameters_of(engine.SineStraightSine, family.Staged, curved=Curved, share=family.Between),
    parameters=(family.SHARE, *parameters_in(CELLS["sine, straight, sine"])),
    checks=(family.BRIEF,),
    variations=variations_in(__file__, "sine, straight, sine: variations"),
)
