"""What of a book is in sight: sheets, rows and columns, what its windows and views show, what is printed."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree.ElementTree import Element

from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, OK, SHOWN, Report
from workbook.judging.shown import taste
from workbook.judging.shown.formats import Judged
from workbook.judging.shown.page import Page, corner
from workbook.judging.shown.seen import Seen, Told, is_overall, is_verdict
from workbook.judging.shown.words import sheet_of
from workbook.reading.contents import Cells
from workbook.reading.package import tag


class Views:
    """What is out of sight on each sheet of a file."""

    def __init__(self, match: Match, computed: Cells, report: Report, told: Told) -> None:
        self._match, self._computed, self._report, self._told = match, computed, report, told
        drawings = match.file.inspected.drawings if match.file.inspected else {}
        sheets = match.file.workbook.worksheets
        self.pages = {sheet.title: Page(sheet, drawings.get(sheet.title, [])) for sheet in sheets}
        self._ours = {title: sheet for sheet in match.declared.sheets if (title := sheet_of(match, sheet))}

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
        page, verdict = self.pages[pair.address.sheet], is_verdict(pair)
        value = self._computed.get(pair.address, pair.cell.expected)
        said = page.out_of_sight(pair.address)
        if not said and (verdict or pair.cell.quantity.role == "result") and page.covered(pair.address):
            said = "behind a drawing"
        if not said and verdict and page.hidden and value != OK:
            said = "on a hidden sheet"
        if said and verdict and (value != OK or is_overall(self._match, pair)):
            self._report.say(pair.address, SHOWN, f"{value}, {said}", "in sight", pair.what)
        elif said:
            self._told.add(pair.address, (NOTICE, said), "in sight", pair.what, group="")

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
    for element in root.iter():
        for name, attribute, usual, kind, said in taste.SETTINGS:
            if tag(element) == name and element.get(attribute, usual[0]) not in usual:
                yield kind, said


def of_page(page: Element) -> Iterator[Judged]:
    """Yield what is to be told of the views of a sheet, and of what it holds besides cells."""
    yield from of_settings(page)
    yield from ((NOTICE, f"with {tag(one)}") for one in page if tag(one) not in taste.PAGE)
    newer = {tag(one) for one in page.iter()} & {"conditionalFormattings", "sparklineGroups"}
    yield from ((NOTICE, f"with {name} for newer programs") for name in newer)
    views = [view for element in page if tag(element) == "sheetViews" for view in element if tag(view) == "sheetView"]
    if len(views) > 1:
        yield NOTICE, f"{len(views)} views"
    for view in views:
        if float(view.get("zoomScale") or 100) < taste.LEAST_ZOOM:
            yield NOTICE, "too small to be read"
        for pane in (one for one in view if tag(one) == "pane" and one.get("state", "").startswith("frozen")):
            if any(float(pane.get(name) or 0) > most for name, most in taste.MOST_FROZEN.items()):
                yield NOTICE, "frozen beyond a window"


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
            if at in match.addresses or (said in declared and not leads):
                told.add(at, (NOTICE, f"a link to {link.target or link.location}"), "as built", said)
