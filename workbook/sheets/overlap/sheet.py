"""The Overlap sheet: what to enter, the three schedules, checks, diagrams, and what a margin costs."""

from __future__ import annotations

from math import degrees

import numpy as np

from engine.laws.inverse import inverse
from engine.overlap import movement_time
from workbook.chart import Chart, Series
from workbook.declare import Book, Sheet, calc, check, constant, given, result
from workbook.machines.overlap_model import TURN, Overlapping
from workbook.sheets.overlap.cycle import EPS, ToolState, diagrams, turned
from workbook.sheets.sampling import Pieces

BELOW_CHARTS = 45  # the row from which the sheet is free in its whole width
CAPPED = (
    "OR(overlap_room*overlap_split*overlap_rest_in<overlap_free_in,"
    "overlap_room*(1-overlap_split)*overlap_rest_out<overlap_free_out)"
)
PEAK = "=IF(MIN([in],[out])>0,MAX([used.ca.2]/[in]^2,[used.ca.3]/[out]^2)*overlap_stroke/1000*(360/overlap_tc)^2,0)"
CORNERS = (
    "transfer gets in the way",
    "transfer is in place",
    "tool sets off",
    "tool arrives",
    "tool leaves",
    "tool is back",
)


def overlap_sheet(book: Book, machine: Overlapping, pieces: Pieces) -> None:
    """Declare the sheet."""
    sheet = book.sheet("Overlap", "How much longer the tool may take when it begins before the transfer has ended.")
    entries(sheet, machine)
    outcome(sheet, machine)
    verdicts(sheet, machine)
    diagrams(sheet, machine)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    schedules(sheet, machine)
    margins(sheet, machine)
    workings(sheet, machine)
    corners(sheet, machine, pieces)
    sheet.print_columns = 24


def entries(sheet: Sheet, machine: Overlapping) -> None:
    """Declare what the engineer enters."""
    e = machine.given
    t, tool, p = e.transfer, e.tool, e.passage
    sheet.heading(
        "What to enter",
        "The transfer brings the part and begins at 0°; the tool goes in, dwells at the part and goes out again.",
    )
    sheet.rows(
        given("overlap_rate", "Production rate", "N", "pieces/h", e.rate, "overlap.rate", format="0.0##", source="one piece a turn of the master shaft; S2: 2000"),
        given("overlap_transfer", "Transfer", "", "", t.name, "overlap.transfer.name"),
        given("overlap_law", "its law", "", "", t.law, "overlap.transfer.law", source="S2: cycloidal, CIC"),
        given("overlap_pitch", "its stroke", "h_t", "mm", t.stroke, "overlap.transfer.stroke", format="0.0##", source="S2: 100 mm"),
        given("overlap_angle", "its angle", "B_t", "°", t.angle, "overlap.transfer.angle", format="0.0##", source="S2: 150°"),
        given("overlap_tool", "Tool", "", "", tool.name, "overlap.tool.name"),
        given("overlap_law_in", "its law, way in", "", "", tool.law_in, "overlap.tool.law_in", source="S2: cycloidal, CIC"),
        given("overlap_law_out", "its law, way out", "", "", tool.law_out, "overlap.tool.law_out", source="S2: cycloidal, CIC"),
        given("overlap_stroke", "its stroke", "h_m", "mm", tool.stroke, "overlap.tool.stroke", format="0.0##", source="S2: 50 mm"),
        given("overlap_dwell", "its dwell at the part", "", "°", tool.dwell, "overlap.tool.dwell", format="0.0##", source="S2: 100°"),
        given("overlap_remaining", "Share of the transfer's stroke that may remain", "r", "%", p.remaining, "overlap.passage.remaining", format="0.0000", source="while the tool is in; S2: 0.65 %, at a tenth of the time"),
        given("overlap_clearance", "Clearance between tool and transfer", "c", "mm", p.clearance, "overlap.passage.clearance", format="0.0##", source="travel of the tool before it touches; S2: 20 mm"),
        given("overlap_margin", "Margin that stays free", "m", "mm", p.margin, "overlap.passage.margin", format="0.0##", source="S2: 1 mm"),
        given("overlap_allowance", "Allowance for the setting of the cam", "", "°", p.allowance, "overlap.passage.allowance", format="0.0##", source="taken off the tool's angles; S2 advises 5°"),
        given("overlap_split", "Share of the free angle for the way in", "", "", p.split, "overlap.passage.split", format="0.0##", source="S2: divided equally"),
        given("overlap_set_in", "Angle of the way in, if you choose it", "", "°", tool.angle_in, "overlap.tool.angle_in", format="0.0##", source="empty: the longest less the allowance; S2 takes 125°"),
        given("overlap_set_out", "Angle of the way out, if you choose it", "", "°", tool.angle_out, "overlap.tool.angle_out", format="0.0##", source="empty: the longest less the allowance"),
    )  # fmt: skip


