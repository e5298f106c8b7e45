"""A law as a table of pieces: what is carried from piece to piece, and how an abscissa finds its piece.

The position on a piece is S0 + u (S1 + polynomial) − P/ω² sin(ωu + φ), its velocity S1 + polynomial −
P/ω cos(ωu + φ), of two sines less both: one formula each for every piece of every law.
"""

import math
from collections.abc import Sequence
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array, Law, stage_of
from engine.laws.piece import Piece


class Carried(NamedTuple):
    """A piece at its place in a law: its begin ξ_k, s_k and v_k there, and what s and v gain over it."""

    piece: Piece
    begin: float
    s: float
    v: float
    ds: float
    dv: float

    @property
    def amplitudes(self) -> list[tuple[float, float, float]]:
        """P/ω², P/ω and P ω of either sine, the amplitudes in position, velocity and jerk; 0 without a frequency."""
        p = self.piece
        return [
            (amplitude / omega**2, amplitude / omega, amplitude * omega)
            if omega > 0.0
            else (0.0, 0.0, amplitude * omega)
            for amplitude, omega in ((p.amplitude, p.omega), (p.amplitude2, p.omega2))
        ]

    @property
    def constants(self) -> tuple[float, float]:
        """S0 = s_k + P/ω² sin φ and S1 = v_k + P/ω cos φ, with those of both sines."""
        p, ((one, v, _), (other, w, _)) = self.piece, self.amplitudes
        return (
            self.s + one * math.sin(p.phase) + other * math.sin(p.phase2),
            self.v + v * math.cos(p.phase) + w * math.cos(p.phase2),
        )


def begins(pieces: Sequence[Piece]) -> list[float]:
    """Return ξ_k at which each piece begins, at most 1."""
    return [min(xi, 1.0) for xi in accumulate((piece.duration for piece in pieces[:-1]), initial=0.0)]


def carried(law: Law, pieces: Sequence[Piece]) -> list[Carried]:
    """Return the pieces of a law with s and v at their begins; these and the gains are by its closed form."""
    found = []
    for piece, begin in zip(pieces, begins(pieces), strict=True):
        at, end = law.evaluate(begin), law.evaluate(min(begin + piece.duration, 1.0))
        found.append(Carried(piece, begin, at.s, at.v, end.s - at.s, end.v - at.v))
    return found


class Located(NamedTuple):
    """Where abscissae lie among the pieces of a law: piece (from 0), u from its begin, ωu + φ of both sines (rad)."""

    piece: NDArray[np.intp]
    u: Array
    angle: Array
    angle2: Array


def located(pieces: Sequence[Piece], xi: Array) -> Located:
    """Return the piece of each ξ: the last that begins at or before it; ξ = 1 is in the last."""
    starts = np.array(begins(pieces))
    k = stage_of(xi, starts)
    u = xi - starts[k]
    rates = np.array([(piece.omega, piece.phase, piece.omega2, piece.phase2) for piece in pieces]).T
    omega, phi, omega2, phi2 = rates[:, k]
    return Located(k, u, omega * u + phi, omega2 * u + phi2)
