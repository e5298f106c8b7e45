"""Constant acceleration."""

from engine.laws.constant_acceleration import ConstantAcceleration
from workbook.laws.edged import FLAT, Stage, Stages, edged, law_of
from workbook.laws.shared import SHARE, SHARES, Shared

STAGES = Stages({2: Stage(FLAT, "=@share"), 6: Stage(FLAT, "=1-@share")})  # fmt: skip

PAGE = edged(
    STAGES,
    title="Constant acceleration",
    source="S3, figure 1; with λ: LCamHdl, D_D_PARABOLA",
    entries=Shared,
    made=law_of(ConstantAcceleration, "share"),
    parameters=(SHARE,),
    variations=SHARES,
)
