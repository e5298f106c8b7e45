"""What a template gives besides its book: axes for controllers, and results of many designs at once.

Designs that differ only in entries that scale results (a motor, a reducer) are computed together, without a book: a
template names these entries, and gives the results by the names in its book.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from engine.motion.profile import CamProfile
from engine.timing import Switch

M = TypeVar("M")
Values = NDArray[Any]  # a result of designs: one for all, or one for each


@dataclass(frozen=True)
class CamAxis:
    """An axis over a cycle of its master: its profile and the units of both."""

    name: str
    profile: CamProfile
    x_unit: str
    y_unit: str
    repeats: bool = True  # whether the cycle follows upon itself: it comes back, or a feed goes on from where it is
    shaft: Callable[[], Self] | None = None
    """gives the angle of its motor's shaft, if it has a drive; raises ValueError for what the mechanism cannot do"""

    @property
    def units(self) -> tuple[str, str, str, str]:
        """Units of y, y', y'' and y'''."""
        x, y = self.x_unit, self.y_unit
        return y, f"{y}/{x}", f"{y}/{x}²", f"{y}/{x}³"


class CamSwitch(NamedTuple):
    """A switch over a cycle of the master, in the unit of its angles."""

    name: str
    switch: Switch
    x_unit: str


class Column(NamedTuple):
    """An entry in many designs: its different values, and which of them each design has."""

    values: Sequence[Any]
    places: NDArray[np.intp]

    @property
    def each(self) -> Values:
        """The value in each design."""
        return np.array(self.values)[self.places]


Computations = dict[str, Callable[[], Any]]


class Results(NamedTuple):
    """Functions that compute results, by name; which of them are checks, and which take each design by itself."""

    named: Mapping[str, Callable[[], Any]]
    checks: Collection[str]
    slow: Collection[str]


class Scaling(NamedTuple, Generic[M]):
    """The entries of a kind of machine that only scale its results, and these results.

    ``part`` returns to which part of the machine the entry at a key belongs, empty for all others; one entry of a part
    may differ. ``results`` gives the results of designs that differ in the columns, by the keys of these. ``most``
    gives by name what results are at most if nothing else is told, where entries at these keys vary.
    """

    part: Callable[[str], str]
    results: Callable[[M, Mapping[str, Column]], Results]
    most: Callable[[M, Collection[str]], Mapping[str, float]]
