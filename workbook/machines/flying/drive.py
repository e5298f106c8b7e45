"""The Drive sheet: motor and reducer on the tool's shaft, and one table of both at points of the cycle (S5, step 7)."""

import numpy as np

from engine.drive.bounds import CONSTANT
from engine.laws.points import POINTS
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import SHARES, WEIGHTS, filled
from workbook.drive.motor import (
    below_curve,
    continuous,
    inertia_check,
    limit_checks,
    limits_table,
    plane,
    rms_point,
    within_reducer,
)
from workbook.fields.units import PER_RPM, RPM, shown
from workbook.machines.flying.view import LOOKS, ToolDrive
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import place_columns, sampled

BELOW_CHARTS = 45
UNLISTED = "a name is not in the catalogue; expected one of its names, or an empty cell"
OVER = {"motor.rated": "rms_reserve", "motor.stall": "rms_reserve", "motor.peak": "peak_reserve",
        "motor.fall": "peak_reserve", "motor.nmax": "speed_reserve"}  # fmt: skip
"""of each limit of the motor in use, the reserve that it is over"""
PEAK = "at a point: exact; of a law of your own to 4 %"
MOVING = "SUMPRODUCT([@pt.share],([@pt.v]^2)^0.5)"
CUBIC = f"=IF({MOVING}>0,(SUMPRODUCT([@pt.share],([@pt.v]^2)^0.5,([@pt.S]^2)^1.5)/{MOVING})^(1/3),0)"

ABOUT_TURNS = (
    "Friction and losses change sides there. The speed falls until the law is fastest, then rises. First look at "
    "the middle of the last piece that begins before a turn, the next where the parabola by v, a and j is 0."
)
TITLE = "Where the tool turns round: four looks at each turn, each nearer"
LEAST = "=fly_v+fly_h1/1000/fly_tm*[standing.v.1]"
ABOUT_POINTS = "Nine points, ends included, of each piece of the tool's motion, cut where the tool turns round."


def drive_sheet(book: Book, view: ToolDrive, rows: PieceRows) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Drive", "Motor and reducer on the tool's shaft: what a cycle asks of them.")
    with sheet.scoped("drive_"):
        s, proposed = view.chosen, "empty: that which the sheet Selection proposes"
        sheet.heading("Enter")
        sheet.rows(
            given("@motor_name", "Motor of the catalogue", "", "", s.motor, "selection.motor", choices="=motor_name",
                  align="left", source=proposed),
            given("@reducer_name", "Reducer of the catalogue", "", "", s.reducer, "selection.reducer",
                  choices="=reducer_name", align="left", source=proposed),
        )  # fmt: skip
        outcome(sheet, view)
        sheet.checks(*checks(view))
        sheet.chart(plane("[@pt.n]", "[@pt.T]"), column=10, row=5, width=8, height=22)
        torque = Series("torque", "[@pt.t]", "[@pt.T]")
        over = Chart(
            "Torque of the motor over a cycle", "time t [s]", "T [Nm]", (torque,), "Torque of the motor over one cycle"
        )
        sheet.chart(over, column=10, row=28, width=8, height=16)
        sheet.row = max(sheet.row, BELOW_CHARTS)
        in_use(sheet, view)
        sheet.not_printed_below()
        sheet.heading("Workings: the motor's limits in the chart")
        corners = view.motor.corners(min(0.0, float(view.load.direction.min())))
        limits_table(sheet, corners, "MIN([@pt.dir])<0", falls=True)
        rms_point(sheet, view.points.mean_speed, view.points.rms_torque)
        turns(sheet, view, rows)
        sheet.heading("Workings: the cycle at points", ABOUT_POINTS)
        intervals(sheet, view)
        points(sheet, view, rows)
    book.name("tool_joints", tool_v0="v0")
    book.name("drive_pt", tool_dir="dir", tool_al="al", tool_S="S", tool_n="w")
    sheet.print_columns = 18


