"""The master shaft of a timing diagram, and switches over its cycle: what they are, and how two of them differ."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array

FULL_TURN = 2.0 * math.pi  # rad


def shaft_speed(rate: float) -> float:
    """Return the speed of the master shaft, ω = 2π n, of one cycle a turn.

    Source: S1, 'Timing diagram for a cutting machine', 200 pieces per minute = 20.944 rad/s.

    Parameters
    ----------
    rate : float, 1/s
        n, cycles per second; finite and above 0.

    Returns
    -------
    float, rad/s
        ω.

    Raises
    ------
    ValueError
        For another rate.
    """
    if not (math.isfinite(rate) and rate > 0.0):
        raise ValueError(f"rate is {rate:g}; expected a finite number above 0")
    return FULL_TURN * rate


def turn_time(rate: float) -> float:
    """Return the time of a turn, 1/n, in s, of n cycles per second. Raises ValueError as :func:`shaft_speed`."""
    return FULL_TURN / shaft_speed(rate)


@dataclass(frozen=True)
class Switch:
    """A lane that is on or off over the cycle: a cylinder, a valve. Raises ValueError for times that overlap."""

    name: str
    on: tuple[tuple[float, float], ...]  # begin and end of each time; an end before its begin is in the next cycle
    cycle: float = FULL_TURN

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
        """Return 1 where it is on and 0 where it is off; where it switches, what comes after."""
        state = np.zeros(np.shape(x))
        for begin, end in self.on:
            state = np.maximum(state, (np.asarray(x) - begin) % self.cycle < self._time(begin, end))
        return np.asarray(state, dtype=np.float64)

    @property
    def share(self) -> float:
        """Share of the cycle in which it is on."""
        return self.total / self.cycle

    @property
    def total(self) -> float:
        """What it is on for, in units of the cycle."""
        return math.fsum(self.spans)

    @property
    def spans(self) -> list[float]:
        """How long each time of being on lasts."""
        return [self._time(begin, end) for begin, end in self.on]

    @property
    def bars(self) -> list[tuple[tuple[float, float], tuple[float, float]]]:
        """From where to where each time of being on shows in the cycle: up to its end, and on from its begin."""
        ends = [begin + span for (begin, _), span in zip(self.on, self.spans, strict=True)]
        return [((begin, min(end, self.cycle)), (0.0, max(0.0, end - self.cycle)))
                for (begin, _), end in zip(self.on, ends, strict=True)]  # fmt: skip

    def _time(self, begin: float, end: float) -> float:
        return self.cycle if end - begin == self.cycle else (end - begin) % self.cycle


SAME = 1e-12  # of the cycle: edges so near to each other are one


class SwitchDifference(NamedTuple):
    """How two switches differ, in units of the cycle."""

    edges: int  # of the switch that is meant
    largest: float  # how far one is off at most; infinite without one of its kind on the other side
    x: float  # where
    duration: float  # for how long states differ


def compare_switches(meant: Switch, found: Switch) -> SwitchDifference:
    """Return how a switch differs from the one meant; always on has no edge. Raises ValueError for other cycles."""
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
    return SwitchDifference(sum(map(len, here)), largest, x, duration)
