"""Sizing of an actuator (S4): lead screw, conveyor, rack and pinion, belt, rotary table, gear train."""

from __future__ import annotations

from engine.choice import LoadSamples, Task
from workbook.book.declare import Book, result
from workbook.book.summary import summary_sheet
from workbook.entries.rules import limits
from workbook.entries.units import shown
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.actuator.axes import axes
from workbook.machines.actuator.check import check
from workbook.machines.actuator.cycle import cycle_sheet
from workbook.machines.actuator.entries import ActuatorSizing
from workbook.machines.actuator.printed import printed_sheet
from workbook.machines.actuator.rms import rms_sheet
from workbook.machines.actuator.sheet import actuator_sheet
from workbook.machines.actuator.tables import AT
from workbook.machines.actuator.variations import variants
from workbook.machines.actuator.view import Sized
from workbook.motion.cells import rows_of
from workbook.motion.exported import Exportable, export_sheet
from workbook.selection.load import LoadCells
from workbook.selection.sheet import selection_sheet
from workbook.selection.view import Choosing
from workbook.template import Template, finish

LOAD = LoadCells(
    time="[cycle.time]",
    speed="[cycle.w]",
    acceleration="[cycle.dw]",
    torque="[cycle.total]",
    acceleration_rms="act_wrms",
    torque_rms="act_lrms",
    power_rate_mean="act_lmean",
    max_speed="act_wmax",
)
"""where the book has the load at the shaft that the motor, or its reducer, is coupled to"""


def declare(given: ActuatorSizing) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes)
    view = Sized(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    peak, fastest = view.sizing.peak_torque, view.sizing.max_speed
    torque, speed = view.sides.torque, view.sides.motor_speed
    summary_sheet(
        book,
        given,
        "Sizing of an actuator: what a cycle of moves asks of the motor behind a mechanism.",
        [
            result("about_peak", "Peak torque of the motor", "T_max", "Nm", "=act_peak", peak, scale=torque),
            result("about_rms", "RMS torque of the motor", "T_RMS", "Nm", "=act_rms", view.rms_torque, scale=torque),
            result("about_speed", "Largest speed of the motor", "ω_m", "rad/s", "=act_wmax", fastest, scale=speed),
        ],
    )  # fmt: skip
    rows = rows_of(AT, view.sizing.motion, shelf.stack, given.sizes.phases)
    actuator_sheet(book, view, rows)
    cycle_sheet(book, view, rows)
    rms_sheet(book, view, shelf.named)
    selection_sheet(book, LOAD, choosing(view, given))
    printed_sheet(book, view)
    shelf.sheets(book)
    units = ("s", "mm or °", "mm/s or °/s", "mm/s² or °/s²")
    export_sheet(book, given, [Exportable("load", '="load"', rows, units, (1.0, shown(1.0, view.unit)), "/act_unit",
                                          view.sizing.motion.size)])  # fmt: skip
    return finish(book, "Sizing of an actuator", ("S4", "S1", "S3", "S5"))


def choosing(view: Sized, given: ActuatorSizing) -> Choosing:
    """Return the choice of motor and reducer for the load at the first shaft."""
    at, asked = view.sizing.motion.at(view.time), view.squares
    shaft = view.drive.shafts(at.y1, at.y2, view.sizing.going(view.time))[0]
    wanted = Task.of_figures(asked.acceleration, asked.torque, asked.product, view.sizing.max_speed)
    return Choosing(given.selection, given.sizes, wanted, LoadSamples(view.time, *shaft))


TEMPLATE = Template(
    "actuator-sizing",
    ActuatorSizing,
    declare,
    variants,
    LAW_SIZES
    | {"cycle": ("cycle", 1), "phases": ("phases", 0), "motion_pieces": ("act_pieces", 0)}
    | {"rotors": ("act_parts", 0), "gears": ("act_gears", 0)}
    | {"motors": ("motors", 0), "reducers": ("reducers", 0)},
    check,
    axes=axes,
)
