"""Requirements of a motion: smoothness, velocity and acceleration where curved phases meet, room for its pieces."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

from engine.laws import Law
from engine.laws.inverse import law_pieces
from workbook.entries.machine import Machine
from workbook.fields.types import EntryError
from workbook.law_sheets.library import laws
from workbook.laws.entries import Laws

Smoothness = Literal["velocity", "acceleration", "jerk"]
"""what must be continuous: velocity; acceleration too; jerk too"""
ABOUT = "what must not jump: velocity; acceleration too; jerk too"


@dataclass(frozen=True)
class RequiredSmoothness:
    """The smoothness that a motion must have, and its words in sentences: pairs are a formula and its text."""

    smooth: Smoothness
    entry: str  # the formula of what is entered
    order: str  # the name of the cell that counts the derivatives
    largest: tuple[str, str]  # the formulas of the largest |y'| and |y''|
    place: str  # the unit of the abscissa, behind a place
    of: tuple[str, str] = ("", "")  # the motion's name
    wraps: str = ""  # the condition under which the motion repeats
    periodic: bool = True  # whether it does
    # of its phases, in the column ``what`` of their table, where sentences give them
    names: tuple[str, ...] = ()
    # of a motion in degrees shown over time: the cell of its speed, and rad/s
    speed: tuple[str, float] | None = None
    # the end of a formula of a lift in another unit, and what that is in it
    lift: tuple[str, float] = ("", 1.0)
    # of the derivatives, where sentences have others than the motion's own
    units: tuple[str, ...] = ()
    quickest: str = ""  # the formula of the greatest 1/δ by which jerks are measured: by default that of all phases


def jump_formulas(required: RequiredSmoothness, degrees: str, size: str, order: str) -> tuple[str, str]:
    """Return the formulas of a place and of a jump as sentences show them."""
    if required.speed is None:
        return degrees, size
    return f"RADIANS({degrees})/{required.speed[0]}", f"{size}*{required.speed[0]}^{order}{required.lift[0]}"


def jump_values(required: RequiredSmoothness, x: float, size: float, order: int) -> tuple[float, float]:
    """Return place and jump by the engine, as sentences show them; x is in rad where the motion is over time."""
    if required.speed is None:
        return x, size
    return x / required.speed[1], size * required.speed[1] ** order / required.lift[1]


FEW = 8  # rows more than are used, where a description does not say how many
KNOWN = 256  # laws whose number of pieces is remembered: a study asks for each many times
AT_REST = {"law": "DWL", "lift": 0.0}  # the entries of a phase that does not move
CROWDED = "{} pieces do not fit into {} rows; build it with larger sizes.motion_pieces"


def piece_counts(given: Laws) -> dict[str, int]:
    """Return the number of pieces of each law of a book."""
    return {name: piece_count(law) for name, law in laws(given).items()}


@lru_cache(maxsize=KNOWN)
def piece_count(law: Law) -> int:
    """Return the number of pieces of a law."""
    return len(law_pieces(law))


def settle_room(machine: Machine, needed: Sequence[int], rest: int, at_once: int = 1) -> None:
    """Settle the rows for pieces of each motion: what is stated, or a few more than are ``needed``; raise EntryError.

    At least for ``rest`` pieces and any law of the book ``at_once`` times: so many does verify try.
    """
    least = rest + at_once * max(machine.sizes.pieces, *piece_counts(machine.laws).values())
    stated = machine.sizes.motion_pieces
    rooms = stated or [max(least, most + FEW) for most in needed]
    if min(rooms) < least:
        raise EntryError("sizes.motion_pieces", f"{min(rooms)} pieces are too few; expected at least {least}")
    if stated is None:
        sizes = machine.sizes.model_copy(update={"motion_pieces": rooms})
        sizes.model_fields_set.discard("motion_pieces")  # a machine with other entries settles it anew
        object.__setattr__(machine, "sizes", sizes)


def dwells_for_room(phases: list[dict[str, Any]], given: dict[str, Any], room: int) -> list[dict[str, Any]]:
    """Return phases, some replaced by dwells so that the pieces of all find room; ``given`` are the laws."""
    number, left = piece_counts(Laws.model_validate(given)), room
    for after, phase in zip(range(len(phases) - 1, -1, -1), phases, strict=True):
        if number[phase["law"]] + after > left:
            phase |= AT_REST
        left -= number[phase["law"]]
    return phases
