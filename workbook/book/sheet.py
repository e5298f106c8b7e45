"""A sheet as it is laid out: texts, rows, tables, checks and charts, each below the last."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import accumulate
from math import inf
from typing import TYPE_CHECKING

from workbook.book import limits
from workbook.book.chart import Chart, Text, in_scope
from workbook.book.limits import Entries, RowRule
from workbook.book.quantity import Block, Quantity, sentence, side_of
from workbook.book.rows import as_rows

if TYPE_CHECKING:
    from workbook.book.declare import Book


LONG = 40  # rows of a table that is not printed below others, and of which a page is printed where it stands alone
TITLES = 3  # rows of a sheet's title, purpose and overall verdict
DEEPEST = 14  # a table that begins farther down than this is not alone on its sheet
MOST_COLUMNS = 40  # of a sheet
LEAST_COLUMNS = 9  # of a printed page
FIRST = 2  # the column in which labels and tables begin; column 1 is a margin
WIDTHS, COLUMN_WIDTH = {1: 2, FIRST: 39.5}, 9.5  # of columns that have none of their own, in digits
ON_SCREEN = 186.0  # digits that a screen of 1366 pixels shows side by side


@dataclass
class Sheet:
    """A sheet as it is laid out: each call places the next thing below the last."""

    book: Book
    title: str
    purpose: str
    row: int = 5
    texts: list[Text] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)
    charts: list[tuple[Chart, int, int, int, int]] = field(default_factory=list)
    print_columns: int = 0
    print_rows: int = 0
    # the column from which on there are workings alone: an outline of them is folded
    folded: int = 0
    folded_rows: int = 0  # the row from which on there are workings alone, likewise
    page_end: int = 0  # the last row of its first page, if that is a whole
    # of rows (points) that differ from others
    heights: dict[int, float] = field(default_factory=dict)
    unprinted: bool = False  # whether it is for the screen alone: its print area is a hidden cell
    one_page: bool = False
    # of columns that differ from those of other sheets
    widths: dict[int, float] = field(default_factory=dict)
    scope: str = ""
    messages: list[tuple[Block, tuple[Quantity, ...]]] = field(default_factory=list)
    """of tables of inputs: what is expected of each entry"""
    section: int = 0  # row of the heading above
    # by unit, scales as :attr:`Book.sizes`, of this sheet
    sizes: Mapping[str, float] = field(default_factory=dict)
    shared_heads: int = 0  # the row of the names of columns, of the heads that were written last
    # checks of tables without heads, until they are placed
    later: list[Quantity] = field(default_factory=list)
    more: Sequence[Quantity] = ()  # results that stand below what is printed
    # beside that to the first sheet: titles with cells
    links: dict[str, str] = field(default_factory=dict)
    # what its checks begin with, if not with its title; on the sheet itself they go without
    called: str = ""

    @property
    def head(self) -> int:
        """The last row that stays in sight and stands on each printed page: that of a long table's heads over it."""
        top = next(iter(self.blocks), None)
        return top.row - 1 if top and top.size > LONG and top.row <= DEEPEST else TITLES

    @property
    def last_column(self) -> int:
        """The last column that is printed and that a screen shows."""
        used = max((column for block in self.blocks for column in block.columns.values()), default=FIRST)
        wide, last = WIDTHS | self.widths, self.print_columns or max(used, LEAST_COLUMNS)
        ends = accumulate(wide.get(column, COLUMN_WIDTH) for column in range(1, last + 1))
        return sum(end <= ON_SCREEN for end in ends)

    @contextmanager
    def scoped(self, scope: str) -> Iterator[None]:
        """Let ``@`` stand for ``scope`` in the names and formulas of what is placed meanwhile."""
        before, self.scope = self.scope, scope
        try:
            yield
        finally:
            self.scope = before

    def not_printed_below(self) -> None:
        """End what is printed above the next thing: long tables are for the screen."""
        self.print_rows = self.row

    def heading(self, text: str, note: str = "") -> None:
        """Begin a section."""
        self.row += 1
        self.section = self.row
        self.texts.append(Text(self.row, FIRST, text, "heading"))
        self.row += 1
        if note:
            self.note(note)

    def note(self, text: str) -> None:
        """Write a line of explanation."""
        self.texts.append(Text(self.row, FIRST, text, "note"))
        self.row += 1

    def rows(self, *quantities: Quantity, section: str = "", first: Quantity | None = None) -> None:
        """Place quantities, a ``section`` from its ``first`` on; beside inputs what is expected, below a check."""
        own = self._own(quantities)
        watched = self.limited(own)
        messages = {q.name: limits.message_beside(q, limit) for q, limit in watched}
        for q, given in zip(own, quantities, strict=True):
            if given is first:
                self.heading(section)
            self._row(q, messages.get(q.name))
        if watched:
            name = f"{watched[0][0].name}_entries"
            self.checks(limits.cells_check(name, f"{self.called or self.title}: entries within limits", watched))

    def limited(self, quantities: Sequence[Quantity]) -> Entries:
        """Return the inputs that have limits, with these."""
        inputs = [(q, self.book.limit(q.key, q.upper_limit)) for q in self._own(quantities) if q.role == "input"]
        return [(q, limit) for q, limit in inputs if limit is not None]

    def _row(self, q: Quantity, message: Quantity | None = None) -> None:
        """Place a quantity below the others, perhaps with a message in place of its source."""
        texts = {"label": q.label, "symbol": q.symbol, "": "", "unit": q.unit, "note": "" if message else q.source}
        self.texts += [
            Text(self.row, column, text, style) for column, (style, text) in enumerate(texts.items(), FIRST) if text
        ]
        self.put(q, self.row, FIRST + 2)
        if message:
            self.put(message, self.row, FIRST + 4)
        self.row += 1

    def put(self, quantity: Quantity, row: int, column: int, is_large: bool = False) -> None:
        """Place a quantity in a cell of its own."""
        own = self._own((quantity,))
        self._place(Block(own[0].name, self, row, column, own, 1, is_table=False, is_large=is_large))

    def checks(self, *quantities: Quantity) -> None:
        """Place checks and what each says, without the sheet's name, and enter them in the book's list."""
        name = self.called or self.title
        for q in quantities:
            rest = q.label.removeprefix(f"{name}: ").removeprefix(f"{name}, ")
            here = q._replace(label=q.label if rest == q.label else f"{rest[0].upper()}{rest[1:]}")
            self.texts.append(Text(self.row, FIRST, here.label, "label"))
            self.check(here, self.row, FIRST + 2, FIRST + 4)
            self.book.checks.append((self, self._own((q,))[0]))
            self.row += 1

    def check(self, q: Quantity, row: int, column: int, says: int) -> None:
        """Place a check at a column, and at another what it says."""
        (own,) = self._own((q,))
        self.put(sentence(own), row, says)
        self.put(own._replace(source=""), row, column)

    def table(
        self,
        name: str,
        title: str,
        size: int,
        *quantities: Quantity,
        rules: Sequence[RowRule] = (),
        blank: str = "",
        heads: bool = True,
    ) -> Block:
        """Place a table of ``size`` rows under a header of names, symbols with units, and equations.

        A table of inputs gets messages to its right on entries beyond their limits or against ``rules``, and a check
        below that counts them. A row without any entry shows nothing, of other tables a row for which ``blank`` holds.
        A table without ``heads`` stands below a like one that has them; its check waits in :attr:`later`.
        """
        if size > LONG and not self.print_rows:
            above = self.section if self.row < self.section + 4 else self.row
            self.print_rows = above - 1 if self.blocks else self.row + LONG
        inputs = [q for q in quantities if q.role == "input"]
        if heads:
            self.heads(title, quantities)
        top, unused = self.row, in_scope(blank or limits.all_empty(inputs), self.scope)
        name = in_scope(name, self.scope)
        block = self._place(Block(name, self, top, FIRST, self._own(quantities), size, title, blank=unused))
        block.shared_heads = 0 if heads else self.shared_heads
        self.row = top + size + 1
        if watched := self.limited(quantities):
            self._guard(block, watched, rules)
        return block

    def list_at(self, name: str, title: str, row: int, column: int, quantity: Quantity) -> Block:
        """Place a column at a cell, below its title alone."""
        self._heads(title, row, column, False, ())
        return self._place(Block(name, self, row + 1, column, self._own((quantity,)), len(quantity.value), title))

    def _guard(self, block: Block, watched: Entries, rules: Sequence[RowRule]) -> None:
        """Give a table of inputs its messages, and below it the check that counts them."""
        first = next(q for q in block.quantities if q.role == "input")
        label = f"{self.called or self.title}, {re.split(r'[:;(]', block.title)[0].strip()}: entries within limits"
        some = self.book.limit(first.key.partition(".*")[0], inf)
        columns, verdict = limits.guard_rows(block, watched, rules, label, some is not None and some.required)
        self.messages.append((block, tuple(columns)))  # until all of the sheet is placed
        if columns[0].name == limits.USED:
            room = limits.room_cell(block.name, as_rows(columns[0].value, block.size, limits.USED))
            self.put(room, block.row + block.size, block.columns[first.name])
        if block.shared_heads:
            self.later.append(verdict)
            return
        self.checks(verdict)
        self.row += 1

    def heads(self, title: str, quantities: Sequence[Quantity], column: int = FIRST) -> None:
        """Write the title and the heads of a table, or of several alike, below what is there, from a column on."""
        self.shared_heads = self.row + 1
        explained = any(q.source for q in quantities)
        self._heads(title, self.row, column, explained, quantities)
        self.row += 4 if explained else 3

    def place_messages(self) -> None:
        """Place the messages of tables of inputs: to the right of each, where its rows are free."""
        for block, columns in self.messages:
            runs = limits.SPARE if block.quantities[-1].align == "left" else 0
            column = self._free(block, len(columns), runs)
            self.workings(block, f"{block.name}{limits.MESSAGES}", "What is expected", column, *columns)

    def _free(self, block: Block, wide: int, runs: int) -> int:
        """Return the first column right of a table with ``wide`` free behind ``runs`` for texts, not printed if any."""
        top, end = block.top, block.row + block.size
        others = (other for other in self.blocks if other.top < end and top < other.row + other.size)
        charts = (
            range(left, left + width) for _, row, left, width, height in self.charts if row < end and top < row + height
        )
        taken = {column for columns in (*(other.columns.values() for other in others), *charts) for column in columns}
        behind, printed = max(block.columns.values()) + 1 + runs, self.print_columns + 1
        free = [c for c in range(behind, max(taken | {printed}) + 2 + runs) if not taken & set(range(c, c + wide))]
        return next((c for c in free if printed <= c <= MOST_COLUMNS + 1 - wide), free[0])

    def _heads(self, title: str, row: int, first: int, explained: bool, quantities: Sequence[Quantity]) -> None:
        """Write the title of a table and the heads of its columns."""
        self.texts.append(Text(row, first, title, "subheading"))
        for column, q in enumerate(quantities, first):
            symbol = "" if ", " in q.unit else f"{q.symbol} "  # behind which several units are too wide
            unit = f"{symbol}[{q.unit}]".strip() if q.unit else q.symbol
            lines = [(q.label, "header"), (unit, "units"), *([(q.source, "equation")] if explained else [])]
            side = side_of(q, is_table=True)
            self.texts += [Text(row + k, column, text, style, side=side) for k, (text, style) in enumerate(lines, 1)]

    def workings(
        self, block: Block, name: str, title: str, column: int, *quantities: Quantity, heads: bool = True
    ) -> None:
        """Place a table in the rows of another, at a column to its right: what is worked out from each of its rows."""
        explained = any(q.source for q in block.quantities)
        above = block.shared_heads - 1 if block.shared_heads else block.row - (4 if explained else 3)
        if heads and not any((text.row, text.column) == (above, column) for text in self.texts):
            self._heads(title, above, column, explained, quantities)
        own, name = self._own(quantities), in_scope(name, self.scope)
        workings = self._place(
            Block(name, self, block.row, column, own, block.size, title, blank=block.blank, lead=block)
        )
        workings.shared_heads = block.shared_heads
        block.workings = block.workings or workings

    def beside(self, block: Block, name: str, quantity: Quantity, blank: str = "", heads: bool = True) -> None:
        """Place a table of a column beside a table without equations: as many as a size says, each with its name."""
        column = max(b.column + len(b.quantities) for b in self.blocks if b.row == block.row)
        lines = ((2, quantity.label, "header"), (1, quantity.unit, "units")) if heads else ()
        side = side_of(quantity, is_table=True)
        self.texts += [Text(block.row - above, column, text, style, side=side) for above, text, style in lines]
        own, (name, blank) = self._own((quantity,)), (in_scope(text, self.scope) for text in (name, blank))
        self._place(Block(name, self, block.row, column, own, block.size, block.title, blank=blank, lead=block))

    def chart(self, chart: Chart, column: int, row: int, width: int = 8, height: int = 17) -> None:
        """Place a chart with its corner at a cell, ``width`` columns by ``height`` rows large."""
        self.charts.append((chart.within(self.scope), row, column, width, height))

    def chart_row(self, *charts: Chart, width: int = 5, height: int = 17) -> None:
        """Place charts side by side below what is there."""
        column = FIRST
        for i, chart in enumerate(charts):
            wide = width if i else width - 2
            self.chart(chart, column, self.row, wide, height)
            column += wide
        self.row += height + 1

    def _own(self, quantities: Sequence[Quantity]) -> tuple[Quantity, ...]:
        sizes = {**self.book.sizes, **self.sizes}
        sized = (q if q.scale else q._replace(scale=sizes.get(q.unit, 0.0)) for q in quantities)
        return tuple(q.within(self.scope) if self.scope else q for q in sized)

    def _place(self, block: Block) -> Block:
        if block.name in self.book.blocks or block.name in self.book.column_names:
            raise ValueError(f"{block.name} is declared twice")
        self.book.blocks[block.name] = block
        self.blocks.append(block)
        return block
