"""Pulses of acceleration, and laws of two pulses with a cruise at constant velocity between them."""

import math
from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple

from engine.laws.base import require_finite
from engine.laws.ends import BoundaryLaw
from engine.laws.extremes import at_peaks
from engine.laws.piece import Piece, PlacedPiece, backwards, placed_pieces

K = 2.0 / math.pi  # mean of a quarter sine
QUARTER = math.pi / 2.0
SUM_TOLERANCE = 1e-9


@dataclass(frozen=True)
class Pulse:
    """An acceleration p(x) of peak 1 over x from 0 to 1, nowhere negative; x counts from the nearer end of the law."""

    pieces: tuple[Piece, ...]  # from the law's end inwards, with those without duration
    mirrored: tuple[Piece, ...]  # those of p(1 − x)

    @cached_property
    def gain(self) -> float:
        """W = ∫p dx: the velocity gained."""
        last = placed_pieces(self.pieces)[-1]
        return last.v + last.dv

    @cached_property
    def lead(self) -> float:
        """κ = ∫(1 − x)p dx/W: the travel from rest for unit velocity gained."""
        last = placed_pieces(self.pieces)[-1]
        return (last.s + last.ds) / self.gain


def edged(*shares: float, sine: bool = True) -> Pulse:
    """Return the pulse sin(πx/2d1), 1, cos(πx/2d3), x from the begin of each stage; without ``sine`` x/d1, 1, 1 − x/d3.

    d1, d2 and d3 are the ``shares`` of its duration; raises ValueError unless they are 0 or more and sum to 1. Straight
    edges are a ramp of velocity with limited jerk. Source: S1, 'Modified trapezoidal … curve'.
    """
    rise, flat, fall = shares
    if not (min(shares) >= 0.0 and abs(math.fsum(shares) - 1.0) <= SUM_TOLERANCE):
        raise ValueError(f"the shares of a pulse are {shares}; expected three, none negative, of sum 1")
    return Pulse(_stages(rise, flat, fall, sine), _stages(fall, flat, rise, sine))


def _stages(rise: float, flat: float, fall: float, sine: bool) -> tuple[Piece, ...]:
    up, down = ((QUARTER if sine else 1.0) / d if d > 0.0 else 0.0 for d in (rise, fall))
    level = Piece(flat, (1.0, 0.0, 0.0, 0.0))
    if sine:
        return Piece(rise, amplitude=1.0, omega=up), level, Piece(fall, amplitude=1.0, omega=down, phase=QUARTER)
    return Piece(rise, (0.0, up, 0.0, 0.0)), level, Piece(fall, (1.0, -down, 0.0, 0.0))


def polynomial_pulse(*c: float) -> Pulse:
    """Return the pulse Σ c_i xⁱ, which must have the peak 1 and be nowhere negative."""
    piece = Piece(1.0, c + (0.0,) * (4 - len(c)))
    return Pulse((piece,), (Piece(1.0, tuple(-mirrored for mirrored in backwards(piece).c)),))


_HALF_SINE = (Piece(1.0, amplitude=1.0, omega=math.pi),)
HALF_SINE = Pulse(_HALF_SINE, _HALF_SINE)  # sin πx in a piece. Source: S3, 'CIC'
FALLING_SINE = edged(0.0, 0.0, 1.0)
CONSTANT = polynomial_pulse(1.0)
LINE_DOWN = polynomial_pulse(1.0, -1.0)  # the half of a cubic
HALF_345 = polynomial_pulse(*(c / (5.0 / math.sqrt(3.0)) for c in (0.0, 15.0, -22.5, 7.5)))
"""the half of the polynomial 3-4-5, s = 10ξ³ − 15ξ⁴ + 6ξ⁵"""
HALF_4567 = polynomial_pulse(*(c / (42.0 / (5.0 * math.sqrt(5.0))) for c in (0.0, 0.0, 52.5, -105.0, 65.625, -13.125)))
"""the half of the polynomial 4-5-6-7, s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷"""


