"""The sheet Names of a machine: names for its figures, those of its axes and of its clearances; names.md lists them."""

from collections.abc import Sequence

from workbook.book import public_names
from workbook.book.declare import Book
from workbook.book.public_names import place_names
from workbook.machines.machine.entries_beside import ClearanceEntry
from workbook.machines.machine.view import MovingAxis

NAMES = public_names.names_in(__file__)


def names_sheet(book: Book, axes: Sequence[MovingAxis], clearances: Sequence[ClearanceEntry]) -> None:
    """Declare the sheet, and the public names of a machine, of its axes and of its clearances."""
    sheet = public_names.names_sheet(book)
    place_names(sheet, NAMES["Results"], "machine")
    units = {axis.given.name: (axis.given.unit, *axis.over.rates(axis.given.unit)) for axis in axes}
    for axis in axes:
        place_names(sheet, NAMES["Axis"], f"axis{axis.number}", axis.typed.called, axis.number, units[axis.given.name])
    for n, clearance in enumerate(clearances, 1):
        unit = units[clearance.second if clearance.pairs else clearance.first]
        place_names(sheet, NAMES["Clearance"], f"clear{n}", clearance.called, n, unit)
