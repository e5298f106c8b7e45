"""Entries of a drive beside its mechanism: load, rotating parts, motor, reducer and catalogues."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from workbook.book.limits import RowRule
from workbook.book.sentence import figure
from workbook.fields.texts import LOOKED_UP, Text
from workbook.fields.types import DesignError, EmptyCell, EntryError, MakesCells, Model, NotNegative, Number, Positive
from workbook.machines.machine.entries_beside import Name
from workbook.selection.catalogue import Factor
from workbook.selection.entries import Products, Ranked

Efficiency = Annotated[float, Field(gt=0, ge=0.01, le=1, allow_inf_nan=False)]
BackEfficiency = Annotated[float, Field(ge=-10, le=1, allow_inf_nan=False)]
Slope = Annotated[float, Field(ge=-90, le=90)]
Temperature = Annotated[float, Field(ge=-60, le=400, allow_inf_nan=False)]
Product = Annotated[str, Field(max_length=60), LOOKED_UP]
"""the name of a product in the catalogue; empty where its figures are entered"""
# figures of a motor without a name
NEEDED = ("inertia", "rated_torque", "peak_torque", "max_speed")
TRAVELLING_LOAD = ("mass", "friction", "slope", "force")
TURNING_LOAD = ("inertia", "torque", "friction_torque")
WINDOWS = 4  # process forces of an axis, at most
STAGES = 2  # between reducer and mechanism, at most
UNTOLD = "neither the name of a motor in the catalogue, nor all its figures"


class PowerEntry(Model):
    """The entries that all drives share: efficiency between motor and mains, hours of running in a year, price."""

    efficiency: Efficiency = 1.0
    hours: Annotated[float, Field(ge=0, le=8784)] = 0.0
    price: NotNegative = 0.0


class ForceWindow(Model):
    """A process force, N or Nm, between two places of the cycle, across its end where it ends before it begins."""

    start: NotNegative
    stop: NotNegative
    force: Number
    resists: Literal["always", "moving"] = "always"


class Backlash(Model):
    """A gap behind the reducer, measured at the load, and the process force that acts while the tool works."""

    gap: Positive
    works: Annotated[int, Field(ge=1, le=WINDOWS)] | None = None


class SwingingArm(Model):
    """The weight of an arm that swings in a vertical plane; its inertia is entered with the load's."""

    mass: NotNegative = 0.0
    radius: NotNegative = 0.0
    angle: Number = 0.0


class AxisLoad(Model):
    """The load of an axis: a mass where it travels, an inertia where it turns, and the forces that resist."""

    mass: NotNegative = 0.0
    friction: NotNegative = 0.0
    slope: Slope = 0.0
    force: Number = 0.0
    inertia: NotNegative = 0.0
    torque: Number = 0.0
    friction_torque: NotNegative = 0.0
    # with it the axis' sheet has an entry for it
    viscous: Annotated[NotNegative, MakesCells(0.0)] | None = None
    arm: SwingingArm | None = None
    windows: Annotated[list[ForceWindow], Field(max_length=WINDOWS)] = []  # noqa: RUF012 - frozen


def lacking(travels: bool, viscous: float | None) -> set[str]:
    """Return the entries of a load that an axis has no cell for: of the other motion, and viscous friction."""
    return {*(TURNING_LOAD if travels else TRAVELLING_LOAD), *(() if viscous is not None else ("viscous",))}


class MotorBrake(Model):
    """The brake of a motor, at its shaft. It holds in dwells that are no shorter than it takes to close and open."""

    torque: Positive
    closing: NotNegative = 0.0
    opening: NotNegative = 0.0


