"""The phases of an axis on the Timing sheet: entries, results of each movement, and checks."""

import math
from collections.abc import Callable
from typing import Any

from engine.motion import Phase
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet, check
from workbook.book.rows import filled
from workbook.book.sentence import amount, first_text
from workbook.entries.abscissa import Abscissa
from workbook.entries.phase import TURN
from workbook.fields.units import shown
from workbook.law_sheets.page import finite
from workbook.laws import sampling
from workbook.laws.sampling import ACCELERATION, JERK, LAW_NUMBER, VELOCITY
from workbook.machines.machine.entries import OPEN_DRIVE
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.timing.stops import stop_check, stops_of
from workbook.motion.pieces import room_check

CELLS = cell_tables(__file__)


def phase_workings(tables: AxisTables) -> list[Quantity]:
    """Return the columns of what the cells compute with for each phase."""
    cell = CELLS["geometric"].sharing(base=tables.axis.base)
    return [
        *faults(tables),  # texts first: a number would show as ### at the print's edge
        *used_columns(tables),
        cell("y1", moving(tables, lambda phase: phase.y1_max), own=own(tables, "vmax", VELOCITY)),
        cell("y2", moving(tables, lambda phase: phase.y2_max), own=own(tables, "amax", ACCELERATION)),
        cell("y3", moving(tables, lambda phase: phase.y3_max), own=own(tables, "jmax", JERK)),
    ]


def moving(tables: AxisTables, figure: Callable[[Phase], float]) -> list[float | str]:
    """Return a figure of each phase that moves, 0 of the others."""
    moves = tables.axis.moves
    return [finite(figure(moves[k])) if k in moves else 0.0 for k in range(tables.rows)]


def every_second_row(formula: str) -> str:
    """Return a formula that takes a figure of the same row, of which phases stand in every second."""
    return formula.replace(",[k])", ",2*[k])")


def own(tables: AxisTables, column: str, formula: str) -> str:
    """Return a formula of each phase: that of its own ends, if phases of the book hand over, or the law's."""
    return every_second_row(tables.ends.own(column, formula)) if tables.ends else formula


def phase_columns(tables: AxisTables) -> list[Quantity]:
    """Return the columns of phases: kind and entries, rates at the ends too if they hand over; greatest rates."""
    over, axis = tables.machine.over, tables.axis
    key = f"axes.{axis.number - 1}.phases.*"

    def entry(name: str) -> list[Any]:
        return filled([getattr(p, name) for p in axis.typed.phases], tables.rows, None)

    passing, kind = list[Quantity](), every_second_row(sampling.kind(tables.at.ends))
    cell = CELLS["entered"].sharing(unit=over.unit, key=key)
    if tables.ends:
        units, symbols = (tables.at.unit(1), tables.at.unit(2)), ("y'", "y''")
        if over.measured:
            units, symbols = over.rates(axis.given.unit)[:2], over.symbols[1:3]
        rates = zip(("velocity", "acceleration"), units, symbols, strict=True)
        passing = [cell(name, entry(name), unit=unit, symbol=symbol) for name, unit, symbol in rates]
    return [
        cell("kind", sampling.kinds(axis.phases, tables.rows), formula=kind),
        cell("start", entry("start"), format=over.format, upper_limit=over.upper_limit),
        cell("stop", entry("stop"), format=over.format, upper_limit=over.upper_limit),
        cell("lift", entry("lift"), unit=axis.given.unit),
        cell("law", entry("law")),
        *passing,
        *extremes(tables),
    ]


def extremes(tables: AxisTables) -> list[Quantity]:
    """Return the columns of each movement's greatest rates, and its duration where the cycle's length is entered."""
    axis, over = tables.axis, tables.machine.over
    units, lift = tuple(over.rates(axis.given.unit)), over.lift(axis.given.unit).shown

    def timed(k: int, figure: Callable[[Phase], float]) -> list[float | str]:
        return moving(tables, lambda phase: axis.rate(figure(phase) * axis.speed**k))

    durations = [1000.0 * p.duration / axis.speed for p in axis.phases]
    cell = CELLS["extremes"].sharing(unit=over.unit, length=over.length, symbols=over.extremes, units=units, lift=lift)
    lasting = filled([over.shown(p.stop - p.start) for p in axis.given.phases], tables.rows)
    lasts = cell("lasts", lasting, symbol=over.lasting) if over.measured else cell("ms", filled(durations, tables.rows))
    return [
        lasts,
        cell("v", timed(1, lambda phase: phase.y1_max)),
        cell("a", timed(2, lambda phase: phase.y2_max)),
        cell("j", timed(3, lambda phase: phase.y3_max)),
    ]


def used_columns(tables: AxisTables) -> list[Quantity]:
    """Return law, lift and angles of each phase as the cells compute with them."""
    cell = CELLS["used"]
    n, axis, over = tables.rows, tables.axis, tables.machine.over
    phases, turned = axis.phases, axis.given.phases
    start, stop = over.degrees_formula("[start]"), over.degrees_formula("[stop]")
    to_base = "[lift]/1000" if axis.given.unit == "mm" else "RADIANS([lift])"
    laws = filled([tables.machine.given.laws.number(p.law) for p in turned], n, 1)
    return [
        cell("k", list(range(1, n + 1))),
        cell("no", laws, formula=LAW_NUMBER),
        cell("h", filled([p.lift for p in phases], n), unit=axis.base, to_base=to_base),
        cell("span", filled([p.duration for p in phases], n), stop=stop, start=start),
        cell("begin", filled([p.start for p in turned], n, 360.0), start=start, scale=360.0),
        cell("end", filled([p.stop for p in turned], n, 360.0), stop=stop, scale=360.0),
        place_in_diagram(tables),
    ]


