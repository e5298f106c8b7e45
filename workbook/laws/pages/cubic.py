"""Cubic."""

from engine.laws.cubic import Cubic
from workbook.laws.edged import LINE_IN, Stage, edged
from workbook.laws.shared import POLYNOMIAL, SHARED

PAGE = edged(
    {3: Stage(LINE_IN, "=@share"), 5: Stage(LINE_IN, "=1-@share")},
    source="S1, S3: the cubic that starts and ends at rest; with λ: LCamHdl, POLY_3",
    **SHARED,
    law=Cubic,
    way=POLYNOMIAL.format(3),
)
