"""Stretches of the motion in cells, where power turns round in them, and sections between all of these."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.machine.brackets import NONE, Step
from engine.machine.interpolated import BEND
from engine.machine.places import FIRST, INTERPOLATING, LAST, LOOKS, NODES, WEIGHTS, Worked, section
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.machines.machine.breaks import ACTS
from workbook.machines.machine.linked import kinds
from workbook.machines.machine.linked.places import columns, stacked
from workbook.machines.machine.linked.turn import Turn
from workbook.machines.machine.linked.worked import FIGURES, LINE, PlacedWork
from workbook.motion.sampled import derivative

LETTERS = ("F", "S", "T")
"""of the columns of force, torque behind the reducer, torque of the motor"""
BENDS = ("ahead", "here", "after")
"""columns of what three nodes are weighed by"""
Point = tuple[str, str]
"""columns of a place, and of a figure's value there"""
FIRST_RANGE = 2
"""row above which there is but one: no program looks up in a single cell alike"""


def begins(table: str, breaks: str, rows: int, spans: list[tuple[float, float]]) -> list[Quantity]:
    """Return begin and end of each stretch or section of a table between breaks; spare rows repeat the last."""
    begin = ["=0*[k]", *("=IF([e-1]>=360-timing_eps,[b-1],[e-1])" for _ in range(rows - 1))]
    after = f"SUMPRODUCT(({breaks}<=[b]+timing_eps)*1)+1"

    def of(k: int) -> list[float]:
        return filled([span[k] for span in spans], rows, spans[-1][k])

    used = filled([1 for _ in spans], rows, 0)
    return [
        calc("b", "begins at", "", "°", begin, of(0), scale=360.0, format="0.0##"),
        calc("e", "ends at", "", "°", f"=SMALL({breaks},{after})", of(1), scale=360.0, format="0.0##"),
        calc("on", "is no spare row", "", "",
             f"=IF([k]=1,1,IF(INDEX([{table}.e],MAX([k]-1,1))>=360-timing_eps,0,1))", used, format="0"),
    ]  # fmt: skip


def bounds(view: PlacedWork, piece: str, ranges: list[tuple[float, float]]) -> list[Quantity]:
    """Return begin and end from the begin of the piece."""
    begin = f"INDEX([axis{view.driven.number}_pieces.begin],{piece})"
    return [
        calc("ub", "from", "u", "rad", f"=RADIANS([b]-{begin})", [low for low, _ in ranges], scale=1.0),
        calc("ue", "to", "u", "rad", f"=RADIANS([e]-{begin})", [high for _, high in ranges], scale=1.0),
    ]  # fmt: skip


def stretches_table(sheet: Sheet, view: PlacedWork) -> None:
    """Declare the stretches: in each, direction and process force stay as they are."""
    i, rows, driven = view.driven.number, view.rows, view.driven
    pieces = f"axis{i}_pieces"
    velocity = velocity_at(view, "(([ub]+[ue])/2)")
    back = f"MIN([dir]*{velocity_at(view, '[ub]')},[dir]*{velocity_at(view, '[ue]')})<0-check_zero*@vmax"
    acts, angle = ACTS.format(x="[x]"), f"(([b]+[e])/2+[axes_taken.late.{i}])"
    helds = view.helds
    sheet.table(
        "@st", "Stretches: one direction, one process force", rows,
        constant("k", "stretch", "k", "", list(range(1, rows + 1))),
        *begins("@st", "[@breaks.at]", rows, view.spans),
        calc("q", "piece", "q", "", f"=MATCH(([b]+[e])/2,[{pieces}.begin],1)", view.numbers, format="0"),
        *bounds(view, "[q]", view.ranges),
        calc("dir", "direction", "", "", f"=IF(ABS({velocity})>check_zero*@vmax,SIGN({velocity}),0)",
             [one.going for one in helds], format="0"),
        calc("back", "turns back", "", "", f"=IF([dir]=0,0,IF({back},1,0))",
             [int(one.turns_back(span, driven.fastest)) for one, span in zip(helds, view.ranges, strict=True)],
             format="0"),
        calc("x", f"{view.one.machine.over.angle} in its middle", "θ", "°",
             f"={angle}-360*INT(({angle}+timing_eps)/360)", view.middles, scale=360.0, format="0.0##"),
        calc("r", "what resists", "R", "N" if driven.travels else "Nm",
             f"=@steady+[dir]*@rub+SUMPRODUCT({acts}*([@windows.always]+[dir]*[@windows.moving]))",
             [one.force.level for one in helds], scale=driven.sizes.force),
        *kinds.of(view.driven).held(view.driven, derivative(view.one.pieces, 0, place="(([ub]+[ue])/2)"),
                                    [one.within for one in helds]),
        calc("acts", "the motor acts", "", "", '=IF(AND([dir]=0,@holding="brake"),0,1)', [one.acts for one in helds],
             format="0", source="not at rest behind a brake"),
    )  # fmt: skip


