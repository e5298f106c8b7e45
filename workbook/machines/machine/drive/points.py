"""The table of a drive: at points of each interval, from the motion to the motor, a column a quantity.

Intervals are pieces of its motion, cut where a process force begins or ends and where it turns round. The points are
those of the rule of Gauss and Lobatto: both ends and seven between, each with what it counts in a mean.
"""

from typing import Any

import numpy as np

from engine.laws.points import POINTS
from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import LEAST, NOT_ZERO, SHARES, WEIGHTS, filled
from workbook.drive.motor import plane
from workbook.entries.abscissa import ANGLE
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KW, RPM, shown
from workbook.machines.machine.boundary.bends import bends_name
from workbook.machines.machine.drive import brake, by_angle, stages
from workbook.machines.machine.drive.entered import ACTS
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.drive.other_rates import LOSS1, behind, by_inertia, driven_unit, standing, tried
from workbook.machines.machine.drive.view import PEAK_UNITS, DriveView
from workbook.machines.machine.drive_entries import WINDOWS
from workbook.motion.pieces import FROM_START, arguments, sampled

PLACE: dict[str, Any] = {"scale": TURN, "format": "0.0##"}  # of angles of the cycle, in degrees


def points_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the drive at the points of each interval."""
    rows = range(1, view.rows + 1)
    sheet.table(
        "@pt", "The drive at nine points of each interval", view.rows * POINTS,
        constant("k", "point", "k", "", list(range(1, view.rows * POINTS + 1))),
        constant("iv", "interval", "", "", [k for k in rows for _ in SHARES]),
        constant("s", "share of it", "", "", list(SHARES) * view.rows),
        constant("w", "counts", "", "", list(WEIGHTS) * view.rows),
        *chain(view, "=INDEX([@iv.begin],[iv])+[s]*INDEX([@iv.len],[iv])"),
        calc("share", "share of the cycle", "", "", "=[w]*INDEX([@iv.len],[iv])/360",
             view.by_point(view.load.share, 0.0), "what it counts in a mean", scale=1.0),
        *standing(view),
        *tried(view),
        blank="[share]=0",
    )  # fmt: skip


def tops_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the drive once more where its quantities have their peaks, and these."""
    there, each = view.at_peaks, list(view.peaks)
    values = [shown(way * view.top(name, way), PEAK_UNITS[name]) for name, way in each]
    formulas = [f"={'MAX' if way > 0 else 'MIN'}([@peaks.y.same],[{name}])" for name, way in each]
    size = max(view.scales.torque, view.scales.behind, view.scales.power, view.scales.rpm if view.varies else 0.0)
    sheet.table(
        "@tops", "The drive at its peaks", len(each),
        constant("k", "peak", "k", "", list(range(1, len(each) + 1))),
        calc("iv", "interval", "", "", "=INDEX([@pt.iv],[@peaks.at.same])", (there.numbers.ravel() + 1).tolist(),
             format="0"),
        *chain(there, "=[@peaks.place.same]+0"),
        calc("top", "peak", "", "", formulas, values, "the larger of here and at the point", scale=size),
    )  # fmt: skip


