"""Overlap of motions (S2): the indexing mill and its tools, one after the other and with overlap."""

from __future__ import annotations

from workbook.book.declare import Book, Quantity, result
from workbook.book.summary import summary_sheet
from workbook.entries.rules import limits
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.overlap.axes import axes
from workbook.machines.overlap.check import check
from workbook.machines.overlap.cycle import cycle_sheets
from workbook.machines.overlap.entries import IndexingOverlap
from workbook.machines.overlap.exported import exportable
from workbook.machines.overlap.inverse import inverse_sheet
from workbook.machines.overlap.picture import picture_sheet
from workbook.machines.overlap.sheet import overlap_sheet
from workbook.machines.overlap.variations import variants
from workbook.machines.overlap.view import Overlapping, laid_out
from workbook.motion.exported import export_sheet
from workbook.template import Template, finish

PRINTED = ("S2: 4.154 m/s²", "S2: 0.804 m/s²", "S2: 5.17")
"""what S2 prints beside the first sheet's results"""


def declare(given: IndexingOverlap) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes)
    view = Overlapping(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    summary_sheet(
        book,
        given,
        "Motions of one machine, one after the other and with overlap: how much the acceleration falls.",
        in_short(view),
    )
    overlap_sheet(book, view, shelf.stack)
    picture_sheet(book, view, shelf.stack)
    cycle_sheets(book, view, shelf.stack)
    inverse_sheet(book, view, shelf.stack)
    shelf.sheets(book)
    export_sheet(book, given, exportable(view, shelf.stack))
    return finish(book, ("S2", "S1", "S3"))


def in_short(view: Overlapping) -> list[Quantity]:
    """Return the results of the first sheet: those of the tool, or the worst of several."""
    which, of = ("Peak", "tool1") if view.alone else ("Largest peak", "overlap")
    before, after, lower = PRINTED if view.alone else ("", "", "")
    first = view.stations[0]
    ratio = result("about_ratio", "The acceleration falls by a factor of", "", "", "=tool1_ratio",
                   first.as_set.times_lower(first.before), source=lower)  # fmt: skip
    return [
        result("about_a0", f"{which} acceleration one after the other", "a_max", "m/s²", f"={of}_a0", view.peaks[0],
               source=before),
        result("about_a1", f"{which} acceleration with overlap", "a_max", "m/s²", f"={of}_a1", view.peaks[1],
               source=after),
        *([ratio] if view.alone else []),
        result("about_least", "Least clearance over the cycle", "", "mm", f"={of}_least", view.least),
    ]  # fmt: skip


TEMPLATE = Template(
    "indexing-overlap",
    IndexingOverlap,
    declare,
    variants,
    LAW_SIZES
    | {"cycle": ("tool1_motions", 1), "margins": ("tool1_margins", 1), "motion_pieces": ("tool1_a_pieces", 0)},
    check,
    laid_out,
    axes,
)
