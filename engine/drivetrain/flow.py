"""Where the flow of power turns round within a phase: the torque as a bent line over the acceleration. SI units.

A load that resists with R is slowed so hard, at y > y_s, that what is behind stage s gives power back. Past that, the
torque goes on along a line of another slope. In one direction of motion all bends lie on one side: y is the
acceleration against R.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.drivetrain.drive import Drive
from engine.drivetrain.losses import gives_back
from engine.laws.base import Array

LEAST = 1e-3
"""N or Nm: what a load that resists with less is accelerated with, to find the slope of its torque"""


@dataclass(frozen=True)
class Flow:
    """One direction of motion (1 or −1): where and by how much the torque at the motor's shaft bends at each stage.

    T*, without the motor's own inertia and in the direction of motion, is ``level`` + ``slope`` · b for accelerations b
    in that direction, until the first stage gives power back. Arrays are over the stages, from the load's to the
    motor's.
    """

    drive: Drive
    direction: float

    @property
    def resists(self) -> float:
        """R against this direction, N or Nm at the load."""
        load = self.drive.mechanism.load
        return load.torque * self.direction + load.friction

    @property
    def sign(self) -> float:
        """1 where the load resists the motion, −1 where it drives."""
        return -1.0 if gives_back(self.resists, 1.0) else 1.0

    @property
    def level(self) -> float:
        """Torque (Nm) at b = 0."""
        return self.sign * self._lines[0][0]

    @property
    def slope(self) -> float:
        """Torque (Nm) per b (m/s² or rad/s²)."""
        return self._lines[0][1]

    @cached_property
    def keep(self) -> Array:
        """Factor of a stage's torque before power turns round in it: 1/η driving, η driven."""
        driving = np.array([1.0 / stage.efficiency for stage in reversed(self.drive.mechanism.stages)])
        return np.asarray(driving if self.sign > 0.0 or self._documented else 1.0 / driving)

    @cached_property
    def back(self) -> Array:
        """Factor after it; the document's method knows one only."""
        return np.asarray(self.keep if self._documented else 1.0 / self.keep)

    @cached_property
    def hold(self) -> Array:
        """Torque behind each stage at b = 0, referred to the motor's shaft (Nm)."""
        return np.array([line[0] for line in self._lines[1:]][::-1]) / self._ratios

    @cached_property
    def weight(self) -> Array:
        """What it grows by, per b."""
        return np.array([line[1] for line in self._lines[1:]][::-1]) / self._ratios

    @cached_property
    def turn(self) -> Array:
        """y_s (m/s² or rad/s²), the acceleration against R past which the stage gives back; 0 without inertia."""
        found = np.zeros(self.hold.shape)
        return np.divide(self.hold, self.weight, out=found, where=self.weight > 0.0)

    @cached_property
    def past(self) -> Array:
        """Product of the factors after the turn, from the load's stage to this one."""
        return np.asarray(np.cumprod(self.back))

    @cached_property
    def first(self) -> Array:
        """Product of the factors after the turn, of the stages in front of this one."""
        return np.array([math.prod(self.back[r + 1 :]) for r in range(len(self.back))])

    @cached_property
    def own(self) -> Array:
        """Slope from the inertia of the shaft in front of each stage alone."""
        m = self.drive.mechanism
        return np.array([m.at_motor(m.on_shaft(k), k) for k in range(m.last)][::-1]) * m.ratio * self.first

    @cached_property
    def run(self) -> Array:
        """Slope from the shafts in front of the stages so far, from the load's on."""
        return np.cumsum(self.own)

    @cached_property
    def front(self) -> Array:
        """Slope from all the inertia in front of the stage."""
        return np.cumsum(self.own[::-1])[::-1]

    @cached_property
    def step(self) -> Array:
        """Change of slope at the turn."""
        return np.asarray(self.first * (self.back - self.keep) * self.weight)

    @cached_property
    def both(self) -> Array:
        """Slope before the turn plus slope after it."""
        return np.asarray(2.0 * self.front + self.first * (self.back + self.keep) * self.weight)

    @property
    def _documented(self) -> bool:
        return self.drive.method == "document"

    @cached_property
    def _ratios(self) -> Array:
        """Motor over the shaft behind each stage, from the load's."""
        m = self.drive.mechanism
        return np.array([m.ratio_to(shaft) for shaft in range(m.last, 0, -1)])

    @cached_property
    def _lines(self) -> list[tuple[float, float]]:
        """Size at b = 0 and slope of the torque of each shaft, from the motor's, where no stage turns round.

        Found as the chain's torques at rest and at an acceleration with R.
        """
        m = self.drive.mechanism
        b = [max(abs(self.resists), LEAST) / j if (j := m.at_load(shaft)) else 0.0 for shaft in range(m.last + 1)]
        at_rest = m.torques(0.0, self.direction, self.drive.method)
        found = []
        for shaft, one in enumerate(b):
            raised = m.torques(self.direction * self.sign * one, self.direction, self.drive.method)[shaft]
            slope = abs(float(raised - at_rest[shaft])) / one if one else 0.0
            found.append((abs(float(at_rest[shaft])), slope))
        return found
