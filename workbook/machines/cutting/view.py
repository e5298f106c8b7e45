"""The engine's view of a cutting machine, in SI units."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from engine.drive import Drive, Inertia, Load, Motor, Transmission, reflected_inertia
from engine.laws import Law
from engine.motion import Motion
from engine.timing import Axis, Diagram
from workbook.entries.units import MM, PER_MINUTE, RPM
from workbook.machines.cutting import entries as entered


def axis(given: entered.Axis, library: dict[str, Law]) -> Axis:
    """Return one axis over a turn of the master shaft: m over rad."""
    edges = np.deg2rad([given.phases[0].start, *(p.stop for p in given.phases)])
    lifts = [p.lift * MM for p in given.phases]
    motion = Motion.from_edges(edges, lifts, [library[p.law] for p in given.phases])
    return Axis(given.name, motion, feed=given.closes == "feed")


class Cutting:
    """The engine's view of a cutting machine."""

    def __init__(self, machine: entered.CuttingMachine, library: dict[str, Law]) -> None:
        self.machine = machine
        self.axes = [axis(a, library) for a in machine.timing.axes]
        self.diagram = Diagram(self.axes)
        self.rate = machine.timing.rate * PER_MINUTE

    @cached_property
    def angles(self) -> NDArray[np.float64]:
        """The sampled angles of the master shaft in degrees."""
        n = self.machine.sizes.cycle
        return np.arange(n + 1) * 360.0 / n

    @cached_property
    def driven(self) -> Axis:
        """The axis that the drive moves."""
        return self.diagram.axis(self.machine.drive.axis)

    @cached_property
    def rotors(self) -> list[Inertia]:
        """The rotating parts, with the speed ratio that their teeth give."""
        return [
            Inertia(
                r.name,
                r.count,
                r.inertia,
                r.teeth_driver / r.teeth_driven if r.teeth_driver and r.teeth_driven else 1.0,
            )
            for r in self.machine.drive.rotors
        ]

    @cached_property
    def drive(self) -> Drive:
        """Load, reducer and motor."""
        d = self.machine.drive
        return Drive(
            Load(reflected_inertia(self.rotors), d.force * d.radius, d.resists),
            Transmission(1 / d.motor.reduction, d.motor.efficiency),
            Motor(d.motor.inertia, d.motor.rated_torque, d.motor.peak_torque, d.motor.max_speed * RPM),
        )
