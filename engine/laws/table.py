"""A law as a table of pieces: what is carried from piece to piece, and how an abscissa finds its piece.

The position on a piece is S0 + u (S1 + polynomial) − P/ω² sin(ωu + φ), its velocity S1 + polynomial −
P/ω cos(ωu + φ): one formula each for every piece of every law.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array, Law, stage_of
from engine.laws.piece import Piece


@dataclass(frozen=True)
class Carried:
    """A piece at its place in a law: its begin ξ_k, s_k and v_k there, and what s and v gain over it."""

    piece: Piece
    begin: float
    s: float
    v: float
    ds: float
    dv: float

    @property
    def position_sine(self) -> float:
        """P/ω², the amplitude of the position's sine; 0 without a frequency."""
        return self.piece.amplitude / self.piece.omega**2 if self.piece.omega > 0.0 else 0.0

    @property
    def velocity_cosine(self) -> float:
        """P/ω, the amplitude of the velocity's cosine; 0 without a frequency."""
        return self.piece.amplitude / self.piece.omega if self.piece.omega > 0.0 else 0.0

    @property
    def position_constant(self) -> float:
        """S0 = s_k + P/ω² sin φ."""
        return self.s + self.position_sine * math.sin(self.piece.phase)

    @property
    def position_slope(self) -> float:
        """S1 = v_k + P/ω cos φ."""
        return self.v + self.velocity_cosine * math.cos(self.piece.phase)


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


class Place(NamedTuple):
    """Where abscissae lie among the pieces of a law: piece (from 0), u from its begin, and the angle ωu + φ (rad)."""

    piece: NDArray[np.intp]
    u: Array
    angle: Array


def located(pieces: Sequence[Piece], xi: Array) -> Place:
    """Return the piece of each ξ: the last that begins at or before it; ξ = 1 is in the last."""
    starts = np.array(begins(pieces))
    k = stage_of(xi, starts)
    u = xi - starts[k]
    omega, phi = np.array([(piece.omega, piece.phase) for piece in pieces]).T
    return Place(k, u, omega[k] * u + phi[k])


def key(number: int, xi: float) -> float:
    """Return 2 · number + ξ, by which the pieces of all laws, numbered from 1, stand in one rising order."""
    return 2.0 * number + xi
