"""Attributes of the declared cells of a file and of a fresh build: style, conditional formats, validation, sight."""

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from openpyxl import Workbook
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.book.quantity import OK
from workbook.judging.display.differences import Differences, Subject
from workbook.judging.display.flat import Flat, differing, flatten, in_words
from workbook.judging.display.formats import format_by_number, plain_number, shows_same
from workbook.judging.display.sheets import SheetView
from workbook.judging.display.texts import QUIET, Label
from workbook.judging.matching import Match, Pair
from workbook.reading.contents import Cells
from workbook.writing import archive
from workbook.writing.archive import Strings
from workbook.writing.write import make_workbook

WHITE, BLACK = "#FFFFFF", "#000000"
OVERALL = re.compile("overall|status[0-9]+")  # verdicts of the book and of each sheet, always to be in sight


class CellStyles(archive.Cells):
    """The numbers of the styles of a sheet's cells, by row and column, in place of cells that are written."""

    def __init__(self) -> None:
        super().__init__(Strings())
        self.numbers: dict[tuple[int, int], int] = {}

    def put(self, row: int, column: int, style: int, content: Any) -> None:
        """Keep the style of a cell."""
        self.numbers[row, column] = style

    def put_formula(self, row: int, column: int, style: int, formula: str, value: Any) -> None:
        """Keep the style of a formula cell."""
        self.numbers[row, column] = style


class FreshBook:
    """A declared book as openpyxl would save it, in memory: styles, pages and charts, without contents."""

    def __init__(self, declared: Book, model: type[BaseModel]) -> None:
        self._styles = {sheet.title: CellStyles() for sheet in declared.sheets}
        self.workbook: Any = make_workbook(declared, model, dict(self._styles))

    def style(self, sheet: str, row: int, column: int) -> Any:
        """Return the style of a cell, as openpyxl has it."""
        return self.workbook._cell_styles[self._styles[sheet].numbers.get((row, column), 0)]


class Spot(NamedTuple):
    """A cell in the file, the same in a fresh build, and what it shows."""

    at: Address
    sheet: str
    row: int
    column: int
    value: Any


class CellGroup(NamedTuple):
    """Cells of a column, from top to bottom: the column of a block, or a text that says what a cell is."""

    pairs: list[Pair]
    label: Label | None = None

    @property
    def subject(self) -> Subject:
        """The cells in words, and whether they say OK or FAIL."""
        if self.label:
            return Subject(self.label.what, is_remark=self.label.text.style in QUIET)
        quantity, block = self.pairs[0].cell.quantity, self.pairs[0].cell.block
        is_verdict = quantity.role == "check" or (block.name, quantity.name) == ("checks", "verdict")
        return Subject(f"{quantity.label} ({block.name})" if block.is_table else quantity.label, is_verdict)

    def spots(self) -> Iterator[Spot]:
        """Yield the cells."""
        if self.label:
            text = self.label.text
            yield Spot(self.label.at, self.label.block.sheet.title, text.row, text.column, text.text)
        for cell, at, held, has_formula in self.pairs:
            yield Spot(at, cell.block.sheet.title, cell.row, cell.column, cell.expected if has_formula else held)


def cell_look(book: Workbook, style: Any) -> Flat:
    """Return the attributes of a style of openpyxl's but for its number format."""
    whole: Any = book
    look = Flat()
    for name, part in (
        ("font", whole._fonts[style.fontId]),
        ("fill", whole._fills[style.fillId]),
        ("border", whole._borders[style.borderId]),
        ("alignment", whole._alignments[style.alignmentId]),
        ("protection", whole._protections[style.protectionId]),
    ):
        look |= flatten(part.to_tree(name), name)
    pattern, ground = look.get("fill patternFill patternType"), look.get("fill patternFill fgColor", BLACK)
    if pattern == "solid":
        look.pop("fill patternFill bgColor", None)
    seen = look.get("font color") or BLACK, ground if pattern == "solid" else pattern or WHITE
    return look | {"legible": "no" if seen[0] == seen[1] else "yes"}


