"""A composed motion as entered, and the engine's view of it."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.entries.machine import Machine, Sizes
from workbook.entries.types import PLAIN, EntryError, Model, Number, Positive
from workbook.laws.entries import LawCode

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
