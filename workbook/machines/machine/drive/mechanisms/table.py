"""A table of positions in cells: its points, and the curve of fifth degree through them, φ over y.

At each point φ' and φ'' are those of the parabola y(φ) through the point and its neighbours; where the points bend so
sharply that the curve might fall, φ'' is 0 and φ' is held near the flatter chord.
"""

from typing import Any

import numpy as np

from engine.drive.mechanisms.variable_ratio import PositionTable, near_end
from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import NOT_ZERO, filled
from workbook.book.sentence import quoted
from workbook.entries.facts import table_of
from workbook.machines.machine.drive.driven import FALLS, Driven, of_kind
from workbook.machines.machine.drive.mechanisms.page import Column, LinkagePage
from workbook.machines.machine.mechanism import Table, TablePoint

CELLS = cell_tables(__file__)

LEVEL = 1e-4  # of a ratio over the narrowest part; a smaller change of it is rounding, as of a table of a straight line


def entered(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the points."""
    cell, given = CELLS["entered"], of_kind(Table, driven.given).points
    column = table_of(TablePoint).columns(given, f"axes.{driven.number - 1}.mechanism.points", rows)
    sheet.row += 1
    cell.place(sheet, column("angle"), column("position", unit=driven.entered.unit))


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of where the mechanism can bring its load to."""
    cell = CELLS["sizes"]
    curve = of_kind(PositionTable, driven.linkage)
    low, high, *_ = curve.reach
    base = driven.axis.base
    return [
        cell("@count", len(of_kind(Table, driven.given).points)),
        cell("@low", low, base=base, scale=high - low),
        cell("@high", high, base=base, scale=high - low),
        cell("@near_end", near_end(curve), base=base),
    ]


def table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the curve between the points: these in SI, the chords, φ' and φ'', and the powers of φ.

    Of φ' and φ'' there are those of the parabola, and as they are used. Over the share t of each part φ is
    φ_k + d1 t + d2 t² + … + d5 t⁵.
    """
    cell, linkage = CELLS["curve"], of_kind(PositionTable, driven.linkage)
    parabolas = linkage.parabolas
    (angle, y, ratios, changes), width = linkage.columns, linkage.widths
    in_si, base = ("{}/1000", "m") if driven.travels else ("RADIANS({})", "rad")
    slope, chords = parabolas.slope, np.diff(angle) / width
    about = np.maximum(2, np.minimum(np.arange(1, slope.size + 1), slope.size - 1))
    first = np.divide(1.0, slope, out=np.zeros_like(slope), where=slope > 0.0)
    size, largest = change(parabolas.second, first, width), float(np.abs(linkage.powers).max())
    d1, d2 = ratios[:-1] * width, changes[:-1] * width**2 / 2.0
    beyond = {"e0": np.diff(angle) - d1 - d2, "e1": ratios[1:] * width - d1 - 2.0 * d2}
    beyond["e2"] = changes[1:] * width**2 - 2.0 * d2

    def of(values: Any) -> list[Any]:
        return filled(np.asarray(values) + 0.0, rows)

    cell.place(
        sheet,
        cell("on", of(np.ones(y.size))),
        cell("phi", of(angle)),
        cell("y", of(y), base=base, in_si=in_si.format("INDEX([@points.position],[k])")),
        cell("w", of(width), base=base),
        cell("chord", of(chords)),
        cell("falls", 0),
        cell("m", of(about)),
        cell("bend", of(parabolas.bend), scale=change(parabolas.bend, slope, np.diff(angle))),
        cell("slope", of(slope)),
        cell("h0", of(parabolas.widths[0])),
        cell("h1", of(parabolas.widths[1])),
        cell("c0", of(np.append(chords[0], chords))),
        cell("c1", of(np.append(chords, chords[-1]))),
        cell("flat", of(parabolas.flat)),
        cell("first", of(first)),
        cell("b", of(parabolas.second), scale=size),
        cell("calm", of(parabolas.calm)),
        cell("g", of(ratios)),
        cell("h", of(changes), scale=size),
        *(cell(f"d{n}", of(linkage.powers[:, n]), scale=largest) for n in range(1, 6)),
        *(cell(name, of(values), scale=largest) for name, values in beyond.items()),
    )


def ratios(driven: Driven, position: Array, of: Column) -> list[Quantity]:
    """Return the columns of φ', φ'' and φ at the position in the column ``y``."""
    cell = CELLS["ratios"]
    curve = of_kind(PositionTable, driven.linkage)
    part = curve.part(position)
    share = (position - curve.columns[1][part]) / curve.widths[part]
    turned, first, second = curve.shaft(position)
    return [
        cell("part", of(np.asarray(part, dtype=np.float64) + 1.0)),
        cell("t", of(share), not_zero=NOT_ZERO, scale=1.0),
        cell("g", of(first)),
        cell("h", of(second), scale=change(second, first, curve.widths)),
        cell("phi", of(turned), scale=1.0),
    ]


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
    sizes,
    ratios,
    varied,
    "@count>=2",
    "SUM([@curve.falls])=0",
    "angle and position rise from point to point",
    f"{quoted(FALLS.partition(' {}')[0] + ' ')}&MATCH(1,[@curve.falls],0)"
    f"&{quoted(' does not rise in angle and position')}",
    "within its table",
    {"low": quoted("begin of the table"), "high": quoted("end of the table")},
    entered,
    table,
)
