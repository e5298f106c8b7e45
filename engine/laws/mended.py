"""An own law that misses its rise or does not come to rest, with its entries scaled so that it does."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from engine.laws.piece import Piece, gains_at

NONE = 1e-12
"""a velocity gained by a piece below this is none, in units of the largest that any piece could gain"""
ALIKE = 1e-6
"""a travel below this is none, in the same units, and a determinant below this, in units of their square"""


@dataclass(frozen=True)
class Misses:
    """By how much a law misses: s(1) − 1 and v(1)."""

    s: float
    v: float


def misses(pieces: Sequence[Piece]) -> Misses:
    """Return by how much pieces, one after the other from rest, miss the rise 1 and rest at its end."""
    found = _gained(pieces)
    return Misses(math.fsum(s for s, _ in found) - 1.0, math.fsum(v for _, v in found))


class Groups(NamedTuple):
    """What the pieces that gain velocity add to s(1) and v(1), and what those that lose it; each one's gains."""

    gained: list[tuple[float, float]]
    sizes: list[float]
    slows: list[bool]
    s1: float
    v1: float
    s2: float
    v2: float

    @property
    def least(self) -> float:
        """A velocity below which none is gained."""
        return NONE * max(self.sizes, default=0.0)

    @property
    def under(self) -> float:
        """S⁺ V⁻ − S⁻ V⁺."""
        return self.s1 * self.v2 - self.s2 * self.v1

    @property
    def least_under(self) -> float:
        """A determinant below which there is none."""
        return ALIKE * max(self.sizes, default=0.0) ** 2

    @property
    def factors(self) -> tuple[float, float]:
        """α and β; 0 where none do."""
        if any(self.slows) or self.v1 > self.least:
            told = abs(self.under) > self.least_under
            return (self.v2 / self.under, -self.v1 / self.under) if told else (0.0, 0.0)
        one = 1.0 / self.s1 if self.s1 > ALIKE * max(self.sizes, default=0.0) else 0.0
        return one, one

    @property
    def mends(self) -> bool:
        """Whether both factors are positive, one beside the other."""
        return min(self.factors) > ALIKE * max(self.factors)


def groups(pieces: Sequence[Piece]) -> Groups:
    """Return the pieces in two groups, those that lose velocity apart."""
    found, sizes = _gained(pieces), [_size(piece) for piece in pieces]
    least = NONE * max(sizes, default=0.0)
    slows = [v < -least for _, v in found]
    sums = [
        math.fsum(one[i] for one, slow in zip(found, slows, strict=True) if slow == side)
        for side in (False, True)
        for i in (0, 1)
    ]
    return Groups(found, sizes, slows, *sums)


def mended(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces with c0 … c5 and P scaled so that the law ends at s = 1 and at rest.

    All pieces that gain velocity have one factor α, all that lose it another, β: with S and V what either group
    adds to s(1) and v(1), α S⁺ + β S⁻ = 1 and α V⁺ + β V⁻ = 0. Where v(1) = 0 already, both are 1/s(1).
    Raises ValueError where no positive factors do: a law that only speeds up, or moves away from its rise.
    """
    found = groups(pieces)
    if not found.mends:
        raise ValueError("no factors bring the own law to rest at its rise; expected it to speed up, then slow down")
    up, down = found.factors
    return tuple(_times(piece, down if slow else up) for piece, slow in zip(pieces, found.slows, strict=True))


def scaled_by(factors: Sequence[float], values: Sequence[float]) -> list[float]:
    """Return each value times its factor."""
    return [factor * value for factor, value in zip(factors, values, strict=True)]


def _gained(pieces: Sequence[Piece]) -> list[tuple[float, float]]:
    """Return what each piece adds to s and v at the end: ∬a and ∫a over it, and its ∫a over the time that follows."""
    rest = math.fsum(piece.duration for piece in pieces)
    found = []
    for piece in pieces:
        rest -= piece.duration
        s, v = gains_at(piece, piece.duration)
        found.append((s + v * rest, v))
    return found


def _times(piece: Piece, factor: float) -> Piece:
    c = tuple(factor * c for c in piece.c)
    return replace(piece, c=c, amplitude=factor * piece.amplitude, amplitude2=factor * piece.amplitude2)


def _size(piece: Piece) -> float:
    """Return no less than the largest |a| of a piece times its duration."""
    powers = sum(abs(c) * piece.duration**i for i, c in enumerate(piece.c))
    return piece.duration * (powers + abs(piece.amplitude) + abs(piece.amplitude2))