def require_shares(ends: bool = False, **shares: float) -> None:
    """Raise ValueError for the first share that is not between 0 and 1; with ``ends`` it may be 0 or 1."""
    require_finite(**shares)
    for name, value in shares.items():
        if not (0.0 < value < 1.0 or (ends and 0.0 <= value <= 1.0)):
            raise ValueError(f"{name} is {value:g}; expected a share {'from 0 to 1' if ends else 'between 0 and 1'}")


def seven_durations(given: Sequence[float]) -> tuple[float, ...]:
    """Return seven shares of sum 1 as floats; raise ValueError for a negative share, or a pulse without duration."""
    durations = tuple(float(d) for d in given)
    if len(durations) != 7:
        raise ValueError(f"{len(durations)} durations are given; expected seven")
    require_shares(ends=True, **{f"the duration of stage {i}": d for i, d in enumerate(durations, 1)})
    total = math.fsum(durations)
    if abs(total - 1.0) > SUM_TOLERANCE:
        raise ValueError(f"the seven durations sum to {total:.12g}; expected 1")
    for stages, part in (("1 to 3", durations[:3]), ("5 to 7", durations[4:])):
        if not max(part) > 0.0:
            raise ValueError(f"the durations of stages {stages} are all zero; expected one that lasts")
    return durations


class TwoPulses(NamedTuple):
    """A pulse, a cruise and a second pulse, reversed in time; the times are shares of the law's and sum to 1."""

    rise: Pulse
    rise_time: float  # T₁
    cruise: float  # T_c
    fall: Pulse  # x from the end of the law
    fall_time: float  # T₂


class Edge(NamedTuple):
    """The edge on which a pulse falls to 0.

    On a quarter sine v = v2 + g sin x and a = A cos x; on a straight line v = v2 + g(1 − y²) and a = A y.
    """

    velocity: float  # v2, at its begin
    gain: float  # g, of velocity over the edge
    sine: bool  # whether it is a quarter sine
    at: float  # sin x, or y, at which v·a is largest: 2g sin²x + v2 sin x = g, or 3g y² = v2 + g, at most 1

    @classmethod
    def of(cls, pulse: Pulse, size: float) -> "Edge":
        """Return the inner edge of a pulse whose height times its duration is ``size``."""
        last = placed_pieces(pulse.pieces)[-1]
        v, g, sine = size * last.v, size * last.dv, bool(last.piece.amplitude)
        if sine:
            return cls(v, g, sine, 2.0 * g / (v + math.hypot(v, math.sqrt(8.0) * g)))
        return cls(v, g, sine, min(1.0, math.sqrt((v + g) / (3.0 * g))) if g else 1.0)


