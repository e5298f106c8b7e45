"""What is out of sight in a file: sheets, rows, columns, drawings over cells (EMU), windows, pages, links."""

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate
from typing import Any, NamedTuple, Self
from xml.etree.ElementTree import Element

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.quantity import OK
from workbook.judging.display.cells import CellGroup, FreshBook, shown_cells
from workbook.judging.display.groups import Differences
from workbook.judging.matching import Match
from workbook.reading.contents import Cells
from workbook.reading.package import PIXEL, Anchor
from workbook.reading.rows import LAST_ROW, tag

POINT = 12700  # EMU
WIDTH, HEIGHT = 8.43, 15.0  # of a column, in characters of 7 pixels, and of a row, in points, where none is given
DIGIT, MARGIN = 7, 5  # pixels
TOO_SMALL = 0.4  # of the width or height of a fresh build, below which a content is not shown whole
LEAST = 40_000  # EMU, 3 points: below it a row or column is as good as hidden
CELL = re.compile("([A-Z]{1,3})([1-9][0-9]{0,6})")
CODES = re.compile(r'&(?:"[^"]*"|[0-9]+|K[0-9A-F]{6}|[BIUEXYS])')  # of fonts in headers and footers
SETTINGS = (  # elements and attributes of a book and its views, what programs take where they are not given, misleading
    ("workbookPr", "date1904", "0", True),
    ("workbookPr", "showObjects", "all", True),
    ("workbookView", "visibility", "visible", False),
    ("workbookView", "minimized", "0", False),
    ("workbookView", "showSheetTabs", "1", False),
    ("sheetView", "showFormulas", "0", True),
    ("sheetView", "showZeros", "1", True),
    ("sheetView", "rightToLeft", "0", False),
    *(("sheetView", f"zoomScale{view}", "100", False) for view in ("", "Normal", "SheetLayoutView", "PageLayoutView")),
    ("pane", "ySplit", "0", False),
    ("pane", "xSplit", "0", False),
)
ZOOMS = frozenset(map(str, (0, *range(30, 401))))  # of page layouts, for which each program has its own; 0: usual
# the elements of a worksheet that are compared elsewhere, or draw nothing; all others are told
PAGE = frozenset(["AlternateContent", "autoFilter", "cellWatches", "colBreaks", "cols", "conditionalFormatting",
    "dataValidations", "dimension", "drawing", "extLst", "headerFooter", "hyperlinks", "ignoredErrors", "legacyDrawing",
    "mergeCells", "pageMargins", "pageSetup", "phoneticPr", "printOptions", "protectedRanges", "rowBreaks", "sheetData",
    "sheetFormatPr", "sheetPr", "sheetProtection", "sheetViews", "sortState"])  # fmt: skip
NEWER = frozenset(["dataValidations", "ignoredErrors"])  # such elements for newer programs, in an ``extLst``


class Rectangle(NamedTuple):
    """A rectangle on a sheet (EMU)."""

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
    """The heights of a sheet's rows or the widths of its columns (EMU), counted from 1."""

    def __init__(self, given: Mapping[int, float], usual: float) -> None:
        self._given, self._usual = given, usual
        self._numbers = sorted(given)
        self._more = list(accumulate((given[number] - usual for number in self._numbers), initial=0.0))

    def __getitem__(self, number: int) -> float:
        """Return the length of a row or column."""
        return self._given.get(number, self._usual)

    def begin(self, number: float) -> float:
        """Return where a row or column begins; with a half, its middle."""
        whole = int(number)
        before = self._usual * (whole - 1) + self._more[bisect_left(self._numbers, whole)]
        return before + (number - whole) * self[whole]


