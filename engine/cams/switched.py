"""How far a switch is from the one that is meant: its edges, and for how much of the cycle their states differ."""

import math
from typing import NamedTuple

import numpy as np

from engine.timing import Switch

SAME = 1e-12
"""of the cycle: edges so near to each other are one"""


class Differing(NamedTuple):
    """The edges of the switch that is meant, how far an edge is off at most, and where; for how long states differ.

    Without an edge of its kind on the other side, an edge is off by infinity. All in units of the cycle.
    """

    edges: int
    largest: float
    x: float
    duration: float


def differing(meant: Switch, found: Switch) -> Differing:
    """Return how a switch differs from the one that is meant, of the same cycle.

    A time that goes on where another ends has no edge there, nor one that is always on. Raises ValueError for cycles
    that differ.
    """
    if not math.isclose(meant.cycle, found.cycle):
        raise ValueError(f"the cycles are {meant.cycle:g} and {found.cycle:g}; expected the same")
    cycle = meant.cycle
    marks = np.unique([0.0, cycle, *(x % cycle for one in (meant, found) for time in one.on for x in time)])
    marks = marks[np.append(np.diff(marks) > SAME * cycle, True)]
    middles = 0.5 * (marks[1:] + marks[:-1])
    states = meant.at(middles), found.at(middles)
    here, there = ([marks[:-1][np.diff(state, prepend=state[-1]) == way] for way in (1.0, -1.0)] for state in states)
    off = [(float(np.minimum(way := np.abs(others - x), cycle - way).min(initial=math.inf)), float(x))
           for one, other in zip(here, there, strict=True)
           for places, others in ((one, other), (other, one)) for x in places]  # fmt: skip
    largest, x = max(off, key=lambda one: one[0], default=(0.0, 0.0))
    duration = float(np.diff(marks)[states[0] != states[1]].sum())
    return Differing(sum(map(len, here)), largest, x, duration)
