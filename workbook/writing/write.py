"""Write a declared book to a file, the same bytes each time, with what an engineer has added to an older book."""

import io
import zipfile
from collections.abc import Callable, Iterable, Mapping
from copy import copy
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from openpyxl import Workbook
from openpyxl.cell.cell import Cell
from openpyxl.styles import Protection
from openpyxl.utils import get_column_letter, quote_sheetname
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.workbook.properties import CalcProperties
from openpyxl.worksheet.header_footer import HeaderFooterItem, _HeaderFooterPart
from openpyxl.worksheet.hyperlink import Hyperlink
from openpyxl.worksheet.page import PageMargins
from openpyxl.worksheet.pagebreak import Break
from openpyxl.worksheet.properties import Outline, PageSetupProperties
from openpyxl.worksheet.worksheet import Worksheet
from openpyxl.writer.excel import ExcelWriter
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import FIRST, Block, Book, Sheet
from workbook.book.formula import LAST_COLUMN
from workbook.book.quantity import number_format, sample
from workbook.book.sheet import COLUMN_WIDTH, LEAST_COLUMNS
from workbook.entries import rules
from workbook.writing import archive, charts, layout, style
from workbook.writing.archive import Cells, Strings
from workbook.writing.layout import FULL, PossibleTexts, lines_of, widths
from workbook.writing.output_files import replace
from workbook.writing.screen import add_validations, set_up_screen

HIDDEN = 16_250
"""a column: of a print area without a cell in sight no page is printed. Others may be put in before it"""
LINE_HEIGHTS, BESIDE = {"header": 14, "units": 13, "equation": 13}, {"header": 2, "units": 2, "equation": 5}
"""in points, of the texts that wrap, and what keeps them off the line beside them: dots and exponents stand high"""
ROW_HEIGHT = 15  # of a line in a cell that wraps
AS_TYPED = "@"  # the format of a cell that keeps 4711, or 3-4, as a text
CM_PER_CHARACTER, CM_PER_ROW = 0.19, 0.53
LOOKS = ("font", "fill", "border", "alignment", "number_format", "protection")


class Additions(NamedTuple):
    """Sheets, cells and names, as openpyxl reads them of the old file, with where they go and what they hold there."""

    sheets: tuple[Worksheet, ...] = ()
    cells: tuple[tuple[Cell, Address, Any], ...] = ()
    notes: tuple[tuple[Cell, Address], ...] = ()
    names: tuple[DefinedName, ...] = ()
    remarks: tuple[str, ...] = ()  # lines on what formulas have in place of what they had
    # the cells that stay behind, each with the reason
    lost: Mapping[Address, str] = MappingProxyType({})


NO_ADDITIONS = Additions()
KEPT = "with work of its engineer's own"  # the category of such a book in its properties


def parts(
    book: Book,
    model: type[BaseModel],
    names: Iterable[DefinedName] | None = None,
    dynamic: str = "",
    own: Additions = NO_ADDITIONS,
) -> dict[str, bytes]:
    """Return the parts of the file, with ``names`` for the book's own; a formula with ``dynamic`` is an array."""
    strings = Strings()
    cells = {sheet.title: Cells(strings, dynamic) for sheet in book.sheets}
    workbook = make_workbook(book, model, cells)
    if names is None:
        names = (defined_name(book, name, target) for name, target in book.names())
    workbook.defined_names.update({defined.name: defined for defined in names})
    write_additions(own, workbook, cells, strings)
    draft = io.BytesIO()
    ExcelWriter(workbook, zipfile.ZipFile(draft, "w")).save()
    files = archive.unzipped(draft.getvalue())
    for number, page in enumerate(cells.values(), 1):
        name = f"xl/worksheets/sheet{number}.xml"
        files[name] = page.within(files[name])
    files |= charts.fill_caches(
        {name: part for name, part in files.items() if name.startswith("xl/charts/chart")}, book
    )
    abouts = [(chart.title or chart.about, chart.about) for sheet in book.sheets for chart, *_ in sheet.charts]
    return archive.complete_parts(files, strings.part(), abouts)


def defined_name(book: Book, name: str, target: str) -> DefinedName:
    """Return a name of a book: a public name with its meaning and unit, beside which the others are hidden."""
    if cell := book.public.get(name):
        (q,) = book.blocks[cell].quantities
        return DefinedName(name, attr_text=target, comment=f"{q.source} [{q.unit}]" if q.unit else q.source)
    return DefinedName(name, attr_text=target, hidden=True if book.public else None)


