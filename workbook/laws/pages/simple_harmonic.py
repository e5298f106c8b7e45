"""Simple harmonic."""

from engine.laws.simple_harmonic import SimpleHarmonic
from workbook.laws.edged import SINE_IN, Stage, edged
from workbook.laws.shared import SHARED

PAGE = edged(
    {3: Stage(SINE_IN, "=@share"), 5: Stage(SINE_IN, "=1-@share")},
    source="LCamHdl, D_D_BASIC_SINE: s = (1 − cos πξ)/2",
    **SHARED,
    law=SimpleHarmonic,
)
