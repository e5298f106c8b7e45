"""The sheet S4: what the document prints of its two machines beside this book's figures, and what is misprinted."""

from dataclasses import replace
from pathlib import Path

from workbook.book.cell_tables import cell_tables, markdown_rows, value_of
from workbook.book.declare import Book
from workbook.fields.texts import sheet_title
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

LOSSY = "/@i/(@eta1*@eta2)"
PARTS = {
    "lossy": LOSSY,
    "inertia": f"(@j0-@jm/10000+@j1/@i1^2/@eta1+@m/@i{LOSSY})",
    "resists": f"(@rub+@steady){LOSSY}",
    "all": "[@printed.here.3]",
    "steady": "[@printed.here.6]+@no_load",
}
"""parts of formulas of the figures; a no-load torque is no load of the document's, but the motor has to give it"""
FIGURES = list(markdown_rows(Path(__file__).with_name("printed_figures.md").read_text(encoding="utf-8")))
"""the figures of S4 by the columns of the sheet, all as texts"""


def printed_sheet(book: Book, view: DriveView) -> None:
    """Declare the sheet of an axis."""
    cell = CELLS["printed"].sharing(**view.parts)
    driven = view.driven
    m = driven.mechanism
    drive = replace(driven.train.drive, method="document")
    hardest = driven.axis.max_acceleration
    values = [
        m.load.inertia / m.inertia_divisor(m.last, "document"),
        m.inertia("document"),
        drive.total_inertia,
        *(f / m.ratio / m.efficiency for f in (m.load.friction, m.load.torque, float(m.load.resisting(1.0)))),
        driven.max_geometric_velocity * driven.axis.speed,
        view.speed,
        m.ratio * hardest,
        *(float(drive.torque(a, 1.0)) for a in (hardest, 0.0, -hardest)),
        view.points.rms_torque,
        driven.left,
    ]
    title = sheet_title(str(driven.entered.printed), [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, "The figures that the document prints, its misprints, and this book's.")
    cell.begin(sheet)
    with sheet.scoped(f"drive{driven.number}_"):
        here = [f"={figure['here'].format(**PARTS)}+0" for figure in FIGURES]
        columns = [cell(name, [value_of(figure[name]) for figure in FIGURES]) for name in FIGURES[0] if name != "here"]
        cell.place(sheet, *columns[:2], cell("here", values, formula=here), *columns[2:])
    sheet.print_columns = 15
