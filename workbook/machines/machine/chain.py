"""What drives an axis of a machine: mechanism, load, parts, motor and reducer, as an engineer enters them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field, model_validator

from workbook.book.sentence import figure
from workbook.drive.entries import Efficiency, RotatingParts
from workbook.entries.texts import LOOKED_UP
from workbook.entries.types import Angle, DesignError, EmptyCell, Model, NotNegative, Number, Positive

Kind = Literal[
    "lead screw",
    "conveyor",
    "rack and pinion",
    "belt",
    "feed rollers",
    "rotary table",
    "gear train",
    "crank-slider",
    "rocker",
    "table",
]
LARGE: dict[str, dict[str, Any]] = {
    "crank-slider": {"crank": 1e4, "rod": 5e4, "position": 1e4},
    "rocker": {"lever": 1e5, "link": 5e5, "offset": 1e5, "angle": 90.0},
    "table": {"points": [{"angle": end, "position": end} for end in (-1e4, 1e4)]},
}
"""of mechanisms of a ratio that changes, sizes with which it reaches wherever an axis goes"""
TURNING = ("rotary table", "gear train")
BELTED = ("conveyor", "belt")
"""mechanisms of which a belt moves with the load"""
SCREWS = ("lead screw",)
"""mechanisms whose losses are friction in a thread"""
TABLE = "table"
EITHER = (TABLE,)
"""mechanisms of axes that travel, and of those that turn"""
LINKED: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "crank-slider": (("crank", "rod"), ("offset", "zero", "branch", "position")),
    "rocker": (("lever", "link", "angle"), ("offset", "slide", "direction")),
    "table": (("points",), ()),
}
"""of each mechanism of a ratio that changes: the entries that it must have, and those that may be empty"""
Slope = Annotated[float, Field(ge=-90, le=90)]
Temperature = Annotated[float, Field(ge=-60, le=400, allow_inf_nan=False)]
Product = Annotated[str, Field(max_length=60), LOOKED_UP]
"""the name of one in the catalogue; empty where its figures are entered"""
UNSIZED = "a size of the mechanism is empty"
LEAST_POINTS = 2
UNTOLD = "neither the name of a motor in the catalogue, nor all its figures"


def size_by_kind(made: dict[str, Any]) -> None:
    """Let the schema of a mechanism do without the size: not every kind has one."""
    made["required"] = [name for name in made["required"] if name != "size"]


class TablePoint(Model):
    """A point of a table: an angle of the shaft in °, and the position of the load there, in mm or °."""

    angle: Number = Field(description="Of a point of the table: angle of the shaft, in °")
    position: Number = Field(description="Of a point of the table: position of the load, in the axis' unit")


class MechanismEntry(Model):
    """What makes the motor's turning the axis' motion: its size is a screw's lead, a diameter or a radius in mm."""

    model_config = ConfigDict(json_schema_extra=size_by_kind)

    kind: Kind = Field(description="What turns the motor's motion into the axis'")
    size: Positive  # 1 where the axis turns with it, or other entries tell its size
    efficiency: Efficiency
    back_efficiency: Annotated[float, Field(ge=-10, le=1, allow_inf_nan=False)] | None = Field(
        default=None,
        description="Efficiency where the load drives it; 0 or less: it locks itself. If empty, 2 - 1/efficiency of a "
        "screw, and the efficiency of all else",
    )
    method: Literal["physical", "document"] = Field(
        default="physical",
        description="Losses: by the flow of power through each stage, or over the efficiency always, as S4 has it",
    )
    belt: NotNegative | None = Field(default=None, description="Of a conveyor or a belt: mass of the belt, in kg")
    crank: Positive | None = Field(default=None, description="Of a crank-slider: radius of the crank, in mm")
    rod: Positive | None = Field(default=None, description="Of a crank-slider: length of the connecting rod, in mm")
    offset: Number | None = Field(default=None, description="From the shaft to the slide's line, in mm; 0 if empty")
    zero: Literal["inner", "outer"] | None = Field(
        default=None, description="Of a crank-slider: the dead centre that positions grow from; inner if empty"
    )
    branch: Literal["ahead", "behind"] | None = Field(
        default=None,
        description="Whether the crank is ahead of the line from shaft to slide, or behind; ahead if empty",
    )
    position: NotNegative | None = Field(
        default=None,
        description="Of a crank-slider: how far from that dead centre the motion begins, in mm; 0 if empty",
    )
    lever: Positive | None = Field(default=None, description="Of a rocker: length of the lever, in mm")
    link: Positive | None = Field(default=None, description="Of a rocker: length of the link, in mm")
    angle: Number | None = Field(
        default=None,
        description="Of a rocker: the lever from the line's direction where the motion begins, in °",
    )
    slide: Literal["ahead", "behind"] | None = Field(
        default=None,
        description="Of a rocker: the slide ahead of the lever's end, or behind; ahead if empty",
    )
    direction: Literal["forward", "backward"] | None = Field(
        default=None, description="Of a rocker: whether positions grow along the line's direction; forward if empty"
    )
    points: list[TablePoint] = Field(
        default=[],
        description="Of a table: the load's position over the shaft's angle, both strictly rising",
    )

    @model_validator(mode="before")
    @classmethod
    def _turns(cls, data: Any) -> Any:
        turning = isinstance(data, dict) and data.get("kind") in (*TURNING, *LINKED)
        return {"size": 1.0} | data if turning else data

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a size that is missing of a mechanism of a ratio that changes."""
        for name in LINKED.get(self.kind, ((), ()))[0]:
            if name == "points" and len(self.points) < LEAST_POINTS:
                yield DesignError(name, UNSIZED, "sized", LARGE[self.kind][name])
            elif getattr(self, name) is None:
                yield DesignError(name, UNSIZED, "sized", 1.0)

    @property
    def foreign(self) -> Iterator[str]:
        """The entries that are of other mechanisms."""
        own = {name for both in LINKED.get(self.kind, ()) for name in both}
        others = {name for names in LINKED.values() for both in names for name in both} - own
        others |= set() if self.kind in BELTED else {"belt"}
        yield from (name for name in sorted(others) if getattr(self, name) not in (None, []))


class PowerEntry(Model):
    """What all drives share: their efficiency between motor and mains, and the hours of running in a year."""

    efficiency: Efficiency = Field(default=1.0, description="Of a drive, between its motor's shaft and the mains")
    hours: Annotated[float, Field(ge=0, le=8784)] = Field(default=0.0, description="Hours of running in a year")


class ForceWindow(Model):
    """A process force, N or Nm, from one angle of the cycle to another; one that ends before it begins runs across."""

    start: Angle
    stop: Angle
    force: Number
    resists: Literal["always", "moving"] = Field(
        default="always", description="Against positive motion always, or against any motion"
    )


WINDOWS = 4


class AxisLoad(Model):
    """What hangs on an axis: of one that travels a mass, of one that turns an inertia, and what resists."""

    mass: NotNegative = 0.0  # kg
    friction: NotNegative = 0.0  # coefficient
    slope: Slope = 0.0  # degrees
    force: Number = 0.0  # N
    inertia: NotNegative = Field(default=0.0, description="Inertia that turns with the axis, in kg cm²")
    torque: Number = Field(default=0.0, description="Torque against positive motion, in Nm; always, also at rest")
    friction_torque: NotNegative = Field(default=0.0, description="Friction torque, in Nm; it opposes the motion")
    viscous: NotNegative | None = Field(
        default=None,
        description="Viscous friction, in N per m/s, or Nm per rad/s; with it the axis' sheet has an entry for it",
    )
    windows: Annotated[list[ForceWindow], Field(max_length=WINDOWS)] = []  # noqa: RUF012 - frozen


class AxisMotor(Model):
    """A motor by its name in the catalogue, or by its figures; at rest it holds the load, or a brake does."""

    name: Product = ""
    inertia: NotNegative | None = None  # kg cm²
    rated_torque: Positive | None = None  # Nm
    peak_torque: Positive | None = None  # Nm
    max_speed: Positive | None = None  # rpm
    holding: Literal["motor", "brake"] = "motor"
    temperature: Temperature | None = Field(
        default=None, description="Around it, in °C, where that lowers its rated torque; empty: as rated"
    )
    rated_at: Temperature = Field(default=40.0, description="That its rated torque holds at, in °C")
    limit: Temperature = Field(default=155.0, description="The largest of its winding, in °C")

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a figure that is missing of a motor without a name, and one hotter than its limit."""
        for name in ("inertia", "rated_torque", "peak_torque", "max_speed"):
            if not self.name and getattr(self, name) is None:
                yield DesignError(name, UNTOLD, "told", 1.0)
        for name in ("temperature", "rated_at"):
            if (getattr(self, name) or 0.0) >= self.limit:
                hottest = max(self.temperature or 0.0, self.rated_at)
                said = f"{figure(hottest)} °C; expected less than the limit, {figure(self.limit)} °C"
                yield DesignError(name, said, "cool", self.limit - 1.0)


class Reducer(Model):
    """What stands between motor and mechanism, by its name in the catalogue, or by its figures."""

    name: Product = ""
    ratio: Annotated[Positive, EmptyCell()] = 1.0  # motor over mechanism
    efficiency: Annotated[Efficiency, EmptyCell()] = 1.0
    inertia: NotNegative = 0.0  # kg cm², at the motor's shaft
    peak_torque: Positive | None = None  # Nm, behind it
    mean_torque: Positive | None = None  # Nm, behind it: the cubic mean, weighted by speed
    max_speed: Positive | None = None  # rpm, of the input


class AxisPart(RotatingParts):
    """Rotating parts on the motor's shaft, or on the mechanism's, behind the reducer; or geared to it."""

    shaft: Literal["motor", "mechanism"]


TRAVELLING_LOAD, TURNING_LOAD = ("mass", "friction", "slope", "force"), ("inertia", "torque", "friction_torque")
