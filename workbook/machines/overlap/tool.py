"""One tool and the transfer: what to enter, the three schedules, checks, charts, and the way to the angles.

The names stand in the tool's scope: ``@stroke`` is ``tool2_stroke`` for the second (:mod:`workbook.book.declare`).
"""

from collections.abc import Sequence

import numpy as np

from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet, calc, check, constant, entries_of, result
from workbook.book.sentence import amount
from workbook.fields.units import DEGREE, MM, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap.cycle import SCHEDULES, AtAngles
from workbook.machines.overlap.entries import LEAST
from workbook.machines.overlap.view import Station
from workbook.motion.requirements import ABOUT as CONTINUOUS

SHARES = {"in": "@split", "out": "(1-@split)"}  # of what is free for both ways
CAPPED = "OR(@room*@split*@rest_in<@free_in,@room*(1-@split)*@rest_out<@free_out)"
TAKEN = "([@schedules.in.3]+@dwell+[@schedules.out.3])"
CORNERS = ("transfer gets in the way", "transfer is in place", "tool sets off", "tool arrives", "tool leaves",
           "tool is back")  # fmt: skip


def declare(sheet: Sheet, station: Station, pieces: Pieces, beside: int, below: int, shared: Sequence[Quantity] = (),
            workings: Sequence[Quantity] = ()) -> None:  # fmt: skip
    """Declare a tool: charts from the row ``beside``, tables from ``below``; ``shared`` are checks of all tools."""
    with sheet.scoped(station.scope):
        entries(sheet, station)
        outcome(sheet, station)
        sheet.checks(*shared)
        charts(sheet, beside)
        sheet.row = max(sheet.row, below)
        schedules(sheet, station)
        margins(sheet, station)
        sheet.not_printed_below()
        sheet.heading("Workings")
        sheet.rows(*workings)
        steps(sheet, station)
        corners_table(sheet, station, pieces)


def quoting(station: Station, *quantities: Quantity) -> list[Quantity]:
    """Return quantities with S2's figures beside the first tool only: another is not S2's."""
    if station.number == 1:
        return list(quantities)
    return [q._replace(source=q.source.partition("S2")[0].rstrip("; ")) for q in quantities]


def entries(sheet: Sheet, station: Station) -> None:
    """Declare what the engineer enters."""
    entry = entries_of(station.given, station.key)
    sheet.rows(*quoting(
        station,
        entry("@name", "Tool", "", "", "name"),
        entry("@law_in", "its law, way in", "", "", "law_in", "S2: cycloidal, CIC", choices="=law_code"),
        entry("@law_out", "its law, way out", "", "", "law_out", "S2: cycloidal, CIC", choices="=law_code"),
        entry("@stroke", "its stroke", "h_m", "mm", "stroke", "S2: 50 mm"),
        entry("@dwell", "its dwell at the part", "", "°", "dwell", "S2: 100°"),
        entry("@smooth", "what must be continuous", "", "", "smoothness", CONTINUOUS, align="center"),
        entry("@remaining", "Share of the stroke that may remain", "s_r", "%", "passage.remaining",
              "while in; S2: 0.65 %, at a tenth of the time", format="0.0000"),
        entry("@clearance", "Clearance between tool and transfer", "c", "mm", "passage.clearance",
              "travel of the tool before it touches; S2: 20 mm"),
        entry("@margin", "Margin that stays free", "m", "mm", "passage.margin", "S2: 1 mm"),
        entry("@allowance", "Allowance for the setting of the cam", "", "°", "passage.allowance",
              "taken off the tool's angles; S2 advises 5°"),
        entry("@split", "Share of the free angle for the way in", "", "", "passage.split", "S2: divided equally"),
        entry("@set_in", "Angle of the way in, if you choose it", "", "°", "angle_in",
              "empty: the longest less the allowance; S2: 125°"),
        entry("@set_out", "Angle of the way out, if you choose it", "", "°", "angle_out",
              "empty: the longest less the allowance"),
    ))  # fmt: skip


