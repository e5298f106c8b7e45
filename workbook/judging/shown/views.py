"""What of a book is in sight: sheets, rows and columns, what its windows and views show, what is printed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, OK, SHOWN, Report
from workbook.judging.shown.covered import Layout
from workbook.judging.shown.formats import Judged
from workbook.judging.shown.seen import Seen, Told, is_overall, is_verdict
from workbook.judging.shown.words import sheet_of
from workbook.reading.contents import Cells
from workbook.reading.package import tag

LEAST_WIDTH, LEAST_HEIGHT = 1.0, 3.0  # characters; points of a row
LEAST_ZOOM = 30  # per cent
MOST_FROZEN = {"xSplit": 12, "ySplit": 45}  # columns and rows that a window must hold whole
ALIKE = 0.5  # of the texts of a sheet, from which on another looks like it
CELL = re.compile("([A-Z]{1,3})([1-9][0-9]{0,6})")
YES, NO = frozenset(("1", "true")), frozenset(("0", "false"))
KNOWN = frozenset([
    "AlternateContent", "autoFilter", "cellWatches", "colBreaks", "cols", "conditionalFormatting",
    "dataValidations", "dimension", "drawing", "drawingHF", "extLst", "headerFooter", "hyperlinks", "ignoredErrors",
    "legacyDrawing", "legacyDrawingHF", "mergeCells", "pageMargins", "pageSetup", "phoneticPr", "printOptions",
    "protectedRanges", "rowBreaks", "sheetData", "sheetFormatPr", "sheetPr", "sheetProtection", "sheetViews",
    "sortState", "tableParts",
])  # fmt: skip
"""the elements of a worksheet that are judged elsewhere, or change nothing of what is read"""


class Views:
    """What is out of sight on each sheet of a file."""

    def __init__(self, match: Match, computed: Cells, report: Report, told: Told) -> None:
        self._match, self._computed, self._report, self._told = match, computed, report, told
        drawings = match.file.inspected.drawings if match.file.inspected else {}
        sheets = match.file.workbook.worksheets
        self.layouts = {sheet.title: Layout(sheet, drawings.get(sheet.title, [])) for sheet in sheets}
        self.hidden = {sheet.title: Hidden(sheet) for sheet in sheets}
        self._ours = {title: sheet for sheet in match.declared.sheets if (title := sheet_of(match, sheet))}

    def judge(self, cells: list[Seen]) -> None:
        """Enter what is out of sight."""
        inspected = self._match.file.inspected
        for said in of_book(inspected.book) if inspected else ():
            self._told.add(Address("", 1, 1), said, "as built", "the windows of the book")
        for title, sheet in self._ours.items():
            first = Address(title, 1, 1)
            if inspected is not None:
                for said in of_page(inspected.pages[title]):
                    self._told.add(first, said, "as built", f"the view of {title}")
            if self.hidden[title].sheet:
                self._told.add(first, (self._replaced(title), "hidden"), "shown", f"the sheet {title}")
            self._printed(title, sheet)
        for one in cells:
            self._judge(one)

    def _judge(self, one: Seen) -> None:
        """Enter which of some cells are out of sight."""
        title = one.at.sheet
        if one.folded:
            return
        if not one.pairs and (said := self._out_of_sight(one.at)):
            self._told.add(one.at, (NOTICE, said), "in sight", one.what, group="")
        for pair in one.pairs:
            verdict, said = is_verdict(pair), self._out_of_sight(pair.address, pair)
            if not said and verdict and self.hidden[title].sheet:
                said = "on a hidden sheet" if self._fails(pair) else ""
            if not said:
                continue
            if verdict and (self._fails(pair) or is_overall(self._match, pair)):
                self._report.say(pair.address, SHOWN, f"{self._value(pair)}, {said}", "in sight", pair.what)
            else:
                self._told.add(pair.address, (NOTICE, said), "in sight", pair.what, group="")

    def _out_of_sight(self, at: Address, pair: Pair | None = None) -> str:
        """Return why a cell is not shown; nothing where it is, or a fresh build folds it away."""
        said = self.hidden[at.sheet].said(at)
        judged = pair is not None and (is_verdict(pair) or pair.cell.quantity.role == "result")
        return said or ("behind a drawing" if judged and self.layouts[at.sheet].covered(at) else "")

    def _value(self, pair: Pair) -> Any:
        return self._computed.get(pair.address, pair.cell.expected)

    def _fails(self, pair: Pair) -> bool:
        return bool(self._value(pair) != OK)

    def _replaced(self, title: str) -> str:
        """Return of which kind a hidden sheet is: one that another, in sight, looks like misleads."""
        ours = texts_of(self._match.file.workbook[title])
        others = [
            s
            for s in self._match.file.workbook.worksheets
            if s.title not in self._ours and not self.hidden[s.title].sheet
        ]
        alike = any(len(ours & texts_of(other)) > ALIKE * len(ours) for other in others)
        return SHOWN if alike else NOTICE

    def _printed(self, title: str, sheet: Sheet) -> None:
        """Enter that a verdict is printed no more."""
        area = self._match.file.workbook[title].print_area
        if not area or sheet.unprinted:
            return
        printed = [tuple(corner(end) for end in part.rpartition("!")[2].replace("$", "").split(":"))
                   for part in str(area).split(",") if ":" in part]  # fmt: skip
        for block in sheet.blocks:
            place = self._match.file.places.get(block.name)
            if block.quantities[0].role == "check" and place is not None and place.sheet == title:
                inside = any(len(ends) == 2 and ends[0][0] <= place.row <= ends[1][0]
                             and ends[0][1] <= place.column <= ends[1][1] for ends in printed)  # fmt: skip
                if not inside and block.row <= (sheet.print_rows or sheet.row):
                    self._told.add(place.cell(0, 0), (NOTICE, "not printed"), "within the print area", block.name)


def corner(text: str) -> tuple[int, int]:
    """Return row and column of a cell; beyond all where it is none."""
    found = CELL.fullmatch(text)
    return (int(found[2]), column_index_from_string(found[1])) if found else (10**7, 10**5)


def texts_of(sheet: Worksheet) -> set[str]:
    """Return the texts of a sheet."""
    return {cell.value for cell in sheet._cells.values() if cell.data_type == "s" and isinstance(cell.value, str)}


def of_book(book: Element) -> Iterator[Judged]:
    """Yield what is to be told of a book's own settings of what is shown."""
    for element in book.iter():
        if tag(element) == "workbookPr":
            if element.get("date1904") in YES:
                yield SHOWN, "dates counted from 1904"
            if element.get("showObjects", "all") != "all":
                yield SHOWN, "charts not shown"
        elif tag(element) == "workbookView":
            if element.get("visibility", "visible") != "visible":
                yield NOTICE, "a hidden window"
            if element.get("showSheetTabs") in NO:
                yield NOTICE, "tabs not shown"


