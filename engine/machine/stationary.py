"""Where the acceleration of a piece of motion turns: it only rises or only falls between these places."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import repeat

from engine.motion.pieces import MotionPiece

PLACES = 3
"""in a piece, at most, at which its acceleration turns, but of the sixth or seventh degree"""
MOST_TURNED = PLACES * math.pi * (1.0 + 1e-9)
"""how far a sine turns in a piece, at most (rad)"""
HALVED = 1.0 / math.sqrt(5.0)
"""of the second half of the polynomial 4-5-6-7: where its acceleration turns"""
INSIDE = 1e-9
"""of a piece: what is nearer to its ends is not inside"""
LOST = 1e-9
"""of the largest acceleration: what differs by less is equal"""


def turning(piece: MotionPiece, places: int = PLACES) -> list[float]:
    """Return where y'' of a piece would be stationary, so many places of them, inside it or not.

    Of a sine (kπ + π/2 − φ)/ω from its begin on; of a polynomial of up to the fifth degree the roots of its slope, the
    one farther from 0 first, and 0. Source: W. H. Press et al., Numerical Recipes, 5.6, for roots in all digits.
    Of A sin(ωu + φ) + B sin(2ωu + ψ) where cos ωu = A sin φ/(16 B sin(ψ − 2φ)), if it begins with y''' = 0.
    Of a half of the polynomial 4-5-6-7 where x = (5 − √5)/10 of the whole; that of prescribed ends has its own ladder.
    """
    (a, omega, phi), *others = piece.sines
    if septic(piece):
        return [piece.duration * (HALVED if piece.number else 1.0 - HALVED), *repeat(0.0, places - 1)]
    if not a:
        return [*roots(*piece.c[3:6]), *repeat(0.0, places - 2)]
    for b, _, psi in (sine for sine in others if sine[0]):
        share = a * math.sin(phi) / (16.0 * b * math.sin(psi - 2.0 * phi))
        return [math.acos(share) / omega if abs(share) < 1.0 else 0.0, *repeat(0.0, places - 1)]
    first = math.floor(phi / math.pi - 0.5 + INSIDE) + 1
    return [((first + k + 0.5) * math.pi - phi) / omega for k in range(places)]


def septic(piece: MotionPiece) -> bool:
    """Whether a piece is of the sixth or seventh degree."""
    return any(piece.c[6:])


def inside(piece: MotionPiece, places: Iterable[float]) -> list[float]:
    """Return places in a piece, its duration instead of those that are not inside."""
    d = piece.duration
    return [u if INSIDE * d < u < (1.0 - INSIDE) * d else d for u in places]


def roots(c3: float, c4: float, c5: float) -> tuple[float, float]:
    """Return the roots of c3 + 4 c4 u + 10 c5 u², the one farther from 0 first; 0 for one that is not there."""
    w = root_term(c3, c4, c5)
    return (w / (10.0 * c5) if c5 else 0.0), (c3 / w if w else 0.0)


def root_term(c3: float, c4: float, c5: float) -> float:
    """Return w, by which the roots are w/(10 c5) and c3/w; 0 where there is none."""
    inside = 4.0 * c4**2 - 10.0 * c3 * c5
    root = math.sqrt(max(0.0, inside))
    return -(2.0 * c4 + (-root if c4 < -LOST * root else root)) if root else 0.0


def plain(piece: MotionPiece) -> bool:
    """Whether :func:`turning` knows all of a piece: a polynomial, or one of the second degree and one sine or two.

    A sine of more than :data:`PLACES` half turns has more places.
    """
    sine, *others = (amplitude for amplitude, _, _ in piece.sines)
    often = abs(piece.sines[0][1]) * piece.duration > MOST_TURNED
    return doubled(piece) if any(others) else not (sine and (often or any(piece.c[3:])))


def doubled(piece: MotionPiece) -> bool:
    """Whether a piece is two sines over half a turn, one of twice the other's frequency, that begin with y''' = 0."""
    (a, omega, phi), (_, double, psi), *more = piece.sines
    half_turn = abs(omega) * piece.duration <= math.pi * (1.0 + LOST)
    phases = abs(math.cos(phi)) + abs(math.cos(psi - 2.0 * phi))
    alone = not any(piece.c[3:]) and not any(amplitude for amplitude, _, _ in more)
    return bool(a) and alone and half_turn and phases < LOST and abs(double - 2.0 * omega) <= LOST * abs(omega)
