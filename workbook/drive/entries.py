"""What descriptions say of a drive: rotating parts, load, motor and reducer."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.entries.texts import Text
from workbook.entries.types import EntryError, Model, NotNegative, Number, Positive

Efficiency = Annotated[float, Field(gt=0, ge=0.01, le=1, allow_inf_nan=False)]


class MotorLimits(Model):
    """What a motor can give."""

    rated_torque: Positive  # Nm
    peak_torque: Positive  # Nm
    max_speed: Positive  # rpm


class GearMotor(MotorLimits):
    """A motor with its reducer."""

    inertia: NotNegative  # kg m²
    reduction: Positive  # ω_m/ω_r
    efficiency: Annotated[float, Field(gt=0, le=1)] = 1.0


class RotatingParts(Model):
    """Rotating parts that turn alike, and how many."""

    name: Text
    count: NotNegative


class GearedParts(RotatingParts):
    """Rotating parts on a shaft, or geared to it: the inertia of one, the teeth of the gear that drives them."""

    inertia: NotNegative  # kg m²
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None

    @model_validator(mode="after")
    def _geared(self) -> Self:
        if (self.teeth_driver is None) != (self.teeth_driven is None):
            missing = "teeth_driver" if self.teeth_driver is None else "teeth_driven"
            raise EntryError(missing, "one of the two teeth counts is empty; expected both, or neither")
        return self


class Gear(Model):
    """A gear between the motor and the last element."""

    name: Text
    ratio: Positive  # speed before it over speed behind it
    efficiency: Efficiency = 1.0


class PlacedParts(RotatingParts):
    """Rotating parts behind a number of gears: the inertia of one, or a cylinder."""

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


class RollerDrive(Model):
    """The drive of one axis by rollers: load, rotating parts, motor."""

    rate: Positive  # pieces/min
    axis: Text
    force: Number  # N
    radius: Positive  # m
    resists: Literal["always", "moving"] = "always"
    rotors: Annotated[list[GearedParts], Field(min_length=1)]
    motor: GearMotor
