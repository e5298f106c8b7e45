"""The sheet Names: names by which formulas of an engineer's own have figures of a machine; names.md lists them."""

import itertools
import re
import unicodedata
from collections.abc import Sequence
from typing import Any

from workbook.book.cell_tables import markdown_rows, sections
from workbook.book.declare import Book, Quantity, Sheet, calc, constant
from workbook.book.rows import as_rows
from workbook.machines.machine.axes_summary import ENTERED
from workbook.machines.machine.entries_beside import ClearanceEntry
from workbook.machines.machine.view import MovingAxis

NAMES = {title: list(markdown_rows(text)) for title, text in sections(__file__)}
# what names of cells that are declared later begin with
LATER = ("block", "book", "checks", "mend", "status")
BUILT = "Named when the book was built"


def names_sheet(book: Book, axes: Sequence[MovingAxis], clearances: Sequence[ClearanceEntry]) -> None:
    """Declare the sheet, and the public names of a machine, of its axes and of its clearances."""
    sheet = book.sheet("Names", "Names for formulas of your own: =MC01_T_max is that figure wherever its cell lies.")
    sheet.unprinted = True
    place_names(sheet, "Machine", "machine", "")
    units = {axis.given.name: (axis.given.unit, *axis.over.rates(axis.given.unit)) for axis in axes}
    for axis in axes:
        place_names(sheet, "Axis", f"axis{axis.number}", axis.typed.called, axis.number, units[axis.given.name])
    for n, clearance in enumerate(clearances, 1):
        unit = units[clearance.second if clearance.pairs else clearance.first]
        place_names(sheet, "Clearance", f"clear{n}", clearance.called, n, unit)


def place_names(sheet: Sheet, kind: str, part: str, called: str, n: int = 0, units: Sequence[str] = ()) -> None:
    """Place the names of a part of the machine, each with its value, unit and meaning.

    Parameters
    ----------
    sheet : Sheet
        The sheet Names.
    kind : str
        The table of names.md that lists them; names whose cell the book lacks are left out.
    part : str
        What the names of the part's cells begin with.
    called : str
        The part, as it was called when the book was built; empty for the machine itself.
    n : int
        The number of the part, from 1.
    units : sequence of str
        Those of its position, velocity and acceleration, where these differ between the axes.
    """
    book, rows = sheet.book, NAMES[kind]
    name = free_name(book, cleaned(called) or part, [row["name"] for row in rows])
    sheet.heading(called or kind)
    if called:
        sheet.rows(constant(f"{part}_built", BUILT, "", "", called, "its names keep this name", align="right"))
    for row in rows:
        reference = row["cell"].format(n=n)
        if source := quantity_at(book, reference):
            public, cell = (row["name"].format(name=each) for each in (name, "public"))
            unit = row["unit"].format(*units) if "unit" in row else source.unit
            sheet.rows(repeated(source._replace(unit=unit), reference, f"{part}_{cell}", public, row["meaning"]))
            book.public[public] = f"{part}_{cell}"


def repeated(source: Quantity, reference: str, cell: str, public: str, meaning: str) -> Quantity:
    """Return the quantity of a public name, which repeats the cell that a reference leads to."""
    formula, value = f"={reference}", source.value
    if source.role == "input":
        formula, value = f'=IF({reference}="","{ENTERED}",{reference})', value or ENTERED
    more: dict[str, Any] = {"scale": source.scale, "format": source.format, "align": "right"}
    return calc(cell, public, source.symbol, source.unit, formula, value, meaning, **more)


def quantity_at(book: Book, reference: str) -> Quantity | None:
    """Return the quantity of a cell, with its value there; None where the book has no such cell."""
    table, *place = reference.strip("[]").split(".")
    if (block := book.blocks.get(table)) is None:
        return None
    if not place:
        return block.quantities[0]
    column, row = place
    q = next(q for q in block.quantities if q.name == column)
    return q._replace(value=as_rows(q.value, block.size, q.name)[int(row) - 1])


def free_name(book: Book, wanted: str, patterns: Sequence[str]) -> str:
    """Return the wanted name of a part, with a number where names after the patterns have it, capitals or not."""
    taken = {name.casefold() for name, _ in book.names()}

    def is_taken(name: str) -> bool:
        return name.casefold() in LATER or any(p.format(name=name).casefold() in taken for p in patterns)

    numbered = (f"{wanted}_{count}" if count > 1 else wanted for count in itertools.count(1))
    return next(name for name in numbered if not is_taken(name))


def cleaned(name: str) -> str:
    """Return of a name what every program takes for part of a name: letters, digits and _, no digit first.

    With _ and an ending behind it, it is no address of a cell, be it as A1 or as R1C1.
    """
    plain = unicodedata.normalize("NFKC", name)
    words = re.sub("_+", "_", "".join(c if c.isalpha() or c.isdecimal() else "_" for c in plain)).strip("_")
    return f"_{words}" if words[:1].isdecimal() else words
