"""The cutting machine of S1: laws, timing diagram of three axes, drive of one of them."""

from __future__ import annotations

import numpy as np

from engine.choice import LoadSamples, Task
from engine.timing import Axis
from workbook.book.declare import Book, result
from workbook.book.summary import summary_sheet
from workbook.drive.in_short import InShort, axes_in_short
from workbook.entries.rules import limits
from workbook.entries.units import DEGREE, MM, RPM, shown
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.cutting.axes import axes
from workbook.machines.cutting.drive import drive_cycle_sheet, drive_sheet
from workbook.machines.cutting.entries import CuttingMachine
from workbook.machines.cutting.timing import cells, cycle_sheet, timing_sheet
from workbook.machines.cutting.variations import variants
from workbook.machines.cutting.view import Cutting
from workbook.motion.cells import PieceRows, rows_of
from workbook.motion.exported import Exportable, export_sheet
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
    points = reference.reserve
    sheet = summary_sheet(
        book,
        given,
        "A three-axis cutting machine: motion laws, timing diagram, and the drive of the feeding group.",
        [
            result("about_rate", "Production rate", "n", "pieces/min", "=timing_rate", given.timing.rate),
            result("about_drive", "Rate at which the drive is sized", "n", "pieces/min",
                   "=drive_rate", given.drive.rate),
            result("about_peak", "Peak torque of the drive's motor", "C_m,max", "Nm",
                   "=MAX(drive_tmax,0-drive_tmin)", points.peak_torque.value),
            result("about_rms", "RMS torque of the drive's motor", "C_m,rms", "Nm",
                   "=drive_rms", points.rms_torque.value),
            result("about_speed", "Largest speed of the drive's motor", "n_m", "rpm",
                   "=drive_speed", shown(points.speed.value, RPM)),
        ],
    )  # fmt: skip
    axes_in_short(sheet, [in_short(axis, reference.speed) for axis in reference.axes], "mm", "m")
    rooms = given.sizes.phases
    axes = list(enumerate(reference.axes, 1))
    rows = [rows_of(cells(i, reference.hands_over), axis.motion, shelf.stack, rooms) for i, axis in axes]
    timing_sheet(book, reference, rows)
    book.name(
        "axes", axis_group="group", axis_name="name", axis_closes="closes", axis_smooth="smooth", axis_travel="travel",
        axis_low="low", axis_high="high", axis_v="v", axis_a="a",
    )  # fmt: skip
    drive_sheet(book, reference)
    selection_sheet(book, LOAD, choosing(reference))
    shelf.sheets(book)
    cycle_sheet(book, reference, rows)
    drive_cycle_sheet(book, reference)
    export_sheet(book, given, [exportable(i, axis, one) for (i, axis), one in zip(axes, rows, strict=True)])
    return finish(book, "Cutting machine", ("S1", "S2", "S3", "S5"))


def exportable(i: int, axis: Axis, rows: PieceRows) -> Exportable:
    """Return an axis as the sheet Export may have it."""
    return Exportable(axis.name, f"=[axes.name.{i}]", rows, ("°", "mm", "mm/°", "mm/°²"),
                      (shown(1.0, DEGREE), shown(1.0, MM)), "*1000", axis.motion.size)  # fmt: skip


def in_short(axis: Axis, speed: float) -> InShort:
    """Return what the first sheet tells of an axis."""
    low, high = shown(np.array(axis.motion.reach), MM).tolist()
    moves = axis.movements(speed)
    fastest, hardest = (max((getattr(m, which) for m in moves), default=0.0) for which in ("v_max", "a_max"))
    return InShort(axis.name, high - low, fastest, hardest)


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