def velocity_at(view: PlacedWork, u: str) -> str:
    """Return the formula of y' of a stretch's piece at a place."""
    rows, text = view.one.pieces, ""
    for n in range(rows.powers - 1, 0, -1):
        term = f"{n}*{rows.at.of_piece(f'c{n}', 'q')}"
        text = f"{term}+{u}*({text})" if text else term
    for *_, mark in rows.sines:
        a, om, ph = (rows.at.of_piece(f"{name}{mark}", "q") for name in ("A", "om", "ph"))
        text += f"+{a}*{om}*COS({om}*{u}+{ph})"
    return f"({text})"


def looks_table(sheet: Sheet, view: PlacedWork) -> None:
    """Declare the places at which each stretch is looked at, and how often power has turned round up to each."""
    rows = view.rows
    numbers = [k for k in range(1, rows + 1) for _ in LOOKS]
    places = np.concatenate([section(span, LOOKS) for span in view.ranges])
    helds = [held for held in view.helds for _ in LOOKS]
    shares = [share for _ in range(rows) for share in LOOKS.tolist()]
    sheet.row += 1
    sheet.table(
        "@look", "Which way power goes: places of each stretch", len(numbers),
        constant("k", "place", "", "", list(range(1, len(numbers) + 1))),
        constant("st", "stretch", "", "", numbers),
        constant("share", "share", "", "", shares),
        calc("u", "within piece", "u", "rad",
             "=INDEX([@st.ub],[st])+[share]*(INDEX([@st.ue],[st])-INDEX([@st.ub],[st]))", places, scale=1.0),
        *columns(view, stacked(view.looks), helds, places),
        *(column for k in range(len(FIGURES)) for column in signs(view, k)),
    )  # fmt: skip


def signs(view: PlacedWork, k: int) -> list[Quantity]:
    """Return the sign of a figure, and how often it has changed."""
    letter, name = LETTERS[k], FIGURES[k]
    counts = ("1", "IF(@j1>0,1,0)", "IF(@j0>0,1,0)")[k]
    before, used = f"INDEX([@look.s{letter}],MAX([k]-1,1))", f"INDEX([@st.on],[st])*{counts}"
    none = f"IF(ABS([{letter}])<=@lost_{letter},1,0)"
    own = f"{used}*(1-{none})*SIGN([{letter}])"
    rows = len(view.look(name))
    kept = [f"={own}", *(f"={own}+{used}*{none}*IF([share]=0,0,1)*[s{letter}-1]" for _ in range(rows - 1))]
    changed = f"IF(AND([share]>0,[s{letter}]*{before}<0),1,0)"
    return [
        calc(f"s{letter}", f"sign of {letter}", "", "", kept,
             [int(sign) for signs in view.signs[name] for sign in signs], format="0", source="of none that before"),
        calc(f"n{letter}", "changes up to here", "", "",
             ["=0*[k]", *(f"=[n{letter}-1]+{changed}" for _ in range(rows - 1))], view.changes(name), format="0"),
    ]  # fmt: skip


def lost_rows(view: PlacedWork) -> list[Quantity]:
    """Return the rows of what has no sign."""
    return [
        calc(f"@lost_{letter}", f"No sign has {letter} up to", "", "",
             f"=check_zero*MAX(MAX([@look.{letter}]),0-MIN([@look.{letter}]))", view.lost(name), format="0E+00",
             scale=view.lost(name))
        for letter, name in zip(LETTERS, FIGURES, strict=True)
    ]  # fmt: skip


