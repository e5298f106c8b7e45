"""Points spread over the pieces of a law, and its extremes refined from the likeliest of them.

It is how a table of cells finds the extremes of a law that has no closed form; the engine's own are those of
:mod:`engine.laws.piece_extremes`, which miss none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.laws.piece import Piece, bends, gains
from engine.laws.table import begins

RANKS = 3  # likeliest places of the largest values, and of the lowest, that are refined
STEPS = 4  # of Newton's method from the chord
DIGITS = 9  # after the point that count: of equal estimates the first is taken, a slope below is none
WIDEST = 0.3  # rad of a sine from one point to the next, at most
LEAST = 6  # points of a piece
AHEAD = 2e-9  # by how much an extreme counts as beyond both points between which it lies
FLAT = 1e-12  # a curvature below this is none
SAME = 1e-9  # of ξ: places no farther apart are one


class Rates(NamedTuple):
    """The law and its derivatives, arrays of one shape.

    s, v, a, j; b = d²a/du² and its slope e; the power v·a, its slope g = a² + v j and that one's, 3 a j + v b.
    """

    s: Array
    v: Array
    a: Array
    j: Array
    b: Array
    e: Array
    va: Array
    g: Array
    gg: Array


CHAINS = {
    "s": ("s", "v", "a"),
    "v": ("v", "a", "j"),
    "a": ("a", "j", "b"),
    "j": ("j", "b", "e"),
    "va": ("va", "g", "gg"),
}
"""what has extremes, with its slope and its curvature"""
BENDING = ("s", "v", "a")
"""whose slope is 0 at a rest: by its curvature there it is known whether it turns before the next point"""


class Top(NamedTuple):
    """A candidate for an extreme: estimate, row of its point (from 1), piece (from 1), bracket, steps, and value."""

    side: int
    rank: int
    estimate: float
    row: int
    piece: int
    low: float
    high: float
    steps: tuple[float, ...]
    value: float


@dataclass(frozen=True)
class Spread:
    """Points k = 0, 1, … on pieces entered with their velocities: equally many, at equal steps, on each in use."""

    pieces: tuple[Piece, ...]
    entered: tuple[tuple[float, float], ...]
    """s and v at the begin of each"""
    points: int

    @cached_property
    def lasting(self) -> list[int]:
        """The pieces that last, from 0."""
        return [k for k, piece in enumerate(self.pieces) if piece.duration > 0.0]

    @property
    def used(self) -> int:
        """How many they are."""
        return len(self.lasting)

    @property
    def counted(self) -> list[int]:
        """How many of the pieces up to each last."""
        return list(accumulate(int(piece.duration > 0.0) for piece in self.pieces))

    @property
    def each(self) -> int:
        """The points of a piece, both its ends included."""
        return max(2, self.points // self.used)

    @cached_property
    def place(self) -> NDArray[np.intp]:
        """Which of the pieces that last each point is on, from 0."""
        return np.minimum(np.arange(self.points) // self.each, self.used - 1)

    @cached_property
    def piece(self) -> NDArray[np.intp]:
        """The piece of each point, from 0."""
        return np.array(self.lasting)[self.place]

    @cached_property
    def u(self) -> Array:
        """The local abscissa of each point."""
        share = (np.arange(self.points) - self.place * self.each) / (self.each - 1)
        return np.asarray(np.array([one.duration for one in self.pieces])[self.piece] * np.minimum(share, 1.0))

    @cached_property
    def xi(self) -> Array:
        """ξ of each point."""
        return np.array(begins(self.pieces))[self.piece] + self.u

    @property
    def angles(self) -> list[list[float]]:
        """ωu + φ of either sine at the points (rad)."""
        places = [(self.pieces[int(k)], float(u)) for k, u in zip(self.piece, self.u, strict=True)]
        return [[p.omega * u + p.phase for p, u in places], [p.omega2 * u + p.phase2 for p, u in places]]

    @property
    def turn(self) -> float:
        """The largest ω d of a piece (rad)."""
        return max(one.omega * one.duration for one in self.pieces)

    @property
    def suffices(self) -> bool:
        """Whether the points are dense enough for the polynomials and sines of all pieces."""
        room = self.each * self.used <= self.points and self.each >= LEAST
        return room and self.turn <= WIDEST * (self.each - 1)

    @cached_property
    def rates(self) -> Rates:
        """The law and its derivatives at the points."""
        return self.at(self.piece, self.u)

    def size(self, of: str) -> float:
        """Return the largest size at the points of one of the law's derivatives."""
        return float(np.abs(getattr(self.rates, of)).max())

    def at(self, piece: NDArray[np.intp], u: Array) -> Rates:
        """Return the law and its derivatives at places: arrays of the shape of ``piece`` and ``u``."""
        row, (s0, v0) = self._rows[:, piece], self._begins[:, piece]
        s, gained, a, j = gains(u, row)
        b, e = bends(u, row)
        v = v0 + gained
        return Rates(s0 + v0 * u + s, v, a, j, b, e, v * a, a * a + v * j, 3.0 * a * j + v * b)

    def at_step(self, tops: Sequence[Top], n: int) -> Rates:
        """Return the law and its derivatives at the ``n``-th step of each candidate."""
        places = np.array([(top.piece - 1, top.steps[n]) for top in tops]).T
        return self.at(places[0].astype(np.intp), places[1])

    @cached_property
    def _rows(self) -> Array:
        return np.array([one.row for one in self.pieces]).T

    @cached_property
    def _begins(self) -> Array:
        return np.array(self.entered).T

    def curves(self, what: str) -> Array:
        """Return the curvature at the points, 0 where it is not asked for."""
        found: Array = getattr(self.rates, CHAINS[what][2]) if what in BENDING else np.zeros(self.points)
        return found

    def crosses(self, what: str) -> NDArray[np.bool_]:
        """Return for each point whether an extreme lies between it and the point before, on the same piece."""
        slope, curve = getattr(self.rates, CHAINS[what][1]).round(DIGITS), self.curves(what).round(DIGITS)
        leaves = np.where(slope[:-1] == 0.0, curve[:-1], slope[:-1])
        arrives = np.where(slope[1:] == 0.0, -curve[1:], slope[1:])
        moving = (slope[:-1] != 0.0) | (slope[1:] != 0.0)
        found = np.zeros(self.points, dtype=bool)
        found[1:] = (self.piece[1:] == self.piece[:-1]) & moving & (leaves * arrives < 0.0)
        return found

    def estimates(self, what: str) -> Array:
        """Return at each point the value there, or that of the extreme just before it: beyond both points.

        The slope's zero is where its chord has it; where it is 0 at one end already, where the parabola with its
        curvature there has its other zero.
        """
        value, slope = (getattr(self.rates, name) for name in CHAINS[what][:2])
        curve, crosses, before = self.curves(what), self.crosses(what), np.maximum(np.arange(self.points) - 1, 0)
        width = self.u - self.u[before]
        away = turning((slope[before], slope), (curve[before], curve), width)
        by_chord = value[before] + slope[before] * away / 2.0
        leaving = value[before] + curve[before] * away**2 / 6.0
        arriving = value + curve * (width - away) ** 2 / 6.0
        found = np.where(none(slope[before]), leaving, np.where(none(slope), arriving, by_chord))
        side = np.sign(np.where(none(slope[before]), curve[before], slope[before]))
        other = np.where(none(slope) & ~none(slope[before]), value[before], value)
        found = other + side * (np.maximum(0.0, side * (found - other)) + AHEAD)
        return np.asarray(np.where(crosses, found, value).round(DIGITS))

    def tops(self, what: str) -> list[Top]:
        """Return the candidates: first for the largest values, then for the lowest."""
        estimates, crosses = self.estimates(what), self.crosses(what)
        falling = np.sort(estimates)[::-1]
        sides = [(1, rank, falling[rank - 1]) for rank in range(1, RANKS + 1)]
        sides += [(-1, rank, falling[-rank]) for rank in range(1, RANKS + 1)]
        rows = np.array([int(np.flatnonzero(estimates == estimate)[0]) for _, _, estimate in sides])
        piece, high = self.piece[rows], self.u[rows]
        low = np.where(crosses[rows], self.u[rows - 1], high)
        steps = self._refined(what, piece, low, high)
        values = getattr(self.at(piece, steps[-1]), CHAINS[what][0])
        columns = rows + 1, piece + 1, low, high, np.transpose(steps), values
        return [
            Top(side, rank, float(estimate), row, number, begin, end, tuple(way), value)
            for (side, rank, estimate), row, number, begin, end, way, value in zip(
                sides, *(column.tolist() for column in columns), strict=True
            )
        ]

    def is_still(self, top: Top) -> bool:
        """Whether v has an extreme at a candidate, or its piece an end there."""
        at_end = top.high <= 0.0 or top.high >= self.pieces[top.piece - 1].duration
        return top.low < top.high or at_end or bool(none(self.rates.a[top.row - 1]))

    def _refined(self, what: str, piece: NDArray[np.intp], low: Array, high: Array) -> list[Array]:
        """Return the steps from the chord of the slope towards its zero; where a bracket is a point, that point."""
        _, slope, curve = CHAINS[what]
        ends = [self.at(piece, u) for u in (low, high)]
        slopes, curves = (tuple(getattr(end, name) for end in ends) for name in (slope, curve))
        bent = curves if what in BENDING else (np.zeros_like(low), np.zeros_like(low))
        steps = [np.where(low < high, low + turning(slopes, bent, high - low), high)]
        for _ in range(STEPS):
            at = self.at(piece, steps[-1])
            rate, curvature = getattr(at, slope), getattr(at, curve)
            step = np.divide(rate, curvature, out=np.zeros_like(low), where=np.abs(curvature) > FLAT)
            steps.append(np.maximum(low, np.minimum(high, steps[-1] - step)))
        return steps

    def wrong_way(self, peak: float) -> Array:
        """Return by how much v falls before the peak's ξ, or rises after it, from each point to the next."""
        gain = np.diff(self.rates.v, prepend=self.rates.v[0])
        return np.maximum(0.0, np.where(self.xi <= peak + SAME, -gain, gain))


def none(slopes: Array) -> NDArray[np.bool_]:
    """Return whether slopes are none."""
    return np.asarray(np.abs(slopes) < 0.5 * 10.0**-DIGITS)


def turning(slopes: Sequence[Array], curves: Sequence[Array], width: Array) -> Array:
    """Return how far behind the begin of a width a slope has a zero within it: g_0 w/(g_0 − g_1) by the chord.

    Of a slope that is 0 at an end already, where the parabola c t + B t² with its curvature c there has its other zero.
    """
    (first, last), (leaving, arriving) = slopes, curves
    rest, stop = none(first), none(last)
    over = np.where(rest, leaving * width - last, np.where(stop, first + arriving * width, first - last))
    part = np.where(rest, leaving * width, first)
    return width * np.divide(part, over, out=np.ones_like(width), where=over != 0.0)


def extreme(tops: Sequence[Top], side: int) -> Top:
    """Return the best of the candidates of one side: the first of equal ones."""
    mine = [top for top in tops if top.side == side]
    return max(mine, key=lambda top: (side * top.value, -top.rank))
