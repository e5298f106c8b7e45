"""The engine's view of a transfer and its tools."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import replace
from functools import cached_property
from math import degrees, radians
from typing import cast

import numpy as np

from engine.laws import Law
from engine.laws.base import Array
from engine.overlap import (
    Clearance,
    MarginSweep,
    Passage,
    Schedule,
    Tool,
    Transfer,
    blocked,
    clearance,
    one_after_the_other,
    overlap,
    sweep_margin,
)
from engine.timing import shaft_speed
from workbook.entries.machine import Machine
from workbook.entries.types import EntryError
from workbook.entries.units import MM
from workbook.machines.overlap.entries import MOST_TOOLS, TURN, IndexingOverlap, ToolEntry

PER_HOUR = 1 / 3600  # 1/s
SCOPE = "tool{}_"  # of the names of a tool's cells


class Overlapping:
    """The engine's view: the transfer, and a station for each tool."""

    def __init__(self, machine: IndexingOverlap, library: dict[str, Law]) -> None:
        self.given, self.sizes, self.library = machine.overlap, machine.sizes, library
        moved = machine.overlap.transfer
        self.transfer = Transfer(library[moved.law], moved.stroke * MM, radians(moved.angle))
        self.rate = machine.overlap.rate * PER_HOUR
        self.omega = shaft_speed(self.rate)
        self.stations = [Station(self, i, tool) for i, tool in enumerate(machine.overlap.tools)]

    @property
    def alone(self) -> bool:
        """Whether there is one tool: its book has no sheets for each."""
        return len(self.stations) == 1

    @cached_property
    def angles(self) -> Array:
        """The sampled angles of the master shaft in degrees."""
        n = self.sizes.cycle
        return np.arange(n + 1) * TURN / n

    @cached_property
    def peaks(self) -> tuple[float, float]:
        """The largest peak acceleration of any tool in m/s², one after the other and as set."""
        before, _, after = np.max([station.peaks for station in self.stations], axis=0)
        return float(before), float(after)

    @cached_property
    def least(self) -> float:
        """The least clearance of any tool over the cycle in mm."""
        return min(station.clearance.minimum for station in self.stations) / MM


class Station:
    """One tool and the transfer: three schedules, their clearance, and what a margin costs.

    ``key`` is the place of its entries in the description, ``scope`` what the names of its cells begin with.
    """

    def __init__(self, machine: Overlapping, i: int, tool: ToolEntry) -> None:
        p, library = tool.passage, machine.library
        self.machine, self.given = machine, tool
        self.number, self.key, self.scope = i + 1, f"overlap.tools.{i}", SCOPE.format(i + 1)
        self.transfer = machine.transfer
        self.tool = Tool(library[tool.law_in], tool.stroke * MM, radians(tool.dwell), library[tool.law_out])
        self.passage = Passage(p.remaining / 100, p.clearance * MM, p.margin * MM, radians(p.allowance), p.split)

    @cached_property
    def before(self) -> Schedule:
        """One after the other."""
        return one_after_the_other(self.transfer, self.tool, self.passage.split)

    @cached_property
    def longest(self) -> Schedule:
        """The longest ways in and out that the passage allows."""
        return overlap(self.transfer, self.tool, replace(self.passage, allowance=0.0))

    @cached_property
    def as_set(self) -> Schedule:
        """The schedule that is built: the angles entered, or the longest less the allowance."""
        found, tool = overlap(self.transfer, self.tool, self.passage), self.given
        way_in = found.way_in if tool.angle_in is None else radians(tool.angle_in)
        way_out = found.way_out if tool.angle_out is None else radians(tool.angle_out)
        return replace(found, way_in=way_in, way_out=way_out)

    @property
    def schedules(self) -> tuple[Schedule, Schedule, Schedule]:
        """One after the other, longest, as set."""
        return self.before, self.longest, self.as_set

    def require_one_turn(self) -> None:
        """Raise EntryError where the schedule that is built takes more than a turn."""
        plan, tool = self.as_set, self.given
        taken = degrees(plan.way_in + plan.way_out) + tool.dwell
        if taken > TURN + 1e-9:
            name = "angle_in" if tool.angle_in is not None else "angle_out"
            raise EntryError(f"{self.key}.{name}", f"way in, dwell and way out take {taken:g}°; expected at most 360°")

    @property
    def angles_set(self) -> tuple[float, float]:
        """The ways in and out as set, in degrees."""
        return degrees(self.as_set.way_in), degrees(self.as_set.way_out)

    @cached_property
    def peaks(self) -> list[float]:
        """Peak acceleration of the tool in each schedule in m/s²."""
        return [schedule.peak_acceleration(self.machine.rate) for schedule in self.schedules]

    @cached_property
    def blocked(self) -> tuple[float, float]:
        """The angles in degrees between which the transfer is in the way."""
        begin, end = blocked(self.transfer, self.passage)
        return degrees(begin), degrees(end)

    @cached_property
    def clearance(self) -> Clearance:
        """What is free between the parts over the cycle as it is set."""
        return clearance(self.as_set, self.passage, np.deg2rad(self.machine.angles))

    @cached_property
    def margins(self) -> MarginSweep:
        """The schedules for margins from 0 to the whole clearance."""
        n = self.machine.sizes.margins
        shares = np.arange(n + 1) / n
        return sweep_margin(self.transfer, self.tool, self.passage, shares * self.passage.clearance, self.machine.rate)


def laid_out(machine: Machine, names: Container[str]) -> Machine:
    """Return a machine with as many tools as a file has by its defined names: its book has the file's inputs."""
    given = cast(IndexingOverlap, machine).overlap
    count = max((i for i in range(1, MOST_TOOLS + 1) if f"{SCOPE.format(i)}name" in names), default=1)
    tools = [given.tools[0]] * count
    return machine.model_copy(update={"overlap": given.model_copy(update={"tools": tools})})