def chain(view: DriveView, place: str) -> list[Quantity]:
    """Return the columns from the motion to the motor's power, at a ``place`` of an interval ``iv``."""
    load, points, size = view.load, view.points, view.scales
    (resists, without), (drives, equation) = by_angle.forces(view)
    between = stages.between(view.driven)
    motor_ratio, (inertia, motor_inertia) = f"@i1{between}*[g]" if view.varies else "@i", by_inertia(view)
    before, output = stages.output(view, behind(view), inertia)
    of, axis, unit = view.by_point, view.driven.axis, driven_unit(view)
    linked = [] if not view.varies else [
        *LINKAGES[view.driven.given.kind].ratios(view.driven, load.position, of),
        calc("al", "acceleration of the shaft", "φ̈", "rad/s²", "=[h]*[v]^2+[g]*[a]", of(load.shaft_acceleration),
             "φ'' ẏ² + φ' ÿ", scale=size.turning),
    ]  # fmt: skip
    return [
        *motion(view, place),
        *([calc("y", "position", "y", axis.base, f"={sampled(view.tables.pieces, 0)}", of(load.position),
                scale=axis.motion.size(0))] if view.varies or view.driven.by_angle else []),
        calc("dir", "direction", "", "", "=INDEX(@up,[iv])", of(load.direction), "of its interval", format="0"),
        *(by_angle.slide(view.driven, load, of) if view.slides else []),
        calc("R", "resisting force", "F_r", unit, resists, of(load.resisting), without, scale=size.force),
        *linked,
        calc("F", "force at the load", "F", unit, drives, of(load.force), equation, scale=size.force),
        *before,
        calc("S", "output torque of the reducer", "T_1", "Nm", output,
             of(load.output_torque), "F/(η_2 φ') + J_p φ̈", scale=size.behind),
        *(brake.of_points(view) if view.brakes else ()),
        result("T", "torque of the motor", "T", "Nm",
               f"=IF({brake.held(view)},0,{LOSS1.format('[S]')}+{motor_inertia}+@no_load*[dir])", of(points.torque),
               "T_1/(η_1 i_1) + J_0 i_1 φ̈ ± T_nl", scale=size.torque),
        result("n", "speed of the motor", "n", "rpm", f"={motor_ratio}*[v]*30/PI()", of(shown(points.speed, RPM)),
               "i_1 φ' ẏ", scale=size.rpm),
        result("P", "power of the motor", "P", "kW", "=[T]*([n]*PI()/30000+@copper*[T])", of(shown(points.power, KW)),
               "T ω + P_Cu (T/T_N)²", scale=size.power),
    ]  # fmt: skip


def motion(view: DriveView, place: str) -> list[Quantity]:
    """Return the columns of the motion: place, powers of u, velocity and acceleration of the load."""
    rows, load, axis = view.tables.pieces, view.load, view.driven.axis
    of = view.by_point
    numbers = np.array([one.piece for one in view.cycle.intervals])[view.numbers]
    pieces, base = view.cycle.pieces, axis.base
    local = load.x - np.array([one.begin for one in pieces])[numbers]
    sines = np.array([one.sines for one in pieces])[numbers[:, 0]]
    angles = [sines[:, k, 1, None] * local + sines[:, k, 2, None] for k in range(len(rows.marks))]
    return [
        calc("theta", "angle of its phases", "θ", "°", place, of(shown(load.x, DEGREE)), **PLACE),
        calc("q", "piece", "q", "", "=INDEX([@iv.q],[iv])", of(numbers + 1.0), format="0"),
        calc("u", "within piece", "u", "rad", f"=RADIANS([theta]-INDEX({rows.at.named('at')},[q])){NOT_ZERO}",
             of(local + LEAST), FROM_START),
        *arguments(rows, "", "[q]", [of(angle) for angle in angles]),
        calc("v", "velocity", "ẏ", f"{base}/s", f"=@omega*({sampled(rows, 1)})", of(load.velocity), "y' ω",
             scale=max(axis.max_velocity, 1e-9)),
        calc("a", "acceleration", "ÿ", f"{base}/s²", f"=@omega^2*({sampled(rows, 2)})", of(load.acceleration), "y'' ω²",
             scale=max(axis.max_acceleration, 1e-9)),
    ]  # fmt: skip


MIDDLE = POINTS // 2 + 1  # the number of the point in the middle of an interval
LENGTH = "[len]<eps"  # the condition of a spare row: an interval of no length


