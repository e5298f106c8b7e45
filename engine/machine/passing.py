"""Where a motion passes a position, by counting points of a grid: as cells find it. SI units."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from engine.motion.pieces import MotionPiece
from engine.motion.turning import GRID, PARTS, ROUNDS

NEAR = 1e-12
"""of what a mechanism reaches: what differs by less is equal"""


def close(low: float, high: float) -> float:
    """Return what is equal beside a reach."""
    return NEAR * (high - low)


class Passed(NamedTuple):
    """Where in a piece y passes a level (rad): not before, round by round; y there and at the end of the bracket."""

    rounds: tuple[float, ...]
    low: float
    high: float
    place: float


def passed(piece: MotionPiece, level: float, way: float, lost: float) -> Passed:
    """Return where y of a piece that moves one way (1 or −1) passes a level; a chord through the last bracket."""

    def y(u: float) -> float:
        return float(piece.derivative(0, np.array([u]))[0])

    width, at, rounds = piece.duration, 0.0, []
    for _ in range(ROUNDS):
        below = way * piece.derivative(0, at + width * GRID) < way * level - lost
        at += width * min(PARTS - 1, int(np.count_nonzero(below))) / PARTS
        width /= PARTS
        rounds.append(at)
    low, high = y(at), y(at + width)
    return Passed(tuple(rounds), low, high, at + width * (level - low) / (high - low))


def passing_piece(pieces: list[MotionPiece], level: float, way: float, lost: float) -> int:
    """Return in which of the pieces of a phase, from 0, y passes a level."""
    begins = np.array([float(piece.derivative(0, np.zeros(1))[0]) for piece in pieces])
    return max(0, int(np.count_nonzero(way * begins < way * level - lost)) - 1)