class SheetView:
    """A sheet as it is seen: sizes of rows and columns, where its window begins, what lies over its cells."""

    def __init__(self, sheet: Worksheet, anchors: Iterable[Anchor] = ()) -> None:
        form, view = sheet.sheet_format, sheet.sheet_view
        height = (
            0.0 if form.zeroHeight else POINT * (HEIGHT if form.defaultRowHeight is None else form.defaultRowHeight)
        )
        self.rows = Lengths(
            {
                number: 0.0 if row.hidden else height if row.height is None else POINT * row.height
                for number, row in sheet.row_dimensions.items()
            },
            height,
        )
        usual: float = WIDTH if form.defaultColWidth is None else form.defaultColWidth
        widths: dict[int, float] = {}
        for letter, column in sheet.column_dimensions.items():
            first = column.min or column_index_from_string(letter)
            width = 0.0 if column.hidden else pixels(usual if column.width is None else column.width)
            widths |= dict.fromkeys(range(first, min(column.max or first, 16_384) + 1), width)
        self.columns = Lengths(widths, pixels(usual))
        self._first = (1, 1)  # row and column that can be scrolled to: nothing leads before those that are frozen
        if (pane := view.pane) is not None and str(pane.state).startswith("frozen") and view.topLeftCell:
            cell = CELL.fullmatch(str(view.topLeftCell))
            row, letters = (int(cell[2]), cell[1]) if cell else (LAST_ROW, "XFD")
            self._first = row if pane.ySplit else 1, column_index_from_string(letters) if pane.xSplit else 1
        self.areas = [self._area(anchor) for anchor in anchors]

    def _area(self, anchor: Anchor) -> Rectangle:
        ends = [
            (self.columns.begin(at.column + 1) + at.right, self.rows.begin(at.row + 1) + at.down)
            for at in (anchor.first, anchor.last)
            if at is not None
        ]
        left, top = ends[0]
        return Rectangle(left, top, *(ends[1] if ends[1:] else (left + anchor.size[0], top + anchor.size[1])))

    def hides_column(self, column: int, usual: float) -> bool:
        """Whether a column is hidden, or narrow beside its ``usual`` width (EMU)."""
        return self.columns[column] < max(LEAST, TOO_SMALL * min(usual, pixels(WIDTH))) or column < self._first[1]

    def hides_row(self, row: int, usual: float) -> bool:
        """Whether a row is hidden, or low beside its ``usual`` height (EMU)."""
        return self.rows[row] < max(LEAST, TOO_SMALL * min(usual, POINT * HEIGHT)) or row < self._first[0]

    def areas_over(self, column: int) -> list[Rectangle]:
        """Return the drawings over the middle of a column."""
        middle = self.columns.begin(column + 0.5) if self.areas else 0.0
        return [area for area in self.areas if area.left < middle < area.right]


def pixels(width: float) -> float:
    """Return the size of a column of so many characters (EMU)."""
    return PIXEL * int(width * DIGIT + MARGIN) if width else 0.0


def sheet_views(match: Match) -> dict[str, SheetView]:
    """Return all sheets of a file as they are seen."""
    drawings = match.file.inspected.drawings if match.file.inspected else {}
    return {sheet.title: SheetView(sheet, drawings.get(sheet.title, [])) for sheet in match.file.workbook.worksheets}


def check_sight(
    match: Match,
    fresh: FreshBook,
    views: Mapping[str, SheetView],
    groups: Iterable[CellGroup],
    computed: Cells,
    differences: Differences,
) -> None:
    """Enter which declared cells are out of sight: a FAIL, or the verdict of a sheet or the book, misleads so."""
    fresh_views = {sheet.title: SheetView(sheet) for sheet in fresh.workbook.worksheets}
    overall = {"overall", *(f"status{n}" for n, _ in enumerate(match.declared.sheets, 1))}
    for group in (group for group in groups if not group.is_folded):
        at, view, page = group.at, views[group.at.sheet], fresh_views[group.declared_sheet]
        is_hidden = match.file.workbook[at.sheet].sheet_state != "visible"
        is_narrow = view.hides_column(at.column, page.columns[group.declared_column])
        areas = view.areas_over(at.column)
        for at, (_, row, _), expected in shown_cells(group):
            cause = "a hidden or narrow column" if is_narrow else ""
            if view.hides_row(at.row, page.rows[row]):
                cause = "a hidden or low row"
            elif areas and any(area.top < view.rows.begin(at.row + 0.5) < area.bottom for area in areas):
                cause = "a drawing over it"
            value = computed.get(at, expected) if group.is_verdict else OK
            if is_hidden and value != OK:
                cause = "a hidden sheet"
            if cause:
                misleads = group.is_verdict and (value != OK or group.pairs[0].cell.block.name in overall)
                differences.add(at, "sight", "in sight", f"hidden by {cause}", group.what, misleads)


