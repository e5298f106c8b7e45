"""pycel as a witness: its functions and operators, each shape compiled once, cells in an order without recursion."""

import sys
from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cache
from importlib.metadata import version
from types import MappingProxyType
from typing import Any

import numpy as np
from openpyxl import Workbook
from pycel.excelutil import AddressRange

from workbook.book.address import Address
from workbook.book.columns import Moved, Moving
from workbook.book.formula import Area, Formula, FormulaError, require_bounded
from workbook.errors import WitnessError
from workbook.reading.contents import Cells, Contents, plain_value
from workbook.reading.files import BookFile
from workbook.witnesses.pycel.compiled import (
    FormulaStep,
    Numbering,
    RangeStep,
    compiled,
    error_value,
    evaluation_order,
)
from workbook.witnesses.pycel.graph import CHANGES, Graph
from workbook.witnesses.pycel.limits import ArrayCells
from workbook.witnesses.witness import CYCLE, CellWitness, Model

PLAIN = frozenset((float, int, str, bool, type(None)))
UNKNOWN = object()  # the value of a range that is not filled
MOST_GROUPS = 64  # into which the cells of a range are parted at most, to see which alter what reads it
MOST_RANGE_CELLS = 4_000_000  # of all different ranges together


class Pycel(CellWitness):
    """The witness of that name."""

    name = "pycel"

    def version(self) -> str:
        """Return pycel's version and Python's, on which it rests."""
        return f"{version('pycel')} (Python {sys.version_info.major}.{sys.version_info.minor})"

    def model(self, file: BookFile, cells: Iterable[Address] = ()) -> Model:
        """Return the formulas of a file, to be evaluated at other values, and cell by cell."""
        require_working()
        return PycelModel(file.contents, given=cells)


@cache
def require_working() -> None:
    """Raise WitnessError where pycel does not compute what is known: then no book is to blame for what it says."""
    known = Workbook()
    known.worksheets[0].append([3.0, "=IF(A1>2,SUM(A1:A2)-A1^2*0.5,0)"])
    model = PycelModel(known)
    ((cell, value),) = model.evaluate().items()
    if value != -1.5:
        why = model.problems.get(cell, f"it has {value!r} for -1.5")
        raise WitnessError(f"pycel {Pycel().version()} fails in a formula whose value is known: {why}")


