"""Cells built from the rows that the guard has read, numbers whatever their format; openpyxl reads the rest."""

from collections.abc import Sequence
from typing import Any

from openpyxl.cell.cell import Cell, MergedCell
from openpyxl.cell.text import Text
from openpyxl.formula.translate import Translator
from openpyxl.utils import get_column_letter
from openpyxl.utils.datetime import WINDOWS_EPOCH, from_ISO8601
from openpyxl.utils.escape import unescape
from openpyxl.worksheet.dimensions import RowDimension
from openpyxl.worksheet.formula import ArrayFormula, DataTableFormula
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.reading.contents import Cells, plain_value
from workbook.reading.guard import Inspected
from workbook.reading.rows import MAIN, RawCell, Rows

MOST_DIGITS = 300  # of a whole number; a number of more may be larger than any that a cell can hold
# types of values that openpyxl has as one, that of shared texts
TEXTS = {"str": "s", "inlineStr": "s"}


def fill_sheet(sheet: Worksheet, rows: Rows, texts: Sequence[str]) -> None:
    """Enter the written cells into a sheet that has none; raise as openpyxl does where they are damaged."""
    cells: dict[tuple[int, int], Any] = sheet._cells
    styles = sheet.parent._cell_styles  # type: ignore[union-attr]
    shared: dict[str, Translator] = {}
    for held in rows.written:
        place = held[:2]
        cell: Any = cells.get(place)  # a cell of a comment, a link, or a range that is merged
        if isinstance(cell, MergedCell):
            continue
        # built in a third of the time of its initializer, which copies the style: nobody changes it
        if cell is None:
            cell = cells[place] = Cell.__new__(Cell)
            cell.parent, (cell.row, cell.column), cell._hyperlink = sheet, place, None
            cell._comment = None
        cell._style = styles[held.style]
        if held.how is None:
            cell._value, cell.data_type = cell_content(held, texts), TEXTS.get(held.kind, held.kind)
        else:
            cell._value, cell.data_type = cell_formula(held, shared), "f"
    for row, looks in rows.looks.items():
        style = {"s": styles[int(looks["s"])]} if "s" in looks else {}
        sheet.row_dimensions[row] = RowDimension(sheet, **{**looks, **style, "r": row})


def cell_content(held: RawCell, texts: Sequence[str]) -> Any:
    """Return the content of a cell without a formula."""
    kind, text = held.kind, held.value
    if not text:
        return "" if kind == "inlineStr" and text == "" else None
    if kind == "n":
        is_whole = len(text) < MOST_DIGITS and text.strip().lstrip("+-").isdecimal()
        return int(text) if is_whole else float(text)
    if kind == "s":
        return texts[int(text)]
    if kind == "b":
        return text == "1"
    if kind == "d":
        return from_ISO8601(text)  # type: ignore[no-untyped-call]
    return text


def cell_formula(held: RawCell, shared: dict[str, Translator]) -> Any:
    """Return the formula of a cell as openpyxl has it; ``shared`` has those met before that several cells share."""
    how: dict[str, Any] = held.how or {}
    text = "=" + held.formula
    kind = how.get("t")
    if kind == "array":
        return ArrayFormula(ref=how.get("ref"), text=text)
    if kind == "dataTable":
        return DataTableFormula(**how)
    if kind == "shared":
        number, at = how.get("si", ""), f"{get_column_letter(held.column)}{held.row}"
        if number in shared:
            return shared[number].translate_formula(at)
        if held.formula:
            shared[number] = Translator(text, at)
    return text


def saved_values(inspected: Inspected) -> Cells:
    """Return the saved value of each formula cell of a file: a number, a text, True or False, an error; or None."""
    written = ((title, cell) for title, rows in inspected.sheets.items() for cell in rows.written)
    cells = [(title, cell) for title, cell in written if cell.how is not None]
    shared = inspected.strings.iter(f"{MAIN}si") if any(c.kind == "s" for _, c in cells) else ()
    text_of: Any = Text.from_tree
    texts = [str(text_of(shared_text).content) for shared_text in shared]
    return {Address(title, *cell[:2]): saved_value(cell, texts) for title, cell in cells}


def saved_value(held: RawCell, texts: list[str]) -> Any:
    """Return a saved value; None where there is none, and an empty text where the type alone says so."""
    if not held.value or (held.kind == "s" and int(held.value) >= len(texts)):
        return "" if held.kind == "str" else None
    if held.kind == "n":
        return float(held.value)
    value = plain_value(cell_content(held, texts), WINDOWS_EPOCH)
    is_escaped = isinstance(value, str) and "_x" in value  # ISO/IEC 29500-1, 22.9.2.19
    return unescape(value) if is_escaped else value
