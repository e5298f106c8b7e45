"""A table of positions in cells: its points, their monotone cubic, and its inverse.

Between two points dy/dφ is that of y = y_k + Δy t (b + t (c2 + t c3)), t the share of the part's width; t of a position
is found by counting points of a grid twice, a chord, and two steps of Newton's method.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from engine.laws.base import Array
from engine.machine.places import Worked
from engine.mechanisms.inverted import Cubics, Inverted
from engine.mechanisms.linkage import Linkage, near_end
from engine.mechanisms.table import PositionTable
from workbook.book.declare import Quantity, Sheet, calc, constant, given
from workbook.book.rows import filled
from workbook.book.sentence import quoted
from workbook.machines.machine.linked import passes
from workbook.machines.machine.linked.changing import LinkedWork
from workbook.machines.machine.linked.driven import FALLS, SHARP, LinkedDriven

SIZED = "@count>=2"
FITS = "SUM([@cubics.falls])+SUM([@cubics.sharp])=0"
HOLDS = "angle and position rise from point to point"
WITHIN = "within its table"
PART = "INDEX([@cubics.{name}],[sg{mark}])"
COEFFICIENTS = {"kb": "b", "kc": "c2", "kd": "c3"}
"""columns of a place, by those of the cubics"""
SOURCE = "Fritsch and Carlson 1980"


def wrong(unit: str) -> str:
    """Return the formula of what is said of points that do not go together."""

    def at(column: str, place: str) -> str:
        return f"INDEX([@points.{column}],{place})"

    def told(words: str, *figures: str) -> str:
        pieces = [quoted(piece) for piece in words.split("{}")]
        return "&".join(part for pair in zip(pieces, [*figures, '""'], strict=True) for part in pair)

    row = "MATCH(1,[@cubics.falls],0)"
    shown = [f"ROUND({at(column, place)},9)" for place in (row, f"{row}-1") for column in ("angle", "position")]
    falls = told(FALLS, row, *shown[:2], quoted(unit), *shown[2:], quoted(unit))
    bend = "MATCH(1,[@cubics.sharp],0)"
    return f"IF(SUM([@cubics.falls])>0,{falls},{told(SHARP, bend, f'({bend}+1)')})"


def entries(driven: LinkedDriven, key: str) -> list[Quantity]:
    """Return no rows: what is entered is a table."""
    return []


def entered(sheet: Sheet, driven: LinkedDriven, rows: int) -> None:
    """Declare the points."""
    e, key, unit = driven.given.points, f"axes.{driven.number - 1}.mechanism.points.*", driven.entered.unit
    sheet.row += 1
    sheet.table(
        "@points", "Points of the table: leave spare rows empty", rows,
        constant("k", "point", "k", "", list(range(1, rows + 1))),
        given("angle", "angle of the shaft", "φ", "°", filled([p.angle for p in e], rows, None), f"{key}.angle",
              format="0.0##", source="rises strictly"),
        given("position", "position of the load", "y", unit, filled([p.position for p in e], rows, None),
              f"{key}.position", format="0.0##", source="rises strictly"),
    )  # fmt: skip


def cubics(driven: LinkedDriven, rows: int) -> list[Quantity]:
    """Return the columns of points in rad and SI, of slopes, and of the cubic of each part."""
    one, found = table_of(driven.linkage), Cubics.of(table_of(driven.linkage))
    angle, y, _ = one.columns
    metres, base = ("={}/1000", "m") if driven.travels else ("=RADIANS({})", "rad")
    angles, positions = ([f"[@points.{name}.{k}]" for k in range(1, rows + 1)] for name in ("angle", "position"))
    entered = [f"=IF(COUNT({one},{other})=2,1,0)" for one, other in zip(angles, positions, strict=True)]
    after = f"MIN([k]+1,{rows})"

    def at(name: str, place: str = after) -> str:
        return f"INDEX([@cubics.{name}],{place})"

    def part(formula: str, spare: str = "0") -> str:
        return f"=IF([k]<@count,{formula},{spare})"

    before = {name: at(name, "MAX([k]-1,1)") for name in ("w", "chord", "phi", "y")}
    mean = f"([w]*{before['chord']}+{before['w']}*[chord])/([w]+{before['w']})"
    free = f"=IF([k]>@count,0,IF([k]=1,[chord],IF([k]=@count,{before['chord']},{mean})))"
    limit = f"IF([k]<@count,MIN(1,3*[chord]/SQRT(({{own}})^2+{at('free')}^2)),1)"
    limits = [f"={limit.format(own='[free]')}", *spread(f"={limit.format(own='[free]*[limit-1]')}", rows)]
    slopes = ["=[free]*[limit]", *spread("=[free]*[limit-1]*[limit]", rows)]
    fall = f"MIN([phi]-{before['phi']},[y]-{before['y']})<=0"

    def of(values: Sequence[float] | Array, spare: float = 0.0) -> list[float]:
        return filled(values, rows, spare)

    return [
        calc("on", "is used", "", "", entered, of([1 for _ in y]), format="0"),
        calc("phi", "angle", "φ", "rad", [f"=RADIANS({one})" for one in angles], of(angle)),
        calc("y", "position", "y", base, [metres.format(one) for one in positions], of(y)),
        calc("w", "to the next", "Δφ", "rad", part(f"MAX(1E-12,{at('phi')}-[phi])", "1"), of(found.width, 1.0)),
        calc("rise", "to the next", "Δy", base, part(f"MAX(1E-12,{at('y')}-[y])", "1"), of(found.rise, 1.0)),
        calc("chord", "slope to the next", "Δy/Δφ", "", part("[rise]/[w]"), of(found.chord)),
        calc("free", "slope", "", "", free, of(found.free), source="parabola through three points"),
        calc("limit", "limited by", "", "", limits, of(found.limit, 1.0), source=SOURCE),
        calc("slope", "slope", "dy/dφ", "", slopes, of(found.slope)),
        calc("b", "of t", "b", "", part("[slope]*[w]/[rise]", "1"), of(found.begin, 1.0)),
        calc("end", "slope at t = 1", "", "", part(f"{at('slope')}*[w]/[rise]", "1"), of(found.end, 1.0)),
        calc("c2", "of t²", "c2", "", part("3-2*[b]-[end]"), of(found.c2), scale=3.0),
        calc("c3", "of t³", "c3", "", part("[b]+[end]-2"), of(found.c3), scale=3.0),
        calc("falls", "does not rise", "", "", f"=IF(AND([k]>1,[on]=1),IF({fall},1,0),0)", 0, format="0;;"),
        calc("sharp", "bends too sharply", "", "", part("IF(MIN([b],[end])<0.01,1,0)"), 0, format="0;;"),
    ]  # fmt: skip


def spread(formula: str, rows: int) -> list[str]:
    """Return a formula for each row but the first."""
    return [formula for _ in range(rows - 1)]


def sizes(driven: LinkedDriven) -> list[Quantity]:
    """Return the rows of where the mechanism can bring its load to."""
    low, high, *_ = driven.linkage.reach
    base = driven.axis.base
    return [
        calc("@count", "Points of the table", "", "", "=SUM([@cubics.on])", len(driven.given.points), format="0"),
        calc("@low", "Lowest position that is reached", "", base, "=INDEX([@cubics.y],1)", low, scale=high - low),
        calc("@high", "Highest position", "", base, "=INDEX([@cubics.y],MAX(1,@count))", high, scale=high - low),
        calc("@near_end", "So near to an end counts as beyond it", "", base, "=0-check_zero*(@high-@low)",
             near_end(driven.linkage), format="0E+00", source="below 0: so far beyond counts as at it"),
    ]  # fmt: skip


def end(which: str) -> str:
    """Return the formula of the name of an end of the reach, ``low`` or ``high``."""
    return quoted("begin of the table" if which == "low" else "end of the table")


def table(sheet: Sheet, driven: LinkedDriven, rows: int) -> None:
    """Declare the cubics between the points."""
    sheet.table(
        "@cubics", "The monotone cubic through the points", rows,
        constant("k", "point", "k", "", list(range(1, rows + 1))),
        *cubics(driven, rows),
    )  # fmt: skip


def passing(sheet: Sheet, view: LinkedWork) -> None:
    """Declare where phases pass points."""
    passes.passing(sheet, view.one, view.passes)


def held(driven: LinkedDriven, position: str, within: list[float]) -> list[Quantity]:
    """Return the columns of a stretch: the position in its middle, and the part of the table."""
    one = table_of(driven.linkage)
    parts = [int(one.part(np.array(y))) + 1 for y in within]
    return [
        calc("ym", "position in its middle", "y", driven.axis.base, f"={position}-@near_end", within,
             scale=driven.axis.motion.size(0), source="a hair further"),
        calc("sg", "part of the table", "", "",
             "=MAX(1,MIN(@count-1,SUMPRODUCT([@cubics.on]*([@cubics.y]<=[ym]))))", parts, format="0"),
    ]  # fmt: skip


def ratios(driven: LinkedDriven, at: Worked, within: Array, mark: str = "") -> list[Quantity]:
    """Return the columns of φ' and φ'' at the position in the column ``p``, each name with a mark at its end."""
    found = Inverted.of(table_of(driven.linkage), at.y, within)
    rates, base = float(np.abs(at.second).max()), driven.axis.base

    def of(name: str) -> str:
        return PART.format(name=name, mark=mark)

    def col(name: str) -> str:
        return f"[{name}{mark}]"

    b, c2, c3 = (col(name) for name in COEFFICIENTS)

    def cubic(t: str) -> str:
        return f"{t}*({b}+{t}*({c2}+{t}*{c3}))"

    def slope(t: str) -> str:
        return f"({b}+{t}*(2*{c2}+{t}*3*{c3}))"

    def counted(at: str, step: str) -> str:
        place = f"({at}+{step}*[grid.at])"
        below = f"SUMPRODUCT(({cubic(place)}<{col('eta')}-check_zero/1000)*1)"
        return f"={at}+{step}*MIN(99,{below})/100"

    fine = col("tb")
    last = f"({fine}+0.0001)"
    chord = f"({col('eta')}-{cubic(fine)})/({cubic(last)}-{cubic(fine)})"

    def newton(t: str) -> str:
        return f"=MAX({fine},MIN({last},{t}-({cubic(t)}-{col('eta')})/{slope(t)}))"

    t = col("te")
    return [
        calc(f"sg{mark}", "part of the table", "", "", "=INDEX([@st.sg],[st])", found.part.tolist(), format="0"),
        calc(f"eta{mark}", "share of its rise", "", "", f"=({col('p')}-{of('y')})/{of('rise')}", found.height,
             scale=1.0),
        *(calc(f"{name}{mark}", "of its cubic", column, "", f"={of(column)}", coefficients, scale=3.0)
          for (name, column), coefficients in zip(COEFFICIENTS.items(), found.coefficients, strict=True)),
        calc(f"ta{mark}", "t, not before", "", "", counted("0", "1"), found.rough, scale=1.0),
        calc(f"tb{mark}", "t, not before", "", "", counted(col("ta"), "0.01"), found.fine, scale=1.0),
        calc(f"tc{mark}", "t", "", "", f"={fine}+0.0001*MAX(0,MIN(1,{chord}))", found.chord, scale=1.0,
             source="chord"),
        calc(f"td{mark}", "t", "", "", newton(col("tc")), found.step, scale=1.0, source="Newton"),
        calc(f"te{mark}", "share of its width", "t", "", newton(col("td")), found.share, scale=1.0, source="Newton"),
        calc(f"g{mark}", "ratio", "φ'", f"rad/{base}", f"={of('w')}/({of('rise')}*{slope(t)})", at.first,
             source="1/(dy/dφ)"),
        calc(f"h{mark}", "its change", "φ''", f"rad/{base}²",
             f"=0-{of('w')}*(2*{c2}+6*{t}*{c3})/({of('rise')}^2*{slope(t)}^3)", at.second, scale=rates,
             source="−y''/y'³"),
    ]  # fmt: skip


def angle(driven: LinkedDriven, y: Array, within: Array) -> Quantity:
    """Return the column of the shaft's angle at positions."""
    one = table_of(driven.linkage)
    return calc("phi", "angle of the shaft", "φ", "rad",
                f"={PART.format(name='phi', mark='')}+[te]*{PART.format(name='w', mark='')}", one.shaft(y).angle,
                scale=1.0, source="as the table tells it")  # fmt: skip


def table_of(linkage: Linkage) -> PositionTable:
    """Return a linkage of points as what it is."""
    if not isinstance(linkage, PositionTable):
        raise TypeError(f"{linkage.name} is no table")
    return linkage
