"""What a description says of a drive: rotating parts, load, motor and reducer."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.entries.types import EntryError, Model, NotNegative, Number, Positive, Text


class Rotor(Model):
    """Rotating parts that turn alike: how many, the inertia of one, the teeth of the gear that drives them."""

    name: Text
    count: NotNegative
    inertia: NotNegative  # kg m²
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None

    @model_validator(mode="after")
    def _geared(self) -> Self:
        if (self.teeth_driver is None) != (self.teeth_driven is None):
            missing = "teeth_driver" if self.teeth_driver is None else "teeth_driven"
            raise EntryError(missing, "one of the two teeth counts is empty; expected both, or neither")
        return self


class Motor(Model):
    """The motor and its reducer, as the drive sheet needs them."""

    inertia: NotNegative  # kg m²
    rated_torque: Positive  # Nm
    peak_torque: Positive  # Nm
    max_speed: Positive  # rpm
    reduction: Positive  # ω_m/ω_r
    efficiency: Annotated[float, Field(gt=0, le=1)] = 1.0


class Drive(Model):
    """The drive of one axis: load, rotors, motor."""

    rate: Positive  # pieces/min
    axis: str
    force: Number  # N
    radius: Positive  # m
    resists: Literal["always", "moving"] = "always"
    rotors: Annotated[list[Rotor], Field(min_length=1)]
    motor: Motor
