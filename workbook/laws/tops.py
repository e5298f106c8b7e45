"""The extremes of an own law in cells: nine points a piece, and the parabola where the slope changes its sign.

``POINTS`` of Gauss and Lobatto stand on each piece, both its ends among them. A point's row has the extreme that lies
between it and the point before, by the values and the slopes there; the largest of a column is the law's.
"""

from engine.laws.points import SLOPES, Points
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.laws.sampling import Pieces

OWN_ENTRIES = ("d", "c0", "c1", "c2", "c3", "P", "omega", "phi")
"""what is entered of a piece"""
CREST = (
    "=IF([part]=0,0,[{f}]+IF([share]=0,0,IF([{g}-1]*[{g}]<0,"
    "[{g}]*([{f}]-[{f}-1]-[{g}-1]*([u]-[u-1])/2)/([{g}-1]-[{g}]),0)))"
)
WORDS = {"s": "position", "v": "velocity", "a": "acceleration", "j": "jerk", "va": "v·a"}
PLACE = "[xi]-IF([share]=0,0,IF([a-1]*[a]<0,([u]-[u-1])*[a]/([a]-[a-1]),0))"
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
        constant("share", "share of the piece", "", "", at.share.tolist()),
        constant("weight", "weight in it", "", "", at.weight.tolist()),
        calc("part", "share of the rise", "", "", "=[weight]*INDEX([@pieces.d],[p])", at.part),
        calc("xi", "abscissa", "ξ", "", "=INDEX([@worked.xi],[p])+[u]", at.xi),
        calc("q", "piece row", "q", "", "=@first+[p]-1", p + (first - 1.0), format="0", source="on the sheet Laws"),
        *stack.within("=[share]*INDEX([@pieces.d],[p])", "share of the duration", at.u, *angles, entries=OWN_ENTRIES),
        *stack.columns(rates, "svaj", entries=OWN_ENTRIES),
        calc("b", "slope of the jerk", "b", "", BEND, rates["b"]),
        calc("va", "v · a", "", "", "=[v]*[a]", rates["va"]),
        calc("g", "slope of v · a", "", "", "=[a]^2+[v]*[j]", rates["g"], source="a² + v j"),
        *(calc(f"top_{f}", f"extreme of {f} before it, or {f}", "", "",
               CREST.format(f=f, g=g), at.crests(f), source="parabola by both slopes")
          for f, g in SLOPES.items()),
        calc("fast", "where v is largest", "", "", FAST, at.fast, source="else 1"),
        calc("back", "the wrong way", "Δv", "", BACK, at.wrong_way),
    )  # fmt: skip
