"""Sheets as they are seen: sizes of rows and columns, drawings over cells (EMU), windows, pages, links."""

import re
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Mapping
from itertools import accumulate
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from openpyxl import Workbook
from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.judging.display.differences import Differences, Subject
from workbook.judging.display.flat import Flat, flatten
from workbook.reading.package import NOTHING, PIXEL, Anchor, Corner
from workbook.reading.rows import LAST_ROW, tag

POINT = 12_700  # EMU
# of a column, in characters of 7 pixels, and of a row, in points, where none is given
WIDTH, HEIGHT = 8.43, 15.0
MOST = 409.5  # of both, in the same units
LAST_SEEN = 1_000  # columns: nothing that is declared lies beyond
# EMU, 26 pixels and 6 points: below it a column or row is as good as hidden
NARROW, LOW = 250_000, 76_000
CELL = re.compile("([A-Z]{1,3})([1-9][0-9]{0,6})")
HEADS = "oddHeader oddFooter evenHeader evenFooter firstHeader firstFooter".split()
CODES = re.compile(r'&(?:"[^"]*"|[0-9]+|K[0-9A-F]{6}|[BIUEXYS])')  # of fonts in headers and footers
SETTINGS = re.compile(  # of a book and its windows; all others, such as which cell is selected, are of a moment
    r".* (date1904|showObjects|visibility|minimized|showSheetTabs|showFormulas|showZeros|rightToLeft|zoomScale\w*"
    r"|[xy]Split|number)"
)
# the elements of a worksheet that are compared elsewhere, or draw nothing
QUIET = re.compile(
    "autoFilter|cellWatches|colBreaks|cols|conditionalFormatting|dataValidations|dimension|drawing|ext|extLst"
    "|headerFooter|hyperlinks|ignoredErrors|legacyDrawing|mergeCells|pageMargins|pageSetup|phoneticPr|printOptions"
    "|protectedRanges|rowBreaks|sheetData|sheetFormatPr|sheetPr|sheetProtection|sheetViews|sortState|AlternateContent"
)


class Rectangle(NamedTuple):
    """A rectangle on a sheet (EMU)."""

    left: float
    top: float
    right: float
    bottom: float

    def has(self, x: float, y: float) -> bool:
        """Whether a point lies within."""
        return self.left < x < self.right and self.top < y < self.bottom


class Lengths:
    """The heights of a sheet's rows or the widths of its columns (EMU), counted from 1."""

    def __init__(self, given: Mapping[int, float], usual: float) -> None:
        self._given, self._usual = given, usual
        self._numbers = sorted(given)
        self._more = list(accumulate((given[n] - usual for n in self._numbers), initial=0.0))

    def __getitem__(self, number: int) -> float:
        """Return the length of a row or column."""
        return self._given.get(number, self._usual)

    def begin(self, number: float) -> float:
        """Return where a row or column begins; with a half, its middle."""
        whole = int(number)
        before = self._usual * (whole - 1) + self._more[bisect_left(self._numbers, whole)]
        return before + (number - whole) * self[whole]


def row_heights(sheet: Worksheet) -> Lengths:
    """Return the heights of a sheet's rows, 0 of those that are hidden."""
    form, rows = sheet.sheet_format, sheet.row_dimensions.items()
    usual = 0.0 if form.zeroHeight else POINT * size(form.defaultRowHeight, HEIGHT)
    shown = {n: row.height for n, row in rows if not row.hidden}
    heights = {n: POINT * size(height, usual / POINT) for n, height in shown.items()}
    return Lengths({n: heights.get(n, 0.0) for n, _ in rows}, usual)


def column_widths(sheet: Worksheet) -> Lengths:
    """Return the widths of a sheet's columns, 0 of those that are hidden."""
    usual, widths = size(sheet.sheet_format.defaultColWidth, WIDTH), dict[int, float]()
    for letter, column in sheet.column_dimensions.items():
        first = column.min or column_index_from_string(letter)
        width = 0.0 if column.hidden else pixels(size(column.width, usual))
        widths |= dict.fromkeys(range(first, min(column.max or first, LAST_SEEN) + 1), width)
    return Lengths(widths, pixels(usual))


class SheetView:
    """A sheet as it is seen: sizes of rows and columns, where its window begins, what lies over its cells."""

    def __init__(self, sheet: Worksheet, anchors: Iterable[Anchor] = ()) -> None:
        self.is_hidden = sheet.sheet_state != "visible"
        self.rows, self.columns = row_heights(sheet), column_widths(sheet)
        # row and column that can be scrolled to: nothing leads before those that are frozen
        self._first = (1, 1)
        pane, first = sheet.sheet_view.pane, sheet.sheet_view.topLeftCell
        if pane is not None and first and str(pane.state).startswith("frozen"):
            cell = CELL.fullmatch(str(first))
            row, letters = (int(cell[2]), cell[1]) if cell else (LAST_ROW, "XFD")
            column = column_index_from_string(letters)
            self._first = row if pane.ySplit else 1, column if pane.xSplit else 1
        self.areas = [self._area(anchor) for anchor in anchors]

    def _area(self, anchor: Anchor) -> Rectangle:
        left, top = self._corner(anchor.first)
        width, height = anchor.size
        right, bottom = self._corner(anchor.last) if anchor.last else (left + width, top + height)
        return Rectangle(left, top, right, bottom)

    def _corner(self, at: Corner) -> tuple[float, float]:
        return self.columns.begin(at.column + 1) + at.right, self.rows.begin(at.row + 1) + at.down

    def hidden_by(self, row: int, column: int) -> str:
        """Return the cause that hides a cell; nothing of a cell in sight."""
        if self.columns[column] < NARROW or column < self._first[1]:
            return "a hidden or narrow column"
        if self.rows[row] < LOW or row < self._first[0]:
            return "a hidden or low row"
        if not self.areas:
            return ""
        middle = self.columns.begin(column + 0.5), self.rows.begin(row + 0.5)
        return "a drawing over it" if any(area.has(*middle) for area in self.areas) else ""


