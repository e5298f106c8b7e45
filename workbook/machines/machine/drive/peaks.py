"""The peaks of a drive: the largest at a point, and the top of the parabola through that and its neighbours.

Where a piece's acceleration only rises or only falls, torques of a constant ratio are largest at a point itself. Else
a peak may lie between points, and the parabola finds it to 0.5 %.
"""

from __future__ import annotations

from typing import NamedTuple

from engine.drive.drive_points import Peak, peak
from engine.drive.quadrature import COUNT
from engine.laws.base import Array
from workbook.book.declare import Sheet, calc, constant
from workbook.entries.units import DEGREE, KW, RPM, shown
from workbook.machines.machine.drive.view import DriveView

BEYOND = "[sign]*([s0]-[s1])<=0,[sign]*([s0]*(2*[a]+[b])-[s1]*[a])<0,[sign]*([s1]*([a]+2*[b])-[s0]*[b])>0"
"""where the parabola's top is not between the neighbours: points on a line that tie with the largest"""
ABOUT = (
    "y at the largest point, y_0 and y_1 at its neighbours, a and b degrees away: the parabola's top is "
    "w + m² (Δ_0 + Δ_1)/4(s_0 − s_1), s_0 and s_1 the slopes on both sides, m = (s_0 b + s_1 a)/(a + b)."
)


class Figure(NamedTuple):
    """A quantity of the table of points: its column, its values, what it is called, its size."""

    column: str
    values: Array
    words: str
    scale: float


def figures(view: DriveView) -> list[Figure]:
    """Return the quantities whose peaks are results: of each its highest and its lowest."""
    points, size = view.points, view.scales
    found = [
        Figure("T", points.torque, "torque of the motor", size.torque),
        Figure("S", view.load.behind, "output torque of the reducer", size.behind),
        Figure("P", shown(points.power, KW), "power of the motor", size.power),
    ]
    return [*found, Figure("n", shown(points.speed, RPM), "speed of the motor", size.rpm)] if view.varies else found


def top(name: str, end: str = "high") -> str:
    """Return the reference to a peak: of the column T, S, P or n, its ``high`` or its ``low``."""
    row = 2 * "TSPn".index(name) + (1 if end == "high" else 2)
    return f"[@peaks.top.{row}]"


def peaks_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the peaks, a row for the highest and one for the lowest of each quantity."""
    each = [(one, sign) for one in figures(view) for sign in (1, -1)]
    found = [peak(sign * one.values, shown(view.load.place, DEGREE)) for one, sign in each]
    rows = len(each)
    last = view.rows * COUNT
    size = max(one.scale for one, _ in each)

    def of(formula: str) -> list[str]:
        return [formula.replace("{y}", f"[@pt.{one.column}]") for one, _ in each]

    signs = [sign for _, sign in each]
    neighbours = [[sign * one.values[j] for j in range(3)] for (_, sign), one in zip(each, found, strict=True)]
    inner = "AND(INDEX([@pt.s],[at])>0,INDEX([@pt.s],[at])<1)"
    size_of = "MAX(MAX({y}),0-MIN({y}))"
    sheet.heading("Workings: peaks", ABOUT)
    sheet.table(
        "@peaks", "Peaks over the cycle", rows,
        constant("what", "quantity", "", "", [f"{one.words}, {'highest' if s > 0 else 'lowest'}" for one, s in each],
                 align="left"),
        constant("sign", "highest (1), lowest (−1)", "", "", signs, format="0"),
        calc("most", "largest at a point", "", "", of("=IF([sign]=1,MAX({y}),0-MIN({y}))"),
             [float((sign * one.values).max()) for one, sign in each], scale=size),
        calc("at", "the first such point", "", "",
             of(f"={last + 1}-SUMPRODUCT(MAX(([sign]*{{y}}>=[most]-check_zero*{size_of})*({last + 1}-[@pt.k])))"),
             [one.at + 1 for one in found], format="0", source="to a rounding"),
        calc("y0", "before it", "w_0", "", of("=INDEX({y},MAX([at]-1,1))"), [n[0] for n in neighbours], scale=size),
        calc("y", "there", "w", "", of("=INDEX({y},[at])"), [n[1] for n in neighbours], scale=size),
        calc("y1", "after it", "w_1", "", of(f"=INDEX({{y}},MIN([at]+1,{last}))"), [n[2] for n in neighbours],
             scale=size),
        calc("a", "to the point before", "Δ_0", "°",
             f"=IF({inner},INDEX([@pt.theta],[at])-INDEX([@pt.theta],[at]-1),0)", [one.before for one in found],
             scale=360.0, source="0 at an end"),
        calc("b", "to the point after", "Δ_1", "°",
             f"=IF({inner},INDEX([@pt.theta],[at]+1)-INDEX([@pt.theta],[at]),0)", [one.after for one in found],
             scale=360.0),
        calc("s0", "slope before", "s_0", "", "=IF([a]>0,([y]-[y0])/[a],0)", slopes(each, found, 0), scale=size),
        calc("s1", "slope after", "s_1", "", "=IF([b]>0,([y1]-[y])/[b],0)", slopes(each, found, 1), scale=size),
        calc("top", "peak", "", "",
             f"=IF([a]=0,[y],IF(OR({BEYOND}),[sign]*[most],[y]+([s0]*[b]+[s1]*[a])^2/([a]+[b])/4/([s0]-[s1])))",
             [sign * one.top for (_, sign), one in zip(each, found, strict=True)], scale=size,
             source="w + m² (Δ_0 + Δ_1)/4(s_0 − s_1)"),
    )  # fmt: skip


def slopes(each: list[tuple[Figure, int]], found: list[Peak], after: int) -> list[float]:
    """Return the slopes before or after the largest points."""
    values = []
    for (_, sign), one in zip(each, found, strict=True):
        gap = one.after if after else one.before
        low, high = (one.values[1], one.values[2]) if after else (one.values[0], one.values[1])
        values.append(sign * (high - low) / gap if gap else 0.0)
    return values
