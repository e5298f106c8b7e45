"""An own law in cells: its extremes by nine points of Gauss and Lobatto a piece, by how much it misses rise and rest.

A point's row has the extreme that lies between it and the point before, by the parabola of both slopes where the slope
changes its sign.
"""

from collections.abc import Sequence

from engine import laws as engine
from engine.laws import Law
from engine.laws.pieces import ALIKE, Groups, groups, misses
from engine.laws.points import SLOPES, Points
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import SHARES, WEIGHTS, filled
from workbook.laws.sampling import Pieces

OWN_ENTRIES = ("d", "c0", "c1", "c2", "c3", "P", "omega", "phi")  # what is entered of a piece
CREST = (
    "=IF([part]=0,0,[{f}]+IF([share]=0,0,IF([{g}-1]*[{g}]<0-check_zero^2,"
    "[{g}]*([{f}]-[{f}-1]-[{g}-1]*([u]-[u-1])/2)/([{g}-1]-[{g}]),0)))"
)
WORDS = {"s": "position", "v": "velocity", "a": "acceleration", "j": "jerk", "va": "v·a"}
PLACE = "[xi]-IF([share]=0,0,IF([a-1]*[a]<0-check_zero^2,([u]-[u-1])*[a]/([a]-[a-1]),0))"
FAST = f"=IF([part]=0,1,IF([top_v]<@v_most-check_zero,1,{PLACE}))"
BACK = "=IF([part]*[share]=0,0,MAX(0,(MAX([v-1],[top_v])-[v])*IF([xi]<=@v_at+check_zero,1,-1)))"
BEND = "=2*INDEX(piece_c2,[q])+6*INDEX(piece_c3,[q])*[u]-INDEX(piece_P,[q])*INDEX(piece_omega,[q])^2*SIN([x])"
BOUNDS = "by nine points a piece"


def extremes(at: Points) -> list[Quantity]:
    """Return the rows of the extremes, of where v is largest, and of its greatest step the wrong way."""
    rows: list[Quantity] = []
    for what, words in WORDS.items():
        low, high = at.extremes(what)
        rows += [
            calc(f"@{what}_most", f"Largest {words}", what, "", f"=MAX(0,[@points.top_{what}])", high, source=BOUNDS),
            calc(f"@{what}_least", f"Lowest {words}", what, "", f"=MIN(0,[@points.top_{what}])", low, source=BOUNDS),
        ]
    return [
        *rows,
        calc("@v_at", "Where the velocity is largest", "ξ_v", "", "=MIN([@points.fast])", at.peak),
        calc("@back", "Greatest step of v the wrong way", "", "", "=MAX([@points.back])", float(at.wrong_way.max()),
             source="slower before the largest, faster after it"),
    ]  # fmt: skip


def points_table(sheet: Sheet, at: Points, first: int, stack: Pieces) -> None:
    """Declare the table of points; ``first`` is the row of the law's first piece in the stack."""
    rates, p = at.rates, at.piece + 1
    angles = at.angles[: 1 + stack.second_sine]
    sheet.table(
        "@points", "Nine points on each piece, both its ends among them", len(p),
        constant("p", "piece", "", "", p.tolist()),
        constant("share", "share of the piece", "", "", list(SHARES) * len(at.pieces)),
        constant("weight", "weight in it", "", "", list(WEIGHTS) * len(at.pieces)),
        calc("part", "share of the rise", "", "", "=[weight]*INDEX([@pieces.d],[p])", at.part),
        calc("xi", "abscissa", "ξ", "", "=INDEX([@worked.xi],[p])+[u]", at.xi),
        calc("q", "piece row", "q", "", "=@first+[p]-1", p + (first - 1.0), format="0", source="on the sheet Laws"),
        *stack.within("=[share]*INDEX([@pieces.d],[p])", "share of the duration", at.u, *angles, entries=OWN_ENTRIES),
        *stack.columns(rates, "svaj", entries=OWN_ENTRIES),
        calc("b", "slope of the jerk", "b", "", BEND, rates["b"]),
        calc("va", "v · a", "", "", "=[v]*[a]", rates["va"]),
        calc("g", "slope of v · a", "", "", "=[a]^2+[v]*[j]", rates["g"], source="a² + v j"),
        *(calc(f"top_{f}", f"extreme of {f} before it, or {f}", "", "", CREST.format(f=f, g=g), at.local_extremes(f),
               source="parabola by both slopes") for f, g in SLOPES.items()),
        calc("fast", "where v is largest", "", "", FAST, at.fastest_xi, source="else 1"),
        calc("back", "the wrong way", "Δv", "", BACK, at.wrong_way),
    )  # fmt: skip


EITHER = (  # a factor: of two groups, or, where nothing slows down, of all
    "=IF(OR(MAX([@mend.slow])>0,@v_up>@least),IF(ABS(@under)>@least_under,{0}/@under,0),"
    "IF(@s_up>@alike*MAX([@mend.size]),1/@s_up,0))"
)
WORTH = '=IF(MIN(@up,@down)>@alike*MAX(@up,@down),"yes","no: it should speed up, then slow down")'


