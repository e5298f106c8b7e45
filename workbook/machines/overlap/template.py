"""Overlap of motions (S2): the indexing mill and its tools, one after the other and with overlap."""

from engine.cams.profile import CamProfile, profile_of, turned
from engine.motion.shifted import Shifted
from engine.overlap.schedule import pieces_of_parts, size_of_parts
from engine.timing import FULL_TURN
from workbook.axes import CamAxis
from workbook.book.declare import Book, Quantity, result
from workbook.book.summary import summary_sheet
from workbook.entries.rules import limits
from workbook.entries.units import DEGREE, MM, shown
from workbook.laws.library import laws
from workbook.laws.sampling import Pieces
from workbook.laws.shelf import LAW_SIZES, LawShelf
from workbook.machines.overlap.check import check
from workbook.machines.overlap.cycle import cycle_sheets, tool_rows, transfer_rows
from workbook.machines.overlap.entries import IndexingOverlap
from workbook.machines.overlap.inverse import inverse_sheet
from workbook.machines.overlap.picture import picture_sheet
from workbook.machines.overlap.sheet import overlap_sheet
from workbook.machines.overlap.variations import variants
from workbook.machines.overlap.view import Overlapping, Station, laid_out
from workbook.motion.exported import Exportable, Later, export_sheet
from workbook.template import Template, finish

PRINTED = ("S2: 4.154 m/s²", "S2: 0.804 m/s²", "S2: 5.17")  # what S2 prints beside the first sheet's results
UNITS = ("°", "mm", "mm/°", "mm/°²")


def declare(given: IndexingOverlap) -> Book:
    """Declare the book."""
    shelf = LawShelf(given.laws, given.sizes)
    view = Overlapping(given, shelf.laws)
    book = Book(given.template, given.title, limit=limits(type(given)))
    about = "Motions of one machine, one after the other and with overlap: how much the acceleration falls."
    summary_sheet(book, given, about, in_short(view))
    overlap_sheet(book, view, shelf.stack)
    picture_sheet(book, view, shelf.stack)
    cycle_sheets(book, view, shelf.stack)
    inverse_sheet(book, view, shelf.stack)
    shelf.sheets(book)
    export_sheet(book, given, exportables(view, shelf.stack))
    return finish(book, ("S2", "S1", "S3"))


def in_short(view: Overlapping) -> list[Quantity]:
    """Return the results of the first sheet: those of the tool, or the worst of several."""
    which, of = ("Peak", "tool1") if view.alone else ("Largest peak", "overlap")
    before, after, lower = PRINTED if view.alone else ("", "", "")
    first = view.stations[0]
    ratio = result("about_ratio", "The acceleration falls by a factor of", "", "", "=tool1_ratio",
                   first.as_set.times_lower(first.before), source=lower)  # fmt: skip
    return [
        result("about_a0", f"{which} acceleration one after the other", "a_max", "m/s²", f"={of}_a0", view.peaks[0],
               source=before),
        result("about_a1", f"{which} acceleration with overlap", "a_max", "m/s²", f"={of}_a1", view.peaks[1],
               source=after),
        *([ratio] if view.alone else []),
        result("about_least", "Least clearance over the cycle", "", "mm", f"={of}_least", view.least),
    ]  # fmt: skip


def exportables(view: Overlapping, pieces: Pieces) -> list[Exportable]:
    """Return the transfer and each tool as it is set, as the sheet Export may have them."""
    unit = shown(1.0, DEGREE), shown(1.0, MM)  # one of the pieces' x and y in these
    transfer = Exportable("transfer", '="transfer"', transfer_rows(view, pieces), UNITS, unit, "*1000",
                          size_of_parts(view.transfer.parts))  # fmt: skip
    found = [transfer]
    for station in view.stations:
        plan, rows = station.as_set, tool_rows(station, "a", pieces)
        later = Later("[@schedules.there.3]", "overlap_eps", "", Shifted(plan.motion, plan.arrival).unshifted, 0.0)
        found.append(Exportable(station.given.name, "=@name", rows, UNITS, unit, "*1000", size_of_parts(plan.parts),
                                later, station.scope))  # fmt: skip
    return found


def axes(machine: IndexingOverlap) -> list[CamAxis]:
    """Return the transfer, which goes on every turn, and each tool as it is set."""
    found = Overlapping(machine, laws(machine.laws))
    x, y = shown(1.0, DEGREE), shown(1.0, MM)
    transfer = profile_of(pieces_of_parts(found.transfer.parts, whole=True), FULL_TURN, x, y)
    tools = [CamAxis(one.given.name, set_profile(one), "°", "mm") for one in found.stations]
    return [CamAxis("transfer", transfer, "°", "mm"), *tools]


def set_profile(station: Station) -> CamProfile:
    """Return a tool's profile as the master shaft sees it."""
    schedule = station.as_set
    fixed = profile_of(pieces_of_parts(schedule.parts, whole=True), FULL_TURN, shown(1.0, DEGREE), shown(1.0, MM))
    return turned(fixed, shown(schedule.arrival, DEGREE))


SIZES = {"cycle": ("tool1_motions", 1), "margins": ("tool1_margins", 1), "motion_pieces": ("tool1_a_pieces", 0)}
TEMPLATE = Template("indexing-overlap", IndexingOverlap, declare, variants, LAW_SIZES | SIZES, check, laid_out, axes)
