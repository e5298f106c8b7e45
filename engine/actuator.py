"""Sizing of an actuator: what torque and speed a cycle of moves asks of the motor behind a mechanism. SI units."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.drive import LimitCheck, Motor, OperatingPoints
from engine.laws import Dwell, TrapezoidalVelocity
from engine.laws.base import Array
from engine.laws.inverse import is_monotone
from engine.laws.sections import breaks, integral, roots
from engine.mechanism import Mechanism
from engine.motion import Motion, Phase

Method = Literal["physical", "document"]
Holding = Literal["motor", "brake"]

RATED_AT = 25.0
"""°C at which a motor's rated torque holds in S4"""

WINDING_LIMIT = 175.0
"""°C; inferred from S4, problem 2, where 35 °C lowers the torque from 0.147 to 0.142 Nm"""


def thirds(first: float = 1 / 3, uniform: float = 1 / 3, last: float = 1 / 3) -> TrapezoidalVelocity:
    """Return the trapezoid of S4's move profiles, e.g. 1/6–2/3–1/6, as a law; the shares sum to 1 (1e-9).

    Raises ValueError where they do not. Source: S4, 'Move profile'.
    """
    if abs(first + uniform + last - 1.0) > 1e-9 or uniform < 0.0:
        raise ValueError(f"the shares are {first:g}, {uniform:g}, {last:g}; expected a sum of 1, the second 0 or more")
    return TrapezoidalVelocity(first, first if uniform == 0.0 else 1.0 - last)


def motor_inertia(mechanism: Mechanism, inertia_ratio: float, method: Method = "physical") -> float:
    """Return the motor's inertia J_machine/ratio (kg m²) for a ratio J_machine/J_motor.

    Raises ValueError unless the ratio is above 0. Source: S4, 'inertia ratio between the machine and the motor'.
    """
    if not (math.isfinite(inertia_ratio) and inertia_ratio > 0.0):
        raise ValueError(f"inertia ratio is {inertia_ratio:g}; expected a finite number above 0")
    return mechanism.inertia(losses=method == "document") / inertia_ratio


def derating(temperature: float, limit: float = WINDING_LIMIT, rated_at: float = RATED_AT) -> float:
    """Return the share of its rated torque that a motor can give at a temperature (°C) of its surroundings.

    sqrt((T_max − T)/(T_max − T_rated)), and no more than 1 where it is colder: 0.9661 at 35 °C.
    Raises ValueError unless both temperatures are below ``limit`` (T_max). Source: S4, problem 2, last lines.
    """
    if not max(temperature, rated_at) < limit:
        raise ValueError(f"{temperature:g} °C, rated at {rated_at:g} °C; expected less than the limit, {limit:g} °C")
    return min(1.0, math.sqrt((limit - temperature) / (limit - rated_at)))


class CyclePart(NamedTuple):
    """A part of a phase and the torque (Nm) in it: the extreme one, where it varies."""

    phase: int
    name: Literal["accelerating", "uniform", "decelerating", "dwell"]
    torque: float


