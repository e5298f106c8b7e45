"""Pulses of acceleration: what a law does between rest and its greatest velocity, and backwards from its end."""

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

from engine.laws.ladder import Curve, zeros
from engine.laws.piece import Piece, backwards

K = 2.0 / math.pi  # mean of a quarter sine
QUARTER = math.pi / 2.0
SUM_TOLERANCE = 1e-9
SLOPED = math.sqrt(1.0 / 3.0)
"""of a straight line over the whole pulse: where v·a is greatest"""


class Edge(NamedTuple):
    """The edge on which a pulse falls to 0: the velocity v2 at its begin, the velocity g gained on it.

    On a quarter sine v = v2 + g sin x and a = cos x, of unit height; on a straight line v = v2 + g(1 − y²) and a = y.
    ``at`` is sin x, or y, where v·a is greatest: 2g sin²x + v2 sin x = g, or 3g y² = v2 + g, at most 1.
    """

    velocity: float
    gain: float
    sine: bool
    at: float

    def scaled(self, size: float) -> "Edge":
        """Return the edge of a pulse whose height times its duration is ``size``."""
        velocity, gain = size * self.velocity, size * self.gain
        return Edge(velocity, gain, self.sine, _greatest(velocity, gain) if self.sine else self.at)


def _greatest(velocity: float, gain: float) -> float:
    """Return sin x where v·a of a quarter sine is greatest."""
    return 2.0 * gain / (velocity + math.hypot(velocity, math.sqrt(8.0) * gain))


@dataclass(frozen=True)
class Pulse:
    """An acceleration p(x) of peak 1 over x from 0 to 1, told from its outer end.

    The outer end is where the law begins; a deceleration is told backwards from where the law ends. All else
    follows from four numbers: w = ∫p, κ = ∫(1 − x)p dx/w, q = ∫p² and the greatest power from rest.
    """

    gain: float
    """w = ∫p dx: the velocity gained"""
    lead: float
    """κ = ∫(1 − x)p dx/w: the travel from rest, for unit velocity gained"""
    square: float
    """q = ∫p² dx"""
    power: float
    """greatest p·∫p, from rest"""
    jerk: float
    """largest |dp/dx| between the ends"""
    outer: float
    """p(0), where the law begins or ends; nowhere is p less than at one of its ends"""
    inner: float
    """p(1), where the law is at its greatest velocity"""
    pieces: tuple[Piece, ...]
    """from the outer end; a stage without length is among them"""
    turned_pieces: tuple[Piece, ...]
    """those of p(1 − x), from the inner end"""
    peaks: tuple[float, ...] = ()
    """the shares of its time at which a pulse of one piece is at its peak inside; none of a pulse of edges"""
    turned_peaks: tuple[float, ...] = ()
    edge: Edge | None = None
    """the edge at the inner end; None where p does not fall to 0 on a sine or a line"""


def _edged(
    shares: tuple[float, float, float], figures: tuple[float, ...], slope: float,
    pieces: tuple[tuple[Piece, ...], tuple[Piece, ...]], edge: Edge,
) -> Pulse:  # fmt: skip
    """Return a pulse of three stages: an edge up, a constant, an edge down."""
    outer, inner = (0.0 if share > 0.0 else 1.0 for share in shares[::2])
    steepest = max((1.0 / d for d in shares[::2] if d > 0.0), default=0.0)
    gain, lead, square, power = figures
    return Pulse(gain, lead, square, power, slope * steepest, outer, inner, *pieces, edge=edge)


def _require(*shares: float) -> None:
    if not (min(shares) >= 0.0 and abs(sum(shares) - 1.0) <= SUM_TOLERANCE):
        raise ValueError(f"the shares of a pulse are {shares}; expected three, none negative, of sum 1")


def sine_edged(rise: float, flat: float, fall: float) -> Pulse:
    """Return sin(πx/2d1), 1, cos(πx/2d3), each from the begin of its stage.

    With k = 2d1/π + d2 and g = 2d3/π: w = k + g, κ = [(2d1/π)(1 − 2d1/π) + d2(d2/2 + d3) + g²]/w,
    q = d1/2 + d2 + d3/2; v·p is greatest on the last edge, at the sine σ = 2g/(k + √(k² + 8g²)) of the angle yet to
    go, where it is (k + gσ)√(1 − σ²). Raises ValueError unless the shares are 0 or more and sum to 1.
    Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'.
    """
    _require(rise, flat, fall)
    up, g, k = K * rise, K * fall, K * rise + flat
    sin = _greatest(k, g)
    gain = up + flat + g
    lead = (up * (1.0 - up) + flat * (flat / 2.0 + fall) + g * g) / gain
    power = math.sqrt(1.0 - sin**2) * (k + g * sin)
    figures = gain, lead, rise / 2.0 + flat + fall / 2.0, power
    pieces = _sines(rise, flat, fall), _sines(fall, flat, rise)
    return _edged((rise, flat, fall), figures, QUARTER, pieces, Edge(k, g, True, sin))


