"""An own law in cells: its extremes by nine points of Gauss and Lobatto a piece, by how much it misses rise and rest.

A point's row has the extreme that lies between it and the point before, by the parabola of both slopes where the slope
changes its sign.
"""

from collections.abc import Sequence

from engine import laws as engine
from engine.laws import Law
from engine.laws.pieces import ALIKE, Groups, groups, misses
from engine.laws.points import SLOPES, Points
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import SHARES, WEIGHTS, filled
from workbook.laws.sampling import Pieces

CELLS = cell_tables(__file__)

OWN_ENTRIES = ("d", "c0", "c1", "c2", "c3", "P", "omega", "phi")  # what is entered of a piece
WORDS = {"s": "position", "v": "velocity", "a": "acceleration", "j": "jerk", "va": "v·a"}


def extremes(at: Points) -> list[Quantity]:
    """Return the rows of the extremes, of where v is largest, and of its greatest step the wrong way."""
    cell = CELLS["extremes"]
    rows: list[Quantity] = []
    for what, words in WORDS.items():
        low, high = at.extremes(what)
        rows.append(cell("@{what}_most", high, what=what, words=words))
        rows.append(cell("@{what}_least", low, what=what, words=words))
    return [*rows, cell("@v_at", at.peak), cell("@back", float(at.wrong_way.max()))]


def points_table(sheet: Sheet, at: Points, first: int, stack: Pieces) -> None:
    """Declare the table of points; ``first`` is the row of the law's first piece in the stack."""
    cell = CELLS["points"]
    rates, p = at.rates, at.piece + 1
    angles = at.angles[: 1 + stack.second_sine]
    sheet.table(
        "@points",
        "Nine points on each piece, both its ends among them",
        len(p),
        cell("p", p.tolist()),
        cell("share", list(SHARES) * len(at.pieces)),
        cell("weight", list(WEIGHTS) * len(at.pieces)),
        cell("part", at.part),
        cell("xi", at.xi),
        cell("q", p + (first - 1.0)),
        *stack.within("=[share]*INDEX([@pieces.d],[p])", "share of the duration", at.u, *angles, entries=OWN_ENTRIES),
        *stack.columns(rates, "svaj", entries=OWN_ENTRIES),
        cell("b", rates["b"]),
        cell("va", rates["va"]),
        cell("g", rates["g"]),
        *(cell("top_{f}", at.local_extremes(f), f=f, g=g) for f, g in SLOPES.items()),
        cell("fast", at.fastest_xi),
        cell("back", at.wrong_way),
    )


def missing(sheet: Sheet, law: Law, n: int) -> None:
    """Declare by how much the law misses its rise and rest, and the entries scaled so that it does not."""
    pieces = filled(law.as_pieces(), n, engine.Piece(0.0))
    cell, grouped, off = CELLS["missing"], groups(pieces), misses(pieces)
    up, down = grouped.factors
    sheet.row += 1
    sheet.heading("By how much it misses", "And its entries scaled so that it reaches 1 at rest.")
    sheet.rows(
        cell("@miss_s", off.s),
        cell("@miss_v", off.v),
        cell("@mends", "yes" if grouped.mends else "no: it should speed up, then slow down"),
        cell("@up", up),
        cell("@down", down),
        *sums(grouped),
    )
    title = "The entries scaled: durations, frequencies and phases stay"
    sheet.table("@mend", title, n, *mended(pieces, grouped), blank='INDEX([@pieces.d],[k])=""')


def mended(pieces: Sequence[engine.Piece], grouped: Groups) -> list[Quantity]:
    """Return the columns of the entries scaled by the factor of each piece's group, and of what a piece adds."""
    cell, (up, down) = CELLS["mend"], grouped.factors
    factors = [down if slow else up for slow in grouped.slows]

    def scaled(name: str, values: Sequence[float]) -> Quantity:
        return cell(name, [factor * value for factor, value in zip(factors, values, strict=True)])

    return [
        cell("k", list(range(1, len(pieces) + 1))),
        *(scaled(f"c{i}", [piece.c[i] for piece in pieces]) for i in range(4)),
        scaled("P", [piece.amplitude for piece in pieces]),
        cell("factor", factors),
        cell("gain_v", [v for _, v in grouped.gained]),
        cell("gain_s", [s for s, _ in grouped.gained]),
        cell("d", [piece.duration for piece in pieces]),
        cell("size", grouped.sizes),
        cell("slow", [float(slow) for slow in grouped.slows]),
    ]


def sums(grouped: Groups) -> list[Quantity]:
    """Return the rows of the sums over the pieces of each group, and the limits below which they count as none."""
    cell = CELLS["sums"]
    return [
        cell("@least", grouped.least),
        cell("@alike", ALIKE),
        cell("@s_up", grouped.s1),
        cell("@v_up", grouped.v1),
        cell("@s_down", grouped.s2),
        cell("@v_down", grouped.v2),
        cell("@under", grouped.under),
        cell("@least_under", grouped.least_under),
    ]
