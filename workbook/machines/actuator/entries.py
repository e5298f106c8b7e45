"""Sizing of an actuator (S4): what an engineer enters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.book.sentence import figure
from workbook.drive.entries import Efficiency, Gear, MotorLimits, PlacedParts
from workbook.entries.exported import Exporting
from workbook.entries.phase import PhaseEntry
from workbook.entries.types import DesignError, EntryError, Model, NotNegative, Number, Positive
from workbook.motion.asked import Smoothness
from workbook.motion.room import settle_phases
from workbook.selection.entries import Selection, SelectionSizes, require_room

Kind = Literal["lead screw", "conveyor", "rack and pinion", "belt", "rotary table", "gear train"]
"""of the engine's mechanisms, those that an actuator can have"""

Temperature = Annotated[float, Field(ge=-60, le=400, allow_inf_nan=False)]  # °C


class Output(Model):
    """The last element, which turns rotation into travel."""

    turns: Positive | None = None  # rev/mm
    diameter: Positive | None = None  # mm
    efficiency: Efficiency


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


class ActuatorMotor(MotorLimits):
    """The motor: its inertia, entered or by a ratio; its limits; where it works."""

    inertia: NotNegative | None = None  # kg m²; empty: by the ratio
    inertia_ratio: Positive | None = None  # J_machine / J_m
    temperature: Temperature
    rated_at: Temperature
    limit: Temperature

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a motor of no known inertia, or hotter than its limit."""
        if self.inertia is None and self.inertia_ratio is None:
            yield DesignError("inertia_ratio", "neither the motor's inertia nor a ratio is entered", "inertia", 1.0)
        for name in ("temperature", "rated_at"):
            if getattr(self, name) >= self.limit:
                hottest = max(self.temperature, self.rated_at)
                said = f"{figure(hottest)} °C; expected less than the limit, {figure(self.limit)} °C"
                yield DesignError(name, said, "cool", self.limit - 1.0)


class ActuatorEntry(Model):
    """The mechanism, its load, the load's motion and the motor."""

    mechanism: Kind
    method: Literal["physical", "document"] = "physical"
    holding: Literal["motor", "brake"] = "motor"
    smoothness: Smoothness = "acceleration"
    output: Output
    gears: list[Gear] = Field(default_factory=list)
    parts: list[PlacedParts] = Field(default_factory=list)
    load: ActuatorLoad = ActuatorLoad()
    phases: Annotated[list[PhaseEntry], Field(min_length=1)]  # lifts in mm or degrees, durations in s
    motor: ActuatorMotor

    def design_faults(self) -> Iterator[DesignError]:
        """Yield parts behind gears that are not there."""
        gears = len(self.gears)
        behind = [part.shaft for part in self.parts]
        if max(behind, default=0.0) > gears:
            i = behind.index(max(behind))
            said = f"row {i + 1}: behind {figure(behind[i])} gears, of {gears}"
            fits = [part.model_dump() | {"shaft": min(part.shaft, float(gears))} for part in self.parts]
            yield DesignError("parts", said, "shafts", fits)


class ActuatorSizes(SelectionSizes):
    """How large the tables are built: also the rows for gears."""

    phases: Annotated[int, Field(ge=2, le=24)] = 6
    gears: Annotated[int, Field(ge=2, le=6)] = 2


class ActuatorSizing(Exporting):
    """Sizing of an actuator (S4)."""

    AXES = ("load",)
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
        ):
            if filled > room:
                raise EntryError(path, f"{filled} rows do not fit into {room}; raise sizes.{size}")
        require_room(self.selection, self.sizes)
        settle_phases(self, {"actuator.phases": a.phases})
        return self
