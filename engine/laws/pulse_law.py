"""Laws of two pulses and a cruise: from one velocity to the greatest, and on to another, by one formula."""

import math
from abc import abstractmethod
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import ClassVar, NamedTuple

from engine.laws.base import Array, Coefficients, require_finite
from engine.laws.ends import EndedLaw
from engine.laws.piece import Piece, cut, scaled_piece
from engine.laws.piece_extremes import JUMP, power_extremes
from engine.laws.pulse import SUM_TOLERANCE, Edge, Pulse
from engine.laws.stages import Staged, carried


def require_share(name: str, value: float) -> None:
    """Raise ValueError unless a share is a number strictly between 0 and 1."""
    require_finite(**{name: value})
    if not 0.0 < value < 1.0:
        raise ValueError(f"{name} is {value:g}; expected a share between 0 and 1")


def require_part(name: str, value: float) -> None:
    """Raise ValueError unless a share is a number from 0 to 1."""
    require_finite(**{name: value})
    if not 0.0 <= value <= 1.0:
        raise ValueError(f"{name} is {value:g}; expected a share from 0 to 1")


def seven_durations(given: Sequence[float]) -> tuple[float, ...]:
    """Return seven durations as floats.

    Raises ValueError unless they are seven, none negative, of sum 1 (within 1e-9), neither the first three nor
    the last three all zero.
    """
    durations = tuple(float(d) for d in given)
    if len(durations) != 7:
        raise ValueError(f"{len(durations)} durations are given; expected seven")
    for i, d in enumerate(durations, 1):
        if not 0.0 <= d <= 1.0 + SUM_TOLERANCE:
            raise ValueError(f"the duration of stage {i} is {d:g}; expected a share from 0 to 1")
    if abs(sum(durations) - 1.0) > SUM_TOLERANCE:
        raise ValueError(f"the seven durations sum to {sum(durations):.12g}; expected 1")
    for stages, part in (("1 to 3", durations[:3]), ("5 to 7", durations[4:])):
        if not sum(part) > 0.0:
            raise ValueError(f"the durations of stages {stages} are all zero; expected one that lasts")
    return durations


class TwoPulses(NamedTuple):
    """A pulse over T₁, a cruise over T_c, and a pulse told backwards over T₂; the times sum to 1."""

    rise: Pulse
    rise_time: float
    cruise: float
    fall: Pulse
    fall_time: float


