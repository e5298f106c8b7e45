"""The axes of a machine over a turn of the master shaft, each as late as it is entered: mm or ° over degrees."""

from dataclasses import replace
from functools import partial

from engine.cams.interpolation import Seen, composed
from engine.motion.pieces import CamProfile, profile_of_motion, turned
from engine.timing import Switch
from workbook.axes import CamAxis, CamSwitch
from workbook.entries.units import DEGREE, shown
from workbook.laws.library import laws
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.view import MovingAxis, Whole


def axes(machine: AnyMachine) -> list[CamAxis]:
    """Return the axes of a machine as a controller can be given them."""
    found = []
    for one in Whole(machine, laws(machine.laws)).axes:
        given, repeats = one.given, one.given.repeats and one.closes
        told = CamAxis(given.name, profile(one, shown(1.0, one.unit)), machine.over.unit, given.unit, repeats)
        found.append(replace(told, shaft=partial(shaft, one, machine, told)) if given.motor else told)
    return found


def profile(one: MovingAxis, y: float) -> CamProfile:
    """Return the motion of an axis, y of its units (m, rad) as one, as late as it is entered."""
    return turned(profile_of_motion(one.motion, one.over.shown(shown(1.0, DEGREE)), y), one.typed.shift)


def shaft(one: MovingAxis, machine: AnyMachine, load: CamAxis) -> CamAxis:
    """Return the angle of the motor's shaft of an axis, in degrees: before the reducer, and where its load is at 0, 0.

    Behind a mechanism whose ratio depends on the position, 0 is where that counts its angle from. Raises ValueError
    where the mechanism cannot bring its load to a position.
    """
    driven = Driven(one, machine)
    if driven.linkage is None:
        return replace(load, profile=profile(one, shown(driven.mechanism.ratio, DEGREE)), y_unit="°")
    linkage, degrees = driven.linkage, shown(driven.reducer.ratio, DEGREE)
    angle = composed(profile(one, 1.0), lambda y: Seen(*(degrees * each for each in linkage.shaft(y))))
    return replace(load, profile=angle, y_unit="°")


def switches(machine: AnyMachine) -> list[CamSwitch]:
    """Return the switches of a machine, over the degrees of its master shaft, or the seconds of its cycle."""
    over, found = machine.over, []
    for one in machine.switches:
        on = tuple((time.start, time.stop) for time in one.on if time.start is not None and time.stop is not None)
        found.append(CamSwitch(one.name, Switch(one.name, on, over.length), over.unit))
    return found
