"""The power of a motor over the stretches of its drive: where it is largest, and how far it bends. SI units.

It is how a table of cells finds it; that of :mod:`engine.machine.demand` comes by a search.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.machine.bent import BentPart
from engine.machine.stationary import LOST, septic
from engine.motion.pieces import MotionPiece

PARTS = 300
"""of a part of a stretch, and of these again, in which the slope of the power is looked at"""
SHARES = np.arange(1, PARTS + 1) / PARTS


class Top(NamedTuple):
    """In which part the slope of the power loses its sign, where (rad), and the power there (W)."""

    part: int
    place: float
    power: float


def flat_up_to(torque: float, acceleration: float, speed: float) -> float:
    """Return the slope of the power, over the motor's speed for y' = 1, up to which it counts as none.

    From the largest torque (Nm) and acceleration (per s²) of a motion whose abscissa advances at a speed (1/s).
    """
    return LOST * torque * acceleration / speed**2


def bound(piece: MotionPiece, order: int, low: float, high: float) -> float:
    """Return what a derivative of a polynomial stays below between two places, by Taylor's series from the middle."""
    middle, half, powers = 0.5 * (low + high), 0.5 * (high - low), len(piece.c)
    terms = [sum(taylor(m, n, order) * piece.c[m] * middle ** (m - n) for m in range(n, powers))
             for n in range(order, powers)]  # fmt: skip
    return sum(abs(term) * half**k for k, term in enumerate(terms))


def taylor(power: int, n: int, order: int) -> int:
    """Return the factor of a power of u in the term of Taylor's series of a derivative that has the n-th of y."""
    return math.perm(power, n) // math.factorial(n - order)