@dataclass(frozen=True)
class Sizing:
    """A mechanism, the phases of its load's motion (m or rad, in s), and the inertia of the motor (kg m²).

    ``method`` physical: each stage's losses count against the motor where it drives and help it where the
    load drives (at rest, as if it drove). ``document``: S4's, inertia and torque behind a stage always over η.
    ``holding``: who holds the load in a dwell; S4 counts no torque there, as with a brake.
    Raises ValueError for no phases, a negative inertia, or a law that moves backwards.
    """

    mechanism: Mechanism
    phases: Sequence[Phase]
    motor_inertia: float
    method: Method = "physical"
    holding: Holding = "motor"

    def __post_init__(self) -> None:
        object.__setattr__(self, "phases", tuple(self.phases))
        if not (math.isfinite(self.motor_inertia) and self.motor_inertia >= 0.0):
            raise ValueError(f"motor: inertia is {self.motor_inertia:g}; expected a finite number, 0 or more")
        if self.method not in ("physical", "document"):
            raise ValueError(f"method is {self.method!r}; expected 'physical' or 'document'")
        if self.holding not in ("motor", "brake"):
            raise ValueError(f"holding is {self.holding!r}; expected 'motor' or 'brake'")
        if not self.phases:
            raise ValueError("no phases are given; expected at least one")
        for k, phase in enumerate(self.phases, 1):
            if not is_monotone(phase.law):
                raise ValueError(f"phase {k}: {phase.law.name} moves backwards; expected a law that does not")

    @cached_property
    def motion(self) -> Motion:
        """The load's motion over time (s)."""
        return Motion(self.phases)

    @property
    def total_inertia(self) -> float:
        """J_T = J_m + Σ J_i at the motor's shaft (kg m²), over η with the document's method."""
        return self.motor_inertia + self.mechanism.inertia(losses=self.method == "document")

    @property
    def max_speed(self) -> float:
        """Largest speed of the motor (rad/s)."""
        return self.mechanism.ratio * max(p.law.coefficients.cv * abs(p.lift) / p.duration for p in self.phases)

    @property
    def max_acceleration(self) -> float:
        """Largest acceleration of the motor (rad/s²)."""
        return self.mechanism.ratio * max(p.law.coefficients.ca * abs(p.lift) / p.duration**2 for p in self.phases)

    def torque(self, acceleration: ArrayLike, direction: ArrayLike) -> Array:
        """Return the motor's torque (Nm) at accelerations of the load (m/s² or rad/s²) in a direction (−1, 0, 1).

        T_m = J_m ω̇ + T(0), T(k) = J_k ω̇_k + f T(k + 1)/i, f = 1/η where power flows to the load, η where it
        flows back. Source: S4, T_m = T_R + J_T θ̈_m, where f is always 1/η.
        """
        a, sign = np.asarray(acceleration, dtype=np.float64), np.asarray(direction, dtype=np.float64)
        torques = self._cascade(a, sign)
        return torques[-1] + self.motor_inertia * self.mechanism.ratio * a

    def _cascade(self, a: Array, sign: Array) -> list[Array]:
        """Return the torque (or force) that each shaft, from the load's to the motor's, must be driven with."""
        machine = self.mechanism
        last = len(machine.stages)
        found = [machine.steady + machine.rubbing * sign + machine.on_shaft(last) * a]
        for k in reversed(range(last)):
            stage, behind = machine.stages[k], found[-1]
            driven = (behind * sign >= 0.0) | (self.method == "document")
            lossy = np.where(driven, behind / stage.efficiency, behind * stage.efficiency)
            speed_ratio = machine.ratio / machine.ratio_to(k)
            found.append(lossy / stage.ratio + machine.on_shaft(k) * speed_ratio * a)
        return found

    @property
    def parts(self) -> tuple[CyclePart, ...]:
        """The torque in each part of the cycle: at the law's extremes of acceleration, and without any."""
        found: list[CyclePart] = []
        for k, phase in enumerate(self.phases):
            if _stands(phase):
                found.append(CyclePart(k, "dwell", self._holding_torque))
                continue
            per, c = phase.lift / phase.duration**2, phase.law.coefficients
            up, level, down = self.torque([c.ca_max * per, 0.0, c.ca_min * per], math.copysign(1.0, phase.lift))
            found.append(CyclePart(k, "accelerating", float(up)))
            found.append(CyclePart(k, "uniform", float(level)))
            found.append(CyclePart(k, "decelerating", float(down)))
        return tuple(found)

    @property
    def peak_torque(self) -> float:
        """max |T_m| (Nm), exact."""
        return max(abs(part.torque) for part in self.parts)

    @cached_property
    def rms_torque(self) -> float:
        """sqrt(∫T_m² dt / t) over the cycle (Nm), exact: not from samples. Source: S4, T_RMS."""
        return math.sqrt(math.fsum(self._square(phase) for phase in self.phases) / self.motion.total)

    @property
    def _holding_torque(self) -> float:
        return float(self.torque(0.0, 0.0)) if self.holding == "motor" else 0.0

    def _square(self, phase: Phase) -> float:
        """Return ∫T_m² dt of a phase."""
        if _stands(phase):
            return self._holding_torque**2 * phase.duration
        lossless = self.method == "document" or all(s.efficiency == 1.0 for s in self.mechanism.stages)
        return self._square_affine(phase) if lossless else self._square_by_stages(phase)

    def _square_affine(self, phase: Phase) -> float:
        """Return ∫T_m² dt where T_m = A a + B: A² ∫a² + 2AB ∫a + B² t, from the law's coefficients."""
        sign = math.copysign(1.0, phase.lift)
        level, raised = self.torque([0.0, 1.0], sign)
        slope = raised - level
        squares = (phase.law.coefficients.ca_rms * phase.lift) ** 2 / phase.duration**3
        gained = (phase.law.end.v - phase.law.start.v) * phase.lift / phase.duration
        return float(slope**2 * squares + 2.0 * slope * level * gained + level**2 * phase.duration)

    def _square_by_stages(self, phase: Phase) -> float:
        """Return ∫T_m² dt, split where the flow of power through a stage turns round."""
        law, per = phase.law, phase.lift / phase.duration**2
        sign = np.asarray(math.copysign(1.0, phase.lift))

        def through(stage: int) -> Callable[[Array], Array]:
            return lambda xi: self._cascade(per * law.a(xi), sign)[stage]

        edges = breaks(law)
        turns = [roots(through(k), edges) for k in range(len(self.mechanism.stages))]
        sections = np.unique(np.concatenate([edges, *turns]))
        return phase.duration * integral(lambda xi: self.torque(per * law.a(xi), sign) ** 2, sections)

    def operating_points(self, time: ArrayLike) -> OperatingPoints:
        """Return speed, torque and power of the motor at times of the cycle (s). Raises ValueError outside it."""
        at = np.asarray(time, dtype=np.float64)
        values, index = self.motion.at(at), self.motion.phase_index(at)
        directions = np.array([0.0 if _stands(p) else math.copysign(1.0, p.lift) for p in self.phases])[index]
        torque = np.where(directions == 0.0, self._holding_torque, self.torque(values.y2, directions))
        speed = self.mechanism.ratio * values.y1
        return OperatingPoints(speed, torque, speed * torque, at)

    def reserve(self, motor: Motor, derated: float = 1.0) -> tuple[LimitCheck, ...]:
        """Return RMS torque, peak torque and speed against the motor; its rated torque times ``derated``.

        The motor's own inertia is not taken from ``motor``: see ``motor_inertia``.
        """
        found = (
            ("RMS torque", self.rms_torque, motor.rated_torque * derated),
            ("peak torque", self.peak_torque, motor.peak_torque),
            ("speed", self.max_speed, motor.max_speed),
        )
        return tuple(LimitCheck(name, value, limit, value <= limit) for name, value, limit in found)


def _stands(phase: Phase) -> bool:
    return isinstance(phase.law, Dwell) or phase.lift == 0.0
