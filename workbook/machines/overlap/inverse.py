"""The Inverse sheet: at which share of its time a law has reached a share of its rise, for any law of the book.

Each law in use has a table of points, closer towards the ends of its pieces. A height lies between two of them; the
share of time is that of a motion with constant acceleration between them, corrected once by what is then
missing at the velocity that the law has there. Behind it stands the law's distance from its height at that time.
"""

from typing import Any, NamedTuple

import numpy as np

from engine.laws import Law
from engine.laws.base import Array
from engine.laws.inverse import HEIGHT, INTERVALS, REST, inversion_points, law_pieces, point_inversion
from engine.laws.points import slowest
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.sentence import amount
from workbook.fields.units import MM, PERCENT, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap.view import OverlapView
from workbook.motion.cells import FIRST, last_before

CELLS = cell_tables(__file__)


class InversionTable(NamedTuple):
    """The rows of a table: the number of its law in use, the heights s, and the columns of their origin."""

    name: str
    title: str
    use: int
    law: Law
    s: Array
    formula: Any
    head: tuple[Quantity, ...]

    @property
    def residual(self) -> Array:
        """The distances of the law from its heights at the inverted shares of time."""
        return self.law.s(point_inversion(self.law, self.s).xi) - self.s


def inverse_sheet(book: Book, machine: OverlapView, pieces: Pieces) -> None:
    """Declare the sheet: the laws in use and their points, then tables for the transfer and two for each tool."""
    sheet = book.sheet(
        "Inverse", "Each law inverted: the share of time ξ at which it has reached a share s of its rise."
    )
    sheet.unprinted = True
    wanted = all_wanted(machine)
    most = [float(np.abs(table.residual).max()) for table in wanted]
    worst = max(most)
    CELLS["inverse_sheet"].begin(sheet)
    cell = CELLS["inverse_sheet"]
    sheet.rows(cell("inverse_residual", worst), cell("inverse_bound", HEIGHT), cell("inverse_slow", REST))
    missed = amount("inverse_residual*100", shown(worst, PERCENT), "missed by ", " % of the rise")
    sheet.checks(cell("inverse_ok", worst <= HEIGHT, says=missed))
    sheet.row += 1
    cell = CELLS["residuals"]
    cell.place(
        sheet,
        cell("what", [table.title for table in wanted]),
        cell("most", most, name=[table.name for table in wanted]),
    )
    laws_in_use(sheet, machine, pieces)
    for table in wanted:
        inversion(sheet, table, pieces)
    for table in wanted:
        points(sheet, table, pieces)


def all_wanted(machine: OverlapView) -> list[InversionTable]:
    """Return the tables of inversions: where the transfer leaves its place and comes to it, how far a tool may go."""
    shares: list[float] = []
    formulas, ends, of_tools = [], [], []
    for station in machine.stations:
        tool, p, n, scope = station.tool, station.passage, machine.sizes.margins, station.scope
        whose, name = ("", "Tool") if machine.alone else (f"tool {station.number}: ", f"Tool {station.number}")
        shares += p.shares
        formulas += [f"={scope}remaining/100", f"=1-{scope}remaining/100"]
        ends += [f"{whose}has left its place", f"{whose}comes to its place"]
        margins, (row_in, row_out) = np.array([p.margin, *station.margins.margin]), station.law_rows
        gone = p.travelled_share(tool.stroke, margins)
        formula = f"MIN(({scope}clearance-[margin])/{scope}stroke,1)"
        cell = CELLS["tool"]
        head = (cell("k", list(range(n + 2))), cell("margin", shown(margins, MM), scope=scope))
        of_tools += [
            InversionTable(f"{scope}inverse_in", f"{name}, way in", row_in, tool.law, gone, f"={formula}", head),
            InversionTable(
                f"{scope}inverse_out",
                f"{name}, way out, counted in reverse",
                row_out,
                tool.out,
                1 - gone,
                f"=1-{formula}",
                head,
            ),
        ]
    where = CELLS["transfer"]("k", list(range(len(ends)))), CELLS["transfer"]("what", ends)
    moved, title = machine.transfer.law, "Transfer: where it is in the way"
    return [InversionTable("inverse_transfer", title, 1, moved, np.array(shares), formulas, where), *of_tools]


