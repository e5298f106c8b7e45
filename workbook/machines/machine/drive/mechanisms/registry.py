"""The mechanisms by their kind: what the sheet of each has."""

from collections.abc import Callable
from typing import cast

from workbook.book.declare import Sheet
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.mechanisms import constant, crank_slider, press_crank, rocker, table
from workbook.machines.machine.drive.mechanisms.column import LinkagePage, MechanismPage

Tables = dict[str, Callable[[Sheet, Driven, int], None]]
LINKAGES = {
    "crank-slider": cast(LinkagePage, crank_slider),
    "rocker": cast(LinkagePage, rocker),
    "table": cast(LinkagePage, table),
}
"""the mechanisms whose ratio depends on the position"""
ENTERED: Tables = {"table": table.entered}
"""the tables of what is entered, of kinds that have any; each has as many rows as the book has for positions"""
WORKED: Tables = {"table": table.table, "rocker": rocker.table}
"""likewise of workings"""


def page(driven: Driven) -> MechanismPage:
    """Return what the sheet of a drive's mechanism has."""
    return LINKAGES.get(driven.given.kind, cast(MechanismPage, press_crank if driven.given.SLIDES else constant))
