"""Find which formula cells of a declared book depend on given cells.

A formula depends on every cell of the ranges that it names, also where a look-up reads any of them.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable

from workbook.book.address import Address
from workbook.book.columns import Formulas
from workbook.book.declare import Book
from workbook.book.formula import Area


class Dependence:
    """The cells that the formulas of a book refer to."""

    def __init__(self, book: Book) -> None:
        self._by_cell: dict[Address, list[Address]] = defaultdict(list)
        self._by_column: dict[tuple[str, int], dict[Area, list[Address]]] = defaultdict(lambda: defaultdict(list))
        areas = book.areas()
        readers = {sheet.title: Formulas(sheet.title, lambda name, _: areas[name]) for sheet in book.sheets}
        for cell in book.cells():
            title = cell.block.sheet.title
            at = Address(title, cell.row, cell.column)
            if cell.quantity.formula is not None:
                formula = readers[title].read(cell.content, cell.row)
                for area in {part for part in formula.arguments if isinstance(part, Area)}:
                    if area.size == 1:
                        self._by_cell[area.first].append(at)
                    else:
                        for column in area.columns:
                            self._by_column[area.sheet, column][area].append(at)

    def on(self, changed: Iterable[Address], known: Collection[Address] = ()) -> set[Address]:
        """Return the formula cells that depend on ``changed``; the search stops at those that are ``known``."""
        reached: set[Address] = set()
        waiting = list(changed)
        seen = set(waiting)
        while waiting:
            at = waiting.pop()
            columns = self._by_column[at.sheet, at.column].items()
            readers = [reader for area, those in columns if area.holds(at) for reader in those]
            for reader in [*self._by_cell.get(at, ()), *readers]:
                if reader not in seen and reader not in known:
                    seen.add(reader)
                    reached.add(reader)
                    waiting.append(reader)
        return reached
