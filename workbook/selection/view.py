"""The engine's view of a choice of motor and reducer: units to SI, pairs in the order of the sheet's tables."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.drivetrain import LimitCheck, OperatingPoints
from engine.laws.base import Array
from engine.pairing import Motors, Pairs, Reducers, TorqueCurve, checks, operating_points, rank
from engine.selection import Ranges, Task, ratio_ranges, rms_torque
from workbook.entries.units import RPM
from workbook.selection.entries import Selection, SelectionSizes

NONE = 1e-9  # rad/s², Nm, rad/s: an acceleration, a torque, a speed that small comes from rounding
PLACES = 6  # decimals in which scores are compared: equal to an engineer, equal in the ranking
STEP = 1e-10  # by which each row of the pairs ranks behind the one above it where they are equal


@dataclass(frozen=True)
class Samples:
    """The load over one cycle at its own shaft: time (s), ω_L (rad/s), ω̇_L (rad/s²), T*_L (Nm)."""

    time: Array
    speed: Array
    acceleration: Array
    torque: Array


@dataclass(frozen=True)
class Asked:
    """What the load asks for: as :class:`engine.selection.Task`, where 0 says that it does not accelerate."""

    acceleration_rms: float
    torque_rms: float
    power_rate_mean: float
    max_speed: float

    @property
    def task(self) -> Task | None:
        """The engine's task, or None for a load that does not accelerate, or has no torque."""
        if min(self.acceleration_rms, self.torque_rms, self.max_speed) <= NONE:
            return None
        bound = self.acceleration_rms * self.torque_rms  # which rounding, and an own law's samples, may overstep
        mean = max(-bound, min(bound, self.power_rate_mean))
        return Task(self.acceleration_rms, self.torque_rms, mean, self.max_speed)

    @property
    def load_factor(self) -> float:
        """β, S5 eq. (15)."""
        return self.task.load_factor if self.task else 0.0


def figures(values: list[float | None], missing: float) -> Array:
    """Return figures as an array, ``missing`` where none is given."""
    return np.array([missing if v is None else v for v in values], dtype=np.float64)


