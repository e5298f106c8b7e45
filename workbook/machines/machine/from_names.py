"""A machine as the defined names of a file tell it: its axes, mechanisms, clearances and switches."""

from collections.abc import Container
from itertools import permutations
from typing import Any, Literal

from workbook.entries.abscissa import UNITS as MEASURES
from workbook.entries.abscissa import in_unit
from workbook.entries.turn import TURN
from workbook.machines.machine import chain
from workbook.machines.machine import entries as entered
from workbook.machines.machine.clearance.entries import ENDS, MOST_CLEARANCES, ClearanceEntry
from workbook.machines.machine.mechanism import MECHANISMS, some_mechanism
from workbook.machines.machine.switches.entries import MOST_SWITCHES, SwitchEntry
from workbook.machines.machine.switches.view import named
from workbook.machines.machine.time_based import Cycle, TimedMachine
from workbook.machines.machine.view import UNITS

MARKS = {"mm": "mm", "°": "deg"}


def unit_name(number: int, unit: str) -> str:
    """Return the name of the cell that says in which unit an axis is entered: by it a file tells that."""
    return f"axis{number}_{MARKS[unit]}"


def laid_out(machine: entered.AnyMachine, names: Container[str]) -> entered.AnyMachine:
    """Return a machine with the axes that a file has by its defined names: its book has the file's inputs."""
    axes = []
    for i in range(1, entered.MOST_AXES + 1):
        units = [unit for unit in UNITS if unit_name(i, unit) in names]
        kinds = [kind for kind in MECHANISMS if kind_name(i, kind) in names]
        if units:
            drive = driven_by(kinds[0]) if kinds else {"mechanism": None, "motor": None}
            viscous = 0.0 if viscous_name(i) in names else None
            arm = chain.SwingingArm() if arm_name(i) in names else None
            load = LEAST.model_copy(update={"viscous": viscous, "arm": arm})
            own = {"unit": units[0], "load": load, "parts": [], "rate": None, "printed": printed_in(i, names)}
            axes.append(machine.axes[0].model_copy(update=own | drive))
    told = [SwitchEntry(name=name, on=[]) for name in switch_names(names)]
    found: dict[str, Any] = {"axes": axes or machine.axes, "switches": told, "clearances": clearances(names)}
    chosen = machine.axes[0].name if CHOSEN in names else None
    falling = any(fall_name(i) in names for i in range(1, entered.MOST_AXES + 1))
    found["selection"] = machine.selection.model_copy(update={"axis": chosen, "falling": falling})
    told_in = [unit for unit in MEASURES if in_unit(unit) in names]
    if told_in:
        known = {name: getattr(machine, name) for name in type(machine).model_fields}
        return TimedMachine.model_construct(**known | found | {"master": Cycle(cycle=TURN, unit=told_in[0])})
    return machine.model_copy(update=found)


CHOSEN = "sel_axis"
"""the name of the cell that says which axis the sheet Selection looks at: by it a file tells that it has one"""


def clearances(names: Container[str]) -> list[ClearanceEntry]:
    """Return the clearances that a file has by its defined names, of axes by their numbers."""
    numbers = range(1, entered.MOST_AXES + 1)
    return [
        ClearanceEntry.model_construct(name=f"Clearance {k}", first=str(one), second=str(other))
        for k in range(1, MOST_CLEARANCES + 1)
        for one, other in permutations(numbers, 2)
        if clearance_name(k, one, other) in names
    ]


def clearance_name(number: int, first: int, second: int) -> str:
    """Return the name of the cell of a clearance: by it a file tells which axes it is of."""
    return f"clear{number}_{first}_{second}"


def switch_names(names: Container[str]) -> list[str]:
    """Return the names of the cells that tell what each switch of a file is called."""
    return [name for name in map(named, range(1, MOST_SWITCHES + 1)) if name in names]


LEAST = chain.AxisLoad()


def driven_by(kind: str) -> dict[str, Any]:
    """Return the entries of some drive with a mechanism."""
    motor = chain.AxisMotor(inertia=1.0, rated_torque=1.0, peak_torque=1.0, max_speed=1.0)
    return {"mechanism": some_mechanism(kind), "motor": motor}


def kind_name(number: int, kind: str) -> str:
    """Return the name of the cell that says which mechanism an axis has: by it a file tells that."""
    return f"drive{number}_{kind.replace(' ', '_').replace('-', '_')}"


def printed_in(number: int, names: Container[str]) -> Literal["S4"] | None:
    """Return which document's figures a file has beside those of an axis, by its defined names."""
    return "S4" if f"drive{number}_printed" in names else None


def viscous_name(number: int) -> str:
    """Return the name of the cell of an axis' viscous friction: by it a file tells that it has one."""
    return f"drive{number}_viscous"


def arm_name(number: int) -> str:
    """Return the name of the cell of an arm's mass: by it a file tells that an axis has one."""
    return f"drive{number}_arm_mass"


def fall_name(number: int) -> str:
    """Return the name of the cell of the fall of a motor's peak torque: by it a file tells that its drives know one."""
    return f"drive{number}_fall"


def fixed(machine: entered.AnyMachine) -> dict[str, Any]:
    """Return the entries that a book's layout tells, and no cell to enter; and tables whose cells may all be empty."""
    master = {"cycle": None, "unit": machine.over.unit} if machine.over.measured else {}
    found: dict[str, Any] = {"master": master} | {f"axes.{i}.unit": axis.unit for i, axis in enumerate(machine.axes)}
    found |= {f"switches.{i}.on": [] for i in range(len(machine.switches))}
    for i, one in enumerate(machine.clearances):
        found |= {f"clearances.{i}.{end}": int(getattr(one, end)) for end in ENDS}
    for i, axis in enumerate(machine.axes):
        if axis.mechanism:
            found |= {f"axes.{i}.mechanism.kind": axis.mechanism.kind, f"axes.{i}.motor": {}, f"axes.{i}.reducer": {}}
    found |= {f"axes.{i}.printed": axis.printed for i, axis in enumerate(machine.axes) if axis.printed}
    found["selection.falling"] = machine.selection.falling
    found |= {f"axes.{i}.load.arm": {} for i, axis in enumerate(machine.axes) if axis.load.arm}
    viscous = (i for i, axis in enumerate(machine.axes) if axis.load.viscous is not None)
    return found | {f"axes.{i}.load.viscous": 0.0 for i in viscous}
