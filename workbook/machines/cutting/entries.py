"""The cutting machine of S1: what an engineer enters."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.drive.entries import RollerDrive
from workbook.entries.machine import Machine
from workbook.entries.texts import LOOKED_UP, NO_FORMULA, Text, place_of, require_distinct
from workbook.entries.types import ANGLE_TOLERANCE, Angle, EntryError, Model, Number, Positive
from workbook.laws.entries import LawName
from workbook.motion.room import WIDEST, settle
from workbook.selection.entries import Selection, SelectionSizes, require_room


class Phase(Model):
    """One phase of an axis: angles of the master shaft in degrees, lift in mm."""

    start: Angle
    stop: Angle
    lift: Number = 0.0
    law: LawName = "DWL"

    @model_validator(mode="after")
    def _forward(self) -> Self:
        if self.stop <= self.start:
            raise EntryError("stop", f"the angles run backwards: {self.stop:g}° does not lie after {self.start:g}°")
        if self.law == "DWL" and self.lift != 0:
            raise EntryError("lift", f"a dwell has no lift; expected 0, or another law, not {self.lift:g} mm")
        return self


class Axis(Model):
    """An axis of the timing diagram: what it does in each phase of one turn of the master shaft."""

    name: Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]
    group: Text
    closes: Literal["position", "feed"] = "position"
    phases: Annotated[list[Phase], Field(min_length=1)]

    @model_validator(mode="after")
    def _joined(self) -> Self:
        reached = 0.0
        for i, phase in enumerate(self.phases):
            if abs(phase.start - reached) > ANGLE_TOLERANCE:
                raise EntryError(f"phases.{i}.start", f"the phase begins at {phase.start:g}°; expected {reached:g}°")
            reached = phase.stop
        if abs(reached - 360) > ANGLE_TOLERANCE:
            raise EntryError(
                f"phases.{len(self.phases) - 1}.stop", f"the last phase ends at {reached:g}°; expected 360°"
            )
        return self


class Timing(Model):
    """The timing diagram of three axes over one turn of the master shaft."""

    rate: Positive  # pieces/min, one piece a turn
    axes: Annotated[list[Axis], Field(min_length=3, max_length=3)]

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        require_distinct((axis.name for axis in self.axes), "axis", "axes.{}.name")
        return self


class CuttingMachine(Machine):
    """The cutting machine of S1: three axes over one master shaft, and the drive of one of them."""

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
        laws = {f"timing.axes.{i}.phases": [p.law for p in axis.phases] for i, axis in enumerate(self.timing.axes)}
        settle(self, laws, self.sizes.phases + WIDEST)
        return self
