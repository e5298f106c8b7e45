"""The engine's view of the drive of one axis."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from math import radians
from typing import NamedTuple

import numpy as np

from engine.drivetrain import KINDS, Drive, Load, Mechanism, Motor, Part, Slide, Stage, cylinder
from engine.drivetrain.bends import Bends, Sizes, sizes_of
from engine.drivetrain.chain import geared
from engine.drivetrain.kinds import Kind
from engine.drivetrain.motor import LimitCheck, Reserve, reserve
from engine.laws.base import Array
from engine.machine.bent import Scales, scales
from engine.machine.course import Course
from engine.machine.demand import Demand
from engine.machine.falling import Falling
from engine.machine.train import Train, Window
from workbook.drive.entries import RotatingParts
from workbook.entries.units import DEGREE, KG_CM2, MM, shown, si
from workbook.machines.machine.choice import Choice
from workbook.machines.machine.chosen import falling_of, left_of, motor_in_use, reducer_in_use
from workbook.machines.machine.view import MovingAxis

RESISTING = {"resists": 1.0, "drives": -1.0}
SHAFTS = ("motor", "mechanism")
SCREW = "lead screw"


def inertia_of(part: RotatingParts) -> float:
    """Return the inertia of one part (kg m²), entered or that of a cylinder."""
    if part.inertia is not None:
        return si(part.inertia, KG_CM2)
    diameter, length, bore = (si(x or 0.0, MM) for x in (part.diameter, part.length, part.bore))
    return cylinder(diameter, length, part.density or 0.0, bore)


class Driven:
    """An axis with its drive."""

    def __init__(self, axis: MovingAxis, products: Choice) -> None:
        self.axis, self.entered = axis.sized, axis.given
        if axis.given.mechanism is None or axis.given.motor is None:
            raise ValueError(f"{axis.given.name} has no drive")
        self.given, self.holding = axis.given.mechanism, axis.given.motor.holding
        self.told_falling = falling_of(axis.given.motor.name, products)
        self.falling = self.told_falling if products.knows_falling else Falling()
        self.motor_used, self.reducer = motor_in_use(axis.given, products), reducer_in_use(axis.given, products)
        self._under: dict[tuple[tuple[Window, ...], float], Bends] = {}
        self.number = axis.number

    @property
    def called(self) -> str:
        """The drive by its axis' name, as its sheet and its checks are called."""
        return f"Drive {self.entered.called}"

    @property
    def kind(self) -> Kind:
        """The mechanism's kind."""
        return KINDS[self.given.kind]

    @property
    def travels(self) -> bool:
        """Whether the axis travels."""
        return self.entered.unit == "mm"

    @property
    def size(self) -> float:
        """Size of the last element as the engine takes it: turns a metre of a screw, a length in m."""
        return shown(1.0, si(self.given.size, MM)) if self.given.kind == SCREW else si(self.given.size, MM)

    @cached_property
    def load(self) -> Load:
        """The load at the end of the chain."""
        e = self.entered.load
        if not self.travels:
            return Load(si(e.inertia, KG_CM2), e.torque, e.friction_torque)
        return Slide(e.mass, e.friction, radians(e.slope), e.force).load

    @property
    def belt(self) -> float:
        """Mass of the belt that moves with the load (kg)."""
        return self.given.belt or 0.0

    @property
    def viscous(self) -> float:
        """Viscous friction of the load (N per m/s, or Nm per rad/s)."""
        return self.entered.load.viscous or 0.0

    @cached_property
    def parts(self) -> list[Part]:
        """The rotating parts."""
        return [
            Part(p.name, inertia_of(p), SHAFTS.index(p.shaft), p.count, geared(p.teeth_driver, p.teeth_driven))
            for p in self.entered.parts
        ]

    @cached_property
    def mechanism(self) -> Mechanism:
        """Reducer and mechanism, their parts and the load."""
        return self.kind.of(self.load, self.size, self.given.efficiency, [self.stage], self.turned, self.belt)

    @property
    def stage(self) -> Stage:
        """The reducer as a stage."""
        return Stage("reducer", self.reducer.ratio, self.reducer.efficiency)

    @property
    def turned(self) -> list[Part]:
        """All that turns on the motor's shaft and on the mechanism's."""
        return [self.reducer.part, *self.parts]

    @cached_property
    def drive(self) -> Drive:
        """The motor on it."""
        return Drive(self.mechanism, self.motor_used.inertia, self.given.method, self.holding)

    @property
    def train(self) -> Train:
        """The drive with all that acts on the load."""
        return Train(self.drive, viscous=self.viscous, windows=self.windows)

    @cached_property
    def demand(self) -> Demand:
        """What a cycle asks of the motor, exact."""
        return Demand(Course(self.train, self.axis.motion, self.axis.speed, self.axis.shifted.shift))

    @property
    def inertia(self) -> float:
        """Inertia at the motor, without it (kg m²)."""
        return self.mechanism.inertia()

    @property
    def inertia_ratio(self) -> float:
        """The same over the motor's; 0 of a motor without inertia."""
        return replace(self.drive, method="physical").inertia_ratio

    @property
    def left(self) -> float:
        """Share of its rated torque that the motor can give at the temperature around it."""
        return left_of(self.entered.motor) if self.entered.motor else 1.0

    @cached_property
    def motor(self) -> Motor:
        """The motor with its limits."""
        return self.motor_used.motor

    @cached_property
    def reserve(self) -> Reserve:
        """What a cycle asks of the motor against its limits."""
        found = self.demand
        return reserve(self.motor, found.rms_torque, found.torque.peak, found.speed.peak)

    @cached_property
    def reducer_checks(self) -> tuple[LimitCheck, LimitCheck, LimitCheck]:
        """The torque behind the reducer (Nm) and the speed before it (rad/s), against its limits."""
        limits, found = self.reducer.limits, self.demand
        torque, speed = found.shaft_torque(1).peak, found.speed.peak
        mean = found.mean_shaft_torque(1)
        return (LimitCheck("peak torque", torque, limits.peak_torque, torque <= limits.peak_torque),
                LimitCheck("mean torque", mean, limits.mean_torque, mean <= limits.mean_torque),
                LimitCheck("input speed", speed, limits.input_speed, speed <= limits.input_speed))  # fmt: skip

    @cached_property
    def lines(self) -> dict[str, Bends]:
        """The torque as a bent line where the load resists with 1, and where it drives with it: for their slopes."""
        inertia = self.mechanism.load.inertia
        made = {name: replace(self.mechanism, load=Load(inertia, force)) for name, force in RESISTING.items()}
        return {name: Bends(replace(self.drive, mechanism=one), 1.0) for name, one in made.items()}

    @cached_property
    def windows(self) -> tuple[Window, ...]:
        """The process forces over the cycle, in rad of the master shaft."""
        found = self.entered.load.windows
        return tuple(Window(si(w.start, DEGREE), si(w.stop, DEGREE), w.force, w.resists) for w in found)

    def acting(self, x: float) -> tuple[Window, ...]:
        """Return the process forces at an angle of the master shaft (rad)."""
        return tuple(window for window in self.windows if window.holds(x, self.axis.motion.total))

    def bends_under(self, windows: tuple[Window, ...], going: float) -> Bends:
        """Return the torque as a bent line in a direction of motion, 1, −1 or 0 at rest, under process forces."""
        key = windows, going
        if key not in self._under:
            self._under[key] = under(Bends(self.drive, going or 1.0), windows, going)
        return self._under[key]

    @cached_property
    def sizes(self) -> Sizes:
        """How large its quantities grow."""
        each = [(), *((window,) for window in self.windows), self.windows]
        ways = [self.bends_under(some, going) for some in each for going in (1.0, -1.0)]
        return sizes_of(ways, self.axis.hardest)

    @cached_property
    def scales(self) -> Scales:
        """What its integrals are measured by."""
        return scales(self.sizes.torque, self.sizes.behind, self.mechanism.ratio, self.way, self.demand.course.time)

    @property
    def fastest(self) -> float:
        """The greatest geometric velocity (m or rad, per rad)."""
        return max(phase.y1_max for phase in self.axis.motion.phases)

    @property
    def way(self) -> float:
        """How far the axis goes in a cycle, there and back (m or rad)."""
        return sum(abs(phase.lift) for phase in self.axis.motion.phases)

    @property
    def at_motor(self) -> float:
        """Inertia on the motor's shaft, with it (kg m²)."""
        return self.motor_used.inertia + self.mechanism.on_shaft(0)

    @property
    def beside_motor(self) -> float:
        """Inertia of the parts on the motor's shaft (kg m²), without the reducer's."""
        return self.mechanism.on_shaft(0) - self.reducer.inertia

    def samples(self, at: Array, going: Array, angles: Array) -> Samples:
        """Return what the drive does at places of the motion, in the direction of each phase, at master angles."""
        _, v, a = self.axis.motion.at_speed(at, self.axis.speed)
        found = np.empty((3, len(a)))
        for k, angle in enumerate(angles.tolist()):
            drive = self.bends_under(self.acting(angle), 1.0).drive
            torques = drive.mechanism.torques(a[k], going[k], drive.method)
            found[:, k] = drive.torque(a[k], going[k]), torques[1], torques[2]
        return Samples(self.mechanism.turning(0, v), *found)


def under(bends: Bends, windows: tuple[Window, ...], going: float) -> Bends:
    """Return a direction of motion with process forces more; at rest, without what opposes a motion."""
    drive = bends.drive
    loads = [drive.mechanism.load, *(window.load for window in windows)]
    friction = sum(load.friction for load in loads) if going else 0.0
    load = Load(loads[0].inertia, sum(load.torque for load in loads), friction)
    return replace(bends, drive=replace(drive, mechanism=replace(drive.mechanism, load=load)))


class Samples(NamedTuple):
    """The motor's speed (rad/s) and torque (Nm), the torque of the mechanism's shaft, and what drives the load."""

    speed: Array
    torque: Array
    behind: Array
    force: Array
