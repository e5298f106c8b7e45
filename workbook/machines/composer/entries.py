"""A composed motion (S3): what an engineer enters."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.entries.exported import Exporting
from workbook.entries.machine import Sizes
from workbook.entries.phase import Passing, PhaseEntry, require_straight
from workbook.entries.texts import NO_FORMULA, ONE_LINE
from workbook.entries.types import EntryError, Model, Number
from workbook.motion.asked import Smoothness
from workbook.motion.room import settle_phases

MOST_PHASES = 24
Unit = Annotated[str, Field(min_length=1, max_length=12, pattern=NO_FORMULA), ONE_LINE]


class ComposedPhase(PhaseEntry, Passing):
    """A phase, and what it passes its begin with."""


class ComposedMotion(Model):
    """Phases one after the other over any abscissa: an angle, time, or the travel of a product."""

    abscissa_unit: Unit = "°"
    lift_unit: Unit = "°"
    position: Number = 0.0
    cycle: Literal["closes", "open"] = "closes"
    smoothness: Smoothness = "acceleration"
    phases: Annotated[list[ComposedPhase], Field(min_length=1, max_length=MOST_PHASES)]


class ComposerSizes(Sizes):
    """How large the tables are built: as everywhere, with room for 24 phases; a cycle of N − 1 intervals."""

    phases: Annotated[int, Field(ge=2, le=MOST_PHASES)] = MOST_PHASES


class MotionComposer(Exporting):
    """S3's composed motion."""

    AXES = ("motion",)
    template: Literal["motion-composer"] = "motion-composer"
    sizes: ComposerSizes = ComposerSizes()
    motion: ComposedMotion

    @model_validator(mode="after")
    def _fits(self) -> Self:
        for path, filled, room in (("motion.phases", len(self.motion.phases), self.sizes.phases),):
            if filled > room:
                raise EntryError(path, f"{filled} rows do not fit into {room}; raise sizes.{path.split('.')[-1]}")
        require_straight(self.laws, {"motion.phases": self.motion.phases})
        settle_phases(self, {"motion.phases": self.motion.phases})
        return self
