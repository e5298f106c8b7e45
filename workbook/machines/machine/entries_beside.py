"""Entries of a machine beside its axes: switches, clearances between axes, and the hard stops of an axis."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Annotated, Any, ClassVar

from pydantic import Field, GetJsonSchemaHandler, field_validator
from pydantic.json_schema import JsonSchemaValue

from workbook.book.limits import RowRule
from workbook.book.sentence import figure
from workbook.entries.abscissa import ANGLE, Abscissa
from workbook.entries.phase import TURN
from workbook.fields.paths import spread
from workbook.fields.texts import LOOKED_UP, NO_FORMULA, place_of
from workbook.fields.types import ANGLE_TOLERANCE, Angle, DesignError, EntryError, Model, Number

Name = Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]
TIMES, MOST_SWITCHES, MOST_CLEARANCES = 6, 24, 12  # of being on, that a switch has room for
PAIRS = 12  # of a clearance's table
KEYS, ENDS, PAIR, STOPS = ("start", "stop"), ("first", "second"), ("at", "free"), ("low", "high")
PAIRED = ",".join(f"COUNT([start{t}],[stop{t}])<>1" for t in range(1, TIMES + 1))
HALF = RowRule("paired", f"AND({PAIRED})", "", "a time on without its begin, or without its end")
"""a row of switches of which a time has but one of its ends"""
UNUSED = dict.fromkeys(KEYS)


TWO_NUMBERS = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}


def without_empty_end(rows: Any) -> Any:
    """Return rows without the last ones that are empty, as empty cells are read."""
    while isinstance(rows, list) and rows and rows[-1] == {}:
        rows = rows[:-1]
    return rows


class TimeOn(Model):
    """One time of being on, in degrees of the master shaft; one that ends before it begins runs across the end."""

    start: Angle | None = Field(default=None, description="From where it is on")
    stop: Angle | None = Field(default=None, description="To where it is on")

    @classmethod
    def __get_pydantic_json_schema__(cls, core: Any, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Take [from, to] too, as editors see it."""
        return {"anyOf": [TWO_NUMBERS, handler(core)]}

    @property
    def ends(self) -> tuple[float, float] | None:
        """Both ends, if they are entered."""
        return None if self.start is None or self.stop is None else (self.start, self.stop)


class SwitchEntry(Model):
    """A lane that is on or off over the cycle: a cylinder, a valve, a sensor, a cam switch."""

    PLACED: ClassVar[bool] = True
    """whether its entries alone tell if its times lie right: else the machine does, which knows the cycle's length"""
    name: Name
    on: Annotated[list[TimeOn], Field(max_length=TIMES)] = Field(
        default=[],
        description="When it is on: [from, to] each, or { start, stop }; past the end of the cycle where to is less",
    )

    @field_validator("on", mode="before")
    @classmethod
    def _used(cls, on: Any) -> Any:
        return without_empty_end(on)

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a time with one end, and the first that does not last or is not over where another begins."""
        half = (k for k, time in enumerate(self.on) if time.ends is None and time != type(time)())
        yield from (DesignError(f"on.{k}", HALF.words, HALF.rule, UNUSED) for k in [*half][:1])
        yield from meeting(self) if self.PLACED else ()


def meeting(turned: SwitchEntry, over: Abscissa = ANGLE) -> Iterator[DesignError]:
    """Yield the first time of a switch, in degrees, that does not last, or is not over where another begins."""
    told = [(k, *time.ends) for k, time in enumerate(turned.on, 1) if time.ends]
    spans = {k: stop - start + (TURN if stop < start else 0.0) for k, start, stop in told}
    said = [f"time {k} does not last" for k, span in spans.items() if span <= ANGLE_TOLERANCE]
    for k, start, _ in told:
        more = spans[k] - min(((other - start) % TURN for j, other, _ in told if j != k), default=spans[k])
        if more > ANGLE_TOLERANCE:
            said.append(f"time {k} is on {over.text(more)} beyond the begin of another")
    if said:
        yield DesignError("on", f"{turned.name} {said[0]}", "apart", [UNUSED for _ in turned.on])


class HardStops(Model):
    """The hard stops of an axis, in its unit: [low, high], or { low } or { high } alone; it stays between them."""

    low: Number | None = Field(default=None, description="Position of its lower stop", examples=[-5.0])
    high: Number | None = Field(default=None, description="Position of its upper stop", examples=[325.0])

    @classmethod
    def __get_pydantic_json_schema__(cls, core: Any, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Take [low, high] too, as editors see it."""
        return {"anyOf": [TWO_NUMBERS, handler(core)]}