def outcome(sheet: Sheet, station: Station) -> None:
    """Declare the results, in short, and the checks."""
    before, _, after = station.peaks
    way_in, way_out = station.angles_set
    sheet.heading("Results")
    sheet.rows(*quoting(
        station,
        result("@new_in", "New angle of the tool's way in", "B_m", "°",
               "=[@schedules.in.3]", way_in, "as set; S2: 125°, 120° with the allowance"),
        result("@new_out", "New angle of its way out", "B_m", "°", "=[@schedules.out.3]", way_out),
        result("@a0", "Peak acceleration one after the other", "a_max", "m/s²",
               "=[@schedules.a.1]", before, "S2: 4.154 m/s²"),
        result("@a1", "Peak acceleration with overlap", "a_max", "m/s²",
               "=[@schedules.a.3]", after, "S2: 0.804 m/s² at 125°"),
        result("@ratio", "The acceleration falls by a factor of", "", "",
               "=[@schedules.ratio.3]", station.as_set.times_lower(station.before), "S2: 5.17 at 125°"),
        result("@least", "Least clearance over the cycle", "", "mm",
               "=MIN([@corners.free])", station.least, "exact, at the corners of the diagram"),
        result("@limit", "What limits the tool's angles", "", "",
               f'=IF({CAPPED},"cycle","clearance")', station.longest.limit),
    ))  # fmt: skip
    sheet.checks(*quoting(station, *checks(station)))


def checks(station: Station) -> tuple[Quantity, ...]:
    """Return the checks of the tool."""
    found, margin = station.clearance, station.given.passage.margin
    nearly = "inverse_bound*MAX(@clearance,@stroke)"
    return (
        check("@ok_collide", "The parts do not collide", f"@least>=0-{nearly}", not found.collides,
              "least clearance at least 0", says=amount("@least", station.least, "least clearance ", " mm")),
        check("@ok_margin", "The margin stays free", f"@least>=@margin-{nearly}", found.meets_margin,
              says=amount("@margin-@least", margin - station.least, "", " mm too little stay free")),
        check("@ok_angle", "The cycle leaves the tool an angle",
              "@least_left>=@least_way", True, "of both ways the shorter", f"overlap:angle{station.number}",
              'ROUND(@least_left,9)&"° are left to a way; expected at least "&ROUND(@least_way,9)&"°"'),
        check("@ok_turn", "Way in, dwell and way out fit into the turn",
              f"{TAKEN}<=360+check_zero", True, "", f":turn{station.number}",
              f'"way in, dwell and way out take "&ROUND({TAKEN},9)&"°; expected at most 360°"'),
        check("@ok_entry", "The margin is not more than the clearance", "@margin<=@clearance", True, "",
              f"{station.key}.passage:entry",
              '"a margin of "&ROUND(@margin,9)&" mm; expected at most "&ROUND(@clearance,9)&" mm"'),
    )  # fmt: skip


def charts(sheet: Sheet, row: int) -> None:
    """Place the travel under its limit, and the accelerations."""
    theta = "[@motions.theta]"
    allowed = Series("allowed", theta, "[@motions.limit]", dashed=True)
    for column, title, y, name, more, about in (
        (11, "Travel of the tool, and what the transfer allows", "travel y [mm]", "y", (allowed,),
         "Travel of the tool in both schedules, below the travel that the transfer allows it"),
        (18, "Acceleration of the tool", "acceleration [m/s²]", "acc", (),
         "Acceleration of the tool over the cycle, one after the other and with overlap"),
    ):  # fmt: skip
        lines = (Series(words, theta, f"[@motions.{name}{suffix}]") for suffix, (_, words) in SCHEDULES.items())
        chart = Chart(title, "master angle θ [°]", y, (*lines, *more), about, (0, 360, 30))
        sheet.chart(chart, column=column, row=row, width=7, height=18)


