"""Simple harmonic."""

from engine.laws.simple_harmonic import SimpleHarmonic
from workbook.laws.edged import SINE_IN, Stage, Stages, edged, law_of
from workbook.laws.shared import SHARE, SHARES, Shared

STAGES = Stages({3: Stage(SINE_IN, "=@share"), 5: Stage(SINE_IN, "=1-@share")})  # fmt: skip

PAGE = edged(
    STAGES,
    title="Simple harmonic",
    source="LCamHdl, D_D_BASIC_SINE: s = (1 − cos πξ)/2",
    entries=Shared,
    made=law_of(SimpleHarmonic, "share"),
    parameters=(SHARE,),
    variations=SHARES,
)
