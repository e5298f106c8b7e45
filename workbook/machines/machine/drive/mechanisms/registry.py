"""The mechanisms by their kind: what the sheet of each has."""

from typing import cast

from workbook.book.declare import Quantity, check
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.mechanisms import constant, crank_slider, press_crank, rocker, table
from workbook.machines.machine.drive.mechanisms.column import LinkagePage, MechanismPage

LINKAGES: dict[str, LinkagePage] = {
    "crank-slider": cast(LinkagePage, crank_slider),
    "rocker": cast(LinkagePage, rocker),
    "table": cast(LinkagePage, table),
}


def page(driven: Driven) -> MechanismPage:
    """Return what the sheet of a drive's mechanism has."""
    return LINKAGES.get(driven.given.kind, cast(MechanismPage, press_crank if driven.given.SLIDES else constant))


def linkage_page(driven: Driven) -> LinkagePage:
    """Return what the sheet of a mechanism has whose ratio depends on the position."""
    return LINKAGES[driven.given.kind]


def checks(driven: Driven) -> list[Quantity]:
    """Return the check that the sizes go together."""
    i, kind = driven.number, linkage_page(driven)
    return [
        check("@ok_linked", f"{driven.called}: the sizes of the mechanism go together", kind.FITS, True, kind.HOLDS,
              f":linked{i}", kind.wrong(driven))
    ]  # fmt: skip
