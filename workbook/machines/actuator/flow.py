"""Exact mean squares of an actuator's torque, by phase, also where the flow of power turns round within a phase.

A load that resists with R is slowed so hard, at y > y_s, that stage s gives power back. Past that, the torque goes on
along a line of another slope; the phase's ∫T² is that of the first line, and what each change of slope adds. The
engine finds the turns as zeros of its torque; the cells have them in closed form.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drive import Motor
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.sections import breaks, integral, roots
from engine.mechanism import Mechanism
from engine.motion import Phase
from workbook.laws.library import OwnLaw
from workbook.machines.actuator.view import Actuator

NEAR = 1e-9
"""N or Nm at the load; a load that drives with less counts as resisting, or rounding would choose the side"""


@dataclass(frozen=True)
class Flow:
    """One direction of motion: at each stage, from the load's to the motor's, when and by how much the torque bends."""

    resists: float
    """R against this direction, N or Nm at the load"""
    level: float
    slope: float
    """torque T* at the motor's shaft in the direction of motion: level + slope · b, before any stage gives back"""
    keep: Array
    """factor of a stage's torque before power turns round in it: 1/η driving, η driven"""
    back: Array
    """factor after it"""
    hold: Array
    """torque behind the stage at b = 0, referred to the motor's shaft"""
    weight: Array
    """and what it grows by, per b"""
    first: Array
    """product of the factors after the turn, of the stages before it"""
    front: Array
    """slope from the inertia in front of the stage"""

    @property
    def sign(self) -> float:
        """1 where the load resists the motion, −1 where it drives."""
        return side(self.resists)

    @property
    def turn(self) -> Array:
        """y_s, the acceleration against R (m/s² or rad/s²) past which the stage gives back."""
        return np.divide(self.hold, self.weight, out=np.zeros_like(self.hold), where=self.weight > 0)

    @property
    def step(self) -> Array:
        """Change of slope at the turn."""
        found: Array = self.first * (self.back - self.keep) * self.weight
        return found

    @property
    def both(self) -> Array:
        """Slope before the turn plus slope after it."""
        found: Array = 2 * self.front + self.first * (self.back + self.keep) * self.weight
        return found


def side(resists: float) -> float:
    """Return 1 for a load that resists a motion, −1 for one that drives it."""
    return 1.0 if resists >= -NEAR else -1.0


def flow(machine: Actuator, direction: float) -> Flow:
    """Return what the torque does as the acceleration changes, in one direction of motion."""
    m = machine.mechanism
    n, i = len(m.stages), m.ratio
    resists = m.steady * direction + m.rubbing
    driving = np.array([1 / stage.efficiency for stage in reversed(m.stages)])
    keep = driving if side(resists) > 0 or machine.documented else 1 / driving
    back = keep if machine.documented else 1 / keep
    lines = [_line(machine, m if s == 0 else machine.behind(s), direction, resists) for s in range(n)]
    lines.append((abs(resists), m.on_shaft(n)))
    shafts = range(n, 0, -1)
    first = np.array([math.prod(back[r + 1 :]) for r in range(n)])
    inertia = [m.on_shaft(k) / m.ratio_to(k) ** 2 * i for k in range(n)]
    chain = [math.prod(back[n - k :]) for k in range(n)]
    return Flow(
        resists=resists,
        level=side(resists) * lines[0][0],
        slope=lines[0][1],
        keep=keep,
        back=back,
        hold=np.array([lines[s][0] / m.ratio_to(s) for s in shafts]),
        weight=np.array([lines[s][1] / m.ratio_to(s) for s in shafts]),
        first=first,
        front=np.array([math.fsum(j * c for j, c in zip(inertia[:s], chain[:s], strict=True)) for s in shafts]),
    )


def _line(machine: Actuator, behind: Mechanism, direction: float, resists: float) -> tuple[float, float]:
    """Return size of the torque at rest and slope of the engine's torque, on the side where no stage turns round."""
    sizing = machine.sized(behind, machine.phases)
    inertia = behind.inertia() * behind.ratio**2
    if inertia == 0:
        return abs(float(sizing.torque(0.0, direction))), 0.0
    b = max(abs(resists), 1e-3) / inertia
    at = sizing.torque([0.0, direction * side(resists) * b], direction)
    return abs(float(at[0])), float(abs(at[1] - at[0])) / b


