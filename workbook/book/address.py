"""The address of a cell: sheet, row, column; and the place of a block of cells."""

from typing import NamedTuple, Self

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
    def parse(cls, text: str, sheet: str | None = None) -> Self:
        """Read ``Timing!B7``, ``'My sheet'!$B$7``, or ``B7`` on ``sheet``; raise ValueError for anything else."""
        before, _, cell = text.rpartition("!")
        name = before.strip("'").replace("''", "'") if before else sheet
        if name is None:
            raise ValueError(f"{text!r}: no sheet is named")
        row, column = coordinate_to_tuple(cell.replace("$", ""))
        return cls(name, row, column)


class Place(NamedTuple):
    """The place of a block in a file."""

    sheet: str
    row: int
    column: int
    rows: int
    columns: int
    rows_at: tuple[int, ...] = ()  # the offsets of its rows where others lie between them
    columns_at: tuple[int, ...] = ()  # and of its columns

    def cell(self, i: int, j: int) -> Address:
        """Return the address of the cell in row ``i`` and column ``j`` of the block, from 0."""
        row = self.rows_at[i] if 0 <= i < len(self.rows_at) else i
        column = self.columns_at[j] if 0 <= j < len(self.columns_at) else j
        return Address(self.sheet, self.row + row, self.column + column)

    def down(self, j: int) -> list[Address]:
        """Return the cells of a column."""
        offsets, column = self.rows_at or range(self.rows), self.cell(0, j).column
        return [Address(self.sheet, self.row + offset, column) for offset in offsets]

    def part(self, j: int) -> Self:
        """Return the place of a column."""
        return self._replace(column=self.cell(0, j).column, columns=1, columns_at=())

    @property
    def corners(self) -> tuple[Address, Address]:
        """The first and the last cell."""
        return self.cell(0, 0), self.cell(self.rows - 1, self.columns - 1)
