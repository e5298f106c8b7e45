"""The highest rate of a drive that is worked out place by place, from its sections' nodes at its rate. SI units.

With x the square of the rate over the present one, inertia asks x times, viscous friction √x times what it does now,
and what resists stays. So torques at the nodes are known at any rate, without a place being worked out anew: that the
sections no longer begin where power turns round costs little. Extremes are those of parabolas through three nodes,
the rate is found to :data:`WITHIN`. :mod:`engine.machine.rate` comes to it exactly, another way.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drivetrain.losses import loss_factor
from engine.laws.base import Array
from engine.machine.demand import Demand
from engine.machine.falling import Falling
from engine.machine.limits import ReducerLimits
from engine.machine.pace import APART, FAR, LIMITS, NEARER, Trial, further, met, risen, telling
from engine.machine.places import NODES, WEIGHTS, Held, Worked

TRIALS = 7
FINE = 2
"""how many of the last trials find peaks between nodes, too"""
WITHIN = 1e-4
"""of the rate: how far below the one that is found all limits are held"""
LEAST = 1e-9
PARTS = 1e-9
"""of a section's largest value: values that differ by less are equal"""


class Loads(NamedTuple):
    """What acts at the nodes of sections, a row each, at the present rate.

    Parts of the force at the load (N, or Nm) by mass and by viscous friction, φ', φ̇ and φ̈; what resists, direction,
    whether the motor acts, and the width of each section (rad).
    """

    inertial: Array
    rubbing: Array
    first: Array
    rate: Array
    turning: Array
    level: Array
    going: Array
    acts: Array
    width: Array


def loads_of(placed: Sequence[tuple[Held, float, Worked]]) -> Loads:
    """Return the same of sections: each one's stretch, width (rad) and drive at the nodes."""
    rows = [
        (held.force.mass * at.a, held.force.viscous * at.v, at.first, at.rate, at.turning) for held, _, at in placed
    ]
    columns = [np.array(column) for column in zip(*rows, strict=True)]
    each = np.array([(held.force.level, held.going, held.acts, width) for held, width, _ in placed]).T
    return Loads(*columns, *(column[:, None] for column in each))


class Peak(NamedTuple):
    """The largest of a section's values: the largest at a node, the number of its node, three values around it.

    ``bend`` is above 0 where their parabola has a highest point, ``shift`` by how much that lies before the middle one,
    at most as far as one of the others.
    """

    most: float
    node: int
    before: float
    at: float
    after: float
    bend: float
    shift: float
    value: float


class Asked(NamedTuple):
    """What a rate asks for: ∫T² and ∫|S|³ |φ̇| of each section, the peaks of |T| and |S|, between nodes if ``fine``.

    ``line`` are the peaks of what the line of a falling curve must be at no speed.
    """

    x: float
    fine: bool
    squares: Array
    cubes: Array
    motor: list[Peak]
    geared: list[Peak]
    line: list[Peak]

    @property
    def peaks(self) -> tuple[float, float, float]:
        """The largest |T| and |S|, and of the line."""
        name = "value" if self.fine else "most"
        found = (max(getattr(one, name) for one in peaks) for peaks in (self.motor, self.geared, self.line))
        motor, geared, line = found
        return motor, geared, line


