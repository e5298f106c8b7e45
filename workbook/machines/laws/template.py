"""Motion laws compared: every law of the book side by side, and what each costs."""

from typing import Any

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book
from workbook.book.summary import summary_sheet
from workbook.entries.rules import limits
from workbook.law_sheets.book_laws import BookLaws
from workbook.law_sheets.library import SIX, factors, pick_in_turn, vary_laws, varying
from workbook.laws.registry import CODES, FAMILY
from workbook.machines.laws.entries import MOST_CURVES, MotionLaws
from workbook.machines.laws.sheet import ComparedLaws, comparison_sheet, names_sheet
from workbook.template import Template, finish

CELLS = cell_tables(__file__)


def declare(given: MotionLaws) -> Book:
    """Declare the book."""
    cell = CELLS["declare"]
    book_laws = BookLaws(given.laws, given.sizes)
    view = ComparedLaws(given, book_laws.named, book_laws.stack)
    book = Book(given.template, given.title, limit=limits(type(given)), print_also=given.print_also)
    about = "Motion laws side by side: coefficients, curves over one another, and what each costs."
    summary_sheet(
        book,
        given,
        about,
        [
            cell("about_laws", len(view.moving)),
            cell("about_loss", view.least("loss")),
            cell("about_va", view.least("va")),
        ],
    )
    comparison_sheet(book, view)
    names_sheet(book, view)
    book_laws.sheets(book)
    return finish(book, ("S1", "S3"))


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn: 1 to 4 curves."""
    k = turn % SIX
    vary_laws(data["laws"], k, factors(k), data["sizes"]["pieces"])
    count = (MOST_CURVES, 1, 3, MOST_CURVES, 2, MOST_CURVES)[k]
    names = ["DWL", *data["laws"]]
    data["comparison"]["curves"] = [{"law": pick_in_turn(MOST_CURVES * turn + i, names)} for i in range(count)]
    return data


EVERY = {page.law.name: {"family": code} for code, page in FAMILY.items() if code not in CODES}
TEMPLATE = Template("motion-laws", MotionLaws, declare, varying(MotionLaws, varied), laws=EVERY)