def of_figure(letters: str) -> str:
    """Return the formula of which of three is that of a row's figure."""
    return f"CHOOSE(MAX([figure],1),{letters})"


def looked(at: str) -> str:
    """Return the formula of a row's figure at a place at which stretches are looked at."""
    return of_figure(",".join(f"INDEX([@look.{letter}],{at})" for letter in LETTERS))


def brackets(turns: list[Turn], size: float) -> list[Quantity]:
    """Return the columns of places between which power turns round.

    Where it does so for an earlier figure between them, the figure has a kink: the part on one side of that counts.
    """
    low, below = looked("[row]-1"), range(2, len(turns) + 1)
    signs = f"[gk]*{low}{{}}[lost]*ABS({low})"
    same, other = (f"AND([kink]>0,{signs.format(sign)})" for sign in (">", "<="))

    def number(n: int) -> str:
        above = f"[@turn.row.1]:[@turn.row.{n - 1}]"
        found = f"IF(COUNTIF({above},[row])=0,0,MATCH([row],{above},0))" if n > FIRST_RANGE else "IF([row]=[row-1],1,0)"
        return f"=IF([figure]<2,0,{found})"

    def at_kink(column: str, n: int) -> str:
        first, last = (f"[@turn.{column}.{k}]" for k in (1, n - 1))
        return f"INDEX({first}:{last},[kink])" if n > FIRST_RANGE else first

    def kinked(found: Callable[[int], str]) -> list[str]:
        return ["=0*[k]", *(f"=IF([kink]=0,0,{found(n)})" for n in below)]

    def value(n: int) -> str:
        return of_figure(",".join(at_kink(f"{letter}3", n) for letter in LETTERS))

    def of(name: str) -> list[float]:
        return [getattr(turn.bracket, name) for turn in turns]

    return [
        calc("kink", "has a kink at number", "", "", ["=0*[k]", *map(number, below)], [turn.kink for turn in turns],
             format="0", source="where power turns round for an earlier figure"),
        calc("uk", "beside that", "u", "rad", kinked(lambda n: at_kink("u3", n)), [turn.beside for turn in turns],
             scale=1.0),
        calc("gk", "there", "", "", kinked(value), [turn.at_kink for turn in turns], scale=size),
        calc("lo", "from", "u", "rad", f"=IF({same},[uk],INDEX([@look.u],[row]-1))", of("low"), scale=1.0),
        calc("hi", "to", "u", "rad", f"=IF({other},[uk],INDEX([@look.u],[row]))", of("high"), scale=1.0),
        calc("glo", "there", "", "", f"=IF({same},[gk],{low})", of("at_low"), scale=size),
        calc("ghi", "and there", "", "", f"=IF({other},[gk],{looked('[row]')})", of("at_high"), scale=size),
    ]  # fmt: skip


def stepped(mark: str, one: Point, other: Point, last: Point, steps: list[Step], scale: float) -> list[Quantity]:
    """Return the columns of the step from a place to where the parabola through three is 0: the columns of each."""
    (p, a), (q, b) = ((f"([{u}]-[{last[0]}])", f"([{g}]-[{last[1]}])") for u, g in (one, other))
    u, g = (f"[{name}]" for name in last)
    slope, bend, size, steep = (f"[{name}{mark}]" for name in ("ms", "mb", "md", "mq"))
    root = f"SQRT(MAX(0,{slope}^2-4*{bend}*{g}*{size}))"
    step = f"{u}-2*{g}*[rise]*ABS({size})/{steep}"

    def of(name: str) -> list[float]:
        return [getattr(one, name) for one in steps]

    return [
        calc(f"ms{mark}", "slope of the parabola", "", "", f"={p}^2*{b}-{q}^2*{a}", of("slope"), scale=scale,
             source="p²(g_q − g) − q²(g_p − g)"),
        calc(f"mb{mark}", "bend", "", "", f"={q}*{a}-{p}*{b}", of("bend"), scale=scale,
             source="q(g_p − g) − p(g_q − g)"),
        calc(f"md{mark}", "over", "", "", f"={p}*{q}*({p}-{q})", of("size"), scale=1.0, source="p q (p − q)"),
        calc(f"mq{mark}", "steepness at 0", "", "", f"=[rise]*SIGN({size})*{slope}+{root}", of("steep"), scale=scale),
        calc(f"u{mark}", "turns at" if mark == "4" else f"place {mark}", "u", "rad",
             f"=IF(OR({steep}<=0,ABS({g})<={NONE!r}*[lost]),{u},MAX([lo],MIN([hi],{step})))", of("place"), scale=1.0,
             source="Muller's method"),
    ]  # fmt: skip