@dataclass(frozen=True)
class PlacePace:
    """Sections of a drive's cycle, and the limits that they must hold: as :class:`engine.machine.pace.Pace`."""

    loads: Loads
    held: Held
    demand: Demand
    rated_torque: float
    peak_torque: float
    max_speed: float
    reducer: ReducerLimits
    falling: Falling = Falling()  # noqa: RUF009 - a tuple

    @property
    def sink(self) -> float:
        """By how much the curve falls where the mechanism's shaft turns by 1 rad/s (Nm)."""
        return self.falling.fall * self.held.train.drive.mechanism.stages[0].ratio

    def line(self, torque: Array, rate: Array) -> Array:
        """Return what the line of a falling curve must be at no speed (Nm), of torques at speeds of the shaft."""
        return np.asarray(np.abs(torque) + self.sink * np.abs(rate))

    def torques(self, x: float) -> tuple[Array, Array]:
        """Return the torques of the motor and behind the reducer at the nodes (Nm), a row a section."""
        at, train = self.loads, self.held.train
        m = train.drive.mechanism
        force = x * at.inertial + math.sqrt(x) * at.rubbing + at.level
        before, last = m.stages
        through = loss_factor(force, at.going, last.efficiency, train.method, 0.0)
        behind = through * force / at.first + x * m.on_shaft(1) * at.turning
        own = (train.drive.motor_inertia + m.on_shaft(0)) * before.ratio * at.turning
        torque = loss_factor(behind, at.going, before.efficiency, train.method, 0.0) * behind / before.ratio + x * own
        return at.acts * torque, at.acts * behind

    def asked(self, x: float, fine: bool = False) -> Asked:
        """Return what a rate asks for."""
        torque, behind = self.torques(x)
        half = (self.loads.width / 2.0)[:, 0]
        squares, cubes = torque**2 @ WEIGHTS, (np.abs(behind) ** 3 * np.abs(self.loads.rate)) @ WEIGHTS
        line = self.line(torque, math.sqrt(x) * self.loads.rate)
        peaks = ([peak(row) for row in values] for values in (np.abs(torque), np.abs(behind), line))
        return Asked(x, fine, half * squares, half * cubes, *peaks)

    @cached_property
    def way(self) -> float:
        """∫|φ̇| over the cycle at the present rate."""
        return float((self.loads.width[:, 0] / 2.0 * (np.abs(self.loads.rate) @ WEIGHTS)).sum())

    def figures(self, asked: Asked) -> tuple[float, ...]:
        """Return mean square and cubic mean, the peaks of both torques, and of the line of a falling curve."""
        mean = math.cbrt(float(asked.cubes.sum()) / self.way) if self.way else 0.0
        square = float(asked.squares.sum()) / self.demand.course.told.total
        return square, mean, *asked.peaks

    @property
    def limits(self) -> tuple[float, ...]:
        """What each of these must not be above."""
        line = self.falling.lowest(self.peak_torque)
        return self.rated_torque**2, self.reducer.mean_torque, self.peak_torque, self.reducer.peak_torque, line

    @property
    def bounds(self) -> tuple[float, float]:
        """The x at which the limits of speed bind."""
        fastest = self.demand.speed.peak
        speeds = (self.max_speed, self.reducer.input_speed)
        motor, reducer = (min(FAR, (limit / fastest) ** 2) if fastest else FAR for limit in speeds)
        return motor, reducer

    @cached_property
    def rest(self) -> tuple[float, ...]:
        """What next to no rate asks for."""
        return self.figures(self.asked(0.0))

    @cached_property
    def tried(self) -> list[tuple[Asked, tuple[Trial, ...]]]:
        """The present rate, and all that were tried from there, with where each figure seems to meet its limit."""
        asked, kept = self.asked(1.0), zip(self.rest, self.limits, LONE, strict=True)
        known = list(kept)
        trials = []
        for value, (rest, limit, lone) in zip(self.figures(asked), known, strict=True):
            rise = risen(value, rest)
            trials.append(met(value, rise, lone * rise, rest, limit, 1.0))
        tried = [(asked, tuple(trials))]
        for n in range(TRIALS):
            before, last = asked.x, trials
            x = min(*self.bounds, *squared(one.x for one in last))
            asked = self.asked(x, n >= TRIALS - FINE)
            known_from = x if n == TRIALS - FINE else before
            trials = [
                further(value, one, first, at, rest, limit, None if n else lone, apart)
                for value, one, (rest, limit, lone), first, at, apart in zip(
                    self.figures(asked), last, known, rooted(known_from), rooted(x), NEAR, strict=True
                )
            ]
            tried.append((asked, tuple(trials)))
        return tried

    @property
    def sizes(self) -> list[float]:
        """How large each figure over x grows over the trials: by it rises are measured."""
        found = [(self.figures(asked), rooted(asked.x)) for asked, _ in self.tried if asked.x > 0.0]
        return [max(LEAST, *(figures[k] / at[k] for figures, at in found)) for k in range(len(LONE))]

    @property
    def losses(self) -> list[tuple[float, float]]:
        """Of each stage p = (f + f*)/2, q = (f − f*)/2: a torque counts f = p + q times, one that brakes f* = p − q."""
        train = self.held.train
        each = [
            [float(loss_factor(torque, 1.0, stage.efficiency, train.method)) for torque in (1.0, -1.0)]
            for stage in train.drive.mechanism.stages
        ]
        return [((drives + brakes) / 2.0, (drives - brakes) / 2.0) for drives, brakes in each]

    @property
    def apart(self) -> list[int]:
        """Whether each trial differs enough from the one before to tell a bend; the first fine one does not."""
        found = telling([asked.x for asked, _ in self.tried])
        found[-FINE] = 0
        return found

    @property
    def roots(self) -> list[float]:
        """√x of each trial."""
        return [math.sqrt(asked.x) for asked, _ in self.tried]

    @property
    def roots_apart(self) -> list[int]:
        """Whether these differ enough to tell a bend; the first fine one does not."""
        found = telling(self.roots, NEARER)
        found[-FINE] = 0
        return found

    @property
    def each(self) -> tuple[float, ...]:
        """The x at which each of :data:`engine.machine.pace.LIMITS` binds, to all digits where none binds before."""
        square, mean, peak, geared, line = squared(one.x for one in self.tried[-1][1])
        return (*self.bounds, peak, geared, square, mean, min(FAR, line))

    @property
    def rate(self) -> float:
        """The highest rate (1/s), a little below where a limit binds, so that all hold at it."""
        return math.sqrt(min(self.each)) * (1.0 - WITHIN) / self.demand.course.time

    @property
    def last_step(self) -> float:
        """By how much x changes with the last trial, as a share."""
        x = min(self.each)
        return abs(x / self.tried[-1][0].x - 1.0) if x > 0.0 else 0.0

    @property
    def limit(self) -> str:
        """The limit that binds there."""
        x = min(self.each)
        return LIMITS[self.each.index(x)] if x < FAR else ""