def outcome(sheet: Sheet, machine: Overlapping) -> None:
    """Declare the results, in short."""
    before, _, after = (s.peak_acceleration(machine.rate) for s in machine.schedules)
    as_set = machine.as_set
    sheet.heading("What comes out")
    sheet.rows(
        result("overlap_new_in", "New angle of the tool's way in", "B_m", "°", "=[schedules.in.3]", degrees(as_set.way_in), source="as set; S2: 125°, 120° with the allowance"),
        result("overlap_new_out", "New angle of its way out", "B_m", "°", "=[schedules.out.3]", degrees(as_set.way_out)),
        result("overlap_a0", "Peak acceleration one after the other", "a_max", "m/s²", "=[schedules.a.1]", before, source="S2: 4.154 m/s²"),
        result("overlap_a1", "Peak acceleration with overlap", "a_max", "m/s²", "=[schedules.a.3]", after, source="S2: 0.804 m/s² at 125°"),
        result("overlap_ratio", "The acceleration falls by a factor of", "", "", "=[schedules.ratio.3]", before / after, source="S2: 5.17 at 125°"),
        result("overlap_least", "Least clearance over the cycle", "", "mm", "=MIN([corners.free])", machine.clearance.minimum * 1e3, source="exact, at the corners of the diagram", scale=1.0),
        result("overlap_limit", "What limits the tool's angles", "", "", f'=IF({CAPPED},"cycle","clearance")', machine.longest.limit),
    )  # fmt: skip


def schedules(sheet: Sheet, machine: Overlapping) -> None:
    """Declare the table of the three schedules."""
    plans, rate = machine.schedules, machine.rate
    h = machine.tool.stroke
    peaks = np.array([s.peak_acceleration(rate) for s in plans])
    edges = np.degrees([s.edges for s in plans])
    ways = [[s.way_in for s in plans], [s.way_out for s in plans]]
    times = [[movement_time(w, rate) for w in way] for way in ways]
    accelerations = [
        [law.coefficients.ca * h / t**2 for t in time]
        for law, time in zip((machine.tool.law, machine.tool.out), times, strict=True)
    ]
    arrives = "=IF([k]=1,overlap_angle+overlap_free0*overlap_split,overlap_end+overlap_free_in)"
    sheet.row += 1
    sheet.table(
        "schedules", "The tool's angles", 3,
        constant("what", "schedule", "", "", ["one after the other", "overlap, the longest", "overlap, as set"], align="left"),
        result("in", "way in", "B_m", "°", way_formulas("in", "overlap_split"), np.degrees(ways[0]), source="F_in/(1 − ξ)"),
        result("out", "way out", "B_m", "°", way_formulas("out", "(1-overlap_split)"), np.degrees(ways[1]), source="F_out/(1 − ξ)"),
        calc("away", "sets off at", "", "°", "=[there]-[in]", edges[:, 0], scale=TURN),
        calc("there", "arrives at", "", "°", arrives, edges[:, 1]),
        calc("leaves", "leaves at", "", "°", "=[there]+overlap_dwell", edges[:, 2]),
        calc("back", "is back at", "", "°", "=[leaves]+[out]", edges[:, 3], source="above 360°: in the next turn"),
        calc("t_in", "time in", "t_m", "s", "=[in]/360*overlap_tc", times[0], source="10 B_m/N", scale=1e-3),
        calc("t_out", "time out", "t_m", "s", "=[out]/360*overlap_tc", times[1], source="10 B_m/N", scale=1e-3),
        calc("a_in", "peak, way in", "a", "m/s²", "=IF([t_in]>0,[used.ca.2]*overlap_stroke/1000/[t_in]^2,0)", accelerations[0], source="C_a h/t_m²", scale=1e-3),
        calc("a_out", "peak, way out", "a", "m/s²", "=IF([t_out]>0,[used.ca.3]*overlap_stroke/1000/[t_out]^2,0)", accelerations[1], source="C_a h/t_m²", scale=1e-3),
        result("a", "peak acceleration", "a_max", "m/s²", "=MAX([a_in],[a_out])", peaks, scale=1e-3),
        result("ratio", "times lower", "", "", "=IF([a]>0,[schedules.a.1]/[a],0)", peaks[0] / peaks),
        constant("k", "row", "k", "", [1, 2, 3]),
    )  # fmt: skip


