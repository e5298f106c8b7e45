"""The engine's view of the drive of one axis."""

from __future__ import annotations

from functools import cached_property
from math import radians
from typing import NamedTuple

from engine.drivetrain import KINDS, Drive, Load, Mechanism, Motor, Part, Slide, Stage
from engine.drivetrain.bends import Bends, BentMove, Sizes, sizes_of
from engine.drivetrain.motor import LimitCheck, Reserve, reserve
from engine.laws.base import Array
from engine.machine.course import Course
from engine.machine.demand import Demand
from engine.machine.train import Train
from workbook.entries.units import MM, shown, si
from workbook.machines.machine.chosen import motor_in_use, reducer_in_use
from workbook.machines.machine.view import MovingAxis
from workbook.selection.entries import Products

SHAFTS = ("motor", "mechanism")
SCREW = "lead screw"


class Driven:
    """An axis with its drive."""

    def __init__(self, axis: MovingAxis, products: Products) -> None:
        self.axis, self.entered = axis, axis.given
        if axis.given.mechanism is None or axis.given.motor is None:
            raise ValueError(f"{axis.given.name} has no drive")
        self.given, self.holding = axis.given.mechanism, axis.given.motor.holding
        self.motor_used, self.reducer = motor_in_use(axis.given, products), reducer_in_use(axis.given, products)
        self.kind = KINDS[self.given.kind]
        self.number = axis.number

    @property
    def size(self) -> float:
        """Size of the last element as the engine takes it: turns a metre of a screw, a length in m."""
        return shown(1.0, si(self.given.size, MM)) if self.given.kind == SCREW else si(self.given.size, MM)

    @cached_property
    def load(self) -> Load:
        """The load at the end of the chain."""
        e = self.entered.load
        if not self.kind.travels:
            return Load(e.inertia, e.torque, e.friction_torque)
        return Slide(e.mass, e.friction, radians(e.slope), e.force).load

    @cached_property
    def parts(self) -> list[Part]:
        """The rotating parts."""
        return [Part(p.name, p.inertia, SHAFTS.index(p.shaft), p.count) for p in self.entered.parts]

    @cached_property
    def mechanism(self) -> Mechanism:
        """Reducer and mechanism, their parts and the load."""
        reducer = Stage("reducer", self.reducer.ratio, self.reducer.efficiency)
        parts = [self.reducer.part, *self.parts]
        return self.kind.of(self.load, self.size, self.given.efficiency, [reducer], parts)

    @cached_property
    def drive(self) -> Drive:
        """The motor on it."""
        return Drive(self.mechanism, self.motor_used.inertia, holding=self.holding)

    @cached_property
    def demand(self) -> Demand:
        """What a cycle asks of the motor, exact."""
        return Demand(Course(Train(self.drive), self.axis.motion, self.axis.speed, self.axis.shifted.shift))

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
    def reducer_checks(self) -> tuple[LimitCheck, LimitCheck]:
        """The torque behind the reducer (Nm) and the speed before it (rad/s), against its limits."""
        limits, found = self.reducer.limits, self.demand
        torque, speed = found.shaft_torque(1).peak, found.speed.peak
        return (LimitCheck("peak torque", torque, limits.peak_torque, torque <= limits.peak_torque),
                LimitCheck("input speed", speed, limits.input_speed, speed <= limits.input_speed))  # fmt: skip

    @cached_property
    def bends(self) -> dict[str, Bends]:
        """Both directions of motion."""
        return {"forward": Bends(self.drive, 1.0), "backward": Bends(self.drive, -1.0)}

    @cached_property
    def rest_torque(self) -> float:
        """Torque of the motor (Nm) at rest."""
        return self.drive.held_torque

    @property
    def resting(self) -> float:
        """Share of the cycle in which the axis rests."""
        return self.axis.axis.resting

    @cached_property
    def moves(self) -> dict[int, BentMove]:
        """The phases that lift, by their number as entered."""
        found = {}
        for k, move in self.axis.moves.items():
            way = self.bends["forward" if move.lift > 0.0 else "backward"]
            found[k] = BentMove(way, move.of, self.axis.speed)
        return found

    def shaft_peak(self, move: BentMove) -> float:
        """Return the largest torque behind the reducer (Nm) in a phase."""
        return max(abs(move.bends.shaft(1, b)) for b in (move.lowest, move.highest))

    def torques(self, move: BentMove) -> tuple[float, float]:
        """Return the lowest and the highest torque of the motor (Nm) in a phase."""
        way = move.bends
        low, high = sorted(way.signed(b) for b in (move.lowest, move.highest))
        return low, high

    @cached_property
    def sizes(self) -> Sizes:
        """What deviations are measured by."""
        return sizes_of(self.bends.values(), self.moves.values())

    def shares(self, rows: int) -> list[float]:
        """Return the share of the cycle that each phase as entered lifts in."""
        total = self.axis.motion.total
        return [self.moves[k].part_of(total) if k in self.moves else 0.0 for k in range(rows)]

    @property
    def lowest_direction(self) -> float:
        """−1 where the axis moves backward in any phase, else 0."""
        return min((move.bends.direction for move in self.moves.values()), default=0.0)

    @property
    def at_motor(self) -> float:
        """Inertia on the motor's shaft, with it (kg m²)."""
        return self.motor_used.inertia + self.mechanism.on_shaft(0)

    def samples(self, at: Array, going: Array) -> Samples:
        """Return what the drive does at places of the motion, in the direction of each phase."""
        _, v, a = self.axis.motion.at_speed(at, self.axis.speed)
        _, behind, force = self.mechanism.torques(a, going)
        return Samples(self.mechanism.turning(0, v), self.drive.torque(a, going), behind, force)


class Samples(NamedTuple):
    """The motor's speed (rad/s) and torque (Nm), the torque of the mechanism's shaft, and what drives the load."""

    speed: Array
    torque: Array
    behind: Array
    force: Array
