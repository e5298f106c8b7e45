"""The Drive sheet: motor and reducer on the tool's shaft, and a table of both at points of the cycle (S5, step 7)."""

import numpy as np

from engine.drive.drive_points import USUAL
from engine.laws.points import POINTS
from workbook.book.cell_tables import cell_tables, charts_beside
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.rows import SHARES, WEIGHTS, filled
from workbook.drive import motor
from workbook.fields.units import PER_RPM, RPM, shown
from workbook.machines.flying.view import LOOKS, ToolDrive
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import at_sample, place_columns

CELLS = cell_tables(__file__)
CHARTS = charts_beside(__file__)

BELOW_CHARTS = 45
UNLISTED = "a name is not in the catalogue; expected one of its names, or an empty cell"
PEAK = "at a point: exact; of a law of your own to 4 %"
MOVING = "SUMPRODUCT([@pt.share],([@pt.v]^2)^0.5)"

LEAST = "=fly_v+fly_h1/1000/fly_tm*[standing.v.1]"
ABOUT_POINTS = "Nine points, ends included, of each piece of the tool's motion, cut where the tool turns round."


def drive_sheet(book: Book, view: ToolDrive, rows: PieceRows) -> None:
    """Declare the sheet."""
    cell = CELLS["drive_sheet"]
    sheet = book.sheet("Drive", "Motor and reducer on the tool's shaft: what a cycle asks of them.")
    with sheet.scoped("drive_"):
        s, proposed = view.chosen, "empty: that which the sheet Selection proposes"
        sheet.heading("Enter")
        sheet.rows(cell("@motor_name", s.motor, source=proposed), cell("@reducer_name", s.reducer, source=proposed))
        outcome(sheet, view)
        sheet.checks(*checks(view))
        sheet.chart(motor.plane("[@pt.n]", "[@pt.T]"), column=11, row=5, width=6, height=22)
        sheet.chart(CHARTS["Torque of the motor over a cycle"], column=11, row=28, width=6, height=16)
        sheet.row = max(sheet.row, BELOW_CHARTS)
        sheet.not_printed_below()
        in_use(sheet, view)
        sheet.heading("Workings: the motor's limits in the chart")
        corners = view.motor.corners(min(0.0, float(view.load.direction.min())))
        motor.limits_table(sheet, corners, "MIN([@pt.dir])<0", falls=True)
        motor.rms_point(sheet, view.points.mean_speed, view.points.rms_torque)
        turns(sheet, view, rows)
        sheet.heading("Workings: the cycle at points", ABOUT_POINTS)
        intervals(sheet, view)
        points(sheet, view, rows)
    book.name("tool_joints", tool_v0="v0")
    book.name("drive_pt", tool_dir="dir", tool_al="al", tool_S="S", tool_n="w")
    sheet.print_columns = 16


def outcome(sheet: Sheet, view: ToolDrive) -> None:
    """Declare what the cycle asks of motor and reducer."""
    cell = CELLS["outcome"]
    (m, r), points, held = view.pair, view.points, view.reserve
    size = view.motor_torque
    sheet.heading("Results")
    sheet.rows(
        cell("@motor", view.proposal.motors.names[m]),
        cell("@reducer", view.proposal.reducers.names[r]),
        cell("@tmax", float(points.torque.max()), scale=size, source=PEAK),
        cell("@tmin", float(points.torque.min()), scale=size, source=PEAK),
        cell("@rms", points.rms_torque, part=100.0 * USUAL.rms_torque, scale=size),
        cell("@margin", held.rms_torque.reserve * view.reserves.rms_reserve),
        cell("@speed", shown(view.speed, RPM)),
        cell("@mean", shown(points.mean_speed, RPM)),
        motor.continuous(view.motor, points.mean_speed),
        cell("@spare", float(view.left.min()), scale=max(size, view.motor.peak_torque)),
        cell("@inertias", view.inertia_ratio),
        cell("@smax", view.demand.torque, scale=view.torque),
        cell("@smean", view.demand.mean_torque, scale=view.torque),
        cell("@balance", view.balance),
    )


