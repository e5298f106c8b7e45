"""The table of a drive: at points of each interval, from the motion to the motor, a column a quantity.

Intervals are pieces of its motion, cut where a process force begins or ends and where it turns round. The points are
those of the rule of Gauss and Lobatto: both ends and seven between, each with what it counts in a mean.
"""

from itertools import product
from typing import Any

import numpy as np

from engine.laws.points import POINTS
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import COLOURS, Chart, Series
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import LEAST, NOT_ZERO, SHARES, WEIGHTS, filled
from workbook.drive.motor import PEAK, RMS_POINT, plane
from workbook.entries.abscissa import ANGLE
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, RPM, shown
from workbook.machines.machine.boundary.curves import bends_name
from workbook.machines.machine.drive import by_angle, torques
from workbook.machines.machine.drive.entered import ACTS
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.drive.peaks import PEAK_UNITS
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive_entries import WINDOWS
from workbook.motion.pieces import FROM_START, arguments, at_sample

CELLS = cell_tables(__file__)

PLACE: dict[str, Any] = {"scale": TURN, "format": "0.0##"}  # of angles of the cycle, in degrees


def points_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the drive at the points of each interval."""
    cell = CELLS["pt"]
    rows = range(1, view.rows + 1)
    cell.place(
        sheet,
        cell("iv", [k for k in rows for _ in SHARES]),
        cell("s", list(SHARES) * view.rows),
        cell("w", list(WEIGHTS) * view.rows),
        *chain(view, "=INDEX([@iv.begin],[iv])+[s]*INDEX([@iv.len],[iv])"),
        cell("share", view.by_point(view.load.share, 0.0), scale=1.0),
        *torques.standing(view),
        *torques.at_another_rate(view, torques.TRIED),
        *torques.at_another_rate(view, torques.CREEPING),
        blank="[share]=0",
    )


def tops_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the drive once more where its quantities have their peaks, and these."""
    cell, peaks = CELLS["tops"], view.peaks
    there, first = view.at_peaks, peaks.rows
    values = [shown(way * top, PEAK_UNITS[name]) for (name, way, _), top in peaks.tops.items()]
    at, formulas, places = list[str](), list[str](), list[str]()
    for key in peaks.places:
        name, way, _ = key
        row = f"{first[name, way, 1]}" if key in peaks.again else "same"
        before, place = "[@peaks.y.same]", "peaks.place.same"
        if key in peaks.again:
            before, place = f"[@tops.top.{row}]", f"again.place.{list(peaks.again).index(key) + 1}"
        at.append(f"[@peaks.at.{row}]")
        formulas.append(f"={'MAX' if way > 0 else 'MIN'}({before},[{name}])")
        places.append(f"=[@{place}]+0")
    scales = view.scales
    size = max(scales.torque, scales.behind, scales.power, scales.rpm if view.varies else 0.0)
    cell.place(
        sheet,
        cell("iv", (there.numbers.ravel() + 1).tolist(), at=at),
        *chain(there, places),
        cell("top", values, formula=formulas, scale=size),
    )


def chain(view: DriveView, place: str | list[str]) -> list[Quantity]:
    """Return the columns from the motion to the motor's power, at a ``place`` of an interval ``iv``."""
    cell = CELLS["chain"].sharing(**view.parts)
    load, points = view.load, view.points
    (resists, without), (drives, equation) = by_angle.forces(view)
    between = torques.between(view.driven)
    motor_ratio = f"@i1{between}*[g]" if view.varies else "@i"
    (inertia, motor_inertia) = torques.by_inertia(view)
    before, output = torques.output(view, load.shaft_torques, torques.behind(view), inertia)
    of, axis, unit = view.by_point, view.driven.axis, torques.driven_unit(view)
    linked, position = list[Quantity](), list[Quantity]()
    if view.varies:
        linked = LINKAGES[view.driven.given.kind].ratios(view.driven, load.position, of)
        linked.append(cell("al", of(load.shaft_acceleration)))
    if view.varies or view.driven.by_angle:
        at, size = at_sample(view.tables.pieces, 0), axis.motion.size(0)
        position = [cell("y", of(load.position), unit=axis.base, sampled=at, scale=size)]
    return [
        *motion(view, place),
        *position,
        cell("dir", of(load.direction)),
        *(by_angle.slide(view.driven, load, of) if view.slides else []),
        cell("R", of(load.resisting), unit=unit, formula=resists, source=without),
        *linked,
        cell("F", of(load.force), unit=unit, formula=drives, source=equation),
        *before,
        cell("S", of(load.output_torque), output=output),
        *(torques.braked_columns(view) if view.brakes else ()),
        cell("T", of(points.torque), held=torques.brake_holds(view), own_inertia=motor_inertia),
        cell("n", of(shown(points.speed, RPM)), ratio=motor_ratio),
        cell("P", of(shown(points.power, KW))),
    ]


