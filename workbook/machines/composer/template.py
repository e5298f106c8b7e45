"""S3's composed motion: up to 24 phases over any abscissa."""

from __future__ import annotations

from workbook.book.declare import Book, result
from workbook.book.summary import summary_sheet
from workbook.entries.rules import limits
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.composer.axes import axes
from workbook.machines.composer.entries import MotionComposer
from workbook.machines.composer.phases import PER, PER2
from workbook.machines.composer.sheet import cells, cycle_sheet, motion_sheet
from workbook.machines.composer.variations import variants
from workbook.machines.composer.view import Composition
from workbook.motion.cells import rows_of
from workbook.motion.exported import Exportable, export_sheet
from workbook.template import Template, finish

UNIT = "as on Motion"


def declare(given: MotionComposer) -> Book:
    """Declare the book."""
    hands_over = bool(given.laws.of("LIN"))
    shelf = LawShelf(given.laws, given.sizes, hands_over)
    composed = Composition(given, shelf.laws)
    motion, (h, v, a, _) = composed.motion, composed.motion.sizes
    book = Book(given.template, given.title, limit=limits(type(given)))
    summary_sheet(
        book,
        given,
        "A motion composed of phases: each a motion law over a lift and a duration, in any units.",
        [
            result("about_travel", "Travel", "Σh", "lift", "=move_travel", motion.lifts_sum, scale=h, source=UNIT),
            result("about_v", "Greatest velocity", "|y'|_max", "lift/x",
                   "=move_v", motion.peaks.y1, scale=v, source=UNIT),
            result("about_a", "Greatest acceleration", "|y''|_max", "lift/x²",
                   "=move_a", motion.peaks.y2, scale=a, source=UNIT),
        ],
    )  # fmt: skip
    rows = rows_of(cells(hands_over), motion, shelf.stack, given.sizes.phases)
    motion_sheet(book, composed, rows)
    shelf.sheets(book)
    cycle_sheet(book, composed, rows)
    units = ("x", "lift", PER, PER2)
    export_sheet(book, given, [Exportable("motion", '="motion"', rows, units, (1.0, 1.0), "", motion.size)])
    return finish(book, "Composed motion", ("S1", "S3"))


TEMPLATE = Template(
    "motion-composer",
    MotionComposer,
    declare,
    variants,
    LAW_SIZES | {"cycle": ("motion", 1), "phases": ("phases", 0), "motion_pieces": ("move_pieces", 0)},
    axes=axes,
)
