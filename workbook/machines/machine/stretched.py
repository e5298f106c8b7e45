"""The engine's view of a drive's motion, cut where its acceleration turns and at edges of process forces."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from itertools import chain, repeat
from typing import Any, Protocol

import numpy as np

from engine.drivetrain import Load
from engine.drivetrain.bends import Bends
from engine.laws.base import Array
from engine.machine.bent import BentPart, going, middle, stretches, turned
from engine.machine.pace import Pace
from engine.machine.powering import Powering, flat_up_to
from engine.machine.sharing import Running
from engine.machine.stationary import PLACES, inside, turning
from engine.machine.train import Window
from engine.motion.handover import SEPTIC
from engine.motion.pieces import MotionPiece
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown, si
from workbook.machines.machine.chain import WINDOWS
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.motion import AxisRows
from workbook.motion.sampled import in_piece

QUINTIC = 6
"""powers of a polynomial of the fifth degree"""
FEW, FINE, COARSE = 4, 1.0, 2.0
"""the grid of the sheet Power: with so many drives at most it is fine, in degrees of the master shaft"""


class Paced(Protocol):
    """The highest rate of a drive (1/s), the limit that binds there, and by how much the last trial changed it."""

    @property
    def rate(self) -> float:
        """The highest rate (1/s)."""

    @property
    def limit(self) -> str:
        """The limit that binds there; nothing where none does."""

    @property
    def last_step(self) -> float:
        """By how much the square of the rate changes with the last trial, as a share."""


class Stretched:
    """A drive over the stretches of its axis' motion."""

    def __init__(self, one: AxisRows, driven: Driven) -> None:
        self.one, self.driven = one, driven
        self.pieces = list(one.pieces.pieces)
        self.room, self.near = one.machine.room, one.machine.near

    @property
    def rows(self) -> int:
        """Rows of the table of stretches: for all pieces, two turns of each phase, edges of process forces.

        Where phases hand over, or one is of the seventh degree, it may turn twice more.
        """
        edges = WINDOWS + WINDOWS
        phases = self.one.machine.machine.sizes.phases
        more = [phases, phases] if self.septics or self.one.ends else []
        return sum([self.room, phases, phases, edges, *more])

    @property
    def points(self) -> int:
        """Places at which a torque can be largest: both ends of each stretch."""
        return self.rows + self.rows

    @property
    def septics(self) -> bool:
        """Whether the book has laws of the seventh degree."""
        return self.one.pieces.powers > QUINTIC

    @property
    def places_of_piece(self) -> int:
        """At how many places the acceleration of a piece may turn."""
        return PLACES + 1 if self.septics else PLACES

    def velocity(self, u: str) -> str:
        """Return the formula of y' at a place of a stretch's piece."""
        return in_piece(self.one.pieces, 1, u)

    def acceleration(self, u: str) -> str:
        """Return the formula of y'' there."""
        return in_piece(self.one.pieces, 2, u)

    def jerk(self, u: str) -> str:
        """Return the formula of the third derivative there."""
        return in_piece(self.one.pieces, 3, u)

    def by_ladder(self, bend: str, other: str) -> str:
        """Return the formula of where an acceleration turns: of degree 7 between prescribed ends, or by another."""
        i = self.driven.number
        if not self.one.ends:
            return other
        p = f"INDEX([axis{i}_pieces.p],[r])"
        return f"IF(INDEX([axis{i}_ends.mode],{p})={SEPTIC},INDEX([axis{i}_ends.{bend}],{p}),{other})"

    @cached_property
    def raw(self) -> list[list[float]]:
        """Where the acceleration of each piece turns, inside it or not: u from its begin (rad)."""
        return [self._turning(piece) for piece in self.pieces]

    @property
    def spare_places(self) -> list[float]:
        """The same of a spare row: a piece like the last one, of no duration."""
        return self._turning(replace(self.pieces[-1], duration=0.0))

    def _turning(self, piece: MotionPiece) -> list[float]:
        ends = self.one.ends
        own = ends.bends_of(piece) if ends else []
        return own or turning(piece, self.places_of_piece)

    @cached_property
    def places(self) -> list[list[float]]:
        """The same, those that are not inside at its end."""
        return [inside(piece, each) for piece, each in zip(self.pieces, self.raw, strict=True)]

    @property
    def begins(self) -> list[float]:
        """Where each piece begins, in degrees; spare ones at the end of the turn."""
        return filled([shown(piece.begin, DEGREE) for piece in self.pieces], self.room, TURN)

    @cached_property
    def turned(self) -> list[list[float]]:
        """Where the accelerations turn, in degrees, each piece's first, second and third place; else at the end."""
        found = []
        for j in range(self.places_of_piece):
            each = [
                shown(piece.begin + places[j], DEGREE) if places[j] < piece.duration else TURN
                for piece, places in zip(self.pieces, self.places, strict=True)
            ]
            found.append(filled(each, self.room, TURN))
        return found

    @cached_property
    def edges(self) -> list[float]:
        """The edges of process forces in degrees of the motion as it is told; spare ones at the end of the turn."""
        late = self.driven.axis.given.shift
        windows = self.driven.windows
        found = [turned(shown(edge, DEGREE), -late, TURN, self.near) for w in windows for edge in (w.begin, w.end)]
        return filled(found, WINDOWS + WINDOWS, TURN)

    @cached_property
    def spans(self) -> list[tuple[float, float]]:
        """Begin and end of each stretch, in degrees."""
        further = [angle for angle, _ in self.further]
        cuts = [*self.begins, *chain(*self.turned), *self.edges, self.turn_begin, *further]
        return stretches(cuts, TURN, self.near)

    @property
    def turn_begin(self) -> float:
        """Where the turn of the master shaft begins, in degrees of the motion as it is told."""
        return turned(0.0, -self.driven.axis.given.shift, TURN, self.near)

    @property
    def further(self) -> list[tuple[float, str]]:
        """Where else a stretch begins, in degrees, each with its formula: where a phase turns round."""
        return self.one.ends.turned_round(self.room) if self.one.ends else []

    @cached_property
    def parts(self) -> list[BentPart]:
        """The stretches."""
        return [self._part(span) for span in self.spans]

    def _part(self, span: tuple[float, float]) -> BentPart:
        axis, at = self.driven.axis, middle(span)
        piece = self.pieces[self.piece_at(at)]
        low, high = (si(angle, DEGREE) - piece.begin for angle in span)
        way = going(piece, middle((low, high)), self.driven.fastest)
        bends = self.driven.bends_under(self.driven.acting(si(at, DEGREE) + axis.shifted.shift), way)
        return BentPart(bends, piece, low, high, axis.speed, way, axis.hardest, self.driven.fastest)

    @cached_property
    def pace(self) -> Pace:
        """What they ask for at other rates."""
        motor, driven = self.driven.motor, self.driven
        limits = motor.rated_torque, motor.peak_torque, motor.max_speed, driven.reducer.limits
        return Pace(tuple(self.parts), driven.demand, *limits, driven.falling)

    @property
    def paced(self) -> Paced:
        """Its highest rate."""
        return self.pace

    @property
    def knows_falling(self) -> bool:
        """Whether the book's sheets of drives know motors whose peak torque falls."""
        return self.one.machine.machine.selection.knows_falling

    @property
    def line_asked(self) -> float:
        """What the line of a falling curve must be at no speed (Nm), or a little more; 0 of one that does not fall."""
        return self.pace.against.most(1.0)

    @property
    def corner(self) -> float:
        """The line of a falling curve at no speed (Nm); 0 of one that does not fall."""
        return self.driven.falling.corner(self.driven.motor.peak_torque) if self.driven.falling.fall else 0.0

    @property
    def below_curve(self) -> bool:
        """Whether the torque stays below the motor's curve; of a curve that the book does not know it does not."""
        return self.line_asked <= self.corner if self.knows_falling else not self.driven.told_falling.fall

    @property
    def spare(self) -> float:
        """What is left below the motor's curve at least (Nm)."""
        motor = self.driven.motor
        below = motor.peak_torque - self.driven.demand.torque.peak
        return min(below, self.corner - self.line_asked) if self.driven.falling.fall else below

    @cached_property
    def powers(self) -> list[Powering]:
        """Their power."""
        return [Powering(part, self.flat) for part in self.parts]

    def powering(self, figure: Callable[[Powering], Any], spare: Any = None) -> list[Any]:
        """Return a figure of each stretch's power; spare rows have another, or repeat the last."""
        last = figure(self.powers[-1]) if spare is None else spare
        return filled(map(figure, self.powers), self.rows, last)

    @property
    def ways(self) -> list[float]:
        """The direction of each stretch."""
        return [part.going for part in self.parts]

    @property
    def way(self) -> float:
        """How far the axis goes in a cycle (m or rad), there and back."""
        return self.driven.demand.course.way if self.one.ends else self.driven.way

    def going(self, x: Array) -> Array:
        """Return the direction, 1, −1 or 0, at samples of the master shaft (rad): of the stretch that begins there."""
        told = shown(self.driven.axis.told(x).x, DEGREE)
        begins = np.array([low for low, _ in self.spans])
        found = np.searchsorted(begins, np.minimum(told + self.near, TURN - self.near), side="right") - 1
        return np.array(self.ways)[found]

    @property
    def turning(self) -> float:
        """Speed of the motor (rad/s) for y' = 1."""
        return self.powers[0].turns

    @property
    def flat(self) -> float:
        """The slope of the power over that, up to which it counts as none."""
        driven = self.driven
        return flat_up_to(driven.demand.torque.peak, driven.axis.hardest, driven.axis.speed)

    @property
    def most_power(self) -> float:
        """The largest power (W)."""
        power = self.driven.demand.power
        return max(power.highest.value, -power.lowest.value, 1e-3)

    @property
    def most_snap(self) -> float:
        """The largest fourth derivative of y."""
        return max(1e-9, *(one.snap for one in self.powers))

    @property
    def step(self) -> float:
        """The step of the sheet Power's own grid, in degrees of the master shaft."""
        drives = [axis for axis in self.one.machine.machine.axes if axis.motor]
        return FINE if len(drives) <= FEW else COARSE

    def off(self, one: Powering) -> float:
        """Return by how much straight lines between the places of the sheet Power are off at most (W)."""
        return one.off(si(self.step, DEGREE), self.one.machine.machine.power.efficiency)

    @cached_property
    def most_off(self) -> float:
        """The largest of these (W)."""
        return max(map(self.off, self.powers))

    @property
    def running(self) -> Running:
        """Its power on a common DC bus."""
        return Running(self.powers, self.spans, self.driven.axis.given.shift)

    @property
    def jump_rows(self) -> int:
        """Rows of the table of where its power may jump."""
        return self.rows

    def rowed(self, values: Array) -> list[float]:
        """Return values of the stretches, 0 in spare rows."""
        return filled(values, self.rows)

    def piece_at(self, angle: float) -> int:
        """Return the number of the piece, from 0, in which an angle of the motion lies."""
        return int(np.searchsorted(self.begins[: len(self.pieces)], angle, side="right")) - 1

    def of(self, figure: Callable[[BentPart], Any]) -> list[Any]:
        """Return a figure of each stretch; spare rows repeat the last."""
        return filled(map(figure, self.parts), self.rows, figure(self.parts[-1]))

    def counted(self, figure: Callable[[BentPart], Any]) -> list[Any]:
        """Return a figure of each stretch that is counted up: 0 in spare rows."""
        return filled(map(figure, self.parts), self.rows)

    def passing(self, index: int, turn: int) -> list[float]:
        """Return where y passes one of the levels of each stretch, after some rounds; spare rows are not searched."""
        last = self.parts[-1]
        found = [part.passed(part.levels[index])[turn - 1] for part in self.parts]
        return filled(found, self.rows, last.besides(last.levels[index])[turn - 1])

    @property
    def numbers(self) -> list[int]:
        """The piece of each stretch, from 1."""
        found = [self.piece_at(middle(span)) + 1 for span in self.spans]
        return filled(found, self.rows, found[-1])

    @property
    def middles(self) -> list[float]:
        """The angle of the master shaft in the middle of each stretch."""
        late = self.driven.axis.given.shift
        found = [turned(middle(span), late, TURN, self.near) for span in self.spans]
        return filled(found, self.rows, found[-1])

    @property
    def used(self) -> list[int]:
        """Which rows are no spare ones."""
        return filled(repeat(1, len(self.parts)), self.rows, 0)

    def piece_figures(self, figure: Callable[[MotionPiece], float]) -> list[float]:
        """Return a figure of each stretch's piece."""
        return [figure(self.pieces[number - 1]) for number in self.numbers]


def acting(windows: tuple[Window, ...], going: float) -> Load:
    """Return process forces together, as a load without mass; at rest, those that oppose a motion are none."""
    loads = [window.load for window in windows]
    friction = sum(load.friction for load in loads) if going else 0.0
    return Load(0.0, sum(load.torque for load in loads), friction)


def under(bends: Bends, more: Load, going: float) -> Bends:
    """Return a direction of motion with a load more; at rest, without friction."""
    drive = bends.drive
    own = drive.mechanism.load
    load = Load(own.inertia, own.torque + more.torque, own.friction + more.friction if going else 0.0)
    return replace(bends, drive=replace(drive, mechanism=replace(drive.mechanism, load=load)))
