"""What only the engine can say of the entries of an overlap."""

from __future__ import annotations

from engine.laws.inverse import is_monotone
from workbook.entries.types import ANGLE_TOLERANCE, END_TOLERANCE, EntryError
from workbook.laws.library import laws
from workbook.machines.overlap.entries import TURN, IndexingOverlap
from workbook.machines.overlap.view import Overlapping, Station


def check(machine: IndexingOverlap) -> None:
    """Raise EntryError where a law cannot be inverted, or a tool's schedule takes more than a turn."""
    require_rising(machine)
    for station in Overlapping(machine, laws(machine.laws)).stations:
        require_one_turn(station)


def require_rising(machine: IndexingOverlap) -> None:
    """Raise EntryError where a motion has a law that moves backwards or does not end at 1."""
    given = machine.overlap
    used = {"transfer.law": given.transfer.law}
    for i, tool in enumerate(given.tools):
        used |= {f"tools.{i}.law_in": tool.law_in, f"tools.{i}.law_out": tool.law_out}
    library = laws(machine.laws)
    for entry, name in used.items():
        law, fault = library[name], ""
        if not is_monotone(law):
            fault = "moves backwards; expected a law that rises throughout"
        elif abs(law.end.s - 1) > END_TOLERANCE:
            fault = f"ends at s = {law.end.s:g}; expected a law that ends at 1"
        if fault:
            raise EntryError(f"overlap.{entry}", f"the law {name} {fault}")


def require_one_turn(station: Station) -> None:
    """Raise EntryError where the schedule that is built takes more than a turn."""
    tool, (way_in, way_out) = station.given, station.angles_set
    taken = way_in + way_out + tool.dwell
    if taken > TURN + ANGLE_TOLERANCE:
        name = "angle_in" if tool.angle_in is not None else "angle_out"
        message = f"way in, dwell and way out take {taken:g}°; expected at most 360°"
        raise EntryError(f"{station.key}.{name}", message)
