"""Rest: no sheet of its own, and nothing to enter."""

from engine.laws import Dwell
from workbook.laws.family import COEFFICIENTS, Page, PieceRow

PAGE = Page(
    source="S3, function motionlaw",
    entries=None,
    law=Dwell,
    has_sheet=False,
    samples="",
    pieces=(PieceRow("rest", "s = 0", "=1"),),
    coefficients={name: ("=0", "at rest") for name, *_ in COEFFICIENTS},
    fastest="=0",
    way="=-1",
)
