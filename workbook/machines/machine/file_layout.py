"""The layout of a machine's book by the defined names of a file: its axes, mechanisms, clearances and switches."""

from collections.abc import Container
from itertools import permutations
from typing import Any

from workbook.entries.abscissa import UNITS as MEASURES
from workbook.entries.abscissa import unit_cell_name
from workbook.entries.phase import TURN
from workbook.machines.machine import drive_entries
from workbook.machines.machine import entries as entered
from workbook.machines.machine.entries_beside import (
    ENDS,
    MOST_CLEARANCES,
    MOST_SWITCHES,
    ClearanceEntry,
    FreePosition,
    HardStops,
    SwitchEntry,
)
from workbook.machines.machine.mechanism import MECHANISMS, some_mechanism
from workbook.machines.machine.time_based import Cycle, TimedMachine
from workbook.machines.machine.view import UNITS

MARKS = {"mm": "mm", "°": "deg"}
CHOSEN = "sel_axis"
"""the name of the cell with the axis that the sheet Selection is for; a file with that name has the sheet"""


COMPARED = "timing_compared"
"""the name of the cell with the rate to compare at; a file with that name has columns of extremes there"""
clearance_name = "clear{}_{}_{}".format
"""names the cell of a clearance by its number and those of its axes, which a file has by it"""
pairs_name = "clear{}_pairs_used".format
"""names the cell that counts the pairs of a clearance's table: by it a file says that it has pairs"""
SOME_PAIRS = [FreePosition(at=0.0, free=0.0), FreePosition(at=1.0, free=0.0)]
switch_name = "switch{}_name".format
"""names the cell that tells what a switch is called: by it a file tells how many there are"""


def unit_name(number: int, unit: str) -> str:
    """Return the name of the cell with the unit of an axis; from the name alone a file's layout is known."""
    return f"axis{number}_{MARKS[unit]}"


def kind_name(number: int, kind: str) -> str:
    """Return the name of the cell with the mechanism of an axis; from the name alone a file's layout is known."""
    return f"drive{number}_{kind.replace(' ', '_').replace('-', '_')}"


def stop_name(number: int, end: str) -> str:
    """Return the name of the cell with the lower (``low``) or the upper stop (``high``) of an axis."""
    return f"axis{number}_stop_{end}"


def stage_name(number: int, stage: int) -> str:
    """Return the name of the cell with the ratio of a stage, from 0, of an axis; a file tells so how many it has."""
    return f"drive{number}_s{stage + 1}_ratio"


def laid_out(machine: entered.AnyMachine, names: Container[str]) -> entered.AnyMachine:
    """Return a machine with the axes that a file has by its defined names: its book has the file's inputs."""
    numbers = range(1, entered.MOST_AXES + 1)
    known = [(i, unit) for i in numbers for unit in UNITS if unit_name(i, unit) in names]
    switches = [name for name in map(switch_name, range(1, MOST_SWITCHES + 1)) if name in names]
    layout: dict[str, Any] = {
        "axes": [axis_of(machine.axes[0], i, unit, names) for i, unit in known] or machine.axes,
        "switches": [SwitchEntry(name=name, on=[]) for name in switches],
        "clearances": [
            ClearanceEntry.model_construct(
                name=f"Clearance {k}",
                first=str(first_axis),
                second=str(second_axis),
                pairs=SOME_PAIRS if pairs_name(k) in names else [],
            )
            for k in range(1, MOST_CLEARANCES + 1)
            for first_axis, second_axis in permutations(numbers, 2)
            if clearance_name(k, first_axis, second_axis) in names
        ],
    }
    chosen = machine.axes[0].name if CHOSEN in names else None
    falling = any(f"drive{i}_fall" in names for i in numbers)
    layout["selection"] = machine.selection.model_copy(update={"axis": chosen, "falling": falling})
    units_in_file = [unit for unit in MEASURES if unit_cell_name(unit) in names]
    if units_in_file:
        entries = {name: getattr(machine, name) for name in type(machine).model_fields}
        return TimedMachine.model_construct(**entries | layout | {"master": Cycle(cycle=TURN, unit=units_in_file[0])})
    compared = 0.0 if COMPARED in names else None
    layout["master"] = machine.master.model_copy(update={"compare_rate": compared})
    return machine.model_copy(update=layout)


def axis_of(axis: entered.Axis, number: int, unit: str, names: Container[str]) -> entered.Axis:
    """Return an axis with the unit, the drive and the load that a file has for an axis by its defined names."""
    kinds = [kind for kind in MECHANISMS if kind_name(number, kind) in names]
    mechanism = some_mechanism(kinds[0]) if kinds else None
    if mechanism and f"drive{number}_belt_on_bed" in names:
        mechanism = mechanism.model_copy(update={"belt_on_bed": 0.0})
    viscous = 0.0 if f"drive{number}_viscous" in names else None
    arm = drive_entries.SwingingArm() if f"drive{number}_arm_mass" in names else None
    stages = (
        drive_entries.StageEntry(ratio=1.0) for n in range(drive_entries.STAGES) if stage_name(number, n) in names
    )
    brake = drive_entries.MotorBrake(torque=1.0) if f"drive{number}_brake_torque" in names else None
    motor = drive_entries.AxisMotor(brake=brake, inertia=1.0, rated_torque=1.0, peak_torque=1.0, max_speed=1.0)
    return axis.model_copy(
        update={
            "unit": unit,
            "stops": HardStops() if stop_name(number, "low") in names else None,
            "load": drive_entries.AxisLoad().model_copy(update={"viscous": viscous, "arm": arm}),
            "parts": [],
            "stages": [*stages],
            "rate": None,
            "printed": "S4" if f"drive{number}_printed" in names else None,
            "mechanism": mechanism,
            "motor": motor if kinds else None,
        }
    )


def fixed(machine: entered.AnyMachine) -> dict[str, Any]:
    """Return the entries that follow from a book's layout, without a cell; and tables whose cells may all be empty."""
    entries: dict[str, Any] = {"master": {"cycle": None, "unit": machine.over.unit} if machine.over.measured else {}}
    entries |= {"master.compare_rate": 0.0} if getattr(machine.master, "compare_rate", None) is not None else {}
    for i, axis in enumerate(machine.axes):
        entries[f"axes.{i}.unit"] = axis.unit
        entries |= {f"axes.{i}.stops": {}} if axis.stops else {}
        if axis.mechanism:
            entries |= {
                f"axes.{i}.mechanism.kind": axis.mechanism.kind,
                f"axes.{i}.motor": {},
                f"axes.{i}.reducer": {},
            }
        entries |= {f"axes.{i}.motor.brake": {}} if axis.motor and axis.motor.brake else {}
        entries |= {f"axes.{i}.printed": axis.printed} if axis.printed else {}
        entries |= {f"axes.{i}.stages.{n}": {} for n in range(len(axis.stages))}
        entries |= {f"axes.{i}.load.arm": {}} if axis.load.arm else {}
        on_bed = getattr(axis.mechanism, "belt_on_bed", None)
        entries |= {f"axes.{i}.mechanism.belt_on_bed": 0.0} if on_bed is not None else {}
        entries |= {f"axes.{i}.load.viscous": 0.0} if axis.load.viscous is not None else {}
    entries |= {f"switches.{i}.on": [] for i in range(len(machine.switches))}
    for i, clearance in enumerate(machine.clearances):
        entries |= {f"clearances.{i}.{end}": int(getattr(clearance, end)) for end in ENDS}
    return entries | {"selection.falling": machine.selection.falling}
