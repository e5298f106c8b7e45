"""A workbook in memory, into which a mutant is put, judged, and taken out again."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from openpyxl import Workbook
from openpyxl.workbook.defined_name import DefinedName

from tests.mutation.mutants import Mutant, Orchard
from tests.workbook.cells import opened
from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.book.formula import Area, Formula
from workbook.entries.machine import Machine
from workbook.judging.comparison import TOLERANCE, ExpectedValues, difference
from workbook.judging.matching import Match, Pair, is_formula
from workbook.judging.verify import Report, judge
from workbook.machines.machine.mechanism import LINKED
from workbook.reading.descriptions import read_machine
from workbook.reading.files import BookFile, find_places
from workbook.templates import Template
from workbook.witnesses.pycel.model import PycelModel

SMALL = {"cycle": 24, "law": 8}


@dataclass(frozen=True)
class Inputs:
    """One set of inputs: what every cell of the book holds or should compute, and the peak of every cell's column."""

    cells: dict[Address, Any]
    expected: dict[Address, Any]
    peaks: dict[Address, float]


def sized(template: Template, **sizes: int) -> Machine:
    """Return the committed machine of a template with smaller tables."""
    return smaller(read_machine(template.description), **sizes)


def smaller(machine: Machine, **sizes: int) -> Machine:
    """Return a machine with smaller tables, of its catalogues some products, and of its drives only some."""
    data = machine.model_dump()
    data["sizes"] |= SMALL | sizes
    if "selection" in data:
        chosen = data["selection"]
        chosen["motors"], chosen["reducers"] = chosen["motors"][::6], chosen["reducers"][:1] + chosen["reducers"][1::4]
        data["sizes"] |= {name: len(chosen[name]) + 1 for name in ("motors", "reducers")}
    if machine.template == "machine":
        thin_out(data)
        data["sizes"] |= sizes
    return type(machine).model_validate(data)


def thin_out(data: dict[str, Any]) -> None:
    """Leave a machine all its linkages, of its other drives the one that Selection looks at, and fewer rows.

    A drive has as many cells as the whole book of another template.
    """
    constant = [axis for axis in data["axes"] if axis["mechanism"] and axis["mechanism"]["kind"] not in LINKED]
    kept = data["selection"]["axis"] or next((axis["name"] for axis in constant), None)
    for axis in constant:
        for entry in ("mechanism", "load", "parts", "motor", "reducer") if axis["name"] != kept else ():
            del axis[entry]
    phases = max(4, *(len(axis["phases"]) for axis in data["axes"]))
    data["sizes"] |= {"phases": phases, "pieces": 7, "motion_pieces": None}


def remembered(declare: Callable[[Machine], Book]) -> Callable[[Machine], Book]:
    """Return ``declare`` with a memory: a thousand mutants of one book need its declarations once."""
    books: dict[str, Book] = {}

    def found(machine: Machine) -> Book:
        if machine.design.replaced:  # its book is changed afterwards
            return declare(machine)
        key = machine.model_dump_json()
        if key not in books:
            books[key] = declare(machine)
        return books[key]

    return found


class OfValues(Report):
    """A report that leaves the text of formulas aside, so that values alone must tell."""

    def add(self, pair: Pair, kind: str, *said: Any, **more: Any) -> None:
        """Enter a finding on a declared cell."""
        if kind != "formula":
            super().add(pair, kind, *said, **more)


