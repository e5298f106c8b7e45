"""A workbook's formulas joined and evaluated, and evaluated again where something has changed."""

from __future__ import annotations

from collections.abc import Container, Mapping
from typing import Any

from pycel.excelutil import AddressRange

from workbook.address import Address
from workbook.witnesses.compiled import Compiled, compiled
from workbook.witnesses.order import ordered
from workbook.witnesses.shapes import Area, Formula, FormulaError
from workbook.witnesses.steps import FormulaStep, RangeStep, entered

CYCLE = "#CYCLE!"
MOST_RANGE_CELLS = 4_000_000  # of all different ranges together


class Calculation:
    """Formulas and the cells they refer to; ``problems`` is told in a line why a cell could not be evaluated.

    Everything that has a value (a cell, a range, a text in a formula) has a number, its place in ``_values``.
    """

    def __init__(
        self, constants: Mapping[Address, Any], formulas: Mapping[Address, Formula], problems: dict[Address, str]
    ) -> None:
        self.problems = problems
        self._numbers: dict[Any, int] = {None: 0}  # None is the empty cell, for ranges
        self._values: list[Any] = [None]
        self._steps: dict[int, FormulaStep | RangeStep] = {}
        self._areas: dict[int, Area] = {}
        self._range_cells = 0
        for address, value in constants.items():
            self._number(address, entered(value))
        self._formulas = {self._number(address): address for address in formulas}
        self._occupied = len(self._values)
        for number, address in self._formulas.items():
            self._join(number, address, formulas[address])
        self._order, cycles = ordered({number: step.sources for number, step in self._steps.items()})
        self._cyclic = self._note_cycles(cycles)
        self._results = list(self._values)
        self._due = bytearray(b"\1" * len(self._values))
        self._given: dict[int, Any] = {}

    def evaluate(
        self,
        inputs: Mapping[Address, Any] | None = None,
        assumed: Mapping[Address, Any] | None = None,
        only: Container[Address] | None = None,
    ) -> dict[Address, Any]:
        """Return the value of every formula cell, or of those in ``only``.

        ``inputs`` stand in for what cells hold, in this evaluation only. ``assumed`` are values that formulas
        find in other formula cells instead of what those compute. With ``only``, nothing else is computed:
        what those cells refer to must be constant or assumed. What has not changed is not computed again.
        """
        fixed = {self._input(a): entered(v) for a, v in (inputs or {}).items()}
        known = ((self._numbers.get(a), v) for a, v in (assumed or {}).items())
        given = {n: entered(v) for n, v in known if n in self._formulas} | fixed
        wanted = {n: a for n, a in self._formulas.items() if only is None or a in only}
        self._compute(given, wanted, everything=only is None)
        return {a: fixed.get(n, self._results[n]) for n, a in wanted.items()}

    def _number(self, key: Any, value: Any = None) -> int:
        """Return the number of what ``key`` means; a new one, with ``value``, for what has none."""
        number = self._numbers.setdefault(key, len(self._values))
        if number == len(self._values):
            self._values.append(value)
        return number

    def _join(self, number: int, address: Address, formula: Formula) -> None:
        """Connect a formula with what it refers to."""
        call = compiled(formula.shape)
        try:
            if isinstance(call, FormulaError):
                raise call
            self._steps[number] = FormulaStep(call, self._sources(call, formula))
        except FormulaError as error:
            self._values[number] = error.value
            self.problems[address] = str(error)

    def _sources(self, call: Compiled, formula: Formula) -> list[int]:
        known = self._numbers
        if not call.addresses:
            return [known.get(a) or self._source(a) for a in formula.arguments]
        return [
            self._address(a) if dummy in call.addresses else self._source(a)
            for dummy, a in zip(call.dummies, formula.arguments, strict=True)
        ]

    def _source(self, argument: Area | str) -> int:
        if isinstance(argument, str):
            return self._number(("text", argument), argument)
        if argument.single:
            self._numbers[argument] = number = self._number(argument.first)
            return number
        if argument not in self._numbers:
            self._range_cells += argument.size
            if self._range_cells > MOST_RANGE_CELLS:
                raise FormulaError("#REF!", f"the ranges of this workbook hold over {MOST_RANGE_CELLS:,} cells")
            self._areas[self._number(argument)] = argument
            self._fill(argument)
        return self._numbers[argument]

    def _fill(self, area: Area) -> None:
        """Give a range the numbers of its cells."""
        cells = [self._numbers.get(address, 0) for address in area.cells()]
        self._steps[self._numbers[area]] = RangeStep(cells, area.right - area.left + 1)

    def _address(self, argument: Area | str) -> int:
        """Return the number of an argument's address, for functions that ask for it."""
        if isinstance(argument, str):
            raise FormulaError("#VALUE!", "a reference is expected, not a text")
        return self._number(("address", argument.a1), AddressRange.create(argument.a1))

    @property
    def order(self) -> list[Address]:
        """The formula cells, each after what it needs."""
        return [self._formulas[number] for number in self._order if number in self._formulas]

    def _input(self, address: Address) -> int:
        """Return the number of a cell that is given a value; ranges that passed over it as empty now hold it."""
        number = self._number(address)
        if number >= len(self._results):
            self._results.append(None)
            self._due.append(0)
        if number >= self._occupied:
            for area in self._areas.values():
                if area.holds(address):
                    self._fill(area)
        return number

    def _note_cycles(self, cycles: Mapping[int, int]) -> set[int]:
        for number, need in cycles.items():
            self._values[number] = CYCLE
            if number in self._formulas:
                through = self._formulas.get(need) or self._areas[need].a1
                self.problems[self._formulas[number]] = f"the cell depends on itself, through {through}"
        return set(cycles)

    def _compute(self, given: dict[int, Any], wanted: Mapping[int, Address], everything: bool) -> None:
        """Compute what is due: never computed, or dependent on something that is no longer as it was."""
        due, changed = self._due, bytearray(len(self._values))
        for number in self._given.keys() | given.keys():
            default = CYCLE if number in self._cyclic else self._results[number]
            self._see(number, given.get(number, default), changed)
        self._given = given
        ranges = self._areas if everything else {s for n in wanted for s in self._steps_of(n)}
        for number in self._order:
            step = self._steps[number]
            if not (due[number] or 1 in map(changed.__getitem__, step.sources)):
                continue
            due[number] = number not in wanted and number not in ranges
            if not due[number]:
                self._results[number] = result = self._result(number, step)
                if number not in given:
                    self._see(number, result, changed)

    def _steps_of(self, number: int) -> list[int]:
        step = self._steps.get(number)
        return [s for s in step.sources if s in self._areas] if step else []

    def _see(self, number: int, value: Any, changed: bytearray) -> None:
        """Let others find ``value``; a range counts as changed whenever it is filled again."""
        before = self._values[number]
        if type(value) is not type(before) or type(value) is tuple or value != before:
            self._values[number] = value
            changed[number] = 1

    def _result(self, number: int, step: FormulaStep | RangeStep) -> Any:
        address = self._formulas.get(number)
        if self._cyclic and CYCLE in map(self._values.__getitem__, step.sources):
            if address and number not in self._cyclic:
                self.problems[address] = "the cell depends on cells that depend on themselves"
            return CYCLE
        try:
            result = step.compute(self._values)
        except OverflowError:
            result = "#NUM!"
        except Exception as error:  # pycel's functions raise whatever Python raises
            if address:
                self.problems[address] = f"pycel: {type(error).__name__}: {str(error)[:120]}"
            return "#VALUE!"
        if address in self.problems and number not in self._cyclic:
            del self.problems[address]  # of an evaluation before
        return result
