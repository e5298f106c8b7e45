"""What of a machine only scales: designs that differ in nothing else are worked out together, without a book.

A template says which entries of its description do so (a motor, a reducer), and gives the results of many designs at
once, by the names that its book gives them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

M = TypeVar("M")
Values = NDArray[Any]
"""a result of designs: one for all, or one for each"""


class Column(NamedTuple):
    """An entry in many designs: its different values, and which of them each design has."""

    values: Sequence[Any]
    places: NDArray[np.intp]

    @property
    def each(self) -> Values:
        """The value in each design."""
        return np.array(self.values)[self.places]


Worked = dict[str, Callable[[], Any]]
Results = Mapping[str, Callable[[], Any]]
"""by name, what works a result out"""


class Scaling(NamedTuple, Generic[M]):
    """What of a kind of machine only scales.

    ``part`` returns to which part of the machine the entry at a key belongs, empty for all others; one entry of a part
    may differ. ``results`` gives the results of designs that differ in the columns, by the keys of these. ``off`` tells
    by which share a book may be off a result of that name, where the book finds it by points.
    """

    part: Callable[[str], str]
    results: Callable[[M, Mapping[str, Column]], Results]
    off: Callable[[str], float] = lambda name: 0.0
