"""Sizing of an actuator (S4): the engine's view of what was entered."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi, radians

import numpy as np

from engine.actuator import Sizing, derating, motor_inertia
from engine.laws import Law
from engine.laws.base import Array
from engine.mechanism import Mechanism, Part, Slide, Stage
from engine.motion import Phase
from workbook.entries.units import MM, RPM
from workbook.machines.actuator.entries import KINDS, ActuatorSizing


@dataclass(frozen=True)
class Move:
    """A phase as the tables need it, or a spare row: direction, acceleration per unit of the law's, in SI."""

    direction: float = 0.0
    per: float = 0.0
    extremes: tuple[float, float, float] = (0.0, 0.0, 0.0)


class Actuator:
    """Mechanism, sizing, and the load at the shaft that the motor is coupled to."""

    def __init__(self, machine: ActuatorSizing, library: dict[str, Law]) -> None:
        self.given, self.sizes = machine.actuator, machine.sizes
        self.element, self.travels, self.has_belt = KINDS[self.given.mechanism]
        self.unit = MM if self.travels else pi / 180
        self.phases = [Phase(library[p.law], p.lift * self.unit, p.duration) for p in self.given.phases]

    @cached_property
    def slide(self) -> Slide:
        """The load that travels."""
        load = self.given.load
        return Slide(load.mass * load.count, load.friction, radians(load.slope), load.force)

    @property
    def wheel(self) -> float:
        """Speed of the last element over that of the load: rad/m, or 1."""
        out = self.given.output
        if self.given.mechanism == "lead screw":
            return 2 * pi * (out.turns or 0.0) / MM
        return 2 / ((out.diameter or 0.0) * MM) if self.travels else 1.0

    @cached_property
    def mechanism(self) -> Mechanism:
        """The stages, with a lossless one of ratio 1 for each row of gears that is not used."""
        e, room = self.given, self.sizes.gears
        gears = [Stage(g.name, g.ratio, g.efficiency) for g in e.gears]
        gears += [Stage("none", 1.0)] * (room - len(gears))
        last = Stage(self.element, self.wheel, e.output.efficiency if self.travels else 1.0)
        parts = [Part(p.name, p.one, int(p.shaft), p.count) for p in e.parts]
        if self.travels:
            parts += [Part("load", self.slide.mass, room + 1)]
            parts += [Part("belt", e.load.belt, room + 1)] if self.has_belt else []
            steady, rubbing = self.slide.steady, self.slide.rubbing
        else:
            parts += [Part("load", e.load.inertia, room + 1)]
            steady, rubbing = e.load.torque, e.load.friction_torque
        return Mechanism(e.mechanism, (*gears, last), tuple(parts), steady, rubbing)

    @property
    def documented(self) -> bool:
        """Whether losses are counted as S4 does."""
        return self.given.method == "document"

    @cached_property
    def motor_inertia(self) -> float:
        """J_m in kg m², entered or by the ratio."""
        m = self.given.motor
        if m.inertia is not None:
            return m.inertia
        return motor_inertia(self.mechanism, m.inertia_ratio or 0.0, self.given.method)

    def sized(self, mechanism: Mechanism, phases: list[Phase], inertia: float = 0.0) -> Sizing:
        """Return a sizing by the method entered, for a motor's inertia (kg m²)."""
        return Sizing(mechanism, phases, inertia, self.given.method, self.given.holding)

    @cached_property
    def sizing(self) -> Sizing:
        """As entered."""
        return self.sized(self.mechanism, self.phases, self.motor_inertia)

    @cached_property
    def moves(self) -> list[Move]:
        """The phases, then the spare rows."""
        found = []
        for phase in self.phases:
            per, k = phase.lift / phase.duration**2, phase.law.coefficients
            found.append(Move(float(np.sign(phase.lift)), per, (per * k.ca_max, 0.0, per * k.ca_min)))
        return found + [Move()] * (self.sizes.phases - len(found))

    @property
    def returns(self) -> bool:
        """Whether the load moves backwards in any phase."""
        return any(p.lift < 0 for p in self.phases)

    @property
    def hold(self) -> float:
        """What the motor holds in a dwell, at the load (N or Nm)."""
        return self.mechanism.steady if self.given.holding == "motor" else 0.0

    def resisting(self, direction: Array, used: Array) -> Array:
        """Return what resists at the load (N or Nm) in a direction; nothing in a spare row."""
        moving = self.mechanism.steady + self.mechanism.rubbing * direction
        found: Array = np.where(direction == 0, self.hold, moving) * used
        return found

    def shaft_torques(self, acceleration: Array, direction: Array, used: Array) -> list[Array]:
        """Return the torque at each shaft (at the load a force, if it travels), from the motor's to the load's."""
        machine = self.mechanism
        n = len(machine.stages)
        found = [self._driving(k, acceleration, direction, used) for k in range(n)]
        return [*found, self.resisting(direction, used) + machine.on_shaft(n) * acceleration]

    def _driving(self, k: int, acceleration: Array, direction: Array, used: Array) -> Array:
        sizing = self.sized(self.behind(k), self.phases)
        held = sizing.torque(0.0, 0.0) if self.given.holding == "motor" else 0.0
        torque: Array = np.where(direction == 0, held, sizing.torque(acceleration, direction)) * used
        return torque

    def behind(self, k: int) -> Mechanism:
        """Return the mechanism from its shaft ``k`` on, as if the motor sat there."""
        machine = self.mechanism
        parts = tuple(replace(p, shaft=p.shaft - k) for p in machine.parts if p.shaft >= k)
        return replace(machine, stages=machine.stages[k:], parts=parts)

    @cached_property
    def part_torques(self) -> list[float]:
        """Torque of the motor (Nm) in the three parts of each row of phases: a dwell's three times, a spare row's 0."""
        found: list[float] = []
        for phase in self.phases:
            parts = self.sized(self.mechanism, [phase], self.motor_inertia).parts
            found += [part.torque for part in (parts if len(parts) == 3 else parts * 3)]
        return found + [0.0] * (3 * self.sizes.phases - len(found))

    @property
    def motor_speed(self) -> float:
        """Largest speed that the motor allows, rad/s."""
        return self.given.motor.max_speed * RPM

    @cached_property
    def time(self) -> Array:
        """The sampled times of the cycle in s."""
        n = self.sizes.cycle
        return np.arange(n + 1) * self.sizing.motion.total / n

    @property
    def derating(self) -> float:
        """Share of the rated torque that is left at the motor's temperature."""
        m = self.given.motor
        return derating(m.temperature, m.limit, m.rated_at)

    @cached_property
    def lift_scale(self) -> float:
        """Largest lift, m or rad; 1 where nothing moves. Deviations are measured by this and the next ones."""
        return max(abs(p.lift) for p in self.phases) or 1.0

    @cached_property
    def speed_scale(self) -> float:
        """Largest speed of the load, m/s or rad/s; of a unit lift where nothing moves."""
        return self.lift_scale / min(p.duration for p in self.phases)

    @cached_property
    def acceleration_scale(self) -> float:
        """Largest acceleration of the load, m/s² or rad/s²."""
        return self.speed_scale / min(p.duration for p in self.phases)

    @cached_property
    def force_scale(self) -> float:
        """What the load asks for at most, N or Nm, and something where it asks for nothing."""
        machine = self.mechanism
        inertial = machine.on_shaft(len(machine.stages)) * self.acceleration_scale
        return abs(machine.steady) + machine.rubbing + inertial or 1e-3

    @cached_property
    def torque_scale(self) -> float:
        """What the motor is asked for at most, Nm, losses left out; something where it is asked for nothing."""
        inertia = self.motor_inertia + self.mechanism.inertia()
        inertial = inertia * self.mechanism.ratio * self.acceleration_scale
        found = (abs(self.mechanism.steady) + self.mechanism.rubbing) / self.mechanism.ratio + inertial
        return found if math.isfinite(found) and found > 0 else 1e-3