def laws_in_use(sheet: Sheet, machine: OverlapView, pieces: Pieces) -> None:
    """Declare the laws: number, where their pieces stand, and how many points each piece has."""
    motions, cells, codes = ["transfer"], ["=overlap_law"], [machine.given.transfer.law]
    for station in machine.stations:
        whose = "tool" if machine.alone else f"tool {station.number}"
        motions += [f"{whose}, way in", f"{whose}, way out"]
        cells += [f"={station.scope}law_in", f"={station.scope}law_out"]
        codes += [station.given.law_in, station.given.law_out]
    laws = [machine.library[code] for code in codes]
    numbers = [pieces.number(law) for law in laws]
    sheet.heading("Workings: the laws in use")
    sheet.rows(CELLS["laws_in_use"]("inverse_intervals", INTERVALS))
    sheet.row += 1
    cell = CELLS["used"]
    cell.place(
        sheet,
        cell("what", motions),
        cell("code", codes, formula=cells),
        cell("no", numbers),
        cell("first", [pieces.first[n] for n in numbers], formula=FIRST),
        cell("count", [len(law_pieces(law)) for law in laws], last_before=last_before("[no]", "1")),
        cell("n", [inversion_points(law).n for law in laws]),
        cell("low", [slowest(law) for law in laws]),
        cell("ca", [law.coefficients.ca for law in laws]),
    )
    sheet.row += 1


def points(sheet: Sheet, wanted: InversionTable, pieces: Pieces) -> None:
    """Declare the points of a law in use."""
    cell = CELLS["points"]
    at, i, number = inversion_points(wanted.law), wanted.use, pieces.number(wanted.law)
    rows = [pieces.first[number] + p - 1 for p in at.piece]
    n, count = f"[used.n.{i}]", f"[used.count.{i}]"
    cell.sharing(i=i, title=wanted.title).place(
        sheet,
        cell("k", list(range(len(at.xi)))),
        cell("p", at.piece, n=n, count=count),
        cell("share", at.share, n=n, count=count),
        cell("m", rows, i=i),
        cell("xi", at.xi),
        *pieces.finding(f"[used.no.{i}]", number, "xi", at.xi),
        *pieces.columns({"s": at.s, "v": at.v}, "sv"),
    )
    sheet.row += 1


def inversion(sheet: Sheet, wanted: InversionTable, pieces: Pieces) -> None:
    """Declare, for each height, its share of time; then the residual there."""
    law, inverse, i = wanted.law, point_inversion(wanted.law, wanted.s), wanted.use
    number, low, high = pieces.number(law), inverse.low, inverse.high
    size = max(1.0, 2e-6 / float((high.xi - low.xi).min()) ** 2)  # of a law, or a millionth of 2/Δξ², as heights round
    cell = CELLS["inversion"]
    cell.sharing(name=wanted.name, title=wanted.title).place(
        sheet,
        *wanted.head,
        cell("wanted", wanted.s, formula=wanted.formula),
        cell("xi", inverse.xi),
        cell("k0", inverse.point, i=i),
        cell("x0", low.xi, i=i),
        cell("x1", high.xi, i=i),
        cell("s0", low.s, i=i),
        cell("s1", high.s, i=i),
        cell("ds", inverse.over),
        cell("v0", low.v, i=i),
        cell("v1", high.v, i=i),
        cell("acc", inverse.acceleration, scale=size),
        cell("near", inverse.near),
        *pieces.finding(f"[used.no.{i}]", number, "near", inverse.near),
        *pieces.columns({"s": inverse.s, "v": inverse.v}, "sv"),
        cell("more", inverse.correction),
    )
    sheet.row += 1
    cell = CELLS["heights met"]
    cell.sharing(name=wanted.name, title=wanted.title).place(
        sheet,
        wanted.head[0],
        cell("xi", inverse.xi, name=wanted.name),
        *pieces.finding(f"[used.no.{i}]", number, "xi", inverse.xi),
        *pieces.columns({"s": law.s(inverse.xi)}, "s"),
        cell("residual", wanted.residual, name=wanted.name),
    )
    sheet.row += 1
