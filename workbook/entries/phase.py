"""A phase as entered wherever phases follow one another: a law over a lift in a duration."""

from __future__ import annotations

from collections.abc import Iterator

from workbook.book.limits import RowRule
from workbook.entries.types import DesignError, Model, Number, Positive
from workbook.laws.entries import LawName


class PhaseEntry(Model):
    """One phase: a law, carried out over a lift in a duration, in the units of the motion."""

    law: LawName = "DWL"
    lift: Number = 0.0
    duration: Positive

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a dwell that is to lift."""
        yield from resting(self.law, self.lift)


AT_REST = RowRule(
    "dwell", 'OR(AND([law]<>"DWL",[law]<>""),[lift]+0=0)', "lift", "lift of a dwell or without a law"
)  # fmt: skip
"""a row of phases whose law is the dwell, or that names none, does not lift"""


def resting(law: str, lift: float) -> Iterator[DesignError]:
    """Yield a dwell that is to lift."""
    if law == "DWL" and lift != 0:
        yield DesignError("lift", AT_REST.words, AT_REST.rule, 0.0)