def hinge(law: Law, factor: float, turn: float, power: int) -> float:
    """Return ∫ max(factor · a(ξ) − turn, 0)^power dξ: exact, but for the own law by trapezoids on its samples."""
    if factor == 0:
        return 0.0

    def above(xi: Array) -> Array:
        found: Array = np.maximum(factor * law.a(xi) - turn, 0.0) ** power
        return found

    if isinstance(law, OwnLaw):
        return trapezoids(law, above)
    edges = breaks(law)
    return integral(above, np.union1d(edges, roots(lambda xi: factor * law.a(xi) - turn, edges)))


def trapezoids(law: OwnLaw, function: Callable[[Array], Array]) -> float:
    """Return the integral of a function of ξ by trapezoids on the own law's samples."""
    xi = np.arange(law.intervals + 1) / law.intervals
    return float(np.trapezoid(function(xi), xi))


class Squares(NamedTuple):
    """∫T*² dt, ∫ω̇T* dt and ∫ω̇² dt of a phase, at the motor's shaft."""

    torque: float
    product: float
    acceleration: float


def squares(machine: Actuator, phase: Phase) -> Squares:
    """Return the integrals of a phase, by the engine."""
    i = machine.mechanism.ratio
    grown = (i * phase.law.coefficients.ca_rms * phase.lift) ** 2 / phase.duration**3
    if isinstance(phase.law, OwnLaw) and phase.lift:
        return Squares(*_sampled(machine, phase, phase.law), grown)
    time = phase.duration
    torque = machine.sized(machine.mechanism, [phase]).rms_torque ** 2 * time
    if torque == 0 or grown == 0:
        return Squares(torque, 0.0, grown)
    inertia = math.sqrt(torque / grown)  # of a size that loses no digits
    both = machine.sized(machine.mechanism, [phase], inertia).rms_torque ** 2 * time
    return Squares(torque, (both - torque - inertia**2 * grown) / (2 * inertia), grown)


def _sampled(machine: Actuator, phase: Phase, law: OwnLaw) -> tuple[float, float]:
    """Return ∫T*² dt and ∫ω̇T* dt of a movement by the own law: what the turns add comes from its samples."""
    direction, per, i = math.copysign(1.0, phase.lift), phase.lift / phase.duration**2, machine.mechanism.ratio
    line = flow(machine, direction)
    level, slope = direction * line.level, line.slope
    torque = machine.sized(machine.mechanism, [phase]).torque

    def bent(xi: Array, order: int) -> Array:
        a = per * law.a(xi)
        true, straight = torque(a, direction), level + slope * a
        found: Array = true**2 - straight**2 if order == 2 else i * a * (true - straight)
        return found

    gained = (law.end.v - law.start.v) * per
    square = (law.coefficients.ca_rms * per) ** 2
    straight2 = slope**2 * square + 2 * slope * level * gained + level**2
    straight1 = i * (slope * square + level * gained)
    added = [trapezoids(law, lambda xi, order=order: bent(xi, order)) for order in (2, 1)]  # type: ignore[misc]
    return phase.duration * (straight2 + added[0]), phase.duration * (straight1 + added[1])


class Sized(Actuator):
    """An actuator with its mean squares, and with the motor held against them."""

    @cached_property
    def flows(self) -> dict[str, Flow]:
        """Both directions of motion."""
        return {"forward": flow(self, 1.0), "backward": flow(self, -1.0)}

    @cached_property
    def squares(self) -> list[Squares]:
        """The integrals of each phase."""
        return [squares(self, phase) for phase in self.phases]

    def total(self, name: str) -> float:
        """Return the sum of an integral over the cycle."""
        return math.fsum(getattr(s, name) for s in self.squares)

    @cached_property
    def rms_torque(self) -> float:
        """T_RMS of the motor, Nm: exact, but for what power flowing back adds to movements by the own law."""
        if not any(isinstance(phase.law, OwnLaw) for phase in self.phases):
            return self.sizing.rms_torque
        j = self.motor_inertia
        square = self.total("torque") + 2 * j * self.total("product") + j**2 * self.total("acceleration")
        return math.sqrt(max(square, 0.0) / self.sizing.motion.total)

    @cached_property
    def reserve(self) -> dict[str, bool]:
        """Whether the motor is enough, by the engine's names of its limits."""
        m = self.given.motor
        limits = Motor(self.motor_inertia, m.rated_torque, m.peak_torque, self.motor_speed)
        found = {c.name: c.ok for c in self.sizing.reserve(limits, self.derating)}
        return found | {"RMS torque": self.rms_torque <= m.rated_torque * self.derating}
