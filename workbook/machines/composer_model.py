"""A composed motion as entered, and the engine's view of it."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from engine.laws import Law
from engine.motion import Motion, MotionValues, Phase
from engine.timing import Axis, Diagram, Movement
from workbook.machine import PLAIN, EntryError, LawCode, Machine, Model, Number, Positive, Sizes

MOST_PHASES = 24

Unit = Annotated[str, Field(min_length=1, max_length=12, pattern=PLAIN)]


class ComposedPhase(Model):
    """One phase: a law, carried out over a lift in a duration, in the units of the motion."""

    law: LawCode = "DWL"
    lift: Number = 0.0
    duration: Positive

    @model_validator(mode="after")
    def _at_rest(self) -> Self:
        if self.law == "DWL" and self.lift != 0:
            raise EntryError("lift", f"a dwell has no lift; expected 0, or another law, not {self.lift:g}")
        return self


class ComposedMotion(Model):
    """Phases one after the other over any abscissa: an angle, time, or the travel of a product."""

    abscissa_unit: Unit = "°"
    lift_unit: Unit = "°"
    position: Number = 0.0
    cycle: Literal["closes", "open"] = "closes"
    phases: Annotated[list[ComposedPhase], Field(min_length=1, max_length=MOST_PHASES)]


class ComposerSizes(Sizes):
    """How large the tables are built: as everywhere, with room for 24 phases; a cycle of N − 1 intervals."""

    phases: Annotated[int, Field(ge=2, le=MOST_PHASES)] = MOST_PHASES


class MotionComposer(Machine):
    """S3's composed motion."""

    template: Literal["motion-composer"] = "motion-composer"
    sizes: ComposerSizes = ComposerSizes()
    motion: ComposedMotion

    @model_validator(mode="after")
    def _fits(self) -> Self:
        for path, filled, room in (
            ("motion.phases", len(self.motion.phases), self.sizes.phases),
            ("laws.OWN.pieces", len(self.laws.OWN.pieces), self.sizes.pieces),
        ):
            if filled > room:
                raise EntryError(path, f"{filled} rows do not fit into {room}; raise sizes.{path.split('.')[-1]}")
        return self


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