def write_additions(own: Additions, workbook: Workbook, cells: dict[str, Cells], strings: Strings) -> None:
    """Add to a new workbook, whose cells are ``cells`` by sheet, what an engineer had in the old."""
    for sheet in own.sheets:
        cells[sheet.title], new = Cells(strings), workbook.create_sheet(sheet.title)
        for letter, column in sheet.column_dimensions.items():
            ours = new.column_dimensions[letter]
            ours.min, ours.max, ours.width = column.min, column.max, column.width
            ours.hidden = column.hidden
        for number, row in sheet.row_dimensions.items():
            new.row_dimensions[number].height = row.height
        for merged in sheet.merged_cells.ranges:
            new.merge_cells(merged.coord)
        new.freeze_panes = sheet.freeze_panes
        new.conditional_formatting = sheet.conditional_formatting
        new.data_validations = sheet.data_validations
        new.sheet_state = sheet.sheet_state
        new.sheet_properties.tabColor = sheet.sheet_properties.tabColor
    for cell, at, content in own.cells:
        twin = workbook[at.sheet].cell(at.row, at.column)
        for look in LOOKS if cell.has_style else ():
            setattr(twin, look, copy(getattr(cell, look)))
        place = at.row, at.column, twin.style_id
        if cell.data_type == "f":
            cells[at.sheet].put_formula(*place, content, None)
        else:
            cells[at.sheet].put(*place, content)
    for cell, at in own.notes:
        workbook[at.sheet].cell(at.row, at.column).comment = copy(cell.comment)
    workbook.defined_names.update({name.name: name for name in own.names})
    if own.sheets or own.cells or own.notes or own.names:
        workbook.properties.category = KEPT


def make_workbook(book: Book, model: type[BaseModel], cells: dict[str, Cells]) -> Workbook:
    """Put the cells of each sheet into ``cells``; return the workbook around them: styles, rules, charts, pages."""
    workbook = Workbook()
    workbook.remove(workbook.worksheets[0])
    sheets = {sheet.title: workbook.create_sheet(sheet.title) for sheet in book.sheets}
    styles = style.Styles(workbook)
    standing = PossibleTexts(book)
    for sheet in book.sheets:
        page, content = sheets[sheet.title], cells[sheet.title]
        wide = widths(sheet, standing)
        content.heights |= sheet.heights
        write_texts(sheet, page, content, styles, wide)
        for block in sheet.blocks:
            write_block(block, page, content, styles, model, wide)
        for chart, row, column, columns, rows in sheet.charts:
            drawn = charts.draw(chart, book, *chart_size(sheet, wide, row, column, columns, rows))
            page.add_chart(drawn, f"{get_column_letter(column)}{row}")
        set_up_page(sheet, page, wide, content)
    styles.close()
    workbook.properties.title = book.title
    workbook.properties.creator = "motionbook"
    workbook.calculation = CalcProperties(fullCalcOnLoad=True)
    return workbook


def chart_size(
    sheet: Sheet, wide: dict[int, float], row: int, column: int, columns: int, rows: int
) -> tuple[float, float]:
    """Return width and height in cm of a chart that covers so many columns and rows of a sheet."""
    characters = sum(wide.get(c, COLUMN_WIDTH) for c in range(column, column + columns))
    points = sum(sheet.heights.get(r, ROW_HEIGHT) for r in range(row, row + rows))
    return characters * CM_PER_CHARACTER, points / ROW_HEIGHT * CM_PER_ROW


def write_texts(sheet: Sheet, page: Worksheet, cells: Cells, styles: style.Styles, wide: dict[int, float]) -> None:
    """Write titles, labels and headers."""
    for text in sheet.texts:
        look = styles.text(text.style, text.side, style.indent(text.side, text.column))
        cells.put(text.row, text.column, look, text.text or None)
        if text.link:
            target = f"{quote_sheetname(text.link)}!{text.linked_cell}"
            page.cell(text.row, text.column).hyperlink = Hyperlink("", location=target, tooltip=f"Go to {text.link}")
        if text.style in LINE_HEIGHTS and text.text and (text.style != "units" or sheet.one_page):
            room = wide.get(text.column, COLUMN_WIDTH)
            lines = lines_of(text.text, style.TEXTS[text.style].font.sz or FULL, room)
            cells.heights[text.row] = max(
                lines * LINE_HEIGHTS[text.style] + BESIDE[text.style], cells.heights.get(text.row, 0)
            )


