"""What only the engine can say of the entries of an actuator."""

from __future__ import annotations

from engine.drivetrain import KINDS
from engine.laws.inverse import is_monotone
from workbook.entries.types import DesignError
from workbook.laws.library import laws
from workbook.laws.registry import RISING
from workbook.machines.actuator.entries import ActuatorSizing

SIZES = {"lead screw": "turns"}
"""what a mechanism's last element is entered by, if not by its diameter"""


def check(machine: ActuatorSizing) -> None:
    """Raise DesignError where the mechanism lacks its size, or a phase has an own law that moves backwards."""
    require_size(machine)
    used = [phase.law for phase in machine.actuator.phases]
    if "OWN" in used and not is_monotone(laws(machine.laws, machine.sizes.own_law)["OWN"]):
        said = "the own law moves backwards"
        raise DesignError(f"actuator.phases.{used.index('OWN')}.law", said, "rises", RISING[0])


def require_size(machine: ActuatorSizing) -> None:
    """Raise DesignError where the size of the last element is empty, and its load travels by it."""
    entry, kind = machine.actuator, KINDS[machine.actuator.mechanism]
    size = SIZES.get(kind.name, "diameter")
    if kind.travels and getattr(entry.output, size) is None:
        words = "turns per mm" if size == "turns" else "diameter"
        raise DesignError(f"actuator.output.{size}", f"a {kind.name} has no {words}", "size", 1.0)
