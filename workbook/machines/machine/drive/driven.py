"""The engine's view of the drive of one axis."""

from dataclasses import replace
from functools import cached_property, partial
from math import radians
from typing import TypeVar

import numpy as np

from engine.drive import KINDS, Drive, Load, Mechanism, Part, Slide, Stage, cylinder
from engine.drive.cycle import DriveCycle, MotionPieces
from engine.drive.drive import Brake
from engine.drive.limits import LimitChecks, Limits
from engine.drive.mechanisms.by_angle import Arm, ByAngle
from engine.drive.mechanisms.variable_ratio import Linkage
from engine.drive.motor import Falling, TorqueCurve
from engine.drive.results import DriveResults
from engine.drive.train import Train, Window
from workbook.drive.entries import RotatingParts
from workbook.entries.units import DEGREE, KG_CM2, MM, MS, shown, si
from workbook.latest import latest
from workbook.machines.machine.drive.linkages import linkage_of, press_of
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.mechanism import LINKED, SCREWS, Belted, PressCrank
from workbook.machines.machine.selection.in_use import falling_of, left_of, motor_in_use, reducer_in_use
from workbook.machines.machine.view import MovingAxis

T = TypeVar("T")
SHAFTS = ("motor", "mechanism")
SCREW = "lead screw"


def inertia_of(part: RotatingParts) -> float:
    """Return the inertia of one part (kg m²), entered or that of a cylinder."""
    if part.inertia is not None:
        return si(part.inertia, KG_CM2)
    diameter, length, bore = (si(x or 0.0, MM) for x in (part.diameter, part.length, part.bore))
    return cylinder(diameter, length, part.density or 0.0, bore)


def as_a(kind: type[T], what: object) -> T:
    """Return a mechanism, as it is entered or the engine's, as of its kind; raise TypeError for one of another."""
    if not isinstance(what, kind):
        raise TypeError(f"{what} is no {kind.__name__}")
    return what


