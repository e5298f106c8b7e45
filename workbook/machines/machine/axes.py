"""The axes of a machine as its book has them, with their drives: worked out once for as long as nothing is new."""

import pickle
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from workbook.law_sheets.book_laws import BookLaws
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.entries import MOST_AXES, AnyMachine
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.view import MachineView, moving_axes

# of a machine, and of its variations
REMEMBERED = 8 * MOST_AXES


@dataclass(frozen=True)
class AxisAlone:
    """An axis by its ``number`` in a machine that has no other: the same as another if all that was entered is.

    The laws of the book follow from what was entered.
    """

    number: int
    entered: bytes
    machine: AnyMachine = field(compare=False)
    laws: BookLaws = field(compare=False)


@lru_cache(REMEMBERED)
def tables_of(alone: AxisAlone) -> AxisTables:
    """Return the tables of an axis."""
    (axis,) = axes = moving_axes(alone.machine, alone.laws.laws, alone.number)
    return AxisTables(MachineView(alone.machine, axes), axis, alone.laws.stack)


def laws_of(machine: AnyMachine) -> BookLaws:
    """Return the laws of a machine's book."""
    return BookLaws(machine.laws, machine.sizes, bool(machine.laws.of("LIN")))


def axes_of(machine: AnyMachine, laws: BookLaws | None = None) -> list[AxisTables]:
    """Return the axes of a machine as its book has them; an axis whose entries stay the same is remembered."""
    laws, tables = laws or laws_of(machine), []
    whole: dict[str, Any] = {"title": "", "number": None, "revision": None, "author": None, "date": None}
    whole |= {"switches": [], "clearances": []}
    for number, axis in enumerate(machine.axes, 1):
        alone = machine.model_copy(update=whole | {"axes": [axis]})
        tables.append(tables_of(AxisAlone(number, pickle.dumps(alone), alone, laws)))
    return tables


@lru_cache(REMEMBERED)
def drive_of(tables: AxisTables) -> DriveView | None:
    """Return the drive of an axis, if it has one."""
    given = tables.axis.given
    if given.mechanism and given.motor:
        return DriveView(tables, Driven(tables.axis, tables.machine.given))
    return None
