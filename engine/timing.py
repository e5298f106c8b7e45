"""A timing diagram: named axes over one cycle of the master shaft, and what each movement asks for."""

import math
from dataclasses import dataclass

import numpy as np

from engine.laws.base import Array
from engine.motion import Motion, Phase

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


def ratio_of(rates: Array, rate: float) -> Array:
    """Return how many times faster each of some rates is than another one."""
    return np.asarray(rates / rate)


def at_rate(figure: float, faster: Array, power: int) -> Array:
    """Return a figure that grows with this power of the rate (1 of ẏ, 2 of ÿ, 3 of the jerk), at so many times it."""
    return np.asarray(figure * faster**power)


def lane(y: Array, reach: tuple[float, float], floor: float, share: float) -> Array:
    """Return an axis as a timing diagram shows it: its travel as a share of a lane of height 1 that begins at a floor.

    ``reach`` is from its lowest to its highest position.

    On the floor where it stands. Source: S1, 'Timing diagram for a cutting machine'.
    """
    low, high = reach
    return floor + share * (y - low) / (high - low) if high > low else np.full(y.shape, float(floor))


@dataclass(frozen=True)
class Axis:
    """A named motion.

    Parameters
    ----------
    name : str
        What it is called.
    motion : Motion
        Over one cycle.
    feed : bool
        Whether it advances every cycle and does not come back.
    """

    name: str
    motion: Motion
    feed: bool = False

    @property
    def closes(self) -> bool:
        """Whether the cycle comes back to where it began; a feed need not."""
        return self.feed or self.motion.closes

    def movements(self, speed: float) -> "tuple[Movement, ...]":
        """Return every phase that moves, where the abscissa advances at ``speed``."""
        found = enumerate(self.motion.phases)
        return tuple(Movement(self.name, k, phase, speed) for k, phase in found if phase.moves)


@dataclass(frozen=True)
class Movement:
    """One rise or return of an axis and its peaks.

    ẏ_max = C_v |h|/δ ω, ÿ_max = C_a |h|/δ² ω², ÿ_rms = C_a,rms |h|/δ² ω² over the movement.
    Source: S1, 'Timing diagram for a cutting machine', ÿ_max = c_a h/t_a².

    Parameters
    ----------
    axis : str
        Its name.
    phase : int
        Number of the phase, from 0.
    of : Phase
        The phase, in m or rad.
    speed : float, rad/s or 1/s
        Of the abscissa, e.g. ω.
    """

    axis: str
    phase: int
    of: Phase
    speed: float

    @property
    def v_max(self) -> float:
        """Largest |ẏ|."""
        return self.of.y1_max * self.speed

    @property
    def a_max(self) -> float:
        """Largest |ÿ|."""
        return self.of.y2_max * self.speed**2

    @property
    def j_max(self) -> float:
        """Largest jerk in time; infinite where the law's acceleration jumps."""
        return self.of.y3_max * self.speed**3

    @property
    def a_rms(self) -> float:
        """Root of the mean of ÿ² over the movement."""
        return self.of.y2_rms * self.speed**2


@dataclass(frozen=True)
class Switch:
    """A lane that is on or off over the cycle: a cylinder, a valve, a sensor, a cam switch.

    ``on`` holds begin and end of each time it is on; an end before its begin lies in the next cycle. Raises ValueError
    for an edge outside the cycle, or a time that begins where one before it is not over.
    """

    name: str
    on: tuple[tuple[float, float], ...]
    cycle: float = FULL_TURN

    def __post_init__(self) -> None:
        object.__setattr__(self, "on", tuple((float(begin), float(end)) for begin, end in self.on))
        for begin, end in self.on:
            if not (0.0 <= begin <= self.cycle and 0.0 <= end <= self.cycle):
                raise ValueError(f"{self.name}: on from {begin:g} to {end:g}; expected within 0 to {self.cycle:g}")
        if len(self.on) > 1 and any(self._over(k) for k in range(len(self.on))):
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

    def seconds(self, speed: float) -> float:
        """Return how long it is on in a cycle (s), the abscissa of which advances at ``speed``."""
        return self.total / speed

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

    def _over(self, k: int) -> bool:
        begin, end = self.on[k]
        return any((one - begin) % self.cycle < self._time(begin, end) for j, (one, _) in enumerate(self.on) if j != k)
