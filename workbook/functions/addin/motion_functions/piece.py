"""One piece of a law: its acceleration, a polynomial and up to two sines, and what that adds up to."""

from __future__ import annotations

import math
from typing import NamedTuple

SERIES = 0.7  # rad, below which h − sin h has lost digits
GRID = 256  # parts of a piece of two sines: where its derivatives change sign is looked for in each


class Piece(NamedTuple):
    """Duration and coefficients of a(u) = c0 + c1 u + … + c5 u⁵ + P sin(ωu + φ) + P₂ sin(ω₂u + φ₂)."""

    duration: float
    c0: float = 0.0
    c1: float = 0.0
    c2: float = 0.0
    c3: float = 0.0
    amplitude: float = 0.0
    omega: float = 0.0
    phase: float = 0.0
    c4: float = 0.0
    c5: float = 0.0
    amplitude2: float = 0.0
    omega2: float = 0.0
    phase2: float = 0.0

    @property
    def powers(self) -> tuple[float, ...]:
        """c0 … c5."""
        return (self.c0, self.c1, self.c2, self.c3, self.c4, self.c5)

    @property
    def sines(self) -> list[tuple[float, float, float]]:
        """P, ω, φ of each sine that is there."""
        both = (self.amplitude, self.omega, self.phase), (self.amplitude2, self.omega2, self.phase2)
        return [sine for sine in both if sine[0]]

    @property
    def turned(self) -> float:
        """How far the faster sine turns (rad)."""
        return self.duration * max(abs(self.omega), abs(self.omega2))

    def scaled(self, factor: float) -> Piece:
        """Return the piece with its acceleration times ``factor``."""
        c = {f"c{i}": factor * value for i, value in enumerate(self.powers)}
        return self._replace(amplitude=factor * self.amplitude, amplitude2=factor * self.amplitude2, **c)

    def gains(self, u: float) -> tuple[float, float]:
        """Return ∬a and ∫a from the begin to u.

        Of a sine, with h = ωu: ∫ = P u (sin φ sin h/h + cos φ (1 − cos h)/h),
        ∬ = P u² (sin φ (1 − cos h)/h² + cos φ (h − sin h)/h²).
        """
        s = v = 0.0
        for i in range(5, -1, -1):
            s = s * u + self.powers[i] / ((i + 1) * (i + 2))
            v = v * u + self.powers[i] / (i + 1)
        s, v = u * u * s, u * v
        for amplitude, omega, phase in self.sines:
            h = omega * u
            sinc, lift, lag = (math.sin(h) / h, 2 * (math.sin(h / 2) / h) ** 2, _lag(h)) if h else (1.0, 0.5, 0.0)
            sin, cos = math.sin(phase), math.cos(phase)
            s += amplitude * u * u * (sin * lift + cos * lag)
            v += amplitude * u * (sin * sinc + cos * lift * h)
        return s, v

    def derivative(self, order: int, u: float) -> float:
        """Return a(u), or its derivative of an order."""
        found = 0.0
        for i in range(5, order - 1, -1):
            found = found * u + self.powers[i] * math.factorial(i) / math.factorial(i - order)
        for amplitude, omega, phase in self.sines:
            angle = omega * u + phase
            turned = (math.sin(angle), math.cos(angle), -math.sin(angle), -math.cos(angle))[order % 4]
            found += amplitude * omega**order * turned
        return found

    def zeros(self, order: int) -> list[float]:
        """Return where within the piece a, or its derivative of an order, changes its sign, rising.

        Between two zeros of the next derivative a function is monotone, and has one zero or none; those of the
        sixth derivative, −P ω⁶ sin(ωu + φ), are known.
        """
        if len(self.sines) > 1:
            return self._crossings(order, [k * self.duration / GRID for k in range(1, GRID)])
        found: list[float] = []
        for _, omega, phase in self.sines:
            turns = (phase, phase + omega * self.duration)
            first, last = math.ceil(min(turns) / math.pi), math.floor(max(turns) / math.pi)
            found = sorted((k * math.pi - phase) / omega for k in range(first, last + 1)) if omega else []
        for derivative in range(5, order - 1, -1):
            found = self._crossings(derivative, found)
        return found

    def _crossings(self, order: int, inner: list[float]) -> list[float]:
        """Return where a derivative changes its sign, at most once between two neighbours of these."""
        edges = [0.0, *inner, self.duration]
        crossings = (self._crossing(order, *edges[i : i + 2]) for i in range(len(edges) - 1))
        return [u for u in crossings if u is not None]

    def _crossing(self, order: int, low: float, high: float) -> float | None:
        """Return the one change of sign between two abscissae, by halving, if there is one."""
        above = self.derivative(order, low) > 0.0
        if (self.derivative(order, high) > 0.0) == above:
            return None
        for _ in range(60):
            middle = (low + high) / 2
            if (self.derivative(order, middle) > 0.0) == above:
                low = middle
            else:
                high = middle
        return (low + high) / 2


def _lag(h: float) -> float:
    """Return (h − sin h)/h², by its series where the difference would lose digits."""
    if abs(h) > SERIES:
        return (h - math.sin(h)) / (h * h)
    term, total = h / 6, h / 6
    for k in range(4, 16, 2):
        term *= -h * h / (k * (k + 1))
        total += term
    return total