class PulseLaw(EndedLaw):
    """From v0 to V during T₁, at V during T_c, from V to v1 during T₂, over the stroke H.

    With::

        V = [H − v0 T₁ (1 − κ₁) − v1 T₂ (1 − κ₂)] / (κ₁ T₁ + T_c + κ₂ T₂)
        A = (V − v0)/(w₁ T₁)      B = (V − v1)/(w₂ T₂)

    w = ∫p and κ = ∫(1 − x)p dx/w of each pulse, the second told backwards. A and B are the heights of the
    pulses, a = A p and then a = −B p, and may have either sign: ∫a² = A² q₁ T₁ + B² q₂ T₂, the extremes of v are
    among v0, V and v1, and the travel T (v + κ (V − v)) of the pulses and V T_c add up to H.
    """

    STAGES: ClassVar[tuple[int, ...] | None] = None
    """which of the pieces of first pulse, cruise and second pulse the family has; all by default"""

    @abstractmethod
    def _pulses(self) -> TwoPulses:
        """Return the pulses with their durations."""

    @cached_property
    def pulses(self) -> TwoPulses:
        """The pulses with their durations."""
        return self._pulses()

    @property
    def lobes(self) -> tuple[tuple[float, float], ...]:
        """Velocity gained, and travel from rest, of each pulse of unit height over its time: w T and κ w T²."""
        c = self.pulses
        sides = (c.rise, c.rise_time), (c.fall, c.fall_time)
        return tuple((p.gain * time, p.lead * (p.gain * time) * time) for p, time in sides)

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
    def inner_edges(self) -> tuple[Edge | None, Edge | None]:
        """The edges of both pulses next to V, told from either end: where v·a of a law between rests is greatest."""
        c, sizes = self.pulses, (self.acceleration * self.pulses.rise_time, self.deceleration * self.pulses.fall_time)
        one, other = (
            pulse.edge and pulse.edge.scaled(size) for pulse, size in zip((c.rise, c.fall), sizes, strict=True)
        )
        return one, other

    @property
    def own_acceleration(self) -> tuple[bool, bool]:
        """Whether the first pulse begins, and the second ends, above 0."""
        return self.pulses.rise.outer != 0.0, self.pulses.fall.outer != 0.0

    @property
    def early(self) -> int:
        """How many of its monotone pieces are of the first pulse."""
        rise = self.pulses.rise
        stages = range(len(rise.pieces)) if self.STAGES is None else self.STAGES
        return sum(k < len(rise.pieces) for k in stages) + len(rise.peaks)

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces of the first pulse, of the cruise, and of the second pulse from its inner end."""
        return self._cut((), ())

    def monotone_pieces(self) -> tuple[Piece, ...]:
        """Return the same, each pulse cut at its peak: at shares of its time, so between prescribed ends too."""
        return self._cut(self.pulses.rise.peaks, self.pulses.fall.turned_peaks)

    def _cut(self, rising: Sequence[float], falling: Sequence[float]) -> tuple[Piece, ...]:
        """Return the pieces of the stages that the family has, cut at these shares of the pulses."""
        c = self.pulses
        rise = [cut(scaled_piece(piece, self.acceleration, c.rise_time), rising) for piece in c.rise.pieces]
        fall = [cut(scaled_piece(piece, -self.deceleration, c.fall_time), falling) for piece in c.fall.turned_pieces]
        stages = [*rise, [Piece(c.cruise)], *fall]
        return tuple(part for k in self.STAGES or range(len(stages)) for part in stages[k])

    @cached_property
    def _staged(self) -> Staged:
        """The first pulse and the cruise from the begin, the second pulse backwards from the end."""
        c, e = self.pulses, self.ends
        rise = [scaled_piece(piece, self.acceleration, c.rise_time) for piece in c.rise.pieces]
        fall = [scaled_piece(piece, self.deceleration, c.fall_time) for piece in c.fall.pieces]
        travel = c.rise_time * (e.v0 + c.rise.lead * (self.top - e.v0))
        coast = carried([Piece(c.cruise)], 1.0, c.rise_time, travel, self.top)
        backwards = [*carried(fall, -1.0, c.rise_time + c.cruise + c.fall_time, e.stroke, e.v1)]
        return Staged([*carried(rise, 1.0, 0.0, 0.0, e.v0), *coast, *backwards[::-1]])

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        return self._staged(xi)

    def _coefficients(self) -> Coefficients:
        """Return them of the pulses alone between rests, v·a piece by piece between other ends.

        a jumps at an end, where it should be 0, or between the pulses and the cruise.
        """
        c, e, up, down = self.pulses, self.ends, self.acceleration, self.deceleration
        a = [up, up * min(c.rise.outer, c.rise.inner), -down, -down * min(c.fall.outer, c.fall.inner)]
        inner = [up * c.rise.inner + down * c.fall.inner]
        if c.cruise > 0.0:
            a, inner = [*a, 0.0], [up * c.rise.inner, down * c.fall.inner]
        jump = max(map(abs, (up * c.rise.outer, down * c.fall.outer, *inner)))
        jerk = max(abs(up) * c.rise.jerk / c.rise_time, abs(down) * c.fall.jerk / c.fall_time)
        if e.v0 or e.v1:
            va_max, va_min = power_extremes(self.as_pieces(), e.v0)
        else:
            va_max = up**2 * c.rise_time * c.rise.power
            va_min = -(down**2) * c.fall_time * c.fall.power
        return Coefficients(
            cv=max(abs(e.v0), abs(self.top), abs(e.v1)), ca_max=max(a), ca_min=min(a),
            ca_rms=math.sqrt(up**2 * c.rise.square * c.rise_time + down**2 * c.fall.square * c.fall_time),
            cj=math.inf if jump > JUMP * max(abs(up), abs(down)) else jerk, va_max=va_max, va_min=va_min,
        )  # fmt: skip


def pulses_of(durations: tuple[float, ...], edged: Callable[[float, float, float], Pulse]) -> TwoPulses:
    """Return the pulses of an edge, a constant, an edge, a cruise, and the same mirrored, with these durations."""
    d1, d2, d3, d4, d5, d6, d7 = durations
    up, down = d1 + d2 + d3, d5 + d6 + d7
    return TwoPulses(edged(d1 / up, d2 / up, d3 / up), up, d4, edged(d7 / down, d6 / down, d5 / down), down)
