"""The axes of a machine over a turn of the master shaft, each as late as it is entered: mm or ° over degrees."""

from __future__ import annotations

from engine.cams.course import course_of_motion, turned
from engine.timing import Switch
from workbook.axes import CamAxis, CamSwitch
from workbook.entries.abscissa import Abscissa
from workbook.entries.units import DEGREE, shown
from workbook.laws.library import laws
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.view import MovingAxis, Whole


def axes(machine: AnyMachine) -> list[CamAxis]:
    """Return the axes of a machine."""
    return [cam(one, machine.over) for one in Whole(machine, laws(machine.laws)).axes]


def cam(one: MovingAxis, over: Abscissa) -> CamAxis:
    """Return an axis as a controller can be given it."""
    told = course_of_motion(one.motion, over.shown(shown(1.0, DEGREE)), shown(1.0, one.unit))
    repeats = one.given.repeats and one.axis.closes
    return CamAxis(one.given.name, turned(told, one.typed.shift), over.unit, one.given.unit, repeats)


def switches(machine: AnyMachine) -> list[CamSwitch]:
    """Return the switches of a machine, over the degrees of its master shaft, or the seconds of its cycle."""
    found = []
    for one in machine.switches:
        on = tuple((time.start, time.stop) for time in one.on if time.start is not None and time.stop is not None)
        found.append(CamSwitch(one.name, Switch(one.name, on, machine.over.length), machine.over.unit))
    return found
