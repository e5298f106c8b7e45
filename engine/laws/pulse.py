"""Pulses of acceleration: what a law does between rest and its greatest velocity, and backwards from its end."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from engine.laws.piece import Piece, backwards, carried

K = 2.0 / math.pi  # mean of a quarter sine
QUARTER = math.pi / 2.0
SUM_TOLERANCE = 1e-9


@dataclass(frozen=True)
class Pulse:
    """An acceleration p(x) of peak 1 over x from 0 to 1, nowhere negative, told from its outer end.

    The outer end is where the law begins; a deceleration is told backwards from where the law ends.
    """

    pieces: tuple[Piece, ...]
    """from the outer end; a stage without length is among them"""
    turned: tuple[Piece, ...]
    """those of p(1 − x), from the inner end"""

    @cached_property
    def gain(self) -> float:
        """W = ∫p dx: the velocity gained."""
        last = carried(self.pieces)[-1]
        return last.v + last.dv

    @cached_property
    def lead(self) -> float:
        """κ = ∫(1 − x)p dx/w: the travel from rest, for unit velocity gained."""
        last = carried(self.pieces)[-1]
        return (last.s + last.ds) / self.gain


def _edged(stages: Callable[[float, float, float], tuple[Piece, ...]], shares: tuple[float, float, float]) -> Pulse:
    """Return a pulse of three stages: an edge up, a constant, an edge down; backwards it has these exchanged."""
    if not (min(shares) >= 0.0 and abs(sum(shares) - 1.0) <= SUM_TOLERANCE):
        raise ValueError(f"the shares of a pulse are {shares}; expected three, none negative, of sum 1")
    return Pulse(stages(*shares), stages(*shares[::-1]))


def sine_edged(rise: float, flat: float, fall: float) -> Pulse:
    """Return sin(πx/2d1), 1, cos(πx/2d3), each from the begin of its stage.

    Raises ValueError unless the shares are 0 or more and sum to 1.
    Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'.
    """
    return _edged(_sines, (rise, flat, fall))


def _sines(rise: float, flat: float, fall: float) -> tuple[Piece, ...]:
    """Return a quarter sine, a constant, a quarter cosine."""
    up, down = (QUARTER / d if d > 0.0 else 0.0 for d in (rise, fall))
    level = Piece(flat, (1.0, 0.0, 0.0, 0.0))
    return Piece(rise, amplitude=1.0, omega=up), level, Piece(fall, amplitude=1.0, omega=down, phase=QUARTER)


def linear_edged(rise: float, flat: float, fall: float) -> Pulse:
    """Return x/t1, 1, 1 − x/t3, each from the begin of its stage: a ramp of velocity whose jerk is limited.

    Raises ValueError as :func:`sine_edged`.
    """
    return _edged(_lines, (rise, flat, fall))


def _lines(rise: float, flat: float, fall: float) -> tuple[Piece, ...]:
    """Return a line up, a constant, a line down."""
    up, down = (1.0 / d if d > 0.0 else 0.0 for d in (rise, fall))
    coefficients = (0.0, up, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0), (1.0, -down, 0.0, 0.0)
    return tuple(Piece(d, c) for d, c in zip((rise, flat, fall), coefficients, strict=True))


def polynomial_pulse(*c: float) -> Pulse:
    """Return Σ c_i xⁱ, which is of peak 1 and nowhere negative: the half of a symmetric polynomial law."""
    piece = Piece(1.0, c + (0.0,) * (4 - len(c)))
    return Pulse((piece,), (Piece(1.0, tuple(-one for one in backwards(piece).c)),))


HALF_SINE = Pulse(ONE := (Piece(1.0, amplitude=1.0, omega=math.pi),), ONE)
"""sin πx: two quarter sines that are one piece. Source: S3, 'CIC'"""
FALLING_SINE = sine_edged(0.0, 0.0, 1.0)
CONSTANT = polynomial_pulse(1.0)
LINE_DOWN = polynomial_pulse(1.0, -1.0)
"""the half of a cubic"""
HALF_345 = polynomial_pulse(*(c / (5.0 / math.sqrt(3.0)) for c in (0.0, 15.0, -22.5, 7.5)))
"""the half of the polynomial 3-4-5, s = 10ξ³ − 15ξ⁴ + 6ξ⁵"""
HALF_4567 = polynomial_pulse(*(c / (42.0 / (5.0 * math.sqrt(5.0))) for c in (0.0, 0.0, 52.5, -105.0, 65.625, -13.125)))
"""the half of the polynomial 4-5-6-7, s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷"""
