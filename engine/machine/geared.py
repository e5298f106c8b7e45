"""What a motion asks of many motors behind many reducers at many rates: found once for all of them. SI units.

Speed, acceleration and torque of the shaft behind a reducer hang neither on it nor on the motor. Before it, with J all
that turns with the motor, T = J i α + f S/i: f is 1/η where S drives the load and η where the load drives it. Over a
part in which α only rises or only falls, S turns round once at most at each rate, and so does the power of each motor:
squares of T are sums of three integrals, its peaks lie at ends. :class:`engine.machine.demand.Demand` finds the same of
one drive at one rate, also behind a ratio that changes, by its stretches.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drivetrain.chain import Mechanism, Stage
from engine.drivetrain.losses import gives_back
from engine.laws.base import Array
from engine.laws.ladder import zeros
from engine.machine.course import Course, Span, position, trimmed
from engine.machine.rows import Rows, rows_of
from engine.machine.searching import rule

HALVES = 40
"""of a part, to find where power turns round: work errs by the square of what is left"""
NODES = 32
AT_ONCE = 1 << 18
"""values of which arrays are made"""


class Gears(NamedTuple):
    """Motors with their reducers, arrays of one length: J (kg m²) on the motor's shaft, i, η, and which rate."""

    inertia: Array
    ratio: Array
    efficiency: Array
    rate: NDArray[np.intp]

    def parts(self, width: int) -> Iterator[Gears]:
        """Yield them in parts of which each has no more than :data:`AT_ONCE` values, ``width`` for each motor."""
        step = max(1, AT_ONCE // width)
        for begin in range(0, len(self.inertia), step):
            one = slice(begin, begin + step)
            yield Gears(self.inertia[one], self.ratio[one], self.efficiency[one], self.rate[one])


class Torques(NamedTuple):
    """Lowest and highest torque of each motor (Nm)."""

    lowest: Array
    highest: Array

    @property
    def peak(self) -> Array:
        """The largest size."""
        return np.maximum(np.abs(self.lowest), np.abs(self.highest))


class Works(NamedTuple):
    """Work of each motor over a cycle (J): what it drives with, and what comes back to it, both 0 or more."""

    driving: Array
    regenerated: Array


class Lines(NamedTuple):
    """Every part at every rate, cut where a torque turns round: arrays of parts, rates, and what lies between cuts.

    From ``low`` to ``high`` S = ``mass`` α + ``level``; ``back`` where it is driven by the load, ``held`` 1 where it
    reaches the motor, 0 where a brake holds the motor's shaft.
    """

    low: Array
    high: Array
    mass: Array
    level: Array
    back: NDArray[np.bool_]
    held: Array


class Moments(NamedTuple):
    """By rate: ⟨α²⟩; ⟨α S⟩ and ⟨S²⟩ where S drives the load, and where the load drives it; the mean torque S (Nm)."""

    own: Array
    mixed: Array
    mixed_back: Array
    behind: Array
    behind_back: Array
    mean: Array


@dataclass(frozen=True)
class Geared:
    """A course as the shaft behind its first stage knows it; that stage, the motor and what turns with it do not count.

    Its abscissa advances at each of ``speeds`` (1/s) instead of its own. Raises ValueError for a ratio that depends on
    position, or a viscous resistance: there S is no line over α.
    """

    course: Course
    speeds: Array

    def __post_init__(self) -> None:
        if not constant(self.course):
            raise ValueError("a ratio that changes, or a viscous resistance; expected constant ratios without one")

    @property
    def mechanism(self) -> Mechanism:
        """What is behind the first stage."""
        return self.course.train.drive.mechanism

    @property
    def turns(self) -> float:
        """Angle of the shaft behind the first stage over the way of the load (rad/m or 1)."""
        return self.mechanism.ratio_from(1)

    def inertia(self, ratio: Array) -> Array:
        """Return what is behind the stage at the shafts of motors (kg m²), J/i²."""
        return np.asarray(bare(self.mechanism).inertia() / ratio**2)

    def speed(self, gears: Gears) -> Array:
        """Return the largest speed of motors (rad/s)."""
        return self._turning(gears, self.course.fastest)

    def mean_speed(self, gears: Gears) -> Array:
        """Return the mean speed of motors over the cycle, there and back (rad/s)."""
        return self._turning(gears, self.course.way / self.course.told.total)

    def _turning(self, gears: Gears, velocity: float) -> Array:
        """Return the speed of motors (rad/s) at a geometric velocity of the load."""
        return np.asarray(gears.ratio * abs(self.turns) * velocity * self.speeds[gears.rate])

    @cached_property
    def spans(self) -> list[Span]:
        """The parts, in the order of the motion."""
        return [part for span in self.course.spans for part in monotone(span)]

    @cached_property
    def rows(self) -> Rows:
        """Their pieces."""
        return rows_of([span.piece for span in self.spans])

    def of(self, figure: Callable[[Span], float]) -> Array:
        """Return a figure of each part."""
        return np.array([figure(span) for span in self.spans], dtype=np.float64)

    @cached_property
    def going(self) -> Array:
        """The direction of each part."""
        return self.of(lambda span: span.going)

    @cached_property
    def lines(self) -> Lines:
        """The parts at each rate."""
        low, high = (self.of(end)[:, None] for end in (lambda span: span.low, lambda span: span.high))
        rows, square = self.rows.over(2), self.speeds**2
        cuts = [low + 0.0 * square, high + 0.0 * square]
        going, level = self.going[:, None], self.of(lambda span: span.force.level)[:, None]
        for shaft in range(self.mechanism.last, 0, -1):

            def torque(u: Array, shaft: int = shaft) -> Array:
                mass, rest = self._chain(square * rows.at(u, 2), going, level, shaft)
                return mass * square * rows.at(u, 2) + rest

            cuts.append(turning(torque, low, high + 0.0 * square))
        ends = np.sort(np.stack(cuts, axis=-1), axis=-1)
        begin, end = ends[..., :-1], ends[..., 1:]
        bent = square[:, None] * self.rows.over(3).at(0.5 * (begin + end), 2)
        mass, rest = self._chain(bent, going[..., None], level[..., None], 1)
        back = gives_back(mass * bent + rest, going[..., None], 0.0) & (self.course.train.method == "physical")
        held = (going[..., None] != 0.0) | (self.course.train.drive.holding != "brake")
        return Lines(begin, end, mass / self.turns, rest, back, held + 0.0 * mass)

    def _chain(self, bent: Array, going: Array, level: Array, shaft: int) -> tuple[Array, Array]:
        """Return what drives a shaft at accelerations of the load, as a line over these: slope and level."""
        m, method = self.mechanism, self.course.train.method
        mass, rest = np.full(bent.shape, m.on_shaft(m.last)), level + 0.0 * bent
        for k in range(m.last - 1, shaft - 1, -1):
            stage = m.stages[k]
            share = stage.factor(mass * bent + rest, going, method, 0.0) / stage.ratio
            mass, rest = share * mass + m.on_shaft(k) * m.ratio_from(k), share * rest
        return mass, rest

    @cached_property
    def points(self) -> tuple[Array, Array, NDArray[np.bool_]]:
        """α, S, and whether the load drives, by rate where a torque can be largest or lowest."""
        lines = self.lines
        u = np.stack([lines.low, lines.high], axis=-1)
        alpha = self.turns * (self.speeds**2)[:, None, None] * self.rows.over(4).at(u, 2)
        torque = (lines.mass[..., None] * alpha + lines.level[..., None]) * lines.held[..., None]
        back = np.broadcast_to(lines.back[..., None], u.shape)
        rates = len(self.speeds)
        alphas, torques = (np.moveaxis(one, 1, 0).reshape(rates, -1) for one in (alpha, torque))
        return alphas, torques, np.moveaxis(back, 1, 0).reshape(rates, -1)

    @property
    def behind(self) -> Array:
        """The largest torque behind the stage at each rate (Nm): of a load at rest too, whoever holds the motor."""
        lines = self.lines
        u = np.stack([lines.low, lines.high], axis=-1)
        alpha = self.turns * (self.speeds**2)[:, None, None] * self.rows.over(4).at(u, 2)
        return np.asarray(np.abs(lines.mass[..., None] * alpha + lines.level[..., None]).max(axis=(0, 2, 3)))

    @cached_property
    def moments(self) -> Moments:
        """Integrals over the cycle."""
        step = max(1, AT_ONCE // (self.lines.low[:, 0].size * (NODES + 1)))
        each = [self._moments(slice(at, at + step)) for at in range(0, len(self.speeds), step)]
        return Moments(*(np.concatenate(values) for values in zip(*each, strict=True)))

    def _moments(self, some: slice) -> Moments:
        """Return the integrals at some of the rates."""
        low, high, mass, level = (values[:, some, :, None] for values in self.lines[:4])
        back, held = self.lines.back[:, some, :, None], self.lines.held[:, some, :, None]
        speed = self.speeds[some, None, None]
        grid, weights = rule(NODES)
        u, rows = low + (high - low) * grid, self.rows.over(4)
        alpha, way = self.turns * speed**2 * rows.at(u, 2), np.abs(rows.at(u, 1))
        torque = (mass * alpha + level) * held

        def mean(values: Array) -> Array:
            over = (high - low)[..., 0] * (values @ weights)
            return np.asarray(over.sum(axis=(0, 2))) / self.course.told.total

        mixed, behind, moving = alpha * torque, torque**2, way * np.abs(self.going)[:, None, None, None]
        cubes, ways = mean(np.abs(torque) ** 3 * moving), mean(moving)
        none = np.zeros(cubes.shape)
        return Moments(
            mean(alpha**2), mean(~back * mixed), mean(back * mixed), mean(~back * behind), mean(back * behind),
            np.cbrt(np.divide(cubes, ways, out=none, where=ways > 0.0)),
        )  # fmt: skip

    def rms_torque(self, gears: Gears) -> Array:
        """Return the RMS torque of each motor (Nm): J² i² ⟨α²⟩ + 2 J ⟨α f S⟩ + ⟨f² S²⟩/i², the root of it.

        Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
        """
        inertia, ratio, eta, rate = gears
        own, mixed, mixed_back, behind, behind_back, _ = (values[rate] for values in self.moments)
        square = (inertia * ratio) ** 2 * own + 2.0 * inertia * (mixed / eta + mixed_back * eta)
        square = square + (behind / eta**2 + behind_back * eta**2) / ratio**2
        return np.asarray(np.sqrt(np.maximum(square, 0.0)))

    def torques(self, gears: Gears) -> Torques:
        """Return the lowest and highest torque of each motor (Nm)."""
        lowest, highest = [], []
        for some in gears.parts(self.points[0].shape[1]):
            alpha, torque, back = (values[some.rate] for values in self.points)
            driving, driven = (values[:, None] for values in shares(some))
            found = (some.inertia * some.ratio)[:, None] * alpha + np.where(back, driven, driving) * torque
            lowest.append(found.min(axis=1))
            highest.append(found.max(axis=1))
        return Torques(np.concatenate(lowest), np.concatenate(highest))

    def works(self, gears: Gears) -> Works:
        """Return the work of each motor over a cycle (J), parted where its power turns round."""
        width = self.lines.low[:, 0].size
        each = [self._works(some) for some in gears.parts(width)]
        return Works(*(np.concatenate(values) for values in zip(*each, strict=True)))

    def _works(self, gears: Gears) -> Works:
        """Return the work of some motors: arrays of parts, motors, and what lies between cuts."""
        low, high, mass, level = (values[:, gears.rate] for values in self.lines[:4])
        back = self.lines.back[:, gears.rate]
        driving, driven = (values[:, None] for values in shares(gears))
        share, speed = np.where(back, driven, driving), self.speeds[gears.rate, None]
        slope, rest = (gears.inertia * gears.ratio)[:, None] + share * mass, share * level
        rows = self.rows.over(3)
        ends = [slope * self.turns * speed**2 * rows.at(u, 2) + rest for u in (low, high)]
        place = high.copy()
        at = np.nonzero(((ends[0] > 0.0) != (ends[1] > 0.0)) & (self.going[:, None, None] != 0.0))
        own, bend = self.rows.taken(at[0]), (slope * self.turns * speed**2)[at]
        place[at] = turning(lambda u: bend * own.at(u, 2) + rest[at], low[at], high[at])
        found = np.zeros((2, len(gears.ratio)))
        for begin, end in ((low, place), (place, high)):
            squares = rows.at(end, 1) ** 2 - rows.at(begin, 1) ** 2
            way = self.turns * (rows.at(end, 0) - rows.at(begin, 0))
            work = gears.ratio[:, None] * (slope * (self.turns * speed) ** 2 * squares / 2.0 + rest * way)
            found += [np.maximum(way * work, 0.0).sum(axis=(0, 2)) for way in (1.0, -1.0)]
        return Works(*found)


def constant(course: Course) -> bool:
    """Whether all that a course asks for is a line over the acceleration."""
    return course.train.linkage is None and not course.train.viscous


def mean_power(works: Works, time: Array) -> Array:
    """Return the mean power at the shafts of motors over cycles of so long (W)."""
    return np.asarray((works.driving - works.regenerated) / time)


def shares_of(limit: Array, value: Array) -> Array:
    """Return the limit over the quantity; 0 where nothing is asked for."""
    return np.divide(limit, value, out=np.zeros(np.broadcast(limit, value).shape), where=value != 0.0)


def bare(mechanism: Mechanism) -> Mechanism:
    """Return a mechanism whose first stage changes nothing, with nothing on the motor's shaft."""
    first, *others = mechanism.stages
    parts = tuple(part for part in mechanism.parts if part.shaft > 0)
    return replace(mechanism, stages=(Stage(first.name, 1.0), *others), parts=parts)


def shares(gears: Gears) -> tuple[Array, Array]:
    """Return f/i where S drives the load, and where the load drives it."""
    return 1.0 / (gears.efficiency * gears.ratio), gears.efficiency / gears.ratio


def monotone(span: Span) -> Iterator[Span]:
    """Yield the parts of a span in which its acceleration only rises or only falls."""
    slope = trimmed(position(span.piece).derivative().derivative().derivative())
    turns = [u for u in zeros(slope, span.piece.duration) if span.low < u < span.high]
    for low, high in pairwise((span.low, *turns, span.high)):
        yield span._replace(low=low, high=high)


def turning(torque: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """Return where functions change their sign between two places, by halving; the second where they do not."""
    up = torque(low) > 0.0
    turns = up != (torque(high) > 0.0)
    if not turns.any():
        return np.asarray(high)
    at, width = low + 0.0 * high, high - low
    for _ in range(HALVES):
        width = 0.5 * width
        at = at + np.where((torque(at + width) > 0.0) == up, width, 0.0)
    return np.where(turns, at + width, high)
