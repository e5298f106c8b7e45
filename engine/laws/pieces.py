"""The engineer's own law (OWN): pieces of polynomial and sine, carried on from one to the next."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf, sqrt
from typing import ClassVar

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial
from numpy.polynomial.legendre import leggauss

from engine.laws.base import BREAK_TOLERANCE, Array, Coefficients, Law

JUMP = 1e-9  # a step of acceleration that counts as a jump


@dataclass(frozen=True)
class Piece:
    """One piece: a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ), with u from the piece's begin.

    Raises ValueError for a negative duration, or a sine without ω.
    """

    duration: float
    c: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    amplitude: float = 0.0
    omega: float = 0.0
    phase: float = 0.0

    def __post_init__(self) -> None:
        if not self.duration >= 0:
            raise ValueError(f"own law: expected durations of at least 0, found {self.duration:g}")
        if self.amplitude and not self.omega > 0:
            raise ValueError(f"own law: expected ω > 0 for a sine, found {self.omega:g}")

    def kinematics(self, u: Array, s: float, v: float) -> tuple[Array, Array, Array, Array]:
        """Return s, v, a, j at ``u`` for a piece that begins at position ``s`` with velocity ``v``."""
        a = Polynomial(self.c)
        dv, ds = a.integ(1), a.integ(2)
        if not self.amplitude:
            return s + v * u + ds(u), v + dv(u), a(u), a.deriv()(u)
        p, w, phi = self.amplitude, self.omega, self.phase
        sine, cosine = np.sin(w * u + phi), np.cos(w * u + phi)
        slope = v + p / w * np.cos(phi)
        return (
            s + slope * u + ds(u) - p / w**2 * (sine - np.sin(phi)),
            slope + dv(u) - p / w * cosine,
            a(u) + p * sine,
            a.deriv()(u) + p * w * cosine,
        )


class PieceLaw(Law):
    """A law given by its acceleration, piece by piece; position and velocity start at 0 and are carried on.

    Nothing makes such a law end at s = 1 or at rest: ``end`` tells. Raises ValueError unless the durations
    sum to 1 within 1e-9.
    """

    code: ClassVar[str] = "OWN"
    name: ClassVar[str] = "Own law"

    def __init__(self, pieces: Sequence[Piece]) -> None:
        total = sum(p.duration for p in pieces)
        if abs(total - 1) > 1e-9:
            raise ValueError(f"own law: expected durations that sum to 1, found {total:.10g}")
        self.pieces = tuple(p for p in pieces if p.duration > 0)
        self.begins = np.concatenate([[0.0], np.cumsum([p.duration for p in self.pieces])[:-1]])
        self.carried = [(0.0, 0.0)]
        for piece in self.pieces[:-1]:
            s, v, _, _ = piece.kinematics(np.array([piece.duration]), *self.carried[-1])
            self.carried.append((float(s[0]), float(v[0])))

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        last = np.minimum(xi + BREAK_TOLERANCE, 1 - BREAK_TOLERANCE)
        found = np.searchsorted(self.begins, last, side="right") - 1
        out = np.empty((4, xi.size))
        for k in np.unique(found):
            here = found == k
            out[:, here] = self.pieces[k].kinematics(xi[here] - self.begins[k], *self.carried[k])
        return out[0], out[1], out[2], out[3]

    def _coefficients(self) -> Coefficients:
        v, a, j, va = (self._extremes(pick) for pick in (_velocity, _acceleration, _jerk, _power))
        return Coefficients(
            cv=max(v[1], -v[0]),
            ca_max=a[1],
            ca_min=a[0],
            ca_rms=self._rms(),
            cj=inf if self._jumps() else max(j[1], -j[0]),
            va_max=va[1],
            va_min=va[0],
        )

    def _extremes(self, pick: Callable[[tuple[Array, Array, Array, Array]], Array]) -> tuple[float, float]:
        """Return the lowest and the largest value: at the ends of pieces, or where the slope vanishes."""
        low, high = inf, -inf
        for piece, carried in zip(self.pieces, self.carried, strict=True):
            degree = 32 + int(8 * piece.omega * piece.duration) if piece.amplitude else 12
            fitted = Chebyshev.interpolate(
                lambda u, p=piece, c=carried: pick(p.kinematics(u, *c)), degree, domain=[0, piece.duration]
            )
            roots = fitted.deriv().roots()
            inner = roots.real[np.abs(roots.imag) < 1e-6]
            at = np.concatenate([[0.0, piece.duration], np.clip(inner, 0.0, piece.duration)])
            values = pick(piece.kinematics(at, *carried))
            low, high = min(low, float(values.min())), max(high, float(values.max()))
        return low, high

    def _rms(self) -> float:
        total = 0.0
        for piece in self.pieces:
            nodes, weights = leggauss(16 + int(4 * piece.omega * piece.duration))
            a = piece.kinematics(piece.duration * (nodes + 1) / 2, 0.0, 0.0)[2]
            total += piece.duration / 2 * float(weights @ a**2)
        return sqrt(total)

    def _jumps(self) -> bool:
        """Whether the acceleration jumps, between pieces or against rest at the ends."""
        reached = 0.0
        for piece in self.pieces:
            ends = piece.kinematics(np.array([0.0, piece.duration]), 0.0, 0.0)[2]
            if abs(ends[0] - reached) > JUMP:
                return True
            reached = float(ends[1])
        return abs(reached) > JUMP


def _velocity(k: tuple[Array, Array, Array, Array]) -> Array:
    return k[1]


def _acceleration(k: tuple[Array, Array, Array, Array]) -> Array:
    return k[2]


def _jerk(k: tuple[Array, Array, Array, Array]) -> Array:
    return k[3]


def _power(k: tuple[Array, Array, Array, Array]) -> Array:
    return k[1] * k[2]
