"""Sizing of an actuator (S4): the engine's view of what was entered."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from math import radians

import numpy as np

from engine.drivetrain import (
    KINDS,
    Drive,
    Load,
    Mechanism,
    Motor,
    Part,
    Sizing,
    Slide,
    Stage,
    cylinder,
    derating,
    motor_inertia,
)
from engine.drivetrain.cycle import Move
from engine.drivetrain.flow import Flow
from engine.drivetrain.loads import masses
from engine.drivetrain.magnitudes import Magnitudes
from engine.drivetrain.motor import Reserve, reserve
from engine.drivetrain.squares import BentPhase, CycleSquares
from engine.laws import Law
from engine.laws.base import Array
from engine.motion import Phase
from workbook.book.rows import filled
from workbook.drive.entries import PlacedParts
from workbook.entries.units import DEGREE, MM, RPM, shown, si
from workbook.machines.actuator.entries import ActuatorSizing

SPARE = Stage("none", 1.0)
"""a row of gears that is not used"""


def inertia_of(part: PlacedParts) -> float:
    """Return the inertia of one part (kg m²), entered or that of a cylinder."""
    if part.inertia is not None:
        return part.inertia
    diameter, length, bore = (si(x or 0.0, MM) for x in (part.diameter, part.length, part.bore))
    return cylinder(diameter, length, part.density or 0.0, bore)


class Sized:
    """Mechanism, sizing, and the load at the shaft that the motor is coupled to."""

    def __init__(self, machine: ActuatorSizing, library: dict[str, Law]) -> None:
        self.given, self.sizes = machine.actuator, machine.sizes
        self.kind = KINDS[self.given.mechanism]
        self.unit = MM if self.kind.travels else DEGREE
        self.numbers = [machine.laws.number(p.law) for p in self.given.phases]
        self.phases = [Phase(library[p.law], si(p.lift, self.unit), p.duration) for p in self.given.phases]

    @property
    def room(self) -> int:
        """Rows of the table of the motion's pieces."""
        return self.sizes.motion_pieces or 0

    @cached_property
    def load(self) -> Load:
        """The load at the end of the chain."""
        e = self.given.load
        if not self.kind.travels:
            return Load(e.inertia, e.torque, e.friction_torque)
        return Slide(masses(e.mass, e.count), e.friction, radians(e.slope), e.force).load

    @property
    def mass(self) -> float:
        """Mass of the load that travels (kg)."""
        return masses(self.given.load.mass, self.given.load.count)

    @property
    def belt(self) -> float:
        """Mass of the belt, where one moves with the load (kg)."""
        return self.given.load.belt if self.kind.belt else 0.0

    @cached_property
    def parts(self) -> list[Part]:
        """The rotating parts entered."""
        return [Part(p.name, inertia_of(p), int(p.shaft), p.count) for p in self.given.parts]

    @property
    def size(self) -> float:
        """Size of the last element: turns a metre of a screw, else the diameter (m)."""
        out = self.given.output
        return si(out.diameter or 0.0, MM) if self.kind.name != "lead screw" else shown(out.turns or 0.0, MM)

    @cached_property
    def mechanism(self) -> Mechanism:
        """The chain, with a lossless stage of ratio 1 for each row of gears that is not used."""
        gears = filled([Stage(g.name, g.ratio, g.efficiency) for g in self.given.gears], self.sizes.gears, SPARE)
        efficiency = self.given.output.efficiency if self.kind.travels else 1.0
        return self.kind.of(self.load, self.size, efficiency, gears, self.parts, self.belt)

    @cached_property
    def motor_inertia(self) -> float:
        """J_m in kg m², entered or by the ratio."""
        m = self.given.motor
        if m.inertia is not None:
            return m.inertia
        return motor_inertia(self.mechanism, m.inertia_ratio or 0.0, self.given.method)

    @cached_property
    def sizing(self) -> Sizing:
        """The cycle as entered."""
        return Sizing(self.mechanism, self.phases, self.motor_inertia, self.given.method, self.given.holding)

    @property
    def drive(self) -> Drive:
        """The motor on the mechanism."""
        return self.sizing.drive

    @cached_property
    def sides(self) -> Magnitudes:
        """What deviations are measured by."""
        return Magnitudes(self.sizing)

    @cached_property
    def time(self) -> Array:
        """The sampled times of the cycle in s."""
        return np.linspace(0.0, self.sizing.motion.total, self.sizes.cycle + 1)

    def of_moves(self, figure: Callable[[Move], float]) -> list[float]:
        """Return a figure of each phase, 0 in the spare rows."""
        return filled([figure(move) for move in self.sizing.moves], self.sizes.phases)

    @cached_property
    def part_torques(self) -> list[list[float]]:
        """Torque of the motor (Nm) in the three parts of each row of phases: a dwell's three times, a spare row's 0."""
        found = []
        for k in range(len(self.phases)):
            torques = [part.torque for part in self.sizing.parts_of(k)]
            found.append(torques if len(torques) == 3 else [torques[0] for _ in range(3)])
        return filled(found, self.sizes.phases, [0.0, 0.0, 0.0])

    @cached_property
    def flows(self) -> dict[str, Flow]:
        """Both directions of motion."""
        return {"forward": Flow(self.drive, 1.0), "backward": Flow(self.drive, -1.0)}

    @cached_property
    def bent(self) -> list[BentPhase]:
        """The phases in the flow of power; a law of other shapes adds by its samples, as its cells do."""
        return [BentPhase(self.drive, p, None if p.law.shapes() is not None else self.sizes.law) for p in self.phases]

    @cached_property
    def squares(self) -> CycleSquares:
        """Mean squares of the cycle at the motor's shaft."""
        return CycleSquares(self.bent)

    @cached_property
    def rms_torque(self) -> float:
        """T_RMS of the motor, Nm: exact, but for what power flowing back adds to movements by the own law."""
        if any(phase.intervals is not None for phase in self.bent):
            return self.squares.rms_torque(self.motor_inertia)
        return self.sizing.rms_torque

    @property
    def derating(self) -> float:
        """Share of the rated torque that is left at the motor's temperature."""
        m = self.given.motor
        return derating(m.temperature, m.limit, m.rated_at)

    @property
    def motor(self) -> Motor:
        """The motor with its limits, its rated torque as the temperature leaves it."""
        m = self.given.motor
        limits = Motor(self.motor_inertia, m.rated_torque, m.peak_torque, si(m.max_speed, RPM))
        return limits.derated(self.derating)

    @cached_property
    def reserve(self) -> Reserve:
        """What the cycle asks of the motor against its limits."""
        return reserve(self.motor, self.rms_torque, self.sizing.peak_torque, self.sizing.max_speed)