class AxisMotor(Model):
    """A motor by its name in the catalogue, or by its figures; at rest it holds the load, or a brake does."""

    name: Product = ""
    inertia: NotNegative | None = None
    stall_torque: Positive | None = None
    rated_torque: Positive | None = None
    rated_speed: Positive | None = None
    peak_torque: Positive | None = None
    max_speed: Positive | None = None
    copper_losses: NotNegative | None = None
    holding: Literal["motor", "brake"] = "motor"
    brake: MotorBrake | None = None  # with it the axis' sheet has entries and a check of the brake
    temperature: Temperature | None = None
    rated_at: Temperature = 40.0
    limit: Temperature = 155.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a figure that is missing of a motor without a name, and a temperature above its limit."""
        for name in NEEDED:
            if not self.name and getattr(self, name) is None:
                yield DesignError(name, UNTOLD, 1.0)
        hottest = figure(max(self.temperature or 0.0, self.rated_at))
        for name in ("temperature", "rated_at"):
            if (getattr(self, name) or 0.0) >= self.limit:
                problem = f"{hottest} °C; expected less than the limit, {figure(self.limit)} °C"
                yield DesignError(name, problem, self.limit - 1.0)


class Reducer(Model):
    """The gear unit between motor and mechanism, by its name in the catalogue, or by its figures."""

    name: Product = ""
    ratio: Annotated[Positive, EmptyCell()] = 1.0
    efficiency: Annotated[Efficiency, EmptyCell()] = 1.0
    inertia: NotNegative = 0.0
    no_load_torque: NotNegative = 0.0
    peak_torque: Positive | None = None
    full_cycles: Positive | None = None
    cycle_factor: Factor | None = None
    mean_torque: Positive | None = None
    max_speed: Positive | None = None


STAGED = "expected either a ratio or the teeth of both wheels"


class StageEntry(Model):
    """A stage between reducer and mechanism, such as a toothed belt: by its ratio, or by the teeth of both wheels."""

    ratio: Positive | None = None
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None
    driver_inertia: NotNegative = 0.0
    driven_inertia: NotNegative = 0.0
    efficiency: Annotated[Efficiency, EmptyCell()] = 1.0
    back_efficiency: BackEfficiency | None = None
    friction_torque: NotNegative = 0.0

    @property
    def reduction(self) -> float:
        """The ratio, by teeth if these are given; 1 where nothing is."""
        if self.teeth_driver is not None and self.teeth_driven is not None:
            return self.teeth_driven / self.teeth_driver
        return self.ratio or 1.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a stage with neither a ratio nor teeth, or with both."""
        teeth = [self.teeth_driver, self.teeth_driven]
        if (self.ratio is None and None in teeth) or (self.ratio is not None and any(teeth)):
            settled = self.model_dump() | {"ratio": self.reduction, "teeth_driver": None, "teeth_driven": None}
            yield DesignError("", STAGED, settled)


class AxisPart(Model):
    """Rotating parts on the motor's shaft, or on the mechanism's, behind the reducer; or geared to it."""

    name: Text
    count: NotNegative
    inertia: NotNegative | None = None
    diameter: NotNegative | None = None
    length: NotNegative | None = None
    density: NotNegative | None = None
    bore: NotNegative | None = None
    teeth_driver: Positive | None = None
    teeth_driven: Positive | None = None
    shaft: Literal["motor", "mechanism"]

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


class Choice(Ranked):
    """The catalogues: those that come with the templates where none are entered, or by the word.

    With an axis, a sheet Selection looks for its motor and reducer.
    """

    axis: Annotated[Name, MakesCells("A")] | None = None
    falling: bool | None = None

    @model_validator(mode="after")
    def _as_catalogued(self) -> Self:
        """Leave out what the catalogue says too: a description stays as it is, through a book and back."""
        if self.falling is any(map(falling, self.motors)):
            object.__setattr__(self, "falling", None)
        return self

    @property
    def knows_falling(self) -> bool:
        """Whether the sheets of drives know such motors."""
        return any(map(falling, self.motors)) if self.falling is None else self.falling

    @model_validator(mode="after")
    def _without_axis(self) -> Self:
        own = [name for name in Ranked.model_fields if name not in Products.model_fields]
        given = [name for name in own if getattr(self, name) != Ranked.model_fields[name].default]
        if self.axis is None and given:
            problem = "no axis is told for the sheet Selection; expected selection.axis, or none of this"
            raise EntryError(given[0], problem)
        return self


def falling(motor: Any) -> bool:
    """Return whether the peak torque of a motor of a catalogue falls, as it is entered or as a row."""
    end = motor.get("end_torque") if isinstance(motor, dict) else getattr(motor, "end_torque", None)
    return end is not None
