"""The engine's view of a choice of motor and reducer: units to SI, pairs in the order of the sheet's tables."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.choice import LoadSamples, Pair, Pairs, Task, rank, usable
from engine.choice.pairs import LoadAtMotor, counted_in, load_at_motor, sorting_keys
from engine.choice.ratios import Ranges, ratio_ranges, rms_torque
from engine.drivetrain import LimitCheck, OperatingPoints
from engine.laws.base import Array
from workbook.entries.texts import place_of
from workbook.selection.choosing import engine_motors, engine_reducers
from workbook.selection.entries import Selection, SelectionSizes

PARTS = 1_000_000  # of a unit, in which scores are compared: equal to an engineer, equal in the ranking


class Choosing:
    """A selection put to the engine."""

    def __init__(self, given: Selection, sizes: SelectionSizes, task: Task, load: LoadSamples) -> None:
        self.given, self.task, self.load = given, task, load
        self.rooms = (sizes.motors, sizes.reducers)
        self.rows = np.zeros(self.rooms).size  # of the table of all pairs
        self.motors, self.reducers = engine_motors(given.motors), engine_reducers(given.reducers)
        self.torque_needed = load.torque_needed(given.torque_factor)

    @cached_property
    def sizes(self) -> Task:
        """The sizes by which the task's figures are seen to be rounding."""
        return self.task.sizes(self.load.cycle_time)

    @property
    def load_factor(self) -> float:
        """β, step 2; 0 for a load that there is nothing to choose for."""
        return self.task.load_factor

    @cached_property
    def ranges(self) -> Ranges:
        """The ratios that each motor accepts, steps 3 and 4."""
        m = self.motors
        return ratio_ranges(self.task, m.rated_torque, m.inertia, m.max_speed, self.given.efficiency)

    @cached_property
    def at_motor(self) -> LoadAtMotor:
        """What each reducer makes of the load, step 5."""
        return load_at_motor(self.task, self.reducers, self.torque_needed)

    @cached_property
    def inertia(self) -> Array:
        """J_M + J_T (kg m²) of each pair, motors down and reducers across."""
        return self.motors.inertia[:, None] + self.reducers.inertia

    @cached_property
    def rms(self) -> Array:
        """RMS torque (Nm) of each pair, motors down and reducers across."""
        m, r = self.motors, self.reducers
        return rms_torque(self.task, m.inertia[:, None], r.ratio, r.efficiency, r.inertia)

    @cached_property
    def usable(self) -> NDArray[np.bool_]:
        """Whether each pair holds the load's torque and speed: steps 3 to 5, with η and J_T of step 7."""
        motor, reducer, _ = usable(self.task, self.motors, self.reducers, self.torque_needed)
        return self._spread(motor, reducer, np.ones(len(motor), dtype=bool))

    @cached_property
    def ranking(self) -> Pairs:
        """The usable pairs that have the figures which the criterion reads, best first, equals as in the tables."""
        found = rank(self.task, self.motors, self.reducers, self.given.criterion, output_torque=self.torque_needed)
        order = np.argsort(self._keys(found), kind="stable")
        return replace(found, **{name: getattr(found, name)[order] for name in Pairs.__dataclass_fields__})

    @property
    def counted_in(self) -> float:
        """What scores are counted in: the largest mass or cost, else 1."""
        return counted_in(self.ranking, self.given.criterion)

    def _keys(self, pairs: Pairs) -> Array:
        return sorting_keys(pairs, self.given.criterion, self.row(pairs), PARTS, self.rows)

    def row(self, pairs: Pairs) -> NDArray[np.intp]:
        """Return the row of pairs in the table of all of them, from 1."""
        return np.ravel_multi_index((pairs.motor, pairs.reducer), self.rooms) + 1

    def _spread(self, motor: NDArray[np.intp], reducer: NDArray[np.intp], values: NDArray[Any]) -> NDArray[Any]:
        """Return a figure of some pairs at their places in the catalogues, 0 elsewhere."""
        table = np.zeros(self.inertia.shape, dtype=values.dtype)
        table[motor, reducer] = values
        return table

    @cached_property
    def scores(self) -> Array:
        """The score of each ranked pair at its place in the catalogues, 0 elsewhere."""
        return self._spread(self.ranking.motor, self.ranking.reducer, self.ranking.score)

    @cached_property
    def keys(self) -> Array:
        """What each ranked pair is sorted by, at its place in the catalogues; 0 elsewhere."""
        return self._spread(self.ranking.motor, self.ranking.reducer, self._keys(self.ranking))

    @cached_property
    def ranked(self) -> NDArray[np.bool_]:
        """Whether each pair is ranked."""
        return self._spread(self.ranking.motor, self.ranking.reducer, np.ones(len(self.ranking), dtype=bool))

    @cached_property
    def pair(self) -> Pair | None:
        """The pair that is looked at: the best, or the engineer's own; None where there is no best."""
        if self.given.pair == "chosen":
            at = place_of(self.given.motor, self.motors.names), place_of(self.given.reducer, self.reducers.names)
        elif len(self.ranking):
            at = int(self.ranking.motor[0]), int(self.ranking.reducer[0])
        else:
            return None
        return Pair(self.motors, self.reducers, *at)

    @cached_property
    def points(self) -> OperatingPoints:
        """Speed and torque of the chosen motor over the cycle; all 0 without a pair."""
        if self.pair is None:
            nothing = np.zeros(len(self.load.time))
            return OperatingPoints(nothing, nothing, nothing, self.load.time)
        return self.pair.points(self.load)

    @cached_property
    def reserve(self) -> Array:
        """What is left below the chosen motor's curve (Nm); all 0 without a pair."""
        return np.zeros(len(self.load.time)) if self.pair is None else self.pair.reserve(self.points)

    @cached_property
    def checks(self) -> tuple[LimitCheck, ...]:
        """Step 7's five checks of the chosen pair; none without one."""
        if self.pair is None:
            return ()
        return self.pair.checks(self.points, self.load, self.given.torque_factor)
