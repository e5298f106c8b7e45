"""A cycle of moves behind a drive in closed form: what :class:`engine.drive.results.DriveResults` finds, another way.

Peak and RMS torque follow from the laws' own integrals, where each phase moves one way at constant ratio (S4).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.drive import STANDSTILL, Drive, Load, Mechanism, Motor
from engine.drive.chain import Method
from engine.drive.drivetrain import Holding
from engine.drive.motor import Reserve, reserve
from engine.laws.base import Array
from engine.laws.inverse import breaks, is_monotone
from engine.motion import Motion, Phase
from tests.engine.integrals import crossings, integral


def direction(speed: ArrayLike) -> Array:
    """Return 1 for a shaft that turns forward, −1 backward, 0 for one that stands."""
    return np.where(np.abs(speed) < STANDSTILL, 0.0, np.sign(speed))


@dataclass(frozen=True)
class OperatingPoints:
    """Speed (rad/s), torque (Nm) and power (W) at the motor shaft, sample by sample.

    ``time`` (s) of each sample, or None for equal steps.
    """

    speed: Array
    torque: Array
    power: Array
    time: Array | None = field(default=None)

    @property
    def peak_torque(self) -> float:
        """max |C_m|"""
        return float(np.abs(self.torque).max())

    @property
    def max_speed(self) -> float:
        """max |ω_m|"""
        return float(np.abs(self.speed).max())

    @property
    def rms_torque(self) -> float:
        """sqrt(∫C_m² dt / t), by the trapezoidal rule on the samples."""
        return math.sqrt(self._mean(self.torque**2))

    @property
    def mean_speed(self) -> float:
        """∫|ω_m| dt / t, by the same rule."""
        return self._mean(np.abs(self.speed))

    def _mean(self, values: Array) -> float:
        time = np.arange(len(values), dtype=np.float64) if self.time is None else self.time
        return float(np.trapezoid(values, time)) / float(time[-1] - time[0])


class ShaftSamples(NamedTuple):
    """Speed (rad/s), acceleration (rad/s²) and torque (Nm) of a shaft; at a load that travels m/s, m/s² and N."""

    speed: Array
    acceleration: Array
    torque: Array


def shafts(drive: Drive, speed: ArrayLike, acceleration: ArrayLike, going: ArrayLike) -> list[ShaftSamples]:
    """What each shaft does, from the motor's to the load's; the first without the motor's own inertia."""
    m = drive.mechanism
    first, *others = m.torques(acceleration, going, drive.method)
    braked = (np.asarray(going) == 0.0) & (drive.holding == "brake")
    found = enumerate([np.where(braked, 0.0, first), *others])
    moved = [np.asarray(of_load, dtype=np.float64) for of_load in (speed, acceleration)]
    return [ShaftSamples(*(m.ratio_from(k) * of_load for of_load in moved), torque) for k, torque in found]


def phase_index(motion: Motion, x: Array) -> Array:
    """The index of the phase at x: on an edge the later one, at the end the last."""
    found = np.searchsorted(motion.edges, x + motion.tolerance, side="right") - 1
    return np.clip(found, 0, len(motion.phases) - 1)


def held_torque(drive: Drive) -> float:
    """Torque of the motor (Nm) at rest."""
    return float(drive.torque(0.0, 0.0))


def effective_inertia(drive: Drive, shaft: int = 0) -> float:
    """The motor's torque per unit of a shaft's acceleration (kg m²), without losses: J_m/τ + τ J_tot."""
    return (drive.motor_inertia + drive.mechanism.inertia()) * drive.mechanism.ratio_to(shaft)


def operating_points(
    drive: Drive, speed: ArrayLike, acceleration: ArrayLike, going: ArrayLike | None = None,
    time: ArrayLike | None = None,
) -> OperatingPoints:  # fmt: skip
    """Speed, torque and power of the motor for speeds and accelerations of the load."""
    v = np.asarray(speed, dtype=np.float64)
    torque = drive.torque(acceleration, direction(v) if going is None else going)
    at = None if time is None else np.asarray(time, dtype=np.float64)
    w = drive.mechanism.ratio * v
    return OperatingPoints(w, torque, torque * w, at)


