"""The mechanisms whose ratio depends on the position, as they are entered; what is wrong with their sizes."""

from itertools import pairwise

from engine.drive.mechanisms import by_angle
from engine.drive.mechanisms.slides import crank_slider, rocker
from engine.drive.mechanisms.table import PositionTable
from engine.drive.mechanisms.variable_ratio import Linkage
from workbook.book.sentence import figure
from workbook.entries.units import DEGREE, MM, si
from workbook.machines.machine.mechanism import CrankSlider, MechanismEntry, PressCrank, Rocker, Table


def linkage_of(given: MechanismEntry, unit: float) -> Linkage:
    """Return the mechanism that is entered, of an axis in a unit. Raises ValueError for sizes that cannot be."""
    match given:
        case Table():
            return PositionTable([(si(one.angle, DEGREE), si(one.position, unit)) for one in given.points])
        case Rocker():
            lever, link, offset = (si(one or 0.0, MM) for one in (given.lever_length, given.link_length, given.offset))
            angle, sense = si(given.start_angle or 0.0, DEGREE), -1 if given.direction == "backward" else 1
            return rocker(lever, link, offset, angle, given.slide != "behind", sense)
        case CrankSlider():
            crank, rod, offset, start = (
                si(one or 0.0, MM) for one in (given.crank_radius, given.rod_length, given.offset, given.start)
            )
            return crank_slider(crank, rod, offset, given.zero or "inner", given.branch or "ahead", start)
    raise ValueError(f"a {given.kind} has a constant ratio")


def press_of(given: PressCrank) -> by_angle.PressCrank:
    """Return the press crank that is entered. Raises ValueError for sizes that cannot be."""
    crank, rod, offset = (si(one, MM) for one in (given.crank_radius, given.rod_length, given.offset or 0.0))
    return by_angle.PressCrank(crank, rod, offset, si(given.start_angle or 0.0, DEGREE))


FALLS = "point {} at {} °, {} {} is not beyond the one before it, at {} °, {} {}"
SHORT = "the rod is not longer than crank and offset: the crank cannot turn round"
APART = {
    "press crank": SHORT,
    "crank-slider": SHORT,
    "rocker": "where the motion begins, the link does not reach from the lever to the slide, or is in line with it",
}


def apart(given: MechanismEntry, unit: str) -> str:
    """Return what is wrong with sizes that do not go together, of a table the first point that does not rise."""
    for row, (one, other) in enumerate(pairwise(given.points if isinstance(given, Table) else []), 2):
        if other.angle <= one.angle or other.position <= one.position:
            (angle, position), (low, lowest) = ((figure(p.angle), figure(p.position)) for p in (other, one))
            return FALLS.format(row, angle, position, unit, low, lowest, unit)
    if isinstance(given, Table):
        return ""
    try:
        _ = press_of(given) if isinstance(given, PressCrank) else linkage_of(given, MM)
    except ValueError:
        return APART[given.kind]
    return ""
