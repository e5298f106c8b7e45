"""Cells as people call them: an address, a defined name, or the label beside the cell; labels and units there."""

import keyword
import re

from workbook.book.address import Address
from workbook.dimensions.units import dimension_of
from workbook.errors import ReadError
from workbook.reading.contents import plain_label
from workbook.reading.files import BookFile

CELL = re.compile(r"(?:(?P<sheet>'(?:[^']|'')+'|[^'!]+)!)?\$?(?P<column>[A-Za-z]{1,3})\$?(?P<row>\d{1,7})")
BRACKETS = re.compile(r"[\[(]([^\])]{1,12})[\])]")
NEAR = 6  # columns right of a label in which its figure stands


def find_cell(file: BookFile, text: str) -> Address:
    """Return the cell of an address, a name or a label; raise ReadError where there is none, or are several."""
    if CELL.fullmatch(text):
        return on_sheet(file, text)
    if text in file.places:
        return file.places[text].cell(0, 0)
    held = file.contents.constants.items()
    labels = (at for at, value in held if isinstance(value, str) and plain_label(value) == plain_label(text))
    cells = [cell for label in labels if (cell := value_right_of(file, label)) is not None]
    if len(cells) == 1:
        return cells[0]
    what = f"{len(cells)} cells stand beside this label: {', '.join(map(str, cells))}" if cells else "no such cell"
    raise ReadError(f"{file.path.name}: {text!r}: {what}; expected an address, a defined name or a label")


def on_sheet(file: BookFile, text: str) -> Address:
    """Return the cell of an address, by default on the first sheet; raise ReadError for a sheet that is missing."""
    titles = file.workbook.sheetnames
    if (address := Address.parse(text, titles[0])).sheet not in titles:
        raise ReadError(f"{file.path.name}: {text!r}: no sheet is called {address.sheet!r}; found {', '.join(titles)}")
    return address


def value_right_of(file: BookFile, label: Address) -> Address | None:
    """Return the first number or formula right of a label; None where there is none nearby."""
    constants, formulas = file.contents.constants, file.contents.formulas
    cells = (label._replace(column=label.column + right) for right in range(1, NEAR + 1))
    return next((at for at in cells if isinstance(constants.get(at), int | float) or at in formulas), None)


def label_of(file: BookFile, cell: Address) -> str:
    """Return the text left of a cell, else the text above it, else nothing."""
    left = [cell._replace(column=column) for column in range(cell.column - 1, max(0, cell.column - NEAR), -1)]
    above = [cell._replace(row=row) for row in range(cell.row - 1, max(0, cell.row - NEAR), -1)]
    texts = (file.contents.constants.get(at) for at in [*left, *above])
    return next((text.strip().rstrip(" :=") for text in texts if isinstance(text, str) and text.strip()), "")


def variable_of(file: BookFile, cell: Address) -> str:
    """Return a variable for a cell, built from its label, else from its address."""
    words = re.sub(r"\W+", "_", label_of(file, cell).casefold()).strip("_")
    return words if words.isidentifier() and not keyword.iskeyword(words) else f"cell_{cell.a1.casefold()}"


def unit_of(file: BookFile, cell: Address) -> str:
    """Return the unit beside a cell: right of it, or in brackets in the text left of it, else in that above it."""
    held = file.contents.constants
    left = held.get(cell._replace(column=cell.column - 1)) if cell.column > 1 else None
    above = held.get(cell._replace(row=cell.row - 1)) if cell.row > 1 else None
    brackets = [bracket for text in (left, above) for bracket in BRACKETS.findall(str(text or ""))]
    texts = [held.get(cell._replace(column=cell.column + 1)), *brackets]
    units = (text.strip(" []()") for text in texts if isinstance(text, str))
    return next((unit for unit in units if dimension_of(unit) is not None), "")


def cells_of(file: BookFile, text: str) -> list[list[Address]]:
    """Return the rows of a range such as ``Sheet!A20:D60``."""
    sheet, mark, cells = text.rpartition("!")
    first, _, last = cells.partition(":")
    top, bottom = (on_sheet(file, f"{sheet}{mark}{end}") for end in (first, last or first))
    rows, columns = range(top.row, bottom.row + 1), range(top.column, bottom.column + 1)
    return [[Address(top.sheet, row, column) for column in columns] for row in rows]
