"""Extremes and integrals of sections in cells, each from the drive at the section's nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.machine.interpolated import ORDER
from engine.machine.places import (
    BEYOND,
    FAR,
    FARTHEST,
    FINE,
    FLAT,
    KNOWN,
    LEVEL,
    NODES,
    WIDTHS,
    WITHIN,
    Sums,
    Worked,
    largest,
    lost,
)
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.rows import filled
from workbook.entries.units import KW, shown
from workbook.machines.machine.linked.cut import BENDS, begins, bounds
from workbook.machines.machine.linked.worked import LINE, PlacedWork


class Figure(NamedTuple):
    """What the largest value of is wanted in a section: its mark, words, column of nodes, formula; the engine's."""

    mark: str
    words: str
    column: str
    formula: str
    largest: str
    of: Callable[[Worked], Array]


RATIO = "g"
BOTH = "MAX(MAX({f}),0-MIN({f}))"
FIGURES = (
    Figure("T", "torque", "T", "{f}", "MAX({f})", lambda one: one.torque),
    Figure("D", "torque downwards", "T", "(0-{f})", "(0-MIN({f}))", lambda one: -one.torque),
    Figure("S", "torque behind the reducer", "S", "({f}^2)^0.5", BOTH, lambda one: np.abs(one.behind)),
    Figure("w", "speed of the shaft", "w", "({f}^2)^0.5", BOTH, lambda one: np.abs(one.rate)),
    Figure("g", "ratio, its least", RATIO, "(0-{f})", "(0-MIN({f}))", lambda one: -one.first),
    Figure("P", "power", "P", "{f}", "MAX({f})", lambda one: one.power),
    Figure("Q", "power that comes back", "P", "(0-{f})", "(0-MIN({f}))", lambda one: -one.power),
)
LOST = {name: f"{LEVEL!r}*@lost_{name}" for name in ("T", "S", "w", "g", "P", LINE)}
BARYCENTRIC = "SUMPRODUCT([@rule.inter]/({x}-[@rule.x]),{f})/SUMPRODUCT([@rule.inter]/({x}-[@rule.x]))"


def ranges(view: PlacedWork, column: str) -> list[str]:
    """Return the nodes of each section in a column."""
    firsts = range(1, 1 + len(view.at_nodes("torque")), len(NODES))
    return [f"[@pl.{column}.{first}]:[@pl.{column}.{first + len(NODES) - 1}]" for first in firsts]


def lost_rows(view: PlacedWork) -> list[Quantity]:
    """Return the rows of what is next to nothing of speeds, ratios and powers."""
    ratios = [("g", "ratios", view.least("first"))] if view.varies else []
    lines = [(LINE, "the motor's curve", lost(largest(view.line)))] if view.knows_falling else []
    return [
        calc(f"@lost_{column}", f"Next to nothing of {words} is", "", "",
             f"=check_zero*{BOTH.format(f=f'[@pl.{column}]')}", size, format="0E+00", scale=size)
        for column, words, size in (("w", "speeds", view.least("rate")), *ratios,
                                    ("P", "powers", view.least("power")), *lines)
    ]  # fmt: skip


def extremes(view: PlacedWork, figure: Figure) -> list[Quantity]:
    """Return the columns that find the largest value of a figure in each section."""
    m, of, lost, values = figure.mark, ranges(view, figure.column), LOST[figure.column], figure.of
    sizes = [largest(values(one)) for one in view.worked]
    size = max(sizes)
    tops = view.tops(values, view.node_lost(figure.column))
    middle = f"MAX(2,MIN({len(NODES) - 1},[k{m}]))"
    a, b, c = (f"INDEX([@rule.x],{middle}{n})" for n in ("-1", "", "+1"))
    fa, fb, fc = (f"[{name}{m}]" for name in ("fa", "fb", "fc"))

    def each(formula: str, inner: str = "{f}") -> list[str]:
        return [formula.replace("{F}", figure.formula.replace("{f}", inner)).replace("{f}", text) for text in of]

    def at(n: str) -> list[str]:
        return each("={F}", f"INDEX({{f}},{middle}{n})")

    def through(x: str) -> list[str]:
        return each("=" + BARYCENTRIC.replace("{x}", x).replace("{f}", "{F}"))

    def found(name: str) -> list[float]:
        return [getattr(top, name) for top in tops]

    def value(name: str, words: str, formula: list[str] | str, of: str) -> Quantity:
        return calc(f"{name}{m}", words, "", "", formula, found(of), scale=size)

    def around(n: int, far: float) -> list[Quantity]:
        x = f"[x{n}{m}]"
        places = (("a", f"({x}-{far!r})"), ("b", x), ("c", f"({x}+{far!r})"))
        return [value(f"{name}{n}", "around it", through(place), f"{name}{n}") for name, place in places]

    def beside(place: str, farthest: float) -> str:
        held = f"MAX(0-{farthest!r},MIN({farthest!r},{place}))"
        return f"=(INT({held}*{FINE:.0f}+{WITHIN!r})+{WITHIN!r})/{FINE:.0f}"

    def bent(n: int) -> tuple[str, str]:
        one, other, third = (f"[{name}{n}{m}]" for name in ("a", "b", "c"))
        return f"(2*{other}-{one}-{third})", f"({third}-{one})"

    def highest(n: int) -> str:
        bend, slope = bent(n)
        return f"IF({bend}>{lost},MAX(0-{FAR!r},MIN({FAR!r},{slope}/(2*{bend}))),0)"

    narrow, slope = bent(len(WIDTHS))
    last, width = f"[x{len(WIDTHS)}{m}]", repr(WIDTHS[-1])
    high = f"MIN({BEYOND!r},(1-{last})/{width},{slope}/(2*{narrow}))"
    far = f"MAX(0-{BEYOND!r},(0-1-{last})/{width},{high})"
    rise = f"=IF({narrow}<={FLAT!r}*{lost},0,{far}*({slope}-{far}*{narrow})/2)"
    vertex = f"{b}-(({b}-{a})^2*({fb}-{fc})-({b}-{c})^2*({fb}-{fa}))/(2*[bend{m}])"
    return [
        calc(f"k{m}", f"{figure.words}: largest at node", "", "",
             each(f"={len(NODES)}-INT(LN(SUMPRODUCT(({{F}}>={figure.largest.replace('{f}', '{r}')}-{lost})"
                  "*[@rule.first]))/LN(2)+check_zero)".replace("{r}", "{f}")), found("node"), format="0"),
        value("fa", "before it", at("-1"), "fa"), value("fb", "there", at(""), "fb"),
        value("fc", "behind it", at("+1"), "fc"),
        value("bend", "bend", f"=({b}-{a})*({fb}-{fc})-({b}-{c})*({fb}-{fa})", "bend"),
        calc(f"x1{m}", "place 1", "x", "",
             beside(f"IF([bend{m}]<={lost},INDEX([@rule.x],[k{m}]),{vertex})", FARTHEST[0]), found("x1"), scale=KNOWN),
        *around(1, WIDTHS[0]),
        *(column for n in range(2, len(WIDTHS) + 1) for column in (
            calc(f"x{n}{m}", f"place {n}", "x", "",
                 beside(f"[x{n - 1}{m}]+{WIDTHS[n - 2]!r}*{highest(n - 1)}", FARTHEST[n - 1]), found(f"x{n}"),
                 scale=KNOWN),
            *around(n, WIDTHS[n - 1]))),
        value("rise", "rises above it by", rise, "rise"),
        calc(f"top{m}", f"{figure.words}: largest", "", "",
             each(f"=MAX([b{len(WIDTHS)}{m}]+[rise{m}],{figure.largest})"), found("value"), scale=size),
    ]  # fmt: skip


