"""The torque of a motor over the acceleration: a line that bends where power turns round. SI units.

Accelerations b and torques count in the direction of motion. Beside b = 0 the torque of a drive of two stages is
B + A b; it bends twice, where the load begins to drive its stage and where the shaft between them drives the motor's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from engine.drivetrain.drive import Drive
from engine.drivetrain.squares import hinge
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.sections import breaks, integral, roots
from engine.motion import Phase

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

    def signed(self, b: float) -> float:
        """Return the torque of the motor (Nm), positive forward."""
        return self.direction * self.torque(b)

    @property
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
        """B (Nm)."""
        return self.torque(0.0)

    @cached_property
    def slopes(self) -> tuple[float, float, float]:
        """A (Nm per m/s² or rad/s²) up to the first bend, between both and past both, from virtual work by each way."""
        m, side = self.drive.mechanism, self.sign
        first, last = ((1.0 / one.efficiency) ** side for one in m.stages)
        own = (self.drive.motor_inertia + m.on_shaft(0)) * m.ratio
        ways = [(first, last), (1.0 / first, last), (1.0 / first, 1.0 / last)]
        turn = m.ratio_from(1)
        a, b, c = (own + one / m.ratio_to(1) * (other * m.on_shaft(2) / turn + m.on_shaft(1) * turn)
                   for one, other in ways)  # fmt: skip
        return a, b, c

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


def _above(law: Law, per: float, level: float, xi: Array) -> Array:
    """Return by how much an acceleration is above a level."""
    return np.asarray(per * law.a(xi) - level)


@dataclass(frozen=True)
class BentMove:
    """A phase that lifts, over an abscissa that advances at ``speed``, with the bends of its direction."""

    bends: Bends
    phase: Phase
    speed: float

    @property
    def time(self) -> float:
        """Its duration (s)."""
        return self.phase.duration / self.speed

    @property
    def per(self) -> float:
        """b where the law's a is 1."""
        return abs(self.phase.scale) / self.time**2

    @property
    def lowest(self) -> float:
        """The lowest b."""
        return self.per * self.phase.law.coefficients.ca_min

    @property
    def highest(self) -> float:
        """The highest b."""
        return self.per * self.phase.law.coefficients.ca_max

    @property
    def mean(self) -> float:
        """⟨b⟩."""
        return self.per * (self.phase.law.end.v - self.phase.law.start.v)

    @property
    def mean_square(self) -> float:
        """⟨b²⟩."""
        return (self.per * self.phase.law.coefficients.ca_rms) ** 2

    @property
    def against(self) -> float:
        """The largest y."""
        return -self.lowest if self.bends.sign > 0.0 else self.highest

    def part_of(self, total: float) -> float:
        """Return its duration as a share of a cycle so long."""
        return self.phase.duration / total

    def share(self, k: int) -> float:
        """Return y_k as a share of the largest y, 1 where that is not reached."""
        return min(1.0, self.bends.turns[k] / self.against) if self.against > 0.0 else 1.0

    def angle(self, k: int) -> float:
        """Return acos of the share (rad): where a quarter sine passes the bend."""
        return math.acos(self.share(k))

    def past(self, k: int, power: int) -> float:
        """Return ⟨(y − y_k)+^power⟩, by the law's closed form and its roots."""
        return hinge(self.phase.law, -self.bends.sign * self.per, self.bends.turns[k], power)

    @property
    def square(self) -> float:
        """⟨T²⟩ (Nm²), by quadrature between the bends."""
        law, per = self.phase.law, self.per
        edges = breaks(law)
        cuts = [edges]
        for level in (-self.bends.sign * turn for turn in self.bends.turns):
            cuts.append(roots(partial(_above, law, per, level), edges))
        drive, way = self.bends.drive, self.bends.direction
        return integral(lambda xi: drive.torque(way * per * law.a(xi), way) ** 2, np.unique(np.concatenate(cuts)))


class Sizes(NamedTuple):
    """How large quantities of a drive grow: what deviations are measured by."""

    acceleration: float
    force: float
    behind: float
    torque: float
    slope: float


def sizes_of(both: Iterable[Bends], moves: Iterable[BentMove]) -> Sizes:
    """Return the largest accelerations, forces, torques behind the first stage and of the motor, and slopes."""
    ways, found = list(both), list(moves)
    fastest = max((max(m.highest, -m.lowest) for m in found), default=STEP)
    grown = [[abs(way.shaft(k, b)) for way in ways for b in (0.0, fastest, -fastest)] for k in (2, 1)]
    torque = max(abs(way.torque(b)) for way in ways for b in (0.0, fastest, -fastest))
    slope = max(max(way.slopes) for way in ways)
    force, behind = (max(max(one), LEAST) for one in grown)
    return Sizes(fastest, force, behind, max(torque, LEAST), max(slope, LEAST / fastest))
