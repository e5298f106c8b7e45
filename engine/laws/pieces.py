"""The engineer's own law, piece by piece (OWN)."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, Coefficients, Law, stage_of
from engine.laws.entry import Claims, Entry, formulas
from engine.laws.piece import POWERS, SINES, Piece, gains, gains_of
from engine.laws.piece_extremes import coefficients_of

SUM_TOLERANCE = 1e-9


class Carried(NamedTuple):
    """Columns of the pieces: begin, s and v there, the powers in use, and P, ω, sin φ, cos φ of the sines in use."""

    table: Array
    powers: int


@dataclass(frozen=True)
class PieceLaw(Law):
    """A law given by its acceleration, piece by piece; s and v are carried on from s = v = 0.

    Whether the law ends at s = 1 and at rest is the engineer's affair: see ``end``.

    Parameters
    ----------
    pieces : sequence of Piece
        Their durations sum to 1 (within 1e-9).

    Raises
    ------
    ValueError
        For durations that do not.
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
    def _carried(self) -> Carried:
        rows = np.array([p.row for p in self.pieces]).T
        durations = np.array([p.duration for p in self.pieces])
        ds, dv, _, _ = gains(durations, rows)
        starts, v = _before(durations), _before(dv)
        powers = max((i + 1 for i in range(POWERS) if rows[i].any()), default=0)
        sines = [rows[k : k + 4] for k in SINES if rows[k].any()]
        return Carried(np.vstack([starts, _before(ds + v * durations), v, rows[:powers], *sines]), powers)

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        table, powers = self._carried
        start, s0, v0, *row = table[:, :1] if table.shape[1] == 1 else table.take(stage_of(xi, table[0]), axis=1)
        u = xi - start
        s, v, a, j = gains_of(u, row[:powers], [row[k : k + 4] for k in range(powers, len(row), 4)])
        return s0 + v0 * u + s, v0 + v, a, j

    def _coefficients(self) -> Coefficients:
        return coefficients_of(self.pieces)

    @property
    def breaks(self) -> tuple[float, ...]:
        """The ends of all pieces but the last."""
        return tuple(accumulate(piece.duration for piece in self.pieces[:-1]))

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces as they are given."""
        return self.pieces

    def shapes(self) -> None:
        """Return None: the pieces may be of any shape."""


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
        coefficients=formulas(
            "cv = 15/8; ca_max = 10/sqrt(3); ca_min = -ca_max; ca_rms = sqrt(120/7); cj = 60; "
            "va_max = 225/8*(6/7)**3/sqrt(7); va_min = -va_max"
        ),
    ),
    example=lambda: PieceLaw(POLYNOMIAL_345),
    others=(PieceLaw(MIXED),),
)
