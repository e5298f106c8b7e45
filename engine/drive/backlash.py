"""Backlash of a drive: where the torque that the motor brings changes sides, and how hard the load strikes. SI units.

The gap lies behind the first stage, the reducer: what the motor and the parts before it need for themselves does not
pass it. The load lies on the side of the gap from which it is driven. Where the torque T_1 that it needs for the motion
changes its sign, it is left to itself: its acceleration differs from that of the motion by a = T_1 (ω_1/v)/m, with m
all inertia behind the gap, at the load. It crosses the gap b in the time t in which ∫∫ a dt² = b, off by up to b, and
strikes with Δv = ∫ a dt: √(2 a b) behind a jump to a, (9/2 b² ȧ)^⅓ where a passes 0 with a slope.
Source: M. Nordin and P.-O. Gutman, Controlling mechanical systems with backlash, Automatica 38 (2002), 1633: the dead
zone; Newton's law for both sides of it.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.drive.cycle import DriveCycle, TorqueInterval
from engine.drive.drivetrain import Window
from engine.drive.results import DriveResults
from engine.drive.search import NOISE, gauss_legendre
from engine.laws.base import Array

SHAFT = 1  # number of the shaft that is driven through the gap
NODES = 8  # of Gauss and Legendre on each part of the cycle
NEAR = 1e-9  # of the gap: so little behind its side a load counts as on it


class Crossing(NamedTuple):
    """A moment at which the torque through the gap changes sides."""

    x: float  # abscissa of the unshifted motion
    phase: int  # number of the phase, from 0
    time: float  # until it strikes (s); infinite where it floats for a cycle
    shock: float  # velocity by which it strikes (m/s, or rad/s); below 0 where it falls back onto the side that it left


@dataclass(frozen=True)
class Backlash:
    """A gap behind the first stage of a cycle's drive."""

    cycle: DriveCycle
    gap: float  # b (m, or rad), at the load, above 0

    def sides(self, window: Window) -> tuple[float, float]:
        """Return the greatest torques (Nm) through the gap backward and forward while a process force acts; each ≥ 0.

        The load changes sides in this window where both are above 0.
        """
        at, total = self.cycle.shift, self.cycle.unshifted.total
        parts = self.cycle.torque_intervals
        inside = [part for part in parts if window.acts_at(part.piece.begin + middle(part) + at, total)]
        if not inside:
            return 0.0, 0.0
        bounds = DriveResults(self.cycle).shaft_torque(SHAFT, inside)
        return max(0.0, -bounds.lowest.value), max(0.0, bounds.highest.value)

    @property
    def crossings(self) -> Iterator[Crossing]:
        """The moments at which the load leaves its side, in the order of the unshifted motion.

        Between two of them it is taken to lie on a side again, and without torque to stay there. Raises ValueError
        where nothing behind the gap has an inertia, be it at a dead centre.
        """
        *geared, last = self._inertias
        by_angle, parts = self.cycle.train.by_angle, self.cycle.torque_intervals
        if not sum(geared) + (0.0 if by_angle and by_angle.slides else last) > 0.0:
            raise ValueError("what has no inertia strikes at any speed; expected that of load or parts")
        torques = np.array([part.torque(np.array([middle(part)]), SHAFT)[0] for part in parts])
        driven = np.flatnonzero(np.abs(torques) > NOISE * np.abs(torques).max())
        sides = np.sign(torques[driven])
        for number, side, before in zip(driven.tolist(), sides.tolist(), np.roll(sides, 1).tolist(), strict=True):
            if side != before:
                part = parts[number]
                yield Crossing(part.piece.begin + part.low, part.piece.phase, *self._struck(number, side))

    def _struck(self, number: int, side: float) -> tuple[float, float]:
        """Return when and how fast the load strikes that leaves for a side where an interval begins."""
        from scipy.optimize import brentq  # slow to import

        time, speed, place = 0.0, 0.0, 0.0
        parts = self.cycle.torque_intervals
        for part in (*parts[number:], *parts[:number]):
            for low, high in pairwise(part.samples.tolist()):
                moved = partial(self._moved, part, low, speed, place, side)
                reached = moved(high)
                if not -NEAR * self.gap <= reached[1] < self.gap:
                    end = self.gap if reached[1] > 0.0 else -NEAR * self.gap
                    struck = brentq(partial(lambda moved, end, u: moved(u)[1] - end, moved, end), low, high)
                    return time + (struck - low) / self.cycle.speed, moved(struck)[0]
                (speed, place), time = reached, time + (high - low) / self.cycle.speed
        return math.inf, 0.0

    @cached_property
    def _inertias(self) -> list[float]:
        """The inertias behind the gap, at the mechanism's own shaft (kg m²), the last at the load's (kg, or kg m²)."""
        m = self.cycle.train.mechanism
        turns = [math.prod(stage.ratio for stage in m.stages[k : m.last - 1]) for k in range(1, m.last)]
        return [*(m.on_shaft(k) * ratio**2 for k, ratio in enumerate(turns, 1)), m.on_shaft(m.last)]

    def acceleration(self, part: TorqueInterval, u: Array) -> Array:
        """Return by how much the load, left to itself, differs from the motion at u (m/s², or rad/s²)."""
        train, load, (*geared, last) = self.cycle.train, part.load(u), self._inertias
        torque = part.torque(u, SHAFT)
        if not geared:
            return np.asarray(torque / last)
        slope = train.by_angle.slopes(load.y)[0] if train.by_angle else 1.0
        first, turns = part.shaft(u).first, math.prod(stage.ratio for stage in train.mechanism.stages[1:-1])
        return np.asarray(torque * turns * first / (first**2 * sum(geared) + last * slope**2))

    def _moved(
        self, part: TorqueInterval, low: float, speed: float, place: float, side: float, u: float
    ) -> tuple[float, float]:
        """Return speed and place of the load towards a side at u, from those where a part begins."""
        nodes, weights = gauss_legendre(NODES)
        half, time = 0.5 * (u - low), (u - low) / self.cycle.speed
        at = low + half * (1.0 + nodes)
        faster = side * self.acceleration(part, at) * weights * half / self.cycle.speed
        return speed + float(faster.sum()), place + speed * time + float(faster @ (u - at)) / self.cycle.speed


def middle(part: TorqueInterval) -> float:
    """Return u in the middle of a torque interval."""
    return 0.5 * (part.low + part.high)
