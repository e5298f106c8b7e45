"""Pieces made of pieces: scaled to another height and time, told backwards, turned upside down."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import replace

from engine.laws.piece import Piece


def scaled_piece(piece: Piece, height: float, time: float) -> Piece:
    """Return a piece with its accelerations times ``height`` and its duration times ``time``.

    c_i becomes height c_i/timeⁱ, P height P, ω ω/time; φ stays. Raises ValueError unless the time is positive.
    """
    if not time > 0.0:
        raise ValueError(f"the time is {time:g}; expected more than 0")
    return replace(
        piece,
        duration=piece.duration * time,
        c=tuple(height * c / time**i for i, c in enumerate(piece.c)),
        amplitude=height * piece.amplitude,
        omega=piece.omega / time,
        amplitude2=height * piece.amplitude2,
        omega2=piece.omega2 / time,
    )


def cut(piece: Piece, shares: Sequence[float]) -> list[Piece]:
    """Return the parts of a piece between these shares of its duration, each with its own u.

    c'_i = Σ_{k ≥ i} c_k C(k, i) u₀ᵏ⁻ⁱ, φ' = φ + ω u₀ from the begin u₀ of a part.
    """
    edges = [0.0, *(share * piece.duration for share in shares), piece.duration]
    return [
        replace(
            piece,
            duration=end - begin,
            c=tuple(_shifted(piece.c, i, begin) for i in range(len(piece.c))),
            phase=piece.phase + piece.omega * begin,
            phase2=piece.phase2 + piece.omega2 * begin,
        )
        for begin, end in itertools.pairwise(edges)
    ]


def backwards(piece: Piece) -> Piece:
    """Return a piece with the acceleration a'(u) = −a(d − u): a rise told from its end is a rise.

    c'_i = −(−1)ⁱ Σ_{k ≥ i} c_k C(k, i) dᵏ⁻ⁱ, P' = P, ω' = ω, φ' = −(ωd + φ).
    """
    d = piece.duration
    return replace(
        piece,
        c=tuple(-((-1.0) ** i) * _shifted(piece.c, i, d) for i in range(len(piece.c))),
        phase=-(piece.omega * d + piece.phase),
        phase2=-(piece.omega2 * d + piece.phase2),
    )


def _shifted(c: Sequence[float], i: int, d: float) -> float:
    return sum(c[k] * math.comb(k, i) * d ** (k - i) for k in range(i, len(c)))


def reversed_pieces(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Return the pieces of the same movement told backwards: rest to velocity for velocity to rest."""
    return tuple(map(backwards, reversed(pieces)))
