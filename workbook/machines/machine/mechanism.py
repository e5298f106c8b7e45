"""The mechanisms of an axis' drive as an engineer enters them: a model for each kind, with its own sizes."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, get_args

from pydantic import Field

from workbook.fields.types import DesignError, MakesCells, Model, NotNegative, Number, Positive
from workbook.machines.machine.drive_entries import BackEfficiency, Efficiency

ON_BED = "more of the belt lies on the bed than the whole belt"
UNSIZED = "a size of the mechanism is empty"
LEAST_POINTS = 2


class MechanismEntry(Model):
    """The mechanism that makes the motor's turning the axis' motion."""

    # the entry that sets the ratio, of a kind with a constant ratio that is not 1
    SIZE: ClassVar[str] = ""
    UNITS: ClassVar[tuple[str, ...]] = ("mm",)  # of axes that it moves
    NEEDED: ClassVar[tuple[str, ...]] = ()  # sizes that may be empty in an unfinished design only
    # sizes, with which a changing ratio reaches wherever an axis goes
    LARGE: ClassVar[dict[str, Any]] = {}
    APART: ClassVar[str] = "the sizes of the mechanism do not go together"
    SLIDES: ClassVar[bool] = False  # whether its load travels while its axis turns

    kind: str
    efficiency: Efficiency
    back_efficiency: BackEfficiency | None = None
    method: Literal["physical", "document"] = "physical"

    @property
    def size(self) -> float:
        """The size that sets a constant ratio, in mm; 1 of a kind that has none."""
        return getattr(self, self.SIZE) if self.SIZE else 1.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield the sizes that are missing of a mechanism whose ratio changes."""
        missing = (name for name in self.NEEDED if getattr(self, name) is None)
        yield from (DesignError(name, UNSIZED, 1.0) for name in missing)


class Belted(MechanismEntry):
    """A mechanism of which a belt moves with the load."""

    belt_mass: NotNegative | None = None
    belt_on_bed: Annotated[NotNegative, MakesCells(0.0)] | None = None

    def design_faults(self) -> Iterator[DesignError]:
        """Yield more of the belt on the bed than there is of it."""
        yield from super().design_faults()
        if (self.belt_on_bed or 0.0) > (self.belt_mass or 0.0):
            yield DesignError("belt_on_bed", ON_BED, self.belt_mass or 0.0)


class LeadScrew(MechanismEntry):
    """A screw and its nut: the axis travels the lead a revolution."""

    SIZE: ClassVar[str] = "lead"
    kind: Literal["lead screw"]
    lead: Positive


class Conveyor(Belted):
    """A belt over rollers that carries the load."""

    SIZE: ClassVar[str] = "roller_diameter"
    kind: Literal["conveyor"]
    roller_diameter: Positive


class RackAndPinion(MechanismEntry):
    """A pinion on a rack."""

    SIZE: ClassVar[str] = "pinion_diameter"
    kind: Literal["rack and pinion"]
    pinion_diameter: Positive


class Belt(Belted):
    """A belt over pulleys that pulls the load."""

    SIZE: ClassVar[str] = "pulley_diameter"
    kind: Literal["belt"]
    pulley_diameter: Positive


class FeedRollers(MechanismEntry):
    """Rollers that feed a web or film."""

    SIZE: ClassVar[str] = "roller_radius"
    kind: Literal["feed rollers"]
    roller_radius: Positive


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
    crank_radius: Positive
    rod_length: Positive
    offset: Number | None = None
    start_angle: Number | None = None


class CrankSlider(MechanismEntry):
    """A crank that moves a slide by a connecting rod; the motion is that of the slide."""

    NEEDED: ClassVar[tuple[str, ...]] = ("crank_radius", "rod_length")
    LARGE: ClassVar[dict[str, Any]] = {"crank_radius": 1e4, "rod_length": 5e4, "start": 1e4}
    APART: ClassVar[str] = PressCrank.APART
    kind: Literal["crank-slider"]
    crank_radius: Positive | None = None
    rod_length: Positive | None = None
    offset: Number | None = None
    zero: Literal["inner", "outer"] | None = None
    branch: Literal["ahead", "behind"] | None = None
    start: NotNegative | None = None


class Rocker(MechanismEntry):
    """A lever that moves a slide by a link; the motion is that of the slide."""

    NEEDED: ClassVar[tuple[str, ...]] = ("lever_length", "link_length", "start_angle")
    LARGE: ClassVar[dict[str, Any]] = {"lever_length": 1e5, "link_length": 5e5, "offset": 1e5, "start_angle": 90.0}
    APART: ClassVar[str] = (
        "where the motion begins, the link does not reach from the lever to the slide, or is in line with it"
    )
    kind: Literal["rocker"]
    lever_length: Positive | None = None
    link_length: Positive | None = None
    offset: Number | None = None
    start_angle: Number | None = None
    slide: Literal["ahead", "behind"] | None = None
    direction: Literal["forward", "backward"] | None = None


class TablePoint(Model):
    """A point of a table: an angle of the shaft in °, and the position of the load there, in mm or °."""

    angle: Number
    position: Number


class Table(MechanismEntry):
    """Any mechanism whose position is known over the angle of its shaft, point by point."""

    UNITS: ClassVar[tuple[str, ...]] = ("mm", "°")
    LARGE: ClassVar[dict[str, Any]] = {"points": [{"angle": end, "position": end} for end in (-1e4, 1e4)]}
    kind: Literal["table"]
    points: list[TablePoint] = []  # noqa: RUF012 - frozen

    def design_faults(self) -> Iterator[DesignError]:
        """Yield points of which there are too few."""
        if len(self.points) < LEAST_POINTS:
            yield DesignError("points", UNSIZED, self.LARGE["points"])


Turned = LeadScrew | Conveyor | RackAndPinion | Belt | FeedRollers | RotaryTable | GearTrain
Mechanism = Annotated[Turned | PressCrank | CrankSlider | Rocker | Table, Field(discriminator="kind")]
MECHANISMS: dict[str, type[MechanismEntry]] = {
    get_args(model.model_fields["kind"].annotation)[0]: model for model in get_args(get_args(Mechanism)[0])
}
# the ratio changes
LINKED = tuple(kind for kind, model in MECHANISMS.items() if model.LARGE and not model.SLIDES)
BELTED = tuple(kind for kind, model in MECHANISMS.items() if issubclass(model, Belted))
SLIDING = tuple(kind for kind, model in MECHANISMS.items() if model.SLIDES)
SCREWS = ("lead screw",)  # whose losses are friction in a thread
