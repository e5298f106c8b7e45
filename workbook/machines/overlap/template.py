"""Overlap of motions (S2): the indexing mill and its tools, in sequence and with overlap."""

from typing import Any

from engine.motion.profile import profile_of
from engine.motion.shifted import Shifted
from engine.overlap.schedule import ANGLE_TOLERANCE, movement_time, pieces_of_parts, size_of_parts
from engine.timing import FULL_TURN, shaft_speed
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import COLOURS, Chart, Series
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.public_names import names_in, names_sheet, place_names
from workbook.book.summary import summary_sheet
from workbook.entries.facts import entry_cells, vary
from workbook.entries.phase import TURN
from workbook.entries.rules import limits
from workbook.fields.units import DEGREE, MM, shown
from workbook.law_sheets import library
from workbook.law_sheets.book_laws import BookLaws
from workbook.laws.sampling import Pieces
from workbook.machines.overlap import tool
from workbook.machines.overlap.cycle import OF_TOOL, TRANSFER, cycle_sheets, rows_of
from workbook.machines.overlap.entries import IndexingOverlap, OverlapEntry, ToolEntry
from workbook.machines.overlap.inverse import inverse_sheet
from workbook.machines.overlap.picture import picture_sheet
from workbook.machines.overlap.view import BACKWARDS, OverlapView, check
from workbook.motion.exported import Exportable, ShiftCells, export_sheet
from workbook.template import Template, finish
from workbook.template_outputs import CamAxis

CELLS = cell_tables(__file__)

UNITS = ("°", "mm", "mm/°", "mm/°²")


def declare(given: IndexingOverlap) -> Book:
    """Declare the book."""
    cell = CELLS["declare"]
    book_laws = BookLaws(given.laws, given.sizes)
    view = OverlapView(given, book_laws.laws)
    book = Book(given.template, given.title, limit=limits(type(given)), print_also=given.print_also)
    book.sizes = {"°": TURN}
    about = "Motions of one machine, one after the other and with overlap: how much the acceleration falls."
    which, of = ("Peak", "tool1") if view.alone else ("Largest peak", "overlap")
    ratio = cell("about_ratio", view.stations[0].as_set.times_lower(view.stations[0].before))
    summary_sheet(
        book,
        given,
        about,
        [
            cell("about_a1", view.peaks[1], which=which, of=of),
            *([ratio] if view.alone else []),
            cell("about_a0", view.peaks[0], which=which, of=of),
            cell("about_least", view.least, of=of),
        ],
    )
    overlap_sheet(book, view, book_laws.stack)
    picture_sheet(book, view, book_laws.stack)
    cycle_sheets(book, view, book_laws.stack)
    inverse_sheet(book, view, book_laws.stack)
    book_laws.sheets(book)
    export_sheet(book, given, exportables(view, book_laws.stack))
    place_names(names_sheet(book), names_in(__file__)["Results"], "machine")
    return finish(book, ("S2", "S1", "S3"))


def exportables(view: OverlapView, pieces: Pieces) -> list[Exportable]:
    """Return the transfer and each tool as it is set, as the sheet Export may have them."""
    unit = shown(1.0, DEGREE), shown(1.0, MM)  # the units of the pieces' x and y in these
    parts = view.transfer.parts
    exported = [
        Exportable(
            "transfer", '="transfer"', rows_of(TRANSFER, parts, pieces), UNITS, unit, "*1000", size_of_parts(parts)
        )
    ]
    for station in view.stations:
        plan, rows = station.as_set, rows_of(OF_TOOL["a"], station.as_set.parts, pieces)
        later = ShiftCells("[@schedules.there.3]", "overlap_eps", "", Shifted(plan.motion, plan.arrival).unshifted, 0.0)
        exported.append(
            Exportable(
                station.given.name,
                "=@name",
                rows,
                UNITS,
                unit,
                "*1000",
                size_of_parts(plan.parts),
                later,
                station.scope,
            )
        )
    return exported


def axes(machine: IndexingOverlap) -> list[CamAxis]:
    """Return the transfer, which goes on every turn, and each tool as it is set."""
    view = OverlapView(machine, library.laws(machine.laws))
    units = (shown(1.0, DEGREE), shown(1.0, MM))
    transfer = profile_of(pieces_of_parts(view.transfer.parts, True), FULL_TURN).in_units(*units)
    cam_axes = [CamAxis("transfer", transfer, "°", "mm")]
    for station in view.stations:
        profile = profile_of(pieces_of_parts(station.as_set.parts, True), FULL_TURN).in_units(*units)
        cam_axes.append(CamAxis(station.given.name, profile.shifted(shown(station.as_set.arrival, DEGREE)), "°", "mm"))
    return cam_axes


def varied(data: dict[str, Any], turn: int) -> dict[str, Any]:
    """Return the variation of a turn."""
    k, entries = turn % library.SIX, data["overlap"]
    library.vary_laws(data["laws"], k, library.factors(k), data["sizes"]["pieces"])
    vary(entries, OverlapEntry, k)
    entries["view"] = (97.0, 0.0, 133.5, 140.0, 360.0, 41.0)[k]
    entries["transfer"]["law"] = library.pick_in_turn(turn, data["laws"])
    for i, entered in enumerate(entries["tools"]):
        vary(entered, ToolEntry, turn + i)
        entered |= {
            f"law_{way}": library.pick_in_turn(turn + 2 * i + n, data["laws"]) for way, n in (("in", 2), ("out", 5))
        }
    codes = [entries["transfer"]["law"], *(tool[law] for tool in entries["tools"] for law in ("law_in", "law_out"))]
    for name in set(library.own_in(data["laws"])) & set(codes):
        data["laws"][name]["pieces"] = library.RISING
    return data


VARIED = library.varying(IndexingOverlap, varied)
TEMPLATE = Template("indexing-overlap", IndexingOverlap, declare, VARIED, check, axes)


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
        cell("ok", verdicts, formula=machine.each(f'=IF(AND({conditions}),"OK","FAIL")')),
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
    return CELLS["rising"]("overlap_ok_rises", True, backwards=BACKWARDS)


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
    top, x = len(machine.stations) + 1, "master angle θ [°]"
    for left, way, lane in ((column, "with overlap", "lane_a"), (column + WIDE, "one after the other", "lane_b")):
        moved = Series("=overlap_transfer", "[tool1_motions.theta]", "[tool1_motions.lane_t]")
        about = f"Timing diagram of transfer and tools over one turn of the master shaft: {way}"
        lines = (moved, *lines_of(machine, lane))
        chart = Chart(f"Timing {way}", x, "", lines, about, (0, 360, 60), (0, top, 1), lanes=True)
        sheet.chart(chart, left, 5, WIDE, 18)


def lines_of(machine: OverlapView, column: str) -> tuple[Series, ...]:
    """Return a line over the cycle for each tool, in the same colour in every chart; the transfer has the first."""
    return tuple(
        Series("=@name", "[@motions.theta]", f"[@motions.{column}]", color=COLOURS[s.number]).within(s.scope)
        for s in machine.stations
    )
