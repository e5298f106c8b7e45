"""Transfer and tools of an indexing machine over a turn of the master shaft: mm over degrees."""

from __future__ import annotations

from engine.cams.profile import CamProfile, profile_of, turned
from engine.overlap.schedule import pieces_of_parts
from engine.timing import FULL_TURN
from workbook.axes import CamAxis
from workbook.entries.units import DEGREE, MM, shown
from workbook.laws.library import laws
from workbook.machines.overlap.entries import IndexingOverlap
from workbook.machines.overlap.view import Overlapping, Station


def axes(machine: IndexingOverlap) -> list[CamAxis]:
    """Return the transfer, which goes on every turn, and each tool as it is set."""
    found = Overlapping(machine, laws(machine.laws))
    x, y = shown(1.0, DEGREE), shown(1.0, MM)
    transfer = profile_of(pieces_of_parts(found.transfer.parts, whole=True), FULL_TURN, x, y)
    tools = [CamAxis(one.given.name, _set(one), "°", "mm") for one in found.stations]
    return [CamAxis("transfer", transfer, "°", "mm"), *tools]


def _set(station: Station) -> CamProfile:
    """Return a tool's profile as the master shaft sees it."""
    schedule = station.as_set
    told = profile_of(pieces_of_parts(schedule.parts, whole=True), FULL_TURN, shown(1.0, DEGREE), shown(1.0, MM))
    return turned(told, shown(schedule.arrival, DEGREE))
