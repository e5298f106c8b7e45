"""What a course asks of any motor behind any reducer: found once behind the reducer, then for all at once. SI units.

Speed, acceleration and torque of the shaft behind a reducer hang neither on it nor on the motor. Before it, with J all
that turns with the motor, T = J i α + f S/i: f is 1/η where S drives the load and η where the load drives it. So the
squares of T are sums of three integrals, its peaks lie at extremes of α, and its power turns round once in every part
in which α only rises or only falls.
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
from engine.machine.course import Course, Stretch, trimmed
from engine.machine.demand import Demand
from engine.machine.searching import integral

HALVES = 30
"""of a part, to find where power turns round: work errs by the square of what is left"""


class Gears(NamedTuple):
    """Motors with their reducers, arrays of one length: J (kg m²) on the motor's shaft, i, η."""

    inertia: Array
    ratio: Array
    efficiency: Array


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


class Part(NamedTuple):
    """A part of a stretch in which α only rises or only falls: S = ``mass`` α + ``level``."""

    stretch: Stretch
    low: float
    high: float
    back: bool
    mass: float
    level: float

    def alpha(self, u: Array) -> Array:
        """Return α (rad/s²)."""
        return self.stretch.shaft(u).acceleration


@dataclass(frozen=True)
class Geared:
    """A course as the shaft behind its first stage knows it; that stage, the motor and what turns with it do not count.

    Raises ValueError for a ratio that depends on position, or a viscous resistance: there S is no line over α.
    """

    course: Course

    def __post_init__(self) -> None:
        train = self.course.train
        if train.linkage or train.viscous:
            raise ValueError("a ratio that changes, or a viscous resistance; expected constant ratios without one")
        drive = replace(train.drive, mechanism=bare(train.drive.mechanism), motor_inertia=0.0)
        object.__setattr__(self, "course", replace(self.course, train=replace(train, drive=drive)))

    @cached_property
    def demand(self) -> Demand:
        """What is asked for behind the stage: its shaft 1 is the same as the motor's, 0."""
        return Demand(self.course)

    def inertia(self, ratio: Array) -> Array:
        """Return what is behind the stage at the shafts of motors (kg m²), J/i²."""
        return np.asarray(self.course.train.drive.mechanism.inertia() / ratio**2)

    def speed(self, ratio: Array) -> Array:
        """Return the largest speed of motors (rad/s)."""
        return np.asarray(ratio * self.demand.speed.peak)

    def mean_power(self, works: Works) -> Array:
        """Return the mean power at the shafts of motors (W)."""
        return np.asarray((works.driving - works.regenerated) / self.course.time)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """All parts, in the order of the motion."""
        return tuple(part for stretch in self.course.stretches for part in parts_of(stretch))

    @cached_property
    def points(self) -> tuple[Array, Array, NDArray[np.bool_]]:
        """α, S, and whether the load drives, where a torque can be largest or lowest: no other lies outside them."""
        found: set[tuple[float, float, bool]] = set()
        for part in self.parts:
            u = np.array([part.low, part.high])
            pairs = zip(part.alpha(u).tolist(), part.stretch.torque(u, 1).tolist(), strict=True)
            found.update((*pair, part.back) for pair in pairs)
        kept = np.array([one for one in found if not all(beaten(one, found, way) for way in (1.0, -1.0))])
        return kept[:, 0], kept[:, 1], kept[:, 2] > 0.0

    @cached_property
    def squares(self) -> tuple[float, tuple[float, float], tuple[float, float]]:
        """⟨α²⟩; ⟨α S⟩ and ⟨S²⟩ over the cycle, each where S drives the load and where the load drives it."""
        speed, torque = (float(np.abs(values).max()) for values in self.points[:2])
        own, mixed, behind = 0.0, [0.0, 0.0], [0.0, 0.0]
        for part in self.parts:
            own += over(part, lambda a, _: a**2, speed**2)
            mixed[part.back] += over(part, lambda a, s: a * s, speed * torque)
            behind[part.back] += over(part, lambda _, s: s**2, torque**2)
        total = self.course.told.total
        return own / total, (mixed[0] / total, mixed[1] / total), (behind[0] / total, behind[1] / total)

    def rms_torque(self, gears: Gears) -> Array:
        """Return the RMS torque of each motor (Nm): J² i² ⟨α²⟩ + 2 J ⟨α f S⟩ + ⟨f² S²⟩/i², the root of it.

        Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
        """
        own, mixed, behind = self.squares
        inertia, ratio, eta = gears
        square = (inertia * ratio) ** 2 * own + 2.0 * inertia * (mixed[0] / eta + mixed[1] * eta)
        square = square + (behind[0] / eta**2 + behind[1] * eta**2) / ratio**2
        return np.asarray(np.sqrt(np.maximum(square, 0.0)))

    def torques(self, gears: Gears) -> Torques:
        """Return the lowest and highest torque of each motor (Nm)."""
        turned, driving, driven = gears.inertia * gears.ratio, *shares(gears)
        low, high = np.full(turned.shape, np.inf), np.full(turned.shape, -np.inf)
        for alpha, torque, back in zip(*self.points, strict=True):
            found = turned * alpha + (driven if back else driving) * torque
            np.minimum(low, found, out=low)
            np.maximum(high, found, out=high)
        return Torques(low, high)

    def works(self, gears: Gears) -> Works:
        """Return the work of each motor over a cycle (J), parted where the power turns round."""
        turned, driving, driven = gears.inertia * gears.ratio, *shares(gears)
        found = Works(np.zeros(turned.shape), np.zeros(turned.shape))
        for part in self.parts:
            share = driven if part.back else driving
            slope, level = turned + share * part.mass, share * part.level
            place = turning(part, slope, level)
            for low, high in ((np.array(part.low), place), (place, np.array(part.high))):
                work = gears.ratio * worked(part, slope, level, low, high)
                found.driving[...] += np.maximum(work, 0.0)
                found.regenerated[...] += np.maximum(-work, 0.0)
        return found


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


