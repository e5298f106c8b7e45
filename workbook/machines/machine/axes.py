"""The axes of a machine over a turn of the master shaft, each as late as it is entered: mm or ° over degrees."""

from dataclasses import replace
from functools import partial

from engine.cams.interpolation import Seen, composed
from engine.laws.base import Array
from engine.motion.pieces import CamProfile, profile_of_motion, turned
from engine.timing import Switch
from workbook.axes import CamAxis, CamSwitch
from workbook.entries.abscissa import Abscissa
from workbook.entries.units import DEGREE, shown
from workbook.laws.library import laws
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.view import MovingAxis, Whole

ANGLE_UNIT = "°"


def axes(machine: AnyMachine) -> list[CamAxis]:
    """Return the axes of a machine."""
    return [cam(one, machine) for one in Whole(machine, laws(machine.laws)).axes]


def cam(one: MovingAxis, machine: AnyMachine) -> CamAxis:
    """Return an axis as a controller can be given it."""
    over, driven = machine.over, one.given.motor is not None
    repeats = one.given.repeats and one.closes
    told = CamAxis(one.given.name, profile(one, over, shown(1.0, one.unit)), over.unit, one.given.unit, repeats)
    return replace(told, shaft=partial(shaft, one, machine, told)) if driven else told


def profile(one: MovingAxis, over: Abscissa, y: float) -> CamProfile:
    """Return the motion of an axis, y of its units (m, rad) as one, as late as it is entered."""
    unshifted = profile_of_motion(one.motion, over.shown(shown(1.0, DEGREE)), y)
    return turned(unshifted, one.typed.shift, one.motion.lifts_sum * y)


def shaft(one: MovingAxis, machine: AnyMachine, load: CamAxis) -> CamAxis:
    """Return the angle of the motor's shaft of an axis, in degrees: before the reducer, and where its load is at 0, 0.

    Behind a mechanism whose ratio depends on the position, 0 is where that counts its angle from. Raises ValueError
    where the mechanism cannot bring its load to a position.
    """
    driven = Driven(one, machine)
    if driven.linkage is None:
        turning = profile(one, machine.over, shown(driven.mechanism.ratio, DEGREE))
        return replace(load, profile=turning, y_unit=ANGLE_UNIT)
    linkage, degrees = driven.linkage, shown(driven.reducer.ratio, DEGREE)

    def angle(y: Array) -> Seen:
        return Seen(*(degrees * each for each in linkage.shaft(y)))

    return replace(load, profile=composed(profile(one, machine.over, 1.0), angle), y_unit=ANGLE_UNIT)


def switches(machine: AnyMachine) -> list[CamSwitch]:
    """Return the switches of a machine, over the degrees of its master shaft, or the seconds of its cycle."""
    found = []
    for one in machine.switches:
        on = tuple((time.start, time.stop) for time in one.on if time.start is not None and time.stop is not None)
        found.append(CamSwitch(one.name, Switch(one.name, on, machine.over.length), machine.over.unit))
    return found