def of_page(page: Element) -> Iterator[Judged]:
    """Yield what is to be told of the views of a sheet, and of what it holds besides cells."""
    for element in page:
        if tag(element) not in KNOWN:
            yield NOTICE, f"with {tag(element)}"
    for name in ("conditionalFormattings", "sparklineGroups"):
        if any(tag(one) == name for one in page.iter()):
            yield NOTICE, f"with {name} for newer programs"
    views = [view for element in page if tag(element) == "sheetViews" for view in element]
    if len(views) > 1:
        yield NOTICE, f"{len(views)} views"
    for view in (one for one in views if tag(one) == "sheetView"):
        yield from of_view(view)


def of_view(view: Element) -> Iterator[Judged]:
    """Yield what is to be told of one view of a sheet."""
    if view.get("showFormulas") in YES:
        yield SHOWN, "formulas in place of values"
    if view.get("showZeros") in NO:
        yield SHOWN, "zeros hidden"
    if view.get("rightToLeft") in YES:
        yield NOTICE, "from right to left"
    if float(view.get("zoomScale") or 100) < LEAST_ZOOM:
        yield NOTICE, "too small to be read"
    for pane in (one for one in view if tag(one) == "pane" and one.get("state", "").startswith("frozen")):
        if any(float(pane.get(name) or 0) > most for name, most in MOST_FROZEN.items()):
            yield NOTICE, "frozen beyond a window"


class Hidden:
    """What of a sheet is not shown: the sheet, rows and columns."""

    def __init__(self, sheet: Worksheet) -> None:
        self.sheet = sheet.sheet_state != "visible"
        self._rows = {number: short(row) for number, row in sheet.row_dimensions.items()}
        self._columns: dict[int, bool] = {}
        for letter, column in sheet.column_dimensions.items():
            first = column.min or column_index_from_string(letter)
            narrow = bool(column.hidden) or (column.width is not None and column.width < LEAST_WIDTH)
            self._columns |= dict.fromkeys(range(first, (column.max or first) + 1), narrow)
        form = sheet.sheet_format
        low = form.defaultRowHeight is not None and form.defaultRowHeight < LEAST_HEIGHT
        self._other_rows = bool(form.zeroHeight) or low
        self._other_columns = form.defaultColWidth is not None and form.defaultColWidth < LEAST_WIDTH
        self._first = frozen(sheet)

    def said(self, at: Address) -> str:
        """Return why a cell is not shown; nothing where it is."""
        if self._rows.get(at.row, self._other_rows):
            return "in a hidden row"
        if self._columns.get(at.column, self._other_columns):
            return "in a hidden column"
        return "beyond what is frozen" if at.row < self._first[0] or at.column < self._first[1] else ""

    def rows(self, first: int, last: int) -> int:
        """Return how many of some rows are hidden."""
        return sum(self._rows.get(row, self._other_rows) for row in range(first, last + 1))


def frozen(sheet: Worksheet) -> tuple[int, int]:
    """Return the first row and column that can be scrolled to: nothing leads before those that are frozen."""
    view = sheet.sheet_view
    first = CELL.fullmatch(str(view.topLeftCell or ""))
    if view.pane is None or not str(view.pane.state).startswith("frozen") or first is None:
        return 1, 1
    column, row = column_index_from_string(first[1]), int(first[2])
    return (row if view.pane.ySplit else 1), (column if view.pane.xSplit else 1)


def short(row: Any) -> bool:
    """Whether a row is hidden, or as good as that."""
    return bool(row.hidden) or (row.height is not None and row.height < LEAST_HEIGHT)


def links(match: Match, told: Told) -> None:
    """Enter links that lead from a declared cell to another sheet than they should, or out of the book."""
    titles = {sheet.title: sheet_of(match, sheet) for sheet in match.declared.sheets}
    for sheet in match.declared.sheets:
        page = match.file.workbook[title] if (title := titles[sheet.title]) else None
        declared = {" ".join(text.text.split()): titles.get(text.link) for text in sheet.texts if text.link}
        sheet_title = page.title if page is not None else ""
        for cell in page._cells.values() if page is not None else ():
            link = cell.hyperlink
            if link is None or not isinstance(cell.value, str):
                continue
            text, at = " ".join(cell.value.split()), Address(sheet_title, cell.row, cell.column)
            target = str(link.location or "").rpartition("!")[0].strip("#'").replace("''", "'")
            if at in match.addresses or (text in declared and (link.target or target != declared[text])):
                told.add(at, (NOTICE, f"a link to {link.target or link.location}"), "as built", text)
