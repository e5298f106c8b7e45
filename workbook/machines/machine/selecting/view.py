"""The engine's view of a choice of motor and reducer for one axis of a machine: units to SI, tables as on the sheet."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.machine.bent import BentPart
from engine.machine.geared import shares_of
from engine.machine.grid import RANKS, Asked, Curve, Grid, Points, Used, Wanted, gears, points, reserve, used
from engine.machine.node_load import NodeLoad
from engine.machine.places import NODES
from workbook.book.rows import filled
from workbook.entries.texts import place_of
from workbook.entries.units import RPM, shown, si
from workbook.machines.machine.choice import Choice
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.selecting.behind import load_of, scales_of
from workbook.machines.machine.stretched import Stretched
from workbook.selection.entries import SelectionSizes
from workbook.selection.view import engine_motors, engine_reducers

BEST = 20
"""rows of the list of the best pairs"""


AS_ENTERED = "as entered"


class Figures(NamedTuple):
    """What a pair does, in the units of the sheet."""

    rms: float
    margin: float
    peak: float
    speed: float
    inertias: float
    spare: float


class Choosing:
    """The choice for the axis that is named."""

    def __init__(self, given: Choice, sizes: SelectionSizes, drives: Sequence[Stretched]) -> None:
        self.given, self.drives = given, drives
        names = [one.driven.entered.name for one in drives]
        self.number = place_of(given.axis or "", names)
        self.stretched = drives[self.number]
        self.driven = self.stretched.driven
        self.rooms = sizes.motors, sizes.reducers
        self.motors = engine_motors(given.motors).derated(self.driven.left)
        self.reducers = engine_reducers(given.reducers)

    @cached_property
    def load(self) -> Asked:
        """What the cycle asks for behind the reducer."""
        return load_of(self.stretched)

    @cached_property
    def grid(self) -> Grid:
        """All pairs."""
        g = self.given
        wanted = Wanted(g.inertia_ratio, g.least_margin, g.greatest_margin, g.torque_factor)
        return Grid(self.load, self.motors, self.reducers, self.driven.beside_motor, wanted)

    @property
    def rows(self) -> int:
        """Pairs of the grid, spare rows and columns among them."""
        return np.zeros(self.rooms).size

    @property
    def beta_scale(self) -> float:
        """How large the load factor's parts are."""
        return scales_of(self.stretched).product

    @property
    def rank(self) -> int:
        """The number of what pairs are ranked by, from 1."""
        return RANKS.index(self.given.rank) + 1

    @cached_property
    def keys(self) -> Array:
        """What the pairs are sorted by; NaN where they are not ranked."""
        return self.grid.keys(self.given.rank, self.rooms[1], self.rows)

    @cached_property
    def ranked(self) -> list[tuple[int, int]]:
        """The ranked pairs, best first."""
        return self.grid.best(self.given.rank, self.rooms[1], self.rows)

    def place(self, pair: tuple[int, int]) -> int:
        """Return the number of a pair in the grid, from 0, motor by motor."""
        return int(np.ravel_multi_index(pair, self.rooms))

    @cached_property
    def places(self) -> int:
        """How many places the sheet has: of the drive with the most, that of the axis may be another."""
        return max(one.points for one in self.drives)

    @cached_property
    def points(self) -> Points:
        """Where the torque can be largest, in the order of the sheet; nothing behind the last."""
        return Points(*(np.array(filled(one, self.places)) for one in self._points))

    @property
    def _points(self) -> Points:
        """The ends of the stretches, begins before ends; or the nodes of the sections."""
        if isinstance(self.load, NodeLoad):
            return self.load.points
        ends = [(part, end) for end in (0, 1) for part in self.parts]
        alpha = np.array([part.turning_at(end) for part, end in ends])
        fastest = np.array([part.fastest_behind for part, _ in ends])
        torque = np.array([part.shaft_at(end) for part, end in ends])
        return points(alpha, torque, np.array(self._going), fastest, self.driven.given.method)

    @property
    def torque(self) -> Array:
        """The torque behind the reducer at these places (Nm)."""
        return self.points.driving + self.points.driven

    @property
    def going(self) -> list[float]:
        """The direction of motion there."""
        return filled(self._going, self.places)

    @property
    def _going(self) -> list[float]:
        if isinstance(self.stretched, PlacedWork):
            return [held.going for held, _ in self.stretched.placed for _ in NODES]
        return [part.going for _ in (0, 1) for part in self.parts]

    @property
    def parts(self) -> list[BentPart]:
        """The stretches; spare rows repeat the last."""
        return self.stretched.of(lambda part: part)

    @cached_property
    def figures(self) -> list[tuple[list[float], float]]:
        """What the sheets of the drives tell, a list of each figure in the order of the sheet, with its scale."""
        each = [figures_of(one) for one in self.drives]
        return [([row[k][0] for row in each], max(row[k][1] for row in each)) for k in range(len(each[0]))]

    @property
    def held_motor(self) -> str:
        """The name of the drive's motor."""
        row = self.driven.motor_used.row
        return self.motors.names[row - 1] if row else AS_ENTERED

    @property
    def held_reducer(self) -> str:
        """The name of the drive's reducer."""
        row = self.driven.reducer.row
        return self.reducers.names[row - 1] if row else AS_ENTERED

    def curve(self, motor: int) -> Curve:
        """Return the curve of a motor of the catalogue."""
        m = self.motors
        return Curve(float(m.peak_torque[motor]), float(m.knee[motor]), max(0.0, 0.0 - float(m.slope[motor])))

    @cached_property
    def listed(self) -> list[Figures]:
        """The best pairs."""
        return [self._figures(m, r) for m, r in self.ranked[:BEST]]

    def _figures(self, m: int, r: int) -> Figures:
        g = self.grid
        rms = float(g.rms[m, r])
        margin = shares_of(self.motors.rated_torque[m], g.rms[m, r])
        spare = reserve(self.points, g.pair(m, r), self.curve(m))
        peak, speed = float(g.peak[m, r]), shown(float(g.speed[r]), RPM)
        return Figures(rms, float(margin), peak, speed, float(g.inertia_ratio[m, r]), spare)

    def named(self, count: int) -> list[str]:
        """Return the names of the first pairs."""
        names = [f"{self.motors.names[m]} + {self.reducers.names[r]}" for m, r in self.ranked[:count]]
        return filled(names, count, "–")

    def used(self, place: int) -> Used:
        """Return what one of the best pairs uses of its motor, by its place from 0; left of all where there is none."""
        if place >= len(self.ranked):
            return Used(-1.0, -1.0)
        return self.grid.use(*self.ranked[place])

    @property
    def own_use(self) -> Used:
        """What the drive's pair uses of its motor."""
        return used(self.driven.motor_used.motor, si(self.own.speed, RPM), self.own.rms)

    @cached_property
    def proposed(self) -> int | None:
        """The place of the first of the best pairs that stays below its motor's curve, from 0; None where none does."""
        return next((k for k, one in enumerate(self.listed) if one.spare >= 0.0), None)

    @cached_property
    def own(self) -> Figures:
        """The pair that the drive has."""
        d = self.driven
        inertia = d.at_motor
        pair = gears(inertia, d.reducer.ratio, d.reducer.efficiency)
        rms, peak = float(self.load.rms(pair)[0]), d.demand.torque.peak
        speed = shown(self.load.speed_of_motor(d.reducer.ratio), RPM)
        motor = d.motor_used
        margin = shares_of(np.array(motor.rated_torque), np.array(rms))
        return Figures(rms, float(margin), peak, speed, d.inertia_ratio, self.stretched.spare)

    def spread(self, table: NDArray[Any], spare: Any) -> list[list[Any]]:
        """Return a table of the pairs by columns, ``spare`` where a row or a column of the sheet is."""
        whole = np.full(self.rooms, spare, dtype=object)
        whole[: table.shape[0], : table.shape[1]] = table
        return [column.tolist() for column in whole.T]


def figures_of(view: Stretched) -> list[tuple[float, float]]:
    """Return what the sheet of a drive tells of the shaft behind its reducer, and of its motor, each with its scale."""
    d, load, scale = view.driven, load_of(view), scales_of(view)
    own, mixed, mixed_back, square, square_back = load.squares
    return [
        (own, scale.turned), (square, scale.square), (square_back, scale.square),
        (mixed, scale.product), (mixed_back, scale.product),
        (load.speed, 0.0), (load.torque, d.sizes.behind),
        (load.inertia, 0.0), (d.beside_motor, 0.0),
        (float(d.given.method == "physical"), 0.0), (d.left, 0.0),
        (d.at_motor, 0.0), (d.motor_used.inertia, 0.0), (d.reducer.ratio, 0.0), (d.reducer.efficiency, 0.0),
        (d.motor_used.rated_torque, 0.0), (d.motor_used.peak_torque, 0.0),
        (d.demand.torque.peak, d.sizes.torque),
        (view.spare, d.sizes.torque), (d.motor_used.max_speed, 0.0),
        (d.motor_used.row, 0.0), (d.reducer.row, 0.0),
    ]  # fmt: skip
