"""The torque of a motor over the acceleration: a line that bends where power turns round. SI units.

Accelerations b and torques count in the direction of motion. Beside b = 0 the torque of a drive of two stages is
B + A b; it bends twice, where the load begins to drive its stage and where the shaft between them drives the motor's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drivetrain.drive import Drive
from engine.drivetrain.losses import loss_factor
from engine.laws.base import Array

STEP = 1.0
"""m/s² or rad/s² over which a slope is taken where the torque is straight"""

LEAST = 1e-3
"""N or Nm: what a drive's forces are taken to grow to at least"""


@dataclass(frozen=True)
class Bends:
    """One direction of motion (1 or −1) of a drive of two stages.

    With y the acceleration against what the load resists with, T = B + A b + Σ ΔA_k (y − y_k)+, k = 1, 2.
    """

    drive: Drive
    direction: float

    def shaft(self, number: int, b: float) -> float:
        """Return the torque of a shaft (Nm; N at the load) in the direction of motion, without the motor's inertia."""
        torques = self.drive.mechanism.torques(self.direction * b, self.direction, self.drive.method)
        return self.direction * float(torques[number])

    def torque(self, b: float) -> float:
        """Return the torque of the motor (Nm) in the direction of motion."""
        return self.direction * float(self.drive.torque(self.direction * b, self.direction))

    def torques(self, b: Array, shaft: int = 0) -> Array:
        """Return the torque of the motor (Nm), or behind a stage, in the direction of motion, at accelerations."""
        drive, way = self.drive, self.direction
        found = drive.torque(way * b, way) if shaft == 0 else drive.mechanism.torques(way * b, way, drive.method)[shaft]
        return np.asarray(way * found)

    @cached_property
    def resists(self) -> float:
        """What the load resists with (N, or Nm)."""
        return self.shaft(2, 0.0)

    @property
    def sign(self) -> float:
        """1 where the load resists the motion, −1 where it drives."""
        return -1.0 if self.resists < 0.0 else 1.0

    @cached_property
    def load_turn(self) -> float:
        """The y (m/s² or rad/s²) past which power turns round at the load; 0 of a load without inertia."""
        return _zero(lambda y: self.shaft(2, -self.sign * y), STEP)

    @cached_property
    def shaft_turn(self) -> float:
        """The y past which it turns round at the shaft between the stages; 0 where nothing behind has inertia.

        Up to there power through the last stage keeps its way: of that line the zero is taken.
        """
        return _zero(lambda y: self.shaft(1, -self.sign * y), self.load_turn or STEP)

    @property
    def turns(self) -> tuple[float, float]:
        """y_1 and y_2, the lesser first; a load without inertia never turns power round, and adds no bend."""
        moved = self.drive.mechanism.on_shaft(2) > 0.0
        return self.shaft_turn, self.load_turn if moved else self.shaft_turn

    @property
    def level(self) -> float:
        """B (Nm), by the way of power whatever its size."""
        lossy = math.prod(before for before, _ in self.factors)
        return self.resists * lossy / self.drive.mechanism.ratio

    @cached_property
    def factors(self) -> list[tuple[float, float]]:
        """The rule of losses of each stage, from the motor's: its factor beside b = 0, and past the bend."""
        stages, method = self.drive.mechanism.stages, self.drive.method
        return [
            (float(loss_factor(self.sign, 1.0, one.efficiency, method)),
             float(loss_factor(-self.sign, 1.0, one.efficiency, method)))
            for one in stages
        ]  # fmt: skip

    @cached_property
    def slopes(self) -> tuple[float, float, float]:
        """A (Nm per m/s² or rad/s²) up to the first bend, between both and past both, from virtual work by each way."""
        m = self.drive.mechanism
        (first, first_past), (last, last_past) = self.factors
        own = (self.drive.motor_inertia + m.on_shaft(0)) * m.ratio
        ways = [(first, last), (first_past, last), (first_past, last_past)]
        turn = m.ratio_from(1)
        a, b, c = (own + one / m.ratio_to(1) * (other * m.on_shaft(2) / turn + m.on_shaft(1) * turn)
                   for one, other in ways)  # fmt: skip
        return a, b, c

    @property
    def geared(self) -> tuple[float, float]:
        """The slope of the torque behind the first stage (Nm per m/s² or rad/s²), up to the second bend and past it."""
        past = self.turns[1] + STEP
        near, far = (
            self.shaft(1, -self.sign * y) - self.shaft(1, -self.sign * (y + STEP)) for y in (-STEP, past)
        )  # fmt: skip
        return self.sign * near, self.sign * far

    @property
    def slope(self) -> float:
        """A (Nm per m/s² or rad/s²)."""
        return self.slopes[0]

    @property
    def steps(self) -> tuple[float, float]:
        """ΔA_1 and ΔA_2 (Nm per y)."""
        a, b, c = self.slopes
        return -self.sign * (b - a), -self.sign * (c - b)


def _zero(line: Callable[[float], float], other: float) -> float:
    """Return where a straight line through its values at 0 and ``other`` is 0; 0 where it is level."""
    at_zero, at_other = line(0.0), line(other)
    return at_zero * other / (at_zero - at_other) if at_other != at_zero else 0.0


class Sizes(NamedTuple):
    """How large quantities of a drive grow: what deviations are measured by."""

    acceleration: float
    force: float
    behind: float
    torque: float
    slope: float


def sizes_of(ways: Iterable[Bends], fastest: float) -> Sizes:
    """Return the largest forces, torques behind the first stage and of the motor, and slopes, up to an acceleration."""
    found, fastest = list(ways), fastest or STEP
    grown = [[abs(way.shaft(k, b)) for way in found for b in (0.0, fastest, -fastest)] for k in (2, 1)]
    torque = max(abs(way.torque(b)) for way in found for b in (0.0, fastest, -fastest))
    slope = max(max(way.slopes) for way in found)
    force, behind = (max(max(one), LEAST) for one in grown)
    return Sizes(fastest, force, behind, max(torque, LEAST), max(slope, LEAST / fastest))