def outcome(sheet: Sheet, view: ToolDrive) -> None:
    """Declare what the cycle asks of motor and reducer."""
    (m, r), points, held = view.pair, view.points, view.reserve
    size = view.motor_torque
    sheet.heading("Results")
    sheet.rows(
        result("@motor", "Motor", "", "", '=INDEX([motors.name],MAX(1,@motor_row))&""', view.proposal.motors.names[m],
               align="left"),
        result("@reducer", "Reducer", "", "", '=INDEX([reducers.name],MAX(1,@reducer_row))&""',
               view.proposal.reducers.names[r], align="left"),
        result("@tmax", "Motor torque, highest", "T_max", "Nm", "=MAX([@pt.T])", float(points.torque.max()),
               PEAK, scale=size),
        result("@tmin", "Motor torque, lowest", "T_min", "Nm", "=MIN([@pt.T])", float(points.torque.min()), PEAK,
               scale=size),
        result("@rms", "RMS torque of the motor", "T_rms", "Nm", "=SQRT(SUMPRODUCT([@pt.share],[@pt.T],[@pt.T]))",
               points.rms_torque, f"√(Σ share T²), to {100.0 * CONSTANT.rms_torque:g} % of the peak", scale=size),
        result("@margin", "Margin", "", "", "=IF(@rms>0,@continuous*limits_rms_reserve/@rms,0)",
               held.rms_torque.reserve * view.kept.rms_reserve,
               "continuous torque / T_rms"),
        result("@speed", "Motor speed, largest", "n", "rpm", "=fly_n*@i", shown(view.speed, RPM)),
        result("@mean", "Motor speed, mean", "n_mean", "rpm", "=SUMPRODUCT([@pt.share],([@pt.n]^2)^0.5)",
               shown(points.mean_speed, RPM), "of |n| over the cycle"),
        continuous(view.motor, points.mean_speed),
        result("@spare", "Least reserve below the motor's curve", "", "Nm", "=MIN([@pt.left])",
               float(view.left.min()), "at the points", scale=max(size, view.motor.peak_torque)),
        result("@smax", "Output torque of the reducer, peak", "", "Nm", "=MAX(MAX([@pt.S]),0-MIN([@pt.S]))",
               view.demand.torque, scale=view.torque),
        result("@smean", "Output torque of the reducer, mean", "", "Nm", CUBIC, view.demand.mean_torque,
               "³√(∫|v||S|³ dt/∫|v| dt)", scale=view.torque),
        result("@balance", "Ratio over the best ratio", "τ/τ_opt", "",
               "=IF(sel_moves=1,1/@i/SQRT(@j*sel_wrms*@eta/sel_trms),0)", view.balance,
               "1: motor and load balanced, with the reducer's η and inertia"),
    )  # fmt: skip


def checks(view: ToolDrive) -> list[Quantity]:
    """Return the checks of the motor's and the reducer's limits."""
    fastest, strongest, lasting = view.limits
    speed, mean, torque = view.speed, view.demand.mean_torque, view.kept.torque_factor * view.demand.torque
    return [
        check("@ok_told", "Drive: motor and reducer are in the catalogue", "@motor_row*@reducer_row>0", True,
              says=f'"{UNLISTED}"'),
        *limit_checks(view.reserve, "Drive"),
        inertia_check("Drive", "sel_own_inertias", "limits_inertia_ratio", view.inertia_ratio, view.kept.inertia_ratio),
        below_curve("Drive", view.motor.falling.fall, float(view.left.min())),
        *within_reducer(
            "Drive", ("speed", "@speed", "@reducer_nmax", not fastest or speed <= fastest, shown(speed, RPM),
                      shown(fastest, RPM)),
            ("torque", "sel_tmax", "@reducer_peak", not strongest or torque <= strongest, torque, strongest),
            ("mean torque", "@smean", "@reducer_mean", not lasting or mean <= lasting, mean, lasting)),
    ]  # fmt: skip


def place_in_use(view: ToolDrive) -> int:
    """Return the place of the proposed pair among the best ones, from 1."""
    return (view.proposal.proposed or 0) + 1 if view.proposal.ranked else 1


