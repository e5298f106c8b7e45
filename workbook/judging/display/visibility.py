"""Whether cells can be seen: hidden sheets, rows and columns, drawings over them (EMU), windows, print areas."""

import re
from bisect import bisect_left
from collections.abc import Iterator, Mapping
from itertools import accumulate
from typing import Any, NamedTuple, Self
from xml.etree.ElementTree import Element

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.book.quantity import OK
from workbook.judging.display import permitted
from workbook.judging.display.cell_styles import CellGroup, Remarks
from workbook.judging.display.formats import Remark
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, SHOWN, Report
from workbook.reading.contents import Cells
from workbook.reading.package import PIXEL, Anchor
from workbook.reading.rows import LAST_ROW, tag

POINT = 12700  # EMU
WIDTH, HEIGHT = 8.43, 15.0  # of a column, in characters of 7 pixels, and of a row, in points, where none is given
DIGIT, MARGIN = 7, 5  # pixels
CELL = re.compile("([A-Z]{1,3})([1-9][0-9]{0,6})")


class Rectangle(NamedTuple):
    """A rectangle on a sheet."""

    left: float
    top: float
    right: float
    bottom: float

    def shared(self, other: Self) -> float:
        """Return which share of this is behind another; 0 of one that has no size."""
        wide = max(min(self.right, other.right) - max(self.left, other.left), 0.0)
        high = max(min(self.bottom, other.bottom) - max(self.top, other.top), 0.0)
        size = (self.right - self.left) * (self.bottom - self.top)
        return wide * high / size if size > 0 else 0.0


class Lengths:
    """The heights of a sheet's rows or the widths of its columns, counted from 1; below ``least`` one is hidden."""

    def __init__(self, given: Mapping[int, float], usual: float, least: float) -> None:
        self._given, self._usual, self._least = given, usual, least
        self._numbers = sorted(given)
        self._more = list(accumulate((given[number] - usual for number in self._numbers), initial=0.0))

    def hidden(self, number: int) -> bool:
        """Whether a row or column cannot be seen."""
        return self._given.get(number, self._usual) < self._least

    def begin(self, number: float) -> float:
        """Return where a row or column begins; with a half, its middle."""
        whole = int(number)
        before = self._usual * (whole - 1) + self._more[bisect_left(self._numbers, whole)]
        return before + (number - whole) * self._given.get(whole, self._usual)


class SheetView:
    """A sheet of the file as it is seen."""

    def __init__(self, sheet: Worksheet, anchors: list[Anchor]) -> None:
        form, view, pane = sheet.sheet_format, sheet.sheet_view, sheet.sheet_view.pane
        self.hidden = sheet.sheet_state != "visible"
        row_height = HEIGHT if form.defaultRowHeight is None else form.defaultRowHeight
        height: float = 0.0 if form.zeroHeight else POINT * row_height
        heights = {number: 0.0 if row.hidden else height if row.height is None else POINT * row.height
                   for number, row in sheet.row_dimensions.items()}  # fmt: skip
        self.rows = Lengths(heights, height, POINT * permitted.LEAST_HEIGHT)
        usual: float = WIDTH if form.defaultColWidth is None else form.defaultColWidth
        widths: dict[int, float] = {}
        for letter, column in sheet.column_dimensions.items():
            first = column.min or column_index_from_string(letter)
            width = 0.0 if column.hidden else pixels(usual if column.width is None else column.width)
            widths |= dict.fromkeys(range(first, (column.max or first) + 1), width)
        self._columns = Lengths(widths, pixels(usual), pixels(permitted.LEAST_WIDTH))
        self._first = (1, 1)  # row and column that can be scrolled to: nothing leads before those that are frozen
        if pane is not None and str(pane.state).startswith("frozen") and view.topLeftCell:
            found = CELL.fullmatch(str(view.topLeftCell))
            row, letters = (int(found[2]), found[1]) if found else (LAST_ROW, "XFD")
            self._first = row if pane.ySplit else 1, column_index_from_string(letters) if pane.xSplit else 1
        self.areas = []
        for one in anchors:
            (left, top), *last = ((self._columns.begin(at.column + 1) + at.right, self.rows.begin(at.row + 1) + at.down)
                                  for at in (one.first, one.last) if at is not None)  # fmt: skip
            self.areas.append(Rectangle(left, top, *(last[0] if last else (left + one.size[0], top + one.size[1]))))

    def out_of_sight(self, at: Address) -> str:
        """Return why a cell, or its middle, is not shown; nothing where it is."""
        if self.rows.hidden(at.row):
            return "in a hidden row"
        if self._columns.hidden(at.column):
            return "in a hidden column"
        if at.row < self._first[0] or at.column < self._first[1]:
            return "beyond what is frozen"
        if not self.areas:
            return ""
        x, y = self._columns.begin(at.column + 0.5), self.rows.begin(at.row + 0.5)
        behind = any(one.left < x < one.right and one.top < y < one.bottom for one in self.areas)
        return "behind a drawing" if behind else ""


def pixels(width: float) -> float:
    """Return the size of a column of so many characters."""
    return PIXEL * int(width * DIGIT + MARGIN) if width else 0.0


