"""The highest rate of a drive from its stretches, a few trials instead of a search: as a table of cells finds it.

With x the square of the rate over the present one, the torque at a place of a stretch is the same bent line over x η,
η being y at the present rate. So speed and peaks bind at an x in closed form. ∫T² and the mean torque are nearly
polynomials of x: parabolas through what they are at rest and at the last two trials meet their limits sooner and
sooner. :mod:`engine.machine.rate` comes to the same another way. SI units.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.machine.bent import LEAST, BentPart
from engine.machine.demand import Demand
from engine.machine.falling import Against, Falling
from engine.machine.limits import ReducerLimits
from engine.machine.rows import Rows, rows_of
from engine.machine.searching import rule
from engine.machine.stationary import LOST

TRIALS = 5
FAR = 1e12
"""x beyond which is not looked: a million times the rate"""
EQUAL = 1e-9
"""of a rate: those that differ by less are equal"""
BELOW = 1e-9
"""of the rate: how far below it all limits are held"""
APART = 1e-2
"""of x: trials nearer to each other tell nothing of a parabola's bend"""
NEARER = 1e-4
"""the same of √x, of what the line of a falling curve must be: it is known to more digits"""
FLAT = 1e-9
"""of what is asked for at rest: what rises by no more does not rise, but for rounding"""
REACH = 10.0
"""times the x of a trial: beyond that it only tells a power of ten"""
TRUSTED = 100.0
"""x from which the present rate tells nothing of a parabola's bend"""
PARTS = 300
"""of a stretch, and of these again, in which a level is looked for"""
SHARES = np.arange(1, PARTS + 1) / PARTS
NODES = 32
LONE = (1.0, 0.0, 1.0)
"""the power of x with which each figure grows beyond its first, where a single trial tells it"""
LIMITS = (
    "motor speed", "reducer input speed", "peak torque", "reducer peak torque", "RMS torque", "reducer mean torque",
    "motor's curve",
)  # fmt: skip


class Trial(NamedTuple):
    """A quantity at an x: how it rises from rest, D = (F − F_0)/x = slope + bend · x, and where it meets its limit.

    ``turn`` is by how much D changed since the last trial.
    """

    value: float
    rise: float
    turn: float
    bend: float
    slope: float
    term: float
    x: float


class Trials(NamedTuple):
    """An x that was tried, and what is asked for there.

    The mean square of T, the mean torque behind the reducer, and the line of a falling curve at no speed: this over √x,
    as the speed adds to it.
    """

    x: float
    square: Trial
    mean: Trial
    curve: Trial


class Crossing(NamedTuple):
    """In which part of its rise y passes a level, −1 before it and :data:`PARTS` behind it, and where (rad)."""

    part: Array
    place: Array


