"""The limits that every drive keeps to, in cells: where they are entered."""

from collections.abc import Iterator

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.selection.entries import Limits

CELLS = cell_tables(__file__)

LIMITS = tuple(Limits.model_fields)


def limit_cells(limits: Limits) -> Iterator[Quantity]:
    """Yield the rows in which the limits of all drives are entered."""
    cell = CELLS["limits"]
    for name in LIMITS:
        yield cell(f"limits_{name}", getattr(limits, name))
