"""What a witness is: something that takes a workbook file and says what each formula cell computes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any, Protocol

import openpyxl
from openpyxl import Workbook
from openpyxl.cell.cell import Cell, MergedCell

from workbook.book.address import Address
from workbook.reading.files import BookFile


class Witness(Protocol):
    """One way to evaluate a workbook, independent of the others."""

    name: str

    def version(self) -> str | None:
        """Return the version of the program that evaluates, or None where it is not on this machine."""

    def values(self, file: BookFile) -> dict[Address, Any]:
        """Return the value of every formula cell; raise WitnessError where that cannot be had."""


def formula_cells(workbook: Workbook) -> Iterator[Address]:
    """Yield the address of every formula cell."""
    for sheet in workbook.worksheets:
        for (row, column), cell in sheet._cells.items():
            if cell.data_type == "f":
                yield Address(sheet.title, row, column)


def cached_values(path: Path | IO[bytes], file: BookFile) -> dict[Address, Any]:
    """Return what another copy of the file holds as results of the formula cells of ``file``."""
    held = {sheet.title: sheet._cells for sheet in openpyxl.load_workbook(path, data_only=True).worksheets}
    return {a: result_of(held[a.sheet].get((a.row, a.column))) for a in formula_cells(file.workbook)}


def result_of(cell: Cell | MergedCell | None) -> Any:
    """Return what a cell holds; an empty text is a result too, which openpyxl reads as nothing."""
    if cell is None:
        return None
    return "" if cell.value is None and cell.data_type == "str" else cell.value