@dataclass(frozen=True)
class Pace:
    """Stretches of a drive's cycle, what they ask for at the present rate, and the limits that they must hold.

    The torques (Nm) and the speed (rad/s) are the motor's.
    """

    parts: tuple[BentPart, ...]
    demand: Demand
    rated_torque: float
    peak_torque: float
    max_speed: float
    reducer: ReducerLimits
    falling: Falling = Falling()  # noqa: RUF009 - a tuple

    def of(self, figure: Callable[[BentPart], float]) -> Array:
        """Return a figure of each stretch."""
        return np.array([figure(part) for part in self.parts], dtype=np.float64)

    @cached_property
    def rows(self) -> Rows:
        """The pieces of the stretches, for places in rows."""
        return rows_of([part.piece for part in self.parts]).over(2)

    @cached_property
    def factors(self) -> Array:
        """y of each stretch where y'' is 1, at the present rate."""
        return self.of(lambda part: part.factor)

    @cached_property
    def sides(self) -> tuple[Array, Array]:
        """The ends of each stretch from and to which y rises (rad)."""
        return self.of(lambda part: part.sides[0]), self.of(lambda part: part.sides[1])

    def eta(self, u: Array) -> Array:
        """Return y at the present rate at places (rad) of each stretch, a row each."""
        return np.asarray(self.factors[:, None] * self.rows.at(u, 2))

    def velocity(self, u: Array) -> Array:
        """Return |y'| at places of each stretch."""
        return np.asarray(np.abs(self.rows.at(u, 1)))

    def crossing(self, x: float, index: int) -> Crossing:
        """Return where y passes the first (1) or the second (2) level of its stretch at a rate, if it does."""
        level, lost = self.of(lambda part: part.levels[index]), LOST * self.of(lambda part: part.largest)
        ends = np.array([part.ends for part in self.parts])
        behind = self.parts[0].bends.drive.mechanism.on_shaft
        above = (x * (ends.max(axis=1) - lost) > level) & (behind(1) + behind(2) > 0.0)
        within = above & (x * (ends.min(axis=1) + lost) < level)
        low, high = self.sides

        def below(at: Array) -> Array:
            kept = x * (self.eta(at) + lost[:, None]) < level[:, None]
            return np.asarray(np.minimum(kept.sum(axis=1), PARTS - 1))

        width = high - low
        part = below(low[:, None] + width[:, None] * SHARES)
        begin = low + width * part / PARTS
        fine = below(begin[:, None] + width[:, None] / PARTS * SHARES)
        place = low + width * (part + (fine + 0.5) / PARTS) / PARTS
        outside = np.where(above, -1, PARTS)
        return Crossing(np.where(within, part, outside), np.where(within, place, np.where(above, low, high)))

    def _lines(self, x: float) -> tuple[Array, Array, Array, Array]:
        """Return, of the three lines of each stretch, widths (rad), levels and slopes over x η, and places (rad)."""
        low, high = self.sides
        cuts = np.array([low, self.crossing(x, 1).place, self.crossing(x, 2).place, high]).T
        grid, _ = rule(NODES)
        begins, widths = cuts[:, :-1], np.diff(cuts, axis=1)
        steps = np.array([part.bends.steps for part in self.parts])
        at = np.array([part.levels[1:] for part in self.parts])
        none = np.zeros((len(self.parts), 1))
        slopes = self.of(lambda part: part.falling)[:, None] + np.cumsum(np.hstack([none, steps]), axis=1)
        levels = self.of(lambda part: part.bends.level)[:, None]
        levels = levels - np.cumsum(np.hstack([none, steps * at]), axis=1)
        places = begins[:, :, None] + widths[:, :, None] * grid
        return np.abs(widths), levels[:, :, None], slopes[:, :, None], places

    def _over(self, widths: Array, values: Array) -> Array:
        """Return the integrals over the lines of each stretch that moves."""
        _, weights = rule(NODES)
        moving = np.abs(self.of(lambda part: part.going))
        return np.asarray(moving * (widths * (values @ weights)).sum(axis=1))

    def _eta(self, places: Array) -> Array:
        return self.eta(places.reshape(len(self.parts), -1)).reshape(places.shape)

    def squares(self, x: float) -> Array:
        """Return ∫T² of each stretch at a rate (Nm² rad)."""
        widths, levels, slopes, places = self._lines(x)
        moving = self._over(widths, (levels + slopes * x * self._eta(places)) ** 2)
        resting = self.of(lambda part: 0.0 if part.going else (part.high - part.low) * part.held**2)
        return np.asarray(moving + resting)

    def cubes(self, x: float) -> Array:
        """Return ∫|S|³ |y'| of each stretch at a rate, S behind the reducer."""
        widths, levels, slopes, places = self._lines(x)
        mechanism = self.parts[0].bends.drive.mechanism
        own = (self.parts[0].bends.drive.motor_inertia + mechanism.on_shaft(0)) * mechanism.ratio
        signs = self.of(lambda part: part.bends.sign)[:, None]
        near, past = np.array([part.bends.factors[0] for part in self.parts]).T[:, :, None]
        through = mechanism.stages[0].ratio / np.hstack([near, past, past])
        behind = levels + (slopes + signs[:, :, None] * own) * x * self._eta(places)
        way = self.velocity(places.reshape(len(self.parts), -1)).reshape(places.shape)
        return self._over(widths, np.abs(through[:, :, None] * behind) ** 3 * way)

    @cached_property
    def ways(self) -> Array:
        """∫|y'| of each stretch that moves (m or rad)."""
        return np.array([abs(float(np.diff(p.piece.derivative(0, np.array([p.low, p.high])))[0])) * abs(p.going)
                         for p in self.parts])  # fmt: skip

    def mean_square(self, x: float) -> float:
        """Return the mean of T² over the cycle (Nm²)."""
        return float(self.squares(x).sum()) / self.demand.course.told.total

    def mean_torque(self, x: float) -> float:
        """Return the cubic mean of the torque behind the reducer, weighted by its speed (Nm)."""
        way = float(self.ways.sum())
        return math.cbrt(float(self.cubes(x).sum()) / way) if way else 0.0

    @cached_property
    def peaks(self) -> Array:
        """The x at which the torque of the motor reaches its peak in each stretch."""
        return np.array([reached(part, 0, self.peak_torque) for part in self.parts])

    @cached_property
    def geared_peaks(self) -> Array:
        """The x at which the torque behind the reducer reaches its limit in each stretch."""
        return np.array([reached(part, 1, self.reducer.peak_torque) for part in self.parts])

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """The x at which the limits of speed and of peak torque bind, motor and reducer."""
        fastest = self.demand.speed.peak
        speeds = (self.max_speed, self.reducer.input_speed)
        motor, reducer = (min(FAR, (limit / fastest) ** 2) if fastest else FAR for limit in speeds)
        return motor, reducer, float(self.peaks.min()), float(self.geared_peaks.min())

    @cached_property
    def against(self) -> Against:
        """The stretches against a peak torque that falls."""
        return Against(self.parts, self.falling)

    def curve_at(self, root: float) -> float:
        """Return what the line of a falling curve must be at no speed (Nm) at a √x."""
        return self.against.most(root**2)

    @cached_property
    def trials(self) -> tuple[Trials, ...]:
        """The present rate, and all that were tried from there."""
        limits = (self.rated_torque**2, self.reducer.mean_torque, self.falling.lowest(self.peak_torque))
        asked = (self.mean_square, self.mean_torque, self.curve_at)
        rest = [one(0.0) for one in asked]
        present = (self.demand.rms_torque**2, self.demand.mean_shaft_torque(1), self.curve_at(1.0))
        rises = [risen(value, first) for value, first in zip(present, rest, strict=True)]
        bends = [lone * rise for lone, rise in zip(LONE, rises, strict=True)]
        found = [Trials(1.0, *(met(*one, 1.0) for one in zip(present, rises, bends, rest, limits, strict=True)))]
        for n in range(TRIALS):
            last = found[-1]
            x = min(*self.bounds, last.square.x, last.mean.x, last.curve.x**2)
            at = [(x, last.x)] * 2 + [(math.sqrt(x), math.sqrt(last.x))]
            lone = (None, None, None) if n else LONE
            each = zip(asked, last[1:], at, rest, limits, lone, (APART, APART, NEARER), strict=True)
            found.append(Trials(x, *(further(of(z), one, before, z, *more) for of, one, (z, before), *more in each)))
        return tuple(found)

    @cached_property
    def sizes(self) -> list[float]:
        """How large F/x grows over the trials, of each figure that is tried: by it rises are measured."""
        tried = [((x, x, math.sqrt(x)), each) for x, *each in self.trials if x > 0.0]
        return [max(LEAST, *(each[k].value / at[k] for at, each in tried)) for k in range(len(LONE))]

    @property
    def each(self) -> tuple[float, ...]:
        """The x at which each of :data:`LIMITS` binds: of the last three to all digits where none binds before."""
        _, square, mean, curve = self.trials[-1]
        return (*self.bounds, square.x, mean.x, min(FAR, curve.x**2))

    @property
    def highest(self) -> float:
        """The highest rate over the present one, where a limit binds."""
        return math.sqrt(min(self.each))

    @property
    def rate(self) -> float:
        """The highest rate (1/s), a little below where a limit binds, so that all hold at it."""
        return self.highest * (1.0 - BELOW) / self.demand.course.time

    @property
    def apart(self) -> list[int]:
        """Whether each trial differs enough from the one before to tell a bend."""
        return telling([one.x for one in self.trials])

    @property
    def roots(self) -> list[float]:
        """√x of each trial."""
        return [math.sqrt(one.x) for one in self.trials]

    @property
    def roots_apart(self) -> list[int]:
        """Whether these differ enough to tell a bend."""
        return telling(self.roots, NEARER)

    @property
    def last_step(self) -> float:
        """By how much x changes with the last trial, as a share."""
        x = min(self.each)
        return abs(x / self.trials[-1].x - 1.0) if x > 0.0 else 0.0

    @property
    def limit(self) -> str:
        """The limit that binds there."""
        x = min(self.each)
        return LIMITS[self.each.index(x)] if x < FAR else ""


