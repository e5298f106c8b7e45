"""Overlap of motions (S2): the indexing mill and its tools, in sequence and with overlap."""

from typing import Any

from engine.motion.profile import profile_of
from engine.motion.shifted import Shifted
from engine.overlap.schedule import pieces_of_parts, size_of_parts
from engine.timing import FULL_TURN
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book
from workbook.book.public_names import names_in, names_sheet, place_names
from workbook.book.summary import summary_sheet
from workbook.entries.facts import vary
from workbook.entries.phase import TURN
from workbook.entries.rules import limits
from workbook.fields.units import DEGREE, MM, shown
from workbook.law_sheets import library
from workbook.law_sheets.book_laws import BookLaws
from workbook.laws.sampling import Pieces
from workbook.machines.overlap.cycle import OF_TOOL, TRANSFER, cycle_sheets, rows_of
from workbook.machines.overlap.entries import IndexingOverlap, OverlapEntry, ToolEntry
from workbook.machines.overlap.inverse import inverse_sheet
from workbook.machines.overlap.picture import picture_sheet
from workbook.machines.overlap.sheet import overlap_sheet
from workbook.machines.overlap.view import OverlapView, check
from workbook.motion.exported import Exportable, ShiftCells, export_sheet
from workbook.template import Template, finish
from workbook.template_outputs import CamAxis

CELLS = cell_tables(__file__)

# what S2 prints beside the first sheet's results
PRINTED = ("S2: 4.154 m/s²", "S2: 0.804 m/s²", "S2: 5.17")
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
    before, after, lower = PRINTED if view.alone else ("", "", "")
    times = view.stations[0].as_set.times_lower(view.stations[0].before)
    ratio = cell("about_ratio", times, source=lower)
    summary_sheet(
        book,
        given,
        about,
        [
            cell("about_a0", view.peaks[0], which=which, of=of, source=before),
            cell("about_a1", view.peaks[1], which=which, of=of, source=after),
            *([ratio] if view.alone else []),
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
    entries["transfer"]["law"] = library.law_for(turn, data["laws"])
    for i, tool in enumerate(entries["tools"]):
        vary(tool, ToolEntry, turn + i)
        tool |= {f"law_{way}": library.law_for(turn + 2 * i + n, data["laws"]) for way, n in (("in", 2), ("out", 5))}
    codes = [entries["transfer"]["law"], *(tool[law] for tool in entries["tools"] for law in ("law_in", "law_out"))]
    for name in set(library.own_in(data["laws"])) & set(codes):
        data["laws"][name]["pieces"] = library.RISING
    return data


VARIED = library.varying(IndexingOverlap, varied)
TEMPLATE = Template("indexing-overlap", IndexingOverlap, declare, VARIED, check, axes)
