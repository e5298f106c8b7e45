"""The Inverse sheet: at which share of its time a law has reached a share of its rise, for any law of the book.

Each law in use has a table of points, closer towards the ends of its pieces. A height lies between two of them; the
share of time is that of a motion with constant acceleration from the one to the other, corrected once by what is then
missing at the velocity that the law has there. Behind it stands how near to its height the law is at that time.
"""

from typing import Any, NamedTuple

import numpy as np

from engine.laws import Law
from engine.laws.base import Array
from engine.laws.inverse import HEIGHT, INTERVALS, REST, inversion_points, law_pieces, point_inversion
from engine.laws.points import slowest
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, result
from workbook.book.sentence import amount
from workbook.fields.units import MM, PERCENT, shown
from workbook.laws.sampling import Pieces
from workbook.machines.overlap.view import OverlapView
from workbook.motion.cells import FIRST, last_before

ABOUT = (
    "Between two points of a law as if its acceleration were constant, then corrected once by what is missing at the "
    "velocity there. Within 1e-6 of the rise; within 0.01 % of the time, nearer than 0.001 % to an end 1 %."
)
NEAR = "=IF([ds]<=break_eps,[x0],IF([wanted]>=[s1]-break_eps,[x1],[x0]+2*[ds]/([v0]+SQRT([v0]^2+2*[acc]*[ds]))))"


class InversionTable(NamedTuple):
    """The rows of one table: which of the laws in use, its heights s, and the columns that say where they come from."""

    name: str
    title: str
    use: int
    law: Law
    s: Array
    formula: Any
    head: tuple[Quantity, ...]

    @property
    def residual(self) -> Array:
        """How far the law is from its heights at the shares of time found for them."""
        return self.law.s(point_inversion(self.law, self.s).xi) - self.s


def inverse_sheet(book: Book, machine: OverlapView, pieces: Pieces) -> None:
    """Declare the sheet: the laws in use and their points, then tables for the transfer and two for each tool."""
    sheet = book.sheet(
        "Inverse", "Each law inverted: the share of time ξ at which it has reached a share s of its rise."
    )
    wanted = all_wanted(machine)
    worst = max(float(np.abs(one.residual).max()) for one in wanted)
    sheet.heading("Results", ABOUT)
    sheet.rows(
        result("inverse_residual", "Largest residual", "|s(ξ) − s|", "",
               "=MAX([residuals.most])", worst, "of the rise, in all tables below", format="0.0E+00"),
        constant("inverse_bound", "Heights are met to", "", "",
                 HEIGHT, "of the rise; of 100 mm, 0.1 µm", format="0E+00"),
        constant("inverse_slow", "Slower than this: no correction", "v_0", "",
                 REST, "beside a point at which the law rests", format="0E+00"),
    )  # fmt: skip
    sheet.checks(
        check("inverse_ok", "Inverse: every height is met", "inverse_residual<=inverse_bound", worst <= HEIGHT,
              "S2 reads 38 % at 44 % from a table",
              says=amount("inverse_residual*100", shown(worst, PERCENT), "missed by ", " % of the rise")),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "residuals", "How far the laws are from the heights wanted", len(wanted),
        constant("what", "law", "", "", [one.title for one in wanted], align="left"),
        calc("most", "largest residual", "", "",
             [f"=MAX(MAX([{one.name}_met.residual]),0-MIN([{one.name}_met.residual]))" for one in wanted],
             [float(np.abs(one.residual).max()) for one in wanted], format="0.0E+00"),
    )  # fmt: skip
    laws_in_use(sheet, machine, pieces)
    for one in wanted:
        inversion(sheet, one, pieces)
    for one in wanted:
        points(sheet, one, pieces)


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
        head = (
            constant("k", "row", "k", "", list(range(n + 2)), "0: as entered; then the table of margins"),
            calc("margin", "margin", "", "mm",
                 f"=IF([k]=0,{scope}margin,INDEX([{scope}margins.margin],MAX([k],1)))", shown(margins, MM)),
        )  # fmt: skip
        of_tools += [
            InversionTable(f"{scope}inverse_in", f"{name}, way in", row_in, tool.law, gone, f"={formula}", head),
            InversionTable(f"{scope}inverse_out", f"{name}, way out, counted in reverse", row_out, tool.out, 1 - gone,
                   f"=1-{formula}", head),
        ]  # fmt: skip
    where = constant("k", "row", "k", "", list(range(len(ends)))), constant("what", "where", "", "", ends)
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
    sheet.rows(constant("inverse_intervals", "Intervals between the points of a law", "", "", INTERVALS))
    sheet.row += 1
    sheet.table(
        "used", "The laws of transfer and tools", len(codes),
        constant("what", "motion", "", "", motions, align="left"),
        calc("code", "law", "", "", cells, codes),
        calc("no", "law number", "", "", "=MATCH([code],law_code,0)", numbers, format="0"),
        calc("first", "row of its first piece", "", "", FIRST, [pieces.first[n] for n in numbers], "on Laws",
             format="0"),
        calc("count", "pieces", "", "", f"={last_before('[no]', '1')}-[first]+1",
             [len(law_pieces(law)) for law in laws], "that begin before its end", format="0"),
        calc("n", "intervals on each piece", "n", "", "=INT(inverse_intervals/[count])",
             [inversion_points(law).n for law in laws], format="0"),
        calc("low", "lowest velocity", "", "", "=INDEX(law_v_low,[no])", [slowest(law) for law in laws]),
        calc("ca", "acceleration coefficient", "C_a", "", "=MAX(INDEX(law_ca_max,[no]),0-INDEX(law_ca_min,[no]))",
             [law.coefficients.ca for law in laws], "max |a|"),
    )  # fmt: skip
    sheet.row += 1