def way_formulas(way: str, share: str) -> list[str]:
    """Return the angle of one way in each schedule: half of what the transfer leaves, longest, as set."""
    most, rest = f"overlap_room*{share}", f"overlap_rest_{way}"
    return [
        f"=overlap_free0*{share}",
        f"=IF({rest}>0,MIN(overlap_free_{way}/{rest},{most}),{most})",
        f'=IF(overlap_set_{way}="",[schedules.{way}.2]-overlap_allowance,overlap_set_{way})',
    ]


def verdicts(sheet: Sheet, machine: Overlapping) -> None:
    """Declare the checks."""
    found = machine.clearance
    nearly = "check_zero*MAX(overlap_clearance,overlap_stroke)"
    own = ",".join(f"[used.no.{i}]=OWN_no" for i in (1, 2, 3))
    sheet.checks(
        check("overlap_ok_collide", "The parts do not collide", f"overlap_least>=0-{nearly}", not found.collides, "least clearance at least 0"),
        check("overlap_ok_margin", "The margin stays free", f"overlap_least>=overlap_margin-{nearly}", found.keeps_margin, "S2: 1 mm"),
        check("overlap_ok_angle", "The cycle leaves the tool an angle", "AND(overlap_free0>0,MIN([schedules.in])>0,MIN([schedules.out])>0)", True),
        check("overlap_ok_turn", "Way in, dwell and way out fit into the turn", "[schedules.in.3]+overlap_dwell+[schedules.out.3]<=360+check_zero", True),
        check("overlap_ok_entry", "The margin is not more than the clearance", "overlap_margin<=overlap_clearance", True),
        check("overlap_ok_rises", "The laws never move backwards", f"OR(NOT(OR({own})),MIN([own_samples.v])>=0-check_zero)", True, "only a law that rises throughout can be inverted"),
    )  # fmt: skip


def workings(sheet: Sheet, machine: Overlapping) -> None:
    """Declare the way from the entries to the angles, as S2 goes it."""
    begin, end = machine.blocked
    tool, free0 = machine.tool, degrees(machine.before.way_in + machine.before.way_out)
    dwell = degrees(tool.dwell)
    free = TURN - (end - begin) - dwell
    split = machine.passage.split
    rest_in, rest_out = rests(machine)
    sheet.heading("Workings")
    sheet.rows(
        calc("overlap_tc", "Time of one turn", "t_c", "s", "=3600/overlap_rate", 1 / machine.rate, source="3600 / N"),
        calc("overlap_eps", "Tolerance of an angle", "ε", "°", "=360*break_tolerance", EPS, format="0E+00", source="an angle this near to an event counts as on it"),
        calc("overlap_free0", "Free angle one after the other", "", "°", "=360-overlap_angle-overlap_dwell", free0, source="S2: 360° − 150° − 100° = 110°, 55° each way"),
        calc("overlap_begin", "The transfer is in the way from", "", "°", "=[inverse_transfer.xi.1]*overlap_angle", begin, scale=TURN, source="r of its stroke done; S2: 15°"),
        calc("overlap_end", "to", "", "°", "=[inverse_transfer.xi.2]*overlap_angle", end, scale=TURN, source="r of its stroke to go; S2: 135°"),
        calc("overlap_effective", "Its effective angle", "", "°", "=overlap_end-overlap_begin", end - begin, source="S2: 150° − 2 · 15° = 120°"),
        calc("overlap_free_in", "Free angle of the way in", "F_in", "°", "=(360-overlap_effective-overlap_dwell)*overlap_split", free * split, source="S2: 140°/2 = 70°"),
        calc("overlap_free_out", "Free angle of the way out", "F_out", "°", "=(360-overlap_effective-overlap_dwell)*(1-overlap_split)", free * (1 - split), source="S2: 70°"),
        calc("overlap_rest_in", "Way in left when the transfer comes", "1 − ξ", "", "=1-[inverse_in.xi.1]", rest_in, scale=1.0, source="S2: 1 − 44 % = 56 %; exactly 56.07 %"),
        calc("overlap_rest_out", "Way out done when the transfer leaves", "1 − ξ", "", "=[inverse_out.xi.1]", rest_out, scale=1.0, source="the same in reverse"),
        calc("overlap_room", "Angle for both ways at most", "", "°", "=360-overlap_dwell", TURN - dwell, source="the cycle"),
    )  # fmt: skip


