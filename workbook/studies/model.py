"""What a study is asked: a base description, what varies, results to keep, constraints, what is best."""

from fnmatch import fnmatchcase
from typing import Annotated, Any, Literal, Self

from pydantic import ConfigDict, Field, model_validator

from workbook.entries.texts import Text
from workbook.entries.types import EntryError, Model, Number

Name = Annotated[str, Field(min_length=1, max_length=200)]
MOST_KEYS = 20
OFF = "off"  # instead of a bound: a check of the book that is no constraint


class Vary(Model):
    """An entry that varies, or several that do together, over a list, a range, all laws or a catalogue.

    ``takes`` names a phase that gives the room that this one takes: its other edge, or its duration, moves along.
    """

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True, populate_by_name=True)

    key: Name | Annotated[list[Name], Field(min_length=1, max_length=MOST_KEYS)]
    values: Annotated[list[Any], Field(min_length=1)] | None = None
    low: Number | None = Field(default=None, alias="from")
    high: Number | None = Field(default=None, alias="to")
    steps: Annotated[int, Field(ge=2, le=1_000_000_000)] | None = None  # values of a range, both ends among them
    all: Literal["laws", "catalogue"] | None = None
    takes: Name | None = None

    @model_validator(mode="after")
    def _one_way(self) -> Self:
        ranged = self.low is not None or self.high is not None
        if [self.values is not None, ranged, self.all is not None].count(True) != 1:
            ways = 'values = [...], from = ... with to = ..., all = "laws" or "catalogue"'
            raise EntryError("", f"expected one of {ways}")
        if ranged and (self.low is None or self.high is None):
            raise EntryError("to" if self.high is None else "from", "empty; a range has both ends")
        if self.low is not None and self.high is not None and not self.low < self.high:
            said = f"the range from {self.low:g} to {self.high:g} is empty"
            raise EntryError("to", f"{said}; expected more than its begin")
        if self.steps is not None and not ranged:
            raise EntryError("steps", "only a range has steps; expected none")
        values = self.values or []
        twice = next((n for n, value in enumerate(values) if value in values[:n]), None)
        if twice is not None:
            raise EntryError(f"values.{twice + 1}", f"{values[twice]!r} stands there twice; expected each value once")
        return self

    @property
    def keys(self) -> list[str]:
        """The entries that vary together."""
        return [self.key] if isinstance(self.key, str) else self.key


class Bound(Model):
    """What a result must keep to."""

    min: Number | None = None
    max: Number | None = None

    @model_validator(mode="after")
    def _bounds(self) -> Self:
        if self.min is None and self.max is None:
            raise EntryError("min", "empty; a bound has a min or a max, or both")
        if self.min is not None and self.max is not None and self.min > self.max:
            raise EntryError("max", f"{self.max:g} is less than min, {self.min:g}: no design keeps to that")
        return self

    @property
    def words(self) -> str:
        """It in words."""
        ends = [("at least", self.min), ("at most", self.max)]
        return ", ".join(f"{word} {end:g}" for word, end in ends if end is not None)


class Way(Model):
    """How designs are chosen: all of them, so many by Sobol's sequence, or by differential evolution."""

    kind: Literal["full", "sobol", "evolution"] = "full"
    designs: Annotated[int, Field(ge=1, le=2**30)] | None = None
    seed: Annotated[int, Field(ge=0, le=2**31)] = 1

    @model_validator(mode="after")
    def _counted(self) -> Self:
        if self.kind == "full" and self.designs is not None:
            raise EntryError("designs", "a study in full has all designs; expected none")
        if self.kind != "full" and self.designs is None:
            raise EntryError("designs", f"empty; expected how many designs {self.kind} may try")
        return self


class Study(Model):
    """A study."""

    title: Text
    base: Name | None = None
    vary: Annotated[list[Vary], Field(min_length=1)]
    results: list[Name] = []  # noqa: RUF012 - frozen
    constraints: dict[str, Bound | Name] = {}  # noqa: RUF012
    minimise: list[Name] = []  # noqa: RUF012
    maximise: list[Name] = []  # noqa: RUF012
    way: Way = Way()

    @model_validator(mode="after")
    def _asks(self) -> Self:
        goals = [*self.minimise, *self.maximise]
        twice = next((name for name in goals if goals.count(name) > 1), None)
        if twice is not None:
            raise EntryError("maximise", f"{twice!r} is asked for twice")
        if not self.names:
            raise EntryError("results", "empty; expected the name of a result, or an objective")
        if self.way.kind == "evolution" and len(goals) != 1:
            raise EntryError("minimise", f"{len(goals)} objectives; evolution expects one")
        if self.way.kind == "evolution" and any(one.low is None for one in self.vary):
            raise EntryError("vary", "evolution expects ranges alone; lists go by full or sobol")
        if self.way.kind == "full" and any(one.low is not None and one.steps is None for one in self.vary):
            raise EntryError("vary", "a study in full expects steps of each range; or way.kind sobol or evolution")
        return self

    @property
    def names(self) -> list[str]:
        """The results to keep: those asked for, objectives and what is constrained."""
        return list(dict.fromkeys([*self.results, *self.minimise, *self.maximise, *self.bounds]))

    @property
    def bounds(self) -> dict[str, Bound | str]:
        """The constraints that are told, by the names of results."""
        return {name: bound for name, bound in self.constraints.items() if bound != OFF}

    @property
    def off(self) -> list[str]:
        """What is no constraint although the book checks it: names, or patterns such as ``drive2_*``."""
        return [name for name, bound in self.constraints.items() if bound == OFF]

    def is_off(self, name: str) -> bool:
        """Return whether a check of the book is no constraint."""
        return any(fnmatchcase(name, pattern) for pattern in self.off)

    @property
    def goals(self) -> dict[str, float]:
        """The objectives by name: 1 where less is better, −1 where more is."""
        return dict.fromkeys(self.minimise, 1.0) | dict.fromkeys(self.maximise, -1.0)
