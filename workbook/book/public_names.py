"""Public names: by them formulas of an engineer's own have figures of a book, wherever these lie."""

import itertools
import re
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from workbook.book.cell_tables import markdown_rows, sections
from workbook.book.declare import Book, Quantity, Sheet, calc, constant
from workbook.book.rows import as_rows

# what names of cells that are declared later begin with
LATER = ("block", "book", "checks", "mend", "status")
BUILT = "Named when the book was built"
ENTERED = "as entered"  # in place of a product of the catalogue where none is named
Rows = Sequence[dict[str, str]]
"""names of a Markdown table: name, cell, meaning, and perhaps a unit of their own"""


def names_in(module: str) -> dict[str, Rows]:
    """Return the tables of names.md beside a module, by its ``__file__``, each by its title."""
    beside = Path(module).with_name("names.md")
    return {title: list(markdown_rows(text)) for title, text in sections(str(beside))}


def names_sheet(book: Book) -> Sheet:
    """Add the sheet Names to a book."""
    sheet = book.sheet("Names", "Names for formulas of your own: =NAME*1.2 has that figure wherever its cell lies.")
    sheet.unprinted = True
    return sheet


def place_names(sheet: Sheet, rows: Rows, part: str, called: str = "", n: int = 0, units: Sequence[str] = ()) -> None:
    """Place the names of a part of the machine, each with value, unit and meaning; those without a cell not.

    ``part`` begins the names of its cells; ``called`` is its name, empty for the machine itself; ``n`` its number, from
    1; ``units`` are those of its position, velocity and acceleration.
    """
    book = sheet.book
    name = free_name(book, clean_name(called) or part, [row["name"] for row in rows])
    sheet.heading(called or "Results")
    if called:
        sheet.rows(constant(f"{part}_built", BUILT, "", "", called, "its names keep this name", align="right"))
    for row in rows:
        reference = row["cell"].format(n=n)
        if source := quantity_at(book, reference):
            public, cell = (row["name"].format(name=each) for each in (name, "public"))
            unit = row["unit"].format(*units) if "unit" in row else source.unit
            sheet.rows(repeat_cell(source._replace(unit=unit), reference, f"{part}_{cell}", public, row["meaning"]))
            book.public[public] = f"{part}_{cell}"


def repeat_cell(source: Quantity, reference: str, cell: str, public: str, meaning: str) -> Quantity:
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
    taken = {name.casefold() for name in (*book.blocks, *book.column_names, *book.public)}

    def is_taken(name: str) -> bool:
        return name.casefold() in LATER or any(p.format(name=name).casefold() in taken for p in patterns)

    numbered = (f"{wanted}_{count}" if count > 1 else wanted for count in itertools.count(1))
    return next(name for name in numbered if not is_taken(name))


def clean_name(name: str) -> str:
    """Return of a name what every program takes for part of a name: letters, digits and _, no digit first.

    With _ and an ending behind it, it is no address of a cell, be it as A1 or as R1C1.
    """
    plain = unicodedata.normalize("NFKC", name)
    words = re.sub("_+", "_", "".join(c if c.isalpha() or c.isdecimal() else "_" for c in plain)).strip("_")
    return f"_{words}" if words[:1].isdecimal() else words
