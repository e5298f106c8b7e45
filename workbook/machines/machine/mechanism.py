"""The mechanisms of an axis' drive as an engineer enters them: a model for each kind, with its own sizes."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, get_args

from pydantic import Field

from workbook.drive.entries import BackEfficiency, Efficiency, in_unit, noted
from workbook.fields.types import DesignError, MakesCells, Model, NotNegative, Number, Positive

ON_BED = "more of the belt lies on the bed than the whole belt"
UNSIZED = "a size of the mechanism is empty"
LEAST_POINTS = 2


def size(label: str, note: str = "", default: Any = None, example: float | None = None) -> Any:
    """Return the field of a size in mm, which the sheet calls so; ``example`` if no committed description has it."""
    return in_unit("mm", f"{label}{note}", default, label, example)


class MechanismEntry(Model):
    """The mechanism that makes the motor's turning the axis' motion."""

    SIZE: ClassVar[str] = ""  # the entry that sets the ratio, of a kind with a constant ratio that is not 1
    UNITS: ClassVar[tuple[str, ...]] = ("mm",)  # of axes that it moves
    NEEDED: ClassVar[tuple[str, ...]] = ()  # sizes that may be empty in an unfinished design only
    LARGE: ClassVar[dict[str, Any]] = {}  # sizes, with which a changing ratio reaches wherever an axis goes
    APART: ClassVar[str] = "the sizes of the mechanism do not go together"
    SLIDES: ClassVar[bool] = False  # whether its load travels while its axis turns

    kind: str
    efficiency: Efficiency = Field(description="Efficiency of the mechanism")
    back_efficiency: BackEfficiency | None = noted(
        None,
        "Efficiency where the load drives it; 0 or less: it locks itself. If empty, 2 - 1/efficiency of a screw, "
        "and the efficiency of all else",
    )
    method: Literal["physical", "document"] = noted(
        "physical", "Losses: by the flow of power through each stage, or over the efficiency always, as S4 has it"
    )

    @property
    def size(self) -> float:
        """The size that sets a constant ratio, in mm; 1 of a kind that has none."""
        return getattr(self, self.SIZE) if self.SIZE else 1.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield the sizes that are missing of a mechanism whose ratio changes."""
        missing = (name for name in self.NEEDED if getattr(self, name) is None)
        yield from (DesignError(name, UNSIZED, "sized", 1.0) for name in missing)


class Belted(MechanismEntry):
    """A mechanism of which a belt moves with the load."""

    belt_mass: NotNegative | None = in_unit("kg", "Mass of the belt; it moves with the load", None)
    belt_on_bed: Annotated[NotNegative, MakesCells(0.0)] | None = in_unit(
        "kg",
        "Mass of the belt that slides over a bed, with the load on it; with it the axis' sheet has an entry for it",
        None,
        example=3.0,
    )

    def design_faults(self) -> Iterator[DesignError]:
        """Yield more of the belt on the bed than there is of it."""
        yield from super().design_faults()
        if (self.belt_on_bed or 0.0) > (self.belt_mass or 0.0):
            yield DesignError("belt_on_bed", ON_BED, "on_bed", self.belt_mass or 0.0)


class LeadScrew(MechanismEntry):
    """A screw and its nut: the axis travels the lead a revolution."""

    SIZE: ClassVar[str] = "lead"
    kind: Literal["lead screw"]
    lead: Positive = size("Lead of the screw", default=...)


class Conveyor(Belted):
    """A belt over rollers that carries the load."""

    SIZE: ClassVar[str] = "roller_diameter"
    kind: Literal["conveyor"]
    roller_diameter: Positive = size("Diameter of the roller", default=...)


class RackAndPinion(MechanismEntry):
    """A pinion on a rack."""

    SIZE: ClassVar[str] = "pinion_diameter"
    kind: Literal["rack and pinion"]
    pinion_diameter: Positive = size("Pitch diameter of the pinion", default=..., example=63.66)


class Belt(Belted):
    """A belt over pulleys that pulls the load."""

    SIZE: ClassVar[str] = "pulley_diameter"
    kind: Literal["belt"]
    pulley_diameter: Positive = size("Pitch diameter of the pulley", default=...)


class FeedRollers(MechanismEntry):
    """Rollers that feed a web or film."""

    SIZE: ClassVar[str] = "roller_radius"
    kind: Literal["feed rollers"]
    roller_radius: Positive = size("Radius of the rollers", default=...)


class RotaryTable(MechanismEntry):
    """A table that turns with the reducer's output shaft."""

    UNITS: ClassVar[tuple[str, ...]] = ("°",)
    kind: Literal["rotary table"]


class GearTrain(MechanismEntry):
    """A shaft that turns with the reducer's output shaft."""

    UNITS: ClassVar[tuple[str, ...]] = ("°",)
    kind: Literal["gear train"]


