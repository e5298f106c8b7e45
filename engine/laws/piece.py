"""One piece of the engineer's own law, a(u) = polynomial + P sin(ωu + φ), and its integrals."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from engine.laws.base import Array, require_finite


@dataclass(frozen=True)
class Piece:
    """a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ) over a duration, u from its begin.

    ``amplitude`` is P, ``omega`` ω, ``phase`` φ in rad. Raises ValueError for a negative duration, for
    coefficients that are not four, and for what is not finite.
    """

    duration: float
    c: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    amplitude: float = 0.0
    omega: float = 0.0
    phase: float = 0.0

    def __post_init__(self) -> None:
        if len(self.c) != 4:
            raise ValueError(f"{len(self.c)} coefficients of the polynomial are given; expected c0, c1, c2, c3")
        require_finite(duration=self.duration, amplitude=self.amplitude, omega=self.omega, phase=self.phase)
        require_finite(**{f"c{i}": c for i, c in enumerate(self.c)})
        if self.duration < 0.0:
            raise ValueError(f"the duration of a piece is {self.duration:g}; expected 0 or more")
        object.__setattr__(self, "c", tuple(float(c) for c in self.c))

    @property
    def row(self) -> tuple[float, ...]:
        """c0, c1, c2, c3, P, ω, sin φ, cos φ: what :func:`gains` needs."""
        return (*self.c, self.amplitude, self.omega, math.sin(self.phase), math.cos(self.phase))


def gains(u: Array, row: Array) -> tuple[Array, Array, Array, Array]:
    """Return ∬a, ∫a, a and da/du of pieces from their begin to u; ``row`` is :attr:`Piece.row`, in columns.

    With h = ωu/2 and m, n the sine and cosine of φ + h, the integrals of the sine are
    ∫ = u m sin h/h and ∬ = u² (sin φ (sin h/h)²/2 + cos φ (2h − sin 2h)/(2h)²): right for ω = 0 too.
    """
    c0, c1, c2, c3, p, w, sin_phi, cos_phi = row
    h = w * u / 2.0
    sin, cos = np.sin(h), np.cos(h)
    m, n = sin_phi * cos + cos_phi * sin, cos_phi * cos - sin_phi * sin
    sinc = np.divide(sin, h, out=np.ones_like(h), where=h != 0.0)
    s = u * u * (c0 / 2 + u * (c1 / 6 + u * (c2 / 12 + u * (c3 / 20))))
    v = u * (c0 + u * (c1 / 2 + u * (c2 / 3 + u * (c3 / 4))))
    a = c0 + u * (c1 + u * (c2 + u * c3))
    j = c1 + u * (2 * c2 + u * 3 * c3)
    return (
        s + p * u * u * (sin_phi * sinc * sinc / 2.0 + cos_phi * lag(h, sin, cos)),
        v + p * u * m * sinc,
        a + p * (m * cos + n * sin),
        j + p * w * (n * cos - m * sin),
    )


def lag(h: Array, sin: Array, cos: Array) -> Array:
    """Return (2h − sin 2h)/(2h)²; by its series where the difference would lose digits."""
    y = 4.0 * h * h
    series = h / 3.0
    term = np.ones_like(h)
    for divisor in (210.0, 156.0, 110.0, 72.0, 42.0, 20.0):
        term = 1.0 - y / divisor * term
    small = y < 1.0
    direct = np.divide(h - sin * cos, 2.0 * h * h, out=np.zeros_like(h), where=~small)
    return np.where(small, series * term, direct)
