"""What only the engine can say of the entries of an overlap."""

from engine.laws.inverse import is_monotone
from workbook.book.sentence import figure
from workbook.entries.turn import TURN
from workbook.entries.types import ANGLE_TOLERANCE, END_TOLERANCE, DesignError
from workbook.laws.library import laws
from workbook.laws.registry import RISING
from workbook.machines.overlap.entries import LEAST, IndexingOverlap
from workbook.machines.overlap.view import Overlapping, Station

BACKWARDS = "a law moves backwards: see its sheet, or Laws"


def check(machine: IndexingOverlap) -> None:
    """Raise DesignError where a law cannot be inverted, or a tool's schedule takes more than a turn."""
    require_rising(machine)
    for station in Overlapping(machine, laws(machine.laws)).stations:
        require_one_turn(station)


def require_rising(machine: IndexingOverlap) -> None:
    """Raise DesignError where a motion has a law that moves backwards or does not end at 1."""
    given = machine.overlap
    used = {"transfer.law": given.transfer.law}
    for i, tool in enumerate(given.tools):
        used |= {f"tools.{i}.law_in": tool.law_in, f"tools.{i}.law_out": tool.law_out}
    library = laws(machine.laws)
    for entry, name in used.items():
        law = library[name]
        if not is_monotone(law):
            raise DesignError(f"overlap.{entry}", BACKWARDS, "rises", RISING[0])
        if abs(law.end.s - 1) > END_TOLERANCE:
            said = f"the law {name} ends at s = {law.end.s:g}; expected a law that ends at 1"
            raise DesignError(f"overlap.{entry}", said, "reaches", RISING[0])


def require_one_turn(station: Station) -> None:
    """Raise DesignError where the schedule that is built takes more than a turn."""
    tool, (way_in, way_out) = station.given, station.angles_set
    taken = way_in + way_out + tool.dwell
    if taken > TURN + ANGLE_TOLERANCE:
        name = "angle_in" if tool.angle_in is not None else "angle_out"
        said = f"way in, dwell and way out take {figure(taken)}°; expected at most 360°"
        raise DesignError(f"{station.key}.{name}", said, f"turn{station.number}", LEAST)
