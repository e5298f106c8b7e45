"""The engineer's own law, piece by piece (OWN): as it is entered, and scaled so that it ends at s = 1 and at rest."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, stage_of
from engine.laws.family import Law
from engine.laws.piece import POWERS, SINES, Piece, gains_of, placed_pieces

SUM_TOLERANCE = 1e-9
POLYNOMIAL_345 = (Piece(1.0, (0.0, 60.0, -180.0, 120.0)),)


@dataclass(frozen=True)
class PieceLaw(Law):
    """A law given by its acceleration, piece by piece; s and v are carried on from s = v = 0.

    The durations of the pieces sum to 1 (within 1e-9), else ValueError; by default it is the polynomial 3-4-5. Whether
    the law ends at s = 1 and at rest is the engineer's affair: see ``end``.
    """

    code = "OWN"
    name = "Own law"
    aliases = ("own", "pieces")
    source = "own law of the engineer; the example is the polynomial 3-4-5"

    pieces: tuple[Piece, ...]

    def __init__(self, pieces: Sequence[Piece] = POLYNOMIAL_345) -> None:
        object.__setattr__(self, "pieces", tuple(pieces))
        total = sum(p.duration for p in self.pieces)
        if abs(total - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the durations of the {len(self.pieces)} pieces sum to {total:.12g}; expected 1")

    @cached_property
    def _rows(self) -> tuple[Array, int]:
        """Columns of begin, s, v, the powers in use, and P, ω, sin φ, cos φ of the sines in use; how many powers."""
        rows = np.array([one.piece.row for one in placed_pieces(self.pieces)]).T
        where = np.array([(one.begin, one.s, one.v) for one in placed_pieces(self.pieces)]).T
        powers = int(np.flatnonzero(rows[:POWERS].any(axis=1)).max(initial=-1)) + 1
        return np.vstack([where, rows[:powers], *(rows[k : k + 4] for k in SINES if rows[k].any())]), powers

    def _block(self, xi: Array) -> Sequence[Array]:
        """Return s, v, a, j of a flat array of ξ in [0, 1]: right for sines of any frequency."""
        table, powers = self._rows
        begin, s0, v0, *row = table[:, :1] if table.shape[1] == 1 else table.take(stage_of(xi, table[0]), axis=1)
        u = xi - begin
        s, v, a, j = gains_of(u, row[:powers], [row[k : k + 4] for k in range(powers, len(row), 4)])
        return s0 + v0 * u + s, v0 + v, a, j

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces as they are given."""
        return self.pieces


NONE = 1e-12  # a velocity gained by a piece below this is none, in units of the largest that any piece could gain
ALIKE = 1e-6  # a travel below this is none, in the same units, and a determinant below this, in units of their square


class Misses(NamedTuple):
    """By how much a law misses: s(1) − 1 and v(1)."""

    s: float
    v: float


def misses(pieces: Sequence[Piece]) -> Misses:
    """Return by how much pieces, one after the other from rest, miss the rise 1 and rest at its end."""
    last = placed_pieces(pieces)[-1]
    return Misses(last.s + last.ds - 1.0, last.v + last.dv)


class Groups(NamedTuple):
    """What the pieces that gain velocity add to s(1) and v(1), and what those that lose it; each one's gains."""

    gained: list[tuple[float, float]]
    sizes: list[float]
    slows: list[bool]
    s1: float
    v1: float
    s2: float
    v2: float
    least: float  # a velocity below which none is gained
    under: float  # S⁺ V⁻ − S⁻ V⁺
    least_under: float  # a determinant below which there is none
    factors: tuple[float, float]  # α and β; 0 where none do
    mends: bool  # whether both factors are positive, one beside the other


def groups(pieces: Sequence[Piece]) -> Groups:
    """Return the pieces in two groups, those that lose velocity apart."""
    whole, sizes = math.fsum(piece.duration for piece in pieces), [_size(piece) for piece in pieces]
    found = [(one.ds - one.v * one.piece.duration + one.dv * (whole - one.begin - one.piece.duration), one.dv)
             for one in placed_pieces(pieces)]  # fmt: skip
    largest = max(sizes, default=0.0)
    least, least_under = NONE * largest, ALIKE * largest**2
    slows = [v < -least for _, v in found]
    s1, v1, s2, v2 = (
        math.fsum(one[i] for one, slow in zip(found, slows, strict=True) if slow == side)
        for side in (False, True)
        for i in (0, 1)
    )
    under = s1 * v2 - s2 * v1
    if any(slows) or v1 > least:
        factors = (v2 / under, -v1 / under) if abs(under) > least_under else (0.0, 0.0)
    else:
        one = 1.0 / s1 if s1 > ALIKE * largest else 0.0
        factors = one, one
    mends = min(factors) > ALIKE * max(factors)
    return Groups(found, sizes, slows, s1, v1, s2, v2, least, under, least_under, factors, mends)


def normalized(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces with c0 … c5 and P scaled so that the law ends at s = 1 and at rest.

    All pieces that gain velocity have one factor α, all that lose it another, β: with S and V what either group
    adds to s(1) and v(1), α S⁺ + β S⁻ = 1 and α V⁺ + β V⁻ = 0. Where v(1) = 0 already, both are 1/s(1).
    Raises ValueError where no positive factors do: a law that only speeds up, or moves away from its rise.
    """
    found = groups(pieces)
    if not found.mends:
        raise ValueError("no factors bring the own law to rest at its rise; expected it to speed up, then slow down")
    up, down = found.factors
    factors = [down if slow else up for slow in found.slows]
    return tuple(
        replace(p, c=tuple(f * c for c in p.c), amplitude=f * p.amplitude, amplitude2=f * p.amplitude2)
        for p, f in zip(pieces, factors, strict=True)
    )


def _size(piece: Piece) -> float:
    """Return no less than the largest |a| of a piece times its duration."""
    powers = sum(abs(c) * piece.duration**i for i, c in enumerate(piece.c))
    return piece.duration * (powers + abs(piece.amplitude) + abs(piece.amplitude2))
