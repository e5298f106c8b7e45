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

from workbook.book.address import Address
from workbook.reading.contents import Cells, Contents
from workbook.reading.files import BookFile
from workbook.witnesses.pycel.calculation import Calculation
from workbook.witnesses.witness import Found


def version() -> str:
    """Return pycel's version."""
    return package_version("pycel")


class PycelModel:
    """A workbook's formulas, joined once, to be evaluated again and again with other inputs.

    ``problems`` says in a line why a cell could not be evaluated; its value is an Excel error, or ``#CYCLE!``.
    """

    def __init__(self, held: Workbook | Contents) -> None:
        contents = held if isinstance(held, Contents) else Contents(held)
        self.problems: dict[Address, str] = dict(contents.problems)
        self.constants, self.formulas = contents.constants, contents.formulas
        self._failed = contents.failed
        self._calculation = Calculation(self.constants | self._failed, self.formulas, self.problems)

    @property
    def order(self) -> list[Address]:
        """The formula cells, each after those that it needs."""
        return self._calculation.order

    def evaluate(self, inputs: Mapping[Address, Any] | None = None) -> Cells:
        """Return the value of every formula cell; ``inputs`` stand in for what cells hold."""
        return self._failed | self._calculation.evaluate(inputs)

    def each(self, wanted: Iterable[Address], found: Found) -> Cells:
        """Return the value of each formula cell of ``wanted`` by itself, with ``found`` in the cells it refers to.

        ``found`` is asked with what the cell holds if it holds no formula. With the right values found, a fault
        shows in its own cell only.
        """
        return self._calculation.each(wanted, found)


def evaluate(workbook: Workbook, inputs: Mapping[Address, Any] | None = None) -> Cells:
    """Return the value of every formula cell of ``workbook``."""
    return PycelModel(workbook).evaluate(inputs)


class Pycel:
    """The witness of that name."""

    name = "pycel"
    kept = False

    def version(self) -> str | None:
        """Return pycel's version and Python's, on which it rests."""
        return f"{version()} (Python {sys.version_info.major}.{sys.version_info.minor})"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        return self.model(file).evaluate()

    def model(self, file: BookFile) -> PycelModel:
        """Return the formulas of a file, to be evaluated at other values, and cell by cell."""
        return PycelModel(file.contents)
