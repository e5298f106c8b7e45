"""What an engineer has added to a book, written into a new one: sheets, cells, notes and names."""

from copy import copy
from typing import Any, NamedTuple

from openpyxl import Workbook
from openpyxl.cell.cell import Cell
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.worksheet import Worksheet

from workbook.writing.cells import Cells, Strings

LOOKS = ("font", "fill", "border", "alignment", "number_format", "protection")


class Own(NamedTuple):
    """Sheets, cells with what they hold, cells with notes, and names, as openpyxl reads them of the old file."""

    sheets: tuple[Worksheet, ...] = ()
    cells: tuple[tuple[Cell, Any], ...] = ()
    notes: tuple[Cell, ...] = ()
    names: tuple[DefinedName, ...] = ()


NOTHING = Own()


def add(own: Own, workbook: Workbook, cells: dict[str, Cells], strings: Strings) -> None:
    """Add to a new workbook, whose cells are ``cells`` by sheet, what an engineer had in the old one."""
    for sheet in own.sheets:
        cells[sheet.title], new = Cells(strings), workbook.create_sheet(sheet.title)
        for letter, column in sheet.column_dimensions.items():
            made = new.column_dimensions[letter]
            made.min, made.max, made.width, made.hidden = column.min, column.max, column.width, column.hidden
        for number, row in sheet.row_dimensions.items():
            new.row_dimensions[number].height = row.height
        for merged in sheet.merged_cells.ranges:
            new.merge_cells(merged.coord)
        new.freeze_panes = sheet.freeze_panes
    for cell, content in own.cells:
        twin = workbook[cell.parent.title].cell(cell.row, cell.column)
        for look in LOOKS if cell.has_style else ():
            setattr(twin, look, copy(getattr(cell, look)))
        place = cell.row, cell.column, twin.style_id
        if cell.data_type == "f":
            cells[cell.parent.title].put_formula(*place, content, None)
        else:
            cells[cell.parent.title].put(*place, content)
    for cell in own.notes:
        workbook[cell.parent.title].cell(cell.row, cell.column).comment = copy(cell.comment)
    workbook.defined_names.update({name.name: name for name in own.names})