class FreePosition(Model):
    """How far the second axis of a clearance is free where the first one is at a position, each in its axis' unit."""

    at: Number = Field(description="Position of the first axis, in its unit", examples=[20.0])
    free: Number = Field(description="Position up to which the second axis is free, in its unit", examples=[45.0])

    @classmethod
    def __get_pydantic_json_schema__(cls, core: Any, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Take [at, free] too, as editors see it."""
        return {"anyOf": [TWO_NUMBERS, handler(core)]}


class ClearanceEntry(Model):
    """A gap of two axes, offset + factor · position + factor · position, in the unit of the first axis.

    With a table of pairs the free position of the second axis takes the place of the first one's position, all in the
    second one's unit: by default the gap is what the second axis is short of its free position.
    """

    name: Name
    first: Name = Field(description="Name of an axis")
    first_factor: Number = Field(default=1.0, description="By what its position is multiplied")
    second: Name = Field(description="Name of another axis")
    second_factor: Number = Field(default=-1.0, description="By what its position is multiplied, into the first's unit")
    offset: Number = Field(default=0.0, description="The gap where both are at 0, in the unit of the first axis")
    least: Number = Field(default=0.0, description="The gap that must be left, in the unit of the first axis")
    pairs: Annotated[list[FreePosition], Field(max_length=PAIRS)] = Field(
        default=[],
        examples=[[[0.0, 45.0], [20.0, 30.0]]],
        description="[position of the first axis, free position of the second] each, rising; lines between",
    )

    @field_validator("pairs", mode="before")
    @classmethod
    def _used(cls, pairs: Any) -> Any:
        return without_empty_end(pairs)

    @field_validator("pairs")
    @classmethod
    def _rises(cls, pairs: list[FreePosition]) -> list[FreePosition]:
        if len(pairs) == 1:
            raise EntryError("", "one pair; expected two or more, or none")
        for k, (before, pair) in enumerate(pairwise(pairs), 1):
            if not before.at < pair.at:
                raise EntryError(
                    f"{k}.at", f"{figure(pair.at)} after {figure(before.at)}; expected positions that rise"
                )
        return pairs


def require_axes(clearances: Sequence[ClearanceEntry], names: Sequence[str]) -> None:
    """Raise EntryError for a clearance of an axis that is not there, or of one axis alone."""
    for i, one in enumerate(clearances):
        places = [place_of(getattr(one, end), names) for end in ENDS]
        for end, place in zip(ENDS, places, strict=True):
            if place < 0:
                raise EntryError(f"clearances.{i}.{end}", f"no axis is named {getattr(one, end)!r}")
        if places[0] == places[1]:
            raise EntryError(f"clearances.{i}.second", f"{one.second!r} is the first axis too; expected another")


def spelled(told: Any) -> Any:
    """Return a description whose switches tell the keys of their times, and whose clearances the names of axes.

    Times may be told as [from, to], hard stops as [low, high], and axes by their numbers, from 1, as a book's layout
    does.
    """
    if not isinstance(told, Mapping):
        return told
    names = {int(path[1]) + 1: name for path, name in spread(told, ("axes", "*", "name"))}

    def keyed(pair: Any, keys: Sequence[str] = KEYS) -> Any:
        return dict(zip(keys, pair, strict=True)) if isinstance(pair, list) and len(pair) == len(keys) else pair

    def switch(one: Mapping[str, Any]) -> Any:
        return {**one, "on": [*map(keyed, one["on"])]} if isinstance(one.get("on"), list) else one

    def clearance(one: Mapping[str, Any]) -> Any:
        pairs = one.get("pairs")
        told = {"pairs": [keyed(pair, PAIR) for pair in pairs]} if isinstance(pairs, list) else {}
        ends = {end: names[one[end]] for end in ENDS if type(one.get(end)) is int and one[end] in names}
        return {**one, **ends, **told}

    def stopped(one: Mapping[str, Any]) -> Any:
        return {**one, "stops": keyed(one["stops"], STOPS)} if "stops" in one else one

    found = dict(told)
    for key, spell in (("axes", stopped), ("switches", switch), ("clearances", clearance)):
        if isinstance(told.get(key), list):
            found[key] = [spell(one) if isinstance(one, Mapping) else one for one in told[key]]
    return found
