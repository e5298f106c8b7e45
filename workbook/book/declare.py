"""The parts of a workbook: quantities, declared once, placed in blocks on sheets.

One declaration serves four uses: the cell, its documentation, the validation of its input and the
comparison of ``verify``. Formulas are written with a small reference notation that is turned into
cell references when the book is complete, so that a sheet may name blocks of a later sheet:

====================  ==========================================================
``[xi]``              the cell of column ``xi`` in the same row of the same table
``[xi-1]``            the cell a row above it
``[samples.xi]``      the whole column ``xi`` of table ``samples``, absolute
``[samples.xi.first]``, ``.last``, ``.3``   its first, last, third cell
``[samples.xi.same]``   its cell in the row of the same number
``[c0:c5]``, ``[pieces.c0:c5]``   the same of all columns between two, side by side
``@stroke``           ``tool2_stroke`` in the scope ``tool2_`` (:meth:`Sheet.scoped`),
                      by which a function declares the like of several parts
``drive_rate``        anything else is Excel's own text; scalars go by defined name
====================  ==========================================================
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from openpyxl.utils import get_column_letter, quote_sheetname

from workbook.book.chart import Text
from workbook.book.formula import Area
from workbook.book.limits import Limit, RowRule
from workbook.book.quantity import Block, Cell, Quantity, calc, check, constant, given, result
from workbook.book.rows import as_rows
from workbook.book.sheet import FIRST, Sheet

__all__ = [
    "FIRST", "Block", "Book", "Cell", "Quantity", "RowRule", "Sheet", "Text",
    "calc", "check", "constant", "given", "result",
]  # fmt: skip

REFERENCE = re.compile(r"\[(\w+(?::\w+)?)(-1|\.\w+(?::\w+)?)?(\.first|\.last|\.same|\.\d+)?\]")


@dataclass
class Book:
    """A whole workbook as declared: sheets in the order of their tabs, every block by its name."""

    template: str
    title: str
    sheets: list[Sheet] = field(default_factory=list)
    blocks: dict[str, Block] = field(default_factory=dict)
    checks: list[tuple[Sheet, Quantity]] = field(default_factory=list)
    column_names: dict[str, tuple[str, str]] = field(default_factory=dict)
    limit: Callable[[str, float], Limit | None] = lambda key, most: None
    """the limits of the entry at a key of the description, if it has any"""
    # by unit, the scale of quantities that name none
    sizes: Mapping[str, float] = field(default_factory=dict)
    print_also: Sequence[str] = ()  # what is printed besides: catalogue, laws, parts, workings
    stamp: float | None = None  # the fingerprint of the entries at which it was last verified
    public: dict[str, str] = field(default_factory=dict)
    """names for an engineer's own formulas, each with that of its cell; where there are any, all others are hidden"""

    def sheet(self, title: str, purpose: str) -> Sheet:
        """Add a sheet behind those that are there. Raises ValueError where any of them has its title."""
        if any(sheet.title.casefold() == title.casefold() for sheet in self.sheets):
            raise ValueError(f"the sheet {title} is declared twice")
        self.sheets.append(Sheet(self, title, purpose))
        return self.sheets[-1]

    def name(self, table: str, **columns: str) -> None:
        """Give columns of a table defined names: ``name("laws", law_cv="cv")``, ``name("pieces", piece_c="c0:c5")``."""
        if twice := sorted(name for name in columns if name in self.column_names or name in self.blocks):
            raise ValueError(f"{', '.join(twice)} is declared twice")
        self.column_names |= {name: (table, column) for name, column in columns.items()}

    def cells(self) -> Iterator[Cell]:
        """Yield every declared cell of the book."""
        for block in self.blocks.values():
            yield from block.cells()

    def resolve(self, text: str, at: Block, fixed: str = "") -> str:
        """Turn the reference notation into A1 references, with ``{0}`` for this row and ``{1[n]}`` for n rows below.

        ``fixed`` is ``$`` where columns stay the same as the formula is copied to the right. KeyError: no such name.
        """

        def reference(match: re.Match[str]) -> str:
            first, second, end = match.groups()
            if second is None or second == "-1":
                row = "{0}" if second is None else "{1[-1]}"
                return ":".join(f"{fixed}{get_column_letter(at.seen[name])}{row}" for name in first.split(":"))
            block = self.blocks[first]
            # its first corner names the sheet
            ends_range = text[match.start() - 1 : match.start()] == ":"
            prefix = "" if ends_range or block.sheet is at.sheet else quoted(block.sheet.title) + "!"
            if end == ".same":
                row = f"{{1[{block.row - at.row}]}}"
                return prefix + ":".join(
                    f"{fixed}{get_column_letter(block.columns[name])}{row}" for name in second[1:].split(":")
                )
            return prefix + block.reference(second[1:], end or "", fixed)

        text = text.replace("{", "{{").replace("}", "}}")
        return REFERENCE.sub(reference, text)

    def range(self, text: str) -> str:
        """Return the range that ``[table.column]``, ``[table.c0:c1.3]`` or ``=first:last`` means, with its sheet."""
        if text.startswith("="):
            cells = [self.blocks[name] for name in text[1:].split(":")]
            title, area = cells[0].sheet.title, ":".join(cell.span for cell in cells)
            return f"{quote_sheetname(title)}!{area}"
        table, column, *row = text.strip("[]").split(".")
        block = self.blocks[table]
        end = f".{row[0]}" if row else ""
        return f"{quote_sheetname(block.sheet.title)}!{block.reference(column, end)}"

    def values(self, text: str) -> list[Any]:
        """Return the values of such a range: what is entered, or the engine's value of a formula."""
        if text.startswith("="):
            return [self.blocks[name].quantities[0].value for name in text[1:].split(":")]
        table, column, *row = text.strip("[]").split(".")
        block = self.blocks[table]
        first, last = block.ends(column)
        columns = [q for q in block.quantities if first <= block.columns[q.name] <= last]
        each = [as_rows(q.value, block.size, text) for q in columns]
        return [values[int(row[0]) - 1] for values in each] if row else each[0]

    def areas(self) -> dict[str, Area]:
        """Return the meaning of each defined name, a block or a named column; and of each sheet, ``title!``, a cell."""
        areas = {f"{sheet.title}!": Area(sheet.title, 1, 1, 1, 1, single=True) for sheet in self.sheets}
        areas |= {name: block.area() for name, block in self.blocks.items()}
        areas |= {name: self.blocks[table].area(column) for name, (table, column) in self.column_names.items()}
        return areas | {name: areas[cell] for name, cell in self.public.items()}

    def names(self) -> Iterator[tuple[str, str]]:
        """Yield every defined name with what it refers to: blocks, named columns, public names."""
        cells = {block.name: f"{quote_sheetname(block.sheet.title)}!{block.span}" for block in self.blocks.values()}
        yield from cells.items()
        for name, (table, column) in self.column_names.items():
            yield name, self.range(f"[{table}.{column}]")
        yield from ((name, cells[cell]) for name, cell in self.public.items())


def quoted(title: str) -> str:
    """Return a sheet's title as formulas have it: without quotes where it is a word that no cell or column has."""
    return title if title.isascii() and title.isalpha() and len(title) > 3 else quote_sheetname(title)
