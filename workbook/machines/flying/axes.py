"""The tool of a flying cutter over a cycle: mm over s; its shaft: degrees over s."""

from __future__ import annotations

from engine.cams.profile import profile_of
from engine.flying.pieces import cut_pieces
from workbook.axes import CamAxis
from workbook.entries.units import DEGREE, MM, shown
from workbook.laws.library import laws
from workbook.machines.flying.entries import FlyingCutter
from workbook.machines.flying.view import Flying


def axes(machine: FlyingCutter) -> list[CamAxis]:
    """Return the tool along its path, and the shaft that drives it; both go on from where a cycle ends."""
    found = Flying(machine, laws(machine.laws))
    pieces, end = cut_pieces(found.cut, whole=True), found.cut.cycle_time
    shaft = shown(found.tool.angle(1.0), DEGREE)
    return [
        CamAxis("tool", profile_of(pieces, end, y=shown(1.0, MM)), "s", "mm"),
        CamAxis("shaft", profile_of(pieces, end, y=shaft), "s", "°"),
    ]
