"""The report on a workbook; faults beside wrong values: units, numbers in place of formulas, empty cells."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Literal

from workbook.book.address import Address
from workbook.book.columns import tree
from workbook.book.formula import Area, FormulaError
from workbook.book.rows import is_number
from workbook.dimensions.rules import Dimensions
from workbook.dimensions.units import POWERS
from workbook.oracle.cells import label_of, unit_of
from workbook.reading.files import BookFile

Coverage = Literal["compared", "step", "unaccounted"]
State = Literal["agrees", "differs", "disputed", "cannot"]
# of units: powers and products as people write them
SPELLINGS = POWERS | str.maketrans("µ", "μ", "·*^. -()[]")
# they take empty cells
BLANK = frozenset(["ISBLANK", "COUNTA", "COUNT", "COUNTIF", "COUNTBLANK", "SUM", "SUMIF"])


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


def replaced_formulas(file: BookFile, sheets: Collection[str], inputs: Sequence[Address]) -> Iterator[Fault]:
    """Yield the numbers that stand where the cells above and below have the same formula, inputs aside."""
    formulas = file.contents.formulas
    for cell, value in file.contents.constants.items():
        above, below = (formulas.get(cell._replace(row=cell.row + step)) for step in (-1, 1))
        alike = above is not None and below is not None and above.shape == below.shape
        if alike and is_number(value) and cell.sheet in sheets and cell not in inputs:
            yield Fault(cell, "replaced", value, "a formula, as above and below it")


def empty_cells(file: BookFile, counted: Collection[Address]) -> Iterator[Fault]:
    """Yield the empty cells with which a formula computes, each with the first such formula."""
    contents, readers = file.contents, dict[Address, Address]()
    filled = {*contents.formula_cells, *(cell for cell, value in contents.constants.items() if value is not None)}
    for cell in contents.formulas.keys() & counted:
        formula = contents.formulas[cell]
        handled = not BLANK.isdisjoint(formula.functions) or "" in formula.arguments
        for area in () if handled else (formula.arguments[at] for at in operands(formula.shape)):
            if isinstance(area, Area) and area.single and area.first not in filled:
                readers[area.first] = min(cell, readers.get(area.first, cell))
    yield from (Fault(cell, "empty", None, f"a value: {reader} reads it") for cell, reader in sorted(readers.items()))


@cache
def operands(shape: str) -> frozenset[int]:
    """Return the arguments of a shape that stand in a sum, a product or a power by themselves, by number."""
    try:
        left, numbers = [tree(shape)], set[int]()
    except (FormulaError, RecursionError):
        return frozenset()
    while left:
        node = left.pop()
        left += node.parts
        if node.kind == "operation" and node.value in "±+-*/^":
            numbers |= {int(part.value) for part in node.parts if part.kind == "argument"}
    return frozenset(numbers)


def describe(file: BookFile, cell: Address) -> str:
    """Return a cell with the label beside it."""
    label = label_of(file, cell)
    return f"{cell} ({label})" if label else str(cell)


def normalised_unit(unit: str) -> str:
    """Return a unit without what is written in different ways: blanks, brackets, powers, products."""
    text = unit.translate(SPELLINGS)
    return text.casefold() if len(text) > 2 and text.isalpha() else text