def checks(view: ToolDrive) -> list[Quantity]:
    """Return the checks of the motor's and the reducer's limits."""
    cell, (shaft, motor_mass, hub, reducer_mass) = CELLS["checks"], view.proposal.built(*view.pair).values()
    (fastest, strongest, lasting), demand = view.limits, view.demand
    within = motor.within_reducer("Drive", "sel_tmax", "@reducer_peak")
    return [
        cell("@ok_told", True, unlisted=UNLISTED),
        *motor.limit_checks(view.reserve, "Drive"),
        motor.inertia_check(
            "Drive", "@inertias", "limits_inertia_ratio", view.inertia_ratio, view.reserves.inertia_ratio
        ),
        *motor.pair_checks(
            "Drive", shaft, hub, motor_mass + reducer_mass, view.reserves.largest_mass, "limits_largest_mass"
        ),
        motor.below_curve("Drive", view.motor.falling.fall, float(view.left.min())),
        within.limit("@ok_reducer_speed", shown(view.speed, RPM), shown(fastest, RPM)),
        within.limit("@ok_reducer_peak", view.reserves.torque_factor * demand.torque, strongest),
        within.limit("@ok_reducer_mean", demand.mean_torque, lasting),
    ]


def in_use(sheet: Sheet, view: ToolDrive) -> None:
    """Declare the figures of the motor and the reducer in use."""
    cell, (m, r), own = CELLS["in_use"], view.pair, view.motor
    inertia, ratio, efficiency, no_load = view.gears
    fastest, strongest, lasting = view.limits

    def row(kind: str, column: str, place: int) -> Quantity:
        listed = f"SUMPRODUCT(([{kind}s.name]=@{kind}_name)*[sel_{kind}s.k])"
        return CELLS["row"]("@{kind}_row", place, kind=kind, product=kind.capitalize(), column=column, listed=listed)

    sheet.heading("Motor and reducer in use")
    sheet.rows(
        cell("@place", (view.proposal.proposed or 0) + 1),
        row("motor", "m", m + 1),
        row("reducer", "r", r + 1),
        cell("@jm", own.inertia),
        cell("@jt", float(view.proposal.reducers.inertia[r])),
        cell("@j", inertia),
        cell("@i", ratio),
        cell("@eta", efficiency),
        cell("@no_load", no_load),
        cell("@motor_rated", own.rated_torque),
        cell("@motor_stall", own.stall_torque),
        cell("@motor_nn", shown(own.rated_speed, RPM)),
        cell("@motor_peak", own.peak_torque),
        cell("@motor_nmax", shown(own.max_speed, RPM)),
        cell("@knee", shown(own.falling.knee, RPM)),
        cell("@fall", shown(own.falling.fall, PER_RPM)),
        cell("@reducer_nmax", shown(fastest, RPM)),
        cell("@reducer_peak", strongest),
        cell("@reducer_mean", lasting),
        *(cell(name, figure) for name, figure in view.proposal.built(m, r).items()),
        cell("@still", view.cycle.still, scale=view.cycle.still),
    )


def turns(sheet: Sheet, view: ToolDrive, rows: PieceRows) -> None:
    """Declare where the tool turns round: the speed where the law is fastest, and looks at that beside each turn."""
    cell = CELLS["turns"]
    cycle, cut = view.cycle, view.machine.cut
    looks = [(*stretch[:2], *look) for stretch in cycle.stretches for look in view.looks(stretch)]
    after, number, middle, u, *rates, at = (list(values) for values in zip(*looks, strict=True))
    pieces, begin = [rows.pieces[k] for k in number], "INDEX(tool_at,[q])"
    before, least = "(tool_at<@slowest)", "v_L + h v(ξ_v)/t_m: of a long product its lowest"
    forward = f"SUMPRODUCT((tool_v0>@still)*{before})"
    backward = f"SUMPRODUCT(((tool_v0<0-@still)+{before}>0)*([tool_pieces.r]<=fly_pieces))"
    to = f"MIN({begin}+INDEX([tool_pieces.d],[q]),IF([after]<0,@slowest,fly_tc))"
    origin, place = "INDEX(tool_origin,[q])", "=IF([look]=1,[middle],[at-1])"
    nearer = f"{origin}+[u]-2*[v]/([a]+[after]*SQRT(MAX(0,[a]^2-2*[j]*[v])))"
    cell.begin(sheet)
    sheet.rows(
        cell("@slowest", cycle.slowest),
        cell("@least", cut.slowest_speed, formula=LEAST, source=least),
        cell("@turned", cycle.turns),
    )
    sheet.row += 1
    cell.place(
        sheet,
        cell("after", after),
        cell("look", [*range(1, LOOKS + 1)] * 2),
        cell("q", [k + 1 for k in number], forward=forward, backward=backward),
        cell("middle", middle, begin=begin, to=to),
        *place_columns(rows, "", "looked at", f"{place}-{origin}", np.array(u), pieces, "[q]"),
        *(
            cell(name, rates[n - 1], unit=rows.at.unit(n), there=at_sample(rows, n), scale=cut.size(n))
            for n, name in enumerate("vaj", 1)
        ),
        cell("at", at, nearer=nearer),
        blank="@turned=0",
    )


