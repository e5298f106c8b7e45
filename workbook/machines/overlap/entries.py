"""Overlap of a transfer and tools (S2): what an engineer enters."""

from collections.abc import Iterator
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from workbook.book.sentence import figure
from workbook.entries.machine import Exporting, Sizes
from workbook.entries.phase import TURN
from workbook.fields.texts import LOOKED_UP, NO_FORMULA, require_distinct
from workbook.fields.types import Angle, DesignError, MakesCells, Model, NotNegative, Positive
from workbook.laws.entries import RisingLaw
from workbook.motion.requirements import Smoothness, settle_room

MOST_TOOLS = 6
REST = 2  # pieces of a motion beside those of its laws: a tool's dwell and its rest
Name = Annotated[str, Field(min_length=1, max_length=80, pattern=NO_FORMULA), LOOKED_UP]
LEAST = 0.01  # degrees: no cam moves in less
PartAngle = Annotated[float, Field(ge=LEAST, lt=360, allow_inf_nan=False)]


class TransferEntry(Model):
    """The motion that brings the part."""

    name: Name
    law: RisingLaw
    stroke: Positive
    angle: PartAngle
    smoothness: Smoothness = "acceleration"


class PassageEntry(Model):
    """The room that a part leaves to the other."""

    remaining: Annotated[float, Field(ge=0, lt=50, allow_inf_nan=False)]
    clearance: NotNegative
    margin: NotNegative
    allowance: NotNegative
    split: Annotated[float, Field(gt=0, lt=1, allow_inf_nan=False)] = 0.5

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a margin that is more than the clearance."""
        if self.margin > self.clearance:
            problem = f"a margin of {figure(self.margin)} mm; expected at most {figure(self.clearance)} mm"
            yield DesignError("margin", problem, self.clearance)


class ToolEntry(Model):
    """A motion that enters when the part is there, and is out before the next transfer."""

    name: Name
    law_in: RisingLaw
    law_out: RisingLaw
    stroke: Positive
    dwell: Annotated[float, Field(ge=0, lt=360, allow_inf_nan=False)]
    smoothness: Smoothness = "acceleration"
    passage: PassageEntry
    angle_in: PartAngle | None = None
    angle_out: PartAngle | None = None


class OverlapEntry(Model):
    """The transfer, the tools that work at its stations, and the angle at which the picture shows them."""

    rate: Positive
    transfer: TransferEntry
    tools: Annotated[list[ToolEntry], Field(min_length=1, max_length=MOST_TOOLS), MakesCells()]
    view: Angle = 0.0

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        require_distinct((tool.name for tool in self.tools), "tool", "tools.{}.name")
        return self

    def design_faults(self) -> Iterator[DesignError]:
        """Yield tools to which transfer, dwell and allowance leave no angle: of both ways the shorter is asked."""
        for i, tool in enumerate(self.tools):
            split, allowance = tool.passage.split, tool.passage.allowance
            left = (TURN - self.transfer.angle - tool.dwell) * min(split, 1 - split) - allowance
            if left < LEAST:
                fits = tool.model_dump() | {"dwell": 0.0, "passage": tool.passage.model_dump() | {"allowance": 0.0}}
                problem = f"{figure(left)}° are left to a way; expected at least {figure(LEAST)}°"
                yield DesignError(f"tools.{i}", problem, fits)


class OverlapSizes(Sizes):
    """The sizes of the tables: also the intervals of the table of margins."""

    margins: Annotated[int, Field(ge=2, le=200)] = 20


class IndexingOverlap(Exporting):
    """A transfer and tools over a master shaft, in sequence and with overlap (S2)."""

    AXES = ("transfer",)
    AXES_AT = ("overlap", "tools")
    template: Literal["indexing-overlap"] = "indexing-overlap"
    overlap: OverlapEntry
    sizes: OverlapSizes = OverlapSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        settle_room(self, [REST], REST, at_once=2)
        return self
