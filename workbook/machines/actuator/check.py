"""What only the engine can say of the entries of an actuator."""

from __future__ import annotations

from engine.laws.inverse import is_monotone
from workbook.entries.types import EntryError
from workbook.laws.library import laws
from workbook.machines.actuator.entries import ActuatorSizing


def check(machine: ActuatorSizing) -> None:
    """Raise EntryError where a phase has the own law, and that moves backwards."""
    used = [phase.law for phase in machine.actuator.phases]
    if "OWN" in used and not is_monotone(laws(machine.laws, machine.sizes.own_law)["OWN"]):
        message = "the own law moves backwards; expected a law that rises throughout"
        raise EntryError(f"actuator.phases.{used.index('OWN')}.law", message)
