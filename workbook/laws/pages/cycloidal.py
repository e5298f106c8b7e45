"""Cycloidal."""

from engine.laws.cycloidal import Cycloidal
from workbook.laws.edged import HALF_SINE, Stage, edged
from workbook.laws.shared import SHARED

PAGE = edged(
    {2: Stage(HALF_SINE, "=@share"), 6: Stage(HALF_SINE, "=1-@share")},
    source="S2, movement equation; S3; with λ: LCamHdl, D_D_INCLINED_SINE",
    **SHARED,
    law=Cycloidal,
)
