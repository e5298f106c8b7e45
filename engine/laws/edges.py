"""The edge of a pulse next to a law's greatest velocity: where v·a of a law between rests is greatest."""

import math
from typing import NamedTuple

from engine.laws.polynomial_pulse import LINE_DOWN
from engine.laws.pulse import K, LinearEdged, Pulse, Quarter, SineEdged
from engine.laws.pulse_law import PulseLaw


class InnerEdge(NamedTuple):
    """An edge on which the acceleration falls to 0: the velocity at its begin, what is gained on it, and a place.

    ``at`` is where v·a is greatest: of a quarter sine sin x, where v = v2 + G sin x and a = A cos x; of a straight
    edge y, where v = v2 + G(1 − y²) and a = A y.
    """

    velocity: float
    gain: float
    at: float


def inner_edges(law: PulseLaw) -> tuple[InnerEdge | None, InnerEdge | None]:
    """Return the inner edges of both pulses, told from either end; None of a pulse that has no such edge."""
    c = law.pulses
    return (_inner(c.rise, law.acceleration * c.rise_time), _inner(c.fall, law.deceleration * c.fall_time))


def _inner(pulse: Pulse, size: float) -> InnerEdge | None:
    """Return the edge of a pulse whose height times its duration is ``size``."""
    if isinstance(pulse, SineEdged):
        quarter = Quarter(K * pulse.rise + pulse.flat, K * pulse.fall).scaled(size)
        return InnerEdge(*quarter, quarter.sin)
    if isinstance(pulse, LinearEdged):
        return _straight(pulse.rise / 2.0 + pulse.flat, pulse.fall / 2.0, size)
    return _straight(0.0, 0.5, size) if pulse == LINE_DOWN else None


def _straight(velocity: float, gain: float, size: float) -> InnerEdge:
    """Return a straight edge: 3G y² = v2 + G, y at most 1."""
    y = min(1.0, math.sqrt((velocity + gain) / (3.0 * gain))) if gain > 0.0 else 1.0
    return InnerEdge(size * velocity, size * gain, y)
