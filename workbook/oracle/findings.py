"""The report on a workbook; units beside cells that are others than declared."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from workbook.book.address import Address
from workbook.dimensions.rules import Dimensions
from workbook.dimensions.units import POWERS
from workbook.oracle.cells import label_of, unit_of
from workbook.reading.files import BookFile

Coverage = Literal["compared", "step", "unaccounted"]
State = Literal["agrees", "differs", "disputed", "cannot"]
# of units: powers and products as people write them
SPELLINGS = POWERS | str.maketrans("µ", "μ", "·*^. -()[]")


@dataclass(frozen=True)
class Fault:
    """A fault of a cell: its kind, the value and the expected value, and the inputs at which they differ."""

    cell: Address
    kind: str
    found: Any
    expected: Any
    at: str = ""


@dataclass
class OracleReport:
    """The result of a comparison: findings, cases, notes, dimensions, and the class of each formula cell.

    ``warnings`` are the cells of which evaluators disagree; ``unusable`` are lines on functions of the declarations.
    """

    cases: int
    wrong: list[Fault] = field(default_factory=list)
    warnings: list[Fault] = field(default_factory=list)
    unusable: list[str] = field(default_factory=list)
    states: dict[Address, State] = field(default_factory=dict)
    evaluators: dict[Address, str] = field(default_factory=dict)  # by which each formula cell was computed
    coverage: dict[Address, Coverage] = field(default_factory=dict)
    dimensions: Dimensions = field(default_factory=Dimensions)
    notes: list[str] = field(default_factory=list)

    def count(self, kind: Coverage) -> int:
        """Return the number of formula cells of a class."""
        return sum(coverage == kind for coverage in self.coverage.values())

    @property
    def covered(self) -> float:
        """The share of formula cells that are compared or are steps to such, in per cent."""
        return 100.0 * (1.0 - self.count("unaccounted") / len(self.coverage)) if self.coverage else 100.0


def other_units(file: BookFile, units: Mapping[Address, str]) -> Iterator[Fault]:
    """Yield the cells beside which another unit stands than is declared."""
    for cell, unit in units.items():
        beside = unit_of(file, cell)
        if unit and beside and normalised_unit(beside) != normalised_unit(unit):
            yield Fault(cell, "unit", beside, unit)


def describe(file: BookFile, cell: Address) -> str:
    """Return a cell with the label beside it."""
    label = label_of(file, cell)
    return f"{cell} ({label})" if label else str(cell)


def normalised_unit(unit: str) -> str:
    """Return a unit without what is written in different ways: blanks, brackets, powers, products."""
    text = unit.translate(SPELLINGS)
    return text.casefold() if len(text) > 2 and text.isalpha() else text