def sheet_views(match: Match) -> dict[str, SheetView]:
    """Return all sheets of a file as they are seen."""
    drawings = match.file.inspected.drawings if match.file.inspected else {}
    return {sheet.title: SheetView(sheet, drawings.get(sheet.title, [])) for sheet in match.file.workbook.worksheets}


def check_visibility(
    match: Match, seen: Mapping[str, SheetView], computed: Cells, cells: list[CellGroup], report: Report, told: Remarks
) -> None:
    """Enter what is out of sight: settings, sheets, and cells of the declaration."""
    inspected, workbook = match.file.inspected, match.file.workbook
    if inspected:
        told.add(Address("", 1, 1), setting_remarks(inspected.book), "as built", "the windows of the book")
    ours = {title: sheet for sheet, title in match.sheets}
    others = [texts_of(one) for one in workbook.worksheets if one.title not in ours and not seen[one.title].hidden]
    for title, sheet in ours.items():
        first = Address(title, 1, 1)
        if inspected:
            told.add(first, view_remarks(inspected.pages[title]), "as built", f"the view of {title}")
        if seen[title].hidden:  # another that looks like it misleads
            texts = texts_of(workbook[title])
            replaced = any(len(texts & other) > permitted.ALIKE * len(texts) for other in others)
            told.add(first, [(SHOWN if replaced else NOTICE, "hidden")], "shown", f"the sheet {title}")
        check_print_area(match, title, sheet, told)
    overall = {"overall", *(f"status{n}" for n, _ in enumerate(match.declared.sheets, 1))}
    for one in (one for one in cells if not one.folded):
        page = seen[one.at.sheet]
        held: list[Any] = [(p.address, p.what, computed.get(p.address, p.cell.expected)) for p in one.pairs]
        for at, what, value in held or [(one.at, one.what, None)]:
            said = page.out_of_sight(at)
            if not said and one.verdict and page.hidden and value != OK:
                said = "on a hidden sheet"
            if said and one.verdict and (value != OK or one.pairs[0].cell.block.name in overall):
                report.say(at, SHOWN, f"{value}, {said}", "in sight", what)
            elif said:
                told.add(at, [(NOTICE, said)], "in sight", what, group="")


def check_print_area(match: Match, title: str, sheet: Sheet, told: Remarks) -> None:
    """Enter that a verdict is printed no more."""
    area: Any = match.file.workbook[title]._print_area  # type: ignore[attr-defined]
    within = [cells.bounds for cells in area.ranges] if area else []
    for block, place in match.placed(sheet) if area and not sheet.unprinted else ():
        due = block.quantities[0].role == "check" and block.row <= (sheet.print_rows or sheet.row)
        kept = any(left <= place.column <= right and top <= place.row <= bottom for left, top, right, bottom in within)
        if due and place.sheet == title and not kept:
            told.add(place.cell(0, 0), [(NOTICE, "not printed")], "within the print area", block.name)


def texts_of(sheet: Worksheet) -> set[Any]:
    """Return the texts of a sheet."""
    return {cell.value for cell in sheet._cells.values() if cell.data_type == "s"}


def setting_remarks(root: Element) -> Iterator[Remark]:
    """Yield what is to be told of the settings in a part."""
    elements = [one for one in root.iter() if tag(one) != "pane" or one.get("state", "").startswith("frozen")]
    for name, attribute, usual, kind, said in permitted.SETTINGS:
        for held in (one.get(attribute) for one in elements if tag(one) == name):
            if held is not None and (held not in usual if isinstance(usual, tuple) else int(float(held)) not in usual):
                yield kind, said


def view_remarks(page: Element) -> Iterator[Remark]:
    """Yield what is to be told of the views of a sheet, and of what it holds besides cells."""
    yield from setting_remarks(page)
    for element in page:
        parts, name = list(element), tag(element)
        if name not in permitted.PAGE:
            yield NOTICE, f"with {name}"
        if name == "sheetViews" and len(parts) > 1:
            yield NOTICE, f"{len(parts)} views"
        if name == "headerFooter" and any(
            permitted.TELLING.search(permitted.CODES.sub("", one.text or "")) for one in parts
        ):
            yield NOTICE, "figures or a verdict in its header or footer"
        for newer in {tag(one) for part in parts for one in part if name == "extLst"} - permitted.NEWER:
            yield NOTICE, f"with {newer} for newer programs"


def check_links(match: Match, told: Remarks) -> None:
    """Enter links that lead from a declared cell to another sheet than they should, or out of the book."""
    titles = {sheet.title: title for sheet, title in match.sheets}
    for sheet, title in match.sheets:
        declared = {" ".join(text.text.split()): titles.get(text.link) for text in sheet.texts if text.link}
        for (row, column), cell in match.file.workbook[title]._cells.items():
            link, at = cell.hyperlink, Address(title, row, column)
            if link is None or not isinstance(cell.value, str):
                continue
            said, target = " ".join(cell.value.split()), str(link.location or "").rpartition("!")[0]
            leads = not link.target and target.strip("#'").replace("''", "'") == declared.get(said)
            if at in match.numbers or (said in declared and not leads):
                told.add(at, [(NOTICE, f"a link to {link.target or link.location}")], "as built", said)
