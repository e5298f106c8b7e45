"""Transfer and tools as the sheet Export may have them."""

from __future__ import annotations

from engine.motion.shifted import Shifted
from engine.overlap.schedule import size_of_parts
from workbook.entries.units import DEGREE, MM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap.cycle import tool_rows, transfer_rows
from workbook.machines.overlap.view import Overlapping, Station
from workbook.motion.exported import Exportable, Later

UNITS = ("°", "mm", "mm/°", "mm/°²")
UNIT = (shown(1.0, DEGREE), shown(1.0, MM))
"""one of the pieces' x and y in these"""
TURNED = "*1000"


def exportable(view: Overlapping, pieces: Pieces) -> list[Exportable]:
    """Return the transfer and each tool as it is set."""
    size = size_of_parts(view.transfer.parts)
    transfer = Exportable("transfer", '="transfer"', transfer_rows(view, pieces), UNITS, UNIT, TURNED, size)
    return [transfer, *(_tool(station, pieces) for station in view.stations)]


def _tool(station: Station, pieces: Pieces) -> Exportable:
    plan = station.as_set
    later = Later("[@schedules.there.3]", "overlap_eps", "", Shifted(plan.motion, plan.arrival).unshifted, 0.0)
    return Exportable(station.given.name, "=@name", tool_rows(station, "a", pieces), UNITS, UNIT, TURNED,
                      size_of_parts(plan.parts), later, station.scope)  # fmt: skip
