"""One piece of a law: its acceleration a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ), and what that adds up to."""

from __future__ import annotations

import math
from typing import NamedTuple

SERIES = 0.7  # rad, below which h − sin h has lost digits


class Piece(NamedTuple):
    """Duration and coefficients of a(u), u from the begin of the piece."""

    duration: float
    c0: float = 0.0
    c1: float = 0.0
    c2: float = 0.0
    c3: float = 0.0
    amplitude: float = 0.0
    omega: float = 0.0
    phase: float = 0.0

    def scaled(self, factor: float) -> Piece:
        """Return the piece with its acceleration times ``factor``."""
        c0, c1, c2, c3, amplitude = (factor * c for c in self[1:6])
        return Piece(self.duration, c0, c1, c2, c3, amplitude, self.omega, self.phase)

    def gains(self, u: float) -> tuple[float, float]:
        """Return ∬a and ∫a from the begin to u.

        Of the sine, with h = ωu: ∫ = P u (sin φ sin h/h + cos φ (1 − cos h)/h),
        ∬ = P u² (sin φ (1 − cos h)/h² + cos φ (h − sin h)/h²).
        """
        _, c0, c1, c2, c3, amplitude, omega, phase = self
        s = u * u * (c0 / 2 + u * (c1 / 6 + u * (c2 / 12 + u * c3 / 20)))
        v = u * (c0 + u * (c1 / 2 + u * (c2 / 3 + u * c3 / 4)))
        if not amplitude:
            return s, v
        h = omega * u
        sinc, lift, lag = (math.sin(h) / h, 2 * (math.sin(h / 2) / h) ** 2, _lag(h)) if h else (1.0, 0.5, 0.0)
        sin, cos = math.sin(phase), math.cos(phase)
        return s + amplitude * u * u * (sin * lift + cos * lag), v + amplitude * u * (sin * sinc + cos * lift * h)

    def derivative(self, order: int, u: float) -> float:
        """Return a(u), or its derivative of an order up to 4."""
        _, c0, c1, c2, c3, amplitude, omega, phase = self
        polynomial = (
            c0 + u * (c1 + u * (c2 + u * c3)),
            c1 + u * (2 * c2 + u * 3 * c3),
            2 * c2 + 6 * c3 * u,
            6 * c3,
            0.0,
        )[order]
        if not amplitude:
            return polynomial
        angle = omega * u + phase
        turned = (math.sin(angle), math.cos(angle), -math.sin(angle), -math.cos(angle), math.sin(angle))[order]
        return polynomial + amplitude * omega**order * turned

    def zeros(self, order: int) -> list[float]:
        """Return where within the piece a, or its derivative of an order up to 2, changes its sign, rising.

        Between two zeros of the next derivative a function is monotone, and has one zero or none; those of the
        fourth derivative, P ω⁴ sin(ωu + φ), are known.
        """
        found: list[float] = []
        if self.amplitude and self.omega:
            turns = (self.phase, self.phase + self.omega * self.duration)
            first, last = math.ceil(min(turns) / math.pi), math.floor(max(turns) / math.pi)
            found = sorted((k * math.pi - self.phase) / self.omega for k in range(first, last + 1))
        for derivative in range(3, order - 1, -1):
            edges = [0.0, *found, self.duration]
            crossings = (self._crossing(derivative, *edges[i : i + 2]) for i in range(len(edges) - 1))
            found = [u for u in crossings if u is not None]
        return found

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