def first_lowest(rates: Array) -> Any:
    """Return which rate of each column is the lowest: the first, of those that are equal but for rounding."""
    return (rates <= rates.min(axis=0) * (1.0 + EQUAL)).argmax(axis=0)


def reached(part: BentPart, shaft: int, limit: float) -> float:
    """Return the x up to which the torque of a shaft, 0 or 1, holds a limit at both ends of a stretch."""
    if not part.going:
        held = part.held if shaft == 0 else part.shaft_at(0)
        return FAR if abs(held) <= limit else 0.0
    if abs(float(part.bends.torques(np.zeros(1), shaft)[0])) > limit:
        return 0.0
    lost = LOST * part.largest
    ends = [end for end in part.ends if abs(end) > lost]
    return min([FAR, *(meets(part, shaft, limit, math.copysign(1.0, end)) / abs(end) for end in ends)])


def meets(part: BentPart, shaft: int, limit: float, way: float) -> float:
    """Return how far from 0 the y is, above it (1) or below (−1), at which the torque of a shaft reaches a limit."""
    bends, far, step = part.bends, FAR * part.largest, part.largest or 1.0
    knots = [0.0, *part.levels[1:]] if way > 0.0 else [0.0]
    away = np.array([*knots, knots[-1] + step])
    found = (-way * bends.sign * bends.torques(-bends.sign * way * away, shaft)).tolist()
    for k, (first, second) in enumerate(pairwise(found)):
        if second > first and (second >= limit or k == len(knots) - 1):
            return min(far, float(away[k] + (away[k + 1] - away[k]) * (limit - first) / (second - first)))
    return far


