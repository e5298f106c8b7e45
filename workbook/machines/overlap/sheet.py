"""The Overlap sheet: transfer and timing diagrams; with one tool all of it, with several, a sheet each, their sum."""

from engine.overlap.schedule import ANGLE_TOLERANCE, movement_time
from engine.timing import FULL_TURN, shaft_speed
from workbook.book.chart import COLOURS, Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, entries_of, result
from workbook.fields.units import DEGREE, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap import tool
from workbook.machines.overlap.view import BACKWARDS, OverlapView
from workbook.motion.requirements import ABOUT as CONTINUOUS

BELOW_CHARTS = 45  # the row from which the sheet is free in its whole width
RIGHT, SECOND = 11, 24  # the column of charts beside the entries, and the row of the second two
WIDE = 7  # columns of a chart
ONE = "The transfer brings the part and begins at 0°; the tool goes in, dwells at the part and goes out again."
SEVERAL = "The transfer brings the parts and begins at 0°; each tool goes in, dwells and goes out again."
APART = "The tools work at stations of their own: each meets the transfer, never another tool."


def overlap_sheet(book: Book, machine: OverlapView, pieces: Pieces) -> None:
    """Declare the sheet, and one for each of several tools."""
    sheet = book.sheet("Overlap", "How much longer a tool may take when it begins before the transfer has ended.")
    sheet.print_columns = 24 if machine.alone else 25
    sheet.heading("Enter", ONE if machine.alone else SEVERAL)
    if not machine.alone:
        sheet.note(APART)
    entry = entries_of(machine.given, "overlap")
    sheet.rows(
        entry(
            "overlap_rate", "Production rate", "N", "pieces/h", "rate", "one piece a turn of the master shaft; S2: 2000"
        ),
        entry("overlap_transfer", "Transfer", "", "", "transfer.name"),
        entry("overlap_law", "its law", "", "", "transfer.law", "S2: cycloidal, CIC", choices="=law_code"),
        entry("overlap_pitch", "its stroke", "h_t", "mm", "transfer.stroke", "S2: 100 mm"),
        entry("overlap_angle", "its angle", "B_t", "°", "transfer.angle", "S2: 150°"),
        entry("overlap_smooth", "what must be continuous", "", "", "transfer.smoothness", CONTINUOUS, align="center"),
    )
    if machine.alone:
        timing_diagrams(sheet, machine, RIGHT)
        tool.declare(sheet, machine.stations[0], pieces, SECOND, BELOW_CHARTS, [rising()], workings(machine))
        return
    sums(sheet, machine)
    for station in machine.stations:
        name = f"Tool {station.number}"
        own = book.sheet(name, f"{name} and the transfer: how much longer its ways in and out may take.")
        own.print_columns = 24
        own.heading("Enter", "The rate and the transfer are entered on the sheet Overlap.")
        tool.declare(own, station, pieces, 5, 38)


