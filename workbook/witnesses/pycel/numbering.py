"""Numbers for all that has a value in an evaluation: cells, ranges, texts in formulas."""

from collections.abc import Hashable
from typing import Any

from workbook.book.address import Address


class Numbering:
    """Gives numbers from 1; ``values`` holds what each begins with, and None, the empty cell of ranges, at 0."""

    def __init__(self) -> None:
        self.values: list[Any] = [None]
        self.cells: dict[int, Address] = {}
        self._columns: dict[tuple[str, int], dict[int, int]] = {}
        self._others: dict[Hashable, int] = {}

    def column(self, sheet: str, column: int) -> dict[int, int]:
        """Return the numbers of a column's cells, by row; it grows with them."""
        return self._columns.setdefault((sheet, column), {})

    def cell(self, address: Address, value: Any = None) -> int:
        """Return the number of a cell; a new one, with ``value``, for what has none."""
        number = self.column(address.sheet, address.column).setdefault(address.row, len(self.values))
        if number == len(self.values):
            self.values.append(value)
            self.cells[number] = address
        return number

    def other(self, key: Hashable, value: Any = None) -> int:
        """Return the number of a range or text; a new one, with ``value``, for what has none."""
        number = self._others.setdefault(key, len(self.values))
        if number == len(self.values):
            self.values.append(value)
        return number
