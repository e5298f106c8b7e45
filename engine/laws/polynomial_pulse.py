"""Pulses that are polynomials: the halves of symmetric polynomial laws."""

import math
from dataclasses import dataclass
from functools import cached_property

from engine.laws.ladder import Curve, zeros
from engine.laws.piece import Piece
from engine.laws.piece_rules import backwards
from engine.laws.pulse import Pulse


@dataclass(frozen=True)
class PolynomialPulse(Pulse):
    """P(x) = Σ c_i xⁱ, which is of peak 1 and nowhere negative: the half of a symmetric polynomial law."""

    c: tuple[float, ...]

    @cached_property
    def _acceleration(self) -> Curve:
        return Curve(self.c)

    @cached_property
    def _velocity(self) -> Curve:
        return self._acceleration.integral(0.0)

    @property
    def gain(self) -> float:
        """W = Σ c_i/(i + 1)."""
        return self._velocity(1.0)

    @property
    def lead(self) -> float:
        """κ = Σ c_i/((i + 1)(i + 2))/w."""
        return self._velocity.integral(0.0)(1.0) / self.gain

    @property
    def square(self) -> float:
        """Q = ΣΣ c_i c_k/(i + k + 1)."""
        return self._acceleration.times(self._acceleration).integral(0.0)(1.0)

    @cached_property
    def power(self) -> float:
        """Greatest p·∫p: at a zero of its derivative, or at the inner end."""
        power = self._velocity.times(self._acceleration)
        return max(map(power, [*zeros(power.derivative(), 1.0), 1.0]))

    @cached_property
    def jerk(self) -> float:
        """Largest |Σ i c_i xⁱ⁻¹|: at a zero of the second derivative, or at an end."""
        jerk = self._acceleration.derivative()
        return max(abs(jerk(x)) for x in (0.0, *zeros(jerk.derivative(), 1.0), 1.0))

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """One polynomial."""
        return (Piece(1.0, self.c + (0.0,) * (4 - len(self.c))),)

    @cached_property
    def peaks(self) -> tuple[float, ...]:
        """Where P is largest; nowhere inside, of a constant and of a straight line."""
        flat = zeros(self._acceleration.derivative(), 1.0) if len(self.c) > 2 else []
        return (max(flat, key=self._acceleration),) if flat else ()

    @property
    def turned(self) -> "PolynomialPulse":
        """Σ c_i (1 − x)ⁱ, in powers of x."""
        return PolynomialPulse(tuple(-c for c in backwards(self.pieces[0]).c[: len(self.c)]))

    @property
    def outer(self) -> float:
        """p(0) = c0."""
        return self.c[0]

    @property
    def inner(self) -> float:
        """p(1) = Σ c_i."""
        return self._acceleration(1.0)

    @property
    def least(self) -> float:
        """The smaller of p(0) and p(1), as p has one peak."""
        return min(self.outer, self.inner)

    @property
    def shape(self) -> tuple[float, float, float] | None:
        """Known of a constant and of a straight line."""
        return {1: (1.0, 0.0, 0.0), 2: (0.0, 0.0, 1.0)}.get(len(self.c))


def _of_peak(peak: float, *c: float) -> PolynomialPulse:
    return PolynomialPulse(tuple(x / peak for x in c))


CONSTANT = PolynomialPulse((1.0,))
LINE_DOWN = PolynomialPulse((1.0, -1.0))
"""the half of a cubic"""
HALF_345 = _of_peak(5.0 / math.sqrt(3.0), 0.0, 15.0, -22.5, 7.5)
"""the half of the polynomial 3-4-5, s = 10ξ³ − 15ξ⁴ + 6ξ⁵"""
HALF_4567 = _of_peak(42.0 / (5.0 * math.sqrt(5.0)), 0.0, 0.0, 52.5, -105.0, 65.625, -13.125)
"""the half of the polynomial 4-5-6-7, s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷"""
