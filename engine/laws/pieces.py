"""The engineer's own law, piece by piece (OWN), as entered and normalized to end at s = 1 and at rest."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, stage_of
from engine.laws.ends import AT_REST, BoundaryValues, Slopes
from engine.laws.extremes import reach_of
from engine.laws.family import Law
from engine.laws.piece import POWERS, SINES, Piece, begins, gains_of, placed_pieces, shifted
from engine.laws.polynomials import BoundaryQuintic

SUM_TOLERANCE = 1e-9
POLYNOMIAL_345 = (Piece(1.0, (0.0, 60.0, -180.0, 120.0)),)


@dataclass(frozen=True)
class PieceLaw(Law):
    """A law given by its acceleration, piece by piece; s and v are integrated from s = 0, and v = 0 or a slope.

    The default is the polynomial 3-4-5. The law need not end at s = 1 and at rest: see ``end``, :func:`normalized`.
    A law with a slope, 0 too, keeps the rates of its pieces there, whatever is beside it.
    Raises ValueError unless the durations of the pieces sum to 1 (within 1e-9).
    """

    code = "OWN"
    number = 7
    name = "Own law"
    aliases = ("own", "pieces", "OPT")
    source = "own law of the engineer; the example is the polynomial 3-4-5"

    pieces: tuple[Piece, ...]
    slopes: Slopes  # velocities at begin and end; None: at rest

    def __init__(self, pieces: Sequence[Piece] = POLYNOMIAL_345, slopes: Slopes = AT_REST) -> None:
        object.__setattr__(self, "pieces", tuple(pieces))
        object.__setattr__(self, "slopes", slopes)
        total = math.fsum(p.duration for p in self.pieces)
        if abs(total - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the durations of the {len(self.pieces)} pieces sum to {total:.12g}; expected 1")

    @property
    def entry_velocity(self) -> float:
        """Velocity at ξ = 0."""
        return self.slopes[0] or 0.0

    @property
    def fixes_ends(self) -> bool:
        """Whether it has a slope."""
        return self.slopes != AT_REST

    @property
    def adjacent_accelerations(self) -> tuple[float, float]:
        """The law's acceleration at an end with a slope, else 0."""
        first, last = self.slopes
        return 0.0 if first is None else self.start.a, 0.0 if last is None else self.end.a

    @cached_property
    def _rows(self) -> tuple[Array, int]:
        """Columns of begin, s, v, the powers in use, and P, ω, sin φ, cos φ of the sines in use; number of powers."""
        places = placed_pieces(self.pieces, self.entry_velocity)
        rows = np.array([place.piece.row for place in places]).T
        where = np.array([(place.begin, place.s, place.v) for place in places]).T
        powers = int(np.flatnonzero(rows[:POWERS].any(axis=1)).max(initial=-1)) + 1
        return np.vstack([where, rows[:powers], *(rows[k : k + 4] for k in SINES if rows[k].any())]), powers

    def _at(self, xi: Array) -> Sequence[Array]:
        """Return s, v, a, j of a flat array of ξ in [0, 1], exact for sines of any frequency."""
        table, powers = self._rows
        begin, s0, v0, *row = table[:, :1] if table.shape[1] == 1 else table.take(stage_of(xi, table[0]), axis=1)
        u = xi - begin
        s, v, a, j = gains_of(u, row[:powers], [row[k : k + 4] for k in range(powers, len(row), 4)])
        return s0 + v0 * u + s, v0 + v, a, j

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces as they are given."""
        return self.pieces


def moved_to(law: PieceLaw, ends: BoundaryValues) -> PieceLaw:
    """Return a law with other rates at its ends, plus the polynomial 3-4-5 between the differences.

    Raises ValueError where it would overshoot.
    """
    own = law.start, law.end
    v, a = ([ends.both(n)[i] - getattr(at, n) for i, at in enumerate(own)] for n in "va")
    more = BoundaryQuintic(ends=BoundaryValues(0.0, *v, *a)).polynomial
    both = zip(law.pieces, begins(law.pieces), strict=True)
    pieces = tuple(replace(p, c=tuple(map(sum, zip(p.c, shifted(more, xi), strict=True)))) for p, xi in both)
    low, high = reach_of(pieces, ends.v0)
    if low < -SUM_TOLERANCE or high > 1.0 + SUM_TOLERANCE:
        raise ValueError(f"the law reaches from {low:g} to {high:g}; expected 0 to 1")
    return PieceLaw(pieces, ends.slopes)


NONE = 1e-12  # share of the velocity that any piece could gain at most: a smaller gain counts as 0
ALIKE = 1e-6  # the same for a travel, and for a determinant as a share of the square


class Misses(NamedTuple):
    """The errors of a law at its end, dimensionless."""

    s: float  # s(1) − 1
    v: float  # v(1)


def misses(pieces: Sequence[Piece]) -> Misses:
    """Return by how much consecutive pieces, from rest, miss the rise 1 and rest at the end."""
    last = placed_pieces(pieces)[-1]
    return Misses(last.s + last.ds - 1.0, last.v + last.dv)


class Groups(NamedTuple):
    """The pieces in two groups, those that gain velocity (+) and those that lose it (−); see :func:`normalized`."""

    gained: list[tuple[float, float]]  # what each piece adds to s(1) and v(1)
    sizes: list[float]  # bound of the velocity that each piece could gain
    slows: list[bool]  # whether each piece loses velocity
    s1: float  # S⁺, sum over the first group
    v1: float  # V⁺
    s2: float  # S⁻, sum over the second group
    v2: float  # V⁻
    least: float  # a smaller gain of velocity counts as 0
    under: float  # determinant S⁺ V⁻ − S⁻ V⁺
    least_under: float  # a smaller determinant counts as 0
    factors: tuple[float, float]  # α and β; 0 if there are none
    mends: bool  # whether both factors are positive and of similar size


def groups(pieces: Sequence[Piece]) -> Groups:
    """Return the sums of the pieces that gain and of those that lose velocity, and the factors that normalize them."""
    whole, sizes = math.fsum(piece.duration for piece in pieces), [_size(piece) for piece in pieces]
    gains = []
    for place in placed_pieces(pieces):
        left = whole - place.begin - place.piece.duration
        gains.append((place.ds - place.v * place.piece.duration + place.dv * left, place.dv))
    largest = max(sizes, default=0.0)
    least, least_under = NONE * largest, ALIKE * largest**2
    slows = [v < -least for _, v in gains]
    (s1, v1), (s2, v2) = (
        [math.fsum(gain[k] for gain, slow in zip(gains, slows, strict=True) if slow == side) for k in (0, 1)]
        for side in (False, True)
    )
    under = s1 * v2 - s2 * v1
    if any(slows) or v1 > least:
        factors = (v2 / under, -v1 / under) if abs(under) > least_under else (0.0, 0.0)
    else:
        common = 1.0 / s1 if s1 > ALIKE * largest else 0.0
        factors = common, common
    mends = min(factors) > ALIKE * max(factors)
    return Groups(gains, sizes, slows, s1, v1, s2, v2, least, under, least_under, factors, mends)


def normalized(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces with c0 … c5 and P scaled so that the law ends at s = 1 and at rest.

    All pieces that gain velocity are multiplied by α, all that lose it by β. With S and V, what each group adds to
    s(1) and v(1), α S⁺ + β S⁻ = 1 and α V⁺ + β V⁻ = 0. If v(1) = 0 already, both are 1/s(1).
    Raises ValueError if there are no positive factors: for a law that only speeds up, or moves away from its rise.
    """
    grouped = groups(pieces)
    if not grouped.mends:
        raise ValueError("no factors bring the own law to rest at its rise; expected it to speed up, then slow down")
    up, down = grouped.factors
    factors = [down if slow else up for slow in grouped.slows]
    return tuple(piece.scaled(factor) for piece, factor in zip(pieces, factors, strict=True))


def _size(piece: Piece) -> float:
    """Return an upper bound of max |a| · duration of a piece."""
    powers = math.fsum(abs(c) * piece.duration**i for i, c in enumerate(piece.c))
    return piece.duration * (powers + abs(piece.amplitude) + abs(piece.amplitude2))
