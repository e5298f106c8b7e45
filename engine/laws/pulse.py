"""Pulses of acceleration: what a law does between rest and its greatest velocity, and backwards from its end."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import NamedTuple, Self

from engine.laws.piece import Piece

K = 2.0 / math.pi  # mean of a quarter sine
QUARTER = math.pi / 2.0
SUM_TOLERANCE = 1e-9


class Quarter(NamedTuple):
    """A quarter sine that ends without acceleration: velocity v2 at its begin, velocity g gained on it.

    With x from 0 to π/2 its velocity is v2 + g sin x and its acceleration, of unit height, cos x.
    """

    velocity: float
    gain: float

    @property
    def sin(self) -> float:
        """Sin x where v·a is largest: 2g sin²x + v2 sin x = g; the same for any height of the acceleration."""
        v2, g = self
        return 2.0 * g / (v2 + math.hypot(v2, math.sqrt(8.0) * g))

    @property
    def power(self) -> float:
        """Largest v·a, for unit height: cos x (v2 + g sin x)."""
        return math.sqrt(1.0 - self.sin**2) * (self.velocity + self.gain * self.sin)

    def scaled(self, height: float) -> "Quarter":
        """Return the same for another height of the acceleration."""
        return Quarter(height * self.velocity, height * self.gain)


class Pulse(ABC):
    """An acceleration p(x) of peak 1 over x from 0 to 1, told from its outer end.

    The outer end is where the law begins; a deceleration is told backwards from where the law ends. All else
    follows from four numbers: w = ∫p, κ = ∫(1 − x)p dx/w, q = ∫p² and the greatest power from rest.
    """

    @property
    @abstractmethod
    def gain(self) -> float:
        """w = ∫p dx: the velocity gained."""

    @property
    @abstractmethod
    def lead(self) -> float:
        """κ = ∫(1 − x)p dx/w: the travel from rest, for unit velocity gained."""

    @property
    @abstractmethod
    def square(self) -> float:
        """q = ∫p² dx."""

    @property
    @abstractmethod
    def power(self) -> float:
        """Greatest p·∫p, from rest."""

    @property
    @abstractmethod
    def jerk(self) -> float:
        """Largest |dp/dx| between the ends."""

    @property
    @abstractmethod
    def pieces(self) -> tuple[Piece, ...]:
        """The pulse piece by piece from its outer end; a stage without length is among them."""

    @property
    def peaks(self) -> tuple[float, ...]:
        """The shares of its time at which a pulse of one piece is at its peak inside; none of a pulse of edges."""
        return ()

    @property
    @abstractmethod
    def turned(self) -> "Pulse":
        """The pulse told from its inner end: p(1 − x)."""

    @property
    @abstractmethod
    def outer(self) -> float:
        """p(0), where the law begins or ends."""

    @property
    @abstractmethod
    def inner(self) -> float:
        """p(1), where the law is at its greatest velocity."""

    @property
    @abstractmethod
    def least(self) -> float:
        """The smallest p."""

    @property
    def shape(self) -> tuple[float, float, float] | None:
        """Shares of constant, sine and straight stages; None of a polynomial."""
        return None


@dataclass(frozen=True)
class Edged(Pulse):
    """A pulse of three stages: an edge up, a constant, an edge down; the shares, not negative, sum to 1."""

    rise: float
    flat: float
    fall: float

    def __post_init__(self) -> None:
        shares = (self.rise, self.flat, self.fall)
        if not (min(shares) >= 0.0 and abs(sum(shares) - 1.0) <= SUM_TOLERANCE):
            raise ValueError(f"the shares of a pulse are {shares}; expected three, none negative, of sum 1")

    @property
    def turned(self) -> Self:
        """The same with its edges exchanged."""
        return type(self)(self.fall, self.flat, self.rise)

    @property
    def outer(self) -> float:
        """1 without an edge at the outer end, else 0."""
        return 0.0 if self.rise > 0.0 else 1.0

    @property
    def inner(self) -> float:
        """1 without an edge at the inner end, else 0."""
        return 0.0 if self.fall > 0.0 else 1.0

    @property
    def least(self) -> float:
        """1 for a constant, else 0."""
        return min(self.outer, self.inner)

    @property
    def steepest(self) -> float:
        """1/d of the shorter edge of the two that last; 0 of a constant."""
        return max((1.0 / d for d in (self.rise, self.fall) if d > 0.0), default=0.0)


class SineEdged(Edged):
    """sin(πx/2d1), 1, cos(πx/2d3), each from the begin of its stage.

    With k = 2d1/π + d2 and g = 2d3/π: w = k + g; v·p is greatest on the last edge, at the sine
    σ = 2g/(k + √(k² + 8g²)) of the angle yet to go, where it is (k + gσ)√(1 − σ²).
    Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'.
    """

    @property
    def gain(self) -> float:
        """W = k + g."""
        return K * self.rise + self.flat + K * self.fall

    @property
    def lead(self) -> float:
        """κ = [(2d1/π)(1 − 2d1/π) + d2(d2/2 + d3) + g²]/w."""
        edge, g = K * self.rise, K * self.fall
        return (edge * (1.0 - edge) + self.flat * (self.flat / 2.0 + self.fall) + g * g) / self.gain

    @property
    def square(self) -> float:
        """Q = d1/2 + d2 + d3/2."""
        return self.rise / 2.0 + self.flat + self.fall / 2.0

    @property
    def power(self) -> float:
        """(k + gσ)√(1 − σ²)."""
        return Quarter(K * self.rise + self.flat, K * self.fall).power

    @property
    def jerk(self) -> float:
        """π/2d of the shorter edge."""
        return QUARTER * self.steepest

    @property
    def shape(self) -> tuple[float, float, float]:
        """A constant and two quarters of a sine."""
        return self.flat, self.rise + self.fall, 0.0

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """A quarter sine, a constant, a quarter cosine."""
        return (_quarter(self.rise, 0.0), Piece(self.flat, (1.0, 0.0, 0.0, 0.0)), _quarter(self.fall, QUARTER))


def _quarter(d: float, phase: float) -> Piece:
    return Piece(d, amplitude=1.0, omega=QUARTER / d if d > 0.0 else 0.0, phase=phase)


class HalfSine(SineEdged):
    """sin πx: two quarter sines that are one piece. Source: S3, 'CIC'."""

    def __init__(self) -> None:
        super().__init__(0.5, 0.0, 0.5)

    @property
    def peaks(self) -> tuple[float, ...]:
        """The middle."""
        return (0.5,)

    @property
    def turned(self) -> "HalfSine":
        """Itself."""
        return self

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """One half sine."""
        return (Piece(1.0, amplitude=1.0, omega=math.pi),)


class LinearEdged(Edged):
    """x/t1, 1, 1 − x/t3, each from the begin of its stage: a ramp of velocity whose jerk is limited.

    With k = t1/2 + t2: w = k + t3/2; v·p is greatest on the last edge, where p = y = min(1, √((2k + t3)/3t3)),
    and is (k + t3/2 − t3y²/2)y there.
    """

    @property
    def gain(self) -> float:
        """W = t1/2 + t2 + t3/2."""
        return self.rise / 2.0 + self.flat + self.fall / 2.0

    @property
    def lead(self) -> float:
        """κ = [(t1/2)(1 − 2t1/3) + t2(t2/2 + t3) + t3²/3]/w."""
        edge = self.rise / 2.0 * (1.0 - 2.0 * self.rise / 3.0)
        return (edge + self.flat * (self.flat / 2.0 + self.fall) + self.fall**2 / 3.0) / self.gain

    @property
    def square(self) -> float:
        """Q = t1/3 + t2 + t3/3."""
        return self.rise / 3.0 + self.flat + self.fall / 3.0

    @property
    def power(self) -> float:
        """(k + t3/2 − t3y²/2)y."""
        k, t3 = self.rise / 2.0 + self.flat, self.fall
        y = min(1.0, math.sqrt((2.0 * k + t3) / (3.0 * t3))) if t3 > 0.0 else 1.0
        return (k + t3 / 2.0 - t3 * y * y / 2.0) * y

    @property
    def jerk(self) -> float:
        """1/t of the shorter edge."""
        return self.steepest

    @property
    def shape(self) -> tuple[float, float, float]:
        """A constant and two straight lines."""
        return self.flat, 0.0, self.rise + self.fall

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """A line up, a constant, a line down."""
        up, down = (1.0 / d if d > 0.0 else 0.0 for d in (self.rise, self.fall))
        return (
            Piece(self.rise, (0.0, up, 0.0, 0.0)),
            Piece(self.flat, (1.0, 0.0, 0.0, 0.0)),
            Piece(self.fall, (1.0, -down, 0.0, 0.0)),
        )


CYCLOIDAL = HalfSine()