def place_in_diagram(tables: AxisTables) -> Quantity:
    """Return the column of the middle of each movement in the cycle, before its begin where nothing moves."""
    axis, over, near = tables.axis, tables.machine.over, tables.machine.near
    middles = [(p.start + p.stop) / 2 + axis.given.shift for p in axis.given.phases]
    places = [
        over.shown(x - TURN * math.floor((x + near) / TURN)) if p.lift else -1.0
        for x, p in zip(middles, axis.phases, strict=True)
    ]
    middle = f"([begin]+[end])/2+[axes_taken.late.{axis.number}]"
    place = over.shown_formula(f"{middle}-360*INT(({middle}+eps)/360)")
    cell = CELLS["used"].sharing(unit=over.unit, scale=over.length)
    return cell("place", filled(places, tables.rows, -1.0), place=place)


def faults(tables: AxisTables) -> list[Quantity]:
    """Return the columns of the faults of each phase, and of the rest before it."""
    axis, over = tables.axis, tables.machine.over
    lacks = filled([p.missing_lift for p in axis.phases], tables.rows)
    lack = own(tables, "", "=[h]*(1-INDEX(law_s1,[no]))")
    cell, phases, n = CELLS["faults"].sharing(after=over.after), axis.given.phases, tables.rows
    # how long the axis rests before each phase; before the first spare row, behind the last
    begins = filled([p.start for p in phases], n, 360.0)
    ends = [0.0, *filled([p.stop for p in phases], n, 360.0)]
    gaps = [begin - end for begin, end in zip(begins, ends, strict=False)]
    return [
        cell("backwards", ""),
        cell("early", "", too_soon=over.shown_formula("0-[gap]")),
        *([beyond(over)] if over.measured else []),
        cell("gap", gaps, scale=360.0),
        cell("lack", lacks, unit=axis.base, lack=lack, scale=axis.motion.size(0)),
    ]


def beyond(over: Abscissa) -> Quantity:
    """Return the column of how far a row from ``start`` to ``stop`` goes on beyond the cycle, in words."""
    last = "MAX([start],[stop])"
    degrees, late = over.degrees_formula(last), going_beyond(last, over)
    return CELLS["beyond"]("beyond", "", degrees=degrees, late=late)


def going_beyond(last: str, over: Abscissa) -> str:
    """Return the formula of how far something goes on beyond the cycle."""
    at, by = (f"ROUND({x},9)" for x in (last, f"{last}-{over.shown_formula('360')}"))
    return f'"goes to "&{at}&"{over.after}, "&{by}&"{over.after} beyond the cycle"'


def no_fault(name: str, label: str, texts: str, called: str) -> Quantity:
    """Return the check that a column of faults is empty; where it is not, it says whose is the first, and its row."""
    row = first_text(texts)
    says = f'{called}&{row}&" "&INDEX({texts},{row})'
    return check(name, label, f'COUNTIF({texts},"?*")=0', True, says=says)


def axis_checks(sheet: Sheet, tables: AxisTables) -> None:
    """Declare the checks of an axis; each calls it by its number, as it may get another name."""
    axis, t, i = tables.axis, tables.name, tables.axis.number
    motion, unit, label, over = axis.motion, axis.given.unit, f"Axis {i}", tables.machine.over
    lift, lack, gap = (f"[axes_taken.{name}.{i}]" for name in ("lift", "lack", "gap"))

    def none_in(column: str, name: str, condition: str) -> Quantity:
        called = f'[axes.name.{i}]&" row "'
        return no_fault(f"{t}_{name}", f"{label}: {condition}", f"[{tables.taken}.{column}]", called)

    late = [("beyond", "within", "no phase goes on beyond the cycle")] if over.measured else []
    cuts = f"2*COUNT([drive{i}_windows.start])" if axis.given.motor else ""
    lacks = amount(lack, shown(axis.missing_lift, axis.unit), "a lift lacks ", f" {unit}")
    ends = amount(gap, shown(motion.gap, axis.unit), "it ends ", f" {unit} from where it begins")
    cell = CELLS["axis_checks"].sharing(t=t, label=label, lift=lift, i=i)
    sheet.checks(
        none_in("backwards", "forward", "every phase runs forward"),
        none_in("early", "follows", "phases follow without overlap"),
        *(none_in(*each) for each in late),
        cell("{t}_position", motion.complete, lack=lack, says=lacks),
        room_check(f"{t}_room", tables.at, label, cuts),
        *(tables.ends.checks(t, f"{label}: ") if tables.ends else []),
        *map(stop_check, stops_of(axis)),
        tables.joints.check(f"{t}_smooth", f"{label}: as smooth as asked"),
        cell("{t}_closes", axis.closes, gap=gap, says=ends),
        *([] if axis.given.motor is None else [cell("{t}_repeats", True, open_drive=OPEN_DRIVE)]),
    )