def risen(value: float, rest: float) -> float:
    """Return by how much a value is above that at rest; 0 where that is rounding."""
    rise = value - rest
    return rise if abs(rise) > FLAT * abs(rest) else 0.0


def met(
    value: float, rise: float, bend: float, rest: float, limit: float, x: float, turn: float = 0.0
) -> Trial:  # fmt: skip
    """Return where the parabola from rest, with a rise and a bend at x, meets a limit."""
    slope = rise - bend * x
    if limit == math.inf:
        return Trial(value, rise, turn, bend, slope, 0.0, FAR)
    inside = slope**2 + 4.0 * bend * (limit - rest)
    term = slope + math.sqrt(inside) if inside >= 0.0 else 0.0
    if rest > limit:
        return Trial(value, rise, turn, bend, slope, term, 0.0)
    over = 2.0 * (limit - rest)
    found = FAR if term * FAR <= over else over / term
    return Trial(value, rise, turn, bend, slope, term, found if found <= REACH * x else rough(found))


def rough(x: float) -> float:
    """Return the power of ten that is nearest to an x."""
    return float(10.0 ** math.floor(math.log10(x) + 0.5)) if x > 0.0 else 0.0


def further(
    value: float, last: Trial, before: float, x: float, rest: float, limit: float, lone: float | None,
    apart: float = APART,
) -> Trial:  # fmt: skip
    """Return the next trial of a quantity, after one at ``before``.

    ``lone`` is the power of x with which it grows if it tells nothing beside others; None after the first trial.
    """
    rise = risen(value, rest) / x if x > 0.0 else 0.0
    turn = rise - last.rise
    if told(x, before, lone is None, apart):
        bend = turn / (x - before)
    elif lone is None:
        bend = last.bend
    else:
        bend = lone * rise / x if x > 0.0 else 0.0
    return met(value, rise, bend, rest, limit, x, turn)


def told(x: float, before: float, later: bool, apart: float = APART) -> bool:
    """Whether two trials, the ``later`` ones or the first beside the present rate, tell a parabola's bend."""
    return abs(x - before) > apart * x and (later or x < TRUSTED)


def telling(xs: Sequence[float], apart: float = APART) -> list[int]:
    """Return whether each trial differs enough from the one before to tell a bend; the first is the present rate."""
    return [0, *(int(told(after, before, bool(n), apart)) for n, (before, after) in enumerate(pairwise(xs)))]
