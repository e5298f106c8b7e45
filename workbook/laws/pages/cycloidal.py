"""Cycloidal."""

from engine.laws.cycloidal import Cycloidal
from workbook.laws.edged import HALF_SINE, Stage, Stages, edged, law_of
from workbook.laws.shared import SHARE, SHARES, Shared

STAGES = Stages({2: Stage(HALF_SINE, "=@share"), 6: Stage(HALF_SINE, "=1-@share")})  # fmt: skip

PAGE = edged(
    STAGES,
    title="Cycloidal",
    source="S2, movement equation; S3; with λ: LCamHdl, D_D_INCLINED_SINE",
    entries=Shared,
    made=law_of(Cycloidal, "share"),
    parameters=(SHARE,),
    variations=SHARES,
)
