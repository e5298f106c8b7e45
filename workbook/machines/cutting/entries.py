"""The cutting machine of S1: what an engineer enters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.book.sentence import figure
from workbook.drive.entries import RollerDrive
from workbook.entries.exported import Exporting
from workbook.entries.phase import Passing, require_straight
from workbook.entries.texts import LOOKED_UP, NO_FORMULA, Text, place_of, require_distinct
from workbook.entries.turn import TURN, TurnPhase, forward
from workbook.entries.types import ANGLE_TOLERANCE, DesignError, EntryError, Model, Positive
from workbook.motion.asked import Smoothness
from workbook.motion.room import settle_phases
from workbook.selection.entries import Selection, SelectionSizes, require_room


class AxisPhase(TurnPhase, Passing):
    """A phase, its lift in mm, and what it passes its begin with."""


class Axis(Model):
    """An axis of the timing diagram: what it does in each phase of one turn of the master shaft."""

    name: Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]
    group: Text
    closes: Literal["position", "feed"] = "position"
    smoothness: Smoothness = "acceleration"
    phases: Annotated[list[AxisPhase], Field(min_length=1)]

    def design_faults(self) -> Iterator[DesignError]:
        """Yield phases that run backwards, do not follow on, or do not fill the cycle."""
        yield from forward(self.name, self.phases)
        reached = 0.0
        for i, phase in enumerate(self.phases, 1):
            if abs(phase.start - reached) > ANGLE_TOLERANCE:
                said = parted(self.name, i, phase.start, reached)
                yield DesignError(f"phases.{i - 1}.start", said, "follows", reached)
                break
            reached = phase.stop
        last = max(phase.stop for phase in self.phases)
        if abs(last - TURN) > ANGLE_TOLERANCE:
            yield DesignError(f"phases.{len(self.phases) - 1}.stop", unfilled(self.name, last), "fills", TURN)


def parted(name: str, row: int, start: float, reached: float) -> str:
    """Return the sentence on a phase that does not begin where the one before it ends."""
    gap = start - reached
    side = "after" if gap > 0 else "before"
    other = f"row {row - 1} ends" if row > 1 else "0°"
    return f"{name} row {row} begins at {figure(start)}°, {figure(abs(gap))}° {side} {other}"


def unfilled(name: str, last: float) -> str:
    """Return the sentence on phases that do not end with the cycle."""
    side = "before" if last < TURN else "after"
    return f"{name} ends at {figure(last)}°, {figure(abs(TURN - last))}° {side} 360°"


class Timing(Model):
    """The timing diagram of three axes over one turn of the master shaft."""

    rate: Positive  # pieces/min, one piece a turn
    axes: Annotated[list[Axis], Field(min_length=3, max_length=3)]

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        require_distinct((axis.name for axis in self.axes), "axis", "axes.{}.name")
        return self


class CuttingMachine(Exporting):
    """The cutting machine of S1: three axes over one master shaft, and the drive of one of them."""

    AXES_AT = ("timing", "axes")
    template: Literal["cutting-machine"] = "cutting-machine"
    timing: Timing
    drive: RollerDrive
    selection: Selection = Selection()
    sizes: SelectionSizes = SelectionSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        names = [axis.name for axis in self.timing.axes]
        if place_of(self.drive.axis, names) < 0:
            raise EntryError("drive.axis", f"no axis is named {self.drive.axis!r}; expected one of {', '.join(names)}")
        for path, filled, room in (
            *((f"timing.axes.{i}.phases", len(a.phases), self.sizes.phases) for i, a in enumerate(self.timing.axes)),
            ("drive.rotors", len(self.drive.rotors), self.sizes.rotors),
        ):
            if filled > room:
                raise EntryError(path, f"{filled} rows do not fit into {room}; raise sizes.{path.split('.')[-1]}")
        require_room(self.selection, self.sizes)
        require_straight(self.laws, {f"timing.axes.{i}.phases": axis.phases for i, axis in enumerate(self.timing.axes)})
        settle_phases(self, {f"timing.axes.{i}.phases": axis.phases for i, axis in enumerate(self.timing.axes)})
        return self
