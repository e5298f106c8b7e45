"""The book of an unfinished design: what was entered, and formulas without a value.

The engine works with other numbers in place of faulty ones, so that its results are of no use there: what a cell says,
the entries' own checks among all, a program works out when it opens the book.
"""

from collections.abc import Mapping
from typing import Any

from workbook.book.declare import Book
from workbook.book.quantity import Quantity, number_format, sample
from workbook.book.rows import as_rows
from workbook.entries.machine import Machine
from workbook.fields.paths import key_of
from workbook.law_sheets.library import named_laws


def enter_unfinished(book: Book, machine: Machine) -> None:
    """Put into a book what was entered of an unfinished design; take the values of all formula cells away."""
    names = {f"laws.{key_of(law.name)}": law.key for law in named_laws(machine.laws)}
    entered = {}
    for key, value in machine.design.replaced.items():
        begin = ".".join(key.split(".")[:2])
        entered[names.get(begin, begin) + key.removeprefix(begin)] = value
    for block in book.blocks.values():
        columns = (as_entered(q, block.size, entered) for q in block.quantities)
        block.quantities = tuple(q if block.is_table else q._replace(value=q.value[0]) for q in columns)
    book.checks = [(sheet, q._replace(value=None)) for sheet, q in book.checks]


def as_entered(q: Quantity, size: int, entered: Mapping[str, Any]) -> Quantity:
    """Return a quantity with a value for each row: as entered by its key, none of a formula, whose look stays."""
    rows = as_rows(q.value, size, q.name)
    if q.formula is not None:
        return q._replace(value=[None for _ in rows], format=number_format(q, sample(q)))
    return q._replace(value=[entered.get(q.key.replace("*", str(i)), value) for i, value in enumerate(rows)])
