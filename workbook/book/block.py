"""Quantities in their place on a sheet: a table of some rows, or a single cell."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple

from openpyxl.utils import get_column_letter

from workbook.book.quantity import Quantity
from workbook.book.rows import as_rows

if TYPE_CHECKING:
    from workbook.book.sheet import Sheet


class Cell(NamedTuple):
    """One declared cell, where the generated book has it; ``row`` and ``column`` also tell its offset."""

    block: Block
    quantity: Quantity
    i: int
    row: int
    column: int
    content: Any
    expected: Any


class Row(int):
    """The number of a row; ``row[n]`` is that of the row n below."""

    def __getitem__(self, below: int | str) -> int:
        return self + int(below)


@dataclass
class Block:
    """Quantities placed on a sheet: one row of a table each ``size``, or a single cell."""

    name: str
    sheet: Sheet
    row: int
    column: int
    quantities: tuple[Quantity, ...]
    size: int
    title: str = ""
    is_table: bool = True
    blank: str = ""  # of a table: the condition under which a row is not used, and shows nothing but its inputs
    quiet: str = ""  # of a table: the condition under which its results are errors, and are not shown
    lead: Block | None = None  # of columns beside a table: that, whose cells in the same row their formulas may name
    workings: Block | None = None
    """of a table: its workings to the right, whose cells in the same row its formulas may name"""

    def copied(self) -> Block:
        """Return a copy, made faster than by the module ``copy``: a book has hundreds, and each edit copies them."""
        made = object.__new__(Block)
        vars(made).update(vars(self))
        return made

    @cached_property
    def columns(self) -> dict[str, int]:
        """The sheet column of each quantity, by name."""
        return {q.name: self.column + i for i, q in enumerate(self.quantities)}

    @property
    def seen(self) -> dict[str, int]:
        """The sheet column of each quantity that a formula may name for its own row."""
        beside = (self.lead, self.workings)
        return {**{name: column for block in beside if block for name, column in block.columns.items()}, **self.columns}

    @property
    def span(self) -> str:
        """The block's cells as an absolute A1 range, without the sheet."""
        return span(self.row, self.column, self.row + self.size - 1, self.column + len(self.quantities) - 1)

    def reference(self, quantity: str, end: str = "", fixed: str = "$") -> str:
        """Return the range of a column or of ``c0:c5``, or of its row ``.first``, ``.last`` or ``.3``."""
        top, bottom = self.row, self.row + self.size - 1
        if end:
            row = {".first": 1, ".last": self.size}.get(end) or int(end[1:])
            top = bottom = self.row + row - 1
        first, last = self.ends(quantity)
        return span(top, first, bottom, last, fixed)

    def ends(self, quantity: str) -> tuple[int, int]:
        """Return the sheet's numbers of the first and the last of some columns (``c0:c5``), of one twice the same."""
        first, _, last = quantity.partition(":")
        return self.columns[first], self.columns[last or first]

    @property
    def blanked(self) -> tuple[Quantity, ...]:
        """The columns that show nothing in a row that is not used: all but the inputs."""
        return tuple(q for q in self.quantities if self.blank and q.role != "input")

    def when(self, condition: str, row: int) -> str:
        """Return a condition in a row of the sheet, as a formula without its sign of equality."""
        return self.sheet.book.resolve(f"={condition}", self, "$").format(Row(row)).removeprefix("=")

    def cells(self) -> Iterator[Cell]:
        """Yield the declared cells, column by column, with contents and the engine's values."""
        return chain.from_iterable(self.by_column())

    def by_column(self) -> Iterator[list[Cell]]:
        """Yield the declared cells of each column."""
        for q, column in zip(self.quantities, self.columns.values(), strict=True):
            where = f"{self.name}.{q.name}"
            contents = values = as_rows(q.value, self.size, where)
            if q.formula is not None:
                texts = as_rows(q.formula, self.size, where)
                patterns = {text: self.sheet.book.resolve(text, self) for text in set(texts)}
                contents = [patterns[text].format(Row(row)) for row, text in enumerate(texts, self.row)]
            both = enumerate(zip(contents, values, strict=True))
            yield [Cell(self, q, i, self.row + i, column, content, value) for i, (content, value) in both]


def span(top: int, left: int, bottom: int, right: int, fixed: str = "$") -> str:
    """Return an A1 range, or one cell where both corners are the same; ``fixed`` stands before columns."""
    first = f"{fixed}{get_column_letter(left)}${top}"
    last = f"{fixed}{get_column_letter(right)}${bottom}"
    return first if first == last else f"{first}:{last}"
