"""How many pieces a motion has, and the room that its table has for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from engine.motion.pieces import placed
from workbook.entries.machine import Machine
from workbook.entries.types import EntryError
from workbook.laws.entries import Laws
from workbook.laws.library import laws

FEW = 8  # rows more than are used, where a description does not say how many
WIDEST = 8  # pieces of a law that verify tries in any book


def counts(given: Laws) -> dict[str, int]:
    """Return the number of pieces of each law of a book."""
    return {name: len(placed(law)) for name, law in laws(given).items()}


def settle(machine: Machine, motions: Mapping[str, Sequence[str]], least: int, more: int = 0) -> None:
    """Settle the room for the pieces of a motion: what is stated, or a few rows more than the longest motion needs.

    ``motions`` are the laws of the phases of each, by the place of its entry in the description; each motion has
    ``more`` pieces besides. Raises EntryError for a room of less than ``least``, or too small for a motion.
    """
    number, room = counts(machine.laws), machine.sizes.motion_pieces
    needed = {key: sum(number[name] for name in names) + more for key, names in motions.items()}
    if room is None:
        room = max(least, *needed.values()) + FEW
        object.__setattr__(machine, "sizes", machine.sizes.model_copy(update={"motion_pieces": room}))
    if room < least:
        raise EntryError("sizes.motion_pieces", f"{room} pieces are too few; expected at least {least}")
    for key, count in needed.items():
        if count > room:
            raise EntryError(key, f"{count} pieces do not fit into {room}; raise sizes.motion_pieces")


def within(phases: list[dict[str, Any]], given: dict[str, Any], room: int) -> list[dict[str, Any]]:
    """Return phases of which some are dwells instead, so that their pieces find room; ``given`` are the laws."""
    number, left = counts(Laws.model_validate(given)), room
    for after, phase in zip(range(len(phases) - 1, -1, -1), phases, strict=True):
        if number[phase["law"]] + after > left:
            phase |= {"law": "DWL", "lift": 0.0}
        left -= number[phase["law"]]
    return phases
