"""The templates: which machine model and which sheets make up each kind of book."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import cast

import workbook
from workbook.declare import FIRST, Book, Text, result
from workbook.machine import CuttingMachine, Machine
from workbook.reference import Cutting
from workbook.sheets.about import about_sheet, contents
from workbook.sheets.checks import checks_sheet, repeat_verdict
from workbook.sheets.drive import drive_sheet
from workbook.sheets.laws import PAGES, law_sheet
from workbook.sheets.laws_sheet import laws_sheet
from workbook.sheets.stack import CODES, locator, stacked
from workbook.sheets.timing import timing_sheet
from workbook.variants import cutting_variants

FOLDER = Path(workbook.__file__).parent.parent / "templates"


@dataclass(frozen=True)
class Template:
    """A kind of machine: its description's model, the book declared from a description, variations to verify at."""

    name: str
    model: type[Machine]
    declare: Callable[[Machine], Book]
    variants: Callable[[Machine], list[Machine]]
    sizes: dict[str, tuple[str, int]]  # entry of sizes: the block that tells it, and by how many rows it is longer

    @property
    def description(self) -> Path:
        """The committed machine description."""
        return FOLDER / f"{self.name}.toml"

    @property
    def book(self) -> Path:
        """The committed workbook."""
        return FOLDER / f"{self.name}.xlsx"


def cutting_machine(machine: Machine) -> Book:
    """Declare the book of a cutting machine: laws, timing diagram of three axes, drive of one of them."""
    given = cast(CuttingMachine, machine)
    reference = Cutting(given)
    book = Book(given.template, given.title)
    rows = stacked(reference.laws, given.laws.OWN.pieces, given.sizes)
    stack = locator(rows)
    axes = [a.name for a in given.timing.axes]
    movements = reference.diagram.movements(reference.rate)

    def greatest(axis: str) -> float:
        return max((m.a_max for m in movements if m.axis == axis), default=0.0)

    about_sheet(
        book,
        workbook.__version__,
        "A three-axis cutting machine: motion laws, timing diagram, and the drive of the feeding group.",
        [
            result(f"about_a{i}", f"Greatest acceleration of {name}", "ÿ_max", "m/s²",
                   f"=INDEX([axes.a],{i})", greatest(name), scale=1e-3)
            for i, name in enumerate(axes, 1)
        ],
    )  # fmt: skip
    timing_sheet(book, reference, stack)
    drive_sheet(book, reference)
    for page in PAGES:
        entered = getattr(given.laws, page.code)
        number = CODES.index(page.code) + 1
        law_sheet(book, page, reference.laws[page.code], entered, number, given.sizes.law, stack)
    laws_sheet(book, reference.laws, given.laws.OWN, given.sizes, rows)
    return finish(book, ("S1", "S2", "S3"))


def finish(book: Book, sources: tuple[str, ...]) -> Book:
    """Add what every book has: checks, the verdict on each sheet, contents, titles."""
    checks_sheet(book)
    repeat_verdict(book)
    contents(book, sources)
    for sheet in book.sheets:
        sheet.texts.append(Text(1, FIRST, sheet.title if sheet.title != "About" else TITLES[book.template], "title"))
        sheet.texts.append(Text(2, FIRST, sheet.purpose, "note"))
        if sheet.title != "About":
            sheet.texts.append(Text(3, FIRST + 4, "Contents", "link", "About"))
    book.name_columns(book.blocks["axes"], "axis")
    return book


TITLES = {"cutting-machine": "Cutting machine"}
LAW_SIZES = {"law": ("ACS_samples", 1), "own_law": ("own_samples", 1), "pieces": ("own_pieces", 0)}
CUTTING_SIZES = {"cycle": ("cycle", 1), "phases": ("axis1", 0), "rotors": ("rotors", 0)}
TEMPLATES = {
    t.name: t
    for t in (
        Template("cutting-machine", CuttingMachine, cutting_machine, cutting_variants, LAW_SIZES | CUTTING_SIZES),
    )
}
