"""Mechanisms whose ratio depends on the load's position: the base class, and a table of positions. SI units."""

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array, require_finite

NEAR_END = 1e-9
"""share of the reach: a position must keep this distance from a dead centre, and may exceed another end by it"""


class ShaftAngles(NamedTuple):
    """Angle of the shaft and its derivatives by the load's position y (m or rad), arrays of equal shape."""

    angle: Array  # φ (rad)
    first: Array  # φ' (rad/m or 1)
    second: Array  # φ'' (rad/m² or 1/rad)


class Reach(NamedTuple):
    """The range of the load's positions (m or rad)."""

    low: float
    high: float
    at_low: str  # name of the lower end: a dead centre, the end of a table
    at_high: str


class OutOfReachError(ValueError):
    """A position (m or rad) that a mechanism cannot reach: ``by`` is its distance beyond an end, 0 at it."""

    def __init__(self, name: str, position: float, by: float, end: str) -> None:
        super().__init__(f"{name}: position {position:.9g} is in or beyond the {end}, by {by:.3g}")
        self.position, self.by, self.end = position, by, end


class Linkage(ABC):
    """A mechanism whose ratio φ' depends on the load's position y; the angle φ of its shaft rises with y."""

    name: str
    steady: bool = False  # whether the load may be at the ends of its reach; not in a dead centre, where φ' is infinite

    @property
    @abstractmethod
    def reach(self) -> Reach:
        """Range of the load's positions."""

    @abstractmethod
    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        """Return the shaft's angles at positions within reach; at a knot φ'' on the side of ``within`` counts."""

    @property
    def knots(self) -> tuple[float, ...]:
        """Positions inside the reach at which φ'' jumps (m or rad)."""
        return ()

    def shaft(self, position: ArrayLike, within: float | None = None) -> ShaftAngles:
        """Return φ, φ', φ'' at positions, at a knot as on the side of ``within``, if given. Raises OutOfReachError."""
        y = np.asarray(position, dtype=np.float64)
        extremes = float(y.min(initial=np.inf)), float(y.max(initial=-np.inf))
        errors = [error for error in map(self.beyond, extremes) if error]
        if errors:
            raise max(errors, key=lambda error: error.by)
        return self._shaft(y, y if within is None else np.asarray(within))

    def beyond(self, position: float) -> OutOfReachError | None:
        """Return the error of a position beyond the reach, or None; an infinite position stands for an empty array."""
        low, high, at_low, at_high = self.reach
        near = near_end(self)
        if not np.isfinite(position) or low + near <= position <= high - near:
            return None
        under = position < low + near
        by, end = (low - position, at_low) if under else (position - high, at_high)
        return OutOfReachError(self.name, position, max(by, 0.0), end)


def near_end(linkage: Linkage) -> float:
    """Return the least distance of positions from the ends of the reach (m or rad); below 0 if they may be reached."""
    low, high, *_ = linkage.reach
    return (-NEAR_END if linkage.steady else NEAR_END) * (high - low)


class Parabolas(NamedTuple):
    """Parabolas y(φ) through each point and its neighbours, arrays over the points."""

    slope: Array  # dy/dφ
    bend: Array  # d²y/dφ²
    second: Array  # φ'' by y
    widths: tuple[Array, Array]  # Δy of the parts before and after the point
    flat: Array  # the smaller Δφ/Δy of the two parts
    # whether Bernstein's coefficients of both parts rise with this slope and curvature
    calm: NDArray[np.bool_]

    @classmethod
    def of(cls, angle: Array, y: Array) -> "Parabolas":
        """Return the parabolas of points; at an end that of the nearest three, of two points a straight line."""
        h, chord = np.diff(y), np.diff(angle) / np.diff(y)
        slope, bend = _through_three(angle, y)
        widths = np.append(h[0], h), np.append(h, h[-1])
        before, after = np.append(chord[0], chord), np.append(chord, chord[-1])
        calm = slope > 0.0
        first = np.divide(1.0, slope, out=np.zeros_like(y), where=calm)
        second = -bend * first**3
        for way, width, rise in ((-1.0, widths[0], before), (1.0, widths[1], after)):
            bent = way * width * second
            calm = calm & (4.0 * first + bent > 0.0) & (8.0 * first + bent < 10.0 * rise)
        return cls(slope, bend, second, widths, np.minimum(before, after), calm)


ON_A_POINT = 1e-9  # m or rad: a position of a table this near before a point counts as on it


