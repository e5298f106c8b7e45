"""Variations that a drive's sheet can work out: with less lift where its places would not suffice."""

from __future__ import annotations

from workbook.entries.types import DesignError
from workbook.machines.machine.chain import LINKED
from workbook.machines.machine.check import check
from workbook.machines.machine.entries import AnyMachine, Axis

NODES, TURNS = "nodes", 6
"""the rule of the places of a drive's sheet, and how often lifts are halved where it is broken"""


def gentle(machine: AnyMachine) -> AnyMachine:
    """Return a machine whose axes lift less where the places of a drive's sheet would not suffice."""
    if not any(axis.motor and placed(axis) for axis in machine.axes):
        return machine
    for _ in range(TURNS):
        try:
            check(machine)
        except DesignError as fault:
            if not fault.rule.startswith(NODES):
                break
            k = int(fault.rule.removeprefix(NODES)) - 1
            axes = [halved(axis) if i == k else axis for i, axis in enumerate(machine.axes)]
            machine = machine.model_copy(update={"axes": axes})
        else:
            break
    return machine


def placed(axis: Axis) -> bool:
    """Whether the drive of an axis is worked out place by place."""
    return axis.load.viscous is not None or bool(axis.mechanism and axis.mechanism.kind in LINKED)


def halved(axis: Axis) -> Axis:
    """Return an axis that lifts half as far."""
    return axis.model_copy(update={"phases": [one.model_copy(update={"lift": 0.5 * one.lift}) for one in axis.phases]})
