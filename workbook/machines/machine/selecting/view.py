"""The engine's view of a choice of motor and reducer for one axis of a machine: units to SI, tables as on the sheet."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.machine.geared import shares_of
from engine.machine.grid import RANKS, Curve, Grid, Used, Wanted, gears, reserve, used
from engine.machine.point_load import PointLoad
from engine.machine.quadrature import COUNT
from workbook.book.rows import filled
from workbook.entries.texts import place_of
from workbook.entries.units import RPM, shown, si
from workbook.machines.machine.choice import Choice
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.selecting.behind import load_of, scales_of
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

    def __init__(self, given: Choice, sizes: SelectionSizes, drives: Sequence[DriveView]) -> None:
        self.given, self.drives = given, drives
        names = [one.driven.entered.name for one in drives]
        self.number = place_of(given.axis or "", names)
        self.view = drives[self.number]
        self.driven = self.view.driven
        self.rooms = sizes.motors, sizes.reducers
        self.motors = engine_motors(given.motors).derated(self.driven.left)
        self.reducers = engine_reducers(given.reducers)

    @cached_property
    def load(self) -> PointLoad:
        """What the cycle asks for behind the reducer."""
        return load_of(self.view)

    @cached_property
    def grid(self) -> Grid:
        """All pairs."""
        g = self.given
        wanted = Wanted(g.inertia_ratio, g.least_margin, g.greatest_margin, g.torque_factor)
        return Grid(self.load, self.motors, self.reducers, self.driven.beside_motor, wanted)

    @property
    def pairs(self) -> int:
        """Pairs of the grid, spare rows and columns among them."""
        return np.zeros(self.rooms).size

    @property
    def beta_scale(self) -> float:
        """How large the load factor's parts are."""
        return scales_of(self.view).product

    @property
    def rank(self) -> int:
        """The number of what pairs are ranked by, from 1."""
        return RANKS.index(self.given.rank) + 1

    @cached_property
    def keys(self) -> Array:
        """What the pairs are sorted by; NaN where they are not ranked."""
        return self.grid.keys(self.given.rank, self.rooms[1], self.pairs)

    @cached_property
    def ranked(self) -> list[tuple[int, int]]:
        """The ranked pairs, best first."""
        return self.grid.best(self.given.rank, self.rooms[1], self.pairs)

    def place(self, pair: tuple[int, int]) -> int:
        """Return the number of a pair in the grid, from 0, motor by motor."""
        return int(np.ravel_multi_index(pair, self.rooms))

    @property
    def rows(self) -> int:
        """Points of a drive's sheet: as many of each."""
        return self.view.rows * COUNT

    def by_point(self, values: Array) -> list[float]:
        """Return values of the points as a column."""
        return self.view.by_point(values.reshape(self.view.load.place.shape))

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
        spare = reserve(self.load, g.pair(m, r), self.curve(m))
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
        rms, peak = float(self.load.rms(pair)[0]), self.view.reserve.peak_torque.value
        speed = shown(d.reducer.ratio * self.load.speed, RPM)
        motor = d.motor_used
        margin = shares_of(np.array(motor.rated_torque), np.array(rms))
        return Figures(rms, float(margin), peak, speed, self.view.inertia_ratio, spare_of(self.view))

    def spread(self, table: NDArray[Any], spare: Any) -> list[list[Any]]:
        """Return a table of the pairs by columns, ``spare`` where a row or a column of the sheet is."""
        whole = np.full(self.rooms, spare, dtype=object)
        whole[: table.shape[0], : table.shape[1]] = table
        return [column.tolist() for column in whole.T]


def figures_of(view: DriveView) -> list[tuple[float, float]]:
    """Return what the sheet of a drive tells of the shaft behind its reducer, and of its motor, each with its scale."""
    d, load, scale = view.driven, load_of(view), scales_of(view)
    own, mixed, mixed_back, square, square_back = load.squares
    return [
        (own, scale.turned), (square, scale.square), (square_back, scale.square),
        (mixed, scale.product), (mixed_back, scale.product),
        (load.speed, 0.0), (load.torque, view.scales.behind),
        (load.inertia, 0.0), (d.beside_motor, 0.0), (float(d.holding == "brake"), 0.0),
        (float(d.given.method == "physical"), 0.0), (d.left, 0.0),
        (d.at_motor, 0.0), (d.motor_used.inertia, 0.0), (d.reducer.ratio, 0.0), (d.reducer.efficiency, 0.0),
        (d.motor_used.rated_torque, 0.0), (d.motor_used.peak_torque, 0.0),
        (view.reserve.peak_torque.value, view.scales.torque),
        (spare_of(view), view.scales.torque), (d.motor_used.max_speed, 0.0),
        (d.motor_used.row, 0.0), (d.reducer.row, 0.0),
    ]  # fmt: skip


def spare_of(view: DriveView) -> float:
    """Return what a drive leaves below its motor's curve (Nm); of a book that knows none that falls, of its peak."""
    return view.spare if view.knows_falling else view.driven.motor.peak_torque - view.reserve.peak_torque.value
