"""A table of positions in cells: its points, and the curve of fifth degree through them, φ over y.

At each point φ' and φ'' are those of the parabola y(φ) through the point and its neighbours; where the points bend so
sharply that the curve might fall, φ'' is 0 and φ' is held near the flatter chord.
"""

from typing import Any

import numpy as np

from engine.drive.mechanisms.variable_ratio import PositionTable, near_end
from engine.laws.base import Array
from workbook.book.declare import Quantity, Sheet, calc, columns_of, constant
from workbook.book.quantity import PLAIN
from workbook.book.rows import NOT_ZERO, filled
from workbook.book.sentence import quoted
from workbook.machines.machine.drive.driven import FALLS, Driven, of_kind
from workbook.machines.machine.drive.mechanisms.page import Column, LinkagePage
from workbook.machines.machine.mechanism import Table

LEVEL = 1e-4  # of a ratio over the narrowest part; a smaller change of it is rounding, as of a table of a straight line
D = "INDEX([@curve.d1:d5],[part],0)"  # the coefficients of t to t⁵ of the part of the table in which a position is


def entered(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the points."""
    column = columns_of(of_kind(Table, driven.given).points, f"axes.{driven.number - 1}.mechanism.points", rows)
    sheet.row += 1
    sheet.table(
        "@points", "Points of the table: leave spare rows empty", rows,
        constant("k", "point", "k", "", list(range(1, rows + 1))),
        column("angle", "angle of the shaft", "φ", "°", "angle", "rises strictly", format=PLAIN),
        column("position", "position of the load", "y", driven.entered.unit, "position", "rises strictly",
               format=PLAIN),
    )  # fmt: skip


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of where the mechanism can bring its load to."""
    one = of_kind(PositionTable, driven.linkage)
    low, high, *_ = one.reach
    base = driven.axis.base
    return [
        calc("@count", "Points of the table", "", "", "=SUM([@curve.on])", len(of_kind(Table, driven.given).points),
             format="0"),
        calc("@low", "Lowest position that is reached", "", base, "=INDEX([@curve.y],1)", low, scale=high - low),
        calc("@high", "Highest position", "", base, "=INDEX([@curve.y],MAX(1,@count))", high, scale=high - low),
        calc("@near_end", "So near to an end counts as beyond it", "", base, "=0-check_zero*(@high-@low)",
             near_end(one), "below 0: so far beyond counts as at it", format="0E+00"),
    ]  # fmt: skip


def table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the curve between the points."""
    sheet.table(
        "@curve", "The curve through the points", rows,
        constant("k", "point", "k", "", list(range(1, rows + 1))),
        *points(driven, rows), *slopes(driven, rows), *powers(driven, rows),
    )  # fmt: skip


def at(name: str, place: str) -> str:
    """Return the formula of a figure of another point."""
    return f"INDEX([@curve.{name}],{place})"


AFTER, BEFORE = "MIN([k]+1,MAX(2,@count))", "MAX([k]-1,1)"


def points(driven: Driven, rows: int) -> list[Quantity]:
    """Return the columns of the points in rad and SI, and of the chords between them."""
    one = of_kind(PositionTable, driven.linkage)
    angle, y, *_ = one.columns
    metres, base = ("{}/1000", "m") if driven.travels else ("RADIANS({})", "rad")
    own = "INDEX([@points.{}],[k])"

    def of(values: Any) -> list[Any]:
        return filled(values, rows)

    width, chord = np.diff(y), np.diff(angle) / np.diff(y)
    entry = f"COUNT({own.format('angle')},{own.format('position')})=2"
    return [
        calc("on", "is used", "", "", f"=IF({entry},1,0)", of(np.ones(y.size)), format="0"),
        calc("phi", "angle", "φ", "rad", f"=RADIANS({own.format('angle')})", of(angle)),
        calc("y", "position", "y", base, f"={metres.format(own.format('position'))}", of(y)),
        calc("w", "to the next", "Δy", base, f"=IF([k]<@count,{at('y', AFTER)}-[y],0)", of(width)),
        calc("chord", "slope to the next", "Δφ/Δy", "", f"=IF([k]<@count,({at('phi', AFTER)}-[phi])/[w],0)", of(chord)),
        calc("falls", "does not rise", "", "",
             f"=[on]*([k]>1)*IF(OR([phi]<={at('phi', BEFORE)},[y]<={at('y', BEFORE)}),1,0)", 0, format="0;;"),
    ]  # fmt: skip


def slopes(driven: Driven, rows: int) -> list[Quantity]:
    """Return the columns of φ' and φ'' at the points: of the parabola, and as they are used."""
    one = of_kind(PositionTable, driven.linkage)
    found = one.parabolas
    before, middle, after = (at("phi", place) for place in ("[m]-1", "[m]", "[m]+1"))
    left, right = at("chord", "[m]-1"), at("chord", "[m]")
    about = np.maximum(2, np.minimum(np.arange(1, len(found.slope) + 1), len(found.slope) - 1))

    def of(values: Any, spare: float = 0.0) -> list[Any]:
        return filled(np.asarray(values) + 0.0, rows, spare)

    def used(formula: str) -> str:
        return f"=IF([on]=1,{formula},0)"

    chords = np.diff(one.columns[0]) / one.widths
    first = np.divide(1.0, found.slope, out=np.zeros_like(found.slope), where=found.slope > 0.0)
    place = "MIN([k],MAX(1,@count-1))"
    return [
        calc("m", "parabola about point", "", "", used("MAX(2,MIN([k],@count-1))"), of(about), format="0"),
        calc("bend", "curvature of the parabola", "y''", "",
             f"=IF(AND([on]=1,@count>2),2*(1/{right}-1/{left})/({after}-{before}),0)", of(found.bend),
             "through three points", scale=change(found.bend, found.slope, np.diff(one.columns[0]))),
        calc("slope", "its slope", "y'", "", used(f"1/{left}+[bend]/2*(2*[phi]-{middle}-{before})"), of(found.slope),
             "there"),
        calc("h0", "to the point before", "", "", used(at("w", BEFORE)), of(found.widths[0])),
        calc("h1", "to the next", "", "", used(at("w", place)), of(found.widths[1])),
        calc("c0", "slope from the point before", "Δφ/Δy", "", used(at("chord", BEFORE)),
             of(np.append(chords[0], chords))),
        calc("c1", "slope to the next", "Δφ/Δy", "", used(at("chord", place)), of(np.append(chords, chords[-1]))),
        calc("flat", "flatter of both", "", "", "=MIN([c0],[c1])", of(found.flat)),
        calc("first", "φ' of the parabola", "", "", used("IF([slope]>0,1/[slope],0)"), of(first),
             "1/y'; 0 where y' is not above 0"),
        calc("b", "φ'' of the parabola", "", "", "=0-[bend]*[first]^3", of(found.second), "−y''/y'³",
             scale=change(found.second, first, one.widths)),
        calc("calm", "the curve rises", "", "",
             used("IF(AND([first]>0,4*[first]+MIN([h1]*[b],0-[h0]*[b])>0,"
                  "8*[first]+[h1]*[b]<10*[c1],8*[first]-[h0]*[b]<10*[c0]),1,0)"),
             of(found.calm), format="0", source="1: the parabola's slope and curvature are used"),
        calc("g", "φ' there", "φ'", "", "=IF([on]=0,0,IF([calm]=1,[first],1/MAX(0.8/[flat],MIN(4/[flat],[slope]))))",
             of(one.columns[2])),
        calc("h", "φ'' there", "φ''", "", "=[calm]*[b]", of(one.columns[3]),
             scale=change(found.second, first, one.widths)),
    ]  # fmt: skip


def powers(driven: Driven, rows: int) -> list[Quantity]:
    """Return the coefficients of φ over the share t of each part: φ = φ_k + d1 t + d2 t² + … + d5 t⁵."""
    one = of_kind(PositionTable, driven.linkage)
    found = np.vstack([one.powers[:, 1:], np.zeros((rows - len(one.powers), 5))]).T
    angle, _, first, second = one.columns
    d1, d2 = first[:-1] * one.widths, second[:-1] * one.widths**2 / 2.0
    more = {
        "e0": ("angle beyond these two", f"{at('phi', AFTER)}-[phi]-[d1]-[d2]", np.diff(angle) - d1 - d2),
        "e1": ("slope beyond them", f"{at('g', AFTER)}*[w]-[d1]-2*[d2]", first[1:] * one.widths - d1 - 2.0 * d2),
        "e2": ("curvature beyond them", f"{at('h', AFTER)}*[w]^2-2*[d2]", second[1:] * one.widths**2 - 2.0 * d2),
    }
    formulas = ("[g]*[w]", "[h]*[w]^2/2", "10*[e0]-4*[e1]+[e2]/2", "7*[e1]-15*[e0]-[e2]", "6*[e0]-3*[e1]+[e2]/2")
    words = "t", "t²", "t³", "t⁴", "t⁵"
    size = float(np.abs(one.powers).max())
    return [
        *(calc(f"d{n}", f"coefficient of {word}", f"d{n}", "rad", f"=IF([k]<@count,{formula},0)", values, scale=size)
          for n, (word, formula, values) in enumerate(zip(words, formulas, found, strict=True), 1)),
        *(calc(name, label, "", "rad", f"=IF([k]<@count,{formula},0)", filled(np.asarray(values), rows),
               "at the next point", scale=size)
          for name, (label, formula, values) in more.items()),
    ]  # fmt: skip


def ratios(driven: Driven, position: Array, of: Column) -> list[Quantity]:
    """Return the columns of φ', φ'' and φ at the position in the column ``y``."""
    one = of_kind(PositionTable, driven.linkage)
    part = one.part(position)
    share = (position - one.columns[1][part]) / one.widths[part]
    turned, first, second = one.shaft(position)
    width = "INDEX([@curve.w],[part])"
    passed = "SUMPRODUCT([@curve.on]*([@curve.y]<=[y]+check_zero))"
    return [
        calc("part", "part of the table", "", "", f"=MAX(1,MIN(@count-1,{passed}))",
             of(np.asarray(part, dtype=np.float64) + 1.0), format="0"),
        calc("t", "share of the part", "t", "", f"=([y]-INDEX([@curve.y],[part]))/{width}{NOT_ZERO}", of(share),
             scale=1.0),
        calc("g", "ratio", "φ'", "", f"=SUMPRODUCT({D},{{1,2,3,4,5}},[t]^{{0,1,2,3,4}})/{width}", of(first), "dφ/dy"),
        calc("h", "its change", "φ''", "", f"=SUMPRODUCT({D},{{0,2,6,12,20}},[t]^{{0,0,1,2,3}})/{width}^2", of(second),
             "d²φ/dy²", scale=change(second, first, one.widths)),
        calc("phi", "angle of the shaft", "φ", "rad", f"=INDEX([@curve.phi],[part])+SUMPRODUCT({D},[t]^{{1,2,3,4,5}})",
             of(turned), scale=1.0),
    ]  # fmt: skip


def change(values: Array, ratios: Array, widths: Array) -> float:
    """Return how large changes of ratios grow over parts of these widths."""
    return max(float(np.abs(values).max()), LEVEL * float(np.abs(ratios).max()) / float(widths.min()))


def varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other points for the i-th axis in the k-th variation, and how far its load then moves (mm or °)."""
    steps = [9.0 + 0.7 * ((j + i + k) % 3) for j in range((room, room - 1, 2)[k % 3])]
    places = [sum(steps[:j]) - 6.0 for j in range(len(steps))]
    points = [{"angle": (22.0 + k) * j - 40.0, "position": y} for j, y in enumerate(places)]
    return {"points": points}, -5.0, 0.9 * places[-1]


TABLE = LinkagePage(
    lambda driven, key: [], sizes, ratios, varied, "@count>=2", "SUM([@curve.falls])=0",
    "angle and position rise from point to point",
    f"{quoted(FALLS.partition(' {}')[0] + ' ')}&MATCH(1,[@curve.falls],0)"
    f"&{quoted(' does not rise in angle and position')}",
    "within its table", {"low": quoted("begin of the table"), "high": quoted("end of the table")}, entered, table,
)  # fmt: skip