def size(given: float | None, usual: float) -> float:
    """Return a width or height that a file gives, the usual unless it is from 0 to :data:`MOST`."""
    return given if given is not None and 0 <= given <= MOST else usual


def pixels(width: float) -> float:
    """Return the size of a column of so many characters (EMU)."""
    return float(PIXEL * int(width * 7 + 5)) if width else 0.0


def compare_sheets(fresh: Workbook, differences: Differences) -> None:
    """Enter what of windows, views, headers and footers is not as in a fresh build."""
    match = differences.match
    inspected, titles = match.file.inspected, {sheet.title for sheet in match.declared.sheets}
    subject = Subject("the windows of the book")
    differences.compare(Address("", 1, 1), subject, {}, settings(inspected.book))
    for sheet, title in match.sheets:
        at, subject, page = Address(title, 1, 1), Subject(title), match.file.workbook[title]
        if title.casefold() != sheet.title.casefold():
            what = "sheet name of another" if title in titles else "sheet name"
            differences.add(at, subject, what, sheet.title, title)
        part = inspected.pages.get(title, NOTHING)
        theirs = page_attributes(page) | settings(part) | additions(part)
        usual = settings([fresh[sheet.title].views.to_tree("sheetViews")])
        # frozen panes may go
        usual = {name: value for name, value in usual.items() if name in theirs}
        differences.compare(at, subject, page_attributes(fresh[sheet.title]) | usual, theirs)
        compare_links(sheet, title, differences)
        compare_print_area(sheet, page, differences)


def settings(part: Iterable[Element]) -> Flat:
    """Return the settings of a book, or of the windows of a sheet."""
    flat = Flat()
    for child in part:
        if (name := tag(child)) in ("workbookPr", "bookViews", "sheetViews"):
            flat |= flatten(child, name)
            flat[f"{name} number"] = str(len(child)) if len(child) > 1 else ""
    return {name: value for name, value in flat.items() if SETTINGS.fullmatch(name)}


def additions(page: Element) -> Flat:
    """Return the elements of a sheet's part that may show what no fresh build shows."""
    names = {tag(e) for part in (page, *page.iterfind("{*}extLst/{*}ext")) for e in part}
    return {name: "added" for name in names if not QUIET.fullmatch(name)}


def page_attributes(sheet: Worksheet) -> Flat:
    """Return whether a sheet is in sight and protected, and its headers and footers without their fonts."""
    page = {"sheet": sheet.sheet_state, "protection": "on" if sheet.protection.sheet else "off"}
    for name in HEADS:
        item = getattr(sheet, name)
        texts = [CODES.sub("", part.text or "") for part in (item.left, item.center, item.right)]
        page[name] = "|".join(" ".join(text.split()) for text in texts).strip("|")
    return page


def compare_print_area(sheet: Sheet, page: Any, differences: Differences) -> None:
    """Enter verdicts that are printed no more."""
    printed = page._print_area.ranges if page._print_area and not sheet.unprinted else ()
    for block, place in differences.match.placed(sheet) if printed else ():
        is_check, last = block.quantities[0].role == "check", sheet.print_rows or sheet.row
        first = place.cell(0, 0)
        if is_check and block.row <= last and not any(first.a1 in cells for cells in printed):
            differences.add(first, Subject(block.name), "print area", "with it", "without it")


def compare_links(sheet: Sheet, title: str, differences: Differences) -> None:
    """Enter links of declared cells and texts that lead elsewhere."""
    match = differences.match
    titles = {declared.title: held for declared, held in match.sheets}
    # of texts: those of the same words lead on in the order of their rows
    of_words, of_cells = defaultdict[str, list[str]](list), dict[tuple[int, int], str]()
    links = (text for text in sheet.texts if text.link)
    for text in sorted(links, key=lambda text: (text.row, text.column)):
        target = titles.get(text.link, "")
        if text.text:
            of_words[" ".join(text.text.split())].append(target)
        else:
            of_cells[text.row, text.column] = target
    for (row, column), cell in sorted(match.file.workbook[title]._cells.items()):
        if (link := cell.hyperlink) is None:
            continue
        at, words = Address(title, row, column), " ".join(str(cell.value).split())
        if at in match.numbers:
            declared = match.pairs[match.numbers[at]].cell
            expected = of_cells.get((declared.row, declared.column), "")
        elif of_words.get(words):
            expected = of_words[words].pop(0)
        else:
            continue
        target = str(link.location or "").rpartition("!")[0].strip("#'").replace("''", "'")
        held = {"link": str(link.target or target)}
        differences.compare(at, Subject(words), {"link": expected}, held)