def points(sheet: Sheet, wanted: InversionTable, pieces: Pieces) -> None:
    """Declare the points of one of the laws in use."""
    at, i, number = inversion_points(wanted.law), wanted.use, pieces.number(wanted.law)
    rows = [pieces.first[number] + p - 1 for p in at.piece]
    n, count = f"[used.n.{i}]", f"[used.count.{i}]"
    sheet.table(
        f"points{i}", f"Points of the law of: {wanted.title}", len(at.xi),
        constant("k", "point", "k", "", list(range(len(at.xi)))),
        calc("p", "piece", "p", "", f"=MIN(INT([k]/{n})+1,{count})", at.piece, format="0"),
        calc("share", "share of the piece", "", "", f"=IF([k]>={n}*{count},1,(1-COS(PI()*([k]/{n}-[p]+1)))/2)",
             at.share, "(1 − cos(πi/n))/2: closer towards its ends"),
        calc("m", "row on Laws", "", "", f"=[used.first.{i}]+[p]-1", rows, format="0"),
        calc("xi", "share of time", "ξ", "", "=INDEX(piece_xi,[m])+[share]*INDEX(piece_d,[m])", at.xi,
             "begin of the piece and its share"),
        *pieces.finding(f"[used.no.{i}]", number, "xi", at.xi),
        *pieces.columns({"s": at.s, "v": at.v}, "sv"),
    )  # fmt: skip
    sheet.row += 1


def inversion(sheet: Sheet, wanted: InversionTable, pieces: Pieces) -> None:
    """Declare, for each height, its share of time; then the residual there."""
    law, found, i = wanted.law, point_inversion(wanted.law, wanted.s), wanted.use
    number, low, high = pieces.number(law), found.low, found.high

    def at(column: str, row: str) -> str:
        return f"=INDEX([points{i}.{column}],{row})"

    sheet.table(
        wanted.name, wanted.title, len(wanted.s),
        *wanted.head,
        calc("wanted", "height wanted", "s", "", wanted.formula, wanted.s),
        result("xi", "share of time", "ξ", "", "=IF([wanted]<=0,0,IF([wanted]>=1,1,[near]+[more]))", found.xi,
               "s(ξ) = s", format="0.00000000"),
        calc("k0", "point below", "", "", f"=MATCH(MIN([wanted]+break_eps,1-break_eps),[points{i}.s],1)",
             found.point, "last not above s", format="0"),
        calc("x0", "its share of time", "ξ", "", at("xi", "[k0]"), low.xi),
        calc("x1", "that of the next", "ξ", "", at("xi", "[k0]+1"), high.xi),
        calc("s0", "its height", "s", "", at("s", "[k0]"), low.s),
        calc("s1", "that of the next", "s", "", at("s", "[k0]+1"), high.s),
        calc("ds", "from the point to the height", "Δs", "", "=[wanted]-[s0]", found.over),
        calc("v0", "its velocity", "v", "", at("v", "[k0]"), low.v),
        calc("v1", "that of the next", "v", "", at("v", "[k0]+1"), high.v),
        calc("acc", "acceleration between", "a", "", "=2*([s1]-[s0]-[v0]*([x1]-[x0]))/([x1]-[x0])^2",
             found.acceleration, "as if constant: 2(Δs − vΔξ)/Δξ²"),
        calc("near", "share of time by it", "ξ", "", NEAR, found.near, "2Δs/(v + √(v² + 2aΔs)) after the point"),
        *pieces.finding(f"[used.no.{i}]", number, "near", found.near),
        *pieces.columns({"s": found.s, "v": found.v}, "sv"),
        calc("more", "correction", "Δξ", "", "=IF(MIN([v0],[v1])>inverse_slow,([wanted]-[s])/[v],0)",
             found.correction, "what is missing of s, over the velocity"),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        f"{wanted.name}_met", f"{wanted.title}: the law at these shares of time", len(wanted.s),
        wanted.head[0],
        calc("xi", "share of time", "ξ", "", f"=INDEX([{wanted.name}.xi],[k]+1)", found.xi),
        *pieces.finding(f"[used.no.{i}]", number, "xi", found.xi),
        *pieces.columns({"s": law.s(found.xi)}, "s"),
        calc("residual", "residual", "s(ξ) − s", "", f"=[s]-INDEX([{wanted.name}.wanted],[k]+1)", wanted.residual,
             "how far the law is from the height wanted", format="0.0E+00"),
    )  # fmt: skip
    sheet.row += 1
