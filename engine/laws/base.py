"""Basis of all laws: their values and coefficients, tolerances at breaks, and checks of numbers."""

import math
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

BREAK_TOLERANCE = 2e-9
"""Distance from a break, in units of ξ, within which a sample counts as on the break.

The cells add the same tolerance to ξ before they look up a stage, and spreadsheet programs take numbers that differ by
about 1e-12 for equal. So rounding chooses the side of a jump neither in the engine nor in the cells.

Laws are right-continuous: at a break they have the value of the later stage, at ξ = 1 the left limit.
"""
ROUNDING = 1e-12  # share of its range by which an abscissa may lie outside
Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Real = TypeVar("Real", float, Array)


class Kinematics(NamedTuple, Generic[Real]):
    """Dimensionless position s, velocity v, acceleration a and jerk j: floats, or arrays of equal shape."""

    s: Real
    v: Real
    a: Real
    j: Real


@dataclass(frozen=True)
class Coefficients:
    """Dimensionless extremes of a law for unit rise and unit time; one-sided limits at breaks count."""

    cv: float  # C_v = max |v|
    ca_max: float  # largest a
    ca_min: float  # lowest a, negative
    ca_rms: float  # C_a,rms = sqrt(∫ a² dξ)
    cj: float  # C_j = max |j|; infinite if a jumps within the law, or at its ends from or to rest
    va_max: float  # largest v·a: factor of the largest power that accelerates an inertia
    va_min: float  # lowest v·a: factor of the largest power that an inertia returns, negative

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
        """C_a,rms²/12: copper loss of a pure inertia over that of the cubic, the least loss between two rests."""
        return self.ca_rms**2 / 12.0


def stage_of(xi: Array, starts: Array) -> NDArray[np.intp]:
    """Return the number of the stage at each ξ, by the ξ at which stages begin; ξ = 1 is in the last that lasts."""
    reached = np.minimum(xi + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE)
    return np.searchsorted(starts, reached, side="right") - 1


def require_finite(**quantities: float) -> None:
    """Raise ValueError for the first quantity that is not a finite number."""
    for name, value in quantities.items():
        if not math.isfinite(value):
            raise ValueError(f"{name} is {value}; expected a finite number")


def unwrap(given: object, arrays: list[NDArray[Any]]) -> Any:
    """Return arrays as Python numbers if ``given`` is a plain number, else unchanged."""
    scalar = np.ndim(given) == 0 and not isinstance(given, np.ndarray)  # type: ignore[arg-type]
    return [array.item() for array in arrays] if scalar else arrays


def require_within(low: float, high: float, **abscissae: Array) -> None:
    """Raise ValueError for the first array that holds NaN, or a value outside [low, high] but for rounding."""
    tolerance = ROUNDING * (high - low)
    for name, x in abscissae.items():
        # NaN, if there is any
        least, greatest = float(x.min(initial=high)), float(x.max(initial=low))
        if not (least >= low - tolerance and greatest <= high + tolerance):
            reason = "holds NaN" if math.isnan(least) else f"reaches from {least:.15g} to {greatest:.15g}"
            raise ValueError(f"{name} {reason}; expected numbers from {low:.15g} to {high:.15g}")
