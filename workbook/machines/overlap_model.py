"""Overlap of a transfer and tools (S2): what an engineer enters, and the engine's view of it."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import replace
from functools import cached_property
from math import degrees, radians
from typing import Annotated, Literal, Self, cast

import numpy as np
from pydantic import Field, model_validator

from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.inverse import is_monotone
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
from workbook.machine import Angle, EntryError, Machine, Model, NotNegative, Positive, Sizes, Text
from workbook.reference import MM, laws

PER_HOUR = 1 / 3600  # 1/s
TURN = 360.0
MOST_TOOLS = 6
RiseCode = Literal["ACS", "TVP", "CIC", "CUB", "MTP", "OWN"]
SCOPE = "tool{}_"  # of the names of a tool's cells
LEAST = 0.01  # degrees: no cam moves in less
PartAngle = Annotated[float, Field(ge=LEAST, lt=360, allow_inf_nan=False)]


class TransferEntry(Model):
    """The motion that brings the part."""

    name: Text
    law: RiseCode
    stroke: Positive  # mm
    angle: PartAngle  # degrees of the master shaft


class PassageEntry(Model):
    """What one part leaves to the other."""

    remaining: Annotated[float, Field(ge=0, lt=50, allow_inf_nan=False)]  # % of the transfer's stroke
    clearance: NotNegative  # mm
    margin: NotNegative  # mm
    allowance: NotNegative  # degrees
    split: Annotated[float, Field(gt=0, lt=1, allow_inf_nan=False)] = 0.5

    @model_validator(mode="after")
    def _within(self) -> Self:
        if self.margin > self.clearance:
            raise EntryError(
                "margin", f"the margin is {self.margin:g} mm; expected at most the clearance, {self.clearance:g} mm"
            )
        return self


class ToolEntry(Model):
    """A motion that enters when the part is there, and is out before the next transfer."""

    name: Text
    law_in: RiseCode
    law_out: RiseCode
    stroke: Positive  # mm
    dwell: Annotated[float, Field(ge=0, lt=360, allow_inf_nan=False)]  # degrees
    angle_in: PartAngle | None = None  # degrees; empty: the longest that the passage allows, less the allowance
    angle_out: PartAngle | None = None
    passage: PassageEntry


class OverlapEntry(Model):
    """The transfer, the tools that work at its stations, and the angle at which the picture shows them."""

    rate: Positive  # pieces/h
    transfer: TransferEntry
    tools: Annotated[list[ToolEntry], Field(min_length=1, max_length=MOST_TOOLS)]
    view: Angle = 0.0  # degrees

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        names = [tool.name for tool in self.tools]
        for i, name in enumerate(names):
            if name in names[:i]:
                raise EntryError(f"tools.{i}.name", f"a second tool is named {name!r}; expected a name of its own")
        return self


class OverlapSizes(Sizes):
    """How large the tables are built: also the intervals of the table of margins."""

    margins: Annotated[int, Field(ge=2, le=200)] = 20


class IndexingOverlap(Machine):
    """A transfer and tools over one master shaft, one after the other and with overlap (S2)."""

    template: Literal["indexing-overlap"] = "indexing-overlap"
    overlap: OverlapEntry
    sizes: OverlapSizes = OverlapSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        filled, room = len(self.laws.OWN.pieces), self.sizes.pieces
        if filled > room:
            raise EntryError("laws.OWN.pieces", f"{filled} rows do not fit into {room}; raise sizes.pieces")
        self._rises()
        for i, tool in enumerate(self.overlap.tools):
            self._leaves_angles(f"overlap.tools.{i}", tool)
        for station in Overlapping(self, laws(self.laws, self.sizes.own_law)).stations:
            station.require_one_turn()
        return self

    def _rises(self) -> None:
        given = self.overlap
        used = {"transfer.law": given.transfer.law}
        for i, tool in enumerate(given.tools):
            used |= {f"tools.{i}.law_in": tool.law_in, f"tools.{i}.law_out": tool.law_out}
        entry = next((entry for entry, code in used.items() if code == "OWN"), None)
        if entry is None:
            return
        own = laws(self.laws, self.sizes.own_law)["OWN"]
        if not is_monotone(own):
            raise EntryError(f"overlap.{entry}", "the own law moves backwards; expected a law that rises throughout")
        if abs(own.end.s - 1) > BREAK_TOLERANCE:
            raise EntryError(
                f"overlap.{entry}", f"the own law ends at s = {own.end.s:g}; expected a law that ends at 1"
            )

    def _leaves_angles(self, key: str, tool: ToolEntry) -> None:
        angle, passage = self.overlap.transfer.angle, tool.passage
        free = TURN - angle - tool.dwell
        least = free * min(passage.split, 1 - passage.split)
        if least < LEAST:
            raise EntryError(
                f"{key}.dwell", f"transfer ({angle:g}°) and dwell ({tool.dwell:g}°) leave the tool no angle of 360°"
            )
        if passage.allowance > least - LEAST:
            raise EntryError(
                f"{key}.passage.allowance",
                f"an allowance of {passage.allowance:g}° leaves the tool no angle; expected at most {least - LEAST:g}°",
            )


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
