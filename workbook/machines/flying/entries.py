"""Flying machining (S5): what an engineer enters."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.entries.machine import Machine
from workbook.entries.types import EntryError, Model, NotNegative, Number, Positive
from workbook.laws.entries import RisingLaw
from workbook.motion.room import settle
from workbook.selection.entries import Selection, SelectionSizes, require_room

DRUM = "drum"
MORE = 3  # pieces of the tool's motion beside the law's: a wait, the piece that it interrupts, the work


class DrumEntry(Model):
    """A drum of tools that goes round."""

    tools: Annotated[float, Field(ge=1, le=100, allow_inf_nan=False)]
    radius: Positive  # mm
    tool_angle: Annotated[float, Field(ge=0, lt=360, allow_inf_nan=False)]  # degrees

    @model_validator(mode="after")
    def _pitched(self) -> Self:
        if self.tools != int(self.tools):
            raise EntryError("tools", f"found {self.tools:g}; expected a whole number")
        if self.tool_angle >= 360 / self.tools:
            raise EntryError(
                "tool_angle",
                f"the tools are in step over {self.tool_angle:g}°; expected less than the {360 / self.tools:g}° "
                "between them",
            )
        return self


class SawEntry(Model):
    """A saw on a slide that comes back."""

    tool_length: NotNegative  # mm
    lead: Positive  # mm of the slide a turn of its shaft
    stroke: Positive  # mm that the slide has


class LoadEntry(Model):
    """What the shaft moves."""

    inertia: NotNegative  # kg m²
    mass: NotNegative = 0.0  # kg, in step with the tool
    torque: Number = 0.0  # Nm, against the line's direction

    @model_validator(mode="after")
    def _heavy(self) -> Self:
        if not (self.inertia or self.mass):
            raise EntryError("inertia", "neither an inertia nor a mass; expected at least one of them above 0")
        return self


class LimitEntry(Model):
    """What the shaft may do."""

    speed: Positive  # rpm
    acceleration: Positive  # rad/s²


class LengthsEntry(Model):
    """The product lengths that the machine is compared over."""

    shortest: Positive  # mm
    longest: Positive  # mm

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.longest <= self.shortest:
            raise EntryError("longest", f"{self.longest:g} mm; expected more than the shortest, {self.shortest:g} mm")
        return self


class CutterEntry(Model):
    """The product and its line, the tool, the law of the superimposed motion."""

    kind: Literal["drum", "saw"] = "drum"
    line_speed: Positive  # m/min
    product_length: Positive  # mm
    law: RisingLaw
    beyond: Literal["standstill", "reversal"] = "standstill"
    drum: DrumEntry
    saw: SawEntry
    load: LoadEntry
    limits: LimitEntry
    lengths: LengthsEntry


class FlyingSizes(SelectionSizes):
    """How large the tables are built: also the intervals of the product lengths compared."""

    lengths: Annotated[int, Field(ge=2, le=400)] = 60


class FlyingCutter(Machine):
    """A tool that follows the line while it works, and re-positions for the next product (S5)."""

    template: Literal["flying-cutter"] = "flying-cutter"
    cutter: CutterEntry
    selection: Selection = Selection()
    sizes: FlyingSizes = FlyingSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        require_room(self.selection, self.sizes)
        settle(self, {"cutter.law": [self.cutter.law]}, MORE, more=MORE)
        return self