def schedules(sheet: Sheet, station: Station) -> None:
    """Declare the table of the three schedules."""
    plans, rate = station.schedules, station.machine.rate
    away, there, leaves, back = shown(np.array([plan.edges for plan in plans]).T, DEGREE)
    way_in, way_out = shown(np.array([(plan.angle_in, plan.angle_out) for plan in plans]).T, DEGREE)
    time_in, time_out = np.array([plan.times(rate) for plan in plans]).T
    peak_in, peak_out = np.array([plan.movement_peaks(rate) for plan in plans]).T
    row_in, row_out = station.law_rows
    ways = {
        way: [f"=@free0*{share}", f"={longest(way, f'@rest_{way}')}",
              f'=IF(@set_{way}="",[@schedules.{way}.2]-@allowance,@set_{way})']
        for way, share in SHARES.items()
    }  # fmt: skip
    arrives = "=IF([k]=1,overlap_angle+@free0*@split,@end+@free_in)"
    sheet.row += 1
    sheet.table(
        "@schedules", "The tool's angles", 3,
        constant("what", "schedule", "", "",
                 ["one after the other", "overlap, the longest", "overlap, as set"], align="left"),
        result("in", "way in", "B_m", "°", ways["in"], way_in, "F_in/(1 − ξ)"),
        result("out", "way out", "B_m", "°", ways["out"], way_out, "F_out/(1 − ξ)"),
        calc("away", "sets off at", "", "°", "=[there]-[in]", away),
        calc("there", "arrives at", "", "°", arrives, there),
        calc("leaves", "leaves at", "", "°", "=[there]+@dwell", leaves),
        calc("back", "is back at", "", "°", "=[leaves]+[out]", back, "above 360°: in the next turn"),
        calc("t_in", "time in", "t_m", "s", "=[in]/360*overlap_tc", time_in, "10 B_m/N"),
        calc("t_out", "time out", "t_m", "s", "=[out]/360*overlap_tc", time_out, "10 B_m/N"),
        calc("a_in", "peak, way in", "a", "m/s²",
             f"=IF([t_in]>0,[used.ca.{row_in}]*@stroke/1000/[t_in]^2,0)", peak_in, "C_a h/t_m²"),
        calc("a_out", "peak, way out", "a", "m/s²",
             f"=IF([t_out]>0,[used.ca.{row_out}]*@stroke/1000/[t_out]^2,0)", peak_out, "C_a h/t_m²"),
        result("a", "peak acceleration", "a_max", "m/s²", "=MAX([a_in],[a_out])", station.peaks),
        result("ratio", "times lower", "", "",
               "=IF([a]>0,[@schedules.a.1]/[a],0)", [plan.times_lower(station.before) for plan in plans]),
        constant("k", "row", "k", "", [1, 2, 3]),
    )  # fmt: skip


def longest(way: str, rest: str) -> str:
    """Return the formula, without =, of the longest angle of a way of which a share is left as the transfer moves."""
    most = f"@room*{SHARES[way]}"
    return f"IF({rest}>0,MIN(@free_{way}/{rest},{most}),{most})"


def steps(sheet: Sheet, station: Station) -> None:
    """Declare the way from the entries to the angles, as S2 goes it."""
    left, before = station.engine.left, station.before
    (first, last), shorter = station.blocked_rows, min(before.angle_in, before.angle_out)
    begin, end, free_in, free_out, both = (shown(angle, DEGREE) for angle in left)
    rest_in, rest_out = station.engine.remaining_shares(np.array(station.passage.margin))
    sheet.rows(*quoting(
        station,
        calc("@free0", "Free angle one after the other", "", "°", "=360-overlap_angle-@dwell",
             shown(before.angle_in + before.angle_out, DEGREE), "S2: 360° − 150° − 100° = 110°, 55° each way"),
        calc("@begin", "The transfer is in the way from", "", "°", f"=[inverse_transfer.xi.{first}]*overlap_angle",
             begin, "s_r of its stroke done; S2: 15°"),
        calc("@end", "to", "", "°", f"=[inverse_transfer.xi.{last}]*overlap_angle", end,
             "s_r of its stroke to go; S2: 135°"),
        calc("@effective", "Its effective angle", "", "°",
             "=@end-@begin", shown(left.end - left.begin, DEGREE), "S2: 150° − 2 · 15° = 120°"),
        calc("@free_in", "Free angle of the way in", "F_in", "°",
             "=(360-@effective-@dwell)*@split", free_in, "S2: 140°/2 = 70°"),
        calc("@free_out", "Free angle of the way out", "F_out", "°",
             "=(360-@effective-@dwell)*(1-@split)", free_out, "S2: 70°"),
        calc("@rest_in", "Way in left when the transfer comes", "1 − ξ", "",
             "=1-[@inverse_in.xi.1]", float(rest_in), "S2: 1 − 44 % = 56 %; exactly 56.07 %"),
        calc("@rest_out", "Way out done when the transfer leaves", "1 − ξ", "",
             "=[@inverse_out.xi.1]", float(rest_out), "the same in reverse"),
        calc("@room", "Angle for both ways at most", "", "°", "=360-@dwell", both, "the cycle"),
        calc("@least_left", "Left to the shorter way, one after the other", "", "°",
             "=@free0*MIN(@split,1-@split)-@allowance", shown(shorter - station.passage.allowance, DEGREE)),
        constant("@least_way", "Least angle of a way", "", "°", LEAST, "no cam moves in less", format="0.00"),
    ))  # fmt: skip


