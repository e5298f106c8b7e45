"""The load of an actuator over its cycle: mm or degrees over s."""

from __future__ import annotations

from engine.cams.course import course_of_motion
from workbook.axes import CamAxis
from workbook.entries.units import shown
from workbook.laws.library import laws
from workbook.machines.actuator.entries import ActuatorSizing
from workbook.machines.actuator.view import Sized


def axes(machine: ActuatorSizing) -> list[CamAxis]:
    """Return the one axis, the load; a cycle that does not come back is no cam that repeats."""
    found = Sized(machine, laws(machine.laws))
    course = course_of_motion(found.sizing.motion, y=shown(1.0, found.unit))
    return [CamAxis("load", course, "s", "mm" if found.kind.travels else "°", found.sizing.motion.closes)]
