"""The engineer's own law, piece by piece (OWN)."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.laws.base import Array, Coefficients, Law, stage_of
from engine.laws.piece import POWERS, SINES, Piece, gains, gains_of
from engine.laws.piece_extremes import coefficients_of

SUM_TOLERANCE = 1e-9
POLYNOMIAL_345 = (Piece(1.0, (0.0, 60.0, -180.0, 120.0)),)


@dataclass(frozen=True)
class PieceLaw(Law):
    """A law given by its acceleration, piece by piece; s and v are carried on from s = v = 0.

    Whether the law ends at s = 1 and at rest is the engineer's affair: see ``end``.

    Parameters
    ----------
    pieces : sequence of Piece
        Their durations sum to 1 (within 1e-9); by default the polynomial 3-4-5.

    Raises
    ------
    ValueError
        For durations that do not.
    """

    code = "OWN"
    name = "Own law"
    aliases = ("own", "pieces")
    source = "own law of the engineer; the example is the polynomial 3-4-5"

    pieces: tuple[Piece, ...]

    def __init__(self, pieces: Sequence[Piece] = POLYNOMIAL_345) -> None:
        object.__setattr__(self, "pieces", tuple(pieces))
        total = sum(p.duration for p in self.pieces)
        if abs(total - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the durations of the {len(self.pieces)} pieces sum to {total:.12g}; expected 1")

    @cached_property
    def _carried(self) -> tuple[Array, int]:
        """Columns of begin, s, v, the powers in use, and P, ω, sin φ, cos φ of the sines in use; how many powers."""
        rows = np.array([p.row for p in self.pieces]).T
        durations = np.array([p.duration for p in self.pieces])
        ds, dv, _, _ = gains(durations, rows)
        starts, v = _before(durations), _before(dv)
        powers = max((i + 1 for i in range(POWERS) if rows[i].any()), default=0)
        sines = [rows[k : k + 4] for k in SINES if rows[k].any()]
        return np.vstack([starts, _before(ds + v * durations), v, rows[:powers], *sines]), powers

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        table, powers = self._carried
        start, s0, v0, *row = table[:, :1] if table.shape[1] == 1 else table.take(stage_of(xi, table[0]), axis=1)
        u = xi - start
        s, v, a, j = gains_of(u, row[:powers], [row[k : k + 4] for k in range(powers, len(row), 4)])
        return s0 + v0 * u + s, v0 + v, a, j

    def _coefficients(self) -> Coefficients:
        return coefficients_of(self.pieces)

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces as they are given."""
        return self.pieces


def _before(gained: Array) -> Array:
    """Return the sum of what was gained before each piece."""
    return np.concatenate([[0.0], np.cumsum(gained)[:-1]])