LONE = (1.0, 0.0, 0.0, 0.0, 1.0)
"""the power of x with which each figure grows beyond its first, where a single trial tells it"""
NEAR = (APART, APART, APART, APART, NEARER)
"""trials nearer to each other tell nothing of each figure's bend"""


def rooted(x: float) -> tuple[float, ...]:
    """Return what each figure is tried over: the last over √x, as the speed adds to it."""
    return x, x, x, x, math.sqrt(x)


def squared(found: Iterable[float]) -> tuple[float, ...]:
    """Return the x of what each figure is tried over."""
    *others, root = found
    return *others, root**2


def peak(values: Array) -> Peak:
    """Return the largest of a section's values: of the parabola through the largest at a node and both beside it."""
    most = float(values.max())
    node = int(np.flatnonzero(values >= most * (1.0 - PARTS))[0]) + 1
    middle = max(2, min(NODES.size - 1, node)) - 1
    before, at, after = values[middle - 1 : middle + 2].tolist()
    a, b, c = NODES[middle - 1 : middle + 2].tolist()
    bend = (b - a) * (at - after) - (b - c) * (at - before)
    if bend <= PARTS * most:
        return Peak(most, node, before, at, after, bend, 0.0, most)
    shift = ((b - a) ** 2 * (at - after) - (b - c) ** 2 * (at - before)) / (2.0 * bend)
    shift = max(b - c, min(b - a, shift))
    rise = bend * shift**2 / ((b - a) * (c - b) * (c - a)) if b - c < shift < b - a else 0.0
    return Peak(most, node, before, at, after, bend, shift, max(most, at + rise))
