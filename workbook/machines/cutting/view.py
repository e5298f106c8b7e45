"""The engine's view of a cutting machine, in SI units."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drivetrain import KINDS, Drive, Mechanism, Motor, OperatingPoints, Part, Stage, direction, resisting
from engine.drivetrain.chain import geared
from engine.drivetrain.losses import loss_factor, rounding_of
from engine.drivetrain.lossless import LosslessCycle, at_shaft
from engine.drivetrain.motor import Reserve, reserve
from engine.laws import Law
from engine.laws.base import Array
from engine.motion import Motion, MotionValues
from engine.motion.joining import Joined, joined
from engine.timing import Axis, Diagram, shaft_speed
from workbook.entries.texts import place_of
from workbook.entries.units import DEGREE, MM, PER_MINUTE, RPM, si
from workbook.machines.cutting import entries as entered
from workbook.motion.through import passed

ROLLERS = 1
"""the rollers' shaft, behind the reducer"""


class DriveSamples(NamedTuple):
    """The driven axis over the cycle: geometric values; at the rollers' shaft speed, acceleration and torques."""

    geometric: MotionValues[Array]
    speed: Array
    acceleration: Array
    direction: Array
    resisting: Array
    load: Array
    loss: Array
    motor: OperatingPoints


def motion_of(given: entered.Axis, library: dict[str, Law]) -> Joined:
    """Return the motion of one axis over a turn of the master shaft, m over rad: phases that hand velocity over."""
    edges = np.deg2rad([given.phases[0].start, *(p.stop for p in given.phases)])
    lifts = [si(p.lift, MM) for p in given.phases]
    motion = Motion.from_edges(edges, lifts, [library[p.law] for p in given.phases])
    return joined(motion.phases, passed(given.phases), start=float(edges[0]), shares=False)


class Cutting:
    """The engine's view of a cutting machine."""

    def __init__(self, machine: entered.CuttingMachine, library: dict[str, Law]) -> None:
        self.machine = machine
        self.joined = [motion_of(a, library) for a in machine.timing.axes]
        self.axes = [
            Axis(a.name, found.motion, feed=a.closes == "feed")
            for a, found in zip(machine.timing.axes, self.joined, strict=True)
        ]
        self.diagram = Diagram(self.axes)
        self.rate = si(machine.timing.rate, PER_MINUTE)

    @property
    def hands_over(self) -> bool:
        """Whether phases may hand velocity over: where the book has a straight line."""
        return bool(self.machine.laws.of("LIN"))

    @property
    def room(self) -> int:
        """Rows of the table of an axis's pieces."""
        return self.machine.sizes.motion_pieces or 0

    @cached_property
    def angles(self) -> Array:
        """The sampled angles of the master shaft in degrees."""
        return np.linspace(0.0, 360.0, self.machine.sizes.cycle + 1)

    @property
    def speed(self) -> float:
        """Speed of the master shaft for the timing diagram (rad/s)."""
        return shaft_speed(self.rate)

    @property
    def drive_speed(self) -> float:
        """Speed of the master shaft for the drive (rad/s)."""
        return shaft_speed(si(self.machine.drive.rate, PER_MINUTE))

    @cached_property
    def driven(self) -> Axis:
        """The axis that the drive moves."""
        names = [axis.name for axis in self.diagram.axes]
        return self.diagram.axis(names[place_of(self.machine.drive.axis, names)])

    @cached_property
    def parts(self) -> list[Part]:
        """The rotating parts on the rollers' shaft, or geared to it."""
        rotors = self.machine.drive.rotors
        return [Part(r.name, r.inertia, ROLLERS, r.count, geared(r.teeth_driver, r.teeth_driven)) for r in rotors]

    @cached_property
    def mechanism(self) -> Mechanism:
        """Reducer and rollers, and what resists at the product."""
        d = self.machine.drive
        reducer = Stage("reducer", d.motor.reduction, d.motor.efficiency)
        return KINDS["feed rollers"].of(resisting(d.force, d.resists), d.radius, gears=[reducer], parts=self.parts)

    @cached_property
    def drive(self) -> Drive:
        """The motor on its mechanism."""
        return Drive(self.mechanism, self.machine.drive.motor.inertia)

    @cached_property
    def asked(self) -> LosslessCycle:
        """What the phases ask for at the rollers' shaft, exact by the laws."""
        behind = self.mechanism.behind(ROLLERS)
        phases = at_shaft(self.driven.motion.phases, behind.ratio, self.drive_speed)
        return LosslessCycle(behind.reduced, phases)

    @cached_property
    def samples(self) -> DriveSamples:
        """The driven axis over the cycle."""
        at = si(self.angles, DEGREE)
        _, v, a = self.driven.motion.at_speed(at, self.drive_speed)
        going = direction(self.mechanism.turning(ROLLERS, v))
        shaft = self.drive.shafts(v, a, going)[ROLLERS]
        return DriveSamples(
            self.driven.motion.at(at), shaft.speed, shaft.acceleration, going,
            self.mechanism.referred(self.mechanism.load.resisting(going), ROLLERS), shaft.torque,
            loss_factor(shaft.torque, going, self.mechanism.stages[0].efficiency, near=rounding_of(shaft.torque)),
            self.drive.operating_points(v, a, going),
        )  # fmt: skip

    @cached_property
    def times(self) -> Array:
        """The sampled times of the drive's cycle (s)."""
        return np.linspace(0.0, self.asked.time, len(self.angles))

    @cached_property
    def motor(self) -> Motor:
        """The motor with its limits."""
        m = self.machine.drive.motor
        return Motor(m.inertia, m.rated_torque, m.peak_torque, si(m.max_speed, RPM))

    @property
    def reserve(self) -> Reserve:
        """What the cycle asks of the motor against its limits."""
        points = self.samples.motor
        return reserve(self.motor, points.rms_torque, points.peak_torque, points.max_speed)
