"""The engine's view of a composed motion."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from engine.laws import Law
from engine.laws.base import Array
from engine.motion import MotionValues, Phase
from engine.motion.joining import joined
from engine.timing import Axis
from workbook.machines.composer.entries import MotionComposer
from workbook.motion.through import passed


class Composition:
    """The engine's view of a composed motion, in the units entered."""

    def __init__(self, machine: MotionComposer, library: dict[str, Law]) -> None:
        self.laws = machine.laws
        self.given, self.sizes = machine.motion, machine.sizes
        phases = [Phase(library[p.law], p.lift, p.duration) for p in self.given.phases]
        self.repeats = self.given.cycle == "closes"
        self.joined = joined(
            phases, passed(self.given.phases), self.repeats, position=self.given.position, shares=False
        )
        self.motion = self.joined.motion
        self.axis = Axis("motion", self.motion, feed=not self.repeats)
        self.junctions = self.motion.junctions(periodic=self.repeats)

    @property
    def units(self) -> tuple[str, ...]:
        """Units of velocity, acceleration and jerk."""
        x, y = self.given.abscissa_unit, self.given.lift_unit
        return f"{y}/{x}", f"{y}/{x}²", f"{y}/{x}³"

    @property
    def room(self) -> int:
        """Rows of the table of pieces."""
        return self.sizes.motion_pieces or 0

    @cached_property
    def abscissa(self) -> Array:
        """The sampled places, at equal steps from begin to end."""
        return np.linspace(0.0, self.motion.total, self.sizes.cycle + 1)

    @cached_property
    def samples(self) -> MotionValues[Array]:
        """Position and its derivatives at :attr:`abscissa`."""
        return self.motion.at(self.abscissa)
