"""Mean squares of a drive's torque and acceleration by phase, exact also where power turns round. SI units.

The engine finds the turns as zeros of the torque behind each stage, and integrates between them. A law that is known by
its samples alone, like a workbook's own law, adds what the turns change by trapezoids on them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drivetrain.cycle import Move, Sizing
from engine.drivetrain.drive import Drive
from engine.drivetrain.flow import Flow
from engine.laws import Law
from engine.laws.base import Array
from engine.laws.sections import breaks, integral, roots
from engine.motion import Phase


def hinge(law: Law, factor: float, turn: float, power: int, intervals: int | None = None) -> float:
    """Return ∫ max(factor · a(ξ) − turn, 0)^power dξ, exact; by trapezoids on ``intervals`` of the law if given."""
    if factor == 0.0:
        return 0.0

    def above(xi: Array) -> Array:
        found: Array = np.maximum(factor * law.a(xi) - turn, 0.0) ** power
        return found

    if intervals is not None:
        return trapezoids(above, intervals)
    edges = breaks(law)
    return integral(above, np.union1d(edges, roots(lambda xi: factor * law.a(xi) - turn, edges)))


def trapezoids(function: Callable[[Array], Array], intervals: int) -> float:
    """Return the integral of a function of ξ by the trapezoidal rule."""
    xi = np.arange(intervals + 1) / intervals
    return float(np.trapezoid(function(xi), xi))


class Squares(NamedTuple):
    """∫T*² dt, ∫ω̇T* dt and ∫ω̇² dt of a phase or a cycle, at the motor's shaft, without the motor's own inertia."""

    torque: float
    product: float
    acceleration: float


@dataclass(frozen=True)
class BentPhase:
    """A phase in the flow of its direction: what its mean squares are made of.

    In it T* = B + A b, b the acceleration in the direction of motion, until a stage gives back. ``intervals`` are those
    of a law that is known by its samples.
    """

    drive: Drive
    phase: Phase
    intervals: int | None = None

    @cached_property
    def move(self) -> Move:
        """Its direction and accelerations."""
        return Move(self.phase)

    @cached_property
    def flow(self) -> Flow:
        """The torque's bends in its direction."""
        return Flow(self.drive, self.move.direction or 1.0)

    @property
    def sign(self) -> float:
        """1 where the load resists the motion, or nothing moves; −1 where it drives."""
        return self.flow.sign if self.move.direction else 1.0

    @property
    def per(self) -> float:
        """b where the law's a is 1."""
        return abs(self.move.per)

    @property
    def mean(self) -> float:
        """⟨b⟩."""
        return self.per * (self.phase.law.end.v - self.phase.law.start.v)

    @property
    def level(self) -> float:
        """B (Nm): the torque at b = 0; in a dwell what is held."""
        resting = self.drive.held_torque
        return self.flow.level if self.move.direction else resting

    @property
    def slope(self) -> float:
        """A (Nm per m/s² or rad/s²)."""
        return self.flow.slope if self.move.direction else 0.0

    @property
    def factor(self) -> float:
        """y where the law's a is 1: y is the acceleration against the load's R."""
        return -self.sign * self.per

    @property
    def peak(self) -> float:
        """Largest y."""
        k = self.phase.law.coefficients
        return self.per * (-k.ca_min if self.sign > 0.0 else k.ca_max)

    @property
    def shares(self) -> Array:
        """Of each stage, the turn's y_s as a share of the largest y, and 1 where that is not reached."""
        reached = self.flow.turn < self.peak
        return np.divide(self.flow.turn, self.peak, out=np.ones_like(self.flow.turn), where=reached)

    @property
    def angles(self) -> Array:
        """acos of the shares (rad): where a quarter sine passes the turn."""
        return np.arccos(self.shares)

    def hinge(self, stage: int, power: int) -> float:
        """Return ∫(y − y_s)+^power dξ of a stage, counted from the load's: N1 and N2."""
        return hinge(self.phase.law, self.factor, float(self.flow.turn[stage]), power, self.intervals)

    @cached_property
    def squares(self) -> Squares:
        """The integrals at the motor's shaft."""
        m = self.drive.mechanism
        grown = self.move.square * m.ratio**2
        if self.intervals is not None and self.move.direction:
            return Squares(*self._sampled(self.intervals), grown)
        torque = self._torque_square(0.0)
        if torque == 0.0 or grown == 0.0:
            return Squares(torque, 0.0, grown)
        inertia = math.sqrt(torque / grown)  # of a size that loses no digits
        both = self._torque_square(inertia)
        return Squares(torque, (both - torque - inertia**2 * grown) / (2.0 * inertia), grown)

    @property
    def torque_square(self) -> float:
        """∫T*² dt (N² m² s)."""
        return self.squares.torque

    @property
    def load_product(self) -> float:
        """∫b T* dt, b the acceleration of the load in m/s² or rad/s²."""
        return self.squares.product / self.drive.mechanism.ratio

    @property
    def load_square(self) -> float:
        """∫b² dt."""
        return self.squares.acceleration / self.drive.mechanism.ratio**2

    def _torque_square(self, inertia: float) -> float:
        """Return ∫T² dt with an inertia on the motor's shaft."""
        d = self.drive
        one = Sizing(d.mechanism, [self.phase], inertia, d.method, d.holding)
        return one.rms_torque**2 * self.phase.duration

    def _sampled(self, intervals: int) -> tuple[float, float]:
        """Return ∫T*² dt and ∫ω̇T* dt of a movement: what the turns add comes from the law's samples."""
        direction, per, i = self.move.direction, self.move.per, self.drive.mechanism.ratio
        level, slope, law = direction * self.level, self.slope, self.phase.law
        gained, square = per * (law.end.v - law.start.v), self.move.mean_square

        def bent(xi: Array, order: int) -> Array:
            a = per * law.a(xi)
            true, straight = self.drive.torques(a, direction)[0], level + slope * a
            return np.asarray(true**2 - straight**2 if order == 2 else i * a * (true - straight))

        straight2 = slope**2 * square + 2.0 * slope * level * gained + level**2
        straight1 = i * (slope * square + level * gained)
        added2, added1 = trapezoids(lambda xi: bent(xi, 2), intervals), trapezoids(lambda xi: bent(xi, 1), intervals)
        return self.phase.duration * (straight2 + added2), self.phase.duration * (straight1 + added1)


@dataclass(frozen=True)
class CycleSquares:
    """The phases of a cycle with their mean squares: what a choice of motor and reducer asks for."""

    phases: Sequence[BentPhase]

    @property
    def time(self) -> float:
        """Time of the cycle (s)."""
        return math.fsum(p.phase.duration for p in self.phases)

    @cached_property
    def total(self) -> Squares:
        """The integrals over the cycle."""
        return Squares(*(math.fsum(column) for column in zip(*(p.squares for p in self.phases), strict=True)))

    @property
    def torque(self) -> float:
        """T*_rms (Nm) at the motor's shaft, without the motor."""
        return math.sqrt(max(self.total.torque, 0.0) / self.time)

    @property
    def product(self) -> float:
        """⟨ω̇ T*⟩ (Nm rad/s²)."""
        return self.total.product / self.time

    @property
    def acceleration(self) -> float:
        """ω̇_rms (rad/s²)."""
        return math.sqrt(self.total.acceleration / self.time)

    def rms_torque(self, inertia: float) -> float:
        """Return the RMS torque (Nm) of a motor of an inertia (kg m²), T_m = T* + J_m ω̇."""
        square, product, grown = self.total
        return math.sqrt(max(square + 2.0 * inertia * product + inertia**2 * grown, 0.0) / self.time)
