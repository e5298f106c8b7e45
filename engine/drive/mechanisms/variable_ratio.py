"""A mechanism whose ratio depends on its load's position: the angle of its shaft along the load's way. SI units."""

from abc import ABC, abstractmethod
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws.base import Array

NEAR_END = 1e-9
"""of the reach: so near to an end in which the shaft would run away counts as in it, so far beyond another as at it"""


class ShaftAngles(NamedTuple):
    """Angle φ of the shaft (rad) along the load's position y, with φ' = dφ/dy and φ'' (per m, or per rad)."""

    angle: Array
    first: Array
    second: Array


class Reach(NamedTuple):
    """Between which positions the load can go, and what is at either end: a dead centre, the end of a table."""

    low: float
    high: float
    at_low: str
    at_high: str


class OutOfReachError(ValueError):
    """A position that a mechanism cannot bring its load to, and by how much it lies beyond the end (0 in it)."""

    def __init__(self, name: str, position: float, by: float, end: str) -> None:
        super().__init__(f"{name}: position {position:.9g} is in or beyond the {end}, by {by:.3g}")
        self.position, self.by, self.end = position, by, end


class Linkage(ABC):
    """A mechanism between a shaft and its load whose ratio φ' changes with the load's position; φ rises with y.

    ``steady`` says whether the shaft may stand in the ends of its reach; in a dead centre it may not: the load's motion
    does not say how the shaft goes through it, and φ' is infinite.
    """

    name: str
    steady: bool = False

    @property
    @abstractmethod
    def reach(self) -> Reach:
        """Between which positions the load can go."""

    @abstractmethod
    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        """Return the shaft's angle of positions within reach; on a knot, as on the side of ``within``."""

    @property
    def knots(self) -> tuple[float, ...]:
        """Positions inside the reach at which φ'' jumps."""
        return ()

    def shaft(self, position: ArrayLike, within: float | None = None) -> ShaftAngles:
        """Return φ, φ', φ'' at positions of the load, on a knot as on the side of the position ``within``.

        Raises OutOfReachError for the one that lies farthest out.
        """
        y = np.asarray(position, dtype=np.float64)
        beyond = [one for at in (y.min(initial=np.inf), y.max(initial=-np.inf)) if (one := self.beyond(float(at)))]
        if beyond:
            raise max(beyond, key=lambda one: one.by)
        return self._shaft(y, y if within is None else np.asarray(within))

    def beyond(self, position: float) -> OutOfReachError | None:
        """Return by how much a position lies beyond an end of the reach, or None; infinite ones stand for none."""
        low, high, at_low, at_high = self.reach
        near = near_end(self)
        if not np.isfinite(position) or low + near <= position <= high - near:
            return None
        under = position < low + near
        by, end = (low - position, at_low) if under else (position - high, at_high)
        return OutOfReachError(self.name, position, max(by, 0.0), end)


def near_end(linkage: Linkage) -> float:
    """Return how near to an end of its reach a position counts as in it; less than 0 where it may stand there."""
    low, high, *_ = linkage.reach
    return (-NEAR_END if linkage.steady else NEAR_END) * (high - low)