def write_block(
    block: Block, page: Worksheet, cells: Cells, styles: style.Styles, model: type[BaseModel], wide: dict[int, float]
) -> None:
    """Write the cells of a block, each column in its style and with its rule, and set the height of wrapped texts."""
    for q, column in zip(block.quantities, block.columns.values(), strict=True):
        value = sample(q)
        aligned = style.aligned(q, block.is_table, column)
        shown = AS_TYPED if rules.is_free_text(model, q) else number_format(q, value)
        role = style.style_role(q.role, block)
        looks = [styles.quantity(role, shown, aligned, ink) for ink in q.inks or ("",)]
        if q.role == "input":
            add_validations(block, q, page, model)
        for row, (content, value) in enumerate(block.contents(q), block.row):
            look = looks[(row - block.row) % len(looks)]
            if q.formula is None:
                cells.put(row, column, look, content)
            else:
                cells.put_formula(row, column, look, content, value)
            if q.wrap and isinstance(value, str):
                lines = lines_of(value, FULL, wide.get(column, COLUMN_WIDTH))
                cells.heights[row] = max(lines * ROW_HEIGHT, cells.heights.get(row, 0))
    for mark in style.conditional_formats(block):
        ranges = " ".join(block.reference(q.name).replace("$", "") for q in mark.quantities)
        page.conditional_formatting.add(ranges, mark.rule)


def set_up_page(sheet: Sheet, page: Worksheet, wide: dict[int, float], cells: Cells) -> None:
    """Set columns, panes, protection without a password, and how it prints."""
    used = max([c for b in sheet.blocks for c in b.columns.values()], default=FIRST)
    widest = max(used + 1, LEAST_COLUMNS, sheet.print_columns)
    for column in range(1, widest + 1):
        page.column_dimensions[get_column_letter(column)].width = wide.get(column, COLUMN_WIDTH)
    if sheet.folded:
        first, last = (get_column_letter(column) for column in (sheet.folded, used))
        page.column_dimensions.group(first, last, hidden=True)
    if sheet.folded_rows:
        cells.folded = range(sheet.folded_rows, sheet.row)
        page.row_dimensions.group(cells.folded[0], cells.folded[-1], hidden=True)
        page.sheet_format.outlineLevelRow = 1
        page.sheet_properties.outlinePr = Outline(summaryBelow=False)
    page.sheet_view.showGridLines = False
    page.freeze_panes = f"A{sheet.head + 1}"
    set_up_screen(sheet, page)
    page.protection.sheet = True
    # widths stay the engineer's own
    page.protection.formatColumns = page.protection.formatRows = False
    for begin, end in ((widest + 1, HIDDEN - 1), (HIDDEN + 1, LAST_COLUMN)):
        rest = page.column_dimensions[get_column_letter(begin)]
        rest.min, rest.max, rest.width = begin, end, COLUMN_WIDTH
    for column in (*range(min(used + 2, widest + 1), widest + 2), HIDDEN, HIDDEN + 1):
        unlocked = Protection(locked=False)  # an engineer writes there without unprotecting
        page.column_dimensions[get_column_letter(column)].protection = unlocked
    set_up_print(sheet, page, used, wide, cells.heights)


def set_up_print(sheet: Sheet, page: Worksheet, used: int, wide: dict[int, float], high: dict[int, float]) -> None:
    """Set what is printed, and where its pages end."""
    columns = sheet.print_columns or max(used, LEAST_COLUMNS)
    last = sheet.print_rows or max(sheet.row, 30)
    # below what is printed
    goes_on = any(block.row <= last < block.row + block.size - 1 for block in sheet.blocks)
    page.page_setup.orientation = "landscape"
    page.page_setup.paperSize = 9
    page.page_margins = PageMargins(**layout.MARGINS)
    left, middle, number = (_HeaderFooterPart(text) for text in ("&F", "&A", "Page &P of &N"))
    page.HeaderFooter.oddFooter = HeaderFooterItem(left=left, center=middle, right=number)
    if sheet.unprinted:
        nowhere = get_column_letter(HIDDEN)
        page.print_area = f"{nowhere}1:{nowhere}1"
        page.column_dimensions[nowhere].hidden = True
        return
    page.print_title_rows = f"1:{sheet.head}"
    # as wide as they are, over as many pages as it takes
    has_workings = sheet.page_end and not sheet.folded_rows
    page.print_area = f"A1:{get_column_letter(used if has_workings else columns)}{last}"
    pages = layout.pages(sheet, last, columns, wide, high)
    if sheet.one_page or goes_on or not pages.breaks:
        page.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)
        page.page_setup.fitToWidth = page.page_setup.fitToHeight = 1
        return
    # a program that fits pages to paper heeds no breaks
    page.page_setup.scale = int(100 * pages.scale)
    for row in pages.breaks:
        page.row_breaks.append(Break(id=row))


def pack(
    parts: dict[str, bytes], path: Path, overwrite: bool = False, check: Callable[[Path], None] | None = None
) -> None:
    """Write the parts as a file, as :func:`replace` does."""

    def written(beside: Path) -> None:
        beside.write_bytes(archive.zipped(parts, zipfile.ZIP_DEFLATED))
        if check:
            check(beside)

    replace(path, written, overwrite)
