"""Pages of laws of one pulse and the same backwards."""

from engine.laws.halved import ConstantAcceleration, Cycloidal, SimpleHarmonic
from workbook.laws.edged import FLAT, HALF_SINE, SINE_IN, Stage, edged
from workbook.laws.shared import SHARED

CONSTANT_ACCELERATION = edged(
    {2: Stage(FLAT, "=@share"), 6: Stage(FLAT, "=1-@share")},
    source="S3, figure 1; with λ: LCamHdl, D_D_PARABOLA",
    **SHARED,
    law=ConstantAcceleration,
)

CYCLOIDAL = edged(
    {2: Stage(HALF_SINE, "=@share"), 6: Stage(HALF_SINE, "=1-@share")},
    source="S2, movement equation; S3; with λ: LCamHdl, D_D_INCLINED_SINE",
    **SHARED,
    law=Cycloidal,
)

SIMPLE_HARMONIC = edged(
    {3: Stage(SINE_IN, "=@share"), 5: Stage(SINE_IN, "=1-@share")},
    source="LCamHdl, D_D_BASIC_SINE: s = (1 − cos πξ)/2",
    **SHARED,
    law=SimpleHarmonic,
)

PAGES = (CONSTANT_ACCELERATION, CYCLOIDAL, SIMPLE_HARMONIC)
