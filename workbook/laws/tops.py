"""Extremes of a law without closed forms, in cells: points on its pieces, the likeliest refined by Newton's method.

A point's row knows by the sign of the slope whether an extreme lies between it and the point before, and estimates it
by the chord; the largest estimates, three of each side, are brackets in which the slope's zero is refined.
"""

from __future__ import annotations

from engine.laws.points import CHAINS, FLAT, LEAST, RANKS, STEPS, WIDEST, Spread, Top, extreme
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.laws.sampling import Pieces

FORMS = {
    "s": "=[s0]+[{u}]*([s1]+[{u}]*([c0]/2+[{u}]*([c1]/6+[{u}]*([c2]/12+[{u}]*[c3]/20))))-[ps]*SIN([om]*[{u}]+[ph])",
    "v": "=[s1]+[{u}]*([c0]+[{u}]*([c1]/2+[{u}]*([c2]/3+[{u}]*[c3]/4)))-[pv]*COS([om]*[{u}]+[ph])",
    "a": "=[c0]+[{u}]*([c1]+[{u}]*([c2]+[{u}]*[c3]))+[P]*SIN([om]*[{u}]+[ph])",
    "j": "=[c1]+[{u}]*(2*[c2]+[{u}]*3*[c3])+[P]*[om]*COS([om]*[{u}]+[ph])",
    "b": "=2*[c2]+[{u}]*6*[c3]-[P]*[om]^2*SIN([om]*[{u}]+[ph])",
    "e": "=6*[c3]-[P]*[om]^3*COS([om]*[{u}]+[ph])",
}
"""s, v, a and the derivatives of a at a local abscissa of a piece"""
SLOPES = {
    "s": ("v", "a", "[v{n}]", "[a{n}]"),
    "v": ("a", "j", "[a{n}]", "[j{n}]"),
    "a": ("j", "b", "[j{n}]", "[b{n}]"),
    "j": ("b", "e", "[b{n}]", "[e{n}]"),
    "va": ("vaj", "b", "([a{n}]^2+[v{n}]*[j{n}])", "(3*[a{n}]*[j{n}]+[v{n}]*[b{n}])"),
}
"""of each extreme: what its slope and its curvature are made of, and both"""
COLUMNS = {"s": "v", "v": "a", "a": "j", "j": "b", "va": "g"}
"""the column of points that is the slope"""
ENTRIES = ("s0", "s1", "c0", "c1", "c2", "c3", "ps", "pv", "P", "omega", "phi")
NAMES = {"omega": "om", "phi": "ph"}
RISING, FALLING = range(1, RANKS + 1), range(RANKS + 1, RANKS + RANKS + 1)
"""rows of the candidates for the largest, and for the lowest"""
LEAST_POINTS = 60
"""in all, whatever sizes.own_law says"""
WORDS = {"s": "position", "v": "velocity", "a": "acceleration", "j": "jerk", "va": "v·a"}
CURVES = {"s": "a", "v": "j", "a": "b"}
"""the column of points that is the curvature, where a slope that is 0 at an end hangs on it"""


def beyond(estimated: str, other: str, side: str) -> str:
    """Return the formula of an extreme that is estimated from one point, made to lie beyond the other one too."""
    return f"{other}+SIGN({side})*(MAX(0,SIGN({side})*({estimated}-{other}))+2E-9)"


ACROSS = "ROUND([{g}],9)*ROUND([{g}-1],9)<0"
CHORD = beyond("[{f}-1]+[{g}-1]^2/([{g}-1]-[{g}])*([u]-[u-1])/2", "[{f}]", "[{g}-1]")
LEAVING = "AND(ROUND([{g}-1],9)=0,ROUND([{c}-1],9)*ROUND([{g}],9)<0)"
LEFT = beyond("[{f}-1]+[{c}-1]^3*([u]-[u-1])^4/([{c}-1]*([u]-[u-1])-[{g}])^2/6", "[{f}]", "[{c}-1]")
ARRIVING = "AND(ROUND([{g}],9)=0,ROUND([{c}],9)*ROUND([{g}-1],9)>0)"
COME = beyond("[{f}]+[{c}]^3*([u]-[u-1])^4/([{c}]*([u]-[u-1])+[{g}-1])^2/6", "[{f}-1]", "[{g}-1]")
TOP = f"=ROUND(IF([k]=0,[{{f}}],IF([n]=[n-1],IF({ACROSS},{CHORD},{{rest}}),[{{f}}])),9)"
"""by the chord of the slope, a little beyond the values of both points; slopes below 1e-9 are none"""
REST = f"IF({LEAVING},{LEFT},IF({ARRIVING},{COME},[{{f}}]))"
"""where the slope is none at an end already: by the parabola with its curvature there"""
ROUNDED = 2.0
"""what is rounded to nine digits after the point is compared with: the last of them may differ by one"""
CROSSES = "ROUND([f0],9)*ROUND([f1],9)<0"
TURNS = (
    f"OR({CROSSES},AND(ROUND([f0],9)=0,ROUND([e0],9)*ROUND([f1],9)<0),"
    "AND(ROUND([f1],9)=0,ROUND([e1],9)*ROUND([f0],9)>0))"
)
SHARE = "[f0]/([f0]-[f1])"
AWAY = "([high]-[low])"
PARTED = f"IF(ROUND([f0],9)=0,[e0]*{AWAY}/([e0]*{AWAY}-[f1]),IF(ROUND([f1],9)=0,[f0]/([f0]+[e1]*{AWAY}),{SHARE}))"
BACK = "=IF([k]=0,0,MAX(0,IF([xi]<=@v_at+check_zero,[v-1]-[v],[v]-[v-1])))"
BEND = "=2*INDEX(piece_c2,[q])+[u]*6*INDEX(piece_c3,[q])-INDEX(piece_P,[q])*INDEX(piece_omega,[q])^2*SIN([x])"


