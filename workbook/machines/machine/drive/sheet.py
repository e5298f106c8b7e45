"""The sheet of a drive: entries, results, checks, and the table of points from which all results come."""

import math
import re

import numpy as np

from engine.drive.drive_points import stated_bounds
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.sentence import CheckSentence, Sentence, amount, as_shown, quoted
from workbook.drive import motor
from workbook.entries.facts import table_of
from workbook.fields.texts import sheet_title
from workbook.fields.units import KG_CM2, KW, PER_RPM, RPM, shown
from workbook.machines.machine.drive import (
    by_angle,
    in_use,
    max_rate,
    points,
    rates_between,
    reducer_load,
    torques,
)
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.entered import listed, loads, parts_and_forces, windows_check
from workbook.machines.machine.drive.front_page import NAMED, RIGHT, FrontPage
from workbook.machines.machine.drive.mechanisms import LINKAGES, page
from workbook.machines.machine.drive.reach import linkage_checks, reach_table
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive.workings import again_table, peaks_table, turns_check, turns_table, workings
from workbook.machines.machine.entries import Axis
from workbook.machines.machine.mechanism import ON_BED, SCREWS
from workbook.selection.catalogue import FULL_CYCLES

CELLS = cell_tables(__file__)

MACHINES, OWN = "the machine's rate", "a rate of its own"
LEVEL = (
    "its peak torque falls beyond a speed, and this book knows none that does: give it to the description, and build"
)


