"""The composed motion as an axis, in the units entered."""

from __future__ import annotations

from engine.cams.course import course_of_motion
from workbook.axes import CamAxis
from workbook.laws.library import laws
from workbook.machines.composer.entries import MotionComposer
from workbook.machines.composer.view import Composition


def axes(machine: MotionComposer) -> list[CamAxis]:
    """Return the one axis of a composed motion."""
    given, found = machine.motion, Composition(machine, laws(machine.laws))
    course = course_of_motion(found.motion)
    return [CamAxis("motion", course, given.abscissa_unit, given.lift_unit, found.repeats)]
