"""A constant ratio in cells, of a drive with viscous friction: what is entered, and the ratios."""

from __future__ import annotations

from workbook.book.declare import Quantity, Sheet
from workbook.machines.machine import drive
from workbook.machines.machine.linked import slides
from workbook.machines.machine.linked.driven import PlacedDriven

passing, held = slides.passing, slides.held


def entries(driven: PlacedDriven, key: str) -> list[Quantity]:
    """Return the row of the size, if the mechanism has one."""
    return drive.size(driven)


def entered(sheet: Sheet, driven: PlacedDriven, rows: int) -> None:
    """Declare no table of entries: what is entered are single cells."""


def sizes(driven: PlacedDriven) -> list[Quantity]:
    """Return the rows of the ratios."""
    return drive.ratios(driven)


def table(sheet: Sheet, driven: PlacedDriven, rows: int) -> None:
    """Declare nothing more."""
