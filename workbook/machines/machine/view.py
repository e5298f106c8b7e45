"""The engine's view of a machine of any axes, in SI units."""

from copy import copy
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from engine.laws import Dwell, Law
from engine.laws.base import Array
from engine.laws.polynomials import BoundaryLine, BoundaryPolynomial
from engine.motion import Motion, MotionValues, Phase
from engine.motion.joining import JoinedMotion, Rates, join_phases
from engine.motion.pieces import MotionPiece, motion_pieces
from engine.motion.shifted import Shifted, Unshifted
from engine.timing import shaft_speed, turn_time
from workbook.entries.abscissa import Abscissa
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, MM, PER_MINUTE, Real, shown, si
from workbook.machines.machine import entries as entered
from workbook.machines.machine.places import axis_in_degrees

UNITS = {"mm": MM, "°": DEGREE}
BASES = {"mm": "m", "°": "rad"}  # the unit of the motion, by that of its entries


class MovingAxis:
    """An axis: its motion with the rests between its phases, and the places of both in tables of steps.

    ``given`` has its places in degrees of a turn, ``typed`` in the unit of the abscissa ``over``, as entered.
    """

    def __init__(
        self,
        given: entered.Axis,
        number: int,
        library: dict[str, Law],
        speed: float,
        typed: entered.Axis,
        over: Abscissa,
    ) -> None:
        self.given, self.number, self.library = given, number, library
        self.speed, self.typed, self.over = speed, typed, over
        self.unit, self.base = UNITS[given.unit], BASES[given.unit]

    @property
    def sized(self) -> Self:
        """The axis at the rate that its drive is sized at."""
        if self.given.rate is None:
            return self
        return self.at_speed(shaft_speed(si(self.given.rate, PER_MINUTE)))

    def at_speed(self, speed: float, given: entered.Axis | None = None) -> Self:
        """Return the axis at a speed (rad/s), ``given`` with another drive: of the same motion over a turn."""
        _ = self.motion  # worked out once for both
        other = copy(self)
        other.given, other.speed = given or self.given, speed
        return other

    @cached_property
    def places(self) -> list[int]:
        """The row, from 0, of each step: rests stand in the first, third, fifth row, phases between them."""
        phases = self.given.phases
        return sorted([*(2 * i for i in entered.rests(phases)), *(2 * i + 1 for i in range(len(phases)))])

    @cached_property
    def entered(self) -> list[int]:
        """The numbers in the motion, from 0, of the phases as entered."""
        return [k for k, place in enumerate(self.places) if place % 2]

    @cached_property
    def motion(self) -> Motion:
        """The motion over a turn: m, or rad, over rad; extremes of phases that meet at speed are those at points."""
        return with_extremes(self.joined.motion)

    @cached_property
    def entered_rates(self) -> dict[int, Rates]:
        """Velocity and acceleration entered for the begin of phases, by the numbers of these in the motion."""
        passing = ((k, p) for k, p in zip(self.entered, self.given.phases, strict=True) if p.passes)
        return {k: Rates(phase.velocity or 0.0, phase.acceleration or 0.0) for k, phase in passing}

    @cached_property
    def joined(self) -> JoinedMotion:
        """The motion, with what its phases take from their neighbours: rests are among these.

        A phase lasts what its end is later than its begin as both are entered: of places in rad that would lose digits.
        """
        phases, steps = self.given.phases, list[tuple[Law, float, float]]()
        ends = [0.0, *(p.stop for p in phases)]
        for place in self.places:
            i = place // 2
            moved = (self.library[phases[i].law], phases[i].lift, phases[i].start) if place % 2 else None
            steps.append(moved or (Dwell(), 0.0, ends[i]))
        last = ends[-1] if self.places[-1] % 2 else TURN
        spans = si(np.diff([*(begin for *_, begin in steps), last]), DEGREE).tolist()
        steps_as_phases = [
            Phase(law, si(lift, self.unit), span) for (law, lift, _), span in zip(steps, spans, strict=True)
        ]
        start, begin = si(steps[0][2], DEGREE), si(self.given.position, self.unit)
        return join_phases(steps_as_phases, self.entered_rates, self.given.repeats, start, begin)

    @property
    def closes(self) -> bool:
        """Whether the cycle comes back to where it began; a feed, and what is open, need not."""
        return self.given.closes != "position" or self.motion.closes

    @property
    def phases(self) -> list[Phase]:
        """The phases as entered."""
        return [self.motion.phases[k] for k in self.entered]

    @cached_property
    def moves(self) -> dict[int, Phase]:
        """The phases that move, by their number as entered, from 0."""
        return {i: phase for i, phase in enumerate(self.phases) if phase.moves}

    @cached_property
    def shifted(self) -> Shifted:
        """The motion as late as it is entered."""
        return Shifted(self.motion, si(self.given.shift, DEGREE))

    def unshifted(self, at: Array) -> Unshifted:
        """Return where samples lie in the motion before its shift."""
        return self.shifted.unshifted(at)

    def at(self, x: Array) -> MotionValues[Array]:
        """Return the motion at samples."""
        return self.shifted.over_cycle(x)

    def rate(self, size: Real) -> Real:
        """Return a velocity, acceleration or jerk as it is shown, from SI."""
        return shown(size, self.over.lift(self.given.unit).size)

    def size(self, order: int) -> float:
        """Return how large a derivative grows, as it is shown."""
        return self.rate(self.motion.size(order) * self.speed**order)

    @property
    def max_velocity(self) -> float:
        """The greatest velocity as it is shown: in m/s, or rad/s, or in lift by abscissa."""
        return self.rate(max((m.y1_max * self.speed for m in self.moves.values()), default=0.0))

    @property
    def max_acceleration(self) -> float:
        """The greatest acceleration as it is shown: in m/s², or rad/s², or in lift by abscissa²."""
        return self.rate(max((m.y2_max * self.speed**2 for m in self.moves.values()), default=0.0))

    @property
    def greatest_lift(self) -> float:
        """The greatest size of a lift, in its unit."""
        return max(abs(shown(phase.lift, self.unit)) for phase in self.motion.phases)

    @property
    def missing_lift(self) -> float:
        """The most that a law leaves of its lift."""
        return max(abs(phase.missing_lift) for phase in self.motion.phases)


