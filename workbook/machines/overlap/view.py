"""The engine's view of a transfer and its tools, and what only the engine can say of their entries."""

import math
from dataclasses import replace
from functools import cached_property

import numpy as np

from engine.laws import Law
from engine.laws.inverse import inverse_by_points, is_monotone
from engine.overlap import plan
from engine.overlap.picture import Scene
from engine.overlap.schedule import Passage, Tool, Transfer
from workbook.book.chart import in_scope
from workbook.book.sentence import figure
from workbook.entries.phase import TURN
from workbook.fields.types import ANGLE_TOLERANCE, END_TOLERANCE, DesignError
from workbook.fields.units import DEGREE, MM, PER_HOUR, PERCENT, shown, si
from workbook.law_sheets.library import laws
from workbook.laws.registry import RISING
from workbook.machines.overlap.entries import LEAST, IndexingOverlap, ToolEntry

SCOPE = "tool{}_"  # of the names of a tool's cells
BACKWARDS = "a law moves backwards: see its sheet, or Laws"


class OverlapView:
    """The engine's view: transfer, a station for each tool; laws inverted by points, as on the sheet Inverse."""

    def __init__(self, given: IndexingOverlap, library: dict[str, Law]) -> None:
        self.given, self.sizes, self.library = given.overlap, given.sizes, library
        moved = given.overlap.transfer
        self.transfer = Transfer(library[moved.law], si(moved.stroke, MM), si(moved.angle, DEGREE), inverse_by_points)
        self.rate = si(given.overlap.rate, PER_HOUR)
        self.stations = [Station(self, i, tool) for i, tool in enumerate(given.overlap.tools)]
        peaks = [max(station.peaks[schedule] for station in self.stations) for schedule in (0, 2)]
        self.peaks = peaks[0], peaks[1]  # the largest of any tool in m/s², in sequence and as set
        self.alone = len(self.stations) == 1  # its book has no sheets for each tool then
        self.room = self.sizes.pieces_of(1)  # rows of the tables of pieces
        # of the master shaft at the samples, in degrees
        self.angles = np.linspace(0.0, TURN, self.sizes.cycle + 1)
        self.scene = Scene([station.engine for station in self.stations])  # as drawn

    def each(self, formula: str) -> list[str]:
        """Return a formula for each tool, in its scope: the rows of a table over the tools."""
        return [in_scope(formula, station.scope) for station in self.stations]

    @cached_property
    def least(self) -> float:
        """The least clearance of any tool over the cycle in mm."""
        return min(station.least for station in self.stations)


class Station:
    """One tool and the transfer: three schedules, their clearance, and what a margin costs.

    ``key`` is the place of its entries in the description, ``scope`` what the names of its cells begin with. In the
    tables that all tools share, rows count from 1: ``law_rows`` are those of its laws in and out, behind the
    transfer's, ``blocked_rows`` those of the transfer's inverted law where it begins and ceases to be in the way.
    """

    def __init__(self, machine: OverlapView, i: int, tool: ToolEntry) -> None:
        p, library, row = tool.passage, machine.library, 2 * i + 2
        self.machine, self.given = machine, tool
        self.number, self.key, self.scope = i + 1, f"overlap.tools.{i}", SCOPE.format(i + 1)
        self.law_rows, self.blocked_rows = (row, row + 1), (row - 1, row)
        dwell, allowance = si(tool.dwell, DEGREE), si(p.allowance, DEGREE)
        self.tool = Tool(
            library[tool.law_in], si(tool.stroke, MM), dwell, library[tool.law_out], machine.transfer.inverted
        )
        self.passage = Passage(si(p.remaining, PERCENT), si(p.clearance, MM), si(p.margin, MM), allowance, p.split)
        self.engine = plan.Station(machine.transfer, self.tool, self.passage)
        longest = self.engine.overlapping()
        way_in = longest.angle_in if tool.angle_in is None else si(tool.angle_in, DEGREE)
        way_out = longest.angle_out if tool.angle_out is None else si(tool.angle_out, DEGREE)
        self.before = self.engine.one_after_the_other()
        self.longest = replace(self.engine, passage=replace(self.passage, allowance=0.0)).overlapping()
        # as entered, or the longest less a bit
        self.as_set = replace(longest, angle_in=way_in, angle_out=way_out)
        self.schedules = self.before, self.longest, self.as_set
        # m/s²
        self.peaks = [schedule.peak_acceleration(machine.rate) for schedule in self.schedules]
        self.angles_set = shown(way_in, DEGREE), shown(way_out, DEGREE)

    @cached_property
    def clearance(self) -> plan.Clearance:
        """The clearance between the parts over the cycle as it is set."""
        return self.engine.clearance(self.as_set, si(self.machine.angles, DEGREE))

    @property
    def least(self) -> float:
        """The least clearance over the cycle in mm."""
        return shown(self.clearance.minimum, MM)

    @cached_property
    def margins(self) -> plan.MarginSweep:
        """The schedules for margins from 0 to the whole clearance."""
        margins = np.linspace(0.0, self.passage.clearance, self.machine.sizes.margins + 1)
        return self.engine.sweep(margins, self.machine.rate)


def check(machine: IndexingOverlap) -> None:
    """Raise DesignError where a law moves backwards or does not end at 1, or a tool's schedule takes over a turn."""
    given, library = machine.overlap, laws(machine.laws)
    used = {"transfer.law": given.transfer.law}
    for i, tool in enumerate(given.tools):
        used |= {f"tools.{i}.law_in": tool.law_in, f"tools.{i}.law_out": tool.law_out}
    for entry, name in used.items():
        law = library[name]
        if not is_monotone(law):
            raise DesignError(f"overlap.{entry}", BACKWARDS, RISING[0])
        if abs(law.end.s - 1) > END_TOLERANCE:
            problem = f"the law {name} ends at s = {law.end.s:g}; expected a law that ends at 1"
            raise DesignError(f"overlap.{entry}", problem, RISING[0])
    for station in OverlapView(machine, library).stations:
        taken = math.fsum(station.angles_set) + station.given.dwell
        if taken > TURN + ANGLE_TOLERANCE:
            name = "angle_in" if station.given.angle_in is not None else "angle_out"
            problem = f"way in, dwell and way out take {figure(taken)}°; expected at most 360°"
            raise DesignError(f"{station.key}.{name}", problem, LEAST)
