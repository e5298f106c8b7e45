"""The stamp of a book on its first sheet: the entries at which it was last verified, and whether today's are those.

Entries are told by a sum of all numbers entered, each weighted. Texts count by what follows from them on that sheet.
"""

from collections.abc import Iterator
from math import copysign, fsum, log
from typing import NamedTuple

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Sheet
from workbook.book.quantity import Block, Quantity
from workbook.book.rows import as_rows, filled, is_number

CELLS = cell_tables(__file__)
# the cell that verify --stamp writes; the line that compares
NAME, SENTENCE = "book_stamp", "stamp_today"
TABLE = "stamp"  # of the sums
EQUAL = 1e-10  # of two fingerprints: rounding is far below, a change of an entry in its sixth digit above
# the least numbers that count: what is computed may be zero but for rounding
ENTERED, COMPUTED = 1e-9, 1e-3
CYCLE = 7  # weights 1, 2 … 7, 1 …: entries that stand side by side cannot be exchanged unseen
NEVER, SAME = "Not verified yet", "Verified for these entries"
OTHER = "Verified for other entries than these"


class Counted(NamedTuple):
    """A column of numbers, with its weighted sum; None where a result is open."""

    block: Block
    quantity: Quantity
    sum: float | None

    @property
    def least(self) -> float:
        """The least number that counts."""
        return ENTERED if self.quantity.role == "input" else COMPUTED

    @property
    def size(self) -> float | None:
        """The sign of the sum times the logarithm of its size, in which each digit counts, whatever the unit."""
        return None if self.sum is None else copysign(log(1.0 + abs(self.sum) / self.least), self.sum)

    @property
    def formula(self) -> str:
        """The formula of the sum."""
        first, last = (f"[{TABLE}.weight.{row}]" for row in (1, self.block.size))
        weights = first if first == last else f"{first}:{last}"
        return f"=SUMPRODUCT([{self.block.name}.{self.quantity.name}],{weights})"


def counted_columns(book: Book) -> Iterator[Counted]:
    """Yield the columns of numbers that are entered, and of results on the first sheet."""
    for block in book.blocks.values():
        for q in block.quantities:
            limit = book.limit(q.key, q.upper_limit) if q.role == "input" else None
            if (limit and limit.number) or (block.sheet is book.sheets[0] and q.role == "result"):
                values = as_rows(q.value, block.size, q.name)
                numbers = [weight(row) * value for row, value in enumerate(values) if is_number(value)]
                yield Counted(block, q, None if q.role == "result" and None in values else fsum(numbers))


def weight(row: int) -> float:
    """Return the weight of a row, counted from 0."""
    return 1.0 + row % CYCLE


def fingerprint(book: Book) -> float | None:
    """Return the weighted sum of the sizes; None where any is open."""
    sizes = [column.size for column in counted_columns(book)]
    if None in sizes:
        return None
    return fsum(weight(row) * size for row, size in enumerate(sizes) if size)


def stamp_quantities(book: Book) -> tuple[Quantity, Quantity]:
    """Return the fingerprint of the last verify, and whether today's entries are those, in words."""
    cell, today = CELLS["stamped"], fingerprint(book)
    says: str | None = NEVER
    if book.stamp is not None:
        says = today and (SAME if abs(book.stamp - today) <= EQUAL * abs(today) else OTHER)  # type: ignore[assignment]
    return cell(NAME, book.stamp), cell(SENTENCE, says, never=NEVER, same=SAME, other=OTHER)


def stamp_table(book: Book, sheet: Sheet) -> None:
    """Declare on a sheet the fingerprint of today's entries, and the sums that it is made of."""
    cell, columns = CELLS["stamp_table"], list(counted_columns(book))
    rows = max([len(columns), *(column.block.size for column in columns)])
    sheet.heading("Fingerprint of the entries")
    sheet.rows(cell("stamp_sum", fingerprint(book)), cell("stamp_equal", EQUAL))
    sheet.table(
        TABLE,
        "Numbers that are entered, and results of the first sheet",
        rows,
        cell("of", filled([column.quantity.label for column in columns], rows, "")),
        cell("weight", [weight(row) for row in range(rows)]),
        cell("least", filled([column.least for column in columns], rows, COMPUTED)),
        cell("sum", filled([c.sum for c in columns], rows), formula=filled([c.formula for c in columns], rows, "=0")),
        cell("size", filled([column.size for column in columns], rows)),
    )