class PycelModel:
    """A workbook's formulas, or those of ``cells``, joined once; ``problems`` says why a cell is an error or #CYCLE!.

    ``given`` are the cells whose values :meth:`each` is given.
    """

    def __init__(
        self, held: Workbook | Contents, cells: Collection[Address] | None = None, given: Iterable[Address] = ()
    ) -> None:
        contents = Contents(held) if isinstance(held, Workbook) else held
        self.problems: dict[Address, str] = dict(contents.problems)
        self.raised: set[Address] = set()  # cells in which pycel's own code failed
        self.constants, self.formulas, self._failed = contents.constants, contents.formulas, contents.failed
        if cells is not None:
            self.formulas = {cell: self.formulas[cell] for cell in cells if cell in self.formulas}
        self._entered = {address: plain_value(value) for address, value in (self.constants | self._failed).items()}
        self._numbers = Numbering()
        self._steps: dict[int, FormulaStep | RangeStep] = {}
        self._areas: dict[int, Area] = {}
        self._range_cells = 0
        self._latest: list[Any] = []  # values of the last evaluation of what the cells hold
        self._changed: set[int] = set()  # what was entered since
        for address, value in self._entered.items():
            self._numbers.cell(address, value)
        self._cells = {self._numbers.cell(address): address for address in self.formulas}
        self._given = [self._numbers.cell(address) for address in given]
        self._filled = len(self._numbers.values)  # how many numbers there were when ranges were filled
        for number, address in self._cells.items():
            self._join(number, address, self.formulas[address])
        self._order, self._cyclic = evaluation_order({number: step.sources for number, step in self._steps.items()})
        for number, need in self._cyclic.items():
            self._numbers.values[number] = CYCLE
            if number in self._cells:
                through = self._cells.get(need) or self._areas[need].a1
                self.problems[self._cells[number]] = f"the cell depends on itself, through {through}"

    @property
    def order(self) -> list[Address]:
        """The formula cells, each after those that it needs."""
        return [self._cells[number] for number in self._order if number in self._cells]

    def enter(self, contents: Cells) -> None:
        """Take other contents of cells without formulas, for all that is evaluated from now on."""
        for address, content in contents.items():
            number, value = self._numbers.cell(address), plain_value(content)
            self._entered[address] = self._numbers.values[number] = value
            self._changed.add(number)
            if self._latest and number < len(self._latest):
                self._latest[number] = value
            else:
                self._latest = []

    @np.errstate(all="ignore")  # what is not finite is worked out again, by elements
    def evaluate(self, inputs: Mapping[Address, Any] | None = None) -> Cells:
        """Return the value of every formula cell; ``inputs`` stand in for what cells hold, in this evaluation only.

        Without ``inputs``, only what depends on contents that were entered since the last evaluation is worked out.
        """
        if self._latest and not inputs:
            return self._evaluate_changed(self._latest)
        values = self.numbered(inputs or {})
        if not inputs:
            self._latest = values
            self._changed.clear()
        return self._by_address(values)

    @np.errstate(all="ignore")
    def numbered(self, inputs: Mapping[Address, Any]) -> list[Any]:
        """Return the values of all cells and ranges, by number, with ``inputs`` in place of what cells hold."""
        given = {self._numbers.cell(address): plain_value(value) for address, value in inputs.items()}
        if len(self._numbers.values) > self._filled and (given or self._changed):  # ranges may have passed over these
            self._filled = len(self._numbers.values)
            for number, area in self._areas.items():
                self._fill(number, area)
        values = list(self._numbers.values)
        ArrayCells.cells = 0
        self.raised.clear()
        for number, value in given.items():
            values[number] = value
        for number in self._order:
            if number not in given:
                values[number] = self._result(number, values)
        return values

    def graph(self, also: Mapping[Address, Iterable[Area]] = MappingProxyType({})) -> Graph:
        """Return the graph of cells and ranges; ``also`` are areas that formulas read which cannot be taken apart."""
        reads: dict[int, Sequence[int]] = {number: step.sources for number, step in self._steps.items()}
        others = {a: self.formulas[a].arguments for number, a in self._cells.items() if number not in reads}
        within = cache(self._numbers.within)
        for address, areas in (others | dict(also)).items():
            held = (number for area in areas if isinstance(area, Area) for number in within(area))
            reads[self._numbers.cell(address)] = list(held)
        cells = {self._numbers.cell(address): address for address in (*self.constants, *also)}
        return Graph(reads, cells | self._cells, frozenset(self._areas))

    @np.errstate(all="ignore")
    def alters(self, number: int, among: Collection[int], values: list[Any]) -> set[int]:
        """Return those cells ``among`` whose change alters the formula cell ``number`` by itself, at ``values``."""
        step = self._steps[number]
        right, altering = self._by_itself(number, values), set[int]()
        for source in step.sources:
            inner = self._steps.get(source)
            cells = [cell for cell in (inner.sources if isinstance(inner, RangeStep) else [source]) if cell in among]
            smallest = -(-len(cells) // MOST_GROUPS)  # of a long range cells are changed together
            left = [cells] if cells else []
            while left:
                group = left.pop()
                tried = ({cell: change(values[cell], at) for at, cell in enumerate(group)} for change in CHANGES)
                if any(self._changed_by(number, source, changed, values) != right for changed in tried):
                    if len(group) <= smallest:
                        altering |= {*group}
                    else:
                        left += [group[: len(group) // 2], group[len(group) // 2 :]]
        return altering

    def _changed_by(self, number: int, source: int, changed: Mapping[int, Any], values: list[Any]) -> Any:
        """Return the value of a formula cell with other values in the cells of one of its sources."""
        held = {cell: values[cell] for cell in (*changed, source)}
        try:
            for cell, value in changed.items():
                values[cell] = value
            if source not in changed:
                values[source] = self._steps[source].compute(values)
            return self._by_itself(number, values)
        finally:
            for cell, value in held.items():
                values[cell] = value

    def _evaluate_changed(self, values: list[Any]) -> Cells:
        """Return the value of every formula cell, worked out anew where it depends on what was entered."""
        changed, self._changed = self._changed, set()
        ArrayCells.cells = 0
        for number in self._order if changed else ():
            if not changed.isdisjoint(self._steps[number].sources):
                before, values[number] = values[number], self._result(number, values)
                if not before or before != values[number] or type(before) is not type(values[number]):  # -0.0 is 0.0
                    changed.add(number)
        return self._by_address(values)

    def _by_address(self, values: Sequence[Any]) -> Cells:
        return self._failed | {address: values[number] for number, address in self._cells.items()}

    @np.errstate(all="ignore")
    def each(self, wanted: Sequence[int], values: Sequence[Any]) -> list[Any]:
        """Return the values of formula cells, each by itself: with the right ones around it."""
        known = list(self._numbers.values)  # without formulas: each is what its cell holds
        for number, address in self._cells.items():
            known[number] = self._entered.get(address)
        for number in self._areas:
            known[number] = UNKNOWN
        for number, value in zip(self._given, values, strict=True):
            known[number] = value if type(value) in PLAIN else plain_value(value)
        ArrayCells.cells = 0
        return [self._by_itself(self._given[n], known) for n in wanted]

    def _by_itself(self, number: int, values: list[Any]) -> Any:
        """Return the value of a formula cell from the values known; ranges are entered among these."""
        step = self._steps.get(number)
        if step is None:  # it could not be joined
            return self._numbers.values[number]
        for source in step.sources:
            if values[source] is UNKNOWN:
                values[source] = self._steps[source].compute(values)
        try:
            return step.compute(values)
        except Exception as error:  # pycel's functions raise whatever Python raises
            return error_value(error)

    def _join(self, number: int, address: Address, formula: Formula | Moved) -> None:
        call = compiled(formula.shape)
        try:
            if isinstance(call, FormulaError):
                raise call
            moved, row = (formula.pattern, formula.row) if isinstance(formula, Moved) else (formula, 0)
            pairs = zip(call.dummies, moved.arguments, strict=True)
            sources = [self._source(argument, row, dummy in call.addresses) for dummy, argument in pairs]
            self._steps[number] = FormulaStep(call, sources)
        except FormulaError as error:
            self._numbers.values[number] = error.value
            self.problems[address] = str(error)

    def _source(self, argument: Area | str | Moving, row: int, address: bool) -> int:
        """Return the number of an argument of a row's formula, or of its address, for functions that ask for it."""
        if isinstance(argument, Moving):
            area, top, _ = argument
            if area.single and top is not None and not address:
                value = self._numbers.column(area.sheet, area.left).get(row + top)
                if value:
                    return value
            argument = argument.at(row)
        if isinstance(argument, str):
            if address:
                raise FormulaError("#VALUE!", "a reference is expected, not a text")
            return self._numbers.other(("text", argument), argument)
        if address:
            return self._numbers.other(("address", argument.a1), AddressRange.create(argument.a1))
        if argument.single:
            known = self._numbers.column(argument.sheet, argument.left)
            return known.get(argument.top) or self._numbers.cell(argument.first)
        number = self._numbers.other(argument)
        if number not in self._areas:
            self._range_cells += require_bounded(argument, argument.a1).size
            if self._range_cells > MOST_RANGE_CELLS:
                raise FormulaError("#REF!", f"the ranges of this workbook hold over {MOST_RANGE_CELLS:,} cells")
            self._areas[number] = argument
            self._fill(number, argument)
        return number

    def _fill(self, number: int, area: Area) -> None:
        columns = [self._numbers.column(area.sheet, c) for c in range(area.left, area.right + 1)]
        cells = [rows.get(row, 0) for row in range(area.top, area.bottom + 1) for rows in columns]
        self._steps[number] = RangeStep(cells, len(columns))

    def _result(self, number: int, values: list[Any]) -> Any:
        """Return the value of a step in an evaluation of the whole, and note the reason where it has none."""
        step, address, problem = self._steps[number], self._cells.get(number), ""
        result: Any
        if address and self.raised:
            self.raised.discard(address)
        if self._cyclic and CYCLE in map(values.__getitem__, step.sources):
            result, problem = CYCLE, "the cell depends on cells that depend on themselves"
        else:
            try:
                result = step.compute(values)
            except Exception as error:  # pycel's functions raise whatever Python raises
                result = error_value(error)
                problem = "" if result == "#NUM!" else f"pycel: {type(error).__name__}: {str(error)[:120]}"
                if address and problem:
                    self.raised.add(address)
        if address and number not in self._cyclic:  # a problem of an evaluation before is taken back
            if problem:
                self.problems[address] = problem
            elif self.problems:
                self.problems.pop(address, None)
        return result
