"""What of a book is in sight: sheets, rows, columns and drawings (EMU), what its windows show, what is printed."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import accumulate
from typing import NamedTuple
from xml.etree.ElementTree import Element

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, OK, SHOWN, Report
from workbook.judging.shown import taste
from workbook.judging.shown.formats import Judged
from workbook.judging.shown.looks import Seen, Told, is_verdict
from workbook.judging.shown.words import sheet_of
from workbook.reading.contents import Cells
from workbook.reading.drawings import PIXEL, Anchor, Corner
from workbook.reading.package import tag

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
        self._down = begins(lambda row: POINT * self._heights.get(row, self._height))
        self._right = begins(lambda column: pixels(self._widths.get(column, self._width)))

        def point(at: Corner) -> tuple[float, float]:
            return self._right(at.column + 1) + at.right, self._down(at.row + 1) + at.down

        ends = [(point(one.first), point(one.last) if one.last else None, one.size) for one in anchors]
        self.areas = [Area(x, y, *(last or (x + wide, y + high))) for (x, y), last, (wide, high) in ends]

    def out_of_sight(self, at: Address) -> str:
        """Return why a cell, or its middle, is not shown; nothing where it is."""
        if self._heights.get(at.row, self._height) < taste.LEAST_HEIGHT:
            return "in a hidden row"
        if self._widths.get(at.column, self._width) < taste.LEAST_WIDTH:
            return "in a hidden column"
        if at.row < self._first[0] or at.column < self._first[1]:
            return "beyond what is frozen"
        if not self.areas:
            return ""
        x, y = (0.5 * (to(n) + to(n + 1)) for n, to in ((at.column, self._right), (at.row, self._down)))
        behind = any(one.left < x < one.right and one.top < y < one.bottom for one in self.areas)
        return "behind a drawing" if behind else ""

    def hidden_rows(self, first: int, last: int) -> int:
        """Return how many of some rows are hidden."""
        return sum(self._heights.get(row, self._height) < taste.LEAST_HEIGHT for row in range(first, last + 1))


def begins(size: Callable[[int], float]) -> Callable[[int], float]:
    """Return what gives where a column or row begins, counted from 1, of the sizes of those beside each other."""
    known = [0.0, 0.0]

    def begin(number: int) -> float:
        if number >= len(known):
            known.extend(list(accumulate(map(size, range(len(known) - 1, number)), initial=known.pop())))
        return known[number]

    return begin


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


class Views:
    """What is out of sight on each sheet of a file."""

    def __init__(self, match: Match, computed: Cells, report: Report, told: Told) -> None:
        self._match, self._computed, self._report, self._told = match, computed, report, told
        drawings = match.file.inspected.drawings if match.file.inspected else {}
        sheets = match.file.workbook.worksheets
        self.pages = {sheet.title: Page(sheet, drawings.get(sheet.title, [])) for sheet in sheets}
        self._ours = {title: sheet for sheet in match.declared.sheets if (title := sheet_of(match, sheet))}
        self._overall = {"overall", *(f"status{n}" for n, _ in enumerate(match.declared.sheets, 1))}

    def judge(self, cells: list[Seen]) -> None:
        """Enter what is out of sight."""
        inspected = self._match.file.inspected
        for said in of_settings(inspected.book) if inspected else ():
            self._told.add(Address("", 1, 1), said, "as built", "the windows of the book")
        for title, sheet in self._ours.items():
            first = Address(title, 1, 1)
            for said in of_page(inspected.pages[title]) if inspected else ():
                self._told.add(first, said, "as built", f"the view of {title}")
            if self.pages[title].hidden:
                self._told.add(first, (self._replaced(title), "hidden"), "shown", f"the sheet {title}")
            self._printed(title, sheet)
        for one in (one for one in cells if not one.folded):
            if not one.pairs and (reason := self.pages[one.at.sheet].out_of_sight(one.at)):
                self._told.add(one.at, (NOTICE, reason), "in sight", one.what, group="")
            for pair in one.pairs:
                self._judge(pair)

    def _judge(self, pair: Pair) -> None:
        """Enter that a declared cell is out of sight."""
        at, verdict, page = pair.address, is_verdict(pair), self.pages[pair.address.sheet]
        value, said = self._computed.get(at, pair.cell.expected), page.out_of_sight(at)
        if not said and verdict and page.hidden and value != OK:
            said = "on a hidden sheet"
        if said and verdict and (value != OK or pair.cell.block.name in self._overall):
            self._report.say(at, SHOWN, f"{value}, {said}", "in sight", pair.what)
        elif said:
            self._told.add(at, (NOTICE, said), "in sight", pair.what, group="")

    def _replaced(self, title: str) -> str:
        """Return of which kind a hidden sheet is: one that another, in sight, looks like misleads."""
        ours = texts_of(self._match.file.workbook[title])
        others = [one for one in self._match.file.workbook.worksheets
                  if one.title not in self._ours and not self.pages[one.title].hidden]  # fmt: skip
        return SHOWN if any(len(ours & texts_of(other)) > taste.ALIKE * len(ours) for other in others) else NOTICE

    def _printed(self, title: str, sheet: Sheet) -> None:
        """Enter that a verdict is printed no more."""
        area = self._match.file.workbook[title].print_area
        ranges = [part.rpartition("!")[2].replace("$", "").split(":") for part in str(area or "").split(",")]
        printed = [(corner(ends[0]), corner(ends[1])) for ends in ranges if len(ends) == 2]
        for block in sheet.blocks if area and not sheet.unprinted else ():
            place = self._match.file.places.get(block.name)
            due = block.quantities[0].role == "check" and block.row <= (sheet.print_rows or sheet.row)
            if due and place is not None and place.sheet == title and not any(
                top <= place.row <= bottom and left <= place.column <= right for (top, left), (bottom, right) in printed
            ):  # fmt: skip
                self._told.add(place.cell(0, 0), (NOTICE, "not printed"), "within the print area", block.name)


def texts_of(sheet: Worksheet) -> set[str]:
    """Return the texts of a sheet."""
    return {cell.value for cell in sheet._cells.values() if cell.data_type == "s" and isinstance(cell.value, str)}


def of_settings(root: Element) -> Iterator[Judged]:
    """Yield what is to be told of the settings in a part."""
    elements = [one for one in root.iter() if tag(one) != "pane" or one.get("state", "").startswith("frozen")]
    for name, attribute, usual, kind, said in taste.SETTINGS:
        for held in (one.get(attribute) for one in elements if tag(one) == name):
            if held is not None and (held not in usual if isinstance(usual, tuple) else int(float(held)) not in usual):
                yield kind, said


def of_page(page: Element) -> Iterator[Judged]:
    """Yield what is to be told of the views of a sheet, and of what it holds besides cells."""
    yield from of_settings(page)
    for element in page:
        parts, name = list(element), tag(element)
        if name not in taste.PAGE:
            yield NOTICE, f"with {name}"
        if name == "sheetViews" and len(parts) > 1:
            yield NOTICE, f"{len(parts)} views"
        if name == "headerFooter" and any(taste.TELLING.search(taste.CODES.sub("", one.text or "")) for one in parts):
            yield NOTICE, "figures or a verdict in its header or footer"
        for newer in {tag(one) for part in parts for one in part if name == "extLst"} - taste.NEWER:
            yield NOTICE, f"with {newer} for newer programs"


def links(match: Match, told: Told) -> None:
    """Enter links that lead from a declared cell to another sheet than they should, or out of the book."""
    titles = {sheet.title: sheet_of(match, sheet) for sheet in match.declared.sheets}
    for sheet in match.declared.sheets:
        declared = {" ".join(text.text.split()): titles.get(text.link) for text in sheet.texts if text.link}
        title = titles[sheet.title] or ""
        for (row, column), cell in match.file.workbook[title]._cells.items() if title else ():
            link, at = cell.hyperlink, Address(title, row, column)
            if link is None or not isinstance(cell.value, str):
                continue
            said, target = " ".join(cell.value.split()), str(link.location or "").rpartition("!")[0]
            leads = not link.target and target.strip("#'").replace("''", "'") == declared.get(said)
            if at in match.declared_at or (said in declared and not leads):
                told.add(at, (NOTICE, f"a link to {link.target or link.location}"), "as built", said)
