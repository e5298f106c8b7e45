"""How smooth a law is by itself: what jumps where its pieces meet, and against rest at its ends."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.family import Law
from engine.laws.piece import Piece, carried, gains

JUMP = 1e-9
"""of the law's C_v, of a and j of its C_a: a smaller jump is rounding"""
SMOOTH = 3
"""derivatives of s that are looked at: v, a and j"""
WORDS = ("position", "velocity", "acceleration", "jerk")
"""the highest derivative of s that is continuous, in words"""

Rates = tuple[float, ...]
"""v, a, j"""


class Meeting(NamedTuple):
    """The begin of a piece of a law, or of the rest behind it: rates there and at its end, and what jumps.

    ``angles`` are the ωd + φ of both sines at its end, after its duration d. ``before`` counts, from 1, the last piece
    before that lasts; 0 is rest. ``order`` is the highest derivative of s that is continuous there, up to
    3; of a piece that does not last, 3. ``outer`` tells the law's ends from what is between them.
    """

    duration: float
    angles: tuple[float, float]
    begin: Rates
    end: Rates
    before: int
    jump: Rates
    order: int
    outer: bool


def meetings(law: Law, pieces: Sequence[Piece]) -> tuple[Meeting, ...]:
    """Return where each of a law's pieces begins, and the rest behind the last one, which lasts 1."""
    found: list[Meeting] = []
    scales = law.coefficients.cv, law.coefficients.ca, law.coefficients.ca
    before, ended = 0, (0.0, 0.0, 0.0)
    for k, (piece, _, _, v, _, dv) in enumerate(carried((*pieces, Piece(1.0)), law.start.v), 1):
        behind, lasts = k > len(pieces), piece.duration > 0.0
        _, _, a, j = (x.tolist() for x in gains(np.array([0.0, piece.duration]), np.array(piece.row)[:, None]))
        begin, end = ((0.0,) * 3, (0.0,) * 3) if behind else ((v, a[0], j[0]), (v + dv, a[1], j[1]))
        jump = tuple(y - x for x, y in zip(ended, begin, strict=True)) if lasts else (0.0, 0.0, 0.0)
        jumps = (abs(size) > JUMP * scale for size, scale in zip(jump, scales, strict=True))
        order = next((n for n, jumped in enumerate(jumps) if jumped), SMOOTH)
        angles = piece.omega * piece.duration + piece.phase, piece.omega2 * piece.duration + piece.phase2
        outer = lasts and (behind or before == 0)
        found.append(Meeting(piece.duration, angles, begin, end, before, jump, order, outer))
        if lasts:
            before, ended = k, end
    return tuple(found)


def continuity(law: Law) -> tuple[int, int]:
    """Return the highest derivative of s that is continuous, up to 3: at the ends against rest, and between them."""
    found = meetings(law, law.as_pieces())
    ends, inside = (min([SMOOTH, *(one.order for one in found if one.outer == outer)]) for outer in (True, False))
    return ends, inside


def code(number: int, one: Meeting) -> int:
    """Return what tells law, end and order of a meeting in one number: 8 · number + 4 at an end + order."""
    return 8 * number + 4 * one.outer + one.order
