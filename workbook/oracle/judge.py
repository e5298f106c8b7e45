"""Compare a workbook with its oracle at many values of the inputs, and count what was covered."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np

from workbook.book.address import Address
from workbook.book.formula import Area
from workbook.book.rows import is_number
from workbook.dimensions.rules import Dimensions, UnitWalk
from workbook.dimensions.units import POWERS
from workbook.errors import ReadError, WitnessError
from workbook.oracle.cells import cells_of, find_cell, label_of, unit_of
from workbook.oracle.declarations import SMALLEST, Case, Oracle, Output, Table, cases, close, magnitude
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.agreement import UNKNOWN, same_value
from workbook.witnesses.pycel.model import PycelModel, require_working
from workbook.witnesses.registry import WITNESSES
from workbook.witnesses.witness import naming_failures

Coverage = Literal["compared", "step", "unaccounted"]
PROBES = 8  # cases at which a step is changed, to see whether an output follows
CHANGES: tuple[Callable[[float], float], ...] = (lambda value: value * 1.01 + 1e-3, lambda value: -value - 1.0)
SPELLINGS = POWERS | str.maketrans("µ", "μ", "·*^. -()[]")  # of units: powers and products as people write them
BLANK = frozenset(["ISBLANK", "COUNTA", "COUNT", "COUNTIF", "COUNTBLANK", "SUM", "SUMIF"])  # they take empty cells
FIRST = "pycel"  # the evaluator whose values everything else is asked of


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
    """The result of a comparison: findings, cases, notes, dimensions, and the class of each formula cell."""

    cases: int
    wrong: list[Fault] = field(default_factory=list)
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


class Judge:
    """A workbook and its oracle."""

    def __init__(self, file: BookFile, oracle: Oracle) -> None:
        require_working()
        self.file, self.oracle = file, oracle
        self.cells = {entry: find_cell(file, entry.cell) for entry in oracle.inputs}
        for entry, cell in self.cells.items():
            if cell in file.contents.formulas and not entry.macro:
                raise ReadError(f"{file.path.name}: {cell} is an input and holds a formula; expected a value")
        self.outputs = [(find_cell(file, output.cell), output) for output in oracle.outputs]
        self.tables = [(cells_of(file, table.cells), table) for table in oracle.tables]
        formulas = file.contents.formula_cells
        self.formulas = [cell for cell in formulas if not oracle.sheets or cell.sheet in oracle.sheets]
        self.counted, self.sheets = set(self.formulas), {cell.sheet for cell in self.formulas}
        units = {self.cells[entry]: entry.unit for entry in oracle.inputs}
        self.units = units | {cell: output.unit for cell, output in self.outputs}
        asked = {*self.formulas, *self.targets}
        self.model = PycelModel(file.contents, file.contents.needed(set(formulas) - asked, asked) | asked)

    def judge(self, number: int, seed: int = 0, witnesses: Sequence[str] = (FIRST,)) -> OracleReport:
        """Compare the outputs at so many cases by each witness; look at units, saved values and gaps; count cells."""
        tried = cases(self.oracle.inputs, self.entered, number, seed)
        report = OracleReport(len(tried))
        report.wrong += self.deviating(tried, witnesses, report.notes)
        report.dimensions = self.check_units()
        report.wrong += self.other_findings()
        wrong = report.dimensions.wrong.items()
        report.wrong += [Fault(cell, "dimension", text, "one dimension") for cell, text in wrong]
        report.coverage = self.covered(tried[:: max(1, len(tried) // PROBES)])
        return report

    def other_findings(self) -> Iterator[Fault]:
        """Yield stale saved values, unread inputs, other units beside cells, numbers in place of formulas, gaps."""
        inputs = list(self.cells.values())
        macros = {x: self.file.saved.get(cell) for x, cell in self.cells.items() if x.macro}
        values = self.values(self.entered | macros)
        for cell, saved in self.file.saved.items():
            computed = values.get(cell)
            known = cell in self.counted and saved is not None and computed not in UNKNOWN
            if known and not same_value(saved, computed, SMALLEST):
                yield Fault(cell, "saved", saved, computed)
        read = self.file.contents.read(inputs)
        yield from (Fault(cell, "unread", None, "a formula that reads it") for cell in inputs if cell not in read)
        yield from self.other_units()
        yield from self.replaced_formulas(inputs)
        yield from self.empty()

    def other_units(self) -> Iterator[Fault]:
        """Yield the cells beside which another unit stands than is declared."""
        for cell, unit in self.units.items():
            beside = unit_of(self.file, cell)
            if unit and beside and normalised_unit(beside) != normalised_unit(unit):
                yield Fault(cell, "unit", beside, unit)

    def replaced_formulas(self, inputs: Sequence[Address]) -> Iterator[Fault]:
        """Yield the numbers that stand where the cells above and below have the same formula, inputs aside."""
        formulas = self.file.contents.formulas
        for cell, value in self.file.contents.constants.items():
            above, below = (formulas.get(cell._replace(row=cell.row + step)) for step in (-1, 1))
            alike = above is not None and below is not None and above.shape == below.shape
            if alike and is_number(value) and cell.sheet in self.sheets and cell not in inputs:
                yield Fault(cell, "replaced", value, "a formula, as above and below it")

    def empty(self) -> Iterator[Fault]:
        """Yield the empty cells that a formula reads by themselves, each with the first such formula."""
        contents, readers = self.file.contents, dict[Address, Address]()
        filled = {*contents.formula_cells, *(cell for cell, value in contents.constants.items() if value is not None)}
        for cell in self.counted & contents.formulas.keys():
            formula = contents.formulas[cell]
            for area in (
                formula.arguments if BLANK.isdisjoint(formula.functions) and "" not in formula.arguments else ()
            ):
                if isinstance(area, Area) and area.single and area.first not in filled:
                    readers[area.first] = min(cell, readers.get(area.first, cell))
        yield from (
            Fault(cell, "empty", None, f"a value: {reader} reads it") for cell, reader in sorted(readers.items())
        )

    def check_units(self) -> Dimensions:
        """Return the contradictions of units: of those declared, and those beside the cells of the same sheets."""
        contents = self.file.contents
        cells = (cell for cell in [*contents.formulas, *contents.constants] if cell.sheet in self.sheets)
        beside = {cell: unit for cell in cells if (unit := unit_of(self.file, cell))}
        declared = {cell: unit for cell, unit in self.units.items() if unit}
        return UnitWalk(contents, beside | declared).walk(cell for cell in self.model.order if cell in self.counted)

    @property
    def entered(self) -> Case:
        """The inputs as the workbook has them; of a macro the number that was saved, else the low end of its range."""
        saved, constants = self.file.saved, self.file.contents.constants
        macros = {x: saved.get(cell) for x, cell in self.cells.items() if x.macro}
        numbers = {x: value if is_number(value) else x.low for x, value in macros.items()}
        return {x: constants.get(cell) for x, cell in self.cells.items()} | numbers

    def deviating(self, tried: Sequence[Case], witnesses: Sequence[str], notes: list[str]) -> Iterator[Fault]:
        """Yield the outputs that are not what the oracle says, each at the first case and by the first witness."""
        named = set[Address]()
        for name in witnesses:
            unable, by = set[Address](), "" if name == FIRST else f"{name}: "
            try:
                for case, values in zip(tried, self.values_by(name, tried), strict=True):
                    for cell, expected, allowed, output in self.expected(case, values):
                        value = values.get(cell)
                        if cell in named or close(value, expected, allowed):
                            continue
                        if value in UNKNOWN and name != FIRST:
                            unable.add(cell)
                        else:
                            named.add(cell)
                            yield Fault(cell, "value", value, expected, by + self.case_text(output, case))
            except WitnessError as error:
                notes.append(f"{name}: {error}")
            if unable:
                notes.append(f"{name} cannot evaluate {len(unable)} of {len(self.targets)} compared cells")

    def values_by(self, name: str, tried: Sequence[Case]) -> Iterator[Cells]:
        """Yield what a witness computes at each case."""
        if name == FIRST:
            yield from (self.values(case) for case in tried)
        else:
            constants = self.file.contents.constants
            witness = WITNESSES[name]()
            with naming_failures(witness):
                answers = witness.varied(self.file, map(self.given, tried))
                yield from (constants | given | values for given, values in answers)

    def given(self, case: Case) -> Cells:
        """Return the values of a case by their cells."""
        return {self.cells[entry]: value for entry, value in case.items()}

    def values(self, case: Case, others: Cells | None = None) -> Cells:
        """Return the values of all cells at a case; ``others`` stand in for formula cells."""
        given = self.given(case)
        return self.file.contents.constants | self.model.evaluate(given | (others or {})) | given

    def expected(self, case: Case, values: Cells) -> Iterator[tuple[Address, Any, float, Output | Table]]:
        """Yield each compared cell with what the oracle says of it, the deviation that is allowed, and who says it."""
        for cell, output in self.outputs:
            value = self.called(output, case)
            value = value.item() if isinstance(value, np.generic) else value
            yield cell, value, output.tolerance * magnitude(value), output
        for rows, table in self.tables:
            first = np.array([values.get(row[0]) for row in rows], dtype=float)
            columns = self.called(table, case, first)
            for j, column in enumerate(columns, 1):
                allowed = table.tolerance * float(np.max(np.abs(column)))
                for row, value in zip(rows, np.broadcast_to(column, first.shape).tolist(), strict=True):
                    yield row[j], value, allowed, table

    def called(self, output: Output | Table, case: Case, *first: Any) -> Any:
        """Return the result of a declared function; raise ReadError where it cannot be computed."""
        try:
            return output.of(*first, *(case[x] for x in self.oracle.arguments(output)))
        except (ArithmeticError, TypeError, ValueError) as error:
            what = f"{output.of.__name__} of the declarations at {self.case_text(output, case)}"
            raise ReadError(f"{what}: {type(error).__name__}: {error}") from error

    def case_text(self, output: Output | Table, case: Case) -> str:
        """Return the inputs of a function with their values at a case."""
        names = {x: name for name, x in self.oracle.names.items()}
        values = {names.get(x, x.cell): case[x] for x in self.oracle.arguments(output)}
        return ", ".join(f"{name} = {x:.6g}" if is_number(x) else f"{name} = {x}" for name, x in values.items())

    @cached_property
    def targets(self) -> list[Address]:
        """The cells that are compared."""
        columns = [cell for rows, _ in self.tables for row in rows for cell in row[1:]]
        return [*(cell for cell, _ in self.outputs), *columns]

    def covered(self, tried: list[Case]) -> dict[Address, Coverage]:
        """Return the class of each formula cell: a step is a cell whose change alters a compared cell at some case."""
        coverage: dict[Address, Coverage] = dict.fromkeys(self.formulas, "unaccounted")
        coverage |= {cell: "compared" for cell in self.targets if cell in coverage}
        left = self.file.contents.needed(self.file.contents.formula_cells, self.targets)
        left = {cell for cell in left if coverage.get(cell) == "unaccounted"}
        for case in tried if left else ():
            values = self.values(case)
            steps = {cell for cell in left if self.follows(case, values, cell)}
            coverage |= dict.fromkeys(steps, "step")
            left -= steps
        return coverage

    def follows(self, case: Case, values: Cells, cell: Address) -> bool:
        """Whether a compared cell changes with a formula cell."""
        value: Any = values.get(cell)
        changes: list[Any] = [change(value) for change in CHANGES] if is_number(value) else [f"{value}?", 1.0]
        changed = (self.values(case, {cell: other}) for other in changes)
        pairs = ((turn.get(target), values.get(target)) for turn in changed for target in self.targets)
        return not all(same_value(*pair, SMALLEST) for pair in pairs)


def describe(file: BookFile, cell: Address) -> str:
    """Return a cell with the label beside it."""
    label = label_of(file, cell)
    return f"{cell} ({label})" if label else str(cell)


def normalised_unit(unit: str) -> str:
    """Return a unit without what is written in different ways: blanks, brackets, powers, products."""
    text = unit.translate(SPELLINGS)
    return text.casefold() if len(text) > 2 and text.isalpha() else text