def missing(sheet: Sheet, law: Law, n: int) -> None:
    """Declare by how much the law misses its rise and rest, and the entries scaled so that it does not."""
    pieces = filled(law.as_pieces(), n, engine.Piece(0.0))
    found, off = groups(pieces), misses(pieces)
    up, down = found.factors
    factors = [down if slow else up for slow in found.slows]
    sheet.row += 1
    sheet.heading("By how much it misses", "And its entries scaled so that it reaches 1 at rest.")
    sheet.rows(
        result("@miss_s", "It misses its rise by", "s(1) − 1", "", "=[@samples.s.last]-1", off.s, format="0.0000####"),
        result("@miss_v", "and rest by", "v(1)", "", "=[@samples.v.last]", off.v, format="0.0000####"),
        result("@mends", "Do two factors mend it?", "", "",
               WORTH, "yes" if found.mends else "no: it should speed up, then slow down", align="left"),
        result("@up", "Factor of the pieces that gain velocity", "α", "", EITHER.format("@v_down"), up),
        result("@down", "Factor of those that lose it", "β", "", EITHER.format("(0-@v_up)"), down),
        *sums(found),
    )  # fmt: skip
    row = "@first+[k]-1"

    def scaled(name: str, label: str, symbol: str, values: Sequence[float]) -> Quantity:
        made = [factor * value for factor, value in zip(factors, values, strict=True)]
        return result(name, label, symbol, "", f"=[factor]*INDEX([@pieces.{name}],[k])", made, format="General")

    sheet.table(
        "@mend", "The entries scaled: durations, frequencies and phases stay", n,
        constant("k", "piece", "k", "", list(range(1, n + 1))),
        *(scaled(f"c{i}", f"scaled c{i}", f"c{i}", [piece.c[i] for piece in pieces]) for i in range(4)),
        scaled("P", "scaled amplitude", "P", [piece.amplitude for piece in pieces]),
        calc("factor", "factor", "", "", "=IF([slow]=1,@down,@up)", factors),
        calc("gain_v", "adds to v(1)", "", "", f"=INDEX(piece_dv,{row})", [v for _, v in found.gained]),
        calc("gain_s", "adds to s(1)", "", "", f"=INDEX(piece_ds,{row})-INDEX(piece_v,{row})*INDEX(piece_d,{row})"
             f"+[gain_v]*(SUM([@pieces.d])-INDEX(piece_xi,{row})-INDEX(piece_d,{row}))",
             [s for s, _ in found.gained], source="∬a over it, and ∫a over the time that follows"),
        calc("d", "duration", "d", "", "=INDEX([@pieces.d],[k])", [piece.duration for piece in pieces]),
        calc("size", "size", "", "",
             "=[d]*(ABS(INDEX([@pieces.c0],[k]))+[d]*(ABS(INDEX([@pieces.c1],[k]))+[d]*(ABS(INDEX([@pieces.c2],[k]))"
             "+[d]*ABS(INDEX([@pieces.c3],[k]))))+ABS(INDEX([@pieces.P],[k])))", found.sizes),
        calc("slow", "loses velocity", "", "",
             "=IF([gain_v]<0-@least,1,0)", [float(slow) for slow in found.slows], format="0"),
        blank='INDEX([@pieces.d],[k])=""',
    )  # fmt: skip


def sums(found: Groups) -> list[Quantity]:
    """Return the rows of what the pieces of each group add, and what counts as none."""
    return [
        calc("@least", "A velocity below this is none", "", "",
             "=1E-12*MAX([@mend.size])", found.least, format="0E+00"),
        constant("@alike", "Share of the largest below which travels and factors are none", "", "", ALIKE,
                 format="0E+00"),
        calc("@s_up", "Travel of those that gain", "S⁺", "", "=SUMPRODUCT(1-[@mend.slow],[@mend.gain_s])", found.s1),
        calc("@v_up", "Velocity that they gain", "V⁺", "", "=SUMPRODUCT(1-[@mend.slow],[@mend.gain_v])", found.v1),
        calc("@s_down", "Travel of those that lose", "S⁻", "", "=SUMPRODUCT([@mend.slow],[@mend.gain_s])", found.s2),
        calc("@v_down", "Velocity that they lose", "V⁻", "", "=SUMPRODUCT([@mend.slow],[@mend.gain_v])", found.v2),
        calc("@under", "Determinant", "", "", "=@s_up*@v_down-@s_down*@v_up", found.under, source="S⁺V⁻ − S⁻V⁺"),
        calc("@least_under", "A determinant below this is none", "", "", "=@alike*MAX([@mend.size])^2",
             found.least_under, format="0E+00"),
    ]  # fmt: skip
