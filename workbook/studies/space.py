"""A study's questions, its dimensions and its designs: numbered from 0, those that only scale the fastest."""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from functools import cached_property
from typing import Annotated, Any, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import ConfigDict, Field, model_validator

from workbook.fields.paths import Place, join
from workbook.fields.texts import Text
from workbook.fields.types import EntryError, Model, Number
from workbook.template_outputs import Column

Name = Annotated[str, Field(min_length=1, max_length=200)]
MOST_KEYS = 20
OFF = "off"  # instead of a bound: a check of the book that is no constraint
Shares = NDArray[np.float64]


class Vary(Model):
    """An entry that varies, or several that do together, over a list, a range, all laws or a catalogue.

    ``takes`` names a phase that gives the room that this phase takes: its other edge, or its duration, moves along.
    """

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True, populate_by_name=True)

    key: Name | Annotated[list[Name], Field(min_length=1, max_length=MOST_KEYS)]
    values: Annotated[list[Any], Field(min_length=1)] | None = None
    low: Number | None = Field(default=None, alias="from")
    high: Number | None = Field(default=None, alias="to")
    # values of a range, both ends among them
    steps: Annotated[int, Field(ge=2, le=1_000_000_000)] | None = None
    all: Literal["laws", "catalogue"] | None = None
    takes: Name | None = None

    @model_validator(mode="after")
    def _one_way(self) -> Self:
        ends = (self.low, self.high).count(None)
        if [self.values is not None, ends < 2, self.all is not None].count(True) != 1:
            ways = 'values = [...], from = ... with to = ..., all = "laws" or "catalogue"'
            raise EntryError("", f"expected one of {ways}")
        if ends == 1:
            raise EntryError("to" if self.high is None else "from", "empty; a range has both ends")
        if self.low is not None and self.high is not None and not self.low < self.high:
            problem = f"the range from {self.low:g} to {self.high:g} is empty"
            raise EntryError("to", f"{problem}; expected more than its begin")
        if self.steps is not None and ends == 2:
            raise EntryError("steps", "only a range has steps; expected none")
        for n, value in enumerate(values := self.values or []):
            if value in values[:n]:
                raise EntryError(f"values.{n + 1}", f"{value!r} stands there twice; expected each value once")
        return self

    @property
    def keys(self) -> list[str]:
        """The entries that vary together."""
        return [self.key] if isinstance(self.key, str) else self.key


class Bound(Model):
    """The bounds that a result must keep to."""

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
        """The bounds in words."""
        ends = [("at least", self.min), ("at most", self.max)]
        return ", ".join(f"{word} {end:g}" for word, end in ends if end is not None)


class Sampling(Model):
    """The way of choosing designs: all of them, so many by Sobol's sequence, or by differential evolution."""

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
    """A study; ``links`` has by the path of an entry that of the entry it follows, and its distance beyond that."""

    title: Text
    base: Name | None = None
    vary: Annotated[list[Vary], Field(min_length=1)]
    results: list[Name] = []  # noqa: RUF012 - frozen
    constraints: dict[str, Bound | Name] = {}  # noqa: RUF012
    minimise: list[Name] = []  # noqa: RUF012
    maximise: list[Name] = []  # noqa: RUF012
    links: dict[Name, Name] = {}  # noqa: RUF012
    way: Sampling = Sampling()

    @model_validator(mode="after")
    def _asks(self) -> Self:
        goals = [*self.minimise, *self.maximise]
        for twice in (name for name in goals if goals.count(name) > 1):
            raise EntryError("maximise", f"{twice!r} is asked for twice")
        if not self.names:
            raise EntryError("results", "empty; expected the name of a result, or an objective")
        if self.way.kind == "evolution" and len(goals) != 1:
            raise EntryError("minimise", f"{len(goals)} objectives; evolution expects one")
        if self.way.kind == "evolution" and any(vary.low is None for vary in self.vary):
            raise EntryError("vary", "evolution expects ranges alone; lists go by full or sobol")
        if self.way.kind == "full" and any(vary.low is not None and vary.steps is None for vary in self.vary):
            raise EntryError("vary", "a study in full expects steps of each range; or way.kind sobol or evolution")
        return self

    @property
    def names(self) -> list[str]:
        """The results to keep: those asked for, objectives and what is constrained."""
        return list(dict.fromkeys([*self.results, *self.minimise, *self.maximise, *self.bounds]))

    @property
    def bounds(self) -> dict[str, Bound | str]:
        """The bounds of the constraints, by the names of results."""
        return {name: bound for name, bound in self.constraints.items() if bound != OFF}

    @property
    def off(self) -> list[str]:
        """The book's checks that the study leaves out: names, or patterns such as ``drive2_*``."""
        return [name for name, bound in self.constraints.items() if bound == OFF]

    def is_off(self, name: str) -> bool:
        """Return whether a check of the book is no constraint."""
        return any(fnmatchcase(name, pattern) for pattern in self.off)

    @property
    def goals(self) -> dict[str, float]:
        """The objectives by name: 1 where less is better, −1 where more is."""
        return dict.fromkeys(self.minimise, 1.0) | dict.fromkeys(self.maximise, -1.0)