def _sines(rise: float, flat: float, fall: float) -> tuple[Piece, ...]:
    """Return a quarter sine, a constant, a quarter cosine."""
    up, down = (QUARTER / d if d > 0.0 else 0.0 for d in (rise, fall))
    level = Piece(flat, (1.0, 0.0, 0.0, 0.0))
    return Piece(rise, amplitude=1.0, omega=up), level, Piece(fall, amplitude=1.0, omega=down, phase=QUARTER)


def linear_edged(rise: float, flat: float, fall: float) -> Pulse:
    """Return x/t1, 1, 1 − x/t3, each from the begin of its stage: a ramp of velocity whose jerk is limited.

    With k = t1/2 + t2: w = k + t3/2, κ = [(t1/2)(1 − 2t1/3) + t2(t2/2 + t3) + t3²/3]/w, q = t1/3 + t2 + t3/3; v·p is
    greatest on the last edge, where p = y = min(1, √((2k + t3)/3t3)), and is (k + t3/2 − t3y²/2)y there.
    Raises ValueError as :func:`sine_edged`.
    """
    _require(rise, flat, fall)
    k = rise / 2.0 + flat
    gain = k + fall / 2.0
    lead = (rise / 2.0 * (1.0 - 2.0 * rise / 3.0) + flat * (flat / 2.0 + fall) + fall**2 / 3.0) / gain
    y = min(1.0, math.sqrt((2.0 * k + fall) / (3.0 * fall))) if fall > 0.0 else 1.0
    figures = gain, lead, rise / 3.0 + flat + fall / 3.0, (k + fall / 2.0 - fall * y * y / 2.0) * y
    pieces = _lines(rise, flat, fall), _lines(fall, flat, rise)
    return _edged((rise, flat, fall), figures, 1.0, pieces, Edge(k, fall / 2.0, False, y))


def _lines(rise: float, flat: float, fall: float) -> tuple[Piece, ...]:
    """Return a line up, a constant, a line down."""
    up, down = (1.0 / d if d > 0.0 else 0.0 for d in (rise, fall))
    coefficients = (0.0, up, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0), (1.0, -down, 0.0, 0.0)
    return tuple(Piece(d, c) for d, c in zip((rise, flat, fall), coefficients, strict=True))


def polynomial_pulse(*c: float) -> Pulse:
    """Return Σ c_i xⁱ, which is of peak 1 and nowhere negative: the half of a symmetric polynomial law.

    w = Σ c_i/(i + 1), κ = Σ c_i/((i + 1)(i + 2))/w, q = ΣΣ c_i c_k/(i + k + 1). Power and jerk are greatest at a zero
    of a derivative or at an end; as p has one peak, it is least at an end.
    """
    p = Curve(c)
    velocity, jerk = p.integral(0.0), p.derivative()
    gain, power = velocity(1.0), velocity.times(p)
    piece = _polynomial(c)
    turned = tuple(-one for one in backwards(piece).c[: len(c)])
    return Pulse(
        gain, velocity.integral(0.0)(1.0) / gain, p.times(p).integral(0.0)(1.0),
        max(map(power, [*zeros(power.derivative(), 1.0), 1.0])),
        max(abs(jerk(x)) for x in (0.0, *zeros(jerk.derivative(), 1.0), 1.0)),
        c[0], p(1.0), (piece,), (_polynomial(turned),), _peaks(c), _peaks(turned),
        Edge(0.0, 0.5, False, SLOPED) if c == (1.0, -1.0) else None,
    )  # fmt: skip


def _polynomial(c: tuple[float, ...]) -> Piece:
    return Piece(1.0, c + (0.0,) * (4 - len(c)))


def _peaks(c: tuple[float, ...]) -> tuple[float, ...]:
    """Return where a polynomial is largest; nowhere inside, of a constant and of a straight line."""
    flat = zeros(Curve(c).derivative(), 1.0) if len(c) > 2 else []
    return (max(flat, key=Curve(c)),) if flat else ()


HALF_SINE = replace(
    sine_edged(0.5, 0.0, 0.5), pieces=(ONE := (Piece(1.0, amplitude=1.0, omega=math.pi),)), turned_pieces=ONE,
    peaks=(0.5,), turned_peaks=(0.5,),
)  # fmt: skip
"""sin πx: two quarter sines that are one piece. Source: S3, 'CIC'"""
FALLING_SINE = sine_edged(0.0, 0.0, 1.0)
CONSTANT = polynomial_pulse(1.0)
LINE_DOWN = polynomial_pulse(1.0, -1.0)
"""the half of a cubic"""
HALF_345 = polynomial_pulse(*(c / (5.0 / math.sqrt(3.0)) for c in (0.0, 15.0, -22.5, 7.5)))
"""the half of the polynomial 3-4-5, s = 10ξ³ − 15ξ⁴ + 6ξ⁵"""
HALF_4567 = polynomial_pulse(*(c / (42.0 / (5.0 * math.sqrt(5.0))) for c in (0.0, 0.0, 52.5, -105.0, 65.625, -13.125)))
"""the half of the polynomial 4-5-6-7, s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷"""
