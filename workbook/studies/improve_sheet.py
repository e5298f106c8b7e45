"""The sheet Improve of a book: what would make a machine better, as it was worked out, and what changed since."""

from collections.abc import Iterator, Sequence
from datetime import datetime

from openpyxl import Workbook
from openpyxl.styles import Alignment
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.declare import Book, quoted
from workbook.book.quantity import Cell
from workbook.book.stamp import fingerprint
from workbook.fields.paths import spell
from workbook.writing.style import GREY, font

TITLE, HEADING = "Improve", "What would make the machine better"
NOTE = "Values of motionbook improve, {:%Y-%m-%d %H:%M}; no formula works them out anew"
SAME = "For the entries that the book has now"
OTHER = "The entries have changed since: improve works it out anew"
CHANGED = "changed"
PASSED_OVER = ("selection.", "laws.", "sizes.")  # keys of catalogues, and of what a phase names
ABOVE = 5  # rows above the results
WIDTHS = (84, 20, 20, 10)


def improve_sheet(lines: Sequence[str], when: datetime, book: Book) -> Worksheet:
    """Return a sheet for a book: results in lines, with their time and the fingerprint; the entries then and now."""
    sheet: Worksheet = Workbook().create_sheet(TITLE)
    rows = list(entries_then(book))
    head = ABOVE + len(lines) + 2
    changed = f"D{head + 1}:D{head + len(rows)}"
    equal = "ABS(B3-stamp_sum)<=stamp_equal*ABS(stamp_sum)"
    sheet.append([HEADING])
    sheet.append([NOTE.format(when)])
    sheet.append(["Fingerprint of the entries then", fingerprint(book)])
    sheet.append([f'=IF(AND({equal},COUNTIF({changed},"{CHANGED}")=0),"{SAME}","{OTHER}")'])
    sheet.append([])
    for line in lines:
        sheet.append([line])
    sheet.append([])
    sheet.append(["Entry", "then", "now"])
    for row, (key, value, now) in enumerate(rows, head + 1):
        sheet.append([key, value, f"={now}", f'=IF(C{row}=B{row},"","{CHANGED}")'])
    for cells in sheet.iter_rows():
        for cell in cells:
            cell.font = font(14 if cell.row == 1 else 11, bold=cell.row in (1, 4, ABOVE + 1, head))
    sheet["A2"].font = font(10, GREY)
    for column, width in enumerate(WIDTHS, 1):
        sheet.column_dimensions[get_column_letter(column)].width = width
    for (cell,) in sheet[f"B3:B{head + len(rows)}"]:
        cell.alignment = Alignment(horizontal="left")
    return sheet


def entries_then(book: Book) -> Iterator[tuple[str, object, str]]:
    """Yield the key of each entry with a value, that value and the reference to its cell, catalogues aside."""
    for cell in book.cells():
        key, value = cell.quantity.key, cell.content
        if cell.quantity.role == "input" and value not in (None, "") and not key.startswith(PASSED_OVER):
            yield spell(key.replace("*", str(cell.i))), value, reference(cell)


def reference(cell: Cell) -> str:
    """Return the reference to a declared cell."""
    return f"{quoted(cell.block.sheet.title)}!${get_column_letter(cell.column)}${cell.row}"
