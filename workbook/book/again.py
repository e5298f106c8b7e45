"""Sheets that the latest book has already: copied where the same is asked for, not declared again."""

from collections.abc import Callable, Sequence
from copy import copy
from typing import Any, NamedTuple

from workbook.book.declare import Block, Book, Sheet
from workbook.latest import latest, remembers


class Declared(NamedTuple):
    """What was declared of a book by some calls: sheets, and what these entered in the lists of the book."""

    sheets: list[Sheet]
    checks: list[tuple[int, Any]]  # each with the place of its sheet among these
    guards: list[Any]
    column_names: dict[str, tuple[str, str]]
    keyed: set[str]


def again(book: Book, kind: str, of: tuple[Any, ...], declare: Callable[[], None]) -> None:
    """Declare sheets, or copy those that were declared of equal things behind sheets of the same titles."""
    if not remembers():
        declare()
        return
    fresh: list[Declared] = []

    def made() -> Declared:
        fresh.append(declared(book, declare))
        return fresh[0]

    found = latest(kind, (*of, *(sheet.title for sheet in book.sheets)), made)
    if not fresh:
        place(book, found)


def declared(book: Book, declare: Callable[[], None]) -> Declared:
    """Declare sheets; return copies of them, which later calls on the book leave alone and which do not keep it."""
    sheets, checks, guards = len(book.sheets), len(book.checks), len(book.guards)
    names, keyed = set(book.column_names), set(book.keyed)
    declare()
    own = book.sheets[sheets:]
    return Declared(
        copies(own, Book(book.template, book.title)),
        [(own.index(sheet), q) for sheet, q in book.checks[checks:]],
        book.guards[guards:],
        {name: column for name, column in book.column_names.items() if name not in names},
        book.keyed - keyed,
    )


def place(book: Book, found: Declared) -> None:
    """Add copies of declared sheets to a book."""
    sheets = copies(found.sheets, book)
    book.sheets += sheets
    book.blocks |= {block.name: block for sheet in sheets for block in sheet.blocks}
    book.checks += [(sheets[k], q) for k, q in found.checks]
    book.guards += found.guards
    book.column_names |= found.column_names
    book.keyed |= found.keyed


def copies(sheets: Sequence[Sheet], book: Book) -> list[Sheet]:
    """Return copies of sheets with their blocks, for a book."""
    blocks = {id(block): block.copied() for sheet in sheets for block in sheet.blocks}

    def own(block: Block | None) -> Block | None:
        return blocks[id(block)] if block is not None else None

    made = []
    for sheet in sheets:
        one = copy(sheet)
        one.book, one.texts, one.charts, one.widths = book, [*sheet.texts], [*sheet.charts], dict(sheet.widths)
        one.blocks = [blocks[id(block)] for block in sheet.blocks]
        one.messages = [(blocks[id(block)], columns) for block, columns in sheet.messages]
        for block in one.blocks:
            block.sheet, block.lead, block.workings = one, own(block.lead), own(block.workings)
        made.append(one)
    return made
