"""Declarations in a spreadsheet's terms: a sheet Oracle with a row for each input and output."""

import ast
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from openpyxl import Workbook, load_workbook

from workbook.book.address import Address
from workbook.errors import ReadError, quoted
from workbook.oracle.cells import find_cell, unit_of
from workbook.oracle.declarations import Input, Oracle
from workbook.oracle.draft import inputs_and_outputs, place_of, range_of, variable_names
from workbook.reading.files import BookFile, is_formula, open_book

SHEET = "Oracle"
COLUMNS = ("cell", "unit", "low", "high", "tolerance", "formula in Python")
FUNCTIONS: dict[str, Any] = {name: f for name, f in vars(math).items() if not name.startswith("_")}
FUNCTIONS |= {"abs": abs, "max": max, "min": min, "round": round, "sum": sum}


def write_sheet(file: BookFile) -> Workbook:
    """Return a copy of a workbook with a sheet Oracle: its inputs, and its outputs without formula."""
    copy = load_workbook(file.path)
    if SHEET in copy.sheetnames:
        raise ReadError(f"{file.path}: it has a sheet {SHEET}; expected a workbook without declarations")
    sheet = copy.create_sheet(SHEET)
    sheet.append(COLUMNS)
    inputs, outputs = inputs_and_outputs(file)
    for cell in inputs:
        sheet.append((str(cell), unit_of(file, cell), *range_of(file, cell)[:2]))
    for cell, (cells, _) in outputs.items():
        sheet.append((place_of(cells), unit_of(file, cell), None, None, 1e-9))
    return copy


def oracle_of_sheet(path: Path) -> Oracle:
    """Return the declarations of the sheet Oracle of a workbook; raise ReadError for a row that cannot be used.

    A row without formula is an input where its cell has none either, else an output that nobody has declared yet.
    """
    file = open_book(path)
    rows: Iterator[tuple[Any, ...]] = iter(())
    if SHEET in file.workbook.sheetnames:
        rows = file.workbook[SHEET].iter_rows(max_col=len(COLUMNS), values_only=True)
    if tuple(str(text).strip() for text in next(rows, ())) != COLUMNS:
        raise ReadError(f"{path}: expected a sheet {SHEET} with the headings {', '.join(COLUMNS)} in its first row")
    titles = [title for title in file.workbook.sheetnames if title != SHEET]
    oracle, entries, formulas = Oracle(path.stem, titles, path=path), dict[Address, Input](), []
    for number, (place, unit, low, high, tolerance, formula) in enumerate(rows, 2):
        where = f"{SHEET}, row {number}"
        if odd := next((x for x in (low, high, tolerance) if not isinstance(x, int | float | None)), None):
            raise ReadError(f"{path}: {where}: {quoted(odd)}; expected a number")
        if formula is not None:
            formulas.append((where, place, unit, tolerance, formula))
        elif place is not None and not is_formula(file.value(cell := find_cell(file, str(place).split(":")[0]))):
            entries[cell] = oracle.input(str(place), str(unit or ""), low, high)
    oracle.names = {name: entries[cell] for cell, name in variable_names(file, list(entries)).items()}
    oracle.names |= {cell.a1: entry for cell, entry in entries.items() if cell.sheet == titles[0]}
    for where, place, unit, tolerance, formula in formulas:
        function, names = expression(str(formula), list(oracle.names), f"{path}: {where}")
        function.__name__ = where
        allowed = 1e-9 if tolerance is None else tolerance
        inputs = [oracle.names[name] for name in names]
        oracle.output(str(place), str(unit or ""), allowed, inputs=inputs)(function)
    if not formulas:
        raise ReadError(f"{path}: {SHEET} has no formula in Python; expected one in the row of an output")
    return oracle


def expression(text: str, inputs: list[str], where: str) -> tuple[Callable[..., Any], list[str]]:
    """Return the function of an expression and the inputs it takes; raise ReadError for more than arithmetic."""
    try:
        parsed = ast.parse(text.strip().removeprefix("=").replace("math.", ""), mode="eval")
    except (SyntaxError, ValueError) as error:
        raise ReadError(f"{where}: {quoted(text)} is no expression of Python: {error}") from error
    words = [x.id for x in ast.walk(parsed) if isinstance(x, ast.Name)]
    words += [f".{x.attr}" for x in ast.walk(parsed) if isinstance(x, ast.Attribute)]
    if unknown := [word for word in words if word not in inputs and word not in FUNCTIONS]:
        known = ", ".join(inputs) or "none is declared"
        raise ReadError(f"{where}: {unknown[0]!r} is not known; expected functions of math and inputs: {known}")
    names = [name for name in inputs if name in words]
    # without attributes and with these names alone it reaches nothing else of Python
    code = compile(f"lambda {', '.join(names)}: {ast.unparse(parsed)}", where, "eval")
    function: Callable[..., Any] = eval(code, {"__builtins__": {}} | FUNCTIONS)
    return function, names
