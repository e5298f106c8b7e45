"""What varies in a study, and which designs there are: numbered from 0, what only scales the fastest."""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbook.scaling import Column
from workbook.studies.model import Way

Shares = NDArray[np.float64]


@dataclass(frozen=True)
class Dimension:
    """One thing that varies: the entries at ``paths`` together, over values or a range.

    ``takes`` is the way to the phase that gives it room, ``part`` what only scales with it, empty where more changes.
    """

    label: str
    paths: tuple[tuple[str, ...], ...]
    values: tuple[Any, ...] = ()
    low: float = 0.0
    high: float = 0.0
    steps: int = 0
    takes: tuple[str, ...] = ()
    part: str = ""

    @property
    def size(self) -> int:
        """How many values it has; 0 of a range without steps."""
        return len(self.values) or self.steps

    @property
    def key(self) -> str:
        """The key of its first entry."""
        return ".".join(self.paths[0])

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
    way: Way

    @property
    def size(self) -> int:
        """How many designs there are; of an evolution the most that it may try."""
        if self.way.kind == "full":
            return math.prod(one.size for one in self.dimensions)
        return self.way.designs or 0

    @cached_property
    def inner(self) -> int:
        """How many designs follow each other that differ only in what scales."""
        if self.way.kind != "full":
            return self.size if all(one.part for one in self.dimensions) else 1
        return math.prod(one.size for one in self.dimensions if one.part)

    def columns(self, begin: int, end: int) -> list[Column]:
        """Return the entries of designs by their numbers, by dimension."""
        if self.way.kind == "full":
            sizes = [one.size for one in self.dimensions]
            places = np.unravel_index(np.arange(begin, end), sizes)
            return [one.at(place) for one, place in zip(self.dimensions, places, strict=True)]
        return self.shared(self.sobol(begin, end))

    def shared(self, shares: Shares) -> list[Column]:
        """Return the entries of designs at shares of each dimension, a row a design."""
        return [one.shared(shares[:, k]) for k, one in enumerate(self.dimensions)]

    def sobol(self, begin: int, end: int) -> Shares:
        """Return points of Sobol's sequence, scrambled by the seed, the same however they are parted.

        Source: A. B. Owen, Scrambled Sobol' and Niederreiter–Xing points, J. Complexity 14 (1998), in scipy.stats.qmc.
        """
        from scipy.stats import qmc

        drawn = qmc.Sobol(len(self.dimensions), scramble=True, seed=self.way.seed)
        if begin:
            drawn.fast_forward(begin)
        with warnings.catch_warnings():  # a part need not be a power of two: whether all designs are, is for the study
            warnings.simplefilter("ignore", UserWarning)
            return np.asarray(drawn.random(end - begin))


def arranged(dimensions: Sequence[Dimension], way: Way) -> Space:
    """Return the space of dimensions: of each part that scales the first dimension scales, the others do not."""
    seen: set[str] = set()
    outer, inner = [], []
    for one in dimensions:
        if one.part and one.part not in seen and len(one.paths) == 1 and not one.takes:
            seen.add(one.part)
            inner.append(one)
        else:
            outer.append(replace(one, part=""))
    return Space((*outer, *inner), way)
