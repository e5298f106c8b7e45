"""An own law by nine Gauss-Lobatto points on each of its pieces, as the cells compute its coefficients.

Peaks are the largest values at the points, or of the parabola between two points at which the slopes have different
signs; the RMS is the weighted sum over the points. :mod:`engine.laws.extremes` has the exact coefficients.
"""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Legendre
from numpy.typing import NDArray

from engine.laws.base import Array, Coefficients, Flags
from engine.laws.ends import AT_REST, Slopes
from engine.laws.extremes import reach_of
from engine.laws.family import Law
from engine.laws.inverse import velocity_extremes, velocity_peak
from engine.laws.piece import Piece, begins, gains, placed_pieces, snap
from engine.laws.pieces import PieceLaw


class PieceEnds(NamedTuple):
    """Dimensionless accelerations at the ends of a piece."""

    begin: float
    end: float
    reached: float  # at the end of the last piece of any duration, up to this
    jump: float  # |a| by which the acceleration jumps at the begin; 0 of a piece without duration


def piece_ends(pieces: Sequence[Piece], follows_rest: bool = True) -> list[PieceEnds]:
    """Return the accelerations at the ends of consecutive pieces; where they follow no rest, the first has no jump."""
    ends, reached = list[PieceEnds](), 0.0
    for piece in pieces:
        begin, end = gains(np.array([0.0, piece.duration]), np.array(piece.row)[:, None])[2].tolist()
        reached = reached if ends or follows_rest else begin
        jump, reached = (abs(begin - reached), end) if piece.duration > 0.0 else (0.0, reached)
        ends.append(PieceEnds(begin, end, reached, jump))
    return ends


POINTS = 9  # of a piece, with both its ends
SAME = 1e-9  # difference of ξ, v or a below which two values count as equal
_BASIS = Legendre.basis(POINTS - 1)
# which NumPy from 2.5 on gives as complex numbers
_NODES = np.array([-1.0, *_BASIS.deriv().roots().real, 1.0])
SHARES: Array = (_NODES + 1.0) / 2.0  # places of the points, as shares of a piece's duration
# of the points in a mean over the piece; sum 1
WEIGHTS: Array = 1.0 / (POINTS * (POINTS - 1) * _BASIS(_NODES) ** 2)
SLOPES = {"s": "v", "v": "a", "a": "j", "j": "b", "va": "g"}  # quantity and its derivative by ξ


