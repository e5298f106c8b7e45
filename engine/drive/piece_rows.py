"""Pieces of motions side by side: values of many of them by one call of NumPy each."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import perm, pi
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.motion.pieces import MotionPiece


@dataclass(frozen=True)
class Rows:
    """The powers of u in each piece, a row a power, and its sines A sin(ωu + φ): A, ω and φ, a row each."""

    powers: Array
    sines: tuple[Array, ...]

    def at(self, u: Array, order: int) -> Array:
        """Return a derivative of y at places, which have the shape of these, or one that goes with it."""
        value = np.zeros(u.shape)
        for n in range(len(self.powers) - 1, order - 1, -1):
            value = value * u + perm(n, order) * self.powers[n]
        for a, w, phi in self.sines:
            value = value + a * w**order * np.sin(w * u + (phi + order * pi / 2.0))
        return value

    def taken(self, index: Any) -> "Rows":
        """Return the pieces at places among them."""
        return Rows(self.powers[:, index], tuple(sine[:, index] for sine in self.sines))

    def over(self, axes: int) -> "Rows":
        """Return the same for places in an array of so many axes, a piece along the first."""
        shape = (-1, *([1] * (axes - 1)))
        return Rows(
            np.array([one.reshape(shape) for one in self.powers]),
            tuple(np.array([one.reshape(shape) for one in sine]) for sine in self.sines),
        )


def rows_of(pieces: Sequence[MotionPiece]) -> Rows:
    """Return pieces side by side."""
    degree = max(len(piece.c) for piece in pieces)
    powers = np.array([(*piece.c, *([0.0] * (degree - len(piece.c)))) for piece in pieces]).T
    sines = [[sine for sine in piece.sines if sine[0]] for piece in pieces]
    most = max(map(len, sines))
    filled = [[*found, *([(0.0, 1.0, 0.0)] * (most - len(found)))] for found in sines]
    return Rows(powers, tuple(np.array([found[k] for found in filled]).T for k in range(most)))
