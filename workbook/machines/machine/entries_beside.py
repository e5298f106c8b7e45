"""Entries of a machine beside its axes: its cycle, switches, clearances, hard stops, the room of its timing."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import (
    BeforeValidator,
    Field,
    GetJsonSchemaHandler,
    PrivateAttr,
    ValidatorFunctionWrapHandler,
    field_validator,
)
from pydantic.json_schema import JsonSchemaValue

from workbook.book.limits import RowRule
from workbook.book.sentence import figure
from workbook.entries.abscissa import ANGLE, Abscissa, Unit, length_abscissa
from workbook.entries.phase import TURN
from workbook.fields.paths import Place, replaced, spread
from workbook.fields.texts import LOOKED_UP, NO_FORMULA, place_of
from workbook.fields.types import CountsAs, DesignError, EntryError, MakesCells, Model, NotNegative, Number, Positive
from workbook.fields.units import PER_MINUTE, shown

Name = Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]
TIMES, MOST_SWITCHES, MOST_CLEARANCES = 6, 24, 12  # of being on, that a switch has room for
PAIRS = 12  # of a clearance's table
KEYS, ENDS, PAIR, STOPS = ("start", "stop"), ("first", "second"), ("at", "free"), ("low", "high")
PAIRED = ",".join(f"COUNT([start{t}],[stop{t}])<>1" for t in range(1, TIMES + 1))
HALF = RowRule("paired", f"AND({PAIRED})", "", "a time on without its begin, or without its end")
"""a row of switches of which a time lacks an end"""
LISTED = {("axes", "*", "stops"): STOPS, ("switches", "*", "on", "*"): KEYS, ("clearances", "*", "pairs", "*"): PAIR}
"""entries that may be given as a list, with the keys of its numbers"""
NAMED: list[Place] = [("clearances", "*", end) for end in ENDS]
NAMED += [("timing", table, "*", "axis") for table in ("edges", "orders", "lasting")] + [
    ("timing", "orders", "*", "other")
]
"""entries that name an axis, and of a book's layout tell its number"""
UNUSED = dict.fromkeys(KEYS)


TWO_NUMBERS = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}


def without_empty_end(rows: Any) -> Any:
    """Return rows without the last ones that are empty, as empty cells are read."""
    while isinstance(rows, list) and rows and rows[-1] == {}:
        rows = rows[:-1]
    return rows


Trimmed = BeforeValidator(without_empty_end)


