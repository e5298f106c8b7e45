"""Compare a workbook with its oracle at many values of the inputs, and count what was covered."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from workbook.book.address import Address
from workbook.book.rows import is_number
from workbook.dimensions.rules import Dimensions, UnitWalk
from workbook.errors import ReadError, quoted
from workbook.oracle.calls import CallError, block_of, call, columns_of, plain_result
from workbook.oracle.cells import cells_of, find_cell, unit_of
from workbook.oracle.declarations import Case, Input, Oracle, Output, Table, cases, close
from workbook.oracle.findings import Coverage, Fault, OracleReport, other_units
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.calibration import FIRST, Evaluators, is_no_value
from workbook.witnesses.pycel.model import PycelModel, require_working
from workbook.witnesses.registry import WITNESSES

Rows = list[list[Address]]
Expected = Iterator[tuple[Address, Any, float, Output | Table]]
PROBES = 8  # cases at which a step is changed, to see whether an output follows


@dataclass
class Deviation:
    """A compared cell that an evaluator gives otherwise than the oracle, at the first case where it does."""

    case: Case
    value: Any
    expected: Any
    allowed: float
    row: Output | Table


class Judge:
    """A workbook and its oracle."""

    def __init__(self, file: BookFile, oracle: Oracle) -> None:
        require_working()
        self.file, self.oracle = file, oracle
        self.cells = {entry: find_cell(file, entry.cell) for entry in oracle.inputs}
        require_values(file, self.cells)
        self.outputs = [
            (cells_of(file, x.cell) if ":" in x.cell else [[find_cell(file, x.cell)]], x) for x in oracle.outputs
        ]
        self.tables = [(cells_of(file, table.cells), table) for table in oracle.tables]
        self.declared: list[tuple[Rows, Output | Table]] = [*self.outputs, *self.tables]
        require_names(oracle, self.tables)
        formulas = file.contents.formula_cells
        self.formulas = [cell for cell in formulas if not oracle.sheets or cell.sheet in oracle.sheets]
        self.counted, self.sheets = set(self.formulas), {cell.sheet for cell in self.formulas}
        units = {self.cells[entry]: entry.unit for entry in oracle.inputs}
        self.units = units | {rows[0][0]: output.unit for rows, output in self.outputs}
        asked = {*self.formulas, *self.targets}
        self.model = PycelModel(file.contents, file.contents.needed(set(formulas) - asked, asked) | asked)
        self.unusable: dict[int, str] = {}  # why a function of the declarations is called no more

    def judge(self, number: int, seed: int = 0, witnesses: Sequence[str] = (FIRST,)) -> OracleReport:
        """Compare the outputs at so many cases; look at units, saved values and gaps; count cells."""
        tried = cases(self.oracle.inputs, self.entered, number, seed)
        report = OracleReport(len(tried))
        macros = {cell: self.entered[x] for x, cell in self.cells.items() if x.macro}
        self.evaluators = Evaluators(self.file, self.model, witnesses, macros)
        self.compare(tried, report)
        report.dimensions = self.check_units()
        report.wrong += self.other_findings()
        wrong = report.dimensions.wrong.items()
        report.wrong += [Fault(cell, "dimension", text, "one dimension") for cell, text in wrong]
        report.coverage = self.covered(tried[:: max(1, len(tried) // PROBES)], report)
        report.evaluators = {cell: " and ".join(self.evaluators.trusted.get(cell, ())) for cell in self.formulas}
        report.unusable += self.unusable.values()
        if number := sum(row.proposed for _, row in self.outputs):
            report.notes.append(f"{number} of the functions are proposed, translated from the workbook: steps alone")
        report.notes += [self.evaluators.line(self.formulas), *self.evaluators.notes]
        return report

    def compare(self, tried: Sequence[Case], report: OracleReport) -> None:
        """Enter the state of each compared cell, with findings: each by the first evaluator that is trusted for it."""
        left = set(self.targets)
        reasons = self.evaluators.reasons()
        report.states |= {cell: "cannot" for cell in left if cell in reasons}
        left -= report.states.keys()
        for _ in WITNESSES:
            deviating = self.deviating(tried, left) if left else {}
            report.states |= dict.fromkeys(left - deviating.keys() - self.without_function(), "agrees")
            left = set()
            if not deviating:
                break
            others = self.asked_again(deviating)
            left = {cell for cell, deviation in deviating.items() if self.decide(cell, deviation, others[cell], report)}
        report.states |= dict.fromkeys(left, "cannot")

    def decide(self, cell: Address, deviation: Deviation, others: Mapping[str, Any], report: OracleReport) -> bool:
        """Enter a deviating cell as different or disputed; return whether it is to be compared by others instead."""
        first = self.evaluators.first(cell) or FIRST
        alike = [name for name, value in others.items() if close(value, deviation.expected, deviation.allowed)]
        if len(alike) > 1 and cell in self.evaluators.trusted:  # two give what the first does not
            self.evaluators.trusted[cell] = [name for name in self.evaluators.names if name in alike]
            return True
        at = self.case_text(deviation.row, deviation.case)
        saved = self.evaluators.evidence.get(cell)
        if saved is not None and deviation.case == self.entered and close(saved, deviation.expected, deviation.allowed):
            report.states[cell] = "cannot"  # Excel and the function agree: it is the evaluators that do not
            self.evaluators.stale.pop(cell, None)
        elif alike or (self.evaluators.is_alone(cell) and not others):
            report.states[cell] = "disputed"
            values = {first: deviation.value, **others}
            text = ", ".join(f"{name} {quoted(value)}" for name, value in values.items())
            report.warnings.append(Fault(cell, "disputed", text, deviation.expected, at))
        else:
            report.states[cell] = "differs"
            by = "" if first == FIRST else f"{first}: "
            report.wrong.append(Fault(cell, "value", deviation.value, deviation.expected, by + at))
        return False

    def without_function(self) -> set[Address]:
        """Return the cells of which a function of the declarations cannot be used."""
        return {cell for rows, row in self.declared if id(row.of) in self.unusable for line in rows for cell in line}

    def deviating(self, tried: Sequence[Case], asked: Collection[Address]) -> dict[Address, Deviation]:
        """Return the cells ``asked`` that are not what the oracle says, each at the first case where it is not."""
        deviations: dict[Address, Deviation] = {}
        for case, values in zip(tried, self.computed(tried), strict=False):
            for cell, expected, allowed, row in self.expected(case, values):
                if cell in asked and cell not in deviations and not close(values.get(cell), expected, allowed):
                    deviations[cell] = Deviation(case, values.get(cell), expected, allowed, row)
        return {cell: deviation for cell, deviation in deviations.items() if id(deviation.row.of) not in self.unusable}

    def computed(self, tried: Sequence[Case]) -> Iterator[Cells]:
        """Yield the values of all cells at each case, those compared by the evaluator that is trusted first."""
        read = {*self.targets, *(row[0] for rows, _ in self.tables for row in rows)} & self.evaluators.cells
        by: dict[str, list[Address]] = {}
        for cell in read:
            if (name := self.evaluators.first(cell)) not in (None, FIRST):
                by.setdefault(str(name), []).append(cell)
        given = [self.given(case) for case in tried]
        others = [answers for name, cells in by.items() if (answers := self.evaluators.values(name, given, cells))]
        for case, *answers in zip(tried, *others, strict=True):
            values = self.values(case)
            for answer in answers:
                values |= answer
            yield values

    def asked_again(self, deviating: Mapping[Address, Deviation]) -> dict[Address, dict[str, Any]]:
        """Return the values by the other evaluators of deviating cells, each at the case where it deviates."""
        answered: dict[Address, dict[str, Any]] = {cell: {} for cell in deviating}
        tried = list({id(deviation.case): deviation.case for deviation in deviating.values()}.values())
        for name in list(self.evaluators.names):
            cells = [
                cell for cell in deviating if name in self.evaluators.others(self.evaluators.first(cell) or FIRST, cell)
            ]
            answers = self.evaluators.values(name, [self.given(case) for case in tried], cells) if cells else []
            by_case = {id(case): values for case, values in zip(tried, answers, strict=bool(answers))}
            for cell in cells if answers else ():
                value = by_case[id(deviating[cell].case)].get(cell)
                if not is_no_value(value) and value != "#NAME?":
                    answered[cell][name] = value
        return answered

    def other_findings(self) -> Iterator[Fault]:
        """Yield stale saved values, unread inputs, other units beside cells."""
        inputs = list(self.cells.values())
        stale = self.evaluators.stale.items()
        yield from (Fault(x, "stale", self.file.saved[x], value) for x, value in stale if x in self.counted)
        read = self.file.contents.read(inputs)
        yield from (Fault(cell, "unread", None, "a formula that reads it") for cell in inputs if cell not in read)
        yield from other_units(self.file, self.units)

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

    def given(self, case: Case) -> Cells:
        """Return the values of a case by their cells."""
        return self.evaluators.linked | {self.cells[entry]: value for entry, value in case.items()}

    def values(self, case: Case) -> Cells:
        """Return the values of all cells at a case."""
        given = self.given(case)
        return self.file.contents.constants | self.model.evaluate(given) | given

    def expected(self, case: Case, values: Cells) -> Expected:
        """Yield each compared cell with what the oracle says of it, the deviation that is allowed, and who says it."""
        for rows, row in self.declared:
            if id(row.of) in self.unusable:
                continue
            try:
                if isinstance(row, Output):
                    yield from self.expected_of_output(rows, row, case)
                else:
                    yield from self.expected_of_table(rows, row, case, values)
            except CallError as error:
                at = f" at {inputs}" if (inputs := self.case_text(row, case)) else ""
                self.unusable[id(row.of)] = f"{self.oracle.path}: {row.of.__name__}{at}: {error}"

    def expected_of_output(self, rows: Rows, output: Output, case: Case) -> Expected:
        """Yield the cells of an output as :meth:`expected` does."""
        result = self.called(output, case)
        held = block_of(result, len(rows), len(rows[0])) if ":" in output.cell else [[plain_result(result)]]
        for cell, value in zip(chain.from_iterable(rows), chain.from_iterable(held), strict=True):
            yield cell, value, output.tolerance * (abs(value) if is_number(value) else 0.0), output

    def expected_of_table(self, rows: Rows, table: Table, case: Case, values: Cells) -> Expected:
        """Yield the cells of a table as :meth:`expected` does; raise CallError where the first column has texts."""
        column = [values.get(row[0]) for row in rows]
        odd = next((row[0] for row, value in zip(rows, column, strict=True) if not is_number(value)), None)
        if odd is not None:
            raise CallError(f"the first column has {quoted(values.get(odd))} in {odd}; expected numbers")
        columns = columns_of(self.called(table, case, np.array(column, dtype=float)), len(rows), table.columns[1:])
        for j, held in enumerate(columns, 1):
            allowed = table.tolerance * max(map(abs, held))
            for row, value in zip(rows, held, strict=True):
                yield row[j], value, allowed, table

    def called(self, row: Output | Table, case: Case, *first: Any) -> Any:
        """Return the result of a declared function; raise CallError where it cannot be computed."""
        return call(row.of, [*first, *(case[x] for x in self.oracle.arguments(row))], self.oracle.path)

    def case_text(self, output: Output | Table, case: Case) -> str:
        """Return the inputs of a function with their values at a case."""
        names = {x: name for name, x in self.oracle.names.items()}
        values = {names.get(x, x.cell): case[x] for x in self.oracle.arguments(output)}
        return ", ".join(f"{name} = {x:.6g}" if is_number(x) else f"{name} = {x}" for name, x in values.items())

    @cached_property
    def targets(self) -> list[Address]:
        """The cells that are compared."""
        outputs = [cell for rows, _ in self.outputs for row in rows for cell in row]
        return [*outputs, *(cell for rows, _ in self.tables for row in rows for cell in row[1:])]

    def covered(self, tried: list[Case], report: OracleReport) -> dict[Address, Coverage]:
        """Return the class of each formula cell: of a step a change goes on, formula by formula, to a compared cell.

        What pycel does not compute is taken to change with all that it reads.
        """
        coverage: dict[Address, Coverage] = dict.fromkeys(self.formulas, "unaccounted")
        there = [cell for cell in self.targets if report.states.get(cell) in ("agrees", "differs")]
        proposed = {cell for rows, row in self.outputs if row.proposed for line in rows for cell in line}
        coverage |= {cell: "step" if cell in proposed else "compared" for cell in there if cell in coverage}
        live = self.live({*there}, [self.model.numbered(self.given(case)) for case in tried])
        steps = live & self.evaluators.trusted.keys()
        return coverage | {cell: "step" for cell in steps if coverage.get(cell) == "unaccounted"}

    def live(self, compared: set[Address], runs: list[list[Any]]) -> set[Address]:
        """Return the cells from which a change goes on, formula by formula, to one that is compared."""
        graph = self.evaluators.graph
        live = {number for number, cell in graph.cells.items() if cell in compared}
        for number in reversed(graph.order()):
            if number not in live or number in graph.ranges:
                continue
            left = {cell for cell in graph.sources(number) if cell in graph.reads and cell not in live}
            if graph.cells[number] in self.evaluators.given:
                continue
            if self.evaluators.first(graph.cells[number]) != FIRST:
                live |= left
                continue
            for values in runs if left else ():
                live |= self.model.alters(number, left, values)
                left -= live
        return {graph.cells[number] for number in live if number in graph.cells}


def require_values(file: BookFile, cells: Mapping[Input, Address]) -> None:
    """Raise ReadError for an input with a formula."""
    for entry, cell in cells.items():
        if (cell in file.contents.formulas or cell in file.contents.failed) and not entry.macro:
            raise ReadError(f"{file.path.name}: {cell} is an input and holds a formula; expected a value")


def require_names(oracle: Oracle, tables: Sequence[tuple[Rows, Table]]) -> None:
    """Raise ReadError for a table that has another number of columns than are named."""
    for rows, table in tables:
        if len(rows[0]) != len(table.columns):
            widths = f"{len(table.columns)} columns are named, the range has {len(rows[0])}"
            raise ReadError(f"{oracle.path}: the table {table.cells}: {widths}; expected a name for each")
