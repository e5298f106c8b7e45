"""Entries of descriptions about rotating parts, and of efficiencies."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from workbook.book.limits import RowRule
from workbook.fields.texts import Text
from workbook.fields.types import DesignError, Model, NotNegative, Positive

Efficiency = Annotated[float, Field(gt=0, ge=0.01, le=1, allow_inf_nan=False)]
BackEfficiency = Annotated[float, Field(ge=-10, le=1, allow_inf_nan=False)]


class RotatingParts(Model):
    """Rotating parts that turn alike: how many, the inertia of one or a cylinder's size, teeth if they are geared."""

    name: Text
    count: NotNegative
    inertia: NotNegative | None = None
    diameter: NotNegative | None = None
    length: NotNegative | None = None
    density: NotNegative | None = None
    bore: NotNegative | None = None
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a part of no known inertia, or of two; a bore as large as the cylinder; teeth of a gear alone."""
        size = {"diameter": self.diameter, "length": self.length, "density": self.density}
        missing = [name for name, value in size.items() if value is None]
        if self.inertia is None and missing:
            entry, fits = ("inertia", 0.0) if len(missing) == len(size) else (missing[0], 1.0)
            yield DesignError(entry, SIZED.words, fits)
        if self.inertia is not None and (len(missing) < len(size) or self.bore is not None):
            alone = self.model_dump() | dict.fromkeys([*size, "bore"])
            yield DesignError("", ALONE.words, alone)
        if self.bore and self.bore >= (self.diameter or 0.0):
            yield DesignError("bore", BORED.words, 0.0)
        if (self.teeth_driver is None) != (self.teeth_driven is None):
            entry = "teeth_driver" if self.teeth_driver is None else "teeth_driven"
            yield DesignError(entry, GEARED.words, 1.0)


SIZED = RowRule(
    "sized",
    'OR([used]=0,[inertia]<>"",COUNT([diameter],[length],[density])=3)',
    "inertia",
    "neither an inertia nor a cylinder's diameter, length and density: inertia",
)
ALONE = RowRule(
    "alone",
    'OR([inertia]="",COUNT([diameter],[length],[density],[bore])=0)',
    "inertia",
    "both an inertia and a cylinder: inertia",
)
BORED = RowRule("bored", "OR([bore]+0=0,[bore]+0<[diameter]+0)", "bore", "bore, not less than the diameter")
GEARED = RowRule("geared", "COUNT([driver],[driven])<>1", "driver", "teeth of one gear alone, of the driver")