def moving_axes(machine: entered.AnyMachine, library: dict[str, Law], first: int = 1) -> list[MovingAxis]:
    """Return the motions of a machine's axes, by laws of a ``library``, numbered from ``first``."""
    over, speed = machine.over, shaft_speed(si(machine.per_minute, PER_MINUTE))
    return [
        MovingAxis(axis_in_degrees(axis, over), i, library, speed, axis, over)
        for i, axis in enumerate(machine.axes, first)
    ]


class MachineView:
    """The engine's view of a machine.

    A turn lasts its ``time`` (s), at the ``speed`` of the master shaft (rad/s), over an abscissa that tells no time by
    its unit. A machine that ``hands_over`` velocity between phases has a
    straight line in its book. ``angles`` are the samples of the master shaft in degrees, ``samples`` in rad.
    """

    def __init__(self, machine: entered.AnyMachine, axes: list[MovingAxis]) -> None:
        self.given, self.axes, self.over = machine, axes, machine.over
        rate = si(machine.per_minute, PER_MINUTE)
        self.time = turn_time(rate)
        self.speed = shaft_speed(rate)
        self.hands_over = bool(machine.laws.of("LIN"))
        self.angles = np.linspace(0.0, TURN, machine.sizes.cycle + 1)
        self.samples: Array = si(self.angles, DEGREE)

    @property
    def near(self) -> float:
        """The distance from the begin of a phase that counts as on it, in degrees."""
        return shown(self.axes[0].motion.tolerance, DEGREE)


# where a piece is looked at for its extremes, as shares of its duration
POINTS = np.linspace(0.0, 1.0, 201)


def at_points(piece: MotionPiece, order: int) -> Array:
    """Return the position (order 0) or a derivative of a piece at its points."""
    return piece.curves[order](piece.duration * POINTS)


@dataclass(frozen=True)
class MeasuredPhase(Phase):
    """A phase with prescribed ends whose extremes are those of its ``parts`` at points.

    The velocity, acceleration and jerk of a law of two pulses are exact by the heights of its pulses.
    """

    parts: tuple[MotionPiece, ...] = ()

    def _most(self, order: int, exact: float) -> float:
        if not isinstance(self.law, BoundaryPolynomial | BoundaryLine):
            return exact
        return max(float(np.abs(at_points(piece, order)).max()) for piece in self.parts)

    @cached_property
    def y1_max(self) -> float:
        """Largest |y'|."""
        return self._most(1, super().y1_max)

    @cached_property
    def y2_max(self) -> float:
        """Largest |y''|."""
        return self._most(2, super().y2_max)

    @cached_property
    def y3_max(self) -> float:
        """Largest |y'''|; infinite where the acceleration jumps."""
        return self._most(3, super().y3_max)


class MeasuredMotion(Motion):
    """A motion with such phases."""

    @cached_property
    def reaches(self) -> tuple[tuple[float, float], ...]:
        """The lowest and the highest position of each phase."""
        reaches = list(super().reaches)
        for k, phase in enumerate(self.phases):
            if isinstance(phase, MeasuredPhase):
                y = np.concatenate([at_points(piece, 0) for piece in phase.parts])
                reaches[k] = float(y.min()), float(y.max())
        return tuple(reaches)


def with_extremes(motion: Motion) -> Motion:
    """Return a motion with the extremes at points; itself where no phase has prescribed ends."""
    if not any(phase.origin for phase in motion.phases):
        return motion
    pieces = motion_pieces(motion)
    phases = list(motion.phases)
    for k, phase in enumerate(phases):
        if phase.origin:
            parts = tuple(piece for piece in pieces if piece.phase == k)
            phases[k] = MeasuredPhase(phase.law, phase.lift, phase.duration, phase.origin, parts)
    return MeasuredMotion(phases, float(motion.edges[0]), motion.position)