def spread_rows(at: Spread) -> list[Quantity]:
    """Return the rows that say how many points a piece has, and whether they are dense enough."""
    return [
        calc("@used", "Pieces that last", "", "", "=MAX([@worked.nth])", at.used, format="0"),
        calc("@each", "Points on each", "", "",
             "=MAX(2,INT(COUNT([@points.k])/@used))", at.each, format="0", source="both ends of a piece included"),
    ]  # fmt: skip


DENSE = f"AND(@each*@used<=COUNT([@points.k]),@each>={LEAST},MAX([@worked.turn])<={WIDEST}*(@each-1))"


def extremes(at: Spread, peak: float) -> list[Quantity]:
    """Return the rows of the extremes, and where v is largest."""
    rows: list[Quantity] = []
    for what in CHAINS:
        tops = at.tops(what)
        for name, side, function, numbers in (("most", 1, "MAX", RISING), ("least", -1, "MIN", FALLING)):
            cells = ",".join(f"[@top_{what}.value.{n}]" for n in numbers)
            rows.append(
                calc(f"@{what}_{name}", f"{'Largest' if side > 0 else 'Lowest'} {WORDS[what]}", what, "",
                     f"={function}({cells})", extreme(tops, side).value)
            )  # fmt: skip
    firsts = ",".join(
        f"IF([@top_v.still.{n}]*[@top_v.value.{n}]>=@v_most-check_zero,[@top_v.xi.{n}],1)" for n in range(1, RANKS + 1)
    )
    rows.append(calc("@v_at", "Where the velocity is largest", "ξ_v", "", f"=MIN({firsts})", peak))
    rows.append(
        calc("@back", "Greatest step of v the wrong way", "", "", "=MAX([@points.back])",
             float(at.wrong_way(peak).max()), source="slower before the largest, faster after it")
    )  # fmt: skip
    return rows


def points_table(sheet: Sheet, at: Spread, first: int, peak: float, stack: Pieces) -> None:
    """Declare the table of points; ``first`` is the row of the law's first piece in the stack."""
    rates, q = at.rates, at.piece + float(first)
    columns = {"s": rates.s, "v": rates.v, "a": rates.a, "j": rates.j}
    sheet.table(
        "@points", "Points on the pieces, the same number on each that lasts", at.points,
        constant("k", "point", "k", "", list(range(at.points))),
        calc("n", "of the pieces that last", "", "", "=MIN(@used,INT([k]/@each)+1)", at.place + 1, format="0"),
        calc("p", "piece", "", "", "=MATCH([n],[@worked.nth],0)", at.piece + 1, format="0"),
        calc("xi", "abscissa", "ξ", "", "=INDEX([@worked.xi],[p])+[u]", at.xi),
        calc("q", "piece row", "q", "", "=@first+[p]-1", q, format="0", source="on the sheet Laws"),
        *stack.within("=INDEX([@pieces.d],[p])*MIN(1,([k]-([n]-1)*@each)/(@each-1))", "", at.u,
                      *at.angles[: 1 + stack.second_sine]),
        *stack.columns(columns, "svaj"),
        calc("b", "slope of the jerk", "b", "", BEND, rates.b),
        calc("va", "v · a", "", "", "=[v]*[a]", rates.va),
        calc("g", "slope of v · a", "", "", "=[a]^2+[v]*[j]", rates.g, source="a² + v j"),
        *(calc(f"top_{f}", f"extreme of {f} here, by the chord", "", "",
               estimate(f, g), at.estimates(f), scale=ROUNDED, source="or the value at the point")
          for f, g in COLUMNS.items()),
        calc("back", "the wrong way", "Δv", "", BACK, at.wrong_way(peak)),
    )  # fmt: skip


def estimate(f: str, g: str) -> str:
    """Return the formula of an extreme between a point and the one before, else of the value there."""
    rest = REST.format(f=f, g=g, c=CURVES[f]) if f in CURVES else f"[{f}]"
    return TOP.format(f=f, g=g, rest=rest)


