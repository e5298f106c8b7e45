"""Constant acceleration."""

from engine.laws.constant_acceleration import ConstantAcceleration
from workbook.laws.edged import FLAT, Stage, edged
from workbook.laws.shared import SHARED

PAGE = edged(
    {2: Stage(FLAT, "=@share"), 6: Stage(FLAT, "=1-@share")},
    source="S3, figure 1; with λ: LCamHdl, D_D_PARABOLA",
    **SHARED,
    law=ConstantAcceleration,
)
