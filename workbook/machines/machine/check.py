"""What only the engine can say of the entries of a machine."""

from __future__ import annotations

from workbook.entries.types import DesignError
from workbook.laws.library import laws
from workbook.laws.registry import RISING
from workbook.machines.machine.drive import UNSHAPED
from workbook.machines.machine.entries import AnyMachine


def check(machine: AnyMachine) -> None:
    """Raise DesignError where an axis with a drive lifts by a law that its sheet cannot integrate."""
    library = laws(machine.laws)
    for i, axis in enumerate(machine.axes):
        for k, phase in enumerate(axis.phases if axis.motor else []):
            if phase.lift and library[phase.law].shapes() is None:
                raise DesignError(f"axes.{i}.phases.{k}.law", UNSHAPED, f"shaped{i + 1}", RISING[0])
