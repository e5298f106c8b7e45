"""What every motion law has: s, v, a, j over ξ in [0, 1], and its coefficients."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

BREAK_TOLERANCE = 1e-12
"""A sample within this of a break, in units of ξ, counts as on it: rounding never decides the side of a jump."""

BLOCK = 16_384  # samples evaluated at a time, so that the intermediate arrays stay in the processor's cache


class Kinematics(NamedTuple):
    """Dimensionless position, velocity, acceleration and jerk: floats for a scalar ξ, else arrays of its shape."""

    s: Any
    v: Any
    a: Any
    j: Any


@dataclass(frozen=True)
class Coefficients:
    """Extremes of a law for unit rise and unit time.

    ``cv`` = max|v|; ``ca_max`` and ``ca_min`` the largest and the lowest a; ``ca_rms`` = √∫a² dξ;
    ``cj`` = max|j|, infinite where a jumps (at the ends, against rest); ``va_max``, ``va_min`` the
    largest and the lowest v·a, which size the power when driving and when braking.
    """

    cv: float
    ca_max: float
    ca_min: float
    ca_rms: float
    cj: float
    va_max: float
    va_min: float

    @property
    def ca(self) -> float:
        """C_a = max|a|."""
        return max(self.ca_max, -self.ca_min)

    @property
    def va(self) -> float:
        """The largest |v·a|."""
        return max(self.va_max, -self.va_min)


class Law(ABC):
    """A motion law s(ξ): y = h s(t/t_a), with h the rise and t_a its time (S3, equation 1).

    Laws are right-continuous: at a break the value is that of the later stage, at ξ = 1 the limit from the left.
    """

    code: ClassVar[str]
    name: ClassVar[str]

    @abstractmethod
    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        """Return s, v, a, j of a one-dimensional array within [0, 1]."""

    @abstractmethod
    def _coefficients(self) -> Coefficients:
        """Return the coefficients from closed forms."""

    def evaluate(self, xi: ArrayLike) -> Kinematics:
        """Return s, v, a, j at ``xi``: floats for a scalar, else arrays of its shape.

        Raises ValueError where a value is not a number, or lies outside [0, 1] by more than BREAK_TOLERANCE.
        """
        given = np.asarray(xi, dtype=np.float64)
        flat = np.ascontiguousarray(given).reshape(-1)
        if flat.size and not (flat.min() >= -BREAK_TOLERANCE and flat.max() <= 1 + BREAK_TOLERANCE):
            raise ValueError(
                f"{self.code}: ξ must lie in [0, 1], found values from {flat.min():g} to {flat.max():g}"
            )
        out = np.empty((4, flat.size))
        for begin in range(0, flat.size, BLOCK):
            block = slice(begin, begin + BLOCK)
            for row, values in zip(out, self._kinematics(flat[block]), strict=True):
                row[block] = values
        if given.ndim == 0:
            return Kinematics(*(float(row[0]) for row in out))
        return Kinematics(*(row.reshape(given.shape) for row in out))

    def s(self, xi: ArrayLike) -> Any:
        """Return the dimensionless position at ``xi``."""
        return self.evaluate(xi).s

    def v(self, xi: ArrayLike) -> Any:
        """Return the dimensionless velocity ds/dξ at ``xi``."""
        return self.evaluate(xi).v

    def a(self, xi: ArrayLike) -> Any:
        """Return the dimensionless acceleration d²s/dξ² at ``xi``."""
        return self.evaluate(xi).a

    def j(self, xi: ArrayLike) -> Any:
        """Return the dimensionless jerk d³s/dξ³ at ``xi``; jumps of a are left out."""
        return self.evaluate(xi).j

    @cached_property
    def coefficients(self) -> Coefficients:
        """The law's coefficients, exact."""
        return self._coefficients()

    @cached_property
    def start(self) -> Kinematics:
        """Values at ξ = 0."""
        return self.evaluate(0.0)

    @cached_property
    def end(self) -> Kinematics:
        """Values at ξ = 1, from the left."""
        return self.evaluate(1.0)
