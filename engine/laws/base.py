"""What every motion law offers: s, v, a, j over ξ in [0, 1], exact coefficients, names and source."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import TYPE_CHECKING, Any, ClassVar, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from engine.laws.piece import Piece

BREAK_TOLERANCE = 2e-9
"""A sample this near to a break, in units of ξ, counts as on it: twice what a look-up may hang on.

The cells look up the same sum of ξ and tolerance, and spreadsheet programs take numbers for equal that differ by
1e-12 or more: so rounding decides neither here nor there on which side of a jump a sample lies.

Laws are right-continuous: at a break they have the value of the later stage, at ξ = 1 the left limit.
"""

ROUNDING = 1e-12
"""By so much of its range an abscissa may lie outside it."""

BLOCK = 8192  # samples evaluated at a time, so that what lies between stays in the cache

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

    cv: float
    """C_v = max |v|"""
    ca_max: float
    """largest a"""
    ca_min: float
    """lowest a, negative"""
    ca_rms: float
    """C_a,rms = sqrt(∫ a² dξ)"""
    cj: float
    """C_j = max |j|; infinite where a jumps, also at the ends against rest"""
    va_max: float
    """largest v·a: the greatest power that an inertia asks for"""
    va_min: float
    """lowest v·a: the greatest power that an inertia gives back, negative"""

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


class Vendors(NamedTuple):
    """What a law is called where cams are made, with its number there; empty where there is none, or none is sure.

    Sources: simatic-ax/lcamhdl, LCamHdl_ProfileConstants; Beckhoff Infosys, MC_MotionFunctionType; CODESYS, segment
    types of SM3_CamBuilder; SEW 27800520, aCamSegment.
    """

    siemens: str = ""
    twincat: str = ""
    codesys: str = ""
    sew: str = ""


class Law(ABC):
    """A motion law: position s(ξ) of the abscissa ξ = t/t_a in [0, 1], from s = 0, with derivatives by ξ.

    A law states its names and source, its closed form and, from its parameters, what else is known of it: one test
    measures that all of it is true of the closed form (tests/engine/laws/test_claims.py).
    """

    code: ClassVar[str]
    """three letters"""
    name: ClassVar[str]
    aliases: ClassVar[tuple[str, ...]] = ()
    """other names that documents give it"""
    source: ClassVar[str]
    vendors: ClassVar[Vendors] = Vendors()

    @abstractmethod
    def _block(self, xi: Array) -> tuple[Array | float, Array | float, Array | float, Array | float]:
        """Return s, v, a, j of a flat array of ξ in [0, 1]."""

    @abstractmethod
    def _coefficients(self) -> Coefficients:
        """Return the coefficients in closed form."""

    @cached_property
    def breaks(self) -> tuple[float, ...]:
        """Every ξ between 0 and 1 at which the formula changes, in order; a stage of no duration repeats one."""
        return tuple(accumulate(piece.duration for piece in self.as_pieces()[:-1]))

    @abstractmethod
    def as_pieces(self) -> "tuple[Piece, ...]":
        """Return the law as pieces, each a polynomial and a sine: what the cells of its page must hold."""

    def monotone_pieces(self) -> "tuple[Piece, ...]":
        """Return the pieces cut where the acceleration is largest or lowest: it is monotone on each.

        Sines are cut at their quarters, polynomials at their peaks. What is entered piece by piece, and a polynomial
        between prescribed ends, stays as it is.
        """
        return self.as_pieces()

    def evaluate(self, xi: Real) -> Kinematics[Real]:
        """Return s, v, a, j at ξ: floats of a number, arrays of ξ's shape of an array.

        Raises ValueError where ξ is not a number from 0 to 1.
        """
        x = np.asarray(xi, dtype=np.float64)
        require_within("xi", x, 0.0, 1.0, ROUNDING)
        flat = x.reshape(-1)
        table = np.empty((4, flat.size))
        for begin in range(0, flat.size, BLOCK):
            here = slice(begin, begin + BLOCK)
            inside = np.minimum(np.maximum(flat[here], 0.0), 1.0)
            for row, values in zip(table, self._block(inside), strict=True):
                row[here] = values
        return Kinematics(*unwrap(xi, [row.reshape(x.shape) for row in table]))

    def s(self, xi: Real) -> Real:
        """Return the position s(ξ)."""
        return self.evaluate(xi).s

    def v(self, xi: Real) -> Real:
        """Return the velocity v = ds/dξ."""
        return self.evaluate(xi).v

    def a(self, xi: Real) -> Real:
        """Return the acceleration a = dv/dξ."""
        return self.evaluate(xi).a

    def j(self, xi: Real) -> Real:
        """Return the jerk j = da/dξ, within the stages: a jump of a adds no value."""
        return self.evaluate(xi).j

    @cached_property
    def coefficients(self) -> Coefficients:
        """The exact coefficients C_v, C_a, C_a,rms, C_j, max(v·a)."""
        return self._coefficients()

    @cached_property
    def start(self) -> Kinematics[float]:
        """Values at ξ = 0."""
        return self.evaluate(0.0)

    @cached_property
    def end(self) -> Kinematics[float]:
        """Values at ξ = 1, from the left."""
        return self.evaluate(1.0)


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
