"""Coefficients of a law: extremes and root mean square, from the zeros of the derivatives of its pieces."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

from .law import Law, Stage
from .piece import Piece
from .refused import NUM, Refused

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
    if any(stage.piece.turned > MOST for stage in law.stages):
        raise Refused(NUM)
    v = [v for stage in law.stages for v in velocities(stage)]
    a = [abs(stage.piece.derivative(0, u)) for stage in law.stages for u in around(stage.piece, 1)]
    j = [abs(stage.piece.derivative(1, u)) for stage in law.stages for u in around(stage.piece, 2)]
    square = math.fsum(squared(stage.piece) for stage in law.stages)
    cj = math.inf if jumps(law, JUMP * max(a)) else max(j)
    return Coefficients(max(map(abs, v)), max(a), math.sqrt(square), cj, min(v))


def monotone(law: Law) -> bool:
    """Whether a law never moves backwards."""
    return coefficients(law).v_min >= -BACKWARDS


def around(piece: Piece, order: int) -> list[float]:
    """Return the ends of a piece and the zeros between them of the derivative of a of this order."""
    return [0.0, *piece.zeros(order), piece.duration]


def velocities(stage: Stage) -> list[float]:
    """Return v at the ends of a stage and wherever a is zero."""
    return [stage.v0 + stage.piece.gains(u)[1] for u in around(stage.piece, 0)]


def jumps(law: Law, least: float) -> bool:
    """Whether a jumps by more than ``least``, between the stages or at the ends against rest."""
    before = 0.0
    for stage in law.stages:
        ends = [stage.way * stage.piece.derivative(0, u) for u in (0.0, stage.piece.duration)][:: stage.way]
        if abs(ends[0] - before) > least:
            return True
        before = ends[1]
    return abs(before) > least


def squared(piece: Piece) -> float:
    """Return ∫a² of a piece: to rounding for eight steps, and of a quarter rad."""
    parts = 8 + int(4 * piece.turned)
    half = piece.duration / parts / 2
    return half * math.fsum(
        weight * piece.derivative(0, half * (2 * k + 1 + node)) ** 2 for k in range(parts) for node, weight in GAUSS
    )
