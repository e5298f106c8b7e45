"""pycel as a witness: its parser, compiler and functions, each formula shape compiled once.

pycel itself parses, compiles and loads every formula anew and walks its graph at every call; here its compiler
is called once for each shape (:mod:`workbook.witnesses.shapes`), and cells are evaluated in an order found
without recursion. Every value is computed by pycel's own functions and operators.
"""

from __future__ import annotations

import ast
import importlib
import sys
from collections.abc import Callable, Container, Mapping
from functools import cached_property, lru_cache
from importlib.metadata import version as package_version
from typing import Any

from openpyxl import Workbook
from pycel.excelformula import ExcelFormula
from pycel.excelutil import EMPTY, AddressRange, build_operator_operand_fixup
from pycel.lib.function_helpers import load_functions
from pycel.lib.function_info import all_excel_functions

from workbook.address import Address
from workbook.files import BookFile, Place, find_places
from workbook.witnesses.shapes import Area, Formula, FormulaError, bounded, read, row_mark

if sys.version_info >= (3, 14):  # where ast.Str is gone, for which pycel's compiler still asks
    setattr(ast, "Str", ast.Constant)  # noqa: B010 - the type checker knows no such attribute

Cells = dict[Address, Any]
REFERENCES = frozenset({"ROW", "COLUMN", "OFFSET", "INDIRECT", "CELL", "ROWS", "COLUMNS"})
MODULES = tuple(importlib.import_module(name) for name in ExcelFormula.default_modules)


def version() -> str:
    """Return pycel's version."""
    return package_version("pycel")


class Arguments:
    """What the formula under evaluation asks for, by the dummy references of its shape."""

    def __init__(self) -> None:
        self.now: dict[str, Any] = {}
        self.space: dict[str, Any] = {
            "_C_": self._get,
            "_R_": self._get,
            "_REF_": AddressRange.create,
            "pi": 3.141592653589793,
            "excel_operator_operand_fixup": build_operator_operand_fixup(lambda is_exception, message: None),
        }

    def _get(self, name: str) -> Any:
        return self.now[name]


ARGUMENTS = Arguments()


@lru_cache(maxsize=20_000)
def compiled(shape: str, functions: frozenset[str]) -> Callable[[], Any] | FormulaError:
    """Return a shape as pycel compiles it, or why it cannot; either is found out once.

    Only Excel's own functions pass: pycel would hand any other name on to Python.
    """
    try:
        return _compiled(shape, functions)
    except FormulaError as error:
        return error


def _compiled(shape: str, functions: frozenset[str]) -> Callable[[], Any]:
    for name in functions:
        if name not in all_excel_functions:
            raise FormulaError("#NAME?", f"{name} is no function of Excel")
        if name in REFERENCES:
            raise FormulaError("#NAME?", f"{name} depends on where a cell stands, which pycel cannot be asked here")
    try:
        code, names = ExcelFormula(shape).compiled_python
    except RecursionError as error:
        raise FormulaError("#VALUE!", "the formula is nested too deeply") from error
    except Exception as error:
        raise FormulaError("#NAME?", f"pycel cannot compile it: {str(error)[:120]}") from error
    space = ARGUMENTS.space
    made: list[Callable[[], Any]] = []
    space["lambdas"] = made
    missing = load_functions(names, space, MODULES)
    if missing:
        raise FormulaError("#NAME?", f"pycel has no function {', '.join(sorted(missing)).upper()}")
    exec(code, space, space)  # noqa: S102 - what pycel's compiler made of a shape without any text of the file
    return made[0]


class Step:
    """One formula cell, ready to be evaluated."""

    __slots__ = ("address", "bound", "call")

    def __init__(self, address: Address, call: Callable[[], Any], formula: Formula) -> None:
        self.address, self.call = address, call
        self.bound = [
            (f"A{i}" if isinstance(a, str) or a.single else f"A{i}:B{i}", name_of(a), a)
            for i, a in enumerate(formula.arguments, 1)
        ]


