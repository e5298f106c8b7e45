"""A phase as entered wherever phases follow one another: a law over a lift in a duration."""

from __future__ import annotations

from typing import Self

from pydantic import model_validator

from workbook.entries.types import EntryError, Model, Number, Positive
from workbook.laws.entries import LawName


class PhaseEntry(Model):
    """One phase: a law, carried out over a lift in a duration, in the units of the motion."""

    law: LawName = "DWL"
    lift: Number = 0.0
    duration: Positive

    @model_validator(mode="after")
    def _at_rest(self) -> Self:
        if self.law == "DWL" and self.lift != 0:
            raise EntryError("lift", f"a dwell has no lift; expected 0, or another law, not {self.lift:g}")
        return self
