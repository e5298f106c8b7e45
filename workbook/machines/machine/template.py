"""Any machine: laws, and the timing diagram of 1 to 24 axes at one rate, or over any abscissa."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from engine.machine.pace import first_lowest
from engine.timing import turn_time
from workbook.book.declare import Book, Quantity, result
from workbook.book.summary import summary_sheet
from workbook.drive.in_short import NO_DRIVE, InShort, axes_in_short
from workbook.entries.abscissa import Abscissa
from workbook.entries.rules import limits
from workbook.entries.units import PER_MINUTE, shown, si
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.machine.apart import Apart
from workbook.machines.machine.axes import axes, switches
from workbook.machines.machine.bussed import Bus
from workbook.machines.machine.check import check
from workbook.machines.machine.chosen import catalogue_sheet
from workbook.machines.machine.clearances import clearances_sheet
from workbook.machines.machine.cycle import cycle_sheets, exportable
from workbook.machines.machine.drive import drive_sheet
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.judged import judge_axes
from workbook.machines.machine.linked.changing import over_motion
from workbook.machines.machine.linked.driven import driven_of
from workbook.machines.machine.linked.sheet import placed_sheet
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.motion import AxisRows, pieces_sheet
from workbook.machines.machine.pacing import rate_of
from workbook.machines.machine.power import power_sheet, supply
from workbook.machines.machine.printed import printed_sheets
from workbook.machines.machine.selecting.sheet import selection_sheet
from workbook.machines.machine.stretched import Stretched
from workbook.machines.machine.studied import SCALING
from workbook.machines.machine.switches import switches_sheet
from workbook.machines.machine.timed import TimedMachine, told_in_seconds
from workbook.machines.machine.timing import positions, rates, timing_sheet
from workbook.machines.machine.variations import variants
from workbook.machines.machine.view import MovingAxis, Whole, fixed, laid_out
from workbook.motion.exported import export_sheet
from workbook.template import Other, Template, finish


def declare(given: AnyMachine) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes, bool(given.laws.of("LIN")))
    machine = Whole(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    rows = [AxisRows(machine, axis, shelf.stack) for axis in machine.axes]
    drives = {one.axis.number: over_motion(one, driven_of(one.axis, given.selection))
              for one in rows if one.axis.given.mechanism and one.axis.given.motor}  # fmt: skip
    bus = Bus(list(drives.values()), given.power)
    sheet = summary_sheet(
        book,
        given,
        f"A machine: the motions of its axes over a cycle in {machine.over.unit}."
        if machine.over.measured
        else "A machine: the motions of its axes over one master shaft, at one rate.",
        [*pace(machine), *highest_rate(drives.values(), len(rows), machine.over), *supply(bus)],
    )  # fmt: skip
    axes_in_short(
        sheet,
        [in_short(axis, drives.get(axis.number)) for axis in machine.axes],
        positions(machine),
        [(symbol, rates(machine, order)) for order, symbol in enumerate(machine.over.symbols[1:3], 1)],
    )
    timing_sheet(book, machine, rows)
    switches_sheet(book, machine)
    book.name("axes", axis_name="name")
    for one in rows:
        view = drives.get(one.axis.number)
        if isinstance(view, PlacedWork):
            placed_sheet(book, view)
        elif view:
            drive_sheet(book, view)
    apart = [Apart(one, k, rows) for k, one in enumerate(given.clearances, 1)]
    clearances_sheet(book, apart)
    power_sheet(book, bus)
    selection_sheet(book, given.selection, given.sizes, list(drives.values()))
    catalogue_sheet(book, given)
    printed_sheets(book, drives.values())
    shelf.sheets(book, {phase.law.casefold() for axis in given.axes for phase in axis.phases})
    cycle_sheets(book, machine, rows)
    pieces_sheet(book, rows, bool(drives or apart))
    export_sheet(book, given, [exportable(one) for one in rows])
    judge_axes(book, machine.axes, given.laws.names)
    return finish(book, "Machine", ("S1", "S3", "S4"))


def pace(machine: Whole) -> list[Quantity]:
    """Return the results of how fast the machine goes; where nothing tells that, of how long its cycle is."""
    over = machine.over
    if not over.paced:
        return [result("about_cycle", "Length of a cycle", f"{over.symbol}_c", over.unit, "=timing_cycle", over.length)]
    return [
        result("about_rate", "Production rate", "n", "cycles/min", "=timing_rate", machine.machine.per_minute),
        result("about_cycle", "Time of a cycle", "t_c", "s", "=timing_cycle", machine.time),
    ]


def in_short(axis: MovingAxis, view: Stretched | None) -> InShort:
    """Return what the first sheet tells of an axis, and of its drive if it has one."""
    low, high = (shown(end, axis.unit) for end in axis.motion.reach)
    found = InShort(axis.given.name, high - low, axis.fastest, axis.hardest)
    if view is None:
        return found
    name, driven = axis.given.motor.name if axis.given.motor else "", view.driven
    return found._replace(reserve=driven.reserve, scope=f"drive{axis.number}_", motor=name,
                          ratio=driven.reducer.ratio, highest=rate_of(view))  # fmt: skip


def highest_rate(drives: Iterable[Stretched], axes: int, over: Abscissa) -> list[Quantity]:
    """Return the results of the whole machine: the highest rate at which all drives hold all limits, and who binds."""
    views = list(drives)
    if not views:
        return []
    rates = [rate_of(view) for view in views]
    each = np.array([rate.rate for rate in rates])
    least, binding, place = float(each.min()), int(first_lowest(each)), ""
    for view in reversed(views):
        number = view.driven.number
        held = f"drive{number}_highest<=about_highest*(1+check_zero)"
        place = f"IF({held},{number},{place})" if place else str(number)
    names = ("[axes_short.axis]", "[axes_short.binds]")
    told = [f"INDEX({column},{place})" if axes > 1 else column for column in names]
    return [
        result("about_highest", "Highest rate", "n_max", "cycles/min", "=MIN([axes_short.highest])", least,
               source="of all drives"),
        *([shortest(least)] if over.measured else []),
        result("about_binds", "Axis and limit that bind there", "", "", f'={told[0]}&": "&{told[1]}',
               f"{views[binding].driven.axis.given.name}: {rates[binding].limit}", align="right",
               source="the first, of equal ones"),
    ]  # fmt: skip


def shortest(rate: float) -> Quantity:
    """Return the result of the shortest cycle: at the highest rate."""
    time = turn_time(si(rate, PER_MINUTE)) if rate > 0 else NO_DRIVE
    formula = f'=IF(about_highest>0,60/about_highest,"{NO_DRIVE}")'
    return result("about_shortest", "Shortest cycle", "t_c,min", "s", formula, time, align="right",
                  source="all times scaled")  # fmt: skip


TEMPLATE = Template(
    "machine",
    AnyMachine,
    declare,
    variants,
    LAW_SIZES
    | {"cycle": ("cycle1", 1), "phases": ("axis1", 0), "motion_pieces": ("axis1_pieces", 0)}
    | {"rotors": ("drive#_parts", 0), "positions": ("drive#_points", 0)}
    | {"motors": ("motors", 0), "reducers": ("reducers", 0)},
    check,
    laid_out=laid_out,
    fixed=fixed,
    axes=axes,
    scaling=SCALING,
    switches=switches,
    others={"master.cycle": Other(TimedMachine, told_in_seconds)},
)
