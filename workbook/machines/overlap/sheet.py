"""The Overlap sheet: transfer and timing diagrams; all of a single tool; of several, a sheet each, their sum."""

from engine.overlap.schedule import ANGLE_TOLERANCE, movement_time
from engine.timing import FULL_TURN, shaft_speed
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import COLOURS, Chart, Series
from workbook.book.declare import Book, Quantity, Sheet
from workbook.entries.facts import entry_cells
from workbook.fields.units import DEGREE, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap import tool
from workbook.machines.overlap.view import BACKWARDS, OverlapView

CELLS = cell_tables(__file__)

BELOW_CHARTS = 45  # the row from which the sheet is free in its whole width
RIGHT, SECOND = 11, 24  # the column of charts beside the entries, and the row of the second two
WIDE = 4  # columns of a chart
ONE = "The transfer brings the part and begins at 0°; the tool goes in, dwells at the part and goes out again."
SEVERAL = "The transfer brings the parts and begins at 0°; each tool goes in, dwells and goes out again."
APART = "The tools work at stations of their own: each meets the transfer, never another tool."


def overlap_sheet(book: Book, machine: OverlapView, pieces: Pieces) -> None:
    """Declare the sheet, and for several tools a sheet each."""
    sheet = book.sheet("Overlap", "How much longer a tool may take when it begins before the transfer has ended.")
    sheet.print_columns = 18 if machine.alone else 19
    sheet.heading("Enter", ONE if machine.alone else SEVERAL)
    if not machine.alone:
        sheet.note(APART)
    sheet.rows(*entry_cells(machine.given, "overlap"))
    if machine.alone:
        timing_diagrams(sheet, machine, RIGHT)
        tool.declare(sheet, machine.stations[0], pieces, SECOND, BELOW_CHARTS, [rising()], workings(machine))
        return
    sums(sheet, machine)
    for station in machine.stations:
        name = f"Tool {station.number}"
        own = book.sheet(name, f"{name} and the transfer: how much longer its ways in and out may take.")
        own.print_columns = 18
        own.heading("Enter", "The rate and the transfer are entered on the sheet Overlap.")
        tool.declare(own, station, pieces, 5, 38)


def sums(sheet: Sheet, machine: OverlapView) -> None:
    """Declare the figures of several tools together."""
    sheet.heading("Results")
    cell = CELLS["sums"]
    sheet.rows(
        cell("overlap_a0", machine.peaks[0]), cell("overlap_a1", machine.peaks[1]), cell("overlap_least", machine.least)
    )
    sheet.checks(rising())
    sheet.row += 1
    stations = machine.stations
    lower = [s.as_set.times_lower(s.before) for s in stations]
    before, _, after = zip(*(s.peaks for s in stations), strict=True)
    ways_in, ways_out = zip(*(s.angles_set for s in stations), strict=True)
    verdicts = ["FAIL" if "FAIL" in [q.value for q in tool.checks(s)] else "OK" for s in stations]
    conditions = ",".join(f'{q.name}="OK"' for q in tool.checks(stations[0]))
    cell = CELLS["tools"]
    cell.place(
        sheet,
        cell("name", [s.given.name for s in stations], formula=machine.each("=@name")),
        cell("sheet", [f"Tool {s.number}" for s in stations]),
        cell("in", ways_in, formula=machine.each("=@new_in")),
        cell("out", ways_out, formula=machine.each("=@new_out")),
        cell("a0", before, formula=machine.each("=@a0")),
        cell("a1", after, formula=machine.each("=@a1")),
        cell("ratio", lower, formula=machine.each("=@ratio")),
        cell("least", [s.least for s in stations], formula=machine.each("=@least")),
        Quantity(
            "ok",
            "its checks",
            role="check",
            formula=machine.each(f'=IF(AND({conditions}),"OK","FAIL")'),
            value=verdicts,
        ),
    )
    left = RIGHT + 1
    timing_diagrams(sheet, machine, left)
    for column, title, values in ((left, "one after the other", "accb"), (left + WIDE, "with overlap", "acca")):
        about = f"Acceleration of the tools over one turn of the master shaft: {title}"
        chart = Chart(
            f"Acceleration of the tools: {title}",
            "master angle θ [°]",
            "acceleration [m/s²]",
            lines_of(machine, values),
            about,
            (0, 360, 30),
        )
        sheet.chart(chart, column, SECOND, WIDE, 18)
    sheet.row = max(sheet.row, BELOW_CHARTS)
    sheet.not_printed_below()
    sheet.heading("Workings")
    sheet.rows(*workings(machine))


def rising() -> Quantity:
    """Return the check of the only law that may move backwards: the engineer's own."""
    cell = CELLS["rising"]
    return cell("overlap_ok_rises", True, backwards=BACKWARDS)


def workings(machine: OverlapView) -> tuple[Quantity, ...]:
    """Return the workings that all tools share."""
    cell = CELLS["workings"]
    return (
        cell("overlap_tc", movement_time(FULL_TURN, machine.rate)),
        cell("overlap_eps", shown(ANGLE_TOLERANCE, DEGREE)),
        cell("overlap_w", shaft_speed(machine.rate)),
    )


def timing_diagrams(sheet: Sheet, machine: OverlapView, column: int) -> None:
    """Place both timing diagrams side by side: a lane for the transfer, and above it a lane for each tool."""
    top = len(machine.stations) + 1
    for left, title, lane in ((column, "one after the other", "lane_b"), (column + WIDE, "with overlap", "lane_a")):
        moved = Series("=overlap_transfer", "[tool1_motions.theta]", "[tool1_motions.lane_t]")
        line = Series("angle of the picture", "[view_line.theta]", "[view_line.height]", dashed=True, color="7F7F7F")
        about = f"Timing diagram of transfer and tools over one turn of the master shaft: {title}"
        chart = Chart(
            f"Timing diagram: {title}",
            "master angle θ [°]",
            "",
            (moved, *lines_of(machine, lane), line),
            about,
            (0, 360, 30),
            (0, top, 1),
            lanes=True,
            in_short=lane == "lane_a",
        )
        sheet.chart(chart, left, 5, WIDE, 18)


def lines_of(machine: OverlapView, column: str) -> tuple[Series, ...]:
    """Return a line over the cycle for each tool, in the same colour in every chart; the transfer has the first."""
    return tuple(
        Series("=@name", "[@motions.theta]", f"[@motions.{column}]", color=COLOURS[s.number]).within(s.scope)
        for s in machine.stations
    )
