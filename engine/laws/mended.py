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
    least: float
    """a velocity below which none is gained"""
    under: float
    """S⁺ V⁻ − S⁻ V⁺"""
    least_under: float
    """a determinant below which there is none"""
    factors: tuple[float, float]
    """α and β; 0 where none do"""
    mends: bool
    """whether both factors are positive, one beside the other"""


def groups(pieces: Sequence[Piece]) -> Groups:
    """Return the pieces in two groups, those that lose velocity apart."""
    found, sizes = _gained(pieces), [_size(piece) for piece in pieces]
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
    factors = [down if slow else up for slow in found.slows]
    return tuple(
        replace(p, c=tuple(f * c for c in p.c), amplitude=f * p.amplitude, amplitude2=f * p.amplitude2)
        for p, f in zip(pieces, factors, strict=True)
    )


def _gained(pieces: Sequence[Piece]) -> list[tuple[float, float]]:
    """Return what each piece adds to s and v at the end: ∬a and ∫a over it, and its ∫a over the time that follows."""
    rest = math.fsum(piece.duration for piece in pieces)
    found = []
    for piece in pieces:
        rest -= piece.duration
        s, v = gains_at(piece, piece.duration)
        found.append((s + v * rest, v))
    return found


def _size(piece: Piece) -> float:
    """Return no less than the largest |a| of a piece times its duration."""
    powers = sum(abs(c) * piece.duration**i for i, c in enumerate(piece.c))
    return piece.duration * (powers + abs(piece.amplitude) + abs(piece.amplitude2))
