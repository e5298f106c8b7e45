"""Flying machining (S5): what an engineer enters."""

from collections.abc import Iterator
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.book.sentence import figure
from workbook.entries.machine import Exporting
from workbook.entries.phase import TURN
from workbook.fields.types import DesignError, Model, NotNegative, Number, Positive
from workbook.laws.entries import RisingLaw
from workbook.motion.requirements import Smoothness, settle_room
from workbook.selection.entries import Limits, Selection, SelectionSizes, require_room

DRUM, SAW = "drum", "saw"
MORE = 3  # pieces of the tool's motion beside the law's: a wait, the piece that it interrupts, the work


class DrumEntry(Model):
    """A drum of tools that goes round."""

    tools: Annotated[float, Field(ge=1, le=100, allow_inf_nan=False)]
    radius: Positive
    tool_angle: Annotated[float, Field(ge=0, lt=360, allow_inf_nan=False)]


class SawEntry(Model):
    """A saw on a slide that comes back."""

    tool_length: NotNegative
    lead: Positive
    stroke: Positive


class LoadEntry(Model):
    """The load that the shaft moves."""

    inertia: NotNegative
    mass: NotNegative = 0.0
    torque: Number = 0.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a load that nothing has to move."""
        if not (self.inertia or self.mass):
            yield DesignError("inertia", "inertia and mass are 0; expected one of them above", 1.0)


class LimitEntry(Model):
    """The limits of the shaft."""

    speed: Positive
    acceleration: Positive


class LengthsEntry(Model):
    """The product lengths that the machine is compared over."""

    shortest: Positive
    longest: Positive

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a range of lengths that does not rise."""
        if self.longest <= self.shortest:
            low, high = figure(self.shortest), figure(self.longest)
            problem = f"from {low} mm to {high} mm; expected a longest above the shortest"
            yield DesignError("longest", problem, 2 * self.shortest)


class CutterEntry(Model):
    """The product and its line, the tool, the law of the superimposed motion."""

    product_length: Positive
    line_speed: Positive
    law: RisingLaw
    smoothness: Smoothness = "acceleration"
    kind: Literal["drum", "saw"] = "drum"
    drum: DrumEntry
    beyond: Literal["standstill", "reversal"] = "standstill"
    saw: SawEntry
    load: LoadEntry
    limits: LimitEntry
    lengths: LengthsEntry

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a drum with part of a tool, or tools that are in step for longer than to the next tool."""
        drum = self.drum
        if self.kind != DRUM:
            return
        if drum.tools != int(drum.tools):
            yield DesignError("drum.tools", f"{figure(drum.tools)} tools; expected a whole number", 1.0)
        if drum.tool_angle * drum.tools >= TURN:
            problem = f"{figure(drum.tools)} tools in step over {figure(drum.tool_angle)}° each take more than 360°"
            yield DesignError("drum.tool_angle", problem, 0.0)


class FlyingSizes(SelectionSizes):
    """The sizes of the tables: also the intervals of the product lengths compared."""

    lengths: Annotated[int, Field(ge=2, le=400)] = 60


class FlyingCutter(Exporting):
    """A tool that follows the line while it works, and re-positions for the next product (S5)."""

    AXES = ("tool", "shaft")
    template: Literal["flying-cutter"] = "flying-cutter"
    cutter: CutterEntry
    limits: Limits = Limits()
    selection: Selection = Selection()
    sizes: FlyingSizes = FlyingSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        require_room(self.selection, self.sizes)
        settle_room(self, [MORE], MORE)
        return self