@dataclass(frozen=True)
class Dimension:
    """One thing that varies: the entries at ``paths`` together, over values or a range.

    ``takes`` is the way to the phase that gives it room, ``part`` what only scales with it, empty where more changes.
    """

    label: str
    paths: tuple[Place, ...]
    values: tuple[Any, ...] = ()
    low: float = 0.0
    high: float = 0.0
    steps: int = 0
    takes: Place = ()
    part: str = ""

    @property
    def size(self) -> int:
        """Return the number of values; 0 for a range without steps."""
        return len(self.values) or self.steps

    @property
    def key(self) -> str:
        """The key of its first entry."""
        return join(self.paths[0])

    def at(self, indices: NDArray[np.intp]) -> Column:
        """Return its values at places among them."""
        some, index = np.unique(indices, return_inverse=True)
        if self.values:
            return Column([self.values[k] for k in some.tolist()], index.astype(np.intp))
        inner = self.low + (self.high - self.low) * some / (self.steps - 1)
        return Column(np.where(some == self.steps - 1, self.high, inner).tolist(), index.astype(np.intp))

    def shared(self, shares: Shares) -> Column:
        """Return its values at shares of it, from 0 to 1."""
        if self.size:
            return self.at(np.minimum((shares * self.size).astype(np.intp), self.size - 1))
        return Column((self.low + (self.high - self.low) * shares).tolist(), np.arange(len(shares)))


@dataclass(frozen=True)
class Space:
    """All that varies: what changes more than scales first."""

    dimensions: tuple[Dimension, ...]
    way: Sampling

    @property
    def size(self) -> int:
        """Return the number of designs; of an evolution the most that it may try."""
        if self.way.kind == "full":
            return math.prod(dimension.size for dimension in self.dimensions)
        return self.way.designs or 0

    @cached_property
    def inner(self) -> int:
        """Return the number of designs in a row that differ only in what scales."""
        if self.way.kind != "full":
            return self.size if all(dimension.part for dimension in self.dimensions) else 1
        return math.prod(dimension.size for dimension in self.dimensions if dimension.part)

    def columns(self, begin: int, end: int) -> list[Column]:
        """Return the entries of designs by their numbers, by dimension."""
        if self.way.kind == "full":
            sizes = [dimension.size for dimension in self.dimensions]
            places = np.unravel_index(np.arange(begin, end), sizes)
            return [dimension.at(place) for dimension, place in zip(self.dimensions, places, strict=True)]
        return self.shared(self.sobol(begin, end))

    def shared(self, shares: Shares) -> list[Column]:
        """Return the entries of designs at shares of each dimension, a row a design."""
        return [dimension.shared(shares[:, k]) for k, dimension in enumerate(self.dimensions)]

    def sobol(self, begin: int, end: int) -> Shares:
        """Return points of Sobol's sequence, scrambled by the seed, the same however they are parted.

        Source: A. B. Owen, Scrambled Sobol' and Niederreiter–Xing points, J. Complexity 14 (1998), in scipy.stats.qmc.
        """
        from scipy.stats import qmc

        drawn = qmc.Sobol(len(self.dimensions), scramble=True, seed=self.way.seed)
        if begin:
            drawn.fast_forward(begin)
        # a part need not be a power of two: whether all designs are, is for the study
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)
            return np.asarray(drawn.random(end - begin))


def arrange(dimensions: Sequence[Dimension], way: Sampling) -> Space:
    """Return the space of dimensions: of each part that scales the first dimension scales, the others do not."""
    seen: set[str] = set()
    outer, inner = [], []
    for dimension in dimensions:
        if dimension.part and dimension.part not in seen and len(dimension.paths) == 1 and not dimension.takes:
            seen.add(dimension.part)
            inner.append(dimension)
        else:
            outer.append(replace(dimension, part=""))
    return Space((*outer, *inner), way)