@dataclass(frozen=True)
class PositionTable(Linkage):
    """A table of positions; between its points φ(y) is a polynomial of degree 5, with φ' and φ'' continuous.

    At each point φ' and φ'' are those of the parabola y(φ) through the point and its neighbours (at an end through the
    nearest three). Where the points bend so sharply that φ might fall, φ'' is 0 and φ' between 1/4 and 5/4 of the
    smaller Δφ/Δy beside the point: then Bernstein's coefficients of each part rise, and φ with them. Raises ValueError
    for fewer than two points, or points that do not rise.
    Source: G. Farin, Curves and Surfaces for CAGD, 7.6, quintic Hermite interpolation; 5.1, Bernstein form.
    """

    points: tuple[tuple[float, float], ...]  # (φ in rad, y in m or rad), both rising
    name = "table"
    steady = True

    def __init__(self, points: Sequence[tuple[float, float]]) -> None:
        object.__setattr__(self, "points", tuple((float(angle), float(y)) for angle, y in points))
        if len(self.points) < 2:
            raise ValueError(f"table: {len(self.points)} points are given; expected at least two")
        for k, (before, after) in enumerate(pairwise(self.points), 2):
            require_finite(angle=after[0], position=after[1])
            if not (after[0] > before[0] and after[1] > before[1]):
                raise ValueError(f"table: point {k} does not rise in angle and position; expected both to")

    @cached_property
    def columns(self) -> Array:
        """φ, y, dφ/dy and d²φ/dy² of each point."""
        angle, y = np.array(self.points).T
        fit = self.parabolas
        held = 1.0 / np.clip(fit.slope, 0.8 / fit.flat, 4.0 / fit.flat)
        first = np.divide(1.0, fit.slope, out=np.ones_like(y), where=fit.slope > 0.0)
        return np.vstack([angle, y, np.where(fit.calm, first, held), np.where(fit.calm, fit.second, 0.0)])

    @cached_property
    def parabolas(self) -> Parabolas:
        """The parabolas y(φ) through each point and its neighbours, and whether the curve rises beside it."""
        angle, y = np.array(self.points).T
        return Parabolas.of(angle, y)

    @cached_property
    def widths(self) -> Array:
        """Δy of each part (m or rad)."""
        return np.diff(self.columns[1])

    @cached_property
    def control(self) -> Array:
        """Bernstein's coefficients of each part (rad): shape (parts, 6)."""
        angle, _, slope, bend = self.columns
        h = self.widths
        begin, end, left, right = angle[:-1], angle[1:], h * slope[:-1] / 5.0, h * slope[1:] / 5.0
        third = begin + 2.0 * left + h**2 * bend[:-1] / 20.0
        fourth = end - 2.0 * right + h**2 * bend[1:] / 20.0
        return np.column_stack([begin, begin + left, third, fourth, end - right, end])

    @cached_property
    def powers(self) -> Array:
        """Coefficients (rad) of φ over the share t of each part, from the lowest power: shape (parts, 6)."""
        b = self.control.T
        return np.column_stack([math.comb(5, n) * np.diff(b, n, axis=0)[0] for n in range(6)])

    @property
    def reach(self) -> Reach:
        """From the first to the last point."""
        return Reach(self.points[0][1], self.points[-1][1], "begin of the table", "end of the table")

    @property
    def knots(self) -> tuple[float, ...]:
        """Positions of the points but the first and the last."""
        return tuple(y for _, y in self.points[1:-1])

    def part(self, y: Array) -> NDArray[np.intp]:
        """Return the number, from 0, of the part that each position lies in; a point belongs to the part after it.

        Up to 1 nm or 1e-9 rad before a point a position counts as on it, so that rounding does not choose the part.
        """
        position = self.columns[1]
        return np.clip(np.searchsorted(position, y + ON_A_POINT, side="right") - 1, 0, position.size - 2)

    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        k = self.part(within)
        h = self.widths[k]
        t, c = (y - self.columns[1][k]) / h, np.moveaxis(self.powers[k], -1, 0)
        angle, first, second = (np.zeros_like(t) for _ in range(3))
        for coefficient in c[::-1]:
            second, first = second * t + 2.0 * first, first * t + angle
            angle = angle * t + coefficient
        return ShaftAngles(angle, first / h, second / h**2)


def _through_three(x: Array, y: Array) -> tuple[Array, Array]:
    """Return slope and curvature at each point, of the parabola through it and its neighbours."""
    chord = np.diff(y) / np.diff(x)
    if chord.size == 1:
        return np.repeat(chord, 2), np.zeros(2)
    return np.gradient(y, x, edge_order=2), np.pad(2.0 * np.diff(chord) / (x[2:] - x[:-2]), 1, mode="edge")
