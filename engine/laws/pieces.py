"""The engineer's own law, piece by piece (OWN)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.laws.base import Array, Claims, Coefficients, Entry, Law, require_finite, stage_of
from engine.laws.pieces_extremes import stationary

SUM_TOLERANCE = 1e-9
JUMP = 1e-9  # of the largest acceleration: a smaller jump is rounding
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


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
        """Check what was given."""
        if len(self.c) != 4:
            raise ValueError(
                f"{len(self.c)} coefficients of the polynomial are given; expected c0, c1, c2, c3"
            )
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
            raise ValueError(
                f"the durations of the {len(self.pieces)} pieces sum to {total:.12g}; expected 1"
            )

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

    def _extremes(self, k: int) -> tuple[Array, Array, Array]:
        """Return v, a, j at the begin of a piece, where v, a, j or v·a is stationary, and at its end."""
        piece, v0 = self.pieces[k], float(self._carried[2][k])
        inner = stationary(piece.c, piece.amplitude, piece.omega, piece.phase, piece.duration, v0)
        u = np.array([0.0, *sorted(inner), piece.duration])
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

ENTRY = Entry(
    law=PieceLaw,
    aliases=("own", "pieces"),
    source="own law of the engineer; the example is the polynomial 3-4-5",
    claims=Claims(
        order_ends=2,
        order_inside=math.inf,
        where={"x": "sqrt(3/7 - 4*sqrt(2)/21)"},  # 2ξ − 1, negative, where v·a is greatest
        coefficients={
            "cv": "15/8",
            "ca_max": "10/sqrt(3)",
            "ca_min": "-ca_max",
            "ca_rms": "sqrt(120/7)",
            "cj": "60",
            "va_max": "225/4*x*(1 - x**2)**3",
            "va_min": "-va_max",
        },
    ),
    example=lambda: PieceLaw(POLYNOMIAL_345),
)