class PulseLaw(BoundaryLaw):
    """A law from v0 to V during T₁, at V during T_c, from V to v1 during T₂, over the stroke H.

    With::

        V = [H − v0 T₁ (1 − κ₁) − v1 T₂ (1 − κ₂)] / (κ₁ T₁ + T_c + κ₂ T₂)
        A = (V − v0)/(W₁ T₁)      B = (V − v1)/(W₂ T₂)

    W = ∫p dx and κ = ∫(1 − x)p dx/W belong to each pulse, the second reversed in time. A and B are the heights of the
    pulses, a = A p and then a = −B p, of either sign: the travels T (v + κ (V − v)) of the pulses and V T_c of the
    cruise add up to H.
    """

    # numbers of its pieces among pulse, cruise, pulse; None: all
    STAGES: ClassVar[tuple[int, ...] | None] = None

    @abstractmethod
    def _pulses(self) -> TwoPulses:
        """Return the pulses with their durations."""

    @cached_property
    def pulses(self) -> TwoPulses:
        """The pulses with their durations."""
        return self._pulses()

    @property
    def lobes(self) -> tuple[tuple[float, float], ...]:
        """W T and κ W T² of each pulse: the velocity it gains and its travel from rest, for the height 1."""
        c = self.pulses
        sides = (c.rise, c.rise_time), (c.fall, c.fall_time)
        return tuple((pulse.gain * time, pulse.lead * (pulse.gain * time) * time) for pulse, time in sides)

    @cached_property
    def top(self) -> float:
        """V: the velocity between the two pulses."""
        c, e = self.pulses, self.ends
        travelled = e.v0 * c.rise_time * (1.0 - c.rise.lead) + e.v1 * c.fall_time * (1.0 - c.fall.lead)
        return (e.stroke - travelled) / (c.rise.lead * c.rise_time + c.cruise + c.fall.lead * c.fall_time)

    @cached_property
    def acceleration(self) -> float:
        """A: the height of the first pulse."""
        return (self.top - self.ends.v0) / (self.pulses.rise.gain * self.pulses.rise_time)

    @cached_property
    def deceleration(self) -> float:
        """B: the height of the second pulse, downwards."""
        return (self.top - self.ends.v1) / (self.pulses.fall.gain * self.pulses.fall_time)

    @property
    def inner_edges(self) -> tuple[Edge, Edge]:
        """The edges of both pulses next to the cruise, on which v·a of a law between rests is largest."""
        c = self.pulses
        return Edge.of(c.rise, self.acceleration * c.rise_time), Edge.of(c.fall, self.deceleration * c.fall_time)

    @property
    def early(self) -> int:
        """Number of the monotone pieces of the first pulse."""
        return sum(len(parts) for k, parts in self._stages(at_peaks) if k < len(self.pulses.rise.pieces))

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces of the first pulse, of the cruise, and of the second pulse from its inner end."""
        return tuple(piece for _, parts in self._stages(lambda piece: [piece]) for piece in parts)

    def monotone_pieces(self) -> tuple[Piece, ...]:
        """Return the same, each pulse cut at its peak; boundary values do not shift the cuts."""
        return tuple(piece for _, parts in self._stages(at_peaks) for piece in parts)

    @property
    def _placed(self) -> tuple[list[PlacedPiece], list[PlacedPiece], float]:
        """The first pulse and the cruise, at exactly V, from the begin; the second pulse from the end; the stroke."""
        c, e = self.pulses, self.ends
        rise = [piece.scaled(self.acceleration, c.rise_time) for piece in c.rise.pieces]
        fall = [piece.scaled(self.deceleration, c.fall_time) for piece in c.fall.pieces]
        *early, cruise = placed_pieces([*rise, Piece(c.cruise)], e.v0)
        travel = c.rise_time * (e.v0 + c.rise.lead * (self.top - e.v0))
        return [*early, cruise._replace(s=travel, v=self.top)], placed_pieces(fall, e.v1), e.stroke

    def _stages(self, parted: Callable[[Piece], list[Piece]]) -> list[tuple[int, list[Piece]]]:
        """Return the number and the parts of each stage that the family has."""
        c = self.pulses
        sides = (c.rise.pieces, self.acceleration, c.rise_time), (c.fall.mirrored, -self.deceleration, c.fall_time)
        rise, fall = (
            [[part.scaled(height, time) for part in parted(piece)] for piece in pieces]
            for pieces, height, time in sides
        )
        stages = [*rise, [Piece(c.cruise)], *fall]
        return [(k, stages[k]) for k in self.STAGES or range(len(stages))]


def pulses_of(durations: tuple[float, ...], sine: bool) -> TwoPulses:
    """Return two pulses of :func:`edged` and the cruise between them, of the durations of seven stages."""
    d1, d2, d3, d4, d5, d6, d7 = durations
    up, down = d1 + d2 + d3, d5 + d6 + d7
    rise = edged(d1 / up, d2 / up, d3 / up, sine=sine)
    return TwoPulses(rise, up, d4, edged(d7 / down, d6 / down, d5 / down, sine=sine), down)
