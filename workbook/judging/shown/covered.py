"""Where the cells and the drawings of a sheet lie (EMU)."""

from __future__ import annotations

from collections.abc import Callable
from itertools import accumulate
from typing import NamedTuple

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.reading.drawings import PIXEL, Anchor, Corner

POINT = 12700  # EMU
WIDTH, HEIGHT = 8.43, 15.0  # of a column, in characters of 7 pixels, and of a row, in points, where none is told
DIGIT, MARGIN = 7, 5  # pixels


class Area(NamedTuple):
    """A rectangle on a sheet."""

    left: float
    top: float
    right: float
    bottom: float

    def holds(self, x: float, y: float) -> bool:
        """Whether a point lies within."""
        return self.left < x < self.right and self.top < y < self.bottom

    def shared(self, other: Area) -> float:
        """Return which share of this is behind another; 0 of one that has no size."""
        wide = max(min(self.right, other.right) - max(self.left, other.left), 0.0)
        high = max(min(self.bottom, other.bottom) - max(self.top, other.top), 0.0)
        size = (self.right - self.left) * (self.bottom - self.top)
        return wide * high / size if size > 0 else 0.0


class Layout:
    """The lines between the cells of a sheet, and the areas of its drawings."""

    def __init__(self, sheet: Worksheet, anchors: list[Anchor]) -> None:
        self._right, self._down = Line(columns_of(sheet)), Line(rows_of(sheet))
        self.areas = [self._area(anchor) for anchor in anchors]

    def covered(self, at: Address) -> bool:
        """Whether the middle of a cell is behind a drawing."""
        x, y = (self._right.middle(at.column), self._down.middle(at.row)) if self.areas else (0.0, 0.0)
        return any(area.holds(x, y) for area in self.areas)

    def _area(self, anchor: Anchor) -> Area:
        left, top = self._point(anchor.first)
        if anchor.last is not None:
            return Area(left, top, *self._point(anchor.last))
        return Area(left, top, left + anchor.size[0], top + anchor.size[1])

    def _point(self, corner: Corner) -> tuple[float, float]:
        return self._right.begin(corner.column + 1) + corner.right, self._down.begin(corner.row + 1) + corner.down


class Line:
    """Columns beside each other, or rows below each other: where each begins."""

    def __init__(self, size: Callable[[int], float]) -> None:
        self._size = size
        self._begins = [0.0, 0.0]

    def begin(self, number: int) -> float:
        """Return where a column or row begins, counted from 1."""
        known = len(self._begins)
        if number >= known:
            more = accumulate(map(self._size, range(known - 1, number)), initial=self._begins[-1])
            self._begins += list(more)[1:]
        return self._begins[number]

    def middle(self, number: int) -> float:
        """Return its middle."""
        return 0.5 * (self.begin(number) + self.begin(number + 1))


def columns_of(sheet: Worksheet) -> Callable[[int], float]:
    """Return the width of each column."""
    usual = sheet.sheet_format.defaultColWidth or WIDTH
    told: dict[int, float] = {}
    for letter, column in sheet.column_dimensions.items():
        first = column.min or column_index_from_string(letter)
        width = 0.0 if column.hidden else column.width or usual
        told |= dict.fromkeys(range(first, (column.max or first) + 1), width)
    return lambda number: PIXEL * int(told.get(number, usual) * DIGIT + MARGIN) if told.get(number, usual) else 0.0


def rows_of(sheet: Worksheet) -> Callable[[int], float]:
    """Return the height of each row."""
    usual = sheet.sheet_format.defaultRowHeight or HEIGHT
    told = {number: 0.0 if row.hidden else row.height or usual for number, row in sheet.row_dimensions.items()}
    return lambda number: POINT * told.get(number, usual)