class Bench:
    """The book of one machine, and the inputs at which ``verify`` looks at it: those entered, then its variations."""

    def __init__(self, template: Template, machine: Machine) -> None:
        self.template, self.machine = replace(template, declare_complete=remembered(template.declare_complete)), machine
        self.declared = self.template.declare(machine)
        self.workbook = opened(self.declared, type(machine))
        self.file = BookFile(Path(f"{template.name}.xlsx"), self.workbook, find_places(self.workbook))
        self.match = Match(self.file, self.declared)
        self.pairs = {pair.address: pair for pair in self.match.pairs}
        self.targets = dict(self.declared.names())
        self.model = PycelModel(self.workbook)
        self.orchard = Orchard(self.declared)

    @cached_property
    def sets(self) -> list[Inputs]:
        """The sets of inputs at which ``verify`` looks."""
        variations = self.template.variants(self.machine)
        return [self.inputs(self.machine), *(self.inputs(m, assumed=True) for m in variations)]

    def inputs(self, machine: Machine, assumed: bool = False) -> Inputs:
        """Return a set of inputs from a machine of the same layout; ``assumed``: formula cells hold what they should.

        Else they hold what they compute, so that rounding is what it is in the book.
        """
        right = ExpectedValues(self.match, self.template.declare(machine))
        expected = {a: right.get(a) for a, p in self.pairs.items() if p.declared_formula}
        given = {a: right.get(a) for a, p in self.pairs.items() if p.cell.quantity.role == "input"}
        computed = expected if assumed else self.model.evaluate(given)
        return Inputs(self.model.constants | given | computed, expected, {a: right.peak(a) for a in self.pairs})

    def other_shape(self, mutant: Mutant) -> bool:
        """Whether the formula's text alone gives the mutant away."""
        if not is_formula(mutant.mutated):
            return True
        cell, address = self.pairs[mutant.address].cell, mutant.address
        return not self.match.same_formula(cell.content, cell.block, mutant.mutated, address.sheet)

    def differs_at(self, mutant: Mutant, sets: list[Inputs] | None = None) -> int | None:
        """Return the number of the first set of inputs at which the cell computes another value, if any.

        Only the one cell is evaluated, with the right values in all others: what ``verify`` finds of a cell's own
        fault, without the time that all other cells take.
        """
        formula = self.read(mutant) if is_formula(mutant.mutated) else None
        for n, at in enumerate(self.sets if sets is None else sets):
            computed = evaluated(mutant.address, formula, at.cells) if formula else mutant.mutated
            if not self.agrees(mutant.address, computed, at):
                return n
        return None

    def agrees(self, address: Address, computed: Any, at: Inputs) -> bool:
        """Whether a cell's value is the engine's, as ``verify`` measures it."""
        return difference(computed, at.expected[address], at.peaks[address]) <= TOLERANCE

    def verified(self, mutant: Mutant, kind: type[Report] = Report) -> Report:
        """Return what ``verify`` reports, in a report of a kind, of the book with the mutant in it."""
        report = kind(self.file.path, self.template.name)
        with self.holding(mutant):
            judge(replace(self.file), self.template, self.machine, report)  # its formulas read anew
        return report

    @contextmanager
    def holding(self, mutant: Mutant) -> Iterator[None]:
        """Put a mutant into the book, and the formula back afterwards."""
        cell = self.workbook[mutant.address.sheet].cell(mutant.address.row, mutant.address.column)
        cell.value = mutant.mutated
        try:
            yield
        finally:
            cell.value = mutant.original

    def read(self, mutant: Mutant) -> Formula | None:
        """Return the mutant as pycel's witness reads it; None where it cannot."""
        cell = self._blank[mutant.address.sheet].cell(mutant.address.row, mutant.address.column, mutant.mutated)
        try:
            return PycelModel(self._blank).formulas.get(mutant.address)
        finally:
            cell.value = None

    @cached_property
    def _blank(self) -> Workbook:
        """A book with the sheets and names of this one, and no cells."""
        blank = Workbook()
        blank.remove(blank.worksheets[0])
        for title in self.workbook.sheetnames:
            blank.create_sheet(title)
        for name, target in self.targets.items():
            blank.defined_names[name] = DefinedName(name, attr_text=target)
        return blank


def evaluated(address: Address, formula: Formula, cells: dict[Address, Any]) -> Any:
    """Return what a formula computes among cells of known values."""
    needed = {a for argument in formula.arguments if isinstance(argument, Area) for a in argument.cells()}
    known = {a: cells[a] for a in needed if a in cells}
    held = SimpleNamespace(constants=known, formulas={address: formula}, problems={}, failed={})
    return PycelModel(held).evaluate()[address]
