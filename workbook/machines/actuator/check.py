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


BACKWARDS = "a law moves backwards: see its sheet, or Laws"


def check(machine: ActuatorSizing) -> None:
    """Raise DesignError where the mechanism lacks its size, or a phase has a law that moves backwards."""
    require_size(machine)
    used, library = [phase.law for phase in machine.actuator.phases], laws(machine.laws)
    for name in dict.fromkeys(used):
        if not is_monotone(library[name]):
            raise DesignError(f"actuator.phases.{used.index(name)}.law", BACKWARDS, "rises", RISING[0])


def require_size(machine: ActuatorSizing) -> None:
    """Raise DesignError where the size of the last element is empty, and its load travels by it."""
    entry, kind = machine.actuator, KINDS[machine.actuator.mechanism]
    size = SIZES.get(kind.name, "diameter")
    if kind.travels and getattr(entry.output, size) is None:
        words = "turns per mm" if size == "turns" else "diameter"
        raise DesignError(f"actuator.output.{size}", f"a {kind.name} has no {words}", "size", 1.0)
