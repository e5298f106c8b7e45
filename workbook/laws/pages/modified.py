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
from workbook.laws.edged import FLAT, SINE_IN, SINE_OUT, Stage, edged
from workbook.laws.page_tables import checks_in, parameters_in

CELLS = cell_tables(__file__)

MODIFIED_TRAPEZOIDAL = edged(
    dict(enumerate(map(Stage, (SINE_OUT, FLAT, SINE_IN, None, SINE_IN, FLAT, SINE_OUT)), 1)),
    titled="Modified trapezoidal acceleration",
    source="S1, seven parameters; S3, figure 2",
    entries=seven_stages.SevenDurations,
    law=engine.ModifiedTrapezoidal,
    parameters=seven_stages.DURATIONS,
    variations=seven_stages.lasting(
        [0.1, 0.2, 0.15, 0.05, 0.12, 0.25, 0.13],
        [0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0],
        [0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2],
        [0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0],
        [0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1],
        [0.15, 0.1, 0.0, 0.2, 0.0, 0.3, 0.25],
    ),
    checks=seven_stages.LASTING,
)


TRAPEZOID_BY_SHARE = edged(
    {
        1: Stage(SINE_OUT, '=IF(@reversal="start",0,@share/4)'),
        2: Stage(FLAT, '=@share*IF(@reversal="start",1-@edge,1/2)'),
        3: Stage(SINE_IN, '=@share*IF(@reversal="start",@edge,1/4)'),
        5: Stage(SINE_IN, '=(1-@share)*IF(@reversal="end",@edge,1/4)'),
        6: Stage(FLAT, '=(1-@share)*IF(@reversal="end",1-@edge,1/2)'),
        7: Stage(SINE_OUT, '=IF(@reversal="end",0,(1-@share)/4)'),
    },
    source="LCamHdl, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D",
    law=engine.TrapezoidByShare,
    entries=family.parameters_of(
        engine.TrapezoidByShare, share=family.Between, reversal=Literal["none", "start", "end"], edge=Share
    ),
    parameters=(family.SHARE, *parameters_in(CELLS["trapezoid by share"])),
    variations=(
        {"share": 0.4, "reversal": "end", "edge": 0.3},
        {"share": 0.6, "reversal": "start", "edge": 0.7},
        {"share": 0.3, "reversal": "none", "edge": 0.4},
        {"share": 0.55, "reversal": "end", "edge": 1.0},
    ),
)


MODIFIED_SINE = edged(
    {
        1: Stage(SINE_OUT, "=@rise_edge*@share"),
        3: Stage(SINE_IN, "=(1-@rise_edge)*@share"),
        5: Stage(SINE_IN, "=(1-@fall_edge)*(1-@share)"),
        7: Stage(SINE_OUT, "=@fall_edge*(1-@share)"),
    },
    source="LCamHdl, D_D_MOD_SINE",
    law=engine.ModifiedSine,
    entries=family.parameters_of(
        engine.ModifiedSine, family.Staged, share=family.Between, rise_edge=Share, fall_edge=Share
    ),
    parameters=(family.SHARE, *parameters_in(CELLS["modified sine"])),
    variations=(
        {"share": 0.4, "rise_edge": 0.25, "fall_edge": 0.4},
        {"share": 0.6, "rise_edge": 0.0, "fall_edge": 1.0},
        {"share": 0.3, "rise_edge": 0.5, "fall_edge": 0.1},
    ),
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
            yield DesignError("", f"they sum to {figure(total)}; expected 1", "sum", fits)
        if not max(curved):
            yield DesignError("", "all of the time is straight", "lasts", fits)
        if abs(total - 1) <= SUM_TOLERANCE and max(curved):
            yield from super().design_faults()


SINE_CONSTANT_COSINE = edged(
    {
        1: Stage(SINE_OUT, "=@sine*@share"),
        2: Stage(FLAT, "=@constant*@share"),
        3: Stage(SINE_IN, "=@cosine*@share"),
        4: Stage(None, "=@straight"),
        5: Stage(SINE_IN, "=@cosine*(1-@share)"),
        6: Stage(FLAT, "=@constant*(1-@share)"),
        7: Stage(SINE_OUT, "=@sine*(1-@share)"),
    },
    titled="Sine-constant-cosine (SCCA)",
    source="PTC Creo, 'SCCA'; mechdesigner.support, 'Sine-Constant-Cosine'",
    law=engine.SineConstantCosine,
    entries=family.parameters_of(engine.SineConstantCosine, Parts, share=family.Between, **dict.fromkeys(PARTS, Share)),
    parameters=(*parameters_in(CELLS["parts"]), family.SHARE),
    variations=(
        {"sine": 0.1, "constant": 0.6, "cosine": 0.3, "straight": 0.0, "share": 0.4},
        {"sine": 0.2, "constant": 0.0, "cosine": 0.6, "straight": 0.2, "share": 0.6},
        {"sine": 0.0, "constant": 0.5, "cosine": 0.2, "straight": 0.3, "share": 0.3},
        {"sine": 0.15, "constant": 0.25, "cosine": 0.35, "straight": 0.25, "share": 0.55},
    ),
    checks=(*checks_in(CELLS["parts: checks"]), family.BRIEF),
)


HARMONIC_COMBINATION = edged(
    {
        1: Stage(SINE_OUT, '=IF(@reversal="start",0,@share/4)'),
        3: Stage(SINE_IN, '=@share*IF(@reversal="start",1,3/4)'),
        5: Stage(SINE_IN, '=(1-@share)*IF(@reversal="end",1,3/4)'),
        7: Stage(SINE_OUT, '=IF(@reversal="end",0,(1-@share)/4)'),
    },
    source="LCamHdl, D_R_ and R_D_HARMONIC_COMBI",
    law=engine.HarmonicCombination,
    entries=family.parameters_of(engine.HarmonicCombination, share=family.Between, reversal=family.Reversal),
    parameters=(family.SHARE, family.REVERSAL),
    variations=tuple({"share": s, "reversal": end} for s, end in ((0.4, "start"), (0.6, "end"), (0.3, "start"))),
)


Curved = Annotated[float, Field(ge=family.LEAST, le=1, allow_inf_nan=False)]
SINE_STRAIGHT_SINE = edged(
    {
        3: Stage(SINE_IN, "=@curved*@share"),
        4: Stage(None, "=1-@curved"),
        5: Stage(SINE_IN, "=@curved*(1-@share)"),
    },
    source="LCamHdl, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286",
    law=engine.SineStraightSine,
    entries=family.parameters_of(engine.SineStraightSine, family.Staged, curved=Curved, share=family.Between),
    parameters=(family.SHARE, *parameters_in(CELLS["sine, straight, sine"])),
    checks=(family.BRIEF,),
    variations=({"share": 0.4, "curved": 0.3}, {"share": 0.7, "curved": 1.0}, {"share": 0.55, "curved": 0.8}),
)
