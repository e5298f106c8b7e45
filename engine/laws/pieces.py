"""The engineer's own law, piece by piece (OWN)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate

import numpy as np

from engine.laws.base import Array, Coefficients, Law, stage_of
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece, gains
from engine.laws.piece_extremes import stationary

SUM_TOLERANCE = 1e-9
JUMP = 1e-9  # of the largest acceleration: a smaller jump is rounding
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


@dataclass(frozen=True)
class PieceLaw(Law):
    """A law given by its acceleration, piece by piece; s and v are carried on from s = v = 0.

    The durations sum to 1 (within 1e-9), else ValueError. Whether the law ends at s = 1 and at rest is
    the engineer's affair: see ``end``.
    """

    code = "OWN"
    name = "Own law"

    pieces: tuple[Piece, ...]

    def __init__(self, pieces: Sequence[Piece]) -> None:
        object.__setattr__(self, "pieces", tuple(pieces))
        total = sum(p.duration for p in self.pieces)
        if abs(total - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the durations of the {len(self.pieces)} pieces sum to {total:.12g}; expected 1")

    @cached_property
    def _carried(self) -> tuple[Array, Array, Array, Array]:
        """Begin, position and velocity at the begin, and coefficients of each piece."""
        rows = np.array([p.row for p in self.pieces]).T
        durations = np.array([p.duration for p in self.pieces])
        ds, dv, _, _ = gains(durations, rows)
        starts, v = _before(durations), _before(dv)
        return starts, _before(ds + v * durations), v, rows

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        starts, s0, v0, rows = self._carried
        k = stage_of(xi, starts)
        u = xi - starts.take(k)
        s, v, a, j = gains(u, rows.take(k, axis=1))
        begin = v0.take(k)
        return s0.take(k) + begin * u + s, begin + v, a, j

    def _coefficients(self) -> Coefficients:
        found = [self._extremes(k) for k, p in enumerate(self.pieces) if p.duration > 0.0]
        v, a, j = (np.concatenate([values[i] for values in found]) for i in range(3))
        return Coefficients(
            cv=float(np.abs(v).max()),
            ca_max=float(a.max()),
            ca_min=float(a.min()),
            ca_rms=self._rms(),
            cj=math.inf if self._jumps([values[1] for values in found]) else float(np.abs(j).max()),
            va_max=float((v * a).max()),
            va_min=float((v * a).min()),
        )

    @property
    def breaks(self) -> tuple[float, ...]:
        """The ends of all pieces but the last."""
        return tuple(accumulate(piece.duration for piece in self.pieces[:-1]))

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces as they are given."""
        return self.pieces

    def shapes(self) -> None:
        """Return None: the pieces may be of any shape."""

    def _extremes(self, k: int) -> tuple[Array, Array, Array]:
        """Return v, a, j at the begin of a piece, where v, a, j or v·a is stationary, and at its end."""
        piece, v0 = self.pieces[k], float(self._carried[2][k])
        u = np.array([0.0, *stationary(piece, v0), piece.duration])
        _, v, a, j = gains(u, np.array(piece.row)[:, None])
        return v0 + v, a, j

    @staticmethod
    def _jumps(accelerations: list[Array]) -> bool:
        """Whether a jumps between pieces that last, or at the ends against rest."""
        before = [0.0, *(float(a[-1]) for a in accelerations)]
        after = [*(float(a[0]) for a in accelerations), 0.0]
        largest = max(float(np.abs(a).max()) for a in accelerations)
        return max(abs(x - y) for x, y in zip(before, after, strict=True)) > JUMP * largest

    def _rms(self) -> float:
        """Return sqrt(∫a²) by Gauss-Legendre, exact for the polynomial, on at most half a turn of ωu."""
        square = 0.0
        for piece in self.pieces:
            parts = 1 + int(abs(piece.omega) * piece.duration / math.pi)
            width = piece.duration / parts
            u = (np.arange(parts)[:, None] + (NODES + 1.0) / 2.0).ravel() * width
            a = gains(u, np.array(piece.row)[:, None])[2]
            square += float(np.tile(WEIGHTS, parts) @ (a * a)) * width / 2.0
        return math.sqrt(square)


def _before(gained: Array) -> Array:
    """Return the sum of what was gained before each piece."""
    return np.concatenate([[0.0], np.cumsum(gained)[:-1]])


POLYNOMIAL_345 = (Piece(1.0, (0.0, 60.0, -180.0, 120.0)),)
MIXED = (
    Piece(0.3, amplitude=6.0, omega=5.0),
    Piece(0.0, (9.0, 0.0, 0.0, 0.0)),
    Piece(0.2, (6.0, -30.0, 2.0, 0.0), amplitude=1.0, omega=9.0, phase=0.4),
    Piece(0.5, (-4.0, 8.0, 0.0, 0.0)),
)
"""a polynomial and a sine in one piece, a piece of no duration; it ends neither at 1 nor at rest"""

ENTRY = Entry(
    law=PieceLaw,
    aliases=("own", "pieces"),
    source="own law of the engineer; the example is the polynomial 3-4-5",
    claims=Claims(
        order_ends=2,
        order_inside=math.inf,
        coefficients={
            "cv": "15/8",
            "ca_max": "10/sqrt(3)",
            "ca_min": "-ca_max",
            "ca_rms": "sqrt(120/7)",
            "cj": "60",
            "va_max": "225/8*(6/7)**3/sqrt(7)",
            "va_min": "-va_max",
        },
    ),
    example=lambda: PieceLaw(POLYNOMIAL_345),
    others=(PieceLaw(MIXED),),
)
