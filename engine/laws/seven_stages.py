"""Seven durations as two edged pulses and a cruise."""

from engine.laws.pulse import Edged
from engine.laws.pulse_law import TwoPulses


def pulses_of(durations: tuple[float, ...], edged: type[Edged]) -> TwoPulses:
    """Return the course of an edge, a constant, an edge, a cruise, and the same mirrored, with these durations."""
    d1, d2, d3, d4, d5, d6, d7 = durations
    up, down = d1 + d2 + d3, d5 + d6 + d7
    return TwoPulses(edged(d1 / up, d2 / up, d3 / up), up, d4, edged(d7 / down, d6 / down, d5 / down), down)