def in_use(sheet: Sheet, view: ToolDrive) -> None:
    """Declare the figures of the motor and the reducer in use."""
    (m, r), motor, (inertia, ratio, efficiency, no_load) = view.pair, view.motor, view.gears
    sheet.heading("Motor and reducer in use")

    def row(kind: str, column: str, found: int) -> Quantity:
        listed = f"SUMPRODUCT(([{kind}s.name]=@{kind}_name)*[sel_{kind}s.k])"
        return calc(f"@{kind}_row", f"{kind.capitalize()}: row of the catalogue", "", "",
                    f'=IF(@{kind}_name="",MAX(1,INDEX([sel_order.{column}],@place)),{listed})', found, "0: not in it",
                    format="0")  # fmt: skip

    def of(name: str, label: str, symbol: str, unit: str, column: str, value: float, source: str = "") -> Quantity:
        (kind, figure), reserve = column.split("."), f"/limits_{OVER[column]}" if column in OVER else ""
        found = f"=INDEX([sel_{kind}s.{figure}],MAX(1,@{kind}_row)){reserve}"
        return calc(name, label, symbol, unit, found, value, source or (reserve and "over its reserve"))

    sheet.rows(
        calc("@place", "Place of the proposed pair", "", "",
             "=IF(SUM([sel_best.holds])=0,1,MATCH(1,[sel_best.holds],0))", place_in_use(view),
             "among the best pairs", format="0"),
        row("motor", "m", m + 1),
        row("reducer", "r", r + 1),
        of("@jm", "Inertia of the motor", "J_M", "kg m²", "motor.jm", motor.inertia),
        of("@jt", "Inertia of the reducer at its input", "J_T", "kg m²", "reducer.jt",
           float(view.proposal.reducers.inertia[r])),
        calc("@j", "Both", "J", "kg m²", "=@jm+@jt", inertia),
        of("@i", "Reduction", "i", "", "reducer.i", ratio, "1/τ"),
        of("@eta", "Efficiency of the reducer", "η", "", "reducer.eta", efficiency),
        of("@no_load", "No-load torque of the reducer", "T_nl", "Nm", "reducer.own", no_load, "opposes the rotation"),
        of("@motor_rated", "Rated torque of the motor", "T_N", "Nm", "motor.rated", motor.rated_torque),
        of("@motor_stall", "Stall torque of the motor", "T_0", "Nm", "motor.stall", motor.stall_torque, "T_N at least"),
        of("@motor_nn", "Speed of its rated torque", "n_N", "rpm", "motor.nn", shown(motor.rated_speed, RPM)),
        of("@motor_peak", "Peak torque of the motor", "T_max", "Nm", "motor.peak", motor.peak_torque),
        of("@motor_nmax", "Largest speed of the motor", "n_max", "rpm", "motor.nmax", shown(motor.max_speed, RPM)),
        of("@knee", "… up to which the peak torque holds", "n_1", "rpm", "motor.knee", shown(motor.falling.knee, RPM)),
        of("@fall", "Fall of the peak torque beyond", "f", "Nm/rpm", "motor.fall", shown(motor.falling.fall, PER_RPM)),
        of("@reducer_nmax", "Largest input speed of the reducer", "", "rpm", "reducer.nmax",
           shown(view.limits[0], RPM), "0: no limit"),
        of("@reducer_peak", "Largest output torque of the reducer", "", "Nm", "reducer.held", view.limits[1],
           "at these cycles an hour; 0: no limit"),
        of("@reducer_mean", "Largest mean output torque of the reducer", "", "Nm", "reducer.tmean", view.limits[2],
           "0: no limit"),
        calc("@still", "Standstill: speeds up to", "", "m/s", "=check_zero*MAX(ABS(fly_low),ABS(fly_high))",
             view.cycle.still, format="0E+00", scale=view.cycle.still),
    )  # fmt: skip


