"""What a drive that is worked out place by place asks for behind its reducer: for many motors and reducers. SI units.

Its ratio changes, or its friction is viscous: S is no line over α, and integrals and peaks are those of the nodes of
sections, in which power keeps its way through every stage (:mod:`engine.machine.places`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import tau

import numpy as np

from engine.drivetrain.losses import gives_back
from engine.laws.base import Array
from engine.machine.demand import Demand
from engine.machine.geared import Gears
from engine.machine.grid import Points, Squares, points
from engine.machine.places import WEIGHTS, Held, Worked


@dataclass(frozen=True)
class NodeLoad:
    """A drive at the nodes of its sections, each with its width (rad); ``at_motor`` is its inertia there (kg m²).

    That without the motor, the largest where the ratio changes.
    """

    demand: Demand
    at_motor: float
    sections: Sequence[tuple[Held, Worked, float]]

    @cached_property
    def wide(self) -> Array:
        """What each node counts in an integral over the cycle (rad)."""
        return np.concatenate([WEIGHTS * width / 2.0 for _, _, width in self.sections])

    @property
    def back(self) -> Array:
        """The torque behind the reducer with which the load drives, 0 where it does not (Nm)."""
        behind = self._of("behind")
        return np.where(gives_back(behind, self._going, 0.0), behind, 0.0)

    @property
    def _going(self) -> Array:
        return np.concatenate([np.full(at.behind.shape, held.going) for held, at, _ in self.sections])

    def _of(self, name: str) -> Array:
        return np.concatenate([np.asarray(getattr(at, name)) for _, at, _ in self.sections])

    @cached_property
    def points(self) -> Points:
        """The nodes, one section after the other, at the shaft behind the reducer."""
        method = self.demand.course.train.method
        return points(self._of("turning"), self._of("behind"), self._going, np.abs(self._of("rate")), method)

    @cached_property
    def squares(self) -> Squares:
        """Means over the cycle."""
        alpha, drives, back = self.points.acceleration, self.points.driving, self.points.driven
        each = (alpha**2, alpha * drives, alpha * back, drives**2, back**2)
        return Squares(*(float(self.wide @ one / tau) for one in each))

    @property
    def speed(self) -> float:
        """Largest speed of the shaft (rad/s)."""
        return self.demand.speed.peak / self.demand.course.train.drive.mechanism.stages[0].ratio

    def speed_of_motor(self, ratio: float) -> float:
        """Return the largest speed of a motor before a reducer (rad/s)."""
        return ratio * self.speed

    @property
    def torque(self) -> float:
        """Largest torque (Nm)."""
        return self.demand.shaft_torque(1).peak

    @property
    def inertia(self) -> float:
        """Inertia at the shaft (kg m²), the largest."""
        m = self.demand.course.train.drive.mechanism
        return (self.at_motor - m.on_shaft(0)) * m.stages[0].ratio ** 2

    def rms(self, some: Gears) -> Array:
        """Return the RMS torque of motors (Nm)."""
        own, mixed, mixed_back, behind, behind_back = self.squares
        turned, out, back = (
            some.inertia * some.ratio,
            1.0 / (some.efficiency * some.ratio),
            some.efficiency / some.ratio,
        )
        crossed = 2.0 * turned * (mixed * out + mixed_back * back)
        square = turned**2 * own + crossed + behind * out**2 + behind_back * back**2
        return np.sqrt(np.maximum(square, 0.0))

    def peak(self, some: Gears) -> Array:
        """Return the largest torque of motors at the nodes (Nm): between them it may be a little larger."""
        at = self.points
        found = [
            np.abs(
                one.inertia[:, None] * one.ratio[:, None] * at.acceleration
                + at.driving / (one.efficiency * one.ratio)[:, None]
                + at.driven * (one.efficiency / one.ratio)[:, None]
            ).max(axis=1)
            for one in some.parts(at.acceleration.size)
        ]
        return np.concatenate(found)