def drive_sheet(book: Book, view: DriveView) -> None:
    """Declare the sheet."""
    driven, sizes = view.driven, view.tables.machine.given.sizes
    linkage = LINKAGES.get(driven.given.kind)
    sized = linkage.sizes if linkage else by_angle.crank_sizes if view.slides else page.constant_sizes
    title = sheet_title(driven.called, [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"The drive of axis {driven.number}: what its motion asks of the motor.")
    sheet.called = driven.called
    with sheet.scoped(f"drive{driven.number}_"):
        judged = checks(view)
        quantities = [*entries(driven), *in_use.figures(driven), *at_rate(view), *outcome(view)]
        quantities += [*uses(view), *listed(driven)]
        front = FrontPage(sheet, [*quantities, *judged])
        front.place(points.charts(view))
        parts_and_forces(sheet, view)
        checks_of_entries(sheet, view, front, judged)
        is_printed = "workings" in book.print_also
        if not is_printed:
            sheet.note(CLOSED)
            sheet.folded_rows = sheet.row
        sheet.heading("Workings: motor and reducer")
        sheet.rows(*(q for q in quantities if q.name not in NAMED and q.formula is not None))
        workings(sheet, view, sized(driven))
        if linkage and linkage.worked:
            linkage.worked(sheet, driven, sizes.positions)
        if driven.linkage:
            reach_table(sheet, view, driven.linkage)
        peaks_table(sheet, view)
        again_table(sheet, view)
        rates_between.rates_table(sheet, view)
        max_rate.creeping_table(sheet, view)
        if view.for_selection:
            reducer_load.means(sheet, view)
        sheet.heading("Workings: the motor's limits in the chart")
        backward = min(0.0, float(view.cycle.direction.min()))
        corners = driven.motor.corners(backward)
        motor.limits_table(sheet, corners, "MIN([@iv.dir])<0", view.knows_falling)
        motor.rms_point(sheet, view.points.mean_speed, view.points.rms_torque)
        points.limit_lines(sheet, view)
        sheet.heading("Workings: the cycle in intervals and points")
        turns_table(sheet, view)
        points.cuts_table(sheet, view)
        points.intervals_table(sheet, view)
        points.points_table(sheet, view)
        points.tops_table(sheet, view)
        points.samples_table(sheet, view)
        if is_printed:
            sheet.not_printed_below()


ANGLE_ROWS = 13
CLOSED = "The workings of this sheet stand below, in rows that are hidden: select the rows around them, and Unhide."


def checks_of_entries(sheet: Sheet, view: DriveView, front: FrontPage, judged: list[Quantity]) -> None:
    """Place the checks that have no row on the page, below what is printed, and a picture of a shaft that swings."""
    sheet.book.checks += [(sheet, q.within(sheet.scope)) for q in judged if q.name in NAMED]
    sheet.heading("Checks of what is entered")
    top = sheet.row
    sheet.checks(*front.verdicts(), *(q for q in judged if q.name not in NAMED))
    if view.varies:
        sheet.chart(points.angle_chart(view), RIGHT, top, 8, ANGLE_ROWS)
        sheet.row = max(sheet.row, top + ANGLE_ROWS)


def entries(driven: Driven) -> list[Quantity]:
    """Return the entries of this mechanism, its load, stages, reducer and motor."""
    cell = CELLS["entries"]
    m, key = driven.given, f"axes.{driven.number - 1}"
    entry = table_of(type(m)).entries(m, f"{key}.mechanism")
    own = table_of(Axis).entries(driven.entered, key)
    none = f"empty: {'2 − 1/η_2, of its friction' if m.kind in SCREWS else 'η_2'}; 0 or less: self-locking"
    return [
        cell("@axis", driven.entered.name, number=driven.number),
        cell("@{kind}", m.kind, kind=re.sub("[ -]", "_", m.kind)),
        own("@own_rate"),
        *page.entered_sizes(driven, key),
        entry("@eta2"),
        entry("@eta2_back", source=none),
        entry("@method"),
        *loads(driven, key),
        *in_use.entries(driven, key),
        *torques.stage_entries(driven, key),
    ]


UNDAMPED = "; exact without viscous friction"


def to(bound: float, of: str = "") -> str:
    """Return the words for a bound: as a share of the result, or ``of`` another."""
    return f"to {100.0 * bound:g} %{f' of {of}' if of else ''}"


def outcome(view: DriveView) -> list[Quantity]:
    """Return the results: torques, speeds, energies that the cycle asks of the motor, and the range of rates."""
    driven, at, rows = view.driven, view.points, view.peaks.rows
    reducer, own, bound = view.reducer_checks, driven.entered.rate, stated_bounds(driven.train)
    beside = driven.motor_used.inertia, driven.reducer.inertia, driven.beside_motor
    inertias = np.array([*beside, reducer_load.behind_reducer(view)])
    fastest = (
        "=MAX([@tops.top.7],[@tops.top.9],0-[@tops.top.8],0-[@tops.top.10])"
        if view.varies
        else "=ABS(@i)*@vmax*@omega*60/(2*PI())"
    )
    sum_of = "the largest over the stroke" if view.varies or view.slides else "Σ J/i², load and parts"
    damped = "" if view.varies or driven.by_angle else UNDAMPED
    speed = f"i_1 φ' ẏ, {to(bound.speed)}" if view.varies else "C_v h/t, through the ratio"
    cell = CELLS["outcome"].sharing(**view.parts, inertia=torques.inertia(driven))
    return [
        cell("@sized", OWN if own else MACHINES, machines=MACHINES, own=OWN),
        cell("@rate", view.rate),
        cell("@jtot", shown(view.inertia, KG_CM2), source=sum_of),
        cell("@inertias", view.inertia_ratio),
        cell("@j_all", shown(driven.motor_used.inertia + view.inertia, KG_CM2)),
        cell("@j_figures", Sentence(" + ".join(map(as_shown, shown(inertias, KG_CM2))))),
        cell("@largest", view.peaks.size("T"), source=to(bound.peak_torque)),
        cell("@tmax", view.peaks.top("T"), source=to(bound.peak_torque) + damped, row=rows["T", 1, 2]),
        cell("@tmin", -view.peaks.top("T", -1), source=to(bound.peak_torque), row=rows["T", -1, 2]),
        cell("@rms", at.rms_torque, bound=to(bound.rms_torque, "the peak")),
        cell("@t_hold", at.holding_torque),
        cell("@speed", shown(view.speed, RPM), formula=fastest, source=speed),
        cell("@mean", shown(at.mean_speed, RPM)),
        motor.continuous(view.driven.motor, at.mean_speed),
        *([cell("@spare", view.spare)] if view.knows_falling else []),
        cell("@smax", reducer[0].value, source=to(bound.peak_torque), row=rows["S", 1, 2], lowest=rows["S", -1, 2]),
        cell("@smean", reducer[1].value, cubic_mean=max_rate.cubic("[@pt.S]")),
        *energies(view),
        *max_rate.range_results(view),
    ]


def uses(view: DriveView) -> list[Quantity]:
    """Return the shares of the limits that are used, and the reserves of the motor."""
    cell, limits = CELLS["uses"], view.driven.limits
    names = ("rms", "peak", "speed", "reducer", "mean", "input")
    least = (limits.rms_reserve, limits.peak_reserve)
    shares = {name: check.use for name, check in zip(names, [*view.reserve, *view.reducer_checks], strict=True)}
    shares["inertia"] = view.inertia_ratio / limits.inertia_ratio
    reserves = zip(names, view.reserve, (*least, limits.speed_reserve), strict=False)
    return [
        *(cell(f"@use_{name}", use, limit=1.0) for name, use in shares.items()),
        *(cell(f"@res_{name}", check.reserve * reserve) for name, check, reserve in reserves),
        max_rate.CELLS["results"]("@creep_use", max(max_rate.creep_uses(view)), scale=1.0, limit=1.0),
    ]


def energies(view: DriveView) -> list[Quantity]:
    """Return the results of the motor's energy and power over the cycle."""
    (driving, returned), bound = view.energy, stated_bounds(view.driven.train)
    mean = shown((driving - returned) / view.driven.drive_cycle.time, KW)
    lowest, rows = shown(min(0.0, -view.peaks.top("P", -1)), KW), view.peaks.rows
    cell = CELLS["energies"].sharing(**view.parts)
    return [
        cell("@energy", driving, bound=to(bound.energy, "both energies")),
        cell("@returned", returned, source=to(bound.energy, "both energies")),
        cell("@power", mean, source=to(bound.mean_power, "the peak")),
        cell("@pmax", shown(max(0.0, view.peaks.top("P")), KW), source=to(bound.peak_power), row=rows["P", 1, 2]),
        cell("@pmin", lowest, bound=to(bound.peak_power, "the larger"), row=rows["P", -1, 2]),
        *([cell("@brake_load", view.points.brake_torque)] if view.brakes else []),
    ]


def at_rate(view: DriveView) -> list[Quantity]:
    """Return the rows of the reducer's cycles an hour, and of the motor's curve if the book has any."""
    cell = CELLS["at_rate"]
    driven, falling = view.driven, view.driven.catalogued_falling
    held = view.reducer_checks[0].limit
    peak, row, motors = driven.motor.peak_torque, driven.motor_used.row, driven.products.motors
    listed = row > 0 and motors[row - 1].end_torque is not None
    fastest = driven.motor.max_speed * driven.limits.speed_reserve
    rows = [
        cell("@cycles", view.cycles),
        cell("@full", driven.reducer.full_cycles or FULL_CYCLES, full_cycles=f"{FULL_CYCLES:g}"),
        cell("@reducer_held", 0.0 if math.isinf(held) else held),
        cell("@listed", int(listed)),
        cell("@drop", falling.fall * (fastest - falling.knee), scale=peak),
    ]
    if view.knows_falling:
        rows += [
            cell("@knee", shown(falling.knee, RPM)),
            cell("@fall", shown(falling.fall, PER_RPM)),
            cell("@corner", falling.corner(peak) if falling.fall else 0.0),
        ]
    return rows


def checks(view: DriveView) -> list[Quantity]:
    """Return the checks of the drive: of its limits with what would mend them, and of what is entered."""
    cell = CELLS["checks"].sharing(**view.parts)
    driven, (torque, mean, speed) = view.driven, view.reducer_checks
    called, reducer, built = driven.called, driven.reducer, driven.motor_used
    mass = built.known_mass + reducer.known_mass
    mends = CheckSentence('"; the drive "&@longer', f"; the drive {max_rate.range_results(view)[-1].value}")
    most = driven.limits.inertia_ratio
    heavier = amount("@use_inertia", view.inertia_ratio / most, "; try a motor of ", " times it")
    within = motor.within_reducer(called, "@smax", "@reducer_held")
    is_level, level_says = not driven.catalogued_falling.fall, CheckSentence(f'"{LEVEL}"', LEVEL)
    level = cell("@ok_curve", is_level, says=level_says)
    return [
        *motor.limit_checks(view.reserve, called, mends=mends),
        within.limit("@ok_reducer_peak", torque.value, torque.limit, mends),
        within.limit("@ok_reducer_mean", mean.value, reducer.mean_torque, mends),
        within.limit("@ok_reducer_speed", shown(speed.value, RPM), reducer.max_speed, mends),
        max_rate.creeping_check(view),
        motor.inertia_check(called, "@inertias", "@inertia_ratio", view.inertia_ratio, most, heavier),
        *motor.pair_checks(called, built.shaft, reducer.hub, mass, driven.limits.largest_mass),
        turns_check(view),
        *([cell.limit("@ok_brake", view.points.brake_torque, driven.brake.torque)] if view.brakes else []),
        *in_use.checks(called),
        *torques.stage_checks(driven),
        *([cell("@ok_bed", True, says=quoted(ON_BED))] if driven.has_bed else []),
        motor.below_curve(called, driven.motor.falling.fall, view.spare, mends) if view.knows_falling else level,
        *([windows_check(view)] if view.tables.machine.over.measured else ()),
        *(linkage_checks(view) if view.varies else ()),
        *(by_angle.checks(view) if driven.by_angle else ()),
    ]
