"""What a template is, and the parts that every template's book has."""

from __future__ import annotations

from collections.abc import Callable, Container
from dataclasses import dataclass
from pathlib import Path

import workbook
from workbook.book.about import contents
from workbook.book.checks import checks_sheet, repeat_verdict
from workbook.book.declare import FIRST, Book, Text
from workbook.entries.machine import Machine

FOLDER = Path(workbook.__file__).parent.parent / "templates"


@dataclass(frozen=True)
class Template:
    """A kind of machine: its description's model, the book declared from a description, variations to verify at.

    ``sizes`` tells for each entry of a description's ``sizes`` which block shows it, and by how many rows that
    block is longer. ``laid_out`` gives a machine the layout that a file has by its defined names, where the number
    of sheets depends on the description.
    """

    name: str
    model: type[Machine]
    declare: Callable[[Machine], Book]
    variants: Callable[[Machine], list[Machine]]
    sizes: dict[str, tuple[str, int]]
    laid_out: Callable[[Machine, Container[str]], Machine] = lambda machine, names: machine

    @property
    def description(self) -> Path:
        """The committed machine description."""
        return FOLDER / f"{self.name}.toml"

    @property
    def book(self) -> Path:
        """The committed workbook."""
        return FOLDER / f"{self.name}.xlsx"


def finish(book: Book, title: str, sources: tuple[str, ...]) -> Book:
    """Add what comes when all sheets are there: checks, the verdict on each sheet, contents, titles."""
    checks_sheet(book)
    repeat_verdict(book)
    contents(book, sources)
    for sheet in book.sheets:
        about = sheet is book.sheets[0]
        sheet.texts.append(Text(1, FIRST, title if about else sheet.title, "title"))
        sheet.texts.append(Text(2, FIRST, sheet.purpose, "note"))
        if not about:
            sheet.texts.append(Text(3, FIRST + 4, "Contents", "link", "About"))
    return book
