"""What only the engine can say of the entries of a machine."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from engine.laws import Law
from engine.laws.piece_extremes import extremes_of
from engine.machine.stationary import LOST, plain
from engine.motion.joining import EndedPhase
from engine.motion.pieces import Scaled, pieces_of
from workbook.entries.turn import TURN
from workbook.entries.types import DesignError
from workbook.laws.library import laws
from workbook.laws.registry import RISING
from workbook.laws.shelf import LawShelf
from workbook.machines.machine.chain import LARGE, LINKED, TABLE
from workbook.machines.machine.drive import UNSHAPED
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.linked.changing import LinkedWork
from workbook.machines.machine.linked.driven import LinkedDriven, PlacedDriven, apart, linkage_of
from workbook.machines.machine.linked.reach import unreached_row
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.stretched import Stretched
from workbook.machines.machine.view import MovingAxis, Whole

KNOWN = 256
"""laws of which is kept whether a drive takes them: a study asks for each many times"""


def check(machine: AnyMachine) -> None:
    """Raise DesignError where an axis with a drive lifts by a law that its sheet cannot integrate."""
    library = laws(machine.laws)
    for i, axis in enumerate(machine.axes):
        for k, phase in enumerate(axis.phases if axis.motor else []):
            if phase.lift and not integrable(library[phase.law]):
                raise DesignError(f"axes.{i}.phases.{k}.law", UNSHAPED, f"shaped{i + 1}", RISING[0])
    for one in Whole(machine, library).axes:
        if one.given.motor and any(isinstance(phase, EndedPhase) for phase in one.phases):
            require_room(machine, one)
        if one.given.mechanism and one.given.mechanism.kind in LINKED:
            require_reached(machine, one)
        elif one.given.motor and one.given.load.viscous is not None:
            require_places(machine, one)


def require_room(machine: AnyMachine, axis: MovingAxis) -> None:
    """Raise DesignError where phases between prescribed ends turn too often for the stretches of a drive's sheet."""
    rows = rows_of(machine, axis)
    stretched = Stretched(rows, Driven(rows.axis, machine.selection))
    tabled = axis.given.mechanism is not None and axis.given.mechanism.kind == TABLE
    if len(stretched.spans) > stretched.rows or (tabled and any(angle < TURN for angle, _ in stretched.further)):
        raise DesignError(f"axes.{axis.number - 1}.phases", UNSHAPED, f"shaped{axis.number}", resting(axis))


def resting(axis: MovingAxis) -> list[dict[str, Any]]:
    """Return the phases of an axis, none of which moves it."""
    rest = {"law": "DWL", "lift": 0.0, "velocity": None, "acceleration": None}
    return [phase.model_dump() | rest for phase in axis.given.phases]


def require_places(machine: AnyMachine, axis: MovingAxis) -> None:
    """Raise DesignError where the places of a sheet do not suffice for a drive with viscous friction."""
    rows = rows_of(machine, axis)
    work = PlacedWork(rows, PlacedDriven(rows.axis, machine.selection))
    if not work.enough:
        raise DesignError(f"axes.{axis.number - 1}.phases", work.too_few, f"nodes{axis.number}", resting(axis))


def rows_of(machine: AnyMachine, axis: MovingAxis) -> AxisRows:
    """Return an axis as its book cuts it."""
    shelf = LawShelf(machine.laws, machine.sizes, bool(machine.laws.of("LIN")))
    whole = Whole(machine, shelf.laws)
    return AxisRows(whole, whole.axes[axis.number - 1], shelf.stack)


def require_reached(machine: AnyMachine, axis: MovingAxis) -> None:
    """Raise DesignError for a mechanism that cannot be, that does not reach a position, or that the sheet misses."""
    i, given = axis.number, axis.given.mechanism
    if given is None:
        return
    where, large = f"axes.{i - 1}.mechanism", given.model_dump() | LARGE[given.kind]
    said = apart(given, axis.given.unit)
    if said:
        raise DesignError(where, said, f"linked{i}", large)
    said = unreached_row(axis, linkage_of(given, axis.unit))
    if said:
        raise DesignError(where, said, f"reach{i}", large)
    rows = rows_of(machine, axis)
    work = LinkedWork(rows, LinkedDriven(rows.axis, machine.selection))
    if not work.enough:
        raise DesignError(where, work.too_few, f"nodes{i}", large)


@lru_cache(maxsize=KNOWN)
def integrable(law: Law) -> bool:
    """Whether a drive's stretches know a law: its pieces, and that it never turns back."""
    pieces = law.as_pieces()
    rise = pieces_of(Scaled(law, 1.0, 1.0))
    return all(plain(piece) for piece in rise) and extremes_of(pieces, law.start.v).v[0] >= -LOST
