"""What a template is, and the parts that every template's book has."""

from __future__ import annotations

from collections.abc import Callable, Container
from dataclasses import dataclass
from pathlib import Path

import workbook
from workbook.declare import FIRST, Book, Text
from workbook.machine import Laws, Machine, Sizes
from workbook.reference import laws
from workbook.sheets.about import contents
from workbook.sheets.checks import checks_sheet, repeat_verdict
from workbook.sheets.laws import PAGES, law_sheet
from workbook.sheets.laws_sheet import laws_sheet
from workbook.sheets.stack import CODES, locator, stacked

FOLDER = Path(workbook.__file__).parent.parent / "templates"
LAW_SIZES = {"law": ("ACS_samples", 1), "own_law": ("own_samples", 1), "pieces": ("own_pieces", 0)}


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


class LawShelf:
    """The motion laws of a book: the engine's laws, and the stacked pieces in which every sheet looks its law up."""

    def __init__(self, given: Laws, sizes: Sizes) -> None:
        self.given, self.sizes = given, sizes
        self.laws = laws(given, sizes.own_law)
        self.rows = stacked(self.laws, given.OWN.pieces, sizes)
        self.stack = locator(self.rows)

    def sheets(self, book: Book) -> None:
        """Declare a page for each law, and the Laws sheet."""
        for page in PAGES:
            number = CODES.index(page.code) + 1
            entered = getattr(self.given, page.code)
            law_sheet(book, page, self.laws[page.code], entered, number, self.sizes.law, self.stack)
        laws_sheet(book, self.laws, self.given.OWN, self.sizes, self.rows)


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
