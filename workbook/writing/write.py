"""Write a declared book to a file: cells, styles, names, charts, cached values, the same bytes each time."""

from __future__ import annotations

import io
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import formualizer
from openpyxl import Workbook
from openpyxl.utils import get_column_letter, quote_sheetname
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.workbook.properties import CalcProperties
from openpyxl.worksheet.header_footer import HeaderFooterItem, _HeaderFooterPart
from openpyxl.worksheet.hyperlink import Hyperlink
from openpyxl.worksheet.properties import PageSetupProperties
from openpyxl.worksheet.worksheet import Worksheet
from pydantic import BaseModel

from workbook.book.declare import FIRST, Block, Book, Sheet
from workbook.book.formats import number_format, sample
from workbook.entries import rules
from workbook.errors import WriteError
from workbook.writing import archive, charts, style

WIDTHS = {1: 2, FIRST: 38}
COLUMN_WIDTH = 12
LAST_PAGE_COLUMN = 9
NAME, RANGE = rb"\b[a-z]+_\w+", rb"\b[A-Za-z]\w*!\$[A-Z]+\$\d+:\$[A-Z]+\$\d+"
CM_PER_CHARACTER, CM_PER_ROW = 0.19, 0.53


def to_workbook(book: Book, model: type[BaseModel]) -> Workbook:
    """Return ``book`` as an openpyxl workbook without cached values."""
    workbook = Workbook()
    workbook.remove(workbook.worksheets[0])
    sheets = {sheet.title: workbook.create_sheet(sheet.title) for sheet in book.sheets}
    styles = style.Styles(workbook)
    for sheet in book.sheets:
        page = sheets[sheet.title]
        write_texts(sheet, page, styles)
        for block in sheet.blocks:
            write_block(block, page, styles)
            validate(block, page, model)
        for chart, row, column, width, height in sheet.charts:
            page.add_chart(charts.draw(chart, book, *size(column, width, height)), f"{get_column_letter(column)}{row}")
        set_up_page(sheet, page)
    for name, target in book.names():
        workbook.defined_names[name] = DefinedName(name, attr_text=target)
    styles.close()
    workbook.properties.title = book.title
    workbook.properties.creator = "motionbook"
    workbook.calculation = CalcProperties(fullCalcOnLoad=True)
    return workbook


def size(column: int, columns: int, rows: int) -> tuple[float, float]:
    """Return width and height in cm of a chart that covers so many columns and rows."""
    characters = sum(WIDTHS.get(c, COLUMN_WIDTH) for c in range(column, column + columns))
    return characters * CM_PER_CHARACTER, rows * CM_PER_ROW


def write_texts(sheet: Sheet, page: Worksheet, styles: style.Styles) -> None:
    """Write titles, labels and headers."""
    for text in sheet.texts:
        cell = page.cell(text.row, text.column, text.text or None)
        style.apply(cell, styles.text(text.style))
        if text.link:
            target = f"{quote_sheetname(text.link)}!A1"
            cell.hyperlink = Hyperlink(cell.coordinate, location=target, tooltip=f"Go to {text.link}")
        if text.style == "equation":
            page.row_dimensions[text.row].height = 44
        elif text.style == "header":
            height = 32 if len(text.text) < 24 else 47
            page.row_dimensions[text.row].height = max(height, page.row_dimensions[text.row].height or 0)


def write_block(block: Block, page: Worksheet, styles: style.Styles) -> None:
    """Write the cells of one block, each column in one style."""
    formats: dict[str, Any] = {}
    for q in block.quantities:
        shown = sample(q)
        formats[q.name] = styles.quantity(q.role, number_format(q, shown), style.alignment(q, shown, block.is_table))
    for q, _, row, column, content in (c[1:6] for c in block.cells()):
        cell = page.cell(row, column, content)
        style.apply(cell, formats[q.name])
    for q in block.quantities:
        if q.role == "check":
            style.mark_checks(page, block.reference(q.name).replace("$", ""))


def validate(block: Block, page: Worksheet, model: type[BaseModel]) -> None:
    """Attach the rule of each input to its cells."""
    for q in block.quantities:
        if q.role == "input":
            rule = rules.validation(model, q)
            rule.add(block.reference(q.name).replace("$", ""))
            page.add_data_validation(rule)