def intervals(sheet: Sheet, view: ToolDrive) -> None:
    """Declare the pieces of the tool's motion as intervals, cut at turns; spare rows at the end have no length."""
    cell = CELLS["iv"]
    cycle, room, time = view.cycle, view.machine.room, view.machine.cut.cycle_time
    cuts, used = cycle.intervals, "fly_pieces+@turned"
    middle = f"INDEX([@pt.v],{POINTS}*[k]-{POINTS // 2})"
    begins, ends, piece = zip(*cuts, strict=True)
    turned = [k - number for k, number in enumerate(piece)]
    passed = f"IF([k]>[@turns.q.{LOOKS}],1,0)+IF([k]>[@turns.q.last]+1,1,0)"
    begin = f"MAX(INDEX([tool_pieces.begin],[q]),IF([n]=0,0,INDEX([@turns.at],{LOOKS}*[n])))"
    way = filled(cycle.direction, room, float(cycle.direction[-1]))
    cell.place(
        sheet,
        cell("n", filled(turned, room, cycle.turns), passed=passed),
        cell("q", filled([number + 1 for number in piece], room, piece[-1] + 1)),
        cell("begin", filled(begins, room, time), used=used, begin=begin),
        cell("end", filled(ends, room, time), used=used),
        cell("dir", way, used=used, middle=middle),
        blank=f"[k]>{used}",
    )


def points(sheet: Sheet, view: ToolDrive, rows: PieceRows) -> None:
    """Declare tool, shaft and motor at the points of each interval."""
    cell = CELLS["pt"]
    load, drive, of, room = view.load, view.points, view.by_point, view.machine.room
    numbers = list(range(room))
    cut_numbers = [cut.piece for cut in view.cycle.intervals for _ in SHARES]
    pieces = filled([rows.pieces[k] for k in cut_numbers], room * POINTS, rows.pieces[-1])
    u = np.array(of(load.x)) - np.array([piece.origin for piece in pieces])
    cell.place(
        sheet,
        cell("iv", [k + 1 for k in numbers for _ in SHARES]),
        cell("s", list(SHARES) * room),
        cell("g", list(WEIGHTS) * room),
        cell("t", of(load.x)),
        cell("q", filled([k + 1 for k in cut_numbers], room * POINTS, len(rows.pieces))),
        *place_columns(rows, "", "within piece", "=[t]-INDEX([tool_pieces.origin],[q])", u, pieces, "[q]"),
        cell("y", of(load.position), sampled=at_sample(rows, 0)),
        cell("v", of(load.velocity), sampled=at_sample(rows, 1)),
        cell("a", of(load.acceleration), sampled=at_sample(rows, 2)),
        cell("dir", of(load.direction)),
        cell("w", of(load.speed)),
        cell("al", of(load.shaft_acceleration), scale=view.turning),
        cell("S", of(load.output_torque), scale=view.torque),
        cell("n", of(shown(drive.speed, RPM)), scale=shown(view.speed, RPM)),
        cell("T", of(drive.torque), scale=view.motor_torque),
        cell("share", of(load.share, 0.0), scale=1.0),
        cell("left", of(view.left), scale=max(view.motor_torque, view.motor.peak_torque)),
        blank="[share]=0",
    )
