"""Phases of an axis as they are entered."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

from workbook.book.limits import RowRule
from workbook.book.sentence import figure
from workbook.fields.types import DesignError, EntryError, Model, NotNegative, Number
from workbook.laws.entries import LawName, Laws

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


NO_LINE = 'a velocity or acceleration is entered; expected a straight line among the laws: [laws.LIN] family = "LIN"'


def require_straight(laws: Laws, phases: Mapping[str, Sequence[AxisPhase]]) -> None:
    """Raise EntryError for a velocity or acceleration that is entered in a book without straight lines."""
    for key, rows in phases.items():
        for i, phase in enumerate(rows):
            if phase.passes and not laws.of("LIN"):
                raise EntryError(f"{key}.{i}", NO_LINE)


def forward(name: str, phases: Sequence[AxisPhase], unit: str = "°", length: float = TURN) -> Iterator[DesignError]:
    """Yield the first phase of an axis that runs backwards, or does not last, of a cycle of a length."""
    for row, phase in enumerate(phases, 1):
        if phase.stop <= phase.start:
            short = phase.start - phase.stop
            message = f"{name} row {row} ends at {figure(phase.stop)}{unit}, {figure(short)}{unit} before it begins"
            yield DesignError("phases", message, filling(phases, length))
            return


def filling(phases: Sequence[AxisPhase], length: float = TURN) -> list[dict[str, Any]]:
    """Return the phases, evenly spread over the cycle."""
    step = length / len(phases)
    ends = pairwise([*(i * step for i in range(len(phases))), length])
    return [
        phase.model_dump() | {"start": start, "stop": stop} for phase, (start, stop) in zip(phases, ends, strict=True)
    ]
