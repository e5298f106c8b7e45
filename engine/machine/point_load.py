"""What a drive asks for behind its reducer, whatever that and the motor are: at the points of its cycle. SI units.

With J all that turns with the motor, T = J i α + f S/i: f = 1/η where S drives the load, η where the load drives it.
Squares of T are sums of five means of α and S; peaks are those of the points.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drivetrain.losses import gives_back
from engine.laws.base import Array
from engine.machine.quadrature import LoadPoints

AT_ONCE = 1 << 18
"""values of which arrays are made"""


class Gears(NamedTuple):
    """Motors with their reducers, arrays of one length: J (kg m²) on the motor's shaft, i, η."""

    inertia: Array
    ratio: Array
    efficiency: Array

    def parts(self, width: int) -> Iterator[slice]:
        """Yield which of them follow each other with no more than :data:`AT_ONCE` values, ``width`` for each."""
        step = max(1, AT_ONCE // width)
        yield from (slice(begin, begin + step) for begin in range(0, len(self.inertia), step))


class Points(NamedTuple):
    """Points of a cycle, arrays of one length, at the shaft behind the reducer.

    α (rad/s²), S (Nm) where it drives the load and where the load drives it (0 elsewhere), and the speed (rad/s).
    """

    acceleration: Array
    driving: Array
    driven: Array
    speed: Array


class Squares(NamedTuple):
    """⟨α²⟩; ⟨α S⟩ and ⟨S²⟩ where S drives the load, and where the load drives it."""

    own: float
    mixed: float
    mixed_back: float
    behind: float
    behind_back: float


@dataclass(frozen=True)
class PointLoad:
    """A load at its points; its largest speed (rad/s) and torque (Nm) at the shaft, and its inertia there (kg m²)."""

    load: LoadPoints
    speed: float
    torque: float
    inertia: float

    @cached_property
    def points(self) -> Points:
        """The points; of a brake that holds the motor no torque reaches it."""
        load = self.load
        torque = np.where(load.braked, 0.0, load.behind)
        back = gives_back(torque, load.direction, 0.0) & (load.train.method == "physical")
        found = load.turning, np.where(back, 0.0, torque), np.where(back, torque, 0.0), np.abs(load.speed)
        return Points(*(one.ravel() for one in found))

    @cached_property
    def mean_torque(self) -> float:
        """The mean torque of the shaft, ³√(mean |ω||S|³/mean |ω|) (Nm), by which gears are rated; 0 where it stands."""
        weight = self.load.share * np.abs(self.load.speed)
        return math.cbrt(float((weight * np.abs(self.load.behind) ** 3).sum() / weight.sum())) if weight.any() else 0.0

    @cached_property
    def mean_speed(self) -> float:
        """The mean of |ω| (rad/s)."""
        return float((self.load.share * np.abs(self.load.speed)).sum())

    @cached_property
    def squares(self) -> Squares:
        """Means over the cycle."""
        alpha, drives, back, _ = self.points
        share = self.load.share.ravel()
        each = (alpha**2, alpha * drives, alpha * back, drives**2, back**2)
        return Squares(*(float(share @ one) for one in each))

    def rms(self, some: Gears) -> Array:
        """Return the RMS torque of motors (Nm)."""
        own, mixed, mixed_back, behind, behind_back = self.squares
        turned = some.inertia * some.ratio
        out, back = 1.0 / (some.efficiency * some.ratio), some.efficiency / some.ratio
        crossed = 2.0 * turned * (mixed * out + mixed_back * back)
        square = turned**2 * own + crossed + behind * out**2 + behind_back * back**2
        return np.sqrt(np.maximum(square, 0.0))

    def torques(self, some: Gears) -> Array:
        """Return the torque of motors at the points (Nm): motors down, points across."""
        at = self.points
        turned = (some.inertia * some.ratio)[:, None] * at.acceleration
        driving = at.driving / (some.efficiency * some.ratio)[:, None]
        return np.asarray(turned + driving + at.driven * (some.efficiency / some.ratio)[:, None])

    def peak(self, some: Gears) -> Array:
        """Return the largest torque of motors at the points (Nm)."""
        parts = (Gears(*(values[one] for values in some)) for one in some.parts(self.points.speed.size))
        return np.concatenate([np.abs(self.torques(one)).max(axis=1) for one in parts])


def shares_of(limit: Array, value: Array) -> Array:
    """Return the limit over the quantity; 0 where nothing is asked for."""
    return np.divide(limit, value, out=np.zeros(np.broadcast(limit, value).shape), where=value != 0.0)
