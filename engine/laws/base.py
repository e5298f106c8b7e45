"""What laws are told in: s, v, a and j, coefficients, how near counts as the same, what numbers have to be."""

import math
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

BREAK_TOLERANCE = 2e-9
"""A sample this near to a break, in units of ξ, counts as on it: twice what a look-up may hang on.

The cells look up the same sum of ξ and tolerance, and spreadsheet programs take numbers for equal that differ by
1e-12 or more: so rounding decides neither here nor there on which side of a jump a sample lies.

Laws are right-continuous: at a break they have the value of the later stage, at ξ = 1 the left limit.
"""
ROUNDING = 1e-12  # By so much of its range an abscissa may lie outside it.
Array = NDArray[np.float64]
Real = TypeVar("Real", float, Array)


class Kinematics(NamedTuple, Generic[Real]):
    """Dimensionless position s, velocity v, acceleration a and jerk j: floats, or arrays of one shape."""

    s: Real
    v: Real
    a: Real
    j: Real


@dataclass(frozen=True)
class Coefficients:
    """Extremes of a law for unit rise and unit time; one-sided limits at breaks count."""

    cv: float  # C_v = max |v|
    ca_max: float  # largest a
    ca_min: float  # lowest a, negative
    ca_rms: float  # C_a,rms = sqrt(∫ a² dξ)
    cj: float  # C_j = max |j|; infinite where a jumps, also at the ends against rest
    va_max: float  # largest v·a: the greatest power that an inertia asks for
    va_min: float  # lowest v·a: the greatest power that an inertia gives back, negative

    @property
    def ca(self) -> float:
        """C_a = max |a|."""
        return max(abs(self.ca_max), abs(self.ca_min))

    @property
    def va(self) -> float:
        """Max |v·a|."""
        return max(abs(self.va_max), abs(self.va_min))

    @property
    def loss(self) -> float:
        """C_a,rms²/12: copper loss of a pure inertia, against the cubic's, the least between two rests."""
        return self.ca_rms**2 / 12.0


def stage_of(xi: Array, starts: Array) -> NDArray[np.intp]:
    """Return the stage of each ξ: the last that begins at or before it; ξ = 1 is in the last that lasts."""
    reached = np.minimum(xi + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE)
    return np.searchsorted(starts, reached, side="right") - 1


def require_finite(**quantities: float) -> None:
    """Raise ValueError for the first quantity that is not a finite number."""
    for name, value in quantities.items():
        if not math.isfinite(value):
            raise ValueError(f"{name} is {value}; expected a finite number")


def unwrap(given: object, arrays: list[NDArray[Any]]) -> Any:
    """Return arrays as Python numbers if a plain number was given, as they are otherwise."""
    scalar = np.ndim(given) == 0 and not isinstance(given, np.ndarray)  # type: ignore[arg-type]
    return [array.item() for array in arrays] if scalar else arrays


def require_within(name: str, x: Array, low: float, high: float, tolerance: float) -> None:
    """Raise ValueError where x holds NaN, or lies outside [low, high] by more than the tolerance."""
    if not x.size:
        return
    least, greatest = float(x.min()), float(x.max())  # NaN, if there is one
    if not (least >= low - tolerance and greatest <= high + tolerance):
        found = "holds NaN" if math.isnan(least) else f"reaches from {least:.15g} to {greatest:.15g}"
        raise ValueError(f"{name} {found}; expected numbers from {low:.15g} to {high:.15g}")
