"""What a table of an own law works out of its pieces: accelerations at their ends, jumps, and the parts of ∫a²."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial

from engine.laws.piece import Piece

NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)


class Ends(NamedTuple):
    """The acceleration at both ends of a piece; what the pieces so far have reached; the jump from there."""

    begin: float
    end: float
    reached: float
    jump: float


class Squares(NamedTuple):
    """∫a² of a piece in three parts, a = polynomial p + sine q: ∫p², 2∫p q, ∫q²."""

    polynomial: float
    cross: float
    sine: float


def ends(pieces: Sequence[Piece]) -> list[Ends]:
    """Return the accelerations at the ends of pieces that follow rest; a piece of no duration neither jumps nor counts.

    The jump is |a| from what was reached to the begin of the piece, 0 before the first.
    """
    found, reached = [], 0.0
    for piece in pieces:
        begin, end = _acceleration(piece, 0.0), _acceleration(piece, piece.duration)
        jump = abs(begin - reached) if piece.duration > 0.0 else 0.0
        reached = end if piece.duration > 0.0 else reached
        found.append(Ends(begin, end, reached, jump))
    return found


def spread_turn(piece: Piece) -> float:
    """Return ω d, by which the first sine of a piece turns (rad)."""
    return piece.omega * piece.duration


def _acceleration(piece: Piece, u: float) -> float:
    return float(Polynomial(piece.c)(u)) + piece.amplitude * math.sin(piece.omega * u + piece.phase)


def squares(piece: Piece) -> Squares:
    """Return the parts of ∫a² over a piece, by Gauss-Legendre on at most half a turn of ωu at a time."""
    parts = 1 + int(abs(piece.omega) * piece.duration / math.pi)
    half = piece.duration / parts / 2.0
    u = half * (2.0 * np.arange(parts)[:, None] + 1.0 + NODES)
    weights = half * np.tile(WEIGHTS, parts)
    p = Polynomial(piece.c)(u).ravel()
    q = piece.amplitude * np.sin(piece.omega * u + piece.phase).ravel()
    return Squares(float(weights @ p**2), float(2.0 * weights @ (p * q)), float(weights @ q**2))