def turns_table(sheet: Sheet, view: PlacedWork) -> None:
    """Declare where power turns round: of the load, in the reducer, in the motor."""
    rows, turns = view.turn_rows, view.turns
    ends = [f"MAX([@look.n{letter}])" for letter in LETTERS]
    sums = ["+".join(ends[: k + 1]) for k in range(len(ends))]
    figure = f"=IF([k]<={sums[0]},1,IF([k]<={sums[1]},2,IF([k]<={sums[2]},3,0)))"
    row = (
        f"=IF([figure]=0,2,IF([figure]=1,MATCH([k],[@look.nF],0),IF([figure]=2,MATCH([k]-({sums[0]}),[@look.nS],0),"
        f"MATCH([k]-({sums[1]}),[@look.nT],0))))"
    )

    def figured(mark: str) -> str:
        return of_figure(",".join(f"[{letter}{mark}]" for letter in LETTERS))

    lost, line = of_figure("@lost_F,@lost_S,@lost_T"), "[lo]-[glo]*([hi]-[lo])/([ghi]-[glo])"
    helds = [view.helds[turn.stretch - 1] for turn in turns]
    size = max(view.sizes.values())

    def tried(mark: str, worked: list[Worked], places: list[float]) -> list[Quantity]:
        return columns(view, stacked(worked), helds, np.array(places), mark)

    begin = f"INDEX([axis{view.driven.number}_pieces.begin],[q1])"
    sheet.table(
        "@turn", "Where power turns round: at the load (1), in the reducer (2), in the motor (3)", rows,
        constant("k", "number", "", "", list(range(1, rows + 1))),
        calc("figure", "of", "", "", figure, [turn.figure for turn in turns], format="0", source="0: a spare row"),
        calc("row", "before the place", "", "", row, [turn.row for turn in turns], format="0"),
        calc("st", "stretch", "", "", "=INDEX([@look.st],[row])", [turn.stretch for turn in turns], format="0"),
        calc("lost", "has no sign up to", "", "", f"={lost}", [turn.bracket.lost for turn in turns], scale=size),
        *brackets(turns, size),
        calc("rise", "rises (1) or falls", "", "", "=IF([figure]=0,0,IF([ghi]>=[glo],1,0-1))",
             [turn.tried.rise for turn in turns], format="0", source="0: no step"),
        calc("u1", "first place", "u", "rad", f"=IF(ABS([ghi]-[glo])<=[lost],[lo],MAX([lo],MIN([hi],{line})))",
             [turn.bracket.first for turn in turns], scale=1.0, source="chord"),
        *tried("1", [turn.tried.first for turn in turns], [turn.bracket.first for turn in turns]),
        calc("at1", "there", "", "", f"={figured('1')}", [turn.tried.at_first for turn in turns], scale=size),
        *stepped("2", ("lo", "glo"), ("hi", "ghi"), ("u1", "at1"), [turn.tried.step2 for turn in turns], size),
        *tried("2", [turn.tried.second for turn in turns], [turn.tried.step2.place for turn in turns]),
        calc("at2", "there", "", "", f"={figured('2')}", [turn.tried.at_second for turn in turns], scale=size),
        *stepped("3", ("lo", "glo"), ("u1", "at1"), ("u2", "at2"), [turn.tried.step3 for turn in turns], size),
        *tried("3", [turn.tried.third for turn in turns], [turn.tried.step3.place for turn in turns]),
        calc("at3", "there", "", "", f"={figured('3')}", [turn.tried.at_third for turn in turns], scale=size),
        *stepped("4", ("u1", "at1"), ("u2", "at2"), ("u3", "at3"), [turn.tried.step4 for turn in turns], size),
        calc("at", "angle of its phases", "θ", "°", f"=IF([figure]=0,360,{begin}+DEGREES([u4]))",
             [turn.angle for turn in turns], scale=360.0, format="0.0##"),
    )  # fmt: skip


