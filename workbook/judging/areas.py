"""Areas of cells: their corners, those of defined names, and which block each cell belongs to."""

from collections.abc import Callable

from workbook.book.address import Address, Place
from workbook.book.declare import Block, Book
from workbook.book.formula import Area, FormulaError, area_of


def corners(area: Area) -> tuple[Address, Address]:
    """Return the first and the last cell of an area."""
    return area.first, Address(area.sheet, area.bottom, area.right)


def resolve(name: str, names: dict[str, Area], titles: set[str]) -> Area:
    """Return what a defined name means, or ``title!``; FormulaError where there is none."""
    if name.endswith("!") and name[:-1] in titles:
        return Area(name[:-1], 1, 1, 1, 1, single=True)
    if name.lower() not in names:
        raise FormulaError("#NAME?", f"the name {name} does not lead to cells")
    return names[name.lower()]


def declared_place(block: Block) -> Place:
    """Return where the declaration has a block."""
    return Place(block.sheet.title, block.row, block.column, block.size, len(block.quantities))


def declared_area(book: Book, name: str) -> Area:
    """Return what a defined name of the declaration means: a block, or a named column."""
    if name in book.blocks:
        return area_of(declared_place(book.blocks[name]))
    table, column = book.column_names[name]
    block = book.blocks[table]
    first, last = block.ends(column)
    return area_of(Place(block.sheet.title, block.row, first, block.size, last - first + 1))


def cell_index(
    places: dict[str, Place], header: Callable[[str], int]
) -> dict[Address, tuple[str, int, int]]:  # fmt: skip
    """Return the block, row and column of every cell of the blocks, and of the headers above them.

    A column that takes from the row above reads its header in the first row (and makes nothing of it); ``header``
    tells how many rows above the block it stands.
    """
    columns = [(name, place, j) for name, place in places.items() for j in range(place.columns)]
    up = {name: header(name) for name in places}
    cells = {place.cell(-up[name], j): (name, -1, j) for name, place, j in columns}
    return cells | {at: (name, i, j) for name, place, j in columns for i, at in enumerate(place.down(j))}