class TwoNumbers(Model):
    """Two numbers by their keys; a description may list them."""

    @classmethod
    def __get_pydantic_json_schema__(cls, core: Any, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Take [first, second] too, as editors see it."""
        return {"anyOf": [TWO_NUMBERS, handler(core)]}


class TimeOn(TwoNumbers):
    """A time of being on, across the cycle's end where it ends before it begins."""

    start: NotNegative | None = None
    stop: NotNegative | None = None

    @property
    def ends(self) -> tuple[float, float] | None:
        """Both ends, if they are entered."""
        return None if self.start is None or self.stop is None else (self.start, self.stop)


class SwitchEntry(Model):
    """A lane that is on or off over the cycle: a cylinder, a valve, a sensor, a cam switch."""

    name: Name
    on: Annotated[list[TimeOn], Field(max_length=TIMES), Trimmed] = []  # noqa: RUF012 - frozen
    dead_time: NotNegative = 0.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield the first time that lacks an end."""
        half = (k for k, time in enumerate(self.on) if time.ends is None and time != type(time)())
        yield from (DesignError(f"on.{k}", HALF.words, UNUSED) for k in [*half][:1])


class HardStops(TwoNumbers):
    """The hard stops of an axis, in its unit: [low, high], or { low } or { high } alone; it stays between them."""

    low: Number | None = None
    high: Number | None = None


UNTUNED = "neither a natural frequency, nor both stiffness and inertia"


class Vibration(Model):
    """A load that swings behind its axis: its natural frequency, or stiffness and inertia; what may be left of it."""

    frequency: Positive | None = None
    stiffness: Positive | None = None
    inertia: Positive | None = None
    damping: Annotated[float, Field(ge=0, le=0.99)] = 0.0
    settled: Positive | None = None

    def design_faults(self) -> Iterator[DesignError]:
        """Yield an oscillator that lacks its frequency, or one of stiffness and inertia."""
        if self.frequency is None and None in (self.stiffness, self.inertia):
            yield DesignError("", UNTUNED, self.model_dump() | {"frequency": 10.0})

    def natural(self, unit: str) -> float:
        """Return the natural frequency without damping (Hz) of a load of an axis in mm or °; 0 where none follows."""
        if self.frequency is not None or self.stiffness is None or self.inertia is None:
            return self.frequency or 0.0
        stiff, heavy = (1e3, 1.0) if unit == "mm" else (1.0, 1e-4)  # to N/m and kg, or Nm/rad and kg m²
        return math.sqrt(self.stiffness * stiff / (self.inertia * heavy)) / math.tau


class FreePosition(TwoNumbers):
    """The free position of the second axis of a clearance at a position of the first, each in its axis' unit."""

    at: Number
    free: Number


class NamedPart(Model):
    """A part of a machine whose sheet, checks or public names keep the name that it had when its book was built."""

    name: Name
    _built: str | None = PrivateAttr(default=None)

    @property
    def called(self) -> str:
        """Return its name when its book was built, else its name."""
        return self._built or self.name

    def built_as(self, name: str | None) -> None:
        """Keep the name that it had when its book was built; None where that is not known."""
        self._built = name if name != self.name else None


class ClearanceEntry(NamedPart):
    """A gap of two axes, offset + factor · position + factor · position, in the unit of the first axis.

        With a table of pairs the free position of the second axis takes the place of the first position, all in the
    unit of the second: by default the gap is what the second axis is short of its free position.
    """

    first: Name
    first_factor: Number = 1.0
    second: Name
    second_factor: Number = -1.0
    offset: Number = 0.0
    least: Number = 0.0
    pairs: Annotated[list[FreePosition], MakesCells([[0.0, 0.0], [1.0, 0.0]]), Trimmed] = Field([], max_length=PAIRS)

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


class EdgeOfPhase(Model):
    """An edge of a phase: where it starts or stops."""

    axis: Name
    phase: Annotated[int, Field(ge=1)]
    edge: Literal["start", "stop"]


class MovableEdge(EdgeOfPhase):
    """An edge of a phase that may move, and the edge of the next phase that it meets with it."""

    earliest: NotNegative
    latest: NotNegative


class Order(EdgeOfPhase):
    """A position that another axis has passed when a phase starts or stops."""

    other: Name
    above: Number | None = None
    below: Number | None = None


class Lasting(Model):
    """A phase that lasts at least a time; without one its time in the cycle stays, its edges move together."""

    axis: Name
    phase: Annotated[int, Field(ge=1)]
    least: Positive | None = None


class Timing(Model):
    """Edges that `motionbook improve` may move in the cycle, and what must hold; no cell hangs on it."""

    edges: Annotated[list[MovableEdge], MakesCells()] = []  # noqa: RUF012 - frozen
    orders: Annotated[list[Order], MakesCells()] = []  # noqa: RUF012 - frozen
    lasting: Annotated[list[Lasting], MakesCells()] = []  # noqa: RUF012 - frozen


def require_axes(clearances: Sequence[ClearanceEntry], names: Sequence[str]) -> None:
    """Raise EntryError for a clearance of an axis that is not there, or of a single axis."""
    for i, clearance in enumerate(clearances):
        places = [place_of(getattr(clearance, end), names) for end in ENDS]
        for end, place in zip(ENDS, places, strict=True):
            if place < 0:
                raise EntryError(f"clearances.{i}.{end}", f"no axis is named {getattr(clearance, end)!r}")
        if places[0] == places[1]:
            raise EntryError(f"clearances.{i}.second", f"{clearance.second!r} is the first axis too; expected another")


def expand_short_forms(data: Any) -> Any:
    """Return a description whose switches have the keys of their times, clearances and timing the names of axes.

    Times may be given as [from, to], hard stops as [low, high], and axes by their numbers, from 1, as a book's layout
    does.
    """
    if not isinstance(data, Mapping):
        return data
    expanded: Any = dict(data)
    names = {int(path[1]) + 1: name for path, name in spread(data, ("axes", "*", "name"))}
    for pattern, keys in LISTED.items():
        for path, pair in spread(data, pattern):
            if isinstance(pair, list) and len(pair) == len(keys):
                expanded = replaced(expanded, path, dict(zip(keys, pair, strict=True)))
    for pattern in NAMED:
        for path, number in spread(data, pattern):
            if type(number) is int and number in names:
                expanded = replaced(expanded, path, names[number])
    return expanded


class CycleEntry(Model):
    """The cycle: a turn of a master shaft at a rate, or of a machine without one a length in s, °, rad or mm."""


class Master(CycleEntry):
    """The master shaft, a cycle a turn: all places are in degrees of it."""

    rate: Positive  # cycles/min
    compare_rate: Annotated[NotNegative, MakesCells(0.0)] | None = None

    @property
    def over(self) -> Abscissa:
        """Degrees of the master shaft."""
        return ANGLE

    @property
    def per_minute(self) -> float:
        """Cycles a minute."""
        return self.rate


class Cycle(CycleEntry):
    """A cycle without a master shaft: all places are in its unit.

    Over °, rad or mm nothing tells how time passes: rates are geometric, in lift by abscissa, and there are no drives.
    """

    cycle: Annotated[Positive, CountsAs(TURN), MakesCells(TURN)]
    unit: Unit = "s"

    @property
    def over(self) -> Abscissa:
        """Seconds, or another abscissa."""
        return length_abscissa(self.unit, self.cycle)

    @property
    def per_minute(self) -> float:
        """Cycles a minute; over an abscissa that tells no time, in 60 of its units."""
        return shown(shown(1.0, self.cycle), PER_MINUTE)


def by_rate_or_length(data: Any, handler: ValidatorFunctionWrapHandler) -> Master | Cycle:
    """Return the cycle of a description, by which of its keys is there; raise EntryError where both are."""
    keys = data.keys() if isinstance(data, dict) else ()
    if {"rate", "cycle"} <= set(keys):
        raise EntryError("rate", "entered beside cycle; expected one of them: a rate of a master shaft, or a cycle")
    entry: Master | Cycle = (Cycle if "cycle" in keys or isinstance(data, Cycle) else Master).model_validate(data)
    return entry
