"""The dimensions of a workbook's cells: units where they are known, and what follows from them where they are not."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from workbook.book.address import Address
from workbook.book.columns import Moved
from workbook.book.formula import Area, Formula, FormulaError
from workbook.dimensions.rules import FREE, UNKNOWN, Reading, Term
from workbook.dimensions.tree import tree
from workbook.dimensions.units import Dimension, dimension_of, is_either, written
from workbook.reading.contents import Contents


@dataclass
class Dimensions:
    """What came of it: what cannot be, in words, by cell; and how many formula cells have a known dimension."""

    wrong: dict[Address, str] = field(default_factory=dict)
    formulas: int = 0
    known: int = 0


def dimensions(contents: Contents, order: Iterable[Address], units: Mapping[Address, str]) -> Dimensions:
    """Run ``units`` through formulas, each behind those that it needs; a cell with a unit has its dimension."""
    return Walk(contents, units).walk(order)


class Walk:
    """The terms of cells met so far."""

    def __init__(self, contents: Contents, units: Mapping[Address, str]) -> None:
        self.contents, self.units = contents, units
        self.terms: dict[Address, Term] = {}
        self.areas: dict[Area, Term] = {}
        for cell, unit in units.items():
            found = dimension_of(unit)
            if is_either(unit):
                self.terms[cell] = UNKNOWN
            elif found is not None and not isinstance(contents.constants.get(cell), str):
                self.terms[cell] = Term(found)

    def walk(self, order: Iterable[Address]) -> Dimensions:
        """Return what came of all formulas."""
        found = Dimensions()
        for cell in order:
            made, wrong = self.formula(self.contents.formulas[cell])
            label = self.terms.setdefault(cell, made).dimension
            if label is not None and made.dimension is not None and made.dimension != label:
                wrong.append(f"{written(made.dimension)} where the unit says {written(label)}")
            if wrong and not is_either(self.units.get(cell, "")):
                found.wrong[cell] = "; ".join(dict.fromkeys(wrong))
            found.formulas += 1
            found.known += made.dimension is not None or made.free
        return found

    def formula(self, formula: Formula | Moved) -> tuple[Term, list[str]]:
        """Return the term that a formula gives, and what in it cannot be."""
        reading = Reading([self.argument(one) for one in formula.arguments])
        try:
            return reading.of(tree(formula.shape)), reading.wrong
        except (FormulaError, RecursionError):
            return UNKNOWN, []

    def argument(self, one: Area | str) -> Term:
        """Return the term of a text, a cell or a range."""
        if isinstance(one, str):
            return FREE
        if one.size == 1:
            return self.cell(one.first)
        if one not in self.areas:
            self.areas[one] = self.range(one)
        return self.areas[one]

    def range(self, one: Area) -> Term:
        """Return the term of a range: unknown where that of one of its cells is."""
        found: dict[Dimension, None] = {}
        for cell in one.cells():
            term = self.cell(cell)
            if term.dimension is None and not term.free:
                return UNKNOWN
            if term.dimension is not None:
                found[term.dimension] = None
        return Term(next(iter(found))) if len(found) == 1 else Term(several=tuple(found)) if found else FREE

    def cell(self, cell: Address) -> Term:
        """Return the term of a cell; texts and empty cells go with any."""
        if cell in self.terms:
            return self.terms[cell]
        held = self.contents.constants.get(cell)
        return FREE if cell not in self.contents.formulas and (held is None or isinstance(held, str)) else UNKNOWN
