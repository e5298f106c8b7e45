"""The master shaft of a timing diagram, and switches over its cycle."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array

FULL_TURN = 2.0 * math.pi  # rad


def shaft_speed(rate: float) -> float:
    """Return the speed of the master shaft (rad/s), ω = 2π n, at n cycles per second, of one cycle a turn.

    Raises ValueError unless n is finite and above 0.
    Source: S1, 'Timing diagram for a cutting machine', 200 pieces per minute = 20.944 rad/s.
    """
    if not (math.isfinite(rate) and rate > 0.0):
        raise ValueError(f"rate is {rate:g}; expected a finite number above 0")
    return FULL_TURN * rate


def turn_time(rate: float) -> float:
    """Return the time 1/n of a turn (s) at n cycles per second. Raises ValueError as :func:`shaft_speed`."""
    return FULL_TURN / shaft_speed(rate)


@dataclass(frozen=True)
class Switch:
    """A lane that is on or off over the cycle: a cylinder, a valve. Raises ValueError for intervals that overlap."""

    name: str
    # begin and end of each interval; an end before its begin is in the next cycle
    on: tuple[tuple[float, float], ...]
    cycle: float = FULL_TURN  # in the same unit as the intervals

    def __post_init__(self) -> None:
        object.__setattr__(self, "on", tuple((float(begin), float(end)) for begin, end in self.on))
        for begin, end in self.on:
            if not (0.0 <= begin <= self.cycle and 0.0 <= end <= self.cycle):
                raise ValueError(f"{self.name}: on from {begin:g} to {end:g}; expected within 0 to {self.cycle:g}")
        for k, (begin, end) in enumerate(self.on):
            others = (other for j, (other, _) in enumerate(self.on) if j != k)
            if any((other - begin) % self.cycle < self._time(begin, end) for other in others):
                raise ValueError(f"{self.name}: two times of being on overlap; expected one after the other")

    def at(self, x: Array) -> Array:
        """Return 1 where it is on and 0 where it is off; at an edge the state after it."""
        state = np.zeros(np.shape(x))
        for begin, end in self.on:
            state = np.maximum(state, (np.asarray(x) - begin) % self.cycle < self._time(begin, end))
        return np.asarray(state, dtype=np.float64)

    @property
    def total(self) -> float:
        """Time for which it is on in a cycle, in the unit of the cycle."""
        return math.fsum(self.spans)

    @property
    def spans(self) -> list[float]:
        """Duration of each interval in which it is on."""
        return [self._time(begin, end) for begin, end in self.on]

    def _time(self, begin: float, end: float) -> float:
        return self.cycle if end - begin == self.cycle else (end - begin) % self.cycle


SAME = 1e-12  # share of the cycle: edges that are nearer to each other count as the same


class SwitchDifference(NamedTuple):
    """The difference of two switches, in the unit of their cycle."""

    edges: int  # number of edges of the switch that is meant, on and off
    largest: float  # distance of an edge from the nearest of its kind; infinite if there is none
    x: float  # place of that edge
    duration: float  # time for which the states differ


def compare_switches(meant: Switch, actual: Switch) -> SwitchDifference:
    """Return the difference of a switch from that meant. Raises ValueError for different cycles."""
    if not math.isclose(meant.cycle, actual.cycle):
        raise ValueError(f"the cycles are {meant.cycle:g} and {actual.cycle:g}; expected the same")
    cycle = meant.cycle
    marks = np.unique([0.0, cycle, *(x % cycle for interval in (*meant.on, *actual.on) for x in interval)])
    marks = marks[np.append(np.diff(marks) > SAME * cycle, True)]
    middles = 0.5 * (marks[1:] + marks[:-1])
    states = meant.at(middles), actual.at(middles)
    # of an edge to the nearest of its kind on the other side, with the edge
    count, distances = 0, []
    for step in (1.0, -1.0):  # edges on, then edges off
        here, there = (marks[:-1][np.diff(state, prepend=state[-1]) == step] for state in states)
        count += len(here)
        for edges, others in ((here, there), (there, here)):
            for edge in edges.tolist():
                apart = np.abs(others - edge)
                distances.append((float(np.minimum(apart, cycle - apart).min(initial=math.inf)), edge))
    largest, x = max(distances, key=lambda distance: distance[0], default=(0.0, 0.0))
    return SwitchDifference(count, largest, x, float(np.diff(marks)[states[0] != states[1]].sum()))
