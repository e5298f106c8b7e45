"""Any machine: laws, and the timing diagram of 1 to 24 axes at one rate."""

from __future__ import annotations

from workbook.book.about import about_sheet
from workbook.book.declare import Book, result
from workbook.entries.rules import limits
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.machine.axes import axes
from workbook.machines.machine.check import check
from workbook.machines.machine.chosen import catalogue_sheet
from workbook.machines.machine.cycle import cycle_sheet
from workbook.machines.machine.drive import drive_sheet
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.motion import AxisRows, pieces_sheet
from workbook.machines.machine.timing import timing_sheet
from workbook.machines.machine.variations import variants
from workbook.machines.machine.view import Whole, fixed, laid_out
from workbook.template import Template, finish


def declare(given: AnyMachine) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes)
    machine = Whole(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    rows = [AxisRows(machine, axis, shelf.stack) for axis in machine.axes]
    about_sheet(
        book,
        "A machine: the motions of its axes over one master shaft, at one rate.",
        [
            result("about_cycle", "Time of a cycle", "t_c", "s", "=timing_cycle", machine.time),
            *(
                result(f"about_a{i}", f"Greatest acceleration of axis {i}", "ÿ_max", f"{axis.base}/s²",
                       f"=[axes.a.{i}]", axis.hardest)
                for i, axis in enumerate(machine.axes, 1)
            ),
        ],
    )  # fmt: skip
    timing_sheet(book, machine, rows)
    book.name("axes", axis_name="name")
    driven = [one for one in rows if one.axis.given.mechanism and one.axis.given.motor]
    for one in driven:
        drive_sheet(book, one)
    catalogue_sheet(book, given)
    shelf.sheets(book)
    cycle_sheet(book, machine, rows)
    pieces_sheet(book, rows, bool(driven))
    return finish(book, "Machine", ("S1", "S3"))


TEMPLATE = Template(
    "machine",
    AnyMachine,
    declare,
    variants,
    LAW_SIZES
    | {"cycle": ("cycle", 1), "phases": ("axis1", 0), "motion_pieces": ("axis1_pieces", 0)}
    | {"rotors": ("drive#_parts", 0), "motors": ("motors", 0), "reducers": ("reducers", 0)},
    check,
    laid_out=laid_out,
    fixed=fixed,
    axes=axes,
)
