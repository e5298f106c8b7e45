"""A sheet on the screen: the colour of its tab, the cell that it opens at, the rules and prompts of its entries."""

from collections.abc import Iterator

from openpyxl.utils import get_column_letter
from openpyxl.worksheet.worksheet import Worksheet
from pydantic import BaseModel

from workbook.book.declare import Block, Quantity, Sheet
from workbook.entries import rules
from workbook.writing.style import TABS


def set_up_screen(sheet: Sheet, page: Worksheet) -> None:
    """Colour the tab of a sheet by its kind, and let it open at its first entry."""
    entries, is_first = list(entries_of(sheet)), sheet is sheet.book.sheets[0]
    kind = "result" if is_first else "working" if sheet.unprinted else "enter" if entries else "result"
    page.sheet_properties.tabColor = TABS[kind]
    if entries:
        row, column = min(entries)
        for selection in page.sheet_view.selection:
            selection.activeCell = selection.sqref = f"{get_column_letter(column)}{row}"


def entries_of(sheet: Sheet) -> Iterator[tuple[int, int]]:
    """Yield the row and column of each entry, of a column of a table its first cell."""
    for block in sheet.blocks:
        yield from ((block.row, block.columns[q.name]) for q in block.quantities if q.role == "input")


def add_validations(block: Block, q: Quantity, page: Worksheet, model: type[BaseModel]) -> None:
    """Add the rule of an entry's cells; a prompt is beside the first cell of a group alone, where it covers none."""
    first = block.reference(q.name, ".first").replace("$", "")
    last = block.reference(q.name, ".last").replace("$", "")
    prompting, silent = rules.validation(model, q), rules.validation(model, q)
    silent.prompt = silent.promptTitle = silent.showInputMessage = None
    inputs = (each for each in block.quantities if each.role == "input")
    # of a table its first, of entries below one another the uppermost
    begins = q is next(inputs) if block.is_table else (block.row - 1, block.column) not in entries_of(block.sheet)
    (prompting if begins else silent).add(first)
    if first != last:
        rest = block.reference(q.name, ".2").replace("$", "") if begins else first
        silent.add(f"{rest}:{last}")
    for rule in (prompting, silent):
        if rule.sqref.ranges:
            page.add_data_validation(rule)
