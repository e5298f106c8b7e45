"""Compare a workbook with its oracle at many values of the inputs, and count what was covered."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np

from workbook.book.address import Address
from workbook.errors import ReadError
from workbook.oracle.cases import Case, cases
from workbook.oracle.cells import cells_of, find, label_of, unit_of
from workbook.oracle.declared import Input, Oracle
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.pycel.model import PycelModel

Coverage = Literal["compared", "step", "unaccounted"]
ROUNDING, SMALLEST = 1e-9, 1e-12
"""of two values that are the same: a relative and an absolute deviation"""
PROBES = 8
"""cases at which a step is changed, to see whether an output follows"""
SPELLINGS = str.maketrans("²³µ", "23μ", "·*^ ")
"""of units: powers and products as people write them"""
CHANGES: tuple[Callable[[float], float], ...] = (lambda value: value * 1.01 + 1e-3, lambda value: -value - 1.0)


@dataclass(frozen=True)
class Wrong:
    """What is wrong in a cell: the kind of fault, what was found and expected, and at which inputs."""

    cell: Address
    kind: str
    found: Any
    expected: Any
    at: str = ""


@dataclass
class Judged:
    """What came of a comparison: findings, cases, and the class of each formula cell."""

    cases: int
    wrong: list[Wrong] = field(default_factory=list)
    coverage: dict[Address, Coverage] = field(default_factory=dict)

    def count(self, kind: Coverage) -> int:
        """How many formula cells are of a class."""
        return sum(found == kind for found in self.coverage.values())

    @property
    def covered(self) -> float:
        """The share of formula cells that are compared or are steps to such, in per cent."""
        return 100.0 * (1.0 - self.count("unaccounted") / len(self.coverage)) if self.coverage else 100.0


class Judge:
    """A workbook held against its oracle."""

    def __init__(self, file: BookFile, oracle: Oracle) -> None:
        self.file, self.oracle = file, oracle
        self.model = PycelModel(file.contents)
        self.cells = {one: self._input(one) for one in oracle.inputs}
        self.outputs = [(find(file, one.cell), one) for one in oracle.outputs]
        self.tables = [(cells_of(file, one.cells), one) for one in oracle.tables]

    def _input(self, one: Input) -> Address:
        cell = find(self.file, one.cell)
        if cell in self.file.contents.formulas:
            raise ReadError(f"{self.file.path.name}: {cell} is an input and holds a formula; expected a value")
        return cell

    def judge(self, number: int, seed: int = 0) -> Judged:
        """Compare the outputs at so many cases, what was saved, units, and what stands in place of formulas."""
        entered = {one: self.file.contents.constants.get(cell) for one, cell in self.cells.items()}
        found = Judged(0)
        first: dict[Address, Wrong] = {}
        tried = cases(self.oracle.inputs, entered, number, seed)
        for case in tried:
            values = self.values(case)
            for wrong in self.compared(case, values):
                first.setdefault(wrong.cell, wrong)
        found.cases, found.wrong = len(tried), [*first.values(), *self.stale(), *self.unread(), *self.units()]
        found.wrong += self.constants()
        found.coverage = self.covered(tried[:: max(1, len(tried) // PROBES)])
        return found

    def values(self, case: Case, others: Cells | None = None) -> Cells:
        """Return what all cells compute at a case; ``others`` stand in for formula cells."""
        given = {self.cells[one]: value for one, value in case.items()}
        return self.file.contents.constants | given | self.model.evaluate(given | (others or {}))

    def compared(self, case: Case, values: Cells) -> Iterator[Wrong]:
        """Yield the outputs that are not what the oracle says of a case."""
        at = ", ".join(f"{name} = {case[one]:.6g}" if isinstance(case[one], float) else f"{name} = {case[one]}"
                       for name, one in self.oracle.names.items())  # fmt: skip
        for cell, expected, allowed in self.expected(case, values):
            if not close(values.get(cell), expected, allowed):
                yield Wrong(cell, "value", values.get(cell), expected, at)

    def expected(self, case: Case, values: Cells) -> Iterator[tuple[Address, Any, float]]:
        """Yield each compared cell with what the oracle says of it, and the deviation that is allowed."""
        for cell, one in self.outputs:
            value = one.of(*(case[x] for x in self.oracle.arguments(one.of)))
            yield cell, value, one.tolerance * size(value)
        for rows, table in self.tables:
            first = np.array([values.get(row[0]) for row in rows], dtype=float)
            columns = table.of(first, *(case[x] for x in self.oracle.arguments(table.of, 1)))
            for j, column in enumerate(columns, 1):
                allowed = table.tolerance * float(np.max(np.abs(column)))
                for row, value in zip(rows, np.broadcast_to(column, first.shape).tolist(), strict=True):
                    yield row[j], value, allowed

    @cached_property
    def targets(self) -> list[Address]:
        """The cells that are compared."""
        return [
            *(cell for cell, _ in self.outputs),
            *(cell for rows, _ in self.tables for row in rows for cell in row[1:]),
        ]

    def stale(self) -> Iterator[Wrong]:
        """Yield the compared cells whose saved value is not what they compute."""
        values = self.model.evaluate()
        for cell, saved in self.file.saved.items():
            if saved is not None and cell in values and not same(saved, values[cell]):
                yield Wrong(cell, "saved", saved, values[cell])

    def unread(self) -> Iterator[Wrong]:
        """Yield the inputs that no formula reads."""
        read = self.file.contents.read(list(self.cells.values()))
        yield from (
            Wrong(cell, "unread", None, "a formula that reads it") for cell in self.cells.values() if cell not in read
        )

    def units(self) -> Iterator[Wrong]:
        """Yield the cells beside which another unit stands than is declared."""
        declared = [(self.cells[one], one.unit) for one in self.oracle.inputs]
        for cell, unit in [*declared, *((cell, one.unit) for cell, one in self.outputs)]:
            beside = unit_of(self.file, cell)
            if unit and beside and spelled(beside) != spelled(unit):
                yield Wrong(cell, "unit", beside, unit)

    def constants(self) -> Iterator[Wrong]:
        """Yield the numbers that stand between formulas of one column."""
        formulas = self.file.contents.formulas
        for cell, value in self.file.contents.constants.items():
            above, below = cell._replace(row=cell.row - 1), cell._replace(row=cell.row + 1)
            number = isinstance(value, int | float) and not isinstance(value, bool)
            if number and above in formulas and below in formulas and cell not in self.cells.values():
                yield Wrong(cell, "replaced", value, "a formula, as above and below it")

    def covered(self, tried: list[Case]) -> dict[Address, Coverage]:
        """Return the class of each formula cell: a step is one whose change alters a compared cell at some case."""
        formulas = self.file.contents.formula_cells
        found: dict[Address, Coverage] = dict.fromkeys(formulas, "unaccounted")
        needed = self.file.contents.needed(formulas, self.targets)
        for case in tried:
            values = self.values(case)
            for cell in needed:
                if found[cell] == "unaccounted" and self.follows(case, values, cell):
                    found[cell] = "step"
        return found | {cell: "compared" for cell in self.targets if cell in found}

    def follows(self, case: Case, values: Cells, cell: Address) -> bool:
        """Whether a compared cell changes with a formula cell."""
        value = values.get(cell)
        changes: list[Any] = [f"{value}?", 1.0]
        if isinstance(value, int | float):
            changes = [change(value) for change in CHANGES]
        return any(
            not same(changed.get(target), values.get(target))
            for other in changes
            for changed in [self.values(case, {cell: other})]
            for target in self.targets
        )


def close(found: Any, expected: Any, allowed: float) -> bool:
    """Whether a value deviates from the expected one by no more than is allowed; a text must be the same."""
    if is_number(found) and is_number(expected):
        return math.isfinite(found) and abs(found - expected) <= allowed + SMALLEST
    return type(found) is type(expected) and bool(found == expected)


def same(found: Any, expected: Any) -> bool:
    """Whether two values are the same but for rounding."""
    return close(found, expected, ROUNDING * size(expected))


def size(value: Any) -> float:
    """Return the magnitude of a number, else 0."""
    return abs(float(value)) if is_number(value) else 0.0


def is_number(value: Any) -> bool:
    """Whether a value is a number, and not a truth value."""
    return isinstance(value, int | float | np.number) and not isinstance(value, bool)


def spelled(unit: str) -> str:
    """Return a unit without what is written in different ways: blanks, brackets, powers, products."""
    return unit.translate(SPELLINGS).strip("[]()")


def describe(file: BookFile, cell: Address) -> str:
    """Return a cell with the label beside it."""
    label = label_of(file, cell)
    return f"{cell} ({label})" if label else str(cell)
