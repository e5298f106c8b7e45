"""The mechanisms by their kind: what the sheet of each has."""

from __future__ import annotations

from types import ModuleType

from workbook.book.declare import Quantity, check
from workbook.machines.machine.linked import constant, crank, rocker, table
from workbook.machines.machine.linked.driven import LinkedDriven, PlacedDriven

KINDS: dict[str, ModuleType] = {"crank-slider": crank, "rocker": rocker, "table": table}


def of(driven: PlacedDriven) -> ModuleType:
    """Return what the sheet of a drive's mechanism has."""
    return KINDS.get(driven.given.kind, constant)


def checks(driven: LinkedDriven) -> list[Quantity]:
    """Return the check that the sizes go together."""
    i, kind = driven.number, of(driven)
    said = table.wrong(driven.entered.unit) if kind is table else kind.WRONG
    return [
        check("@ok_linked", f"{driven.called}: the sizes of the mechanism go together", kind.FITS, True, kind.HOLDS,
              f":linked{i}", said)
    ]  # fmt: skip
