"""Overlap of two motions (S2): what an engineer enters, and the engine's view of it."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from math import degrees, radians
from typing import Annotated, Literal, Self

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
from workbook.machine import Angle, EntryError, Laws, Machine, Model, NotNegative, Positive, Sizes, Text
from workbook.reference import MM, laws

PER_HOUR = 1 / 3600  # 1/s
TURN = 360.0
RiseCode = Literal["ACS", "TVP", "CIC", "CUB", "MTP", "OWN"]
LEAST = 0.01  # degrees: no cam moves in less
PartAngle = Annotated[float, Field(ge=LEAST, lt=360, allow_inf_nan=False)]


class TransferEntry(Model):
    """The motion that brings the part."""

    name: Text
    law: RiseCode
    stroke: Positive  # mm
    angle: PartAngle  # degrees of the master shaft


class ToolEntry(Model):
    """The motion that enters when the part is there, and is out before the next transfer."""

    name: Text
    law_in: RiseCode
    law_out: RiseCode
    stroke: Positive  # mm
    dwell: Annotated[float, Field(ge=0, lt=360, allow_inf_nan=False)]  # degrees
    angle_in: PartAngle | None = None  # degrees; empty: the longest that the passage allows, less the allowance
    angle_out: PartAngle | None = None


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


class OverlapEntry(Model):
    """Both motions, their passage, and the angle at which the picture shows them."""

    rate: Positive  # pieces/h
    transfer: TransferEntry
    tool: ToolEntry
    passage: PassageEntry
    view: Angle = 0.0  # degrees


class OverlapSizes(Sizes):
    """How large the tables are built: also the intervals of the table of margins."""

    margins: Annotated[int, Field(ge=2, le=200)] = 20


class IndexingOverlap(Machine):
    """Two motions over one master shaft, one after the other and with overlap (S2)."""

    template: Literal["indexing-overlap"] = "indexing-overlap"
    overlap: OverlapEntry
    sizes: OverlapSizes = OverlapSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        filled, room = len(self.laws.OWN.pieces), self.sizes.pieces
        if filled > room:
            raise EntryError("laws.OWN.pieces", f"{filled} rows do not fit into {room}; raise sizes.pieces")
        self._rises()
        self._leaves_angles()
        return self

    def _rises(self) -> None:
        own = own_law(self.laws, self.sizes)
        for entry in ("transfer.law", "tool.law_in", "tool.law_out"):
            part, _, name = entry.partition(".")
            if getattr(getattr(self.overlap, part), name) != "OWN":
                continue
            if not is_monotone(own):
                raise EntryError(
                    f"overlap.{entry}", "the own law moves backwards; expected a law that rises throughout"
                )
            if abs(own.end.s - 1) > BREAK_TOLERANCE:
                raise EntryError(
                    f"overlap.{entry}", f"the own law ends at s = {own.end.s:g}; expected a law that ends at 1"
                )

    def _leaves_angles(self) -> None:
        given, tool = self.overlap, self.overlap.tool
        free = TURN - given.transfer.angle - tool.dwell
        least = free * min(given.passage.split, 1 - given.passage.split)
        if least < LEAST:
            raise EntryError(
                "overlap.tool.dwell",
                f"transfer ({given.transfer.angle:g}°) and dwell ({tool.dwell:g}°) leave the tool no angle of 360°",
            )
        if given.passage.allowance > least - LEAST:
            raise EntryError(
                "overlap.passage.allowance",
                f"an allowance of {given.passage.allowance:g}° leaves the tool no angle; "
                f"expected at most {least - LEAST:g}°",
            )
        schedule = Overlapping(self, laws(self.laws, self.sizes.own_law)).as_set
        taken = degrees(schedule.way_in + schedule.way_out) + tool.dwell
        if taken > TURN + 1e-9:
            name = "angle_in" if tool.angle_in is not None else "angle_out"
            raise EntryError(
                f"overlap.tool.{name}", f"way in, dwell and way out take {taken:g}°; expected at most 360°"
            )


def own_law(given: Laws, sizes: Sizes) -> Law:
    """Return the engineer's own law."""
    return laws(given, sizes.own_law)["OWN"]


class Overlapping:
    """The engine's view: three schedules, their clearance, and what a margin costs."""

    def __init__(self, machine: IndexingOverlap, library: dict[str, Law]) -> None:
        self.given, self.sizes, self.library = machine.overlap, machine.sizes, library
        given, p = machine.overlap, machine.overlap.passage
        moved, tool = given.transfer, given.tool
        self.transfer = Transfer(library[moved.law], moved.stroke * MM, radians(moved.angle))
        self.tool = Tool(library[tool.law_in], tool.stroke * MM, radians(tool.dwell), library[tool.law_out])
        self.passage = Passage(p.remaining / 100, p.clearance * MM, p.margin * MM, radians(p.allowance), p.split)
        self.rate = given.rate * PER_HOUR
        self.omega = shaft_speed(self.rate)

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
        found, tool = overlap(self.transfer, self.tool, self.passage), self.given.tool
        way_in = found.way_in if tool.angle_in is None else radians(tool.angle_in)
        way_out = found.way_out if tool.angle_out is None else radians(tool.angle_out)
        return replace(found, way_in=way_in, way_out=way_out)

    @property
    def schedules(self) -> tuple[Schedule, Schedule, Schedule]:
        """One after the other, longest, as set."""
        return self.before, self.longest, self.as_set

    @cached_property
    def blocked(self) -> tuple[float, float]:
        """The angles in degrees between which the transfer is in the way."""
        begin, end = blocked(self.transfer, self.passage)
        return degrees(begin), degrees(end)

    @cached_property
    def clearance(self) -> Clearance:
        """What is free between the parts over the cycle as it is set."""
        return clearance(self.as_set, self.passage, np.deg2rad(self.angles))

    @cached_property
    def angles(self) -> Array:
        """The sampled angles of the master shaft in degrees."""
        n = self.sizes.cycle
        return np.arange(n + 1) * TURN / n

    @cached_property
    def margins(self) -> MarginSweep:
        """The schedules for margins from 0 to the whole clearance."""
        n = self.sizes.margins
        return sweep_margin(
            self.transfer, self.tool, self.passage, np.arange(n + 1) / n * self.passage.clearance, self.rate
        )
