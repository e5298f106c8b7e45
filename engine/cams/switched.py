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
    cycle, here, there = meant.cycle, edges(meant), edges(found)
    off = [(min((distance(x, y, cycle) for y in others), default=math.inf), x)
           for one, other in zip(here, there, strict=True)
           for places, others in ((one, other), (other, one)) for x in places]  # fmt: skip
    largest, x = max(off, key=lambda one: one[0], default=(0.0, 0.0))
    marks = np.unique([0.0, cycle, *(x for each in (*here, *there) for x in each)])
    middles = 0.5 * (marks[1:] + marks[:-1])
    duration = float(np.sum(np.diff(marks)[meant.at(middles) != found.at(middles)]))
    return Differing(sum(map(len, here)), largest, x, duration)


def edges(of: Switch) -> tuple[list[float], list[float]]:
    """Return where a switch goes on, and where it goes off, each in rising order."""
    begins = sorted(begin % of.cycle for begin, _ in of.on)
    ends = sorted((begin + span) % of.cycle for (begin, _), span in zip(of.on, of.spans, strict=True))
    for begin in list(begins):
        for end in ends:
            if distance(begin, end, of.cycle) <= SAME * of.cycle:
                begins.remove(begin)
                ends.remove(end)
                break
    return begins, ends


def distance(one: float, other: float, cycle: float) -> float:
    """Return the distance of two places of a cycle."""
    way = abs(one - other) % cycle
    return min(way, cycle - way)