def motion(view: DriveView, place: str | list[str]) -> list[Quantity]:
    """Return the columns of the motion: place, powers of u, velocity and acceleration of the load."""
    rows, load, axis = view.tables.pieces, view.load, view.driven.axis
    of = view.by_point
    numbers = np.array([interval.piece for interval in view.cycle.intervals])[view.numbers]
    pieces, base = view.cycle.pieces, axis.base
    local = load.x - np.array([piece.begin for piece in pieces])[numbers]
    sines = np.array([piece.sines for piece in pieces])[numbers[:, 0]]
    angles = [sines[:, k, 1, None] * local + sines[:, k, 2, None] for k in range(len(rows.marks))]
    cell = CELLS["motion"].sharing(base=base, not_zero=NOT_ZERO)
    fastest, hardest = max(axis.max_velocity, 1e-9), max(axis.max_acceleration, 1e-9)
    return [
        cell("theta", of(shown(load.x, DEGREE)), formula=place, **PLACE),
        cell("q", of(numbers + 1.0)),
        cell("u", of(local + LEAST), begins=rows.at.named("at"), source=FROM_START),
        *arguments(rows, "", "[q]", [of(angle) for angle in angles]),
        cell("v", of(load.velocity), sampled=at_sample(rows, 1), scale=fastest),
        cell("a", of(load.acceleration), sampled=at_sample(rows, 2), scale=hardest),
    ]


MIDDLE = POINTS // 2 + 1  # the number of the point in the middle of an interval
LENGTH = "[len]<eps"  # the condition of a spare row: an interval of no length


