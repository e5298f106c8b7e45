"""What a table of an own law works out of its pieces: accelerations at their ends, and jumps."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from numpy.polynomial import Polynomial

from engine.laws.piece import Piece


class Ends(NamedTuple):
    """The acceleration at both ends of a piece; what the pieces so far have reached; the jump from there."""

    begin: float
    end: float
    reached: float
    jump: float


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


def _acceleration(piece: Piece, u: float) -> float:
    return float(Polynomial(piece.c)(u)) + piece.amplitude * math.sin(piece.omega * u + piece.phase)
