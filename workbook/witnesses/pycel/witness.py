"""pycel as a witness: its parser, compiler and functions, each formula shape compiled once.

pycel itself parses, compiles and loads every formula anew and walks its graph at every call; here its compiler is
called once for each shape (:mod:`workbook.witnesses.pycel.compiled`), and cells are evaluated in an order found without
recursion (:mod:`workbook.witnesses.pycel.calculation`). Every value is computed by pycel's functions and operators.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from importlib.metadata import version as package_version
from typing import Any

from openpyxl import Workbook
from openpyxl.cell.cell import Cell, MergedCell
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula

from workbook.book.address import Address
from workbook.book.formula import REFERENCE, Area, Formula, FormulaError, anchored, reference
from workbook.reading.files import BookFile, Place
from workbook.witnesses.pycel.calculation import Calculation, Found
from workbook.witnesses.pycel.columns import Formulas, Moved
from workbook.witnesses.pycel.steps import entered

Cells = dict[Address, Any]


def version() -> str:
    """Return pycel's version."""
    return package_version("pycel")


class PycelModel:
    """A workbook's formulas, parsed once, to be evaluated again and again with other inputs.

    ``workbook`` is loaded with formulas, and never asked for cached values. ``problems`` says in a line why a
    cell could not be evaluated; such a cell's value is an Excel error, or ``#CYCLE!``.
    """

    def __init__(self, workbook: Workbook) -> None:
        self.problems: dict[Address, str] = {}
        self.constants: Cells = {}
        self.formulas: dict[Address, Formula | Moved] = {}
        self._failed: Cells = {}
        self._titles = {title.casefold(): title for title in workbook.sheetnames}
        self._names = names_of(workbook)
        self._epoch = workbook.epoch
        for sheet in workbook.worksheets:
            formulas = Formulas(sheet.title, self._area)
            # the cells that the file has: its dimensions may be absurd, and iter_rows() would make all of them
            for (row, column), cell in sheet._cells.items():
                self._take(Address(sheet.title, row, column), cell, formulas)
        self._calculation = Calculation(self.constants | self._failed, self.formulas, self.problems)

    @property
    def order(self) -> list[Address]:
        """The formula cells, each after those that it needs."""
        return self._calculation.order

    def reads(self, address: Address) -> bool:
        """Whether some formula refers to a cell."""
        return self._calculation.reads(address)

    def evaluate(self, inputs: Mapping[Address, Any] | None = None) -> Cells:
        """Return the value of every formula cell; ``inputs`` stand in for what cells hold."""
        return self._failed | self._calculation.evaluate(inputs)

    def each(self, wanted: Iterable[Address], found: Found) -> Cells:
        """Return the value of each formula cell of ``wanted`` by itself, with ``found`` in the cells it refers to.

        ``found`` is asked with what the cell holds if it holds no formula. With the right values found, a fault
        shows in its own cell only.
        """
        return self._calculation.each(wanted, found)

    def _take(self, address: Address, cell: Cell | MergedCell, formulas: Formulas) -> None:
        if cell.data_type != "f":
            if cell.value is not None:
                self.constants[address] = entered(cell.value, self._epoch)
            return
        value = cell.value
        if isinstance(value, ArrayFormula) and value.ref == address.a1:
            value = value.text  # arrays are computed in every formula, and of a result the first cell is taken
        try:
            if not isinstance(value, str):
                raise FormulaError("#VALUE!", f"a formula of the kind {type(value).__name__} is not evaluated")
            self.formulas[address] = formulas.read(value, address.row)
        except FormulaError as error:
            self._failed[address] = error.value
            self.problems[address] = str(error)

    def _area(self, name: str, sheet: str) -> Area:
        """Resolve a defined name, the sheet's own before the workbook's; or ``title!`` to the sheet of that title."""
        if name.endswith("!"):
            title = self._titles.get(name[:-1].casefold())
            if title is None:
                kind = "is in another file" if "[" in name else "is no sheet of this workbook"
                raise FormulaError("#REF!", f"{name[:-1]} {kind}")
            return Area(title, 1, 1, 1, 1, single=True)
        key = name.casefold()
        text = self._names.get((sheet.casefold(), key), self._names.get((None, key)))
        if text is None or not REFERENCE.fullmatch(text):
            raise FormulaError("#NAME?", f"the name {name} does not lead to cells")
        if anchored(text) not in ("$c$r", "$c$r:$c$r"):
            raise FormulaError("#NAME?", f"the name {name} moves with the cell that uses it")
        area = reference(text, sheet, self._area)
        return area._replace(single=area.size == 1)


def names_of(workbook: Workbook) -> dict[tuple[str | None, str], str]:
    """Return the texts of all defined names by sheet (None for the workbook's) and name, case-folded."""

    def texts(scope: str | None, names: Mapping[str, DefinedName]) -> dict[tuple[str | None, str], str]:
        return {(scope, name.casefold()): str(n.attr_text).removeprefix("=") for name, n in names.items()}

    found = texts(None, workbook.defined_names)
    for sheet in workbook.worksheets:
        found |= texts(sheet.title.casefold(), sheet.defined_names)
    return found


def area_of(place: Place) -> Area:
    """Return a place as an area of formulas."""
    bottom, right = place.row + place.rows - 1, place.column + place.columns - 1
    return Area(place.sheet, place.row, place.column, bottom, right, place.rows == place.columns == 1)


def cells_of(area: Area) -> list[Address]:
    """Return the addresses of an area, row by row."""
    return area.cells()


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
