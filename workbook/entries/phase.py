"""Rules of a phase as it is entered wherever phases follow one another."""

from collections.abc import Iterator, Mapping, Sequence

from pydantic import Field

from workbook.book.limits import RowRule
from workbook.entries.types import DesignError, EntryError, Model, Number
from workbook.laws.entries import Laws


class Passing(Model):
    """What a phase passes its begin with, between two curved phases, in the units of the motion; else 0."""

    velocity: Number | None = Field(None, description="y' with which two curved phases meet at its start; else 0")
    acceleration: Number | None = Field(None, description="y'' with which two curved phases meet at its start; else 0")

    @property
    def passes(self) -> bool:
        """Whether any of them is entered."""
        return self.velocity is not None or self.acceleration is not None


NO_LINE = 'a velocity or acceleration is entered; expected a straight line among the laws: [laws.LIN] family = "LIN"'


def require_straight(laws: Laws, phases: Mapping[str, Sequence[Passing]]) -> None:
    """Raise EntryError for a velocity or acceleration that is entered in a book without straight lines."""
    for key, rows in phases.items():
        for i, phase in enumerate(rows):
            if phase.passes and not laws.of("LIN"):
                raise EntryError(f"{key}.{i}", NO_LINE)


AT_REST = RowRule("dwell", 'OR(AND([law]<>"DWL",[law]<>""),[lift]+0=0)', "lift",
                  "lift of a dwell or without a law")  # fmt: skip
"""a row of phases whose law is the dwell, or that names none, does not lift"""


def resting(law: str, lift: float) -> Iterator[DesignError]:
    """Yield a dwell that is to lift."""
    if law == "DWL" and lift != 0:
        yield DesignError("lift", AT_REST.words, AT_REST.rule, 0.0)
