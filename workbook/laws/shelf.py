"""The laws of a book as every sheet looks them up."""

from __future__ import annotations

from collections.abc import Container

from workbook.book.again import again
from workbook.book.declare import Book
from workbook.entries.machine import Sizes
from workbook.latest import latest
from workbook.laws.entries import Laws
from workbook.laws.library import named
from workbook.laws.page import law_sheet
from workbook.laws.registry import CODES, FAMILY
from workbook.laws.sheet import laws_sheet, locator, stacked

PAGED = tuple(code for code in CODES if FAMILY[code].has_sheet)
LAW_SIZES = {
    "law": (f"{PAGED[0]}_samples", 1), "pieces": ("OWN_pieces", 0),
    "points": ("SPL#_points", 0), "export": ("export", 1),
}  # fmt: skip


def shelf_of(given: Laws, sizes: Sizes, hands_over: bool = False) -> LawShelf:
    """Return the laws of a book, those of the latest one where they are the same."""
    return latest("laws", (given, sizes, hands_over), lambda: LawShelf(given, sizes, hands_over))


class LawShelf:
    """The motion laws of a book: the engine's laws by name, and the stack of pieces in which sheets look them up."""

    def __init__(self, given: Laws, sizes: Sizes, hands_over: bool = False) -> None:
        self.given, self.sizes, self.hands_over = given, sizes, hands_over
        self.named = named(given)
        self.laws = {one.name: one.law for one in self.named}
        self.rows = stacked(self.named, sizes)
        self.stack = locator(self.named, self.rows)

    def sheets(self, book: Book, printed: Container[str] | None = None) -> None:
        """Declare a page for each law, and the Laws sheet; of the pages print all, or those of some laws."""
        begun = len(book.sheets)
        again(book, "law sheets", (self,), lambda: self._sheets(book))
        sheets = book.sheets[begun:]
        for one, sheet in zip((one for one in self.named if one.page.has_sheet), sheets, strict=False):
            sheet.unprinted = printed is not None and one.name.casefold() not in printed

    def _sheets(self, book: Book) -> None:
        for one in self.named:
            if one.page.has_sheet:
                law_sheet(book, one, self.sizes, self.stack)
        laws_sheet(book, self.named, self.sizes, self.rows, self.stack, self.hands_over)
