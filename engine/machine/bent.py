"""A motion's pieces cut where its acceleration turns, and the torque of a motor on them as a bent line. SI units.

It is how a table of cells finds peaks, RMS torque and energy; those of :mod:`engine.machine.demand` come another way.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise, repeat
from typing import Literal, NamedTuple

import numpy as np

from engine.drivetrain.bends import Bends
from engine.laws.base import Array
from engine.machine.searching import integral
from engine.machine.stationary import LOST
from engine.motion.pieces import MotionPiece
from engine.motion.turning import GRID, PARTS, ROUNDS

LEAST = 1e-9
"""J, and of ∫|S|³ |y'|: what is next to nothing"""


def stretches(cuts: Iterable[float], total: float, near: float) -> list[tuple[float, float]]:
    """Return what lies between cuts from 0 to ``total``; cuts no farther apart than ``near`` are one."""
    found = [0.0]
    for cut in sorted(cuts):
        if cut > found[-1] + near:
            found.append(cut)
    if total - found[-1] > near:
        found.append(total)
    return list(pairwise(found))


def middle(span: tuple[float, float]) -> float:
    """Return the middle of a stretch."""
    return 0.5 * (span[0] + span[1])


def turned(angle: float, late: float, cycle: float, near: float = 0.0) -> float:
    """Return the place in the cycle of a place in a motion that is so late; so near before its begin it is on that."""
    place = angle + late
    return place - cycle * math.floor((place + near) / cycle)


def going(piece: MotionPiece, u: float, fastest: float) -> float:
    """Return the direction of a motion, 1, −1, or 0 where it is next to nothing beside its largest |y'|."""
    velocity = float(piece.derivative(1, np.array([u]))[0])
    return float(np.sign(velocity)) if abs(velocity) > LOST * fastest else 0.0


class Scales(NamedTuple):
    """What the integrals of a cycle are measured by: ∫T² (Nm² rad), work (J), ∫|S|³ |y'|, mean power (W)."""

    square: float
    work: float
    cube: float
    power: float


def scales(torque: float, behind: float, ratio: float, way: float, time: float) -> Scales:
    """Return them from the largest torques of motor and reducer (Nm), the motor's ratio, the way and the time."""
    work = max(torque * ratio * way, LEAST)
    return Scales(torque**2, work, max(behind**3 * way, LEAST), work / time)


class Away(NamedTuple):
    """What the shaft behind a reducer is measured by: α, and integrals over a cycle ∫α², ∫αS and ∫S²."""

    alpha: float
    turned: float
    product: float
    square: float


def away(behind: float, acceleration: float, ratio: float) -> Away:
    """Return them from the largest torque there (Nm), the load's largest acceleration, and the shaft's ratio."""
    alpha = abs(ratio) * acceleration
    return Away(alpha, alpha**2, alpha * behind, behind**2)


