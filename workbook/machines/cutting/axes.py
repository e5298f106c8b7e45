"""The axes of a cutting machine over a turn of the master shaft: mm over degrees."""

from __future__ import annotations

from engine.cams.course import course_of_motion
from workbook.axes import CamAxis
from workbook.entries.units import DEGREE, MM, shown
from workbook.laws.library import laws
from workbook.machines.cutting.entries import CuttingMachine
from workbook.machines.cutting.view import Cutting


def axes(machine: CuttingMachine) -> list[CamAxis]:
    """Return the axes of a machine."""
    x, y = shown(1.0, DEGREE), shown(1.0, MM)
    found = Cutting(machine, laws(machine.laws)).axes
    return [CamAxis(one.name, course_of_motion(one.motion, x, y), "°", "mm", one.closes) for one in found]
