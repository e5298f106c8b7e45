"""Rest, without a sheet of its own and nothing to enter, and the straight line."""

from engine.laws import Dwell
from engine.laws.uniform import StraightLine
from workbook.laws.family import COEFFICIENTS, Page, PieceRow

DWELL = Page(
    source="S3, function motionlaw",
    entries=None,
    law=Dwell,
    has_sheet=False,
    pieces=(PieceRow("rest", "s = 0", "=1"),),
    coefficients={name: ("=0", "at rest") for name, *_ in COEFFICIENTS},
    fastest="=0",
    way="=-1",
)

STRAIGHT_LINE = Page(
    source="LCamHdl, CONST_VELO",
    law=StraightLine,
    pieces=(PieceRow("straight line", "s = ξ", "=1"),),
    coefficients={name: ("=0", "no acceleration") for name, *_ in COEFFICIENTS} | {"cv": ("=1", "v = 1")},
    fastest="=0",
    start="=1",
    lowest="=1",
    rests=False,
    way="=-1",
    single=False,
)

PAGES = (DWELL, STRAIGHT_LINE)