def name_of(argument: Area | str) -> Any:
    """Return the key of an argument: an address, an area, or nothing for a text."""
    if isinstance(argument, str):
        return None
    if argument.single:  # as Address(...), but in a third of the time
        return tuple.__new__(Address, (argument.sheet, argument.top, argument.left))
    return argument


class PycelModel:
    """A workbook's formulas, parsed once, to be evaluated again and again with other inputs.

    ``workbook`` is loaded with formulas, and never asked for cached values. ``problems`` says in a line why a
    cell could not be evaluated; such a cell's value is an Excel error.
    """

    def __init__(self, workbook: Workbook) -> None:
        self.problems: dict[Address, str] = {}
        self.constants: Cells = {}
        self._failed: Cells = {}
        self._titles = {title.lower(): title for title in workbook.sheetnames}
        self._names = {name.lower(): area_of(place) for name, place in find_places(workbook).items()}
        self.formulas: dict[Address, Formula] = {}
        self._rows: dict[tuple[str, str], tuple[Formula, int]] = {}
        for sheet in workbook.worksheets:
            for row in sheet.iter_rows():
                for cell in row:
                    if cell.value is not None:
                        self._take(Address(sheet.title, cell.row, cell.column), cell.value, cell.data_type)
        self._steps = self._prepared()
        self._order = self._ordered()

    @cached_property
    def read_cells(self) -> set[Address]:
        """Every cell that some formula refers to."""
        areas = {a for formula in self.formulas.values() for a in formula.arguments if isinstance(a, Area)}
        return {address for area in areas for address in cells_of(area)}

    def evaluate(
        self,
        inputs: Mapping[Address, Any] | None = None,
        assumed: Mapping[Address, Any] | None = None,
        only: Container[Address] | None = None,
    ) -> Cells:
        """Return the value of every formula cell, or of those in ``only``.

        ``inputs`` stand in for constant cells. ``assumed`` are values that formulas find in other formula
        cells instead of what those compute: with the right values assumed, a fault shows in its own cell only.
        """
        values: Cells = {**self.constants, **(inputs or {})}
        results: Cells = dict(self._failed)
        values.update(self._failed)
        if assumed:
            values.update(assumed)
        ranges: dict[Area, Any] = {}
        for step in self._order:
            if only is not None and step.address not in only:
                continue
            value = self._computed(step, values, ranges)
            results[step.address] = value
            if not assumed or step.address not in assumed:
                values[step.address] = value
        return results

    def _take(self, address: Address, value: Any, kind: str) -> None:
        if kind != "f":
            self.constants[address] = value
            return
        try:
            if not isinstance(value, str):
                raise FormulaError("#VALUE!", f"a formula of the kind {type(value).__name__} is not evaluated")
            self.formulas[address] = self._read(address, value)
        except FormulaError as error:
            self._fail(address, error)

    def _read(self, address: Address, text: str) -> Formula:
        """Read a formula; one that only repeats, in its own row, what another row has is not read anew."""
        if '"' in text:
            return read(text, address.sheet, self._area)
        key = (address.sheet, row_mark(address.row).sub(r"\1@", text))
        known = self._rows.get(key)
        if known is None:
            known = self._rows[key] = (read(text, address.sheet, self._area), address.row)
        formula, below = known
        return formula if below == address.row else formula.in_row(address.row, below)

    def _fail(self, address: Address, error: FormulaError) -> None:
        self._failed[address] = error.value
        self.problems[address] = str(error)

    def _area(self, name: str, sheet: str) -> Area:
        """Resolve a defined name, or ``title!`` to the sheet of that title."""
        if name.endswith("!"):
            title = self._titles.get(name[:-1].lower())
            if title is None:
                raise FormulaError("#REF!", f"there is no sheet {name[:-1]}")
            return Area(title, 1, 1, 1, 1, single=True)
        area = self._names.get(name.lower())
        if area is None:
            raise FormulaError("#NAME?", f"the name {name} does not lead to cells")
        return bounded(area)

    def _prepared(self) -> dict[Address, Step]:
        steps = {}
        for address, formula in self.formulas.items():
            call = compiled(formula.shape, formula.functions)
            if isinstance(call, FormulaError):
                self._fail(address, call)
            else:
                steps[address] = Step(address, call, formula)
        return steps

    def _ordered(self) -> list[Step]:
        """Return the cells so that each follows what it needs; cells of a cycle are failed."""
        needs: dict[Address, list[Address]] = {}
        within: dict[Area, list[Address]] = {}
        for address, step in self._steps.items():
            found: list[Address] = []
            for _, key, _ in step.bound:
                if isinstance(key, Address):
                    found.append(key)
                elif key is not None:
                    if key not in within:
                        within[key] = [a for a in cells_of(key) if a in self._steps]
                    found += within[key]
            needs[address] = found
        return self._sorted(needs)

    def _sorted(self, needs: dict[Address, list[Address]]) -> list[Step]:
        order: list[Step] = []
        done: dict[Address, bool] = {}  # False while what a cell needs is under way
        for start in self._steps:
            stack = [(start, iter(needs[start]))] if start not in done else []
            done.setdefault(start, False)
            while stack:
                address, rest = stack[-1]
                for need in rest:
                    if need not in self._steps:
                        continue
                    if need not in done:
                        done[need] = False
                        stack.append((need, iter(needs[need])))
                        break
                    if not done[need]:
                        self._fail(need, FormulaError("#CYCLE!", "the cell depends on itself"))
                else:
                    done[address] = True
                    order.append(self._steps[address])
                    stack.pop()
        return [step for step in order if step.address not in self._failed]

    def _computed(self, step: Step, values: Cells, ranges: dict[Area, Any]) -> Any:
        ARGUMENTS.now = now = {}
        for dummy, key, argument in step.bound:
            if isinstance(key, Address):
                now[dummy] = values.get(key)
            elif key is None:
                now[dummy] = argument
            else:
                if key not in ranges:
                    ranges[key] = table_of(key, values)
                now[dummy] = ranges[key]
        try:
            value = step.call()
        except Exception as error:
            self.problems[step.address] = f"pycel: {type(error).__name__}: {str(error)[:120]}"
            return "#VALUE!"
        return plain(value)


