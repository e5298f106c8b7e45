"""From the engineer's units to the engine's: mm, degrees, rpm and pieces/min become SI here and nowhere else."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from engine.drive import Drive, Inertia, Load, Motor, Transmission, reflected_inertia
from engine.laws import (
    ConstantAcceleration,
    Cubic,
    Cycloidal,
    Dwell,
    Law,
    ModifiedTrapezoidal,
    Piece,
    PieceLaw,
    TrapezoidalVelocity,
)
from engine.laws.base import Coefficients
from engine.motion import Motion
from engine.timing import Axis, Diagram
from workbook import machine as entered
from workbook.machines.cutting_model import CuttingMachine

MM = 1e-3  # m
RPM = 2 * math.pi / 60  # rad/s
PER_MINUTE = 1 / 60  # 1/s


class OwnLaw(PieceLaw):
    """The own law with the coefficients that cells can find: extremes of its ``intervals + 1`` samples, the exact RMS.

    No closed form leads from a cubic and a sine to their extremes; the workbook's coefficients are therefore those
    of its table, and a movement is judged by the same.
    """

    intervals: int

    def __init__(self, pieces: Sequence[Piece], intervals: int) -> None:
        super().__init__(pieces)
        object.__setattr__(self, "intervals", intervals)

    def _coefficients(self) -> Coefficients:
        exact = super()._coefficients()
        _, v, a, j = self.evaluate(np.arange(self.intervals + 1) / self.intervals)
        return replace(
            exact,
            cv=float(np.abs(v).max()),
            ca_max=float(a.max()),
            ca_min=float(a.min()),
            cj=float(np.abs(j).max()) if math.isfinite(exact.cj) else math.inf,
            va_max=float((v * a).max()),
            va_min=float((v * a).min()),
        )


def laws(given: entered.Laws, intervals: int) -> dict[str, Law]:
    """Return the engine's laws by code, in the order of the Laws sheet; the own law is sampled in ``intervals``."""
    pieces = [Piece(p.duration, (p.c0, p.c1, p.c2, p.c3), p.amplitude, p.omega, p.phase) for p in given.OWN.pieces]
    d = given.MTP.durations
    return {
        "DWL": Dwell(),
        "ACS": ConstantAcceleration(),
        "TVP": TrapezoidalVelocity(given.TVP.rise_end, given.TVP.fall_start),
        "CIC": Cycloidal(),
        "CUB": Cubic(),
        "MTP": ModifiedTrapezoidal((d[0], d[1], d[2], d[3], d[4], d[5], d[6])),
        "OWN": OwnLaw(pieces, intervals),
    }


def axis(given: entered.Axis, library: dict[str, Law]) -> Axis:
    """Return one axis over a turn of the master shaft: m over rad."""
    edges = np.deg2rad([given.phases[0].start, *(p.stop for p in given.phases)])
    lifts = [p.lift * MM for p in given.phases]
    motion = Motion.from_edges(edges, lifts, [library[p.law] for p in given.phases])
    return Axis(given.name, motion, feed=given.closes == "feed")


class Cutting:
    """The engine's view of a cutting machine."""

    def __init__(self, machine: CuttingMachine, library: dict[str, Law]) -> None:
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