class Driven:
    """An axis with its drive; ``left`` is the share of its rated torque that the motor has at its temperature."""

    def __init__(self, axis: MovingAxis, machine: AnyMachine) -> None:
        products = machine.selection
        self.axis, self.entered = axis.sized, axis.given
        if axis.given.mechanism is None or axis.given.motor is None:
            raise ValueError(f"{axis.given.name} has no drive")
        self.given, self.holding = axis.given.mechanism, axis.given.motor.holding
        self.catalogued_falling = falling_of(axis.given.motor.name, products)
        self.falling = self.catalogued_falling if products.knows_falling else Falling()
        self.motor_used, self.reducer = motor_in_use(axis.given, products), reducer_in_use(axis.given, products)
        self.motor, self.left = self.motor_used.motor, left_of(axis.given.motor)
        self.number, self.products, self.gravity = axis.number, products, machine.gravity

    @property
    def called(self) -> str:
        """The drive by its axis' name, as its sheet and its checks are called."""
        return f"Drive {self.entered.called}"

    @property
    def travels(self) -> bool:
        """Whether the load travels: with its axis, or as the slide of a crank."""
        return self.entered.unit == "mm" or self.given.SLIDES

    @cached_property
    def linkage(self) -> Linkage | None:
        """The mechanism, of one whose ratio depends on the position."""
        return linkage_of(self.given, self.axis.unit) if self.given.kind in LINKED else None

    @cached_property
    def by_angle(self) -> ByAngle | None:
        """What the load does by the angle of its axis: a slide on a crank, an arm's weight."""
        arm = self.entered.load.arm
        if isinstance(self.given, PressCrank):
            return press_of(self.given)
        return Arm(arm.mass * self.gravity * si(arm.radius, MM), si(arm.angle, DEGREE)) if arm else None

    @property
    def back_efficiency(self) -> float:
        """Efficiency of the mechanism where the load drives it, if none is entered: of a screw 2 − 1/η.

        Source: G. Niemann, Maschinenelemente I, screws: the friction torque is the same both ways.
        """
        entered, forward = self.given.back_efficiency, self.given.efficiency
        if entered is not None:
            return entered
        return 2.0 - 1.0 / forward if self.given.kind in SCREWS else forward

    @cached_property
    def load(self) -> Load:
        """The load at the end of the chain."""
        e = self.entered.load
        if not self.travels:
            return Load(si(e.inertia, KG_CM2), e.torque, e.friction_torque)
        return Slide(e.mass, e.friction, radians(e.slope), e.force, self.gravity).load

    @cached_property
    def parts(self) -> list[Part]:
        """The rotating parts."""
        return [
            Part(p.name, inertia_of(p), SHAFTS.index(p.shaft), p.count,
                 p.teeth_driver / p.teeth_driven if p.teeth_driver and p.teeth_driven else 1.0)
            for p in self.entered.parts
        ]  # fmt: skip

    @cached_property
    def mechanism(self) -> Mechanism:
        """Reducer and mechanism, their parts and the load; a screw is told by its turns a metre, all else by a size."""
        reducer = [Stage("reducer", self.reducer.ratio, self.reducer.efficiency)]
        turned, kind, size = [self.reducer.part, *self.parts], self.given.kind, si(self.given.size, MM)
        size = shown(1.0, size) if kind == SCREW else size
        belt = self.given.belt_mass or 0.0 if isinstance(self.given, Belted) else 0.0
        made = KINDS[kind].of(self.load, size, self.given.efficiency, reducer, turned, belt)
        *gears, last = made.stages
        return replace(made, stages=(*gears, replace(last, back_efficiency=self.back_efficiency)))

    @cached_property
    def drive(self) -> Drive:
        """The motor on it."""
        used = self.motor_used.inertia, self.given.method, self.holding, self.reducer.no_load_torque
        return Drive(self.mechanism, *used, self.motor_used.copper, self.brake)

    @property
    def brake(self) -> Brake:
        """The motor's brake; one that holds any torque, in any dwell, where no figures are entered."""
        entered = self.entered.motor and self.entered.motor.brake
        return Brake(entered.torque, si(entered.closing + entered.opening, MS)) if entered else Brake()

    @property
    def train(self) -> Train:
        """The drive with all that acts on the load."""
        return Train(self.drive, self.linkage, self.entered.load.viscous or 0.0, self.windows, self.by_angle)

    @cached_property
    def drive_cycle(self) -> DriveCycle:
        """The drive over the motion of its axis, at the rate that it is sized at."""
        motion = self.axis.motion
        told = latest("told", motion, partial(MotionPieces.of, motion))
        return DriveCycle(self.train, told, self.axis.speed, self.axis.shifted.shift)

    @cached_property
    def results(self) -> DriveResults:
        """What a cycle asks of the motor, exact."""
        return DriveResults(self.drive_cycle)

    @property
    def judged(self) -> LimitChecks:
        """The drive and its limits, exact: the motor's peak torque is level, or falls beyond its knee."""
        knee, fall = self.falling
        peak, fastest = self.motor.peak_torque, self.motor.max_speed
        torques = np.array([peak, peak, peak - fall * (fastest - knee)])
        curve = TorqueCurve(np.array([0.0, knee, fastest]), torques) if fall else None
        return LimitChecks(self.drive_cycle, Limits(self.motor, curve, self.reducer.limits))

    @cached_property
    def windows(self) -> tuple[Window, ...]:
        """The process forces over the cycle, in rad of the master shaft."""
        found = self.entered.load.windows
        return tuple(Window(si(w.start, DEGREE), si(w.stop, DEGREE), w.force, w.resists) for w in found)

    @property
    def fastest(self) -> float:
        """The greatest geometric velocity (m or rad, per rad)."""
        return max(phase.y1_max for phase in self.axis.motion.phases)

    @property
    def at_motor(self) -> float:
        """Inertia on the motor's shaft, motor included (kg m²)."""
        return self.motor_used.inertia + self.mechanism.on_shaft(0)

    @property
    def beside_motor(self) -> float:
        """Inertia of the parts on the motor's shaft (kg m²), without the reducer's."""
        return self.mechanism.on_shaft(0) - self.reducer.inertia
