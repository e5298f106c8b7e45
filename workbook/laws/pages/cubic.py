"""Cubic."""

from engine.laws.cubic import Cubic
from workbook.laws.edged import LINE_IN, Stage, Stages, edged, law_of
from workbook.laws.shared import POLYNOMIAL, SHARE, SHARES, Shared

STAGES = Stages({3: Stage(LINE_IN, "=@share"), 5: Stage(LINE_IN, "=1-@share")})  # fmt: skip

PAGE = edged(
    STAGES,
    title="Cubic",
    source="S1, S3: the cubic that starts and ends at rest; with λ: LCamHdl, POLY_3",
    entries=Shared,
    made=law_of(Cubic, "share"),
    parameters=(SHARE,),
    variations=SHARES,
    way=POLYNOMIAL.format(3),
)
