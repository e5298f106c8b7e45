"""Flying machining (S5): what an engineer enters."""

from __future__ import annotations

from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from engine.flying import Beyond
from engine.laws.base import BREAK_TOLERANCE
from engine.laws.inverse import is_monotone
from engine.laws.sections import velocity_extremes
from workbook.entries.machine import Machine, Sizes
from workbook.entries.types import EntryError, Model, NotNegative, Number, Positive
from workbook.entries.units import MM
from workbook.laws.entries import Laws, RiseCode
from workbook.laws.library import laws
from workbook.selection.entries import Selection, SelectionSizes, require_room

DRUM = "drum"
REST = 1e-9  # dimensionless velocity at which a law is at rest
LONGER = 1.001  # times the tool length, the shortest product: the tool needs time to get back
LEAST_CV = 1.001  # below, no product is too long to keep moving


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
    law: RiseCode
    beyond: Beyond = "standstill"
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
        filled, room = len(self.laws.OWN.pieces), self.sizes.pieces
        if filled > room:
            raise EntryError("laws.OWN.pieces", f"{filled} rows do not fit into {room}; raise sizes.pieces")
        require_room(self.selection, self.sizes)
        require_law(self.cutter.law, self.laws, self.sizes)
        from workbook.machines.flying.view import tool_of

        least = tool_of(self.cutter).tool_length / MM * LONGER
        for entry, length in (
            ("product_length", self.cutter.product_length),
            ("lengths.shortest", self.cutter.lengths.shortest),
        ):
            if length < least:
                raise EntryError(
                    f"cutter.{entry}",
                    f"a product of {length:g} mm leaves no time to re-position; expected at least {least:.6g} mm",
                )
        return self


def require_law(code: str, given: Laws, sizes: Sizes) -> None:
    """Raise EntryError unless the law goes from rest to rest, speeds up once and slows down once."""
    law = laws(given, sizes.own_law)[code]
    speeds = law.v(velocity_extremes(law))
    top = int(np.argmax(speeds))
    falls = np.diff(speeds)
    fault = None
    if not is_monotone(law):
        fault = "moves backwards; expected a law that rises throughout"
    elif abs(law.end.s - 1) > BREAK_TOLERANCE:
        fault = f"ends at s = {law.end.s:g}; expected a law that ends at 1"
    elif max(abs(law.start.v), abs(law.end.v)) > REST:
        fault = "does not begin and end at rest; expected a law that does"
    elif min(falls[:top].min(initial=0.0), -falls[top:].max(initial=0.0)) < -REST:
        fault = "speeds up more than once; expected a law that speeds up once, then slows down"
    elif law.coefficients.cv < LEAST_CV:
        fault = f"has C_v = {law.coefficients.cv:g}; expected at least {LEAST_CV:g}"
    if fault:
        raise EntryError("cutter.law", f"the law {code} {fault}")
