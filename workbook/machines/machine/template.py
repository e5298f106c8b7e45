"""Any machine: laws, and the timing diagram of 1 to 24 axes at one rate."""

from __future__ import annotations

from workbook.book.declare import Book, result
from workbook.book.summary import summary_sheet
from workbook.drive.in_short import InShort, axes_in_short
from workbook.entries.rules import limits
from workbook.entries.units import shown
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.machine.axes import axes, switches
from workbook.machines.machine.chain import LINKED
from workbook.machines.machine.check import check
from workbook.machines.machine.chosen import catalogue_sheet
from workbook.machines.machine.cycle import cycle_sheet, exportable
from workbook.machines.machine.drive import drive_sheet
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.linked.driven import LinkedDriven
from workbook.machines.machine.linked.sheet import linked_sheet
from workbook.machines.machine.motion import AxisRows, pieces_sheet
from workbook.machines.machine.studied import SCALING
from workbook.machines.machine.switches import switches_sheet
from workbook.machines.machine.timing import joined, timing_sheet
from workbook.machines.machine.variations import variants
from workbook.machines.machine.view import MovingAxis, Whole, fixed, laid_out
from workbook.motion.exported import export_sheet
from workbook.selection.entries import Products
from workbook.template import Template, finish


def declare(given: AnyMachine) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes, bool(given.laws.of("LIN")))
    machine = Whole(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    rows = [AxisRows(machine, axis, shelf.stack) for axis in machine.axes]
    drives = {axis.number: driven(axis, given.selection)
              for axis in machine.axes if axis.given.mechanism and axis.given.motor}  # fmt: skip
    sheet = summary_sheet(
        book,
        given,
        "A machine: the motions of its axes over one master shaft, at one rate.",
        [
            result("about_rate", "Production rate", "n", "cycles/min", "=timing_rate", given.master.rate),
            result("about_cycle", "Time of a cycle", "t_c", "s", "=timing_cycle", machine.time),
        ],
    )  # fmt: skip
    axes_in_short(
        sheet,
        [in_short(axis, drives.get(axis.number)) for axis in machine.axes],
        joined(machine, si=False),
        joined(machine),
    )
    timing_sheet(book, machine, rows)
    switches_sheet(book, machine)
    book.name("axes", axis_name="name")
    for one in rows:
        found = drives.get(one.axis.number)
        if isinstance(found, LinkedDriven):
            linked_sheet(book, one, found)
        elif found:
            drive_sheet(book, one, found)
    catalogue_sheet(book, given)
    shelf.sheets(book)
    cycle_sheet(book, machine, rows)
    pieces_sheet(book, rows, bool(drives))
    export_sheet(book, given, [exportable(one) for one in rows])
    return finish(book, "Machine", ("S1", "S3"))


def driven(axis: MovingAxis, products: Products) -> Driven:
    """Return the drive of an axis."""
    linked = axis.given.mechanism and axis.given.mechanism.kind in LINKED
    return LinkedDriven(axis, products) if linked else Driven(axis, products)


def in_short(axis: MovingAxis, driven: Driven | None) -> InShort:
    """Return what the first sheet tells of an axis, and of its drive if it has one."""
    low, high = (shown(end, axis.unit) for end in axis.motion.reach)
    found = InShort(axis.given.name, high - low, axis.fastest, axis.hardest)
    if driven is None:
        return found
    name = axis.given.motor.name if axis.given.motor else ""
    return found._replace(reserve=driven.reserve, scope=f"drive{axis.number}_", motor=name,
                          ratio=driven.reducer.ratio)  # fmt: skip


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
    scaling=SCALING,
    switches=switches,
)
