"""Entries of a drive beside its mechanism and motor: load, rotating parts, process forces over the cycle."""

from collections.abc import Sequence

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.book.sentence import PLACES, Sentence, as_shown, figure
from workbook.entries.facts import entry_cells, table_of
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, KG_CM2, shown
from workbook.machines.machine import drive_entries
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.mechanisms import LINKAGES
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.timing.phases import beyond, no_fault

CELLS = cell_tables(__file__)

OF_PART = "count inertia shaft driver driven diameter length density bore".split()


def parts_and_forces(sheet: Sheet, view: DriveView) -> None:
    """Declare rotating parts, process forces and points of a mechanism: printed on request, or with other entries."""
    driven, sizes = view.driven, view.tables.machine.given.sizes
    linkage, is_full = LINKAGES.get(driven.given.kind), sheet.row > sheet.page_end + 2
    sheet.heading("Enter: parts and process forces")
    parts_table(sheet, driven, sizes.rotors)
    windows_table(sheet, f"axes.{driven.number - 1}", view)
    has_points = bool(linkage and linkage.entered)
    if linkage and linkage.entered:
        linkage.entered(sheet, driven, sizes.positions)
    is_printed = is_full or has_points or "parts" in sheet.book.print_also
    sheet.print_rows = sheet.row if is_printed else sheet.page_end


def parts_table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the rotating parts."""
    cell = CELLS["parts"]
    column = table_of(drive_entries.AxisPart).columns(driven.entered.parts, f"axes.{driven.number - 1}.parts", rows)
    turned, before = driven.parts, BEFORE.format("[all]=0")
    cell.place(
        sheet,
        column("name"),
        cell("k", list(range(1, rows + 1))),
        *map(column, OF_PART),
        cell("one", filled([shown(p.inertia, KG_CM2) for p in turned], rows)),
        cell("speed", filled([p.speed_ratio for p in turned], rows, 1.0)),
        cell("all", filled([shown(p.reflected, KG_CM2) for p in turned], rows)),
        cell("listed", so_far(parts_in_words(driven), rows), before=before, places=PLACES),
        rules=[drive_entries.SIZED, drive_entries.ALONE, drive_entries.BORED, drive_entries.GEARED],
    )


BEFORE = 'IF([k]=1,"",[listed-1]&IF(OR([listed-1]="",{}),"",", "))'
NONE = "none"


def so_far(texts: Sequence[str], rows: int) -> list[Sentence]:
    """Return in each row of a table all texts down to it, with commas between them."""
    listed = [Sentence(", ".join(filter(None, texts[: k + 1]))) for k in range(len(texts))]
    return filled(listed, rows, listed[-1] if listed else Sentence(""))


def parts_in_words(driven: Driven) -> list[str]:
    """Return count, name and inertia at its shaft of each rotating part."""
    each = zip(driven.entered.parts, driven.parts, strict=True)
    return [
        f"{figure(part.count)} × {part.name or ''} {as_shown(shown(turned.reflected, KG_CM2))}"
        if turned.reflected
        else ""
        for part, turned in each
    ]


def forces_in_words(driven: Driven) -> list[str]:
    """Return each process force as it is entered, with where it begins and ends."""
    windows = driven.axis.typed.load.windows
    return [f"{figure(w.force)} from {figure(w.start)} to {figure(w.stop)}" for w in windows]


def listed(driven: Driven) -> list[Quantity]:
    """Return rotating parts and process forces in a line each, for the page of the drive."""
    texts = [", ".join(filter(None, of(driven))) for of in (parts_in_words, forces_in_words)]
    parts, forces = (Sentence(text or NONE) for text in texts)
    unit = "N" if driven.travels else "Nm"
    cell = CELLS["listed"].sharing(none=NONE)
    return [cell("@parts_listed", parts), cell("@windows_listed", forces, unit=unit)]


def on_shaft(shaft: str) -> str:
    """Return the formula of the inertia (kg m²) of all parts on a shaft, the motor's or the mechanism's."""
    return f'SUMPRODUCT(([@parts.shaft]="{shaft}")*[@parts.all])/10000'


def loads(driven: Driven, key: str) -> list[Quantity]:
    """Return the entries of the load of this kind."""
    e, travels = driven.entered.load, driven.travels
    rows = entry_cells(e, f"{key}.load", drive_entries.lacking(travels, e.viscous))
    return [row._replace(unit=row.unit.split(" or ")[0 if travels else -1]) for row in rows]


# where a process force acts at the angle in the column ``at``
ACTS = "(([at]>=[@windows.from])*([at]<[@windows.from]+[@windows.span])+([at]+360<[@windows.from]+[@windows.span]))"


def windows_table(sheet: Sheet, key: str, view: DriveView) -> None:
    """Declare the process forces over the cycle."""
    driven, over = view.driven, view.tables.machine.over
    found, unit = driven.windows, "N" if driven.travels else "Nm"
    start = over.degrees_formula("[start]")
    stop = f"MIN(360,{over.degrees_formula('[stop]')})" if over.measured else "[stop]"
    column = table_of(drive_entries.ForceWindow).columns(
        driven.axis.typed.load.windows, f"{key}.load.windows", drive_entries.WINDOWS
    )
    late = f"[axes_taken.late.{driven.number}]"
    spans = [shown(w.end - w.begin, DEGREE) for w in found]
    spans = [span + TURN * (span < 0) for span in spans]
    rows, own = drive_entries.WINDOWS, {"format": over.format, "upper_limit": over.upper_limit}
    listed, before = so_far(forces_in_words(driven), rows), BEFORE.format('[start]=""')
    cell = CELLS["windows"].sharing(start=start, unit=unit, late=late)
    cell.place(
        sheet,
        column("start", place=over.unit, **own),
        column("stop", place=over.unit, source=over.entered_of, **own),
        column("force", unit=unit),
        column("resists"),
        cell("from", filled([w.start for w in driven.entered.load.windows], rows)),
        cell("span", filled(spans, rows), stop=stop),
        cell("always", filled([w.load.torque for w in found], rows)),
        cell("moving", filled([w.load.friction for w in found], rows)),
        cell("b", view.edges[::2], scale=360.0),
        cell("e", view.edges[1::2], scale=360.0),
        cell("listed", listed, before=before),
        *([beyond(over)] if over.measured else []),
    )


def windows_check(view: DriveView) -> Quantity:
    """Return the check that process forces end with the cycle, of which an entry says how long it is."""
    i = view.driven.number
    label = f"{view.driven.called}: no process force goes on beyond the cycle"
    return no_fault("@ok_windows", label, "[@windows.beyond]", f'[axes.name.{i}]&" process force "')