def turns(sheet: Sheet, view: ToolDrive, rows: PieceRows) -> None:
    """Declare where the tool turns round: the speed where the law is fastest, and looks at that beside each turn."""
    cycle, cut = view.cycle, view.machine.cut
    looks = [(*one[:2], *look) for one in cycle.stretches for look in view.looks(one)]
    after, number, middle, u, *rates, at = (list(values) for values in zip(*looks, strict=True))
    pieces, begin = [rows.pieces[k] for k in number], "INDEX(tool_at,[q])"
    before, least = "(tool_at<@slowest)", "v_L + h v(ξ_v)/t_m: of a long product its lowest"
    forward = f"SUMPRODUCT((tool_v0>@still)*{before})"
    backward = f"SUMPRODUCT(((tool_v0<0-@still)+{before}>0)*([tool_pieces.r]<=fly_pieces))"
    to = f"MIN({begin}+INDEX([tool_pieces.d],[q]),IF([after]<0,@slowest,fly_tc))"
    origin, place = "INDEX(tool_origin,[q])", "=IF([look]=1,[middle],[at-1])"
    nearer = f"{origin}+[u]-2*[v]/([a]+[after]*SQRT(MAX(0,[a]^2-2*[j]*[v])))"
    sheet.heading("Workings: where the tool turns round", ABOUT_TURNS)
    sheet.rows(
        calc("@slowest", "When the law is fastest", "t_v", "s", "=fly_peak*fly_tm", cycle.slowest, "ξ_v t_m"),
        calc("@least", "Speed of the tool then", "v_v", "m/s", LEAST, cut.slowest_speed, least),
        calc("@turned", "Turns round", "", "times", "=IF(@least<0-@still,2,0)", cycle.turns, format="0"),
    )
    sheet.row += 1
    sheet.table(
        "@turns", TITLE, len(looks),
        constant("after", "direction after it", "", "", after),
        constant("look", "look", "k", "", [*range(1, LOOKS + 1)] * 2),
        calc("q", "piece", "q", "", f"=IF([after]<0,{forward},{backward})", [k + 1 for k in number], format="0"),
        calc("middle", "first look at", "", "s", f"=(MAX({begin},IF([after]<0,0,@slowest))+{to})/2", middle),
        *place_columns(rows, "", "looked at", f"{place}-{origin}", np.array(u), pieces, "[q]"),
        *(calc(name, what, name, rows.at.unit(n), f"={sampled(rows, n)}", rates[n - 1], scale=cut.size(n))
          for n, (name, what) in enumerate((("v", "speed there"), ("a", "acceleration"), ("j", "jerk")), 1)),
        calc("at", "turns round at", "t", "s", f"=IF(@turned=0,[middle],{nearer})", at),
        blank="@turned=0",
    )  # fmt: skip


def intervals(sheet: Sheet, view: ToolDrive) -> None:
    """Declare the pieces of the tool's motion as intervals, cut at turns; spare rows at the end have no length."""
    cycle, room, time = view.cycle, view.machine.room, view.machine.cut.cycle_time
    cuts, used = cycle.intervals, "fly_pieces+@turned"
    middle = f"INDEX([@pt.v],{POINTS}*[k]-{POINTS // 2})"
    begins, ends, piece = zip(*cuts, strict=True)
    turned = [k - number for k, number in enumerate(piece)]
    passed = f"IF([k]>[@turns.q.{LOOKS}],1,0)+IF([k]>[@turns.q.last]+1,1,0)"
    begin = f"MAX(INDEX([tool_pieces.begin],[q]),IF([n]=0,0,INDEX([@turns.at],{LOOKS}*[n])))"
    way = filled(cycle.direction, room, float(cycle.direction[-1]))
    sheet.table(
        "@iv", "Intervals of the cycle", room,
        constant("k", "interval", "k", "", list(range(1, room + 1))),
        calc("n", "turns so far", "", "", f"=IF(@turned=0,0,{passed})", filled(turned, room, cycle.turns), format="0"),
        calc("q", "piece of the motion", "q", "", "=MIN([k]-[n],fly_pieces)",
             filled([number + 1 for number in piece], room, piece[-1] + 1), format="0"),
        calc("begin", "begins at", "t", "s", f"=IF([k]>{used},fly_tc,{begin})", filled(begins, room, time)),
        calc("end", "ends at", "t", "s", f"=IF([k]<{used},INDEX([@iv.begin],[k]+1),fly_tc)",
             filled(ends, room, time)),
        calc("dir", "direction in its middle", "", "",
             f"=IF([k]>{used},[dir-1],IF(ABS({middle})<=@still,0,SIGN({middle})))", way, "0 at rest", format="0"),
        blank=f"[k]>{used}",
    )  # fmt: skip