def sums(sheet: Sheet, machine: OverlapView) -> None:
    """Declare what several tools come to together."""
    sheet.heading("Results")
    sheet.rows(
        result("overlap_a0", "Largest peak acceleration one after the other", "a_max", "m/s²",
               "=MAX([tools.a0])", machine.peaks[0]),
        result("overlap_a1", "Largest peak acceleration with overlap", "a_max", "m/s²",
               "=MAX([tools.a1])", machine.peaks[1]),
        result("overlap_least", "Least clearance over the cycle", "", "mm",
               "=MIN([tools.least])", machine.least, "of any tool"),
    )  # fmt: skip
    sheet.checks(rising())
    sheet.row += 1
    stations = machine.stations
    lower = [s.as_set.times_lower(s.before) for s in stations]
    peaks = [s.peaks for s in stations]
    verdicts = ["FAIL" if "FAIL" in [q.value for q in tool.checks(s)] else "OK" for s in stations]
    conditions = ",".join(f'{q.name}="OK"' for q in tool.checks(stations[0]))
    sheet.table(
        "tools", "The tools", len(stations),
        calc("name", "tool", "", "", machine.each("=@name"), [s.given.name for s in stations], align="left"),
        constant("sheet", "sheet", "", "", [f"Tool {s.number}" for s in stations]),
        result("in", "way in", "B_m", "°", machine.each("=@new_in"), [s.angles_set[0] for s in stations]),
        result("out", "way out", "B_m", "°", machine.each("=@new_out"), [s.angles_set[1] for s in stations]),
        result("a0", "peak, one after the other", "a_max", "m/s²", machine.each("=@a0"), [p[0] for p in peaks]),
        result("a1", "peak, with overlap", "a_max", "m/s²", machine.each("=@a1"), [p[2] for p in peaks]),
        result("ratio", "times lower", "", "", machine.each("=@ratio"), lower),
        result("least", "least clearance", "", "mm", machine.each("=@least"), [s.least for s in stations]),
        Quantity("ok", "its checks", role="check", formula=machine.each(f'=IF(AND({conditions}),"OK","FAIL")'),
                 value=verdicts),
    )  # fmt: skip
    left = RIGHT + 1
    timing_diagrams(sheet, machine, left)
    for column, title, values in ((left, "one after the other", "accb"), (left + WIDE, "with overlap", "acca")):
        about = f"Acceleration of the tools over one turn of the master shaft: {title}"
        chart = Chart(f"Acceleration of the tools: {title}", "master angle θ [°]", "acceleration [m/s²]",
                      lines_of(machine, values), about, (0, 360, 30))  # fmt: skip
        sheet.chart(chart, column, SECOND, WIDE, 18)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(*workings(machine))


def rising() -> Quantity:
    """Return the check of the one law that may move backwards: the engineer's own."""
    return check("overlap_ok_rises", "The laws never move backwards", "MIN([used.low])>=0-check_zero", True,
                 "only a law that rises throughout can be inverted", ":rises", f'"{BACKWARDS}"')  # fmt: skip


def workings(machine: OverlapView) -> tuple[Quantity, ...]:
    """Return the workings that all tools share."""
    return (
        calc("overlap_tc", "Time of one turn", "t_c", "s",
             "=3600/overlap_rate", movement_time(FULL_TURN, machine.rate), "3600 / N"),
        calc("overlap_eps", "Tolerance of an angle", "ε", "°", "=360*break_eps", shown(ANGLE_TOLERANCE, DEGREE),
             "an angle this close to an event is taken as the event", format="0E+00"),
        calc("overlap_w", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()/overlap_tc", shaft_speed(machine.rate), "2π/t_c"),
    )  # fmt: skip


def timing_diagrams(sheet: Sheet, machine: OverlapView, column: int) -> None:
    """Place both timing diagrams side by side: a lane for the transfer, and above it one for each tool."""
    top = len(machine.stations) + 1
    for left, title, lane in ((column, "one after the other", "lane_b"), (column + WIDE, "with overlap", "lane_a")):
        moved = Series("=overlap_transfer", "[tool1_motions.theta]", "[tool1_motions.lane_t]")
        line = Series("angle of the picture", "[view_line.theta]", "[view_line.height]", dashed=True, color="7F7F7F")
        about = f"Timing diagram of transfer and tools over one turn of the master shaft: {title}"
        chart = Chart(f"Timing diagram: {title}", "master angle θ [°]", "", (moved, *lines_of(machine, lane), line),
                      about, (0, 360, 30), (0, top, 1), lanes=True)  # fmt: skip
        sheet.chart(chart, left, 5, WIDE, 18)


def lines_of(machine: OverlapView, column: str) -> tuple[Series, ...]:
    """Return a line over the cycle for each tool, in the same colour in every chart; the transfer has the first."""
    return tuple(
        Series("=@name", "[@motions.theta]", f"[@motions.{column}]", color=COLOURS[s.number]).within(s.scope)
        for s in machine.stations
    )