def rule_table(sheet: Sheet) -> None:
    """Declare the nodes of a section, and what they are weighed by."""
    sheet.table(
        "@rule", "Nodes of a section: its ends, and Gauss–Legendre's", len(NODES),
        constant("x", "place", "x", "", NODES.tolist(), source="−1 … 1"),
        constant("w", "weight", "", "", WEIGHTS.tolist()),
        constant("last", "of the last coefficient", "", "", LAST.tolist(), source="of Legendre's series"),
        constant("inter", "of the barycentric formula", "", "", INTERPOLATING.tolist()),
        constant("first", "which is the first", "", "", FIRST.tolist(), source="powers of 2"),
        *(constant(name, f"of a bend, the node {words}", "", "", bend, source="twice a divided difference")
          for name, words, bend in zip(BENDS, ("before", "itself", "behind"), inner(BEND), strict=True)),
    )  # fmt: skip


def inner(weights: Array) -> list[list[float]]:
    """Return columns of what the nodes between both ends are weighed by; 0 at these."""
    return [[0.0, *one, 0.0] for one in weights.tolist()]


def cuts_table(sheet: Sheet, view: PlacedWork) -> None:
    """Declare where a section can begin: at stretches, and where power turns round."""
    formulas = [f"=[@st.b.{k}]" for k in range(1, view.rows + 1)]
    formulas += [f"=[@turn.at.{k}]" for k in range(1, view.turn_rows + 1)]
    formulas.append("=360+0")
    spans = filled([low for low, _ in view.spans], view.rows, view.spans[-1][0])
    values: list[Any] = [*spans, *(turn.angle for turn in view.turns), TURN]
    sheet.table(
        "@cuts", "Where a section can begin", len(formulas),
        constant("n", "number", "", "", list(range(1, len(formulas) + 1))),
        calc("at", "angle of its phases", "θ", "°", formulas, values, scale=360.0, format="0.0##"),
    )  # fmt: skip


def nodes_table(sheet: Sheet, view: PlacedWork, *more: Quantity) -> None:
    """Declare the drive at the nodes of each section, and more columns."""
    rows = view.section_rows
    ranges = [view.within(held, span) for held, span in view.placed]
    places = np.concatenate([section(span, NODES, -1.0) for span in ranges])
    helds = [held for held, _ in view.placed for _ in NODES]
    numbers = [k for k in range(1, rows + 1) for _ in NODES]
    parents = [view.parent_rows[k - 1] for k in numbers]
    sheet.row += 1
    sheet.table(
        "@pl", "The drive at the nodes of each section", len(numbers),
        constant("sec", "section", "", "", numbers),
        constant("t", "place", "x", "", [x for _ in range(rows) for x in NODES.tolist()]),
        constant("inter", "of the barycentric formula", "", "",
                 [x for _ in range(rows) for x in INTERPOLATING.tolist()]),
        calc("st", "stretch", "", "", "=INDEX([@sec.st],[sec])", parents, format="0"),
        calc("u", "within piece", "u", "rad",
             "=INDEX([@sec.ub],[sec])+(1+[t])/2*(INDEX([@sec.ue],[sec])-INDEX([@sec.ub],[sec]))", places, scale=1.0),
        *columns(view, stacked(view.worked), helds, places),
        calc("P", "torque times speed, before the reducer", "", "Nm rad/s", "=[T]*[w]", view.at_nodes("power"),
             scale=max(1e-9, float(np.abs(view.at_nodes("power")).max()))),
        *([calc(LINE, "line of the motor's curve", "", "Nm", "=([T]^2)^0.5+@sink*([w]^2)^0.5", view.line,
                scale=view.driven.sizes.torque)] if view.knows_falling else ()),
        *more,
    )  # fmt: skip
