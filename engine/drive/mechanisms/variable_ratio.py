"""A mechanism whose ratio depends on its load's position: by any curve, or by points. SI units."""

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
    """A mechanism between a shaft and its load whose ratio φ' changes with the load's position; φ rises with y."""

    name: str
    steady: bool = False  # whether the shaft may stand in the ends of its reach: not in a dead centre, φ' is infinite

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
        """Return φ, φ', φ'' at positions, on a knot as on the side of ``within``. Raises OutOfReachError."""
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


class Parabolas(NamedTuple):
    """The parabolas through points and their neighbours."""

    slope: Array  # y' by φ
    bend: Array  # y''
    second: Array  # φ'' by y
    widths: tuple[Array, Array]  # of the parts beside
    flat: Array  # the flatter chord Δφ/Δy beside
    calm: NDArray[np.bool_]  # whether Bernstein's coefficients of both parts rise with that slope and curvature

    @classmethod
    def of(cls, angle: Array, y: Array) -> "Parabolas":
        """Return them of points; at an end those of the nearest three, of two points those of a straight line."""
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
    """Points (φ in rad, y in m or rad), both strictly rising; between them φ(y) is a polynomial of fifth degree.

    At each point φ' and φ'' are those of the parabola y(φ) through the point and its neighbours (at an end through the
    nearest three), so that all three are continuous: Hermite interpolation. Where the points bend so sharply that a
    part might fall, φ'' is 0 and φ' at most 5/4, at least 1/4 of the flatter chord beside it: then Bernstein's
    coefficients of each part rise, and the curve with them. Raises ValueError for fewer than two points, or points that
    do not rise.
    Source: G. Farin, Curves and Surfaces for CAGD, 7.6, quintic Hermite interpolation; 5.1, Bernstein form.
    """

    points: tuple[tuple[float, float], ...]
    name = "table"
    steady = True

    def __init__(self, points: Sequence[tuple[float, float]]) -> None:
        object.__setattr__(self, "points", tuple((float(angle), float(y)) for angle, y in points))
        if len(self.points) < 2:
            raise ValueError(f"table: {len(self.points)} points are given; expected at least two")
        for k, (one, other) in enumerate(pairwise(self.points), 2):
            require_finite(angle=other[0], position=other[1])
            if not (other[0] > one[0] and other[1] > one[1]):
                raise ValueError(f"table: point {k} does not rise in angle and position; expected both to")

    @cached_property
    def columns(self) -> Array:
        """φ, y, dφ/dy and d²φ/dy² of each point."""
        angle, y = np.array(self.points).T
        one = self.parabolas
        held = 1.0 / np.clip(one.slope, 0.8 / one.flat, 4.0 / one.flat)
        first = np.divide(1.0, one.slope, out=np.ones_like(y), where=one.slope > 0.0)
        return np.vstack([angle, y, np.where(one.calm, first, held), np.where(one.calm, one.second, 0.0)])

    @cached_property
    def parabolas(self) -> Parabolas:
        """The parabolas y(φ) through each point and its neighbours, and whether the curve rises beside it."""
        angle, y = np.array(self.points).T
        return Parabolas.of(angle, y)

    @cached_property
    def widths(self) -> Array:
        """How far each point is from the next (m or rad)."""
        return np.diff(self.columns[1])

    @cached_property
    def control(self) -> Array:
        """Bernstein's coefficients of each part, six in a row (rad): as they rise, so does the curve."""
        angle, _, slope, bend = self.columns
        h = self.widths
        left, right = h * slope[:-1] / 5.0, h * slope[1:] / 5.0
        inner = [angle[:-1] + left, angle[:-1] + 2.0 * left + h**2 * bend[:-1] / 20.0,
                 angle[1:] - 2.0 * right + h**2 * bend[1:] / 20.0, angle[1:] - right]  # fmt: skip
        return np.column_stack([angle[:-1], *inner, angle[1:]])

    @cached_property
    def powers(self) -> Array:
        """Coefficients of φ over the share t of each part, from the lowest power: parts by six (rad)."""
        b = self.control.T
        d1, d2, d3 = (np.diff(b, n, axis=0) for n in (1, 2, 3))
        d4, d5 = np.diff(b, 4, axis=0), np.diff(b, 5, axis=0)
        return np.column_stack([b[0], 5.0 * d1[0], 10.0 * d2[0], 10.0 * d3[0], 5.0 * d4[0], d5[0]])

    @property
    def reach(self) -> Reach:
        """From the first to the last point."""
        return Reach(self.points[0][1], self.points[-1][1], "begin of the table", "end of the table")

    @property
    def knots(self) -> tuple[float, ...]:
        """Positions of the points but the first and the last."""
        return tuple(y for _, y in self.points[1:-1])

    def part(self, y: Array) -> NDArray[np.intp]:
        """Return the number, from 0, of the part between two points in which positions lie, on a point of the next.

        Up to 1 nm or 1e-9 rad before a point a position counts as on it, so that rounding does not choose the part.
        """
        position = self.columns[1]
        return np.clip(np.searchsorted(position, y + ON_A_POINT, side="right") - 1, 0, position.size - 2)

    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        k = self.part(within)
        h = self.widths[k]
        t, c = (y - self.columns[1][k]) / h, np.moveaxis(self.powers[k], -1, 0)
        angle, first, second = (np.zeros_like(t) for _ in range(3))
        for one in c[::-1]:
            second, first, angle = second * t + 2.0 * first, first * t + angle, angle * t + one
        return ShaftAngles(angle, first / h, second / h**2)


def _through_three(x: Array, y: Array) -> tuple[Array, Array]:
    """Return slope and curvature at each point, of the parabola through it and its neighbours."""
    chord = np.diff(y) / np.diff(x)
    if chord.size == 1:
        return np.repeat(chord, 2), np.zeros(2)
    return np.gradient(y, x, edge_order=2), np.pad(2.0 * np.diff(chord) / (x[2:] - x[:-2]), 1, mode="edge")