@dataclass(frozen=True)
class Powering:
    """The power over a stretch: up to where the torque passes 0 the motor drives, or is driven; then the other way.

    ``flat`` is the slope of the power, over the speed of the motor for y' = 1, up to which it counts as none.
    """

    part: BentPart
    flat: float

    @property
    def turns(self) -> float:
        """Speed of the motor (rad/s) for y' = 1."""
        return self.part.bends.drive.mechanism.ratio * self.part.speed

    def way(self, u: Array) -> Array:
        """Return |y'|; below 0 where it turns back."""
        return np.asarray(self.part.going * self.part.piece.derivative(1, u))

    def watts(self, u: Array) -> Array:
        """Return the power (W) at places (rad)."""
        one = self.part
        if not one.going:
            return np.zeros(u.shape)
        ahead = one.going * one.speed**2 * one.piece.derivative(2, u)
        return np.asarray(one.bends.torques(ahead) * self.turns * self.way(u))

    def over(self, middle: float, half: float) -> tuple[float, float]:
        """Return the power (W) at both ends of a part, by the middle of that in the motion and half its width (rad)."""
        u = middle - self.part.piece.begin
        low, high = self.watts(np.array([u - half, u + half])).tolist()
        return low, high

    def _power(self, u: float) -> float:
        """Return the power (W) at a place."""
        return float(self.watts(np.array([u]))[0])

    @cached_property
    def ends(self) -> tuple[float, float]:
        """The power at begin and end: the limits from inside (W)."""
        return self._power(self.part.low), self._power(self.part.high)

    def _slope(self, u: Array, bent: bool) -> Array:
        """Return dP/du over the motor's speed for y' = 1; ``bent`` where the torque may have bent."""
        one, rising = self.part, np.sign(self.part.sides[1] - self.part.sides[0])
        slope, line = np.full(u.shape, one.falling), one.bends.level + one.falling * one.y(u)
        for step, level, place in zip(one.bends.steps, one.levels[1:], one.places[2:4], strict=True):
            past = ((u - place) * rising > 0.0) * float(bent)
            slope, line = slope + past * step, line + past * step * (one.y(u) - level)
        along = one.going * one.piece.derivative(2, u)
        return np.asarray(slope * one.factor * one.piece.derivative(3, u) * self.way(u) + line * along)

    def top(self, bent: bool) -> Top:
        """Return where the power is largest by size before the torque passes 0, or behind that."""
        one = self.part
        if not one.going:
            return Top(0, one.sides[0], 0.0)
        first, last = one.places[1 if bent else 0], one.places[4 if bent else 1]
        way = (-1.0 if bent else 1.0) * one.bends.sign * float(np.sign(last - first))

        def kept(shares: Array) -> int:
            slopes = way * self._slope(first + (last - first) * shares, bent)
            return min(PARTS - 1, int(np.count_nonzero(slopes > self.flat)))

        part = kept(SHARES)
        place = first + (last - first) * (part + (kept((part + SHARES) / PARTS) + 0.5) / PARTS) / PARTS
        return Top(part, place, self._power(place) if abs(last - first) > LOST else 0.0)

    @cached_property
    def tops(self) -> tuple[Top, Top]:
        """Where it is largest before the torque passes 0, and behind that."""
        return self.top(bent=False), self.top(bent=True)

    @property
    def at_bends(self) -> float:
        """The power (W) where the torque bends, the larger by size; 0 where it does not."""
        one = self.part
        found = [abs(self._power(self._nearer(k))) for k in (1, 2) if one.going and one.crosses(one.levels[k])]
        return -one.bends.sign * max(found, default=0.0)

    def _nearer(self, k: int) -> float:
        """Return where y passes a level, a step of Newton's nearer than the place that is known."""
        one, u = self.part, self.part.places[k + 1]
        steep = one.factor * float(one.piece.derivative(3, np.array([u]))[0])
        return u - (float(one.y(u)) - one.levels[k]) / steep

    @property
    def sharpest(self) -> float:
        """The largest |y'''|; of two sines what it stays below."""
        one = self.part
        if one.piece.sines[0][0]:
            return math.fsum(abs(amplitude * omega**3) for amplitude, omega, _ in one.piece.sines)
        if septic(one.piece):
            return bound(one.piece, 3, one.low, one.high)
        c4, c5 = one.piece.c[4:6]
        turn = max(one.low, min(one.high, -c4 / (5.0 * c5))) if c5 else one.low
        return float(np.abs(one.piece.derivative(3, np.array([one.low, one.high, turn]))).max())

    @property
    def snap(self) -> float:
        """The largest fourth derivative of y; of two sines what it stays below."""
        one = self.part
        if one.piece.sines[0][0]:
            return math.fsum(abs(amplitude * omega**4) for amplitude, omega, _ in one.piece.sines)
        if septic(one.piece):
            return bound(one.piece, 4, one.low, one.high)
        c4, c5 = one.piece.c[4:6]
        return max(abs(24.0 * c4 + 120.0 * c5 * u) for u in (one.low, one.high))

    def off(self, step: float, efficiency: float) -> float:
        """Return by how much straight lines over steps (rad) are off at most (W), of what its drive draws.

        Of a function of a largest |P''| they are off by |P''| δ²/8, and by a quarter of δ where its slope jumps, times
        that jump. Source: P. J. Davis, Interpolation and Approximation, 3.1, the remainder of linear interpolation.
        """
        one = self.part
        if not one.going:
            return 0.0
        short = min(step, one.high - one.low)
        slopes = np.abs(one.falling + np.cumsum([0.0, *one.bends.steps]))
        hard = max(map(abs, one.ends))
        torque = max(abs(one.torque_at(0)), abs(one.torque_at(1)))
        factor, sharp, fast = abs(one.factor), self.sharpest, one.fastest
        bend = slopes.max() * factor * self.snap * fast + (2.0 * slopes.max() * hard + torque) * sharp
        jumps = [one.crosses(level) * size for level, size in zip(one.levels, self._jumps(efficiency), strict=True)]
        broken = math.fsum(jumps) * factor * sharp * fast
        return float((bend * short**2 / 8.0 + broken * short / 4.0) * self.turns / efficiency)

    def _jumps(self, efficiency: float) -> tuple[float, float, float]:
        """Return by how much the torque's slope over y changes where the torque passes 0, and where it bends."""
        first, second = self.part.bends.steps
        return abs(self.part.falling) * (1.0 - efficiency**2), abs(first), abs(second)