@dataclass(frozen=True)
class BentPart:
    """A part of a piece in which the acceleration only rises or only falls, over an abscissa that advances at a speed.

    ``going`` is 1, −1, or 0 at rest; y = −sign · b, b the acceleration in that direction. ``bends`` has the load that
    acts there; ``largest`` and ``fastest`` are the largest acceleration and |y'| of the motion.
    """

    bends: Bends
    piece: MotionPiece
    low: float
    high: float
    speed: float
    going: float
    largest: float
    fastest: float
    _found: dict[tuple[str, int, float], float] = field(default_factory=dict, init=False, compare=False, repr=False)

    @property
    def factor(self) -> float:
        """y where y'' is 1."""
        return -self.bends.sign * self.going * self.speed**2

    def y(self, u: float | Array) -> Array:
        """Return the acceleration against what the load resists with (m/s² or rad/s²)."""
        return np.asarray(self.factor * self.piece.derivative(2, np.asarray(u, dtype=np.float64)))

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Y at the begin and at the end."""
        first, last = self.y(np.array([self.low, self.high])).tolist()
        return first, last

    @property
    def falls(self) -> bool:
        """Whether y falls."""
        return self.ends[0] - self.ends[1] > LOST * self.largest

    @property
    def sides(self) -> tuple[float, float]:
        """The end (rad) from which y rises, and the other."""
        return (self.high, self.low) if self.falls else (self.low, self.high)

    @cached_property
    def levels(self) -> tuple[float, float, float]:
        """The y at which power turns round in the motor, in the reducer and in the mechanism.

        It never does where nothing behind has inertia: then they are beyond any acceleration.
        """
        slope, far, behind = self.bends.slope, 2.0 * self.largest, self.bends.drive.mechanism.on_shaft
        turns = self.bends.turns if behind(1) + behind(2) > 0.0 else (far, far)
        return (abs(self.bends.level) / slope if slope else far, *turns)

    def crosses(self, level: float) -> bool:
        """Whether y passes a level."""
        lost = LOST * self.largest
        return min(self.ends) < level - lost and max(self.ends) > level + lost

    def besides(self, level: float) -> list[float]:
        """Return the end (rad) up to which y is below a level that it does not pass, in place of each round."""
        at, other = self.sides
        return [*repeat(at, ROUNDS - 1), other if max(self.ends) <= level + LOST * self.largest else at]

    def passed(self, level: float) -> list[float]:
        """Return where y passes a level, round by round; an end where it does not."""
        if not self.crosses(level):
            return self.besides(level)
        at, other = self.sides
        width, lost, found = other - at, LOST * self.largest, []
        for turn in range(1, ROUNDS + 1):
            kept = int(np.count_nonzero(self.y(at + width * GRID) < level - lost))
            at += width * (min(kept, PARTS - 1) + (0.5 if turn == ROUNDS else 0.0)) / PARTS
            width /= PARTS
            found.append(at)
        return found

    @cached_property
    def places(self) -> list[float]:
        """The begin of its rise, where it passes each level, and its end."""
        first, last = self.sides
        return [first, *(self.passed(level)[-1] for level in self.levels), last]

    @property
    def falling(self) -> float:
        """The slope of the torque over y (Nm per m/s² or rad/s²) beside y = 0."""
        return -self.bends.sign * self.bends.slope

    @property
    def turns_back(self) -> bool:
        """Whether it moves against its direction at an end."""
        v = self.going * self.piece.derivative(1, np.array([self.low, self.high]))
        return bool(v.min() < -LOST * self.fastest)

    @property
    def first_factor(self) -> float:
        """The reducer's factor before power turns round in it."""
        return self.bends.factors[0][0]

    @property
    def held_at_rest(self) -> float:
        """The torque of the motor (Nm) if it rested under what resists."""
        drive = self.bends.drive
        if drive.holding == "brake":
            return 0.0
        return self.bends.resists / drive.mechanism.ratio / math.prod(one.efficiency for one in drive.mechanism.stages)

    @property
    def held(self) -> float:
        """The torque of the motor (Nm) at rest."""
        return self.bends.drive.held_torque

    def torque_at(self, end: int) -> float:
        """Return the torque of the motor (Nm) at its begin, 0, or its end, 1: the limit from inside."""
        if not self.going:
            return self.held
        return self.going * self.bends.torque(float(-self.bends.sign * self.ends[end]))

    def shaft_at(self, end: int) -> float:
        """Return the torque behind the reducer (Nm) there."""
        if not self.going:
            return float(self.bends.drive.torques(0.0, 0.0)[1])
        return self.going * self.bends.shaft(1, float(-self.bends.sign * self.ends[end]))

    def square(self, part: tuple[int, int], scale: float) -> float:
        """Return ∫T² over the abscissa (Nm² rad) between two places, by their numbers."""
        return self._over("square", part, scale)

    def work(self, part: tuple[int, int], scale: float) -> float:
        """Return ∫T dφ of the motor (J) between two places."""
        return self._over("work", part, scale)

    def cube(self, part: tuple[int, int], scale: float) -> float:
        """Return ∫|S|³ |y'| over the abscissa between two places, S behind the reducer."""
        return self._over("cube", part, scale)

    def behind(self, figure: Literal["square", "product"], part: tuple[int, int], scale: float) -> float:
        """Return ∫S² or ∫αS over the abscissa between two places, of the shaft behind the reducer; 0 at rest."""
        return self._over(f"behind: {figure}", part, scale)

    def turned(self, scale: float) -> float:
        """Return ∫α² over the abscissa of that shaft."""
        return self._over("turned", (0, 4), scale)

    @property
    def fastest_behind(self) -> float:
        """A bound of the speed of that shaft (rad/s): its largest at the ends where the acceleration keeps its sign."""
        return abs(self.bends.drive.mechanism.ratio_from(1)) * self.speed * self.fastest_here

    @property
    def fastest_here(self) -> float:
        """The same of |y'|: that of the whole motion where the acceleration turns round."""
        if self.crosses(0.0):
            return self.fastest
        return float(np.abs(self.piece.derivative(1, np.array([self.low, self.high]))).max())

    def turning_at(self, end: int) -> float:
        """Return the acceleration of that shaft (rad/s²) at its begin, 0, or its end, 1."""
        return -self.bends.sign * self.going * self.ends[end] * self.bends.drive.mechanism.ratio_from(1)

    def square_in_all(self, scale: float) -> float:
        """Return ∫T² over the abscissa, also at rest (Nm² rad)."""
        return self.square((0, 4), scale) if self.going else (self.high - self.low) * self.held**2

    def driven(self, scale: float) -> float:
        """Return the work with which the motor drives (J)."""
        return self.work((0, 1), scale) if self.bends.sign > 0.0 else self.work((1, 4), scale)

    def regenerated(self, scale: float) -> float:
        """Return the work that comes back to the motor (J)."""
        return -(self.work((1, 4), scale) if self.bends.sign > 0.0 else self.work((0, 1), scale))

    def _over(self, figure: str, part: tuple[int, int], scale: float) -> float:
        for k in range(*part):
            if (figure, k, scale) not in self._found:
                self._found[figure, k, scale] = self._between(figure, k, scale)
        return sum(self._found[figure, k, scale] for k in range(*part))

    def _between(self, figure: str, k: int, scale: float) -> float:
        """Return an integral from a place to the next one, between which no torque bends."""
        low, high = sorted(self.places[k : k + 2])
        if not self.going or high <= low:
            return 0.0
        shaft = 1 if figure == "cube" or figure.startswith("behind") else 0
        torque, ratio = self._line(low, high, shaft), self.bends.drive.mechanism.ratio
        turn = self.going * self.bends.drive.mechanism.ratio_from(1) * self.speed**2

        def value(u: Array) -> Array:
            if figure in ("square", "behind: square"):
                return torque(u) ** 2
            if figure in ("behind: product", "turned"):
                alpha = turn * self.piece.derivative(2, u)
                return np.asarray(alpha * (alpha if figure == "turned" else torque(u)))
            way = np.abs(self.piece.derivative(1, u))
            return np.asarray(np.abs(torque(u)) ** 3 * way if figure == "cube" else torque(u) * ratio * way)

        return integral(value, low, high, scale)

    def _line(self, low: float, high: float, shaft: int) -> Callable[[Array], Array]:
        """Return a torque in the direction of motion between two places, where it is straight over the acceleration.

        Taken from well inside: a place is only known to some digits, and beside it the torque may have bent.
        """
        turn = self.going * self.speed**2
        one, other = self.piece.derivative(2, np.array([low, high]))
        begin, grown = 0.75 * one + 0.25 * other, 0.5 * (other - one)
        first, last = self.bends.torques(turn * np.array([begin, begin + grown]), shaft).tolist()
        slope = (last - first) / grown if grown else 0.0
        return lambda u: np.asarray(first + slope * (self.piece.derivative(2, u) - begin))
