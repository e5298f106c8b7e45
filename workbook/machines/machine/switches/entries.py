"""Switches that are on or off over the cycle, as an engineer enters them."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import Field, GetJsonSchemaHandler, field_validator
from pydantic.json_schema import JsonSchemaValue

from workbook.book.limits import RowRule
from workbook.entries.abscissa import ANGLE, Abscissa
from workbook.entries.phase import TURN
from workbook.entries.texts import LOOKED_UP, NO_FORMULA
from workbook.entries.types import ANGLE_TOLERANCE, Angle, DesignError, Model

TIMES = 6
"""of being on, that a switch has room for"""
MOST_SWITCHES = 24
KEYS = ("start", "stop")
PAIRED = "COUNT([start{0}],[stop{0}])<>1"
HALF = RowRule(
    "paired", f"AND({','.join(map(PAIRED.format, range(1, TIMES + 1)))})", "",
    "a time on without its begin, or without its end",
)  # fmt: skip
"""a row of switches of which a time has but one of its ends"""
UNUSED = dict.fromkeys(KEYS)


class TimeOn(Model):
    """One time of being on, in degrees of the master shaft; one that ends before it begins runs across the end."""

    start: Angle | None = Field(default=None, description="From where it is on")
    stop: Angle | None = Field(default=None, description="To where it is on")

    @classmethod
    def __get_pydantic_json_schema__(cls, core: Any, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Take [from, to] too, as editors see it."""
        pair = {"type": "array", "items": {"type": "number"}, "minItems": len(KEYS), "maxItems": len(KEYS)}
        return {"anyOf": [pair, handler(core)]}

    @property
    def told(self) -> bool:
        """Whether both ends are entered."""
        return self.start is not None and self.stop is not None

    @property
    def span(self) -> float:
        """How long it is on (degrees)."""
        if self.start is None or self.stop is None:
            return 0.0
        return self.stop - self.start + (TURN if self.stop < self.start else 0.0)


class SwitchEntry(Model):
    """A lane that is on or off over the cycle: a cylinder, a valve, a sensor, a cam switch."""

    name: Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]
    on: Annotated[list[TimeOn], Field(max_length=TIMES)] = Field(
        description="When it is on: [from, to] each, or { start, stop }; past the end of the cycle where to is less"
    )

    @field_validator("on", mode="before")
    @classmethod
    def _used(cls, on: Any) -> Any:
        rows = list(on) if isinstance(on, list) else on
        while isinstance(rows, list) and rows and rows[-1] == {}:  # as empty cells are read
            rows.pop()
        return rows

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a time with one end, and the first that does not last or is not over where another begins."""
        for k, time in enumerate(self.on):
            if not time.told and time != type(time)():
                yield DesignError(f"on.{k}", HALF.words, HALF.rule, UNUSED)
                break
        yield from self.apart()

    def apart(self) -> Iterator[DesignError]:
        """Yield the first time that does not last, or is not over where another begins."""
        yield from meeting(self)


def meeting(turned: SwitchEntry, over: Abscissa = ANGLE) -> Iterator[DesignError]:
    """Yield the first time of a switch, in degrees, that does not last, or is not over where another begins."""
    told = [(k, time) for k, time in enumerate(turned.on, 1) if time.told]
    said = [f"time {k} does not last" for k, time in told if time.span <= ANGLE_TOLERANCE]
    for k, time in told:
        after = [((other.start or 0.0) - (time.start or 0.0)) % TURN for j, other in told if j != k]
        more = time.span - min(after, default=time.span)
        if more > ANGLE_TOLERANCE:
            said.append(f"time {k} is on {over.said(more)} beyond the begin of another")
    if said:
        yield DesignError("on", f"{turned.name} {said[0]}", "apart", [UNUSED for _ in turned.on])


def spelled(switches: Any) -> Any:
    """Return the switches of a description with the keys of times that are told as [from, to]."""
    if not isinstance(switches, list):
        return switches

    def keyed(time: Any) -> Any:
        return dict(zip(KEYS, time, strict=True)) if isinstance(time, list) and len(time) == len(KEYS) else time

    return [{**one, "on": [*map(keyed, one["on"])]} if isinstance(one, Mapping) and isinstance(one.get("on"), list)
            else one for one in switches]  # fmt: skip