def sections_table(sheet: Sheet, view: PlacedWork, *more: Quantity) -> None:
    """Declare the sections, with their extremes and integrals, and more columns."""
    rows, driven = view.section_rows, view.driven
    square, work, cube, _ = driven.scales
    torque, behind, turning = (ranges(view, column) for column in ("T", "S", "w"))
    half = "=[on]*([ue]-[ub])/2*SUMPRODUCT([@rule.w],"
    works = [f"{half}{t}*{w})*@i1/@omega" for t, w in zip(torque, turning, strict=True)]
    cubes = [f"{half}({s}^2)^1.5*({w}^2)^0.5)" for s, w in zip(behind, turning, strict=True)]
    bends = [bend(n) for n in range(0, len(view.at_nodes("torque")), len(NODES))]
    lasts = [f"=[on]*ABS(SUMPRODUCT([@rule.last],{one}))" for one in torque]

    def of(name: str) -> list[float]:
        return [getattr(one, name) for one in view.sums]

    sheet.row += 1
    sheet.table(
        "@sec", "Sections: in each power keeps its way through every stage", rows,
        constant("k", "section", "k", "", list(range(1, rows + 1))),
        *begins("@sec", "[@cuts.at]", rows, view.sections),
        calc("st", "stretch", "", "", "=MATCH(([b]+[e])/2,[@st.b],1)", view.parent_rows, format="0"),
        *bounds(view, "INDEX([@st.q],[st])", [view.within(held, span) for held, span in view.placed]),
        calc("square", "∫T²", "", "", [f"{half}{one}^2)" for one in torque], of("square"), scale=square),
        calc("work", "work of the motor", "", "J", works, of("work"), scale=work),
        calc("cube", "∫|S|³ |φ̇|", "", "", cubes, of("cube"), scale=cube),
        calc("way", "∫|φ̇|", "", "", [f"{half}({one}^2)^0.5)" for one in turning], of("way"), scale=view.rate),
        calc("rest", "last coefficient of T", "", "Nm", lasts,
             of("rest"), scale=driven.sizes.torque),
        calc("off", "straight lines are off by at most", "", "kW", bends, filled(shown(np.array(view.offs), KW), rows),
             scale=shown(view.most_power, KW)),
        *(column for figure in figures(view) for column in extremes(view, figure)),
        *more,
    )  # fmt: skip


def figures(view: PlacedWork) -> list[Figure]:
    """Return what the largest values of are wanted: of a ratio that changes, of a motor whose peak torque falls."""
    found = [figure for figure in FIGURES if view.varies or figure.column != RATIO]
    line = Figure(LINE, "line of the motor's curve", LINE, "{f}", "MAX({f})", view.line_at)
    return [*found, line] if view.knows_falling else found


def bend(before: int) -> str:
    """Return the formula of by how much straight lines are off at most, of the section behind so many nodes."""
    n = len(NODES)
    each = "+".join(
        f"[@rule.{name}.2]:[@rule.{name}.{n - 1}]*[@pl.P.{before + k}]:[@pl.P.{before + n - 3 + k}]"
        for k, name in enumerate(BENDS, 1)
    )
    short = "MIN(1,RADIANS(bus_step)/([ue]-[ub]))"
    return f"=[on]*@i1/1000/power_efficiency*SUMPRODUCT(({each})^{ORDER})^(1/{ORDER})*{short}^2/2"


def sums_of(view: PlacedWork) -> Sums:
    """Return the integrals of all sections together."""
    return Sums(*map(sum, zip(*view.sums, strict=True)))
