"""Coefficients of a law: extremes and root mean square, from the zeros of the derivatives of its pieces."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

from .law import NUM, Law, Piece, Refused

JUMP = 1e-9  # of the largest acceleration: a smaller one is rounding
BACKWARDS = 1e-9  # of the mean velocity: a smaller velocity backwards is rounding
MOST = 1e3  # rad of a sine within a piece: beyond, a cell would keep Calc waiting

# Gauss-Legendre with five nodes (Abramowitz & Stegun, 25.4.29), as (node, weight) on −1 … 1
NEAR, FAR = math.sqrt(5 - 2 * math.sqrt(10 / 7)) / 3, math.sqrt(5 + 2 * math.sqrt(10 / 7)) / 3
HEAVY, LIGHT = (322 + 13 * math.sqrt(70)) / 900, (322 - 13 * math.sqrt(70)) / 900
GAUSS = ((0.0, 128 / 225), (NEAR, HEAVY), (-NEAR, HEAVY), (FAR, LIGHT), (-FAR, LIGHT))


class Coefficients(NamedTuple):
    """C_v, C_a, C_a,rms, C_j (infinite where a jumps), and the lowest velocity."""

    cv: float
    ca: float
    ca_rms: float
    cj: float
    v_min: float


@lru_cache(maxsize=512)
def coefficients(law: Law) -> Coefficients:
    """Return the coefficients of a law, for unit rise and time; refuses sines of more than 1,000 rad in a piece."""
    pieces = [stage.piece for stage in law.stages]
    if any(piece.turned > MOST for piece in pieces):
        raise Refused(NUM)
    v = [stage.state(u)[1] for stage in law.stages for u in around(stage.piece, 0)]
    a = [abs(piece.derivative(0, u)) for piece in pieces for u in around(piece, 1)]
    j = [abs(piece.derivative(1, u)) for piece in pieces for u in around(piece, 2)]
    begins = [*(piece.derivative(0, 0.0) for piece in pieces), 0.0]
    ends = [0.0, *(piece.derivative(0, piece.duration) for piece in pieces)]
    jumps = any(abs(begin - end) > JUMP * max(a) for begin, end in zip(begins, ends))
    square = math.fsum(squared(piece) for piece in pieces)
    return Coefficients(max(map(abs, v)), max(a), math.sqrt(square), math.inf if jumps else max(j), min(v))


def monotone(law: Law) -> bool:
    """Whether a law never moves backwards."""
    return coefficients(law).v_min >= -BACKWARDS


def around(piece: Piece, order: int) -> list[float]:
    """Return the ends of a piece and the zeros between them of the derivative of a of this order."""
    return [0.0, *piece.zeros(order), piece.duration]


def squared(piece: Piece) -> float:
    """Return ∫a² of a piece: to rounding for eight steps, and of a quarter rad."""
    parts = 8 + int(4 * piece.turned)
    half = piece.duration / parts / 2
    return half * math.fsum(
        weight * piece.derivative(0, half * (2 * k + 1 + node)) ** 2 for k in range(parts) for node, weight in GAUSS
    )
