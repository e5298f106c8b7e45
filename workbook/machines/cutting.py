"""The cutting machine of S1: laws, timing diagram of three axes, drive of one of them."""

from __future__ import annotations

from typing import cast

from workbook.declare import Book, result
from workbook.machine import CuttingMachine, Machine
from workbook.reference import Cutting
from workbook.sheets.about import about_sheet
from workbook.sheets.drive import drive_sheet
from workbook.sheets.timing import timing_sheet
from workbook.template import LAW_SIZES, LawShelf, Template, finish
from workbook.variants import cutting_variants


def declare(machine: Machine) -> Book:
    """Declare the book."""
    given = cast(CuttingMachine, machine)
    shelf = LawShelf(given.laws, given.sizes)
    reference = Cutting(given, shelf.laws)
    book = Book(given.template, given.title)
    movements = reference.diagram.movements(reference.rate)
    names = [axis.name for axis in given.timing.axes]
    greatest = [max((m.a_max for m in movements if m.axis == name), default=0.0) for name in names]
    about_sheet(
        book,
        "A three-axis cutting machine: motion laws, timing diagram, and the drive of the feeding group.",
        [
            result(f"about_a{i}", f"Greatest acceleration of {name}", "ÿ_max", "m/s²", f"=[axes.a.{i}]", a, scale=1e-3)
            for i, (name, a) in enumerate(zip(names, greatest, strict=True), 1)
        ],
    )  # fmt: skip
    timing_sheet(book, reference, shelf.stack)
    book.name_columns(book.blocks["axes"], "axis")
    drive_sheet(book, reference)
    shelf.sheets(book)
    return finish(book, "Cutting machine", ("S1", "S2", "S3"))


TEMPLATE = Template(
    "cutting-machine",
    CuttingMachine,
    declare,
    cutting_variants,
    LAW_SIZES | {"cycle": ("cycle", 1), "phases": ("axis1", 0), "rotors": ("rotors", 0)},
)