def rests(machine: Overlapping) -> tuple[float, float]:
    """Return the shares of the ways in and out for which the transfer is in place, from the engine's motions."""
    p, tool = machine.passage, machine.tool
    gone = min((p.clearance - p.margin) / tool.stroke, 1.0)
    return 1 - inverse(tool.law, gone), inverse(tool.out, 1 - gone)


def corners(sheet: Sheet, machine: Overlapping, pieces: Pieces) -> None:
    """Declare the corners of the diagram, at which the clearance is least."""
    plan, p = machine.as_set, machine.passage
    begin, end = machine.blocked
    raw = np.array([begin, end, *np.degrees(plan.edges)])
    theta = turned(raw)
    inside = (theta >= begin - EPS) & (theta <= end + EPS)
    free = np.where(inside, p.clearance - plan.positions(np.radians(theta)).tool, p.clearance) * 1e3
    sheet.row += 1
    sheet.table(
        "corners", "Clearance at the corners: between them the tool moves one way only", 6,
        constant("what", "corner", "", "", list(CORNERS), align="left"),
        calc("raw", "angle", "", "°", ["=overlap_begin", "=overlap_end", *(f"=[schedules.{c}.3]" for c in ("away", "there", "leaves", "back"))], raw, scale=TURN),
        calc("theta", "master angle", "θ", "°", "=[raw]-360*INT([raw]/360+break_tolerance)", theta, scale=TURN, source="within one turn"),
        calc("inside", "transfer in the way", "", "", "=IF(AND([theta]>=overlap_begin-overlap_eps,[theta]<=overlap_end+overlap_eps),1,0)", inside.astype(float), format="0"),
        result("free", "clearance", "", "mm", "=IF([inside]=1,overlap_clearance-[y],overlap_clearance)", free, scale=1.0, source="c − y; c where it is out of the way"),
        *ToolState(machine, plan, theta, pieces).columns("", 3),
    )  # fmt: skip


def margins(sheet: Sheet, machine: Overlapping) -> None:
    """Declare what a margin costs."""
    sweep, n = machine.margins, machine.sizes.margins
    mm = sweep.margin * 1e3
    sheet.heading(
        "What a margin costs", "The longest angles less the allowance, for margins from 0 to the whole clearance."
    )
    sheet.chart_row(
        Chart("Acceleration ratio against margin", "margin m [mm]", "times lower", (
            Series("times lower", "[margins.margin]", "[margins.ratio]"),
            Series("margin entered", "[margin_line.x]", "[margin_line.ratio]", dashed=True)),
            "How many times the peak acceleration falls, over the margin that stays free between the parts"),
        Chart("Peak acceleration against margin", "margin m [mm]", "a_max [m/s²]", (
            Series("peak acceleration", "[margins.margin]", "[margins.a]"),
            Series("margin entered", "[margin_line.x]", "[margin_line.a]", dashed=True)),
            "Peak acceleration of the tool over the margin that stays free between the parts"),
        width=7,
    )  # fmt: skip

    def way(which: str, share: str) -> str:
        xi = f"INDEX([inverse_{which}.xi],[k]+2)"
        rest = f"(1-{xi})" if which == "in" else xi
        most = f"overlap_room*{share}"
        return f"=IF({rest}>0,MIN(overlap_free_{which}/{rest},{most}),{most})-overlap_allowance"

    sheet.table(
        "margins", "Ratio against margin", n + 1,
        calc("margin", "margin", "m", "mm", "=[k]/[margins.k.last]*overlap_clearance", mm, scale=1.0),
        result("in", "way in", "B_m", "°", way("in", "overlap_split"), np.degrees(sweep.way_in)),
        result("out", "way out", "B_m", "°", way("out", "(1-overlap_split)"), np.degrees(sweep.way_out)),
        result("a", "peak acceleration", "a_max", "m/s²", PEAK, sweep.acceleration, scale=1e-3, source="C_a h/t_m²"),
        result("ratio", "times lower", "", "", "=IF([a]>0,overlap_a0/[a],0)", sweep.ratio),
        constant("k", "row", "k", "", list(range(n + 1))),
    )  # fmt: skip
    sheet.table(
        "margin_line", "The margin entered, as drawn in the charts", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("x", "margin", "m", "mm", "=overlap_margin", [machine.passage.margin * 1e3] * 2, scale=1.0),
        calc("ratio", "times lower", "", "", "=[end]*MAX([margins.ratio])", [0.0, float(sweep.ratio.max())], scale=1.0),
        calc("a", "peak acceleration", "a_max", "m/s²", "=[end]*MAX([margins.a])", [0.0, float(sweep.acceleration.max())], scale=1e-3),
    )  # fmt: skip