def compare_cells(
    match: Match,
    fresh: FreshBook,
    groups: list[CellGroup],
    views: dict[str, SheetView],
    computed: Cells,
    differences: Differences,
) -> None:
    """Enter which declared cells look otherwise than in a fresh build, or are out of sight."""
    held_book, known = match.file.workbook, dict[tuple[Any, ...], Flat]()
    pages, fonts = {sheet.title: SheetView(sheet) for sheet in fresh.workbook.worksheets}, text_fonts(match)
    for group in groups:
        subject, unit = group.subject, group.pairs[0].cell.quantity.unit if group.pairs else ""
        for spot in group.spots():
            cell = match.file.cell(spot.at)
            style, is_text = fresh.style(*spot[1:4]), isinstance(spot.value, str)
            held: Any = cell._style if cell is not None else style  # type: ignore[union-attr]
            key = (tuple(style), tuple(held), is_text, unit)
            if key not in known:
                looks = cell_look(fresh.workbook, style), cell_look(held_book, held)
                codes = format_by_number(fresh.workbook, style.numFmtId), format_by_number(held_book, held.numFmtId)
                known[key] = dict(format_difference(*codes, is_text, unit)) | differing(*looks)
            if known[key]:
                differences.tell(spot.at, subject, known[key])
            if spot.at in fonts:
                differences.add(spot.at, subject, "fonts within the text", "", fonts[spot.at], misleads=False)
        compare_sight(group, views, pages, computed, differences)


def compare_sight(
    group: CellGroup,
    views: dict[str, SheetView],
    pages: dict[str, SheetView],
    computed: Cells,
    differences: Differences,
) -> None:
    """Enter which cells of a column are out of sight, but in sight in a fresh build."""
    first, subject = next(group.spots()), group.subject
    view, page = views[first.at.sheet], pages[first.sheet]
    if not page.columns[first.column]:
        return
    is_narrow = view.hides_column(first.at.column, page.columns[first.column])
    areas = view.areas_over(first.at.column)
    is_overall = bool(group.pairs) and bool(OVERALL.fullmatch(group.pairs[0].cell.block.name))
    for spot in group.spots():
        cause = "a hidden or narrow column" if is_narrow else ""
        if view.hides_row(spot.at.row, page.rows[spot.row]):
            cause = "a hidden or low row"
        elif areas and any(area.top < view.rows.begin(spot.at.row + 0.5) < area.bottom for area in areas):
            cause = "a drawing over it"
        elif view.is_hidden and subject.is_verdict and computed.get(spot.at, spot.value) != OK:
            cause = "a hidden sheet"
        counts = subject.is_verdict and (is_overall or computed.get(spot.at, spot.value) != OK)
        if cause:
            pair = {"sight": ("in sight", f"hidden by {cause}")}
            differences.tell(spot.at, subject._replace(is_verdict=counts), pair)


def format_difference(ours: str, theirs: str, is_text: bool, unit: str) -> Iterator[tuple[str, tuple[str, str]]]:
    """Yield the difference of two number formats: whether it shows another number or text, or other decimals only."""
    if not shows_same(ours, theirs, is_text):
        is_other = is_text or plain_number(theirs, unit) != plain_number(ours)
        yield "number format" if is_other else "decimals", (ours, theirs)


def text_fonts(match: Match) -> dict[Address, str]:
    """Return the fonts of parts of texts in words, by the cells that show them."""
    fonts: dict[Address, str] = {}
    for title, rows in match.file.inspected.sheets.items() if match.file.inspected else ():
        held = {Address(title, *at): elements for at, elements in rows.fonts.items()}
        shared = match.file.inspected.fonts  # type: ignore[union-attr]
        for cell in rows.written if shared else ():
            if cell.kind == "s" and cell.how is None and int(cell.value or -1) in shared:
                held[Address(title, cell.row, cell.column)] = shared[int(cell.value or -1)]
        fonts |= {at: "; ".join(in_words(flatten(font)) for font in elements) for at, elements in held.items()}
    return fonts