@dataclass(frozen=True)
class Move:
    """A phase as it is for the drive: its direction and the accelerations of the load, in m (or rad) and s."""

    phase: Phase

    @property
    def direction(self) -> float:
        """1 forward, −1 backward, 0 for a dwell; 1 where it comes back to where it began."""
        return float(np.sign(self.phase.lift)) or float(self.phase.moves)

    @property
    def per(self) -> float:
        """h/t², the acceleration where the law's a is 1."""
        return self.phase.scale / self.phase.duration**2

    @property
    def mean_square(self) -> float:
        """Mean of a², (C_a,rms h/t²)²."""
        return self.phase.y2_rms**2

    @property
    def square(self) -> float:
        """∫a² dt."""
        return self.mean_square * self.phase.duration

    @property
    def gained(self) -> float:
        """∫a dt, the speed that it ends with less that it begins with."""
        return (self.phase.law.end.v - self.phase.law.start.v) * self.phase.scale / self.phase.duration

    @property
    def way(self) -> float:
        """∫|v| dt (m or rad), there and back."""
        law, edges = self.phase.law, breaks(self.phase.law)
        sections = np.union1d(edges, crossings(law.v, edges))
        return abs(self.phase.scale) * integral(lambda xi: np.abs(law.v(xi)), sections)

    @property
    def extremes(self) -> tuple[float, float, float]:
        """Accelerations in its three parts: at the law's largest a, at none, and at its lowest a."""
        k = self.phase.law.coefficients
        return k.ca_max * self.per, 0.0, k.ca_min * self.per


class CyclePart(NamedTuple):
    """A part of a phase and the torque (Nm) in it: the extreme one, where it varies."""

    phase: int
    name: Literal["accelerating", "uniform", "decelerating", "dwell"]
    torque: float