def set_up_page(sheet: Sheet, page: Worksheet) -> None:
    """Columns, panes, protection without a password, and how it prints."""
    used = max([c for b in sheet.blocks for c in b.columns.values()], default=FIRST)
    for column in range(1, max(used, LAST_PAGE_COLUMN, sheet.print_columns) + 1):
        page.column_dimensions[get_column_letter(column)].width = WIDTHS.get(column, COLUMN_WIDTH)
    page.sheet_view.showGridLines = False
    page.freeze_panes = "A4"
    page.protection.sheet = True
    page.protection.formatColumns = page.protection.formatRows = False  # widths stay the engineer's own
    page.page_setup.orientation, page.page_setup.paperSize = "landscape", 9
    page.page_setup.fitToWidth, page.page_setup.fitToHeight = 1, int(sheet.one_page)
    page.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)
    page.print_title_rows = "1:3"
    right = get_column_letter(sheet.print_columns or max(used, LAST_PAGE_COLUMN))
    page.print_area = f"A1:{right}{max(sheet.row, 30)}"
    left, middle, number = (_HeaderFooterPart(text) for text in ("&F", "&A", "Page &P of &N"))
    page.HeaderFooter.oddFooter = HeaderFooterItem(left=left, center=middle, right=number)


def save(workbook: Workbook, book: Book, path: Path, overwrite: bool = False) -> None:
    """Save with cached values filled in: beside the target first, then renamed onto it.

    Raises WriteError where ``path`` exists and ``overwrite`` is not given, or cannot be written, or where the book
    is too large to be computed.
    """
    refuse_existing(path, overwrite)

    spell_out(workbook)
    draft = io.BytesIO()
    workbook.save(draft)
    try:
        filled = recalculated(archive.unzipped(draft.getvalue()), book)
    except (OSError, ValueError) as error:  # formualizer takes 100,000 formulas, and files of a certain size
        raise WriteError(f"{path}: too large to be computed; give smaller tables ([sizes]): {error}") from error
    abouts = [(chart.title, chart.about) for s in book.sheets for chart, *_ in s.charts]
    replace(path, lambda beside: archive.pack(filled, beside, abouts))


def recalculated(parts: dict[str, bytes], book: Book) -> dict[str, bytes]:
    """Return the parts with the result of every formula filled in.

    formualizer looks up the name of a column anew for each cell, which takes three times as long as all else: it is
    given ranges instead, in a spelling that the book has nowhere else (a sheet's title without quotes).
    """
    ranges = {name: target.replace("'", "") for name, target in book.names() if name in book.column_names}
    plain = {name: target for name, target in ranges.items() if target.partition("!")[0].isidentifier()}
    draft = archive.zipped(archive.respelled(parts, NAME, plain))
    filled = archive.unzipped(formualizer.recalculate_xlsx_bytes(draft)["bytes"])
    return archive.respelled(filled, RANGE, {target: name for name, target in plain.items()})


def spell_out(workbook: Workbook) -> None:
    """Have numbers written with all their digits: openpyxl writes 16, and some numbers need 17 to come back."""
    for page in workbook.worksheets:
        for cell in getattr(page, "_cells").values():  # noqa: B009 - every cell that there is; iter_rows would add more
            number = cell.value
            if isinstance(number, float) and float(f"{number:.16g}") != number:
                cell._value = repr(number)  # its type remains that of a number


def refuse_existing(path: Path, overwrite: bool) -> None:
    """Raise WriteError where ``path`` exists and may not be replaced."""
    if path.exists() and not overwrite:
        raise WriteError(f"{path}: the file exists; it is left as it is (--force replaces it, -o names another)")


def replace(path: Path, write: Callable[[Path], None]) -> None:
    """Let ``write`` fill a new file beside ``path``, then move it there; a failure leaves the old file whole."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.stem}-", suffix=path.suffix)
    except OSError as error:
        raise WriteError(f"{path}: cannot be written: {error.strerror or error}") from error
    os.close(handle)
    draft = Path(name)
    try:
        write(draft)
        draft.chmod(0o644)
        draft.replace(path)
    except PermissionError as error:
        raise WriteError(f"{path}: cannot be written; close it in the other program and try again") from error
    except OSError as error:
        raise WriteError(f"{path}: cannot be written: {error.strerror or error}") from error
    finally:
        draft.unlink(missing_ok=True)