def bracket(at: Spread, what: str, tops: list[Top]) -> list[Quantity]:
    """Return the columns of what the slope, and where it hangs on it the curvature, is at the ends of a bracket."""
    before = [max(top.row - 2, 0) for top in tops]
    there = [top.row - 1 for top in tops]
    columns = [("f", "slope", COLUMNS[what]), *([("e", "curvature", CURVES[what])] if what in CURVES else [])]
    return [
        calc(f"{name}{k}", f"{word} {place}", "", "", f"=INDEX([@points.{column}],{row})",
             [getattr(at.rates, column)[i] for i in rows], scale=at.size(column))
        for name, word, column in columns
        for k, (place, row, rows) in enumerate((("before", "MAX([row]-1,1)", before), ("there", "[row]", there)))
    ]  # fmt: skip


def still(at: Spread, tops: list[Top]) -> Quantity:
    """Return the column of whether a candidate is an extreme of v, or an end of a piece: not beside an extreme."""
    formula = "=IF(OR([low]<[high],ROUND([f1],9)=0,[high]<=0,[high]>=INDEX([@pieces.d],[p])),1,0)"
    return calc(
        "still", "is an extreme or an end", "", "", formula, [int(at.is_still(top)) for top in tops], format="0"
    )


def top_table(sheet: Sheet, at: Spread, what: str, stack_row: int, entries: dict[str, list[float]]) -> None:
    """Declare the likeliest places of one extreme, each with the steps of its refinement.

    ``entries`` are the columns of the law's rows in the stack, of which ``stack_row`` is the first.
    """
    tops = at.tops(what)
    held = {name: [entries[name][top.piece - 1] for top in tops] for name in ENTRIES}
    sheet.table(
        f"@top_{what}", f"Where the {WORDS[what]} may be largest, or lowest", len(tops),
        constant("side", "side", "", "", [top.side for top in tops], source="1 largest, −1 lowest"),
        constant("rank", "rank", "", "", [top.rank for top in tops]),
        calc("near", "estimate", "", "",
             f"=IF([side]>0,LARGE([@points.top_{what}],[rank]),SMALL([@points.top_{what}],[rank]))",
             [top.estimate for top in tops], scale=ROUNDED),
        calc("row", "row of its point", "", "",
             f"=MATCH([near],[@points.top_{what}],0)", [top.row for top in tops], format="0"),
        calc("p", "piece", "", "", "=INDEX([@points.p],[row])", [top.piece for top in tops], format="0"),
        *bracket(at, what, tops),
        calc("high", "not after", "u", "", "=INDEX([@points.u],[row])", [top.high for top in tops]),
        calc("low", "not before", "u", "",
             f"=IF(AND(INDEX([@points.p],MAX([row]-1,1))=[p],{TURNS if what in CURVES else CROSSES}),"
             "INDEX([@points.u],MAX([row]-1,1)),[high])",
             [top.low for top in tops]),
        *([still(at, tops)] if what == "v" else []),
        calc("q", "piece row", "q", "", "=@first+[p]-1", [float(stack_row + top.piece - 1) for top in tops],
             format="0"),
        *(calc(NAMES.get(name, name), f"{name} of the piece", name, "", f"=INDEX(piece_{name},[q])", held[name])
          for name in ENTRIES),
        calc("u0", "by the chord", "u", "",
             f"=IF([low]<[high],[low]+{AWAY}*{PARTED if what in CURVES else SHARE},[high])",
             [top.steps[0] for top in tops]),
        *(column for n in range(STEPS) for column in step(at, what, tops, n)),
        *valued(at, what, tops),
        calc("xi", "abscissa", "ξ", "",
             f"=INDEX(piece_xi,[q])+[u{STEPS}]", [entries["xi"][top.piece - 1] + top.steps[-1] for top in tops]),
    )  # fmt: skip
    sheet.row += 1


def step(at: Spread, what: str, tops: list[Top], n: int) -> list[Quantity]:
    """Return the columns of a step of Newton's method."""
    slope, curve, rate, curvature = (text.format(n=n) for text in SLOPES[what])
    found = at.at_step(tops, n)
    parts = [
        calc(f"{d}{n}", f"{d} there", d, "", FORMS[d].format(u=f"u{n}"), getattr(found, d).tolist(), scale=at.size(d))
        for d in slope + curve
    ]
    formula = f"=MAX([low],MIN([high],[u{n}]-IF(ABS({curvature})>{FLAT!r},{rate}/{curvature},0)))"
    following = calc(f"u{n + 1}", f"step {n + 1}", "u", "", formula.replace("1e-12", "1E-12"),
                     [top.steps[n + 1] for top in tops])  # fmt: skip
    return [*parts, following]


def valued(at: Spread, what: str, tops: list[Top]) -> list[Quantity]:
    """Return the columns of the value at the last step."""
    u = f"u{STEPS}"
    if what != "va":
        return [result("value", WORDS[what], what, "", FORMS[what].format(u=u), [top.value for top in tops])]
    found = at.at_step(tops, STEPS)
    return [
        *(calc(f"{d}{STEPS}", f"{d} there", d, "", FORMS[d].format(u=u), getattr(found, d).tolist(),
               scale=at.size(d))
          for d in "va"),
        result("value", "v · a", "", "", f"=[v{STEPS}]*[a{STEPS}]", [top.value for top in tops]),
    ]  # fmt: skip