def plain(value: Any) -> Any:
    """Return a result as a cell holds it."""
    if value is None or value is EMPTY:
        return 0
    if isinstance(value, tuple | list):
        return "#VALUE!"
    return value.item() if hasattr(value, "item") else value


def area_of(place: Place) -> Area:
    """Return a place as an area of formulas."""
    bottom, right = place.row + place.rows - 1, place.column + place.columns - 1
    return Area(place.sheet, place.row, place.column, bottom, right, place.rows == place.columns == 1)


def cells_of(area: Area) -> list[Address]:
    """Return the addresses of an area, row by row."""
    return [
        Address(area.sheet, r, c) for r in range(area.top, area.bottom + 1) for c in range(area.left, area.right + 1)
    ]


def table_of(area: Area, values: Cells) -> tuple[tuple[Any, ...], ...]:
    """Return the values of an area as pycel's functions take them: a tuple of rows."""
    columns = range(area.left, area.right + 1)
    return tuple(
        tuple(values.get(Address(area.sheet, r, c)) for c in columns) for r in range(area.top, area.bottom + 1)
    )


def evaluate(workbook: Workbook, inputs: Mapping[Address, Any] | None = None) -> Cells:
    """Return the value of every formula cell of ``workbook``."""
    return PycelModel(workbook).evaluate(inputs)


class Pycel:
    """The witness of that name."""

    name = "pycel"

    def version(self) -> str | None:
        """Return pycel's version and Python's, on which it rests."""
        return f"{version()} (Python {sys.version_info.major}.{sys.version_info.minor})"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        return evaluate(file.workbook)
