"""The rows, columns and drawings of a sheet: where they are (EMU), and which are in sight."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import accumulate
from typing import NamedTuple

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.judging.shown import taste
from workbook.reading.drawings import PIXEL, Anchor, Corner

POINT = 12700  # EMU
WIDTH, HEIGHT = 8.43, 15.0  # of a column, in characters of 7 pixels, and of a row, in points, where none is given
DIGIT, MARGIN = 7, 5  # pixels
CELL = re.compile("([A-Z]{1,3})([1-9][0-9]{0,6})")


class Area(NamedTuple):
    """A rectangle on a sheet."""

    left: float
    top: float
    right: float
    bottom: float

    def shared(self, other: Area) -> float:
        """Return which share of this is behind another; 0 of one that has no size."""
        wide = max(min(self.right, other.right) - max(self.left, other.left), 0.0)
        high = max(min(self.bottom, other.bottom) - max(self.top, other.top), 0.0)
        size = (self.right - self.left) * (self.bottom - self.top)
        return wide * high / size if size > 0 else 0.0


class Page:
    """A sheet of the file as it is seen."""

    def __init__(self, sheet: Worksheet, anchors: list[Anchor]) -> None:
        self.hidden = sheet.sheet_state != "visible"
        form = sheet.sheet_format
        self._height = 0.0 if form.zeroHeight else or_else(form.defaultRowHeight, HEIGHT)
        self._heights = {number: 0.0 if row.hidden else or_else(row.height, self._height)
                         for number, row in sheet.row_dimensions.items()}  # fmt: skip
        self._width, self._widths = or_else(form.defaultColWidth, WIDTH), dict[int, float]()
        for letter, column in sheet.column_dimensions.items():
            first = column.min or column_index_from_string(letter)
            width = 0.0 if column.hidden else or_else(column.width, self._width)
            self._widths |= dict.fromkeys(range(first, (column.max or first) + 1), width)
        view, pane = sheet.sheet_view, sheet.sheet_view.pane
        self._first = (1, 1)
        """the first row and column that can be scrolled to: nothing leads before those that are frozen"""
        if pane is not None and str(pane.state).startswith("frozen") and view.topLeftCell:
            row, left = corner(str(view.topLeftCell))
            self._first = row if pane.ySplit else 1, left if pane.xSplit else 1
        self._down = Line(lambda row: POINT * self._heights.get(row, self._height))
        self._right = Line(lambda column: pixels(self._widths.get(column, self._width)))
        self.areas = [self._area(anchor) for anchor in anchors]

    def out_of_sight(self, at: Address) -> str:
        """Return why a cell is not shown; nothing where it is."""
        if self._heights.get(at.row, self._height) < taste.LEAST_HEIGHT:
            return "in a hidden row"
        if self._widths.get(at.column, self._width) < taste.LEAST_WIDTH:
            return "in a hidden column"
        return "beyond what is frozen" if at.row < self._first[0] or at.column < self._first[1] else ""

    def covered(self, at: Address) -> bool:
        """Whether the middle of a cell is behind a drawing."""
        x, y = (self._right.middle(at.column), self._down.middle(at.row)) if self.areas else (0.0, 0.0)
        return any(area.left < x < area.right and area.top < y < area.bottom for area in self.areas)

    def hidden_rows(self, first: int, last: int) -> int:
        """Return how many of some rows are hidden."""
        return sum(self._heights.get(row, self._height) < taste.LEAST_HEIGHT for row in range(first, last + 1))

    def _area(self, anchor: Anchor) -> Area:
        left, top = self._point(anchor.first)
        right, bottom = self._point(anchor.last) if anchor.last else (left + anchor.size[0], top + anchor.size[1])
        return Area(left, top, right, bottom)

    def _point(self, at: Corner) -> tuple[float, float]:
        return self._right.begin(at.column + 1) + at.right, self._down.begin(at.row + 1) + at.down


class Line:
    """Columns beside each other, or rows below each other: where each begins."""

    def __init__(self, size: Callable[[int], float]) -> None:
        self._size, self._begins = size, [0.0, 0.0]

    def begin(self, number: int) -> float:
        """Return where a column or row begins, counted from 1."""
        known = len(self._begins)
        if number >= known:
            more = accumulate(map(self._size, range(known - 1, number)), initial=self._begins.pop())
            self._begins += more
        return self._begins[number]

    def middle(self, number: int) -> float:
        """Return its middle."""
        return 0.5 * (self.begin(number) + self.begin(number + 1))


def pixels(width: float) -> float:
    """Return the size of a column of so many characters."""
    return PIXEL * int(width * DIGIT + MARGIN) if width else 0.0


def or_else(given: float | None, usual: float) -> float:
    """Return a size, the usual one where none is given."""
    return usual if given is None else given


def corner(text: str) -> tuple[int, int]:
    """Return row and column of a cell; beyond all where it is none."""
    found = CELL.fullmatch(text)
    return (int(found[2]), column_index_from_string(found[1])) if found else (10**7, 10**5)