def points(sheet: Sheet, view: ToolDrive, rows: PieceRows) -> None:
    """Declare tool, shaft and motor at the points of each interval."""
    load, drive, of, room = view.load, view.points, view.by_point, view.machine.room
    numbers, cut_numbers = list(range(room)), [cut.piece for cut in view.cycle.intervals for _ in SHARES]
    pieces = filled([rows.pieces[k] for k in cut_numbers], room * POINTS, rows.pieces[-1])
    u = np.array(of(load.x)) - np.array([piece.origin for piece in pieces])
    sheet.table(
        "@pt", "The drive at nine points of each interval", room * POINTS,
        constant("k", "point", "k", "", list(range(1, room * POINTS + 1))),
        constant("iv", "interval", "", "", [k + 1 for k in numbers for _ in SHARES]),
        constant("s", "share of it", "", "", list(SHARES) * room),
        constant("g", "counts", "", "", list(WEIGHTS) * room),
        calc("t", "time", "t", "s", "=INDEX([@iv.begin],[iv])+[s]*(INDEX([@iv.end],[iv])-INDEX([@iv.begin],[iv]))",
             of(load.x)),
        calc("q", "piece", "q", "", "=INDEX([@iv.q],[iv])",
             filled([k + 1 for k in cut_numbers], room * POINTS, len(rows.pieces)), format="0"),
        *place_columns(rows, "", "within piece", "=[t]-INDEX([tool_pieces.origin],[q])", u, pieces, "[q]"),
        calc("y", "position of the tool", "s", "m", f"={sampled(rows, 0)}", of(load.position)),
        calc("v", "its speed", "v", "m/s", f"={sampled(rows, 1)}", of(load.velocity)),
        calc("a", "its acceleration", "a", "m/s²", f"={sampled(rows, 2)}", of(load.acceleration)),
        calc("dir", "direction", "", "", "=INDEX([@iv.dir],[iv])", of(load.direction), "of its interval", format="0"),
        calc("w", "speed of the shaft", "ω_L", "rad/s", "=[v]*1000/fly_r", of(load.speed)),
        calc("al", "its acceleration", "ω̇_L", "rad/s²", "=[a]*1000/fly_r", of(load.shaft_acceleration),
             scale=view.turning),
        calc("S", "its torque", "T*_L", "Nm", "=fly_torque+fly_j*[al]", of(load.output_torque), "T_L + J_L ω̇_L",
             scale=view.torque),
        result("n", "speed of the motor", "n", "rpm", "=@i*[w]*30/PI()", of(shown(drive.speed, RPM)), "ω_L/τ",
               scale=shown(view.speed, RPM)),
        result("T", "torque of the motor", "T", "Nm", "=IF([S]*[dir]<0,@eta,1/@eta)*[S]/@i+@j*@i*[al]+@no_load*[dir]",
               of(drive.torque), "τ T*/η + J ω̇/τ ± T_nl; τ T* η where the load drives", scale=view.motor_torque),
        calc("share", "share of the cycle", "", "", "=[g]*(INDEX([@iv.end],[iv])-INDEX([@iv.begin],[iv]))/fly_tc",
             of(load.share, 0.0), "what it counts in a mean", scale=1.0),
        calc("left", "left below the motor's curve", "", "Nm", "=@motor_peak-@fall*MAX(0,ABS([n])-@knee)-ABS([T])",
             of(view.left), "T_max − f (n − n_1) − |T|", scale=max(view.motor_torque, view.motor.peak_torque)),
        blank="[share]=0",
    )  # fmt: skip