def corners_table(sheet: Sheet, station: Station, pieces: Pieces) -> None:
    """Declare the corners of the diagram, at which the clearance is least."""
    at = station.engine.critical_angles(station.as_set)
    theta = shown(at.angle, DEGREE)
    sheet.row += 1
    sheet.table(
        "@corners", "Clearance at the corners: between them the tool moves one way only", 6,
        constant("what", "corner", "", "", list(CORNERS), align="left"),
        calc("raw", "angle", "", "°",
             ["=@begin", "=@end", *(f"=[@schedules.{c}.3]" for c in ("away", "there", "leaves", "back"))],
             shown(at.raw, DEGREE)),
        calc("theta", "master angle", "θ", "°", "=[raw]-360*INT([raw]/360+break_eps)", theta, "within one turn"),
        calc("inside", "transfer in the way", "", "",
             "=IF(AND([theta]>=@begin-overlap_eps,[theta]<=@end+overlap_eps),1,0)", at.inside.astype(float),
             format="0"),
        result("free", "clearance", "", "mm", "=IF([inside]=1,@clearance-[y],@clearance)", shown(at.free, MM),
               "c − y; c where it is out of the way"),
        *AtAngles(station, "a", theta, pieces).columns(""),
    )  # fmt: skip


def margins(sheet: Sheet, station: Station) -> None:
    """Declare charts and table, in the tool's scope."""
    sheet.heading(
        "What a margin costs", "The longest angles less the allowance, for margins from 0 to the whole clearance."
    )
    shown_over = (
        ("Acceleration ratio", "times lower", "times lower", "ratio",
         "How many times the peak acceleration falls, over the margin that stays free between the parts"),
        ("Peak acceleration", "a_max [m/s²]", "peak acceleration", "a",
         "Peak acceleration of the tool over the margin that stays free between the parts"),
    )  # fmt: skip
    sheet.chart_row(
        *(Chart(f"{title} against margin", "margin m [mm]", unit, (
            Series(name, "[@margins.margin]", f"[@margins.{y}]"),
            Series("margin entered", "[@margin_line.x]", f"[@margin_line.{y}]", dashed=True)), about)
          for title, unit, name, y, about in shown_over),
        width=7,
    )  # fmt: skip
    sweep, n = station.margins, station.machine.sizes.margins
    row_in, row_out = station.law_rows
    ways = f"MAX([used.ca.{row_in}]/[in]^2,[used.ca.{row_out}]/[out]^2)"
    peak = f"=IF(MIN([in],[out])>0,{ways}*@stroke/1000*(360/overlap_tc)^2,0)"
    sheet.table(
        "@margins", "Ratio against margin", n + 1,
        calc("margin", "margin", "m", "mm", "=[k]/[@margins.k.last]*@clearance", shown(sweep.margin, MM)),
        result("in", "way in", "B_m", "°", f"={longest('in', '(1-INDEX([@inverse_in.xi],[k]+2))')}-@allowance",
               shown(sweep.angle_in, DEGREE)),
        result("out", "way out", "B_m", "°", f"={longest('out', 'INDEX([@inverse_out.xi],[k]+2)')}-@allowance",
               shown(sweep.angle_out, DEGREE)),
        result("a", "peak acceleration", "a_max", "m/s²", peak, sweep.acceleration, "C_a h/t_m²"),
        result("ratio", "times lower", "", "", "=IF([a]>0,@a0/[a],0)", sweep.ratio),
        constant("k", "row", "k", "", list(range(n + 1))),
    )  # fmt: skip
    sheet.table(
        "@margin_line", "The margin entered, as drawn in the charts", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("x", "margin", "m", "mm", "=@margin", station.given.passage.margin),
        calc("ratio", "times lower", "", "", "=[end]*MAX([@margins.ratio])", [0.0, float(sweep.ratio.max())]),
        calc("a", "peak acceleration", "a_max", "m/s²",
             "=[end]*MAX([@margins.a])", [0.0, float(sweep.acceleration.max())]),
    )  # fmt: skip