@dataclass(frozen=True)
class Sizing:
    """A mechanism, the phases of its load's motion (m or rad, in s), and the inertia of the motor (kg m²).

    ``method`` and ``holding`` as in :class:`engine.drive.drivetrain.Drive`.
    Raises ValueError for no phases, a negative inertia, or a law that moves backwards.
    """

    mechanism: Mechanism
    phases: Sequence[Phase]
    motor_inertia: float
    method: Method = "physical"
    holding: Holding = "motor"

    def __post_init__(self) -> None:
        object.__setattr__(self, "phases", tuple(self.phases))
        _ = self.drive  # which refuses what cannot be
        if not self.phases:
            raise ValueError("no phases are given; expected at least one")
        for k, phase in enumerate(self.phases, 1):
            if not is_monotone(phase.law):
                raise ValueError(f"phase {k}: {phase.law.name} moves backwards; expected a law that does not")

    @cached_property
    def drive(self) -> Drive:
        """The motor on the mechanism."""
        return Drive(self.mechanism, self.motor_inertia, self.method, self.holding)

    @cached_property
    def motion(self) -> Motion:
        """The load's motion over time (s)."""
        return Motion(self.phases)

    @cached_property
    def moves(self) -> tuple[Move, ...]:
        """The phases as they are for the drive."""
        return tuple(Move(phase) for phase in self.phases)

    @property
    def load_speed(self) -> float:
        """Largest speed of the load (m/s or rad/s)."""
        return self.motion.peaks.y1

    @property
    def max_speed(self) -> float:
        """Largest speed of the motor (rad/s)."""
        return self.mechanism.ratio * self.load_speed

    @cached_property
    def mean_speed(self) -> float:
        """∫|ω_m| dt/t over the cycle (rad/s)."""
        return self.mechanism.ratio * math.fsum(move.way for move in self.moves) / self.motion.total

    @property
    def max_acceleration(self) -> float:
        """Largest acceleration of the motor (rad/s²)."""
        return self.mechanism.ratio * self.motion.peaks.y2

    def parts_of(self, k: int) -> tuple[CyclePart, ...]:
        """Return the torque in each part of a phase: at the law's extremes of acceleration, and without any."""
        move = self.moves[k]
        if move.direction == 0.0:
            return (CyclePart(k, "dwell", held_torque(self.drive)),)
        up, level, down = self.drive.torque(move.extremes, move.direction)
        named = (("accelerating", up), ("uniform", level), ("decelerating", down))
        return tuple(CyclePart(k, name, float(torque)) for name, torque in named)  # type: ignore[arg-type]

    @property
    def parts(self) -> tuple[CyclePart, ...]:
        """The torque in each part of the cycle."""
        return tuple(part for k in range(len(self.phases)) for part in self.parts_of(k))

    @property
    def peak_torque(self) -> float:
        """max |T_m| (Nm), exact."""
        return max(abs(part.torque) for part in self.parts)

    @cached_property
    def rms_torque(self) -> float:
        """sqrt(∫T_m² dt / t) over the cycle (Nm), exact: not from samples. Source: S4, T_RMS."""
        return math.sqrt(math.fsum(self._square(move) for move in self.moves) / self.motion.total)

    def _square(self, move: Move) -> float:
        """Return ∫T_m² dt of a phase."""
        if move.direction == 0.0:
            return held_torque(self.drive) ** 2 * move.phase.duration
        lossless = self.method == "document" or all(s.efficiency == 1.0 for s in self.mechanism.stages)
        return self._square_affine(move) if lossless else self._square_by_stages(move)

    def _square_affine(self, move: Move) -> float:
        """Return ∫T_m² dt where T_m = A a + B: A² ∫a² + 2AB ∫a + B² t, from the law's coefficients."""
        level, raised = self.drive.torque([0.0, 1.0], move.direction)
        slope = raised - level
        mixed = 2.0 * slope * level * move.gained
        return float(slope**2 * move.square + mixed + level**2 * move.phase.duration)

    def _square_by_stages(self, move: Move) -> float:
        """Return ∫T_m² dt, split where the flow of power through a stage turns round."""
        law, per, sign = move.phase.law, move.per, move.direction

        def behind(stage: int) -> Callable[[Array], Array]:
            return lambda xi: self.mechanism.torques(per * law.a(xi), sign, self.drive.method)[stage]

        edges = breaks(law)
        turns = [crossings(behind(k), edges) for k in range(1, self.mechanism.last + 1)]
        sections = np.unique(np.concatenate([edges, *turns]))
        return move.phase.duration * integral(lambda xi: self.drive.torque(per * law.a(xi), sign) ** 2, sections)

    def going(self, time: ArrayLike) -> Array:
        """Return the direction of the motion at times of the cycle (s): that of the phase, also at its ends.

        Raises ValueError outside the cycle.
        """
        directions = np.array([move.direction for move in self.moves])
        return np.asarray(directions[phase_index(self.motion, np.asarray(time, dtype=np.float64))])

    def operating_points(self, time: ArrayLike) -> OperatingPoints:
        """Return speed, torque and power of the motor at times of the cycle (s). Raises ValueError outside it."""
        at = np.asarray(time, dtype=np.float64)
        values = self.motion.at(at)
        return operating_points(self.drive, values.y1, values.y2, self.going(at), at)

    def reserve(self, motor: Motor) -> Reserve:
        """Return RMS torque, peak torque and speed against the motor's limits.

        The motor's own inertia is not taken from ``motor``: see ``motor_inertia``.
        """
        return reserve(motor, self.rms_torque, self.peak_torque, self.max_speed, self.max_speed / 2)


def from_shaft(mechanism, shaft):
    """The mechanism from one of its shafts on, as if the motor sat there."""
    parts = tuple(replace(part, shaft=part.shaft - shaft) for part in mechanism.parts if part.shaft >= shaft)
    return replace(mechanism, stages=mechanism.stages[shaft:], parts=parts)


def reduced(mechanism):
    """The load with all the parts, as the motor's shaft sees them where nothing is lost: T/i, as C_r = F_r R (S1)."""
    load = mechanism.load
    return Load(mechanism.inertia(), load.torque / mechanism.ratio, load.friction / mechanism.ratio)


def lossless_rms(mechanism, phases, inertia):
    """RMS torque (Nm) of a mechanism's first shaft, sqrt(J² ω̇_rms² + ⟨T²⟩), J its torque per ω̇, without losses.

    Source: S1, 'Feeding group', last equation, squared: what resists and what accelerates do not correlate.
    """
    motion, load = Motion(phases), reduced(mechanism)
    going = [float(np.sign(phase.lift)) or float(phase.moves) for phase in phases]
    held = [phase.duration * float(load.resisting(way)) ** 2 for phase, way in zip(phases, going, strict=True)]
    return math.sqrt((inertia * mechanism.ratio * motion.y2_rms) ** 2 + math.fsum(held) / motion.total)