def cuts_table(sheet: Sheet, view: DriveView) -> None:
    """Declare where an interval can begin: at the motion's pieces, at edges of process forces, and where it turns."""
    table = f"axis{view.driven.number}_pieces"
    pieces = filled([shown(one.begin, DEGREE) for one in view.cycle.pieces], view.room, TURN)
    steps, turning, bent = range(1, view.steps), range(1, view.turn_rows + 1), range(1, len(view.bends) // 2 + 1)
    turned = filled([shown(one.at, DEGREE) for one in view.turns[: view.turns_cut]], view.turn_rows, TURN)
    edges = [*pieces, *view.edges, *(TURN * n / view.steps for n in steps), *turned, *view.bends]
    windows = [0] * view.room + [n for n in range(1, WINDOWS + 1) for _ in (1, 2)] + [-n for n in steps]
    sides = [0] * view.room + [side for _ in range(WINDOWS) for side in (1, 2)] + [0 for _ in (*steps, *turning)]
    turns = [0] * len(windows) + list(turning)
    edge = f"IF([window]=0,INDEX([{table}.begin],[k]),INDEX([@windows.b:e],[window],[side]))"
    near = view.tables.machine.near
    kept = [
        TURN if at > TURN - near or any(abs(at - one) < near for one in edges[:k]) else at for k, at in enumerate(edges)
    ]
    if view.steps > 1:
        edge = f"IF([window]<0,0-[window]*360/{view.steps},{edge})"
    edge = f"IF([turn]>0,INDEX([@turns.at],MAX([turn],1)),{edge})"
    bends = []
    if ends := view.tables.ends:
        edge = f"IF([bend]>0,INDEX([{bends_name(ends)}.at0:at1],MAX([bend],1),[side]),{edge})"
        phases = [0] * len(turns) + [*bent, *bent]
        bends = [constant("bend", "phase whose acceleration bends", "", "", phases, format="0;;")]
    sheet.table(
        "@cuts", "Where an interval can begin", len(edges),
        constant("k", "number", "k", "", list(range(1, len(edges) + 1))),
        constant("window", "process force", "", "", filled(windows, len(edges), 0),
                 "below 0: the number of an even step" if view.steps > 1 else "", format="0;;"),
        constant("side", "its begin or first (1), end or second (2)", "", "",
                 [*sides, *(1 for _ in bent), *(2 for _ in bent)], format="0;;"),
        constant("turn", "turn", "", "", filled(turns, len(edges), 0), format="0;;"), *bends,
        calc("edge", "angle of its phases", "θ", "°", f"={edge}", edges, "of a piece, a force or a turn", **PLACE),
        calc("at", "cut", "θ", "°",
             "=IF(SUMPRODUCT((([@cuts.edge]-[edge])^2<eps^2)*([@cuts.k]<[k]))+([edge]>360-eps)>0,360,[edge])", kept,
             "360: one before it is there", **PLACE),
    )  # fmt: skip


def intervals_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the intervals, in order; spare rows at the end of the cycle have no length."""
    i, cycle, rows, found = view.driven.number, view.cycle, view.rows, view.cycle.intervals
    low, high, middles = (np.array([getattr(one, name) for one in found]) for name in ("begin", "end", "middle"))
    unit = "N" if view.driven.travels else "Nm"
    steady, friction = cycle.levels
    at = f"([mid]+[axes_taken.late.{i}])"
    speed = f"INDEX([@pt.v],{POINTS}*[k]-{POINTS - MIDDLE})"
    sheet.table(
        "@iv", "Intervals of the cycle", rows,
        constant("k", "interval", "k", "", list(range(1, rows + 1))),
        calc("begin", "begins at", "θ", "°", "=SMALL([@cuts.at],[k])", filled(shown(low, DEGREE), rows, TURN), **PLACE),
        calc("end", "ends at", "θ", "°", "=SMALL([@cuts.at],[k]+1)", filled(shown(high, DEGREE), rows, TURN), **PLACE),
        calc("len", "length", "", "°", "=[end]-[begin]", filled(shown(high - low, DEGREE), rows), **PLACE),
        calc("mid", "in its middle", "θ", "°", f"=IF({LENGTH},[mid-1],([begin]+[end])/2)",
             view.by_interval(shown(middles, DEGREE)), "spare rows: as above", **PLACE),
        calc("at", "of the master shaft", "", "°", f"={at}-360*INT({at}/360)",
             view.by_interval((shown(middles, DEGREE) + view.driven.axis.given.shift) % TURN), "with the axis' shift",
             **PLACE),
        calc("q", "piece of the motion", "q", "", f"=MATCH([mid],[axis{i}_pieces.begin],1)",
             filled([one.piece + 1 for one in found], rows, found[-1].piece + 1), format="0"),
        calc("dir", "direction", "", "", f"=IF({LENGTH},[dir-1],IF(ABS({speed})<=@still,0,SIGN({speed})))",
             view.by_interval(cycle.direction), "1, −1; 0 at rest", format="0"),
        *(brake.of_intervals(view, LENGTH) if view.brakes else ()),
        calc("steady", "resists always", "", unit, f"=@steady+SUMPRODUCT({ACTS}*[@windows.always])",
             view.by_interval(steady), "with process forces", scale=view.scales.force),
        calc("friction", "against motion", "", unit, f"=@rub+SUMPRODUCT({ACTS}*[@windows.moving])",
             view.by_interval(friction), scale=view.scales.force),
        blank=LENGTH,
    )  # fmt: skip


ABOUT = "Between two points the torque is that of a straight line, right to about 1 %; at the points it is as above."


def samples_table(sheet: Sheet, view: DriveView) -> None:
    """Declare torque and power of the motor at the samples of the cycle."""
    i, size, (torque, power) = view.driven.number, view.scales, view.sampled
    at = f"[cycle{i}.p.same]"
    speed = "[n]*PI()/30000" if view.varies else f"@i*@faster*[cycle{i}.v.same]/1000"
    here, there = "INDEX(@at,[at])", "INDEX(@at,[at]+1)"
    sheet.heading("Table over the cycle", ABOUT)
    sheet.table(
        "@cycle", "The drive over the cycle", len(torque),
        result("torque", "torque of the motor", "T", "Nm", line("T"), torque, scale=size.torque),
        result("power", "power of the motor", "P", "kW", f"=[torque]*({speed}+@copper*[torque])", shown(power, KW),
               "T ω + P_Cu (T/T_N)²", scale=size.power),
        *([] if view.driven.linkage is None else [
            calc("phi", "angle of the shaft", "φ", "rad", line("phi"),
                 view.between.of(view.driven.linkage.shaft(view.load.position).angle), scale=1.0),
            calc("n", "speed of the motor", "n", "rpm", line("n"), shown(view.between.of(view.points.speed), RPM),
                 scale=size.rpm),
        ]),
        constant("k", "sample", "k", "", list(range(len(torque)))),
        calc("at", "point before it", "", "", f"=MATCH(MIN({at}+eps,360-eps),@at,1)",
             view.between.point + 1.0, format="0"),
        calc("s", "share of the way to the next", "", "", f"=({at}-{here})/({there}-{here})", view.between.share,
             scale=1.0),
    )  # fmt: skip


def line(column: str) -> str:
    """Return the formula of a quantity between two points."""
    return f"=INDEX(@{column},[at])*(1-[s])+INDEX(@{column},[at]+1)*[s]"


CHART_COLUMN = 10
THETA = "angle of its phases θ [°]"


def charts(sheet: Sheet, view: DriveView) -> None:
    """Place the charts: torque against speed, torque over the cycle, and the angle of a shaft whose ratio changes."""
    peaks = [Series("peaks", f"[@tops.{x}]", "[@tops.T]", points=True, marker="circle") for x in ("n", "theta")]
    sheet.chart(plane("[@pt.n]", "[@pt.T]", peaks[0]), column=CHART_COLUMN, row=5, width=8, height=22)
    over, places = view.tables.machine.over, {"column": CHART_COLUMN, "width": 8, "height": 11}
    lines = Series("torque", "[@pt.theta]", "[@pt.T]"), peaks[1]
    about = "Torque of the motor at its points over a cycle, by the angle of its phases"
    torque = Chart("Torque of the motor over the cycle", THETA, "T [Nm]", lines, about, ANGLE.axis(60))
    sheet.chart(torque, row=28, **places)
    if view.varies:
        line = Series("angle", f"[cycle{view.driven.number}.{over.column}]", "[@cycle.phi]")
        title = "Angle of the mechanism's shaft"
        turned = Chart(title, over.title, "φ [rad]", (line,), f"{title} over {over.cycle}", over.axis(60))
        sheet.chart(turned, row=40, **places)
