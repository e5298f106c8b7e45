"""How many pieces a motion has, and the room that its table has for them."""

from functools import lru_cache
from typing import Any

from engine.laws import Law
from engine.motion.pieces import law_pieces
from workbook.entries.machine import Machine
from workbook.entries.types import EntryError
from workbook.laws.entries import Laws
from workbook.laws.library import laws

FEW = 8  # rows more than are used, where a description does not say how many
KNOWN = 256  # laws of which is kept how many pieces they have: a study asks for each many times
AT_REST = {"law": "DWL", "lift": 0.0}  # the entries of a phase that does not move
CROWDED = "{} pieces do not fit into {} rows; build it with larger sizes.motion_pieces"


def counts(given: Laws) -> dict[str, int]:
    """Return the number of pieces of each law of a book."""
    return {name: count(law) for name, law in laws(given).items()}


@lru_cache(maxsize=KNOWN)
def count(law: Law) -> int:
    """Return the number of pieces of a law."""
    return len(law_pieces(law))


def settle(machine: Machine, most: int, rest: int, at_once: int = 1) -> int:
    """Settle the room for the pieces of a motion, and return it: what is stated, or a few rows more than ``most``.

    There is room for ``rest`` pieces and any law of the book ``at_once`` times: so many does verify try. Raises
    EntryError where less is stated.
    """
    least = rest + at_once * max(machine.sizes.pieces, *counts(machine.laws).values())
    room = machine.sizes.motion_pieces
    if room is None:
        room = max(least, most + FEW)
        object.__setattr__(machine, "sizes", machine.sizes.model_copy(update={"motion_pieces": room}))
    if room < least:
        raise EntryError("sizes.motion_pieces", f"{room} pieces are too few; expected at least {least}")
    return room


def rule_of(i: int) -> str:
    """Return the name of the rule that the pieces of the i-th motion, from 1, find room."""
    return f"room{i}"


def within(phases: list[dict[str, Any]], given: dict[str, Any], room: int) -> list[dict[str, Any]]:
    """Return phases of which some are dwells instead, so that their pieces find room; ``given`` are the laws."""
    number, left = counts(Laws.model_validate(given)), room
    for after, phase in zip(range(len(phases) - 1, -1, -1), phases, strict=True):
        if number[phase["law"]] + after > left:
            phase |= AT_REST
        left -= number[phase["law"]]
    return phases