def parts_of(stretch: Stretch) -> Iterator[Part]:
    """Yield the parts of a stretch."""
    middle = np.array([0.5 * (stretch.low + stretch.high)])
    back = bool(gives_back(stretch.torque(middle, 1), stretch.going, 0.0)[0])
    ratio, weights = stretch.train.drive.mechanism.ratio_from(1), stretch.weights[1]
    mass = weights.force * stretch.force.mass / ratio**2 + weights.inertia
    level = weights.force * stretch.force.level / ratio
    slope = trimmed(stretch.curves[2].derivative())
    turns = [u for u in zeros(slope, stretch.piece.duration) if stretch.low < u < stretch.high]
    for low, high in pairwise((stretch.low, *turns, stretch.high)):
        yield Part(stretch, low, high, back, mass, level)


def beaten(one: tuple[float, float, bool], others: set[tuple[float, float, bool]], way: float) -> bool:
    """Whether another point gives no less torque than this one, upwards (1) or downwards (−1), whatever the gears."""
    alpha, torque, back = one
    return any(
        other != one and other[2] == back and way * other[0] >= way * alpha and way * other[1] >= way * torque
        for other in others
    )


def over(part: Part, function: Callable[[Array, Array], Array], scale: float) -> float:
    """Return the integral over a part of a function of α and S that grows to a scale."""
    return integral(lambda u: function(part.alpha(u), part.stretch.torque(u, 1)), part.low, part.high, scale)


def turning(part: Part, slope: Array, level: Array) -> Array:
    """Return where ``slope`` α + ``level`` changes its sign in a part, by halving; its end where it does not."""
    first, last = part.alpha(np.array([part.low, part.high])).tolist()
    at_low, at_high = slope * first + level, slope * last + level
    place = np.full(slope.shape, part.high)
    turns = np.flatnonzero((at_low > 0.0) != (at_high > 0.0))
    if not part.stretch.going or not turns.size:
        return place
    low, width = np.full(turns.size, part.low), part.high - part.low
    slope, level, up = slope[turns], level[turns], at_low[turns] > 0.0
    for _ in range(HALVES):
        width *= 0.5
        same = (slope * part.alpha(low + width) + level > 0.0) == up
        low += np.where(same, width, 0.0)
    place[turns] = low + width
    return place


def worked(part: Part, slope: Array, level: Array, low: Array, high: Array) -> Array:
    """Return ∫(``slope`` α + ``level``) dφ of the shaft between two places: slope Δ(ω²)/2 + level Δφ."""
    stretch = part.stretch
    begin, end = stretch.load(low), stretch.load(high)
    ratio = stretch.train.drive.mechanism.ratio_from(1)
    return np.asarray(slope * (ratio**2 * (end.v**2 - begin.v**2)) / 2.0 + level * ratio * (end.y - begin.y))
