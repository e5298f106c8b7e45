"""The engine's view of a composed motion."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from engine.laws import Law
from engine.motion import Motion, MotionValues, Phase
from engine.timing import Axis, Diagram, Movement
from workbook.machines.composer.entries import MotionComposer


class Composition:
    """The engine's view of a composed motion, in the units entered."""

    def __init__(self, machine: MotionComposer, library: dict[str, Law]) -> None:
        self.given, self.sizes = machine.motion, machine.sizes
        phases = [Phase(library[p.law], p.lift, p.duration) for p in self.given.phases]
        self.motion = Motion(phases, position=self.given.position)
        self.closes = self.given.cycle == "closes"
        self.junctions = self.motion.junctions(periodic=self.closes)

    @cached_property
    def abscissa(self) -> NDArray[np.float64]:
        """The sampled places, at equal steps from begin to end."""
        n = self.sizes.cycle
        return np.arange(n + 1) * self.motion.total / n

    @cached_property
    def samples(self) -> MotionValues[NDArray[np.float64]]:
        """Position and its derivatives at :attr:`abscissa`."""
        return self.motion.at(self.abscissa)

    @cached_property
    def movements(self) -> dict[int, Movement]:
        """The phases that lift, by their index, at one unit of the abscissa a second."""
        found = Diagram([Axis("motion", self.motion)], self.motion.total).movements(1 / self.motion.total)
        return {m.phase: m for m in found}

    @cached_property
    def greatest(self) -> tuple[float, float]:
        """Greatest velocity and acceleration of any phase, exactly: max C_v |h|/δ and max C_a |h|/δ²."""
        moves = self.movements.values()
        return max((m.y1_max for m in moves), default=0.0), max((m.y2_max for m in moves), default=0.0)

    @cached_property
    def peaks(self) -> tuple[float, float, float]:
        """The largest |h|, |h|/δ and |h|/δ² of any phase, 1 where nothing moves: what deviations are measured by."""
        moving = [(abs(p.lift), p.duration) for p in self.motion.phases if p.lift] or [(1.0, 1.0)]
        return max(h for h, _ in moving), max(h / d for h, d in moving), max(h / d**2 for h, d in moving)
