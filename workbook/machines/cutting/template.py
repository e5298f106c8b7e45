"""The cutting machine of S1: laws, timing diagram of three axes, drive of one of them."""

from __future__ import annotations

import numpy as np

from engine.choice import LoadSamples, Task
from workbook.book.about import about_sheet
from workbook.book.declare import Book, result
from workbook.entries.rules import limits
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.cutting.axes import axes
from workbook.machines.cutting.drive import drive_sheet
from workbook.machines.cutting.entries import CuttingMachine
from workbook.machines.cutting.timing import cells, timing_sheet
from workbook.machines.cutting.variations import variants
from workbook.machines.cutting.view import Cutting
from workbook.motion.cells import rows_of
from workbook.selection.load import LoadCells
from workbook.selection.sheet import selection_sheet
from workbook.selection.view import Choosing
from workbook.template import Template, finish

LOAD = LoadCells(
    time="[drive.time]",
    speed="[drive.w]",
    acceleration="[drive.dw]",
    torque="[drive.total]",
    acceleration_rms="drive_wrms",
    torque_rms="SQRT((drive_jtot*drive_wrms)^2+drive_cr^2*drive_share)",
    power_rate_mean="drive_jtot*drive_wrms^2",
    max_speed="MAX(MAX([drive.w]),0-MIN([drive.w]))",
)
"""Where the Drive sheet has the load at the roller shaft."""


def declare(given: CuttingMachine) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes, bool(given.laws.of("LIN")))
    reference = Cutting(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    movements = reference.diagram.movements(reference.rate)
    names = [axis.name for axis in given.timing.axes]
    greatest = [max((m.a_max for m in movements if m.axis == name), default=0.0) for name in names]
    about_sheet(
        book,
        "A three-axis cutting machine: motion laws, timing diagram, and the drive of the feeding group.",
        [
            result(f"about_a{i}", f"Greatest acceleration of axis {i}", "ÿ_max", "m/s²", f"=[axes.a.{i}]", a)
            for i, a in enumerate(greatest, 1)
        ],
    )  # fmt: skip
    rooms = given.sizes.phases
    axes = enumerate(reference.axes, 1)
    timing_sheet(
        book, reference, [rows_of(cells(i, reference.hands_over), axis.motion, shelf.stack, rooms) for i, axis in axes]
    )
    book.name(
        "axes", axis_group="group", axis_name="name", axis_closes="closes", axis_smooth="smooth", axis_travel="travel",
        axis_low="low", axis_high="high", axis_v="v", axis_a="a",
    )  # fmt: skip
    drive_sheet(book, reference)
    selection_sheet(book, LOAD, choosing(reference))
    shelf.sheets(book)
    return finish(book, "Cutting machine", ("S1", "S2", "S3", "S5"))


def choosing(reference: Cutting) -> Choosing:
    """Return the choice of motor and reducer for the load at the roller shaft, exact by the laws where they are."""
    given, exact, points = reference.machine, reference.asked, reference.samples
    asked = Task.of_figures(exact.acceleration, exact.torque, exact.product, float(np.abs(points.speed).max()))
    samples = LoadSamples(reference.times, points.speed, points.acceleration, points.load)
    return Choosing(given.selection, given.sizes, asked, samples)


TEMPLATE = Template(
    "cutting-machine",
    CuttingMachine,
    declare,
    variants,
    LAW_SIZES
    | {"cycle": ("cycle", 1), "phases": ("axis1", 0), "motion_pieces": ("axis1_pieces", 0), "rotors": ("rotors", 0)}
    | {"motors": ("motors", 0), "reducers": ("reducers", 0)},
    axes=axes,
)
