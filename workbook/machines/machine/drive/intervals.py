"""The intervals of a drive's cycle: pieces of its motion, cut where a process force begins or ends."""

from __future__ import annotations

from engine.drive.quadrature import COUNT, Interval
from workbook.book.declare import Sheet, calc, constant
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.chain import WINDOWS
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive.windows import acting

MIDDLE = COUNT // 2 + 1
"""the number of the point in the middle of an interval"""
LENGTH = "[len]<timing_eps"
"""the condition of a spare row: an interval of no length"""


def cuts_table(sheet: Sheet, view: DriveView) -> None:
    """Declare where an interval can begin: at the motion's pieces, and at edges of process forces."""
    table = f"axis{view.driven.number}_pieces"
    pieces = filled([shown(one.begin, DEGREE) for one in view.cycle.pieces], view.room, TURN)
    steps = range(1, view.steps)
    edges = [*pieces, *view.edges, *(TURN * n / view.steps for n in steps)]
    windows = [0] * view.room + [n for n in range(1, WINDOWS + 1) for _ in (1, 2)] + [-n for n in steps]
    sides = [0] * view.room + [side for _ in range(WINDOWS) for side in (1, 2)] + [0 for _ in steps]
    edge = f"IF([window]=0,INDEX([{table}.begin],[k]),INDEX([@windows.b:e],[window],[side]))"
    if view.steps > 1:
        edge = f"IF([window]<0,0-[window]*360/{view.steps},{edge})"
    sheet.table(
        "@cuts", "Where an interval can begin", len(edges),
        constant("k", "number", "k", "", list(range(1, len(edges) + 1))),
        constant("window", "process force", "", "", windows, format="0;;",
                 source="below 0: the number of an even step" if view.steps > 1 else ""),
        constant("side", "its begin (1) or end (2)", "", "", sides, format="0;;"),
        calc("edge", "angle of its phases", "θ", "°",
             f"={edge}", edges, scale=TURN, format="0.0##", source="of a piece, or of a force"),
        calc("at", "cut", "θ", "°",
             "=IF(SUMPRODUCT((([@cuts.edge]-[edge])^2<timing_eps^2)*([@cuts.k]<[k]))+([edge]>360-timing_eps)>0,360,"
             "[edge])",
             kept(edges, view.one.machine.near), scale=TURN, format="0.0##", source="360: one before it is there"),
    )  # fmt: skip


def kept(edges: list[float], near: float) -> list[float]:
    """Return the edges in degrees, 360 instead of one that an earlier one is near to."""
    return [TURN if edge > TURN - near or any(abs(edge - one) < near for one in edges[:k]) else edge
            for k, edge in enumerate(edges)]  # fmt: skip


def intervals_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the intervals, in order; spare rows at the end of the cycle have no length."""
    i, cycle = view.driven.number, view.cycle
    late = view.driven.axis.given.shift
    unit = "N" if view.driven.travels else "Nm"
    steady, friction = cycle.levels

    def middle(one: Interval) -> float:
        return shown(one.middle, DEGREE)

    def master(one: Interval) -> float:
        return (middle(one) + late) % TURN

    at = f"([mid]+[axes_taken.late.{i}])"
    speed = f"INDEX([@pt.v],{COUNT}*[k]-{COUNT - MIDDLE})"
    sheet.table(
        "@iv", "Intervals of the cycle", view.rows,
        constant("k", "interval", "k", "", list(range(1, view.rows + 1))),
        calc("begin", "begins at", "θ", "°", "=SMALL([@cuts.at],[k])",
             view.of_intervals(lambda one: shown(one.begin, DEGREE), TURN), scale=TURN, format="0.0##"),
        calc("end", "ends at", "θ", "°", "=SMALL([@cuts.at],[k]+1)",
             view.of_intervals(lambda one: shown(one.end, DEGREE), TURN), scale=TURN, format="0.0##"),
        calc("len", "length", "", "°", "=[end]-[begin]",
             view.of_intervals(lambda one: shown(one.end - one.begin, DEGREE), 0.0), scale=TURN, format="0.0##"),
        calc("mid", "in its middle", "θ", "°", f"=IF({LENGTH},[mid-1],([begin]+[end])/2)", view.of_intervals(middle),
             scale=TURN, format="0.0##", source="spare rows: as above"),
        calc("at", "of the master shaft", "", "°", f"={at}-360*INT({at}/360)", view.of_intervals(master), scale=TURN,
             format="0.0##", source="with the axis' shift"),
        calc("q", "piece of the motion", "q", "", f"=MATCH([mid],[axis{i}_pieces.begin],1)",
             view.of_intervals(lambda one: one.piece + 1), format="0"),
        calc("dir", "direction", "", "",
             f"=IF({LENGTH},[dir-1],IF(ABS({speed})<=@still,0,SIGN({speed})))", view.by_interval(cycle.direction),
             format="0", source="1, −1; 0 at rest"),
        calc("steady", "resists always", "", unit, f"=@steady+{acting('[at]', 'always')}", view.by_interval(steady),
             scale=view.scales.force, source="with process forces"),
        calc("friction", "against motion", "", unit, f"=@rub+{acting('[at]', 'moving')}", view.by_interval(friction),
             scale=view.scales.force),
        blank=LENGTH,
    )  # fmt: skip