class PressCrank(MechanismEntry):
    """A crank that drives a slide by a connecting rod through its dead centres; the motion is that of the crank."""

    UNITS: ClassVar[tuple[str, ...]] = ("°",)
    LARGE: ClassVar[dict[str, Any]] = {"crank_radius": 1.0, "rod_length": 10.0}
    APART: ClassVar[str] = "the rod is not longer than crank and offset: the crank cannot turn round"
    SLIDES: ClassVar[bool] = True
    kind: Literal["press crank"]
    crank_radius: Positive = size("Radius of the crank", default=...)
    rod_length: Positive = size("Length of the connecting rod", default=...)
    offset: Number | None = size("Offset of the slide's line from the shaft", "; 0 if empty")
    start_angle: Number | None = in_unit(
        "°", "Angle of the crank from the line of the slide, outwards, where the axis is at 0; 0 if empty", None
    )


class CrankSlider(MechanismEntry):
    """A crank that moves a slide by a connecting rod; the motion is that of the slide."""

    NEEDED: ClassVar[tuple[str, ...]] = ("crank_radius", "rod_length")
    LARGE: ClassVar[dict[str, Any]] = {"crank_radius": 1e4, "rod_length": 5e4, "start": 1e4}
    APART: ClassVar[str] = PressCrank.APART
    kind: Literal["crank-slider"]
    crank_radius: Positive | None = size("Radius of the crank")
    rod_length: Positive | None = size(
        "Length of the connecting rod",
        "; its mass counts as two point masses at its pins: add the slide's to the load, the crank's to the parts",
    )
    offset: Number | None = size("Offset of the slide's line from the shaft", "; 0 if empty")
    zero: Literal["inner", "outer"] | None = noted(None, "The dead centre that positions grow from; inner if empty")
    branch: Literal["ahead", "behind"] | None = noted(
        None, "Whether the crank is ahead of the line from shaft to slide, or behind; ahead if empty"
    )
    start: NotNegative | None = size("Distance from that dead centre where the motion begins", "; 0 if empty")


class Rocker(MechanismEntry):
    """A lever that moves a slide by a link; the motion is that of the slide."""

    NEEDED: ClassVar[tuple[str, ...]] = ("lever_length", "link_length", "start_angle")
    LARGE: ClassVar[dict[str, Any]] = {"lever_length": 1e5, "link_length": 5e5, "offset": 1e5, "start_angle": 90.0}
    APART: ClassVar[str] = (
        "where the motion begins, the link does not reach from the lever to the slide, or is in line with it"
    )
    kind: Literal["rocker"]
    lever_length: Positive | None = size("Length of the lever")
    link_length: Positive | None = size("Length of the link")
    offset: Number | None = size("Offset of the slide's line from the shaft", "; 0 if empty")
    start_angle: Number | None = in_unit(
        "°", "Angle of the lever from the direction of the slide's line where the motion begins", None
    )
    slide: Literal["ahead", "behind"] | None = noted(
        None, "Whether the slide is ahead of the lever's end, or behind; ahead if empty"
    )
    direction: Literal["forward", "backward"] | None = noted(
        None, "Whether positions grow along the line's direction; forward if empty"
    )


class TablePoint(Model):
    """A point of a table: an angle of the shaft in °, and the position of the load there, in mm or °."""

    angle: Number = in_unit("°", "Angle of the shaft")
    position: Number = Field(description="Position of the load there, in the axis' unit")


class Table(MechanismEntry):
    """Any mechanism whose position is known over the angle of its shaft, point by point."""

    UNITS: ClassVar[tuple[str, ...]] = ("mm", "°")
    LARGE: ClassVar[dict[str, Any]] = {"points": [{"angle": end, "position": end} for end in (-1e4, 1e4)]}
    kind: Literal["table"]
    points: list[TablePoint] = Field(
        default=[], description="The load's position over the shaft's angle, both strictly rising"
    )

    def design_faults(self) -> Iterator[DesignError]:
        """Yield points of which there are too few."""
        if len(self.points) < LEAST_POINTS:
            yield DesignError("points", UNSIZED, "sized", self.LARGE["points"])


Turned = LeadScrew | Conveyor | RackAndPinion | Belt | FeedRollers | RotaryTable | GearTrain
Mechanism = Annotated[Turned | PressCrank | CrankSlider | Rocker | Table, Field(discriminator="kind")]
MECHANISMS: dict[str, type[MechanismEntry]] = {
    get_args(model.model_fields["kind"].annotation)[0]: model for model in get_args(get_args(Mechanism)[0])
}
LINKED = tuple(kind for kind, model in MECHANISMS.items() if model.LARGE and not model.SLIDES)  # the ratio changes
BELTED = tuple(kind for kind, model in MECHANISMS.items() if issubclass(model, Belted))
SLIDING = tuple(kind for kind, model in MECHANISMS.items() if model.SLIDES)
SCREWS = ("lead screw",)  # whose losses are friction in a thread


def some_mechanism(kind: str) -> MechanismEntry:
    """Return a mechanism of a kind with any sizes."""
    model = MECHANISMS[kind]
    sizes = {model.SIZE: 1.0} if model.SIZE else model.LARGE
    return model.model_validate({"kind": kind, "efficiency": 1.0} | sizes)
