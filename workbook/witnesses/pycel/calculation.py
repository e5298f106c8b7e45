"""A workbook's formulas joined and evaluated: all of them in order, or some of them each by itself."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np
from pycel.excelutil import AddressRange

from workbook.book.address import Address, Strip
from workbook.book.columns import Moved, Moving, Pattern
from workbook.book.formula import Area, Formula, FormulaError, bounded
from workbook.reading.contents import entered
from workbook.witnesses.pycel.arrays import Known
from workbook.witnesses.pycel.compiled import Compiled, compiled
from workbook.witnesses.pycel.limits import Crossed
from workbook.witnesses.pycel.steps import FormulaStep, Numbering, RangeStep, ordered
from workbook.witnesses.witness import CYCLE

Followed = tuple[dict[int, int] | None, int, Any]  # rows of a column, offset, argument; or None and its number
PLAIN = frozenset((float, int, str, bool, type(None)))
UNKNOWN = object()  # the value of a range that is not filled
MOST_RANGE_CELLS = 4_000_000  # of all different ranges together


class Calculation:
    """Formulas and the cells they refer to; ``problems`` is told in a line why a cell could not be evaluated.

    Everything that has a value (a cell, a range, a text in a formula) is known by its number.
    """

    def __init__(
        self,
        constants: Mapping[Address, Any],
        formulas: Mapping[Address, Formula | Moved],
        problems: dict[Address, str],
    ) -> None:
        self.problems = problems
        self._constants = {address: entered(value) for address, value in constants.items()}
        self._numbers = Numbering()
        self._steps: dict[int, FormulaStep | RangeStep] = {}
        self._areas: dict[int, Area] = {}
        self._followed: dict[int, list[Followed]] = {}  # of a pattern, by its identity
        self._range_cells = 0
        self._strips: Sequence[Strip] | None = None  # those asked for last, and the numbers of their cells
        self._strip_cells: list[int] = []
        for address, value in self._constants.items():
            self._numbers.cell(address, value)
        self._formulas = {self._numbers.cell(address): address for address in formulas}
        self._occupied, self._held = len(self._numbers.values), set[int]()
        for number, address in self._formulas.items():
            self._join(number, address, formulas[address])
        self._order, cycles = ordered({number: step.sources for number, step in self._steps.items()})
        self._cyclic = self._note_cycles(cycles)

    @property
    def order(self) -> list[Address]:
        """The formula cells, each after what it needs."""
        return [self._formulas[number] for number in self._order if number in self._formulas]

    @np.errstate(all="ignore")  # what is not finite is worked out again, by elements
    def evaluate(self, inputs: Mapping[Address, Any] | None = None) -> dict[Address, Any]:
        """Return the value of every formula cell; ``inputs`` stand in for what cells hold, in this evaluation only."""
        given = inputs or {}
        numbers = list(map(self._numbers.cell, given))
        self._hold(numbers)
        values = list(self._numbers.values)
        begin()
        for number, value in zip(numbers, given.values(), strict=True):
            values[number] = entered(value)
        fixed = set(numbers)
        for number in self._order:
            if number not in fixed:
                values[number] = self._result(number, values)
        return {address: values[number] for number, address in self._formulas.items()}

    @np.errstate(all="ignore")
    def each(self, wanted: Sequence[int], strips: Sequence[Strip], values: Sequence[Any]) -> list[Any]:
        """Return the values of formula cells, each by itself, with ``values`` in the cells of ``strips``.

        ``wanted`` are the numbers of the cells within ``strips``.
        """
        cells, known = self._within(strips), self._bare()
        for number, value in zip(cells, values, strict=True):
            known[number] = value if type(value) in PLAIN else entered(value)
        begin()
        return [self._by_itself(cells[n], known) for n in wanted]

    def _by_itself(self, number: int, values: list[Any]) -> Any:
        """Return what a formula cell computes of the values known; ranges are entered among these."""
        step = self._steps.get(number)
        if step is None:  # it could not be joined
            return self._numbers.values[number]
        for source in step.sources:
            if values[source] is UNKNOWN:
                values[source] = self._steps[source].compute(values)
        try:
            return step.compute(values)
        except Exception as error:  # pycel's functions raise whatever Python raises
            return fault(error)

    def _bare(self) -> list[Any]:
        """Return what all that has a number is without formulas; ranges are not known."""
        values = list(self._numbers.values)
        for number, address in self._formulas.items():
            values[number] = self._constants.get(address)
        for number in self._areas:
            values[number] = UNKNOWN
        return values

    def _within(self, strips: Sequence[Strip]) -> list[int]:
        """Return the numbers of the cells of strips; ranges that passed over one as empty now hold it."""
        if strips is not self._strips:
            columns = [(sheet, c, self._numbers.column(sheet, c), rows) for sheet, c, rows in strips]
            cells = [
                known.get(row) or self._numbers.cell(Address(sheet, row, column))
                for sheet, column, known, rows in columns
                for row in rows
            ]
            self._hold(cells)
            self._strips, self._strip_cells = strips, cells
        return self._strip_cells

    def _hold(self, numbers: Collection[int]) -> None:
        """Let ranges that may have passed over cells as empty hold them."""
        empty = {number for number in numbers if number >= self._occupied} - self._held
        self._held |= empty
        rows: dict[tuple[str, int], list[int]] = {}
        for sheet, row, column in map(self._numbers.cells.__getitem__, empty):
            rows.setdefault((sheet, column), []).append(row)
        for number, area in self._areas.items() if rows else ():
            columns = (rows.get((area.sheet, column), ()) for column in range(area.left, area.right + 1))
            if any(area.top <= row <= area.bottom for column in columns for row in column):
                self._fill(number, area)

    def _join(self, number: int, address: Address, formula: Formula | Moved) -> None:
        """Connect a formula with what it refers to."""
        call = compiled(formula.shape)
        try:
            if isinstance(call, FormulaError):
                raise call
            self._steps[number] = FormulaStep(call, self._sources(call, formula))
        except FormulaError as error:
            self._numbers.values[number] = error.value
            self.problems[address] = str(error)

    def _sources(self, call: Compiled, formula: Formula | Moved) -> list[int]:
        if call.addresses:
            return [
                self._address(a) if dummy in call.addresses else self._source(a)
                for dummy, a in zip(call.dummies, formula.arguments, strict=True)
            ]
        if not isinstance(formula, Moved):
            return [self._source(a) for a in formula.arguments]
        pattern, row = formula
        return [
            by if rows is None else rows.get(row + by) or self._source(argument.at(row))
            for rows, by, argument in self._followed.get(id(pattern)) or self._follow(pattern)
        ]

    def _follow(self, pattern: Pattern) -> list[Followed]:
        """Return where the arguments of a pattern are found: cells that move in their columns, all else by number."""

        def where(argument: Area | str | Moving) -> Followed:
            if not isinstance(argument, Moving):
                return None, self._source(argument), argument
            if argument.area.single and argument.top is not None:
                return self._numbers.column(argument.area.sheet, argument.area.left), argument.top, argument
            return {}, 0, argument

        found = self._followed[id(pattern)] = [where(argument) for argument in pattern.arguments]
        return found

    def _source(self, argument: Area | str) -> int:
        if isinstance(argument, str):
            return self._numbers.other(("text", argument), argument)
        if argument.single:
            return self._numbers.cell(argument.first)
        number = self._numbers.other(argument)
        if number not in self._areas:
            self._range_cells += bounded(argument, argument.a1).size
            if self._range_cells > MOST_RANGE_CELLS:
                raise FormulaError("#REF!", f"the ranges of this workbook hold over {MOST_RANGE_CELLS:,} cells")
            self._areas[number] = argument
            self._fill(number, argument)
        return number

    def _fill(self, number: int, area: Area) -> None:
        """Give a range the numbers of its cells."""
        columns = [self._numbers.column(area.sheet, c) for c in range(area.left, area.right + 1)]
        cells = [rows.get(row, 0) for row in range(area.top, area.bottom + 1) for rows in columns]
        self._steps[number] = RangeStep(cells, len(columns))

    def _address(self, argument: Area | str) -> int:
        """Return the number of an argument's address, for functions that ask for it."""
        if isinstance(argument, str):
            raise FormulaError("#VALUE!", "a reference is expected, not a text")
        return self._numbers.other(("address", argument.a1), AddressRange.create(argument.a1))

    def _note_cycles(self, cycles: Mapping[int, int]) -> set[int]:
        for number, need in cycles.items():
            self._numbers.values[number] = CYCLE
            if number in self._formulas:
                through = self._formulas.get(need) or self._areas[need].a1
                self.problems[self._formulas[number]] = f"the cell depends on itself, through {through}"
        return set(cycles)

    def _result(self, number: int, values: list[Any]) -> Any:
        """Return what a step computes in an evaluation of the whole, and note what kept it from a value."""
        step, problem = self._steps[number], ""
        result: Any
        if self._cyclic and CYCLE in map(values.__getitem__, step.sources):
            result, problem = CYCLE, self._through(number)
        else:
            try:
                result = step.compute(values)
            except Exception as error:  # pycel's functions raise whatever Python raises
                result = fault(error)
                problem = "" if result == "#NUM!" else f"pycel: {type(error).__name__}: {str(error)[:120]}"
        if problem or self.problems:
            self._note(number, problem)
        return result

    def _through(self, number: int) -> str:
        """Return why a cell has no value that is in a cycle, or depends on one."""
        address = self._formulas.get(number)
        known = self.problems.get(address) if address and number in self._cyclic else None
        return known or "the cell depends on cells that depend on themselves"

    def _note(self, number: int, problem: str) -> None:
        """Enter a cell's problem, or take back that of an evaluation before."""
        address = self._formulas.get(number)
        if address and problem:
            self.problems[address] = problem
        elif address and number not in self._cyclic:
            self.problems.pop(address, None)


def fault(error: Exception) -> str:
    """Return the error value of a cell whose computation raised an error."""
    return "#NUM!" if isinstance(error, OverflowError) else "#VALUE!"


def begin() -> None:
    """Begin another evaluation: limits count anew, and what was made of ranges is forgotten."""
    Crossed.cells = 0
    Known.forget()
