"""What only the engine can say of the entries of a machine."""

from workbook.entries.types import DesignError
from workbook.laws.library import laws
from workbook.machines.machine.drive.linkages import apart, linkage_of
from workbook.machines.machine.drive.reach import unreached_row
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.mechanism import LINKED, SLIDING
from workbook.machines.machine.view import MovingAxis, Whole


def check(machine: AnyMachine) -> None:
    """Raise DesignError for a mechanism that cannot be, or that does not reach a position of its axis."""
    kinds = [axis.mechanism.kind if axis.mechanism else "" for axis in machine.axes]
    if set(kinds).isdisjoint((*LINKED, *SLIDING)):
        return
    for axis, kind in zip(Whole(machine, laws(machine.laws)).axes, kinds, strict=True):
        if kind in (*LINKED, *SLIDING):
            require_reached(axis)


def require_reached(axis: MovingAxis) -> None:
    """Raise DesignError for a mechanism that cannot be, or that does not reach a position."""
    i, given = axis.number, axis.given.mechanism
    if given is None:
        return
    where, large = f"axes.{i - 1}.mechanism", given.model_dump() | given.LARGE
    said = apart(given, axis.given.unit)
    if said:
        raise DesignError(where, said, f"linked{i}", large)
    said = "" if given.SLIDES else unreached_row(axis, linkage_of(given, axis.unit))
    if said:
        raise DesignError(where, said, f"reach{i}", large)
