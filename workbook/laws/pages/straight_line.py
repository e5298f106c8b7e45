"""Straight line: constant velocity."""

from engine.laws.straight_line import StraightLine
from workbook.laws.family import COEFFICIENTS, Page, PieceRow

PAGE = Page(
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
