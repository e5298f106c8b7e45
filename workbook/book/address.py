"""Where a cell is: sheet, row, column; and where a block of cells is."""

from __future__ import annotations

from typing import NamedTuple

from openpyxl.utils import get_column_letter, quote_sheetname
from openpyxl.utils.cell import coordinate_to_tuple


class Address(NamedTuple):
    """One cell of a workbook; rows and columns count from 1."""

    sheet: str
    row: int
    column: int

    @property
    def a1(self) -> str:
        """The cell on its sheet, such as ``B7``."""
        return f"{get_column_letter(self.column)}{self.row}"

    def __str__(self) -> str:
        sheet = self.sheet if self.sheet.isidentifier() else quote_sheetname(self.sheet)
        return f"{sheet}!{self.a1}"

    @classmethod
    def parse(cls, text: str, sheet: str | None = None) -> Address:
        """Read ``Timing!B7``, ``'My sheet'!$B$7``, or ``B7`` on ``sheet``; raise ValueError for anything else."""
        before, _, cell = text.rpartition("!")
        name = before.strip("'").replace("''", "'") if before else sheet
        if name is None:
            raise ValueError(f"{text!r}: no sheet is named")
        row, column = coordinate_to_tuple(cell.replace("$", ""))
        return cls(name, row, column)


class Place(NamedTuple):
    """Where a block lies in a file."""

    sheet: str
    row: int
    column: int
    rows: int
    columns: int

    def cell(self, i: int, j: int) -> Address:
        """Return the address of the cell in row ``i`` and column ``j`` of the block, from 0."""
        return Address(self.sheet, self.row + i, self.column + j)
