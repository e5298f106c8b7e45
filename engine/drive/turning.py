"""Reversals of a motion inside one of its pieces: sought at even points, then on a parabola of the velocity.

A piece turns round at most twice: where it first moves both ways, and from where on it moves but a single way.
:func:`engine.drive.search.sign_changes` is exact, and has every turn.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.motion.pieces import MotionPiece

PARTS = 200  # of a piece, in whose middles its direction is looked at
MIDDLES: Array = (np.arange(PARTS) + 0.5) / PARTS  # as shares of the piece
# the first and the last share at which a piece moves a way that it never moves
NEVER, NOWHERE = 2.0, 0.0


class Directions(NamedTuple):
    """The first and the last of :data:`MIDDLES` at which a piece moves each way."""

    first_forward: float = NEVER
    first_backward: float = NEVER
    last_forward: float = NOWHERE
    last_backward: float = NOWHERE

    @property
    def turns(self) -> list[tuple[float, float]]:
        """The share of the piece near each turn, half a part from a middle on either side; and the direction after."""
        begin = max(self.first_forward, self.first_backward)
        end = min(self.last_forward, self.last_backward)
        if begin >= 1.0:
            return []
        half = 0.5 / PARTS
        first = begin - half, math.copysign(1.0, self.first_forward - self.first_backward)
        last = end + half, math.copysign(1.0, self.last_forward - self.last_backward)
        return [first, last] if end >= begin else [first]


class Turn(NamedTuple):
    """A turn inside a piece, by the velocity at a place near it."""

    piece: int  # number of the piece, from 0
    again: bool  # whether it is the second of its piece
    after: float  # direction after it: 1 or −1
    share: float  # the place near it, as a share of the piece
    u: float  # the same in units of the abscissa, from the piece's begin
    velocity: float  # y' there
    acceleration: float  # y''
    jerk: float  # y'''
    at: float  # abscissa of the turn


def directions(piece: MotionPiece) -> Directions:
    """Return where a piece moves each way; by default that of a piece without duration."""
    if not piece.duration:
        return Directions()
    v = piece.curves[1](piece.duration * MIDDLES)
    each = [MIDDLES[way * v > 0.0] for way in (1.0, -1.0)]
    firsts = [float(places[0]) if places.size else NEVER for places in each]
    lasts = [float(places[-1]) if places.size else NOWHERE for places in each]
    return Directions(*firsts, *lasts)


def turns_of(pieces: Sequence[MotionPiece], moves: Sequence[Directions]) -> list[Turn]:
    """Return the turns inside pieces, in order; ``moves`` are the directions of each piece."""
    turns = []
    for number, (piece, each) in enumerate(zip(pieces, moves, strict=True)):
        for again, (share, after) in enumerate(each.turns):
            u = share * piece.duration
            v, a, j = (curve(u) for curve in piece.curves[1:])
            root = u - 2.0 * v / (a + after * math.sqrt(max(0.0, a**2 - 2.0 * j * v)))
            turns.append(Turn(number, bool(again), after, share, u, v, a, j, piece.begin + root))
    return turns