def cuts_table(sheet: Sheet, view: DriveView) -> None:
    """Declare where an interval can begin: at the motion's pieces, at edges of process forces, and where it turns."""
    cell, near, steps = CELLS["cuts"], view.tables.machine.near, range(1, view.steps)
    pieces = filled([shown(piece.begin, DEGREE) for piece in view.cycle.pieces], view.room, TURN)
    turned = filled([shown(turn.at, DEGREE) for turn in view.turns[: view.turns_cut]], view.turn_rows, TURN)
    ends_of_windows = product(range(1, WINDOWS + 1), (1, 2))
    bends = product((1, 2), range(1, len(view.bends) // 2 + 1))
    rows = [(0, 0, 0, 0, at) for at in pieces]
    rows += [(n, side, 0, 0, at) for (n, side), at in zip(ends_of_windows, view.edges, strict=True)]
    rows += [(-n, 0, 0, 0, TURN * n / view.steps) for n in steps]
    rows += [(0, 0, n, 0, at) for n, at in enumerate(turned, 1)]
    rows += [(0, side, 0, n, at) for (side, n), at in zip(bends, view.bends, strict=True)]
    windows, sides, turns, phases, edges = map(list, zip(*rows, strict=True))
    edge = f"IF([window]=0,INDEX([axis{view.driven.number}_pieces.begin],[k]),INDEX([@windows.b:e],[window],[side]))"
    kept = [
        TURN if at > TURN - near or any(abs(at - edge) < near for edge in edges[:k]) else at
        for k, at in enumerate(edges)
    ]
    if steps:
        edge = f"IF([window]<0,0-[window]*360/{view.steps},{edge})"
    edge = f"IF([turn]>0,INDEX([@turns.at],MAX([turn],1)),{edge})"
    if ends := view.tables.ends:
        edge = f"IF([bend]>0,INDEX([{bends_name(ends)}.at0:at1],MAX([bend],1),[side]),{edge})"
    cell.place(
        sheet,
        cell("window", windows, source="below 0: the number of an even step" if steps else ""),
        cell("side", sides),
        cell("turn", turns),
        *([cell("bend", phases)] if ends else []),
        cell("edge", edges, edge=edge, **PLACE),
        cell("at", kept, **PLACE),
    )


def intervals_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the intervals, in order; spare rows at the end of the cycle have no length."""
    cell = CELLS["iv"].sharing(**view.parts)
    i, cycle, rows, found = view.driven.number, view.cycle, view.rows, view.cycle.intervals
    low, high, middles = (
        np.array([getattr(interval, name) for interval in found]) for name in ("begin", "end", "middle")
    )
    unit, middle = "N" if view.driven.travels else "Nm", shown(middles, DEGREE)
    steady, friction = cycle.levels
    at = f"([mid]+[axes_taken.late.{i}])"
    speed = f"INDEX([@pt.v],{POINTS}*[k]-{POINTS - MIDDLE})"
    cell.place(
        sheet,
        cell("begin", filled(shown(low, DEGREE), rows, TURN), **PLACE),
        cell("end", filled(shown(high, DEGREE), rows, TURN), **PLACE),
        cell("len", filled(shown(high - low, DEGREE), rows), **PLACE),
        cell("mid", view.by_interval(middle), length=LENGTH, **PLACE),
        cell("at", view.by_interval((middle + view.driven.axis.given.shift) % TURN), at=at, **PLACE),
        cell("q", filled([interval.piece + 1 for interval in found], rows, found[-1].piece + 1)),
        cell("dir", view.by_interval(cycle.direction), length=LENGTH, speed=speed),
        *(torques.dwell_columns(view, LENGTH) if view.brakes else ()),
        cell("steady", view.by_interval(steady), unit=unit, acts=ACTS),
        cell("friction", view.by_interval(friction), unit=unit, acts=ACTS),
        blank=LENGTH,
    )


def samples_table(sheet: Sheet, view: DriveView) -> None:
    """Declare torque and power of the motor at the samples of the cycle."""
    cell = CELLS["cycle"].sharing(**view.parts)
    i, (torque, power) = view.driven.number, view.sampled
    at = f"[cycle{i}.p.same]"
    speed = "[n]*PI()/30000" if view.varies else f"@spin*[cycle{i}.v.same]"
    shaft = list[Quantity]()
    if linkage := view.driven.linkage:
        angle = linkage.shaft(view.load.position).angle
        speeds = shown(view.between.of(view.points.speed), RPM)
        shaft = [
            cell("phi", view.between.of(angle), formula=line("phi"), scale=1.0),
            cell("n", speeds, formula=line("n")),
        ]
    cell.begin(sheet)
    cell.place(
        sheet,
        cell("torque", torque, formula=line("T")),
        cell("power", shown(power, KW), speed=speed),
        *shaft,
        cell("k", list(range(len(torque)))),
        cell("at", view.between.point + 1.0, at=at),
        cell("s", view.between.share, at=at, scale=1.0),
    )


def line(column: str) -> str:
    """Return the formula of a quantity between two points."""
    return f"=INDEX(@{column},[at])*(1-[s])+INDEX(@{column},[at]+1)*[s]"


THETA = "angle of its phases θ [°]"
BY_SPEED = "Torque against speed: limits red, continuous grey, RMS dot"
OVER_CYCLE = "Torque over the cycle: limits red, RMS dashed"


def limit_lines(sheet: Sheet, view: DriveView) -> None:
    """Declare the lines of the motor's peak torque and of the RMS torque over the cycle, as the chart draws them."""
    cell, peak, rms = CELLS["lines"], view.driven.motor.peak_torque, view.points.rms_torque
    cell.place(
        sheet,
        cell("at", [0.0, TURN]),
        cell("up", [peak, peak]),
        cell("down", [-peak, -peak]),
        cell("rms", [rms, rms], scale=view.scales.torque),
    )


def charts(view: DriveView) -> tuple[Chart, Chart]:
    """Return the charts of torque against speed and of torque over the cycle, in the colour of the axis."""
    ink = COLOURS[(view.driven.number - 1) % len(COLOURS)]
    speeds, places = (
        Series("peaks", f"[@tops.{x}]", "[@tops.T]", points=True, marker="circle", color=ink) for x in ("n", "theta")
    )
    lines = (
        Series("torque", "[@pt.theta]", "[@pt.T]", color=ink),
        places,
        Series("largest torque", "[@lines.at]", "[@lines.up]", dashed=True, color=PEAK),
        Series("likewise", "[@lines.at]", "[@lines.down]", dashed=True, color=PEAK),
        Series("RMS torque", "[@lines.at]", "[@lines.rms]", dashed=True, color=RMS_POINT),
    )
    about = "Torque of the motor at its points over a cycle, by the angle of its phases, its limit and its RMS value"
    over = Chart(OVER_CYCLE, THETA, "T [Nm]", lines, about, ANGLE.axis(60), legend=False)
    return plane("[@pt.n]", "[@pt.T]", speeds, ink=ink, title=BY_SPEED), over


def angle_chart(view: DriveView) -> Chart:
    """Return the chart of the angle of a shaft whose ratio changes."""
    over, title = view.tables.machine.over, "Angle of the mechanism's shaft"
    line = Series("angle", f"[cycle{view.driven.number}.{over.column}]", "[@cycle.phi]")
    return Chart(title, over.title, "φ [rad]", (line,), f"{title} over {over.cycle}", over.axis(60))
