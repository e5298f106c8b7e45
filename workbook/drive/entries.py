"""What descriptions say of a drive: rotating parts, load, motor and reducer."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from workbook.book.limits import RowRule
from workbook.entries.texts import Text
from workbook.entries.types import DesignError, Model, NotNegative, Positive

Efficiency = Annotated[float, Field(gt=0, ge=0.01, le=1, allow_inf_nan=False)]


class MotorLimits(Model):
    """What a motor can give."""

    rated_torque: Positive  # Nm
    peak_torque: Positive  # Nm
    max_speed: Positive  # rpm


class RotatingParts(Model):
    """Rotating parts that turn alike, and how many."""

    name: Text
    count: NotNegative


class GearedParts(RotatingParts):
    """Rotating parts on a shaft, or geared to it: the inertia of one, the teeth of the gear that drives them."""

    inertia: NotNegative  # kg m²
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None

    def design_faults(self) -> Iterator[DesignError]:
        """Yield teeth of one gear without the other's."""
        if (self.teeth_driver is None) != (self.teeth_driven is None):
            missing = "teeth_driver" if self.teeth_driver is None else "teeth_driven"
            yield DesignError(missing, GEARED.words, GEARED.rule, 1.0)


GEARED = RowRule("geared", "COUNT([driver],[driven])<>1", "driver", "teeth of one gear alone, of the driver")


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

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a part of no known inertia, or of two; a bore as large as the cylinder; half a gear."""
        size = {"diameter": self.diameter, "length": self.length, "density": self.density}
        missing = [name for name, value in size.items() if value is None]
        if self.inertia is None and missing:
            entry, fits = ("inertia", 0.0) if len(missing) == len(size) else (missing[0], 1.0)
            yield DesignError(entry, SIZED.words, SIZED.rule, fits)
        if self.inertia is not None and (len(missing) < len(size) or self.bore is not None):
            alone = self.model_dump() | dict.fromkeys([*size, "bore"])
            yield DesignError("", ALONE.words, ALONE.rule, alone)
        if self.bore and self.bore >= (self.diameter or 0.0):
            yield DesignError("bore", BORED.words, BORED.rule, 0.0)
        if self.shaft != int(self.shaft):
            yield DesignError("shaft", WHOLE.words, WHOLE.rule, float(int(self.shaft)))


SIZED = RowRule(
    "sized", 'OR([inertia]<>"",COUNT([diameter],[length],[density])=3)', "inertia",
    "neither an inertia nor a cylinder's diameter, length and density: inertia",
)  # fmt: skip
ALONE = RowRule(
    "alone", 'OR([inertia]="",COUNT([diameter],[length],[density],[bore])=0)', "inertia",
    "both an inertia and a cylinder: inertia",
)  # fmt: skip
BORED = RowRule("bored", "OR([bore]+0=0,[bore]+0<[diameter]+0)", "bore", "bore, not less than the diameter")
WHOLE = RowRule("whole", "[shaft]+0=INT([shaft]+0)", "shaft", "gears before it, no whole number")
