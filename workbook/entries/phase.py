"""Phases of an axis as they are entered."""

from collections.abc import Iterator

from workbook.book.limits import RowRule
from workbook.fields.types import DesignError, Model, NotNegative, Number
from workbook.laws.entries import LawName

TURN = 360.0  # degrees


AT_REST = RowRule("dwell", 'OR(AND([law]<>"DWL",[law]<>""),[lift]+0=0)', "lift", "lift of a dwell or without a law")
"""a row of phases whose law is the dwell, or that names none, does not lift"""


class AxisPhase(Model):
    """A phase, its lift in the axis' unit, and what it passes its begin with, in lift by rad, or as rates are shown."""

    # between two curved phases; else 0
    velocity: Number | None = None
    acceleration: Number | None = None
    start: NotNegative
    stop: NotNegative
    lift: Number = 0.0
    law: LawName = "DWL"

    @property
    def passes(self) -> bool:
        """Whether a velocity or acceleration is entered for its begin."""
        return self.velocity is not None or self.acceleration is not None

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a dwell that is to lift."""
        if self.law == "DWL" and self.lift != 0:
            yield DesignError("lift", AT_REST.words, 0.0)
