"""What is wrong in a workbook whatever its formulas should compute: saved values, gaps, units, dimensions."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from workbook.book.address import Address
from workbook.book.formula import Area
from workbook.dimensions.rules import Dimensions, Walk
from workbook.dimensions.units import POWERS
from workbook.oracle.cells import unit_of
from workbook.oracle.declared import is_number, same
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.agreed import UNKNOWN

SPELLINGS = POWERS | str.maketrans("µ", "μ", "·*^. -()[]")  # of units: powers and products as people write them
BLANK = frozenset(["ISBLANK", "COUNTA", "COUNT", "COUNTIF", "COUNTBLANK", "SUM", "SUMIF"])  # they take empty cells


@dataclass(frozen=True)
class Wrong:
    """What is wrong in a cell: the kind of fault, what was found and expected, and at which inputs."""

    cell: Address
    kind: str
    found: Any
    expected: Any
    at: str = ""


class Looks:
    """A workbook in which ``counted`` are the formula cells that are looked at, ``units`` those that are declared."""

    def __init__(self, file: BookFile, counted: Collection[Address], units: Mapping[Address, str]) -> None:
        self.file, self.counted, self.units = file, set(counted), units
        self.sheets = {cell.sheet for cell in counted}

    def wrong(self, values: Cells, inputs: Collection[Address]) -> Iterator[Wrong]:
        """Yield stale saved values, unread inputs, other units beside cells, numbers in place of formulas, gaps."""
        for cell, saved in self.file.saved.items():
            found = values.get(cell)
            if cell in self.counted and saved is not None and found not in UNKNOWN and not same(saved, found):
                yield Wrong(cell, "saved", saved, found)
        read = self.file.contents.read(inputs)
        yield from (Wrong(cell, "unread", None, "a formula that reads it") for cell in inputs if cell not in read)
        for cell, unit in self.units.items():
            beside = unit_of(self.file, cell)
            if unit and beside and spelled(beside) != spelled(unit):
                yield Wrong(cell, "unit", beside, unit)
        formulas = self.file.contents.formulas
        for cell, value in self.file.contents.constants.items():  # numbers between two formulas that are alike
            above, below = (formulas.get(cell._replace(row=cell.row + step)) for step in (-1, 1))
            alike = above is not None and below is not None and above.shape == below.shape
            if alike and is_number(value) and cell.sheet in self.sheets and cell not in inputs:
                yield Wrong(cell, "replaced", value, "a formula, as above and below it")
        yield from self.empty()

    def empty(self) -> Iterator[Wrong]:
        """Yield the empty cells that a formula reads by themselves, each with the first such formula."""
        contents, found = self.file.contents, dict[Address, Address]()
        filled = {*contents.formula_cells, *(cell for cell, value in contents.constants.items() if value is not None)}
        for cell in self.counted & contents.formulas.keys():
            formula = contents.formulas[cell]
            for one in formula.arguments if BLANK.isdisjoint(formula.functions) and "" not in formula.arguments else ():
                if isinstance(one, Area) and one.single and one.first not in filled:
                    found[one.first] = min(cell, found.get(one.first, cell))
        yield from (Wrong(cell, "empty", None, f"a value: {reader} reads it") for cell, reader in sorted(found.items()))

    def dimensions(self, order: Collection[Address]) -> Dimensions:
        """Return what cannot be by the units: those declared, and those beside the cells of the same sheets."""
        contents = self.file.contents
        cells = (cell for cell in [*contents.formulas, *contents.constants] if cell.sheet in self.sheets)
        beside = {cell: unit for cell in cells if (unit := unit_of(self.file, cell))}
        declared = {cell: unit for cell, unit in self.units.items() if unit}
        return Walk(contents, beside | declared).walk(cell for cell in order if cell in self.counted)


def spelled(unit: str) -> str:
    """Return a unit without what is written in different ways: blanks, brackets, powers, products."""
    text = unit.translate(SPELLINGS)
    return text.casefold() if len(text) > 2 and text.isalpha() else text
