"""What a witness is: something that takes a workbook file and says what each formula cell computes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import IO, Any, Protocol, runtime_checkable

import openpyxl
from openpyxl.cell.cell import Cell, MergedCell

from workbook.book.address import Address
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile

Found = Callable[[Address, Any], Any]  # what is found in a cell; else what a cell without a formula holds


class Witness(Protocol):
    """One way to evaluate a workbook, independent of the others."""

    name: str

    def version(self) -> str | None:
        """Return the version of the program that evaluates, or None where it is not on this machine."""

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell; raise WitnessError where that cannot be had."""


class Model(Protocol):
    """A file's formulas as a witness holds them, to be evaluated again and again."""

    @property
    def problems(self) -> Mapping[Address, str]:
        """Why cells could not be evaluated, each in a line."""

    def evaluate(self) -> Cells:
        """Return the value of every formula cell, each from all others."""

    def each(self, wanted: Iterable[Address], found: Found) -> Cells:
        """Return the value of each formula cell of ``wanted`` by itself, with ``found`` in the cells it refers to."""


@runtime_checkable
class CellWitness(Witness, Protocol):
    """A witness that can also evaluate each cell by itself: so a fault shows in its own cell only."""

    def model(self, file: BookFile) -> Model:
        """Return the formulas of a file."""


def cached_values(path: Path | IO[bytes], file: BookFile) -> dict[Address, Any]:
    """Return what another copy of the file holds as results of the formula cells of ``file``."""
    held = {sheet.title: sheet._cells for sheet in openpyxl.load_workbook(path, data_only=True).worksheets}
    return {a: result_of(held[a.sheet].get((a.row, a.column))) for a in file.contents.formula_cells}


def result_of(cell: Cell | MergedCell | None) -> Any:
    """Return what a cell holds; an empty text is a result too, which openpyxl reads as nothing."""
    if cell is None:
        return None
    return "" if cell.value is None and cell.data_type == "str" else cell.value
