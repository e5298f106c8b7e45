"""formulon, an engine tested against Excel's own results by its makers, in WebAssembly; optional to install."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from workbook.book.address import Address
from workbook.errors import WitnessError
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness

if TYPE_CHECKING:
    from formulon import Value, Workbook

EVERYWHERE = (0, 0, 2**20 - 1, 2**14 - 1)  # first row and column, last row and column


class Formulon(Witness):
    """Loads the file, recalculates every formula, and reads the results."""

    name = "formulon"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell, None where it is empty or no single value."""
        import formulon  # optional

        try:
            with formulon.Workbook.load(file.path.read_bytes()) as book:
                book.recalc()
                found = cells(book)
        except formulon.FormulonError as error:
            raise WitnessError(f"formulon cannot evaluate the file: {error}") from error
        return {address: found.get(address) for address in file.contents.formula_cells}


def cells(book: Workbook) -> Cells:
    """Return what every cell of a book holds."""
    from formulon import MergeRange

    found = {}
    for number in range(book.sheet_count()):
        title, more = book.sheet_name(number), True
        cursor: int | None = None
        while more:
            some, cursor = book.get_cells_in_range(number, MergeRange(*EVERYWHERE), cursor)
            more = cursor is not None
            found.update({Address(title, cell.row + 1, cell.col + 1): plain(cell.value) for cell in some})
    return found


def plain(value: Value) -> Any:
    """Return a number, a truth value, a text or an error's name; None for anything else."""
    from formulon import error_display_name

    if value.error_code is not None:
        return error_display_name(value.error_code)
    made = value.to_python()
    return made if isinstance(made, bool | float | str) else None
