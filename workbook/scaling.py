"""What of a machine only scales: designs that differ in nothing else are worked out together, without a book.

A template says which entries of its description do so (a motor, a reducer), and gives the results of many designs at
once, by the names that its book gives them.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

M = TypeVar("M")
Values = NDArray[Any]  # a result of designs: one for all, or one for each


class Column(NamedTuple):
    """An entry in many designs: its different values, and which of them each design has."""

    values: Sequence[Any]
    places: NDArray[np.intp]

    @property
    def each(self) -> Values:
        """The value in each design."""
        return np.array(self.values)[self.places]


Worked = dict[str, Callable[[], Any]]


class Results(NamedTuple):
    """By name what works a result out; which of them are checks, and which take each design by itself."""

    named: Mapping[str, Callable[[], Any]]
    checks: Collection[str]
    slow: Collection[str]


class Scaling(NamedTuple, Generic[M]):
    """What of a kind of machine only scales.

    ``part`` returns to which part of the machine the entry at a key belongs, empty for all others; one entry of a part
    may differ. ``results`` gives the results of designs that differ in the columns, by the keys of these. ``most``
    gives by name what results are at most if nothing else is told, where entries at these keys vary.
    """

    part: Callable[[str], str]
    results: Callable[[M, Mapping[str, Column]], Results]
    most: Callable[[M, Collection[str]], Mapping[str, float]]