class Points:
    """The points of a law on all its pieces, those without duration too: arrays of 9 values a piece, dimensionless."""

    def __init__(self, pieces: Sequence[Piece], slopes: Slopes = AT_REST) -> None:
        self.pieces, self.slopes = tuple(pieces), slopes
        # of each point, from 0
        self.piece: NDArray[np.intp] = np.repeat(np.arange(len(pieces)), POINTS)
        # in its piece
        self.share, self.weight = np.tile(SHARES, len(pieces)), np.tile(WEIGHTS, len(pieces))
        figures = np.array([(p.duration, p.omega, p.phase, p.omega2, p.phase2) for p in pieces]).T
        duration, omega, phi, omega2, phi2 = figures[:, self.piece]
        # share of the rise, place in its piece
        self.part, self.u = self.weight * duration, self.share * duration
        self.xi = np.array(begins(pieces))[self.piece] + self.u
        self.angles = [omega * self.u + phi, omega2 * self.u + phi2]  # ωu + φ of either sine (rad)
        row = np.array([piece.row for piece in pieces]).T[:, self.piece]
        s0, v0 = np.array([(place.s, place.v) for place in placed_pieces(pieces, slopes[0] or 0.0)]).T[:, self.piece]
        s, gained, a, j = gains(self.u, row)
        v = v0 + gained
        b = snap(self.u, row)  # the slope of j; g is that of v·a
        self.rates = {"s": s0 + v0 * self.u + s, "v": v, "a": a, "j": j, "b": b, "va": v * a, "g": a * a + v * j}

    def crosses(self, what: str) -> Flags:
        """Return for each point whether the slope changes its sign since the point before it on the same piece."""
        slope = self.rates[SLOPES[what]]
        return np.asarray((self.share > 0.0) & (np.roll(slope, 1) * slope < 0.0) & (self.part > 0.0))

    def local_extremes(self, what: str) -> Array:
        """Return the extreme between each point and that before it, else the value there; 0 without duration.

        With values f and slopes g at both points it is (g₀ f₁ − g₁ f₀ − g₀ g₁ (u₁ − u₀)/2)/(g₀ − g₁).
        """
        f, g = self.rates[what], self.rates[SLOPES[what]]
        f0, g0, h = np.roll(f, 1), np.roll(g, 1), self.u - np.roll(self.u, 1)
        crosses = self.crosses(what)
        over = np.where(crosses, g0 - g, 1.0)
        extremes = np.where(crosses, (g0 * f - g * f0 - g0 * g * h / 2.0) / over, f)
        return np.where(self.part > 0.0, extremes, 0.0)

    def extremes(self, what: str) -> tuple[float, float]:
        """Return the lowest and the largest value of a quantity of :data:`SLOPES`; 0 counts, the value at rest."""
        extremes = self.local_extremes(what)
        return min(0.0, float(extremes.min())), max(0.0, float(extremes.max()))

    @cached_property
    def fastest_xi(self) -> Array:
        """ξ of each point, or of the extreme just before it, at which v is largest; 1 at all others."""
        a = self.rates["a"]
        crosses = self.crosses("v")
        over = np.where(crosses, a - np.roll(a, 1), 1.0)
        place = self.xi - np.where(crosses, (self.u - np.roll(self.u, 1)) * a / over, 0.0)
        reached = self.local_extremes("v") >= self.extremes("v")[1] - SAME
        return np.where(reached & (self.part > 0.0), place, 1.0)

    @property
    def peak(self) -> float:
        """The first ξ at which v is largest."""
        return float(self.fastest_xi.min())

    @property
    def wrong_way(self) -> Array:
        """Decrease of v before its peak, or increase after it, from the point before to each point; else 0."""
        v, crest = self.rates["v"], self.local_extremes("v")
        before = np.roll(v, 1)
        falls, rises = np.maximum(before, crest) - v, v - np.maximum(before, crest)
        wrong = np.maximum(0.0, np.where(self.xi <= self.peak + SAME, falls, rises))
        return np.where((self.share > 0.0) & (self.part > 0.0), wrong, 0.0)

    @property
    def coefficients(self) -> Coefficients:
        """The law's coefficients by the points."""
        v, a, j, va = (self.extremes(what) for what in ("v", "a", "j", "va"))
        at = piece_ends(self.pieces, self.slopes[0] is None)
        jump = max(*(end.jump for end in at), abs(at[-1].reached) if self.slopes[1] is None else 0.0)
        return Coefficients(
            cv=max(v[1], -v[0]),
            ca_max=a[1],
            ca_min=a[0],
            ca_rms=math.sqrt(float(np.sum(self.part * self.rates["a"] ** 2))),
            cj=math.inf if jump > SAME else max(j[1], -j[0]),
            va_max=va[1],
            va_min=va[0],
        )


class PointedLaw(PieceLaw):
    """An own law with the coefficients by its points, as in a workbook; those of :class:`PieceLaw` are exact."""

    @cached_property
    def points(self) -> Points:
        """The points on its pieces."""
        return Points(self.pieces, self.slopes)

    @cached_property
    def coefficients(self) -> Coefficients:
        """The coefficients by the points."""
        return self.points.coefficients


def reach(law: Law) -> tuple[float, float]:
    """Return the lowest and the highest position of a law: exact, of a :class:`PointedLaw` by its points."""
    return law.points.extremes("s") if isinstance(law, PointedLaw) else reach_of(law.as_pieces(), law.start.v)


def slowest(law: Law) -> float:
    """Return the lowest velocity of a law: exact, of a :class:`PointedLaw` by its points."""
    if isinstance(law, PointedLaw):
        return law.points.extremes("v")[0]
    return float(law.v(velocity_extremes(law)).min())


def fastest(law: Law) -> float:
    """Return the first ξ at which v of a law is largest: exact, of a :class:`PointedLaw` by its points."""
    return law.points.peak if isinstance(law, PointedLaw) else velocity_peak(law)
