"""Two axes that must stay apart, as an engineer enters them."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

from pydantic import Field

from workbook.entries.texts import LOOKED_UP, NO_FORMULA, place_of
from workbook.entries.types import EntryError, Model, Number

MOST_CLEARANCES = 12
ENDS = ("first", "second")
Named = Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]


class ClearanceEntry(Model):
    """A gap of two axes, offset + factor · position + factor · position, in the unit of the first axis."""

    name: Named
    first: Named = Field(description="Name of an axis")
    first_factor: Number = Field(default=1.0, description="By what its position is multiplied")
    second: Named = Field(description="Name of another axis")
    second_factor: Number = Field(default=-1.0, description="By what its position is multiplied, into the first's unit")
    offset: Number = Field(default=0.0, description="The gap where both are at 0, in the unit of the first axis")
    least: Number = Field(default=0.0, description="The gap that must be left, in the unit of the first axis")


def spelled_out(clearances: Any, axes: Any) -> Any:
    """Return clearances with the names of axes that are told by their numbers, from 1, as a book's layout does."""
    if not isinstance(clearances, list) or not isinstance(axes, list):
        return clearances
    names = {i: axis.get("name") for i, axis in enumerate(axes, 1) if isinstance(axis, Mapping)}
    return [{**one, **{end: names[one[end]] for end in ENDS if type(one.get(end)) is int and one[end] in names}}
            if isinstance(one, Mapping) else one for one in clearances]  # fmt: skip


def require_axes(clearances: Sequence[ClearanceEntry], names: Sequence[str]) -> None:
    """Raise EntryError for a clearance of an axis that is not there, or of one axis alone."""
    for i, one in enumerate(clearances):
        places = [place_of(getattr(one, end), names) for end in ENDS]
        for end, place in zip(ENDS, places, strict=True):
            if place < 0:
                raise EntryError(f"clearances.{i}.{end}", f"no axis is named {getattr(one, end)!r}")
        if places[0] == places[1]:
            raise EntryError(f"clearances.{i}.second", f"{one.second!r} is the first axis too; expected another")
