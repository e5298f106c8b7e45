"""The laws of a book as every sheet looks them up."""

from __future__ import annotations

from workbook.book.declare import Book
from workbook.entries.machine import Sizes
from workbook.laws.entries import Laws
from workbook.laws.library import laws
from workbook.laws.page import law_sheet
from workbook.laws.registry import FAMILIES
from workbook.laws.sheet import laws_sheet
from workbook.laws.stack import locator, stacked

PAGED = tuple(family.code for family in FAMILIES if family.page.has_sheet)
LAW_SIZES = {"law": (f"{PAGED[0]}_samples", 1), "own_law": ("own_samples", 1), "pieces": ("own_pieces", 0)}


class LawShelf:
    """The motion laws of a book: the engine's laws, and the stacked pieces in which every sheet looks its law up."""

    def __init__(self, given: Laws, sizes: Sizes) -> None:
        self.given, self.sizes = given, sizes
        self.laws = laws(given, sizes.own_law)
        self.rows = stacked(self.laws, sizes)
        self.stack = locator(self.rows)

    def sheets(self, book: Book) -> None:
        """Declare a page for each law, and the Laws sheet."""
        for number, family in enumerate(FAMILIES, 1):
            if family.page.has_sheet:
                entered = getattr(self.given, family.code)
                law_sheet(book, family, self.laws[family.code], entered, number, self.sizes.law, self.stack)
        laws_sheet(book, self.laws, self.given, self.sizes, self.rows)
