"""Sizing of an actuator (S4): what an engineer enters."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from engine.mechanism import cylinder
from workbook.entries.machine import Machine
from workbook.entries.phase import PhaseEntry
from workbook.entries.types import EntryError, Model, NotNegative, Number, Positive, Text
from workbook.entries.units import MM
from workbook.selection.entries import Selection, SelectionSizes, require_room

Kind = Literal["lead screw", "conveyor", "rack and pinion", "belt", "rotary table", "gear train"]
KINDS = {
    "lead screw": ("screw", True, False),
    "conveyor": ("roller", True, True),
    "rack and pinion": ("pinion", True, False),
    "belt": ("pulley", True, True),
    "rotary table": ("table", False, False),
    "gear train": ("last gear", False, False),
}
"""each mechanism's last element, whether its load travels, whether a belt moves with it"""

Efficiency = Annotated[float, Field(gt=0, ge=0.01, le=1, allow_inf_nan=False)]
Temperature = Annotated[float, Field(ge=-60, le=400, allow_inf_nan=False)]  # °C


class Output(Model):
    """The last element, which turns rotation into travel."""

    turns: Positive | None = None  # rev/mm
    diameter: Positive | None = None  # mm
    efficiency: Efficiency


class Gear(Model):
    """A gear between the motor and the last element."""

    name: Text
    ratio: Positive  # speed before it over speed behind it
    efficiency: Efficiency = 1.0


class RotatingPart(Model):
    """Equal rotating parts: the inertia of one, or a cylinder; behind how many of the gears it turns."""

    name: Text
    count: NotNegative
    inertia: NotNegative | None = None  # kg m²
    diameter: NotNegative | None = None  # mm
    length: NotNegative | None = None  # mm
    density: NotNegative | None = None  # kg/m³
    bore: NotNegative | None = None  # mm
    shaft: NotNegative = 0.0

    @model_validator(mode="after")
    def _one_or_the_other(self) -> Self:
        size = {"diameter": self.diameter, "length": self.length, "density": self.density}
        if self.inertia is None:
            missing = next((name for name, value in size.items() if value is None), None)
            if missing:
                raise EntryError(missing, "empty; expected an inertia, or diameter, length and density")
        elif any(value is not None for value in (*size.values(), self.bore)):
            raise EntryError("inertia", "both an inertia and the size of a cylinder; expected one of them")
        if self.bore and self.bore >= (self.diameter or 0.0):
            raise EntryError("bore", f"the bore is {self.bore:g} mm; expected less than the diameter")
        if self.shaft != int(self.shaft):
            raise EntryError("shaft", f"found {self.shaft:g}; expected the number of gears before it")
        return self

    @property
    def one(self) -> float:
        """Inertia of one, kg m²."""
        if self.inertia is not None:
            return self.inertia
        sizes = [(x or 0.0) * MM for x in (self.diameter, self.length, self.bore)]
        return cylinder(sizes[0] / 2, sizes[1], self.density or 0.0, sizes[2] / 2)


class ActuatorLoad(Model):
    """What is moved and what resists: of a load that travels, and of one that turns."""

    mass: NotNegative = 0.0  # kg
    count: NotNegative = 1.0
    belt: NotNegative = 0.0  # kg
    friction: NotNegative = 0.0
    slope: Annotated[float, Field(ge=-90, le=90, allow_inf_nan=False)] = 0.0  # degrees
    force: Number = 0.0  # N
    inertia: NotNegative = 0.0  # kg m²
    torque: Number = 0.0  # Nm
    friction_torque: NotNegative = 0.0  # Nm


class ActuatorMotor(Model):
    """The motor: its inertia, entered or by a ratio; its limits; where it works."""

    inertia: NotNegative | None = None  # kg m²; empty: by the ratio
    inertia_ratio: Positive | None = None  # J_machine / J_m
    rated_torque: Positive  # Nm
    peak_torque: Positive  # Nm
    max_speed: Positive  # rpm
    temperature: Temperature
    rated_at: Temperature
    limit: Temperature

    @model_validator(mode="after")
    def _cooler(self) -> Self:
        if self.inertia is None and self.inertia_ratio is None:
            raise EntryError("inertia_ratio", "empty, and so is the motor's inertia; expected one of the two")
        for name in ("temperature", "rated_at"):
            if getattr(self, name) >= self.limit:
                raise EntryError(name, f"{getattr(self, name):g} °C; expected less than the limit, {self.limit:g} °C")
        return self


class ActuatorEntry(Model):
    """The mechanism, its load, the load's motion and the motor."""

    mechanism: Kind
    method: Literal["physical", "document"] = "physical"
    holding: Literal["motor", "brake"] = "motor"
    output: Output
    gears: list[Gear] = Field(default_factory=list)
    parts: list[RotatingPart] = Field(default_factory=list)
    load: ActuatorLoad = ActuatorLoad()
    phases: Annotated[list[PhaseEntry], Field(min_length=1)]  # lifts in mm or degrees, durations in s
    motor: ActuatorMotor

    @model_validator(mode="after")
    def _element(self) -> Self:
        element, travels, _ = KINDS[self.mechanism]
        if self.mechanism == "lead screw" and self.output.turns is None:
            raise EntryError("output.turns", "empty; a lead screw needs its turns per mm")
        if self.mechanism != "lead screw" and travels and self.output.diameter is None:
            raise EntryError("output.diameter", f"empty; a {self.mechanism} needs the diameter of its {element}")
        return self


class ActuatorSizes(SelectionSizes):
    """How large the tables are built: also the rows for gears."""

    phases: Annotated[int, Field(ge=2, le=24)] = 6
    gears: Annotated[int, Field(ge=2, le=6)] = 2


class ActuatorSizing(Machine):
    """Sizing of an actuator (S4)."""

    template: Literal["actuator-sizing"] = "actuator-sizing"
    actuator: ActuatorEntry
    selection: Selection = Selection()
    sizes: ActuatorSizes = ActuatorSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        a = self.actuator
        for path, filled, room, size in (
            ("actuator.gears", len(a.gears), self.sizes.gears, "gears"),
            ("actuator.parts", len(a.parts), self.sizes.rotors, "rotors"),
            ("actuator.phases", len(a.phases), self.sizes.phases, "phases"),
            ("laws.OWN.pieces", len(self.laws.OWN.pieces), self.sizes.pieces, "pieces"),
        ):
            if filled > room:
                raise EntryError(path, f"{filled} rows do not fit into {room}; raise sizes.{size}")
        require_room(self.selection, self.sizes)
        for i, part in enumerate(a.parts):
            if part.shaft > len(a.gears):
                expected = f"0 to {len(a.gears)}, the number of gears"
                raise EntryError(f"actuator.parts.{i}.shaft", f"found {part.shaft:g}; expected {expected}")
        return self