class Choosing:
    """A selection put to the engine."""

    def __init__(self, given: Selection, sizes: SelectionSizes, asked: Asked, samples: Samples) -> None:
        self.given, self.asked, self.samples = given, asked, samples
        self.rooms = (sizes.motors, sizes.reducers)
        self.torque_needed = given.torque_factor * float(np.abs(samples.torque).max())
        rows = given.motors
        self.motors = Motors(
            tuple(m.name for m in rows),
            np.array([m.inertia for m in rows]),
            np.array([m.rated_torque for m in rows]),
            np.array([m.peak_torque for m in rows]),
            np.array([m.max_speed for m in rows]) * RPM,
        )
        boxes = given.reducers
        self.reducers = Reducers(
            tuple(r.name for r in boxes),
            np.array([1.0 / r.reduction for r in boxes]),
            np.array([r.efficiency for r in boxes]),
            figures([r.inertia for r in boxes], 0.0),
            figures([r.max_speed for r in boxes], math.inf) * RPM,
            figures([r.max_torque for r in boxes], math.inf),
        )

    @cached_property
    def acceleration_scale(self) -> float:
        """What the load's acceleration (rad/s²) is measured by where it may be near 0: its speed in a cycle."""
        time = self.samples.time
        return max(self.asked.acceleration_rms, self.asked.max_speed / float(time[-1] - time[0]), 1e-3)

    @cached_property
    def ranges(self) -> Ranges | None:
        """The ratios that each motor accepts, steps 3 and 4; None without a task."""
        if self.asked.task is None:
            return None
        m = self.motors
        return ratio_ranges(self.asked.task, m.rated_torque, m.inertia, m.max_speed, self.given.efficiency)

    @cached_property
    def strong(self) -> NDArray[np.bool_]:
        """Whether each reducer holds the load's torque."""
        return np.asarray(self.reducers.max_output_torque >= self.torque_needed)

    @cached_property
    def rms(self) -> Array:
        """RMS torque (Nm) of each pair, motors down and reducers across; 0 without a task."""
        m, r = self.motors, self.reducers
        if self.asked.task is None:
            return np.zeros((len(m.names), len(r.names)))
        return rms_torque(self.asked.task, m.inertia[:, None], r.ratio, r.efficiency, r.inertia)

    @cached_property
    def usable(self) -> NDArray[np.bool_]:
        """Whether each pair holds the load's torque and speed: steps 3 to 5, with η and J_T of step 7."""
        found = self._ranked(np.arange(len(self.motors.names)), np.flatnonzero(self.strong), "margin")
        return self._spread(found, np.ones(len(found)), 0.0) > 0.0

    @cached_property
    def ranking(self) -> Pairs:
        """The usable pairs that have the figures which the criterion reads, best first, equals as in the tables."""
        m, r = self.given.motors, self.given.reducers
        name = {"size": "mass", "cost": "cost"}.get(self.given.criterion)
        has_m = [name is None or getattr(row, name) is not None for row in m]
        has_r = [name is None or getattr(row, name) is not None for row in r]
        found = self._ranked(np.flatnonzero(has_m), np.flatnonzero(self.strong & has_r), self.given.criterion)
        if self.given.criterion == "margin":
            found = replace(found, score=np.sqrt(found.score))  # the engine's is squared: the same order, finer here
        order = np.argsort(self.key(found), kind="stable")
        return Pairs(*(getattr(found, f)[order] for f in Pairs.__dataclass_fields__))

    def unit(self, pairs: Pairs) -> float:
        """Return what scores are counted in: kilograms and costs in shares of the largest."""
        counted = self.given.criterion in ("size", "cost") and len(pairs) > 0
        return float(pairs.score.max()) or 1.0 if counted else 1.0

    def key(self, pairs: Pairs) -> Array:
        """Return what pairs are sorted by: the rounded score (halves up, as in cells), then their row."""
        rounded = np.floor(pairs.score / self.unit(pairs) * 10**PLACES + 0.5) / 10**PLACES
        return np.asarray(rounded + self.row(pairs) * STEP)

    def _ranked(self, some: NDArray[Any], boxes: NDArray[Any], criterion: str) -> Pairs:
        """Rank some of the motors with some of the reducers; indices are those of the whole catalogues."""
        if self.asked.task is None or not (len(some) and len(boxes)):
            nothing = np.empty(0)
            return Pairs(nothing.astype(int), nothing.astype(int), nothing, nothing, nothing, nothing)
        found = rank(self.asked.task, self._some_motors(some), self._some_reducers(boxes), criterion)  # type: ignore[arg-type]  # one of the model's words
        return replace(found, motor=some[found.motor], reducer=boxes[found.reducer])

    def _some_motors(self, some: NDArray[Any]) -> Motors:
        m = self.motors
        rows = [self.given.motors[k] for k in some]
        return Motors(
            tuple(row.name for row in rows),
            m.inertia[some], m.rated_torque[some], m.peak_torque[some], m.max_speed[some],
            figures([row.mass for row in rows], 0.0), figures([row.cost for row in rows], 0.0),
        )  # fmt: skip

    def _some_reducers(self, some: NDArray[Any]) -> Reducers:
        r = self.reducers
        rows = [self.given.reducers[k] for k in some]
        return Reducers(
            tuple(row.name for row in rows),
            r.ratio[some], r.efficiency[some], r.inertia[some], r.max_input_speed[some], r.max_output_torque[some],
            figures([row.mass for row in rows], 0.0), figures([row.cost for row in rows], 0.0),
        )  # fmt: skip

    def _spread(self, pairs: Pairs, values: Array, other: float) -> Array:
        """Return a figure of each ranked pair at its place in the catalogues, ``other`` elsewhere."""
        table = np.full(self.rms.shape, other)
        table[pairs.motor, pairs.reducer] = values
        return table

    @cached_property
    def scores(self) -> Array:
        """The score of each ranked pair at its place in the catalogues, 0 elsewhere."""
        return self._spread(self.ranking, self.ranking.score, 0.0)

    @cached_property
    def keys(self) -> Array:
        """What each ranked pair is sorted by, at its place in the catalogues; 0 elsewhere."""
        return self._spread(self.ranking, self.key(self.ranking), 0.0)

    @cached_property
    def ranked(self) -> NDArray[np.bool_]:
        """Whether each pair is ranked."""
        return self._spread(self.ranking, np.ones(len(self.ranking)), 0.0) > 0.0

    def row(self, pairs: Pairs) -> NDArray[Any]:
        """Return the row of pairs in the table of all of them, from 1."""
        return np.asarray(pairs.motor * self.rooms[1] + pairs.reducer + 1)

    @cached_property
    def chosen(self) -> tuple[int, int] | None:
        """The pair that is looked at: the best, or the engineer's own; None where there is no best."""
        if self.given.pair == "chosen":
            names = [[n.casefold() for n in c.names] for c in (self.motors, self.reducers)]
            return names[0].index(self.given.motor.casefold()), names[1].index(self.given.reducer.casefold())
        return (int(self.ranking.motor[0]), int(self.ranking.reducer[0])) if len(self.ranking) else None

    @cached_property
    def curve(self) -> TorqueCurve:
        """Largest torque of the chosen motor against its speed."""
        row = self.given.motors[self.chosen[0] if self.chosen else 0]
        knee = row.max_speed if row.full_torque_to is None else row.full_torque_to
        end = row.peak_torque if row.end_torque is None else row.end_torque
        speeds = np.array([0.0, knee, row.max_speed]) * RPM
        return TorqueCurve(speeds, np.array([row.peak_torque, row.peak_torque, end]))

    @cached_property
    def points(self) -> OperatingPoints:
        """Speed and torque of the chosen motor over the cycle; all 0 without a pair."""
        s = self.samples
        if self.chosen is None:
            nothing = np.zeros(len(s.time))
            return OperatingPoints(nothing, nothing, nothing, s.time)
        return operating_points(self.motors, self.reducers, self.chosen, s.time, s.speed, s.acceleration, s.torque)

    @cached_property
    def checks(self) -> tuple[LimitCheck, ...]:
        """Step 7's five checks of the chosen pair; none without one."""
        if self.chosen is None:
            return ()
        torque = self.given.torque_factor * self.samples.torque
        return checks(self.motors, self.reducers, self.chosen, self.points, torque, self.curve)
