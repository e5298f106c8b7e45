"""Where v, a, j and v·a of one piece a(u) = polynomial + P sin(ωu + φ) are stationary."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.polynomial import Polynomial

from engine.laws.base import Array
from engine.laws.crossings import narrowed
from engine.laws.piece import Piece, gains

CELLS = 512  # at least, in which a piece is searched for changes of sign
ROUNDS = 4  # of narrowing a cell: a stationary value is then right to the last digit
NEGLIGIBLE = 1e-12  # a leading coefficient, against the largest, that would only spoil the roots


def stationary(piece: Piece, v0: float) -> list[float]:
    """Return abscissae within the piece, entered with velocity ``v0``, where v, a, j or v·a is stationary.

    Found by changes of sign, refined by narrowing; of a polynomial also the roots, as two of them may
    lie too near to each other to change a sign between samples. In no order.
    """
    found = _searched(piece, v0)
    if not (piece.amplitude and piece.omega):
        found += _polynomial(piece, v0)
    return [u for u in found if 0.0 < u < piece.duration]


def _searched(piece: Piece, v0: float) -> list[float]:
    row = np.array(piece.row)[:, None]

    def acceleration(u: Array) -> Array:
        return gains(u, row)[2]

    def jerk(u: Array) -> Array:
        return gains(u, row)[3]

    def snap(u: Array) -> Array:
        sine = np.sin(piece.omega * u + piece.phase)
        return 2.0 * piece.c[2] + 6.0 * piece.c[3] * u - piece.amplitude * piece.omega**2 * sine

    def power_slope(u: Array) -> Array:
        _, v, a, j = gains(u, row)
        return a * a + (v0 + v) * j

    cells = CELLS + int(abs(piece.omega) * piece.duration * 16.0)
    grid = np.linspace(0.0, piece.duration, cells + 1)
    return [u for f in (acceleration, jerk, snap, power_slope) for u in _roots(f, grid)]


def _roots(f: Callable[[Array], Array], grid: Array) -> list[float]:
    """Return where f changes sign between the points of a grid."""
    positive = f(grid) >= 0.0
    cells = np.flatnonzero(positive[1:] != positive[:-1])
    return [float(u) for u in narrowed(lambda u: f(u) >= 0.0, grid[cells], grid[cells + 1], ROUNDS)]


def _polynomial(piece: Piece, v0: float) -> list[float]:
    d = piece.duration
    constant = piece.c[0] + piece.amplitude * math.sin(piece.phase)
    a = Polynomial([c * d**i for i, c in enumerate((constant, *piece.c[1:]))])  # of u/d
    v = d * a.integ() + v0
    found: list[float] = []
    for f in (a, a.deriv(), a.deriv(2), (v * a).deriv()):
        roots = f.trim(NEGLIGIBLE * float(np.abs(f.coef).max())).roots()
        found += [d * float(root.real) for root in roots]  # a split double root keeps its real part
    return found