def check_pages(match: Match, fresh: FreshBook, differences: Differences) -> None:
    """Enter settings of windows, views, headers, footers and print areas that are not those of a fresh build."""
    inspected, workbook = match.file.inspected, match.file.workbook
    if inspected:
        compare_settings(inspected.book, {}, Address("", 1, 1), "the windows of the book", differences)
    for sheet, title in match.sheets:
        ours, theirs, first = fresh.workbook[sheet.title], workbook[title], Address(title, 1, 1)
        if theirs.sheet_state != "visible":
            twin = any(is_twin(theirs, other) for other in workbook.worksheets if other is not theirs)
            differences.add(first, "sheet", "visible", theirs.sheet_state, title, misleads=twin)
        if theirs.protection.sheet != ours.protection.sheet:
            differences.add(first, "protection", "protected", "not protected", title, misleads=False)
        if inspected:
            split = {("pane", "ySplit"): str(sheet.head)}
            compare_settings(inspected.pages[title], split, first, f"the view of {title}", differences)
            for held in additional_elements(inspected.pages[title]):
                differences.add(first, "sheet", "as built", held, title, misleads=False)
        for expected, held in zip(page_texts(ours), page_texts(theirs), strict=True):
            if expected != held:
                differences.add(first, "header or footer", expected or "nothing", held or "nothing", title, False)
        check_print_area(match, title, sheet, theirs, differences)


def additional_elements(page: Element) -> Iterator[str]:
    """Yield the elements of a sheet's part that may show what no fresh build shows."""
    for element in page:
        if tag(element) not in PAGE:
            yield tag(element)
        if tag(element) == "sheetViews" and len(element) > 1:
            yield f"{len(element)} views"
        if tag(element) == "extLst":
            yield from sorted({tag(part) for extension in element for part in extension} - NEWER)


def compare_settings(
    root: Element, fresh: Mapping[tuple[str, str], str], at: Address, what: str, differences: Differences
) -> None:
    """Enter the settings in a part that are not as in a fresh build, which has what programs take but for ``fresh``."""
    for name, attribute, usual, misleads in SETTINGS:
        expected = fresh.get((name, attribute), usual)
        for element in (child for child in root.iter() if tag(child) == name):
            held = element.get(attribute, usual)
            held = {"true": "1", "false": "0"}.get(held, held.removesuffix(".0"))
            held = "100" if (usual, held) == ("100", "0") else held
            is_readable = attribute.endswith("LayoutView") and held in ZOOMS
            if held != expected and not is_readable:
                differences.add(at, f"{name} {attribute}", expected, held, what, misleads)


def is_twin(sheet: Worksheet, other: Worksheet) -> bool:
    """Whether another sheet in sight shows most of the texts of one that is hidden."""
    texts, more = ({cell.value for cell in page._cells.values() if cell.data_type == "s"} for page in (sheet, other))
    return other.sheet_state == "visible" and len(texts & more) > 0.5 * len(texts)


def page_texts(sheet: Worksheet) -> Iterator[str]:
    """Yield the texts of the headers and footers of a sheet, without their fonts."""
    for name in (f"{page}{place}" for page in ("odd", "even", "first") for place in ("Header", "Footer")):
        item = getattr(sheet, name)
        texts = [CODES.sub("", part.text or "") for part in (item.left, item.center, item.right)]
        yield "|".join(" ".join(text.split()) for text in texts).strip("|")


def check_print_area(match: Match, title: str, sheet: Any, page: Any, differences: Differences) -> None:
    """Enter that a verdict is printed no more."""
    area = page._print_area
    within = [cells.bounds for cells in area.ranges] if area else []
    for block, place in match.placed(sheet) if area and not sheet.unprinted else ():
        due = block.quantities[0].role == "check" and block.row <= (sheet.print_rows or sheet.row)
        printed = any(left <= place.column <= right and top <= place.row <= low for left, top, right, low in within)
        if due and place.sheet == title and not printed:
            differences.add(place.cell(0, 0), "print area", "with the verdict", "without it", block.name, False)


def check_links(match: Match, differences: Differences) -> None:
    """Enter links that lead from a declared cell to another sheet than they should, or out of the book."""
    titles = {sheet.title: title for sheet, title in match.sheets}
    for sheet, title in match.sheets:
        declared = {" ".join(text.text.split()): titles.get(text.link) for text in sheet.texts if text.link}
        for (row, column), cell in match.file.workbook[title]._cells.items():
            link, at = cell.hyperlink, Address(title, row, column)
            if link is None or not isinstance(cell.value, str):
                continue
            text, target = " ".join(cell.value.split()), str(link.location or "").rpartition("!")[0]
            is_ours = not link.target and target.strip("#'").replace("''", "'") == declared.get(text)
            if at in match.numbers or (text in declared and not is_ours):
                held = link.target or link.location
                differences.add(at, "link", declared.get(text) or "no link", held, text, misleads=False)
