"""The engine's view of a choice of motor and reducer for one axis of a machine: units to SI, tables as on the sheet."""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.selection.catalogue import Motors, Reducers
from engine.selection.pair_matrix import RANKS, Curve, PairMatrix, Used, Wanted, gears, reserve
from engine.selection.point_load import Gears, shares_of
from workbook.book.rows import filled
from workbook.entries.units import KG_CM2, PER_HOUR, RPM, shown, si
from workbook.selection.catalogue import FULL_CYCLES, MotorRow, ReducerRow
from workbook.selection.entries import Ranked, SelectionSizes
from workbook.selection.shaft import Shaft

BEST = 20
"""rows of the list of the best pairs"""
AS_ENTERED = "as entered"


def figures(rows: Sequence[MotorRow | ReducerRow], entry: str, missing: float = math.nan) -> Array:
    """Return an entry of each product, ``missing`` where it is not given."""
    values = [getattr(row, entry) for row in rows]
    return np.array([missing if v is None else v for v in values], dtype=np.float64)


def engine_motors(rows: Sequence[MotorRow]) -> Motors:
    """Return the engine's catalogue of the motors entered."""
    of = {name: figures(rows, name) for name in MotorRow.model_fields if name not in ("name", "source")}
    return Motors(
        tuple(row.name for row in rows), si(of["inertia"], KG_CM2), of["rated_torque"], of["peak_torque"],
        si(of["max_speed"], RPM), of["mass"], of["cost"], si(of["full_torque_to"], RPM), of["end_torque"],
        of["stall_torque"], si(of["rated_speed"], RPM),
    )  # fmt: skip


def engine_reducers(rows: Sequence[ReducerRow]) -> Reducers:
    """Return the engine's catalogue of the reducers entered."""
    none = {"inertia": 0.0, "no_load_torque": 0.0, "full_cycles": FULL_CYCLES, "cycle_factor": 1.0}
    none |= dict.fromkeys(("max_speed", "max_torque", "mean_torque"), math.inf)
    of = {name: figures(rows, name, none.get(name, math.nan))
          for name in ReducerRow.model_fields if name not in ("name", "source")}  # fmt: skip
    return Reducers(
        tuple(row.name for row in rows), of["reduction"], of["efficiency"], si(of["inertia"], KG_CM2),
        si(of["max_speed"], RPM), of["max_torque"], of["mean_torque"], of["mass"], of["cost"], of["no_load_torque"],
        si(of["full_cycles"], PER_HOUR), of["cycle_factor"],
    )  # fmt: skip


class Figures(NamedTuple):
    """What a pair does, in the units of the sheet."""

    rms: float
    margin: float
    peak: float
    speed: float
    inertias: float
    spare: float


class Choosing:
    """The choice for the shaft that is named, or the only one.

    ``rooms`` are the rows and columns of the grid, ``pairs`` their number, ``rank`` that of what pairs are ranked by.
    """

    def __init__(self, given: Ranked, sizes: SelectionSizes, shafts: Sequence[Shaft], number: int = 0) -> None:
        self.given, self.sizes, self.shafts, self.number = given, sizes, shafts, number
        self.shaft = shafts[number]
        self.load = self.shaft.load
        self.rooms, self.pairs = (sizes.motors, sizes.reducers), sizes.motors * sizes.reducers
        self.rank = RANKS.index(given.rank) + 1
        self.motors = engine_motors(given.motors).derated(self.shaft.values["left"])
        self.reducers = engine_reducers(given.reducers)

    def held(self, name: str) -> float:
        """Return a figure of the pair that the shaft has."""
        return self.shaft.values[f"held_{name}"]

    @cached_property
    def wanted(self) -> Wanted:
        """What is wanted of a pair."""
        g = self.given
        return Wanted(g.inertia_ratio, g.least_margin, g.greatest_margin, g.torque_factor,
                      g.least_peak_margin, g.least_speed_margin)  # fmt: skip

    @cached_property
    def grid(self) -> PairMatrix:
        """All pairs."""
        return PairMatrix(self.load, self.motors, self.reducers, self.shaft.values["beside"], self.wanted,
                          si(self.shaft.values["cycles"], PER_HOUR))  # fmt: skip

    @cached_property
    def own_gears(self) -> Gears:
        """The reducer that the drive has."""
        return gears(0.0, *(np.array([self.held(name)]) for name in ("i", "eta", "no_load")))

    @cached_property
    def behind_own(self) -> PairMatrix:
        """All motors behind the reducer that the drive has, whose own limits are checked on the drive's sheet."""
        none, own = np.array([np.inf]), self.own_gears
        reducer = Reducers(("own",), own.ratio, own.efficiency, own.inertia, none, none, no_load=own.no_load)
        return PairMatrix(self.load, self.motors, reducer, self.held("j") - self.held("jm"), self.wanted)

    @cached_property
    def usable_behind_own(self) -> list[int]:
        """The motors that can do it behind the reducer that the drive has, the smallest first."""
        yes = np.flatnonzero(self.behind_own.verdicts[:, 0] == "yes").tolist()
        return sorted(yes, key=lambda k: (self.grid.smaller[k], k))

    @cached_property
    def every_drive(self) -> list["Choosing"]:
        """The choice for each shaft."""
        return [Choosing(self.given, self.sizes, self.shafts, n) for n in range(len(self.shafts))]

    @cached_property
    def mixed(self) -> Array:
        """The mean of ω̇ S before each reducer, with its losses (W/s)."""
        return self.load.mixed(gears(0.0, self.reducers.reduction, self.reducers.efficiency, self.reducers.no_load))

    @cached_property
    def square(self) -> Array:
        """The mean square of the load's torque at the motor before each reducer (N²m²)."""
        return self.load.square(gears(0.0, self.reducers.reduction, self.reducers.efficiency, self.reducers.no_load))

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
    def held_names(self) -> tuple[str, str]:
        """The names of the drive's motor and reducer."""
        motor, reducer = int(self.held("row")), int(self.held("gear"))
        return (self.motors.names[motor - 1] if motor else AS_ENTERED,
                self.reducers.names[reducer - 1] if reducer else AS_ENTERED)  # fmt: skip

    def curve(self, motor: int) -> Curve:
        """Return the curve of a motor of the catalogue."""
        m = self.motors
        return Curve(float(m.peak_torque[motor]), float(m.knee[motor]), max(0.0, 0.0 - float(m.slope[motor])))

    @cached_property
    def listed(self) -> list[Figures]:
        """The best pairs."""
        g, found = self.grid, []
        for m, r in self.ranked[:BEST]:
            margin = float(shares_of(np.array(1.0), g.uses[m, r]))
            spare = reserve(self.load, g.pair(m, r), self.curve(m))
            peak, speed = float(g.peak[m, r]), shown(float(g.speed[r]), RPM)
            found.append(Figures(float(g.rms[m, r]), margin, peak, speed, float(g.inertia_ratio[m, r]), spare))
        return found

    def named(self, count: int) -> list[str]:
        """Return the names of the first pairs."""
        names = [f"{self.motors.names[m]} + {self.reducers.names[r]}" for m, r in self.ranked[:count]]
        return filled(names, count, "–")

    def used(self, place: int) -> Used:
        """Return what one of the best pairs uses of its motor, by its place from 0; left of all where there is none."""
        if place >= len(self.ranked):
            return Used(-1.0, -1.0)
        return self.grid.use(*self.ranked[place])

    @cached_property
    def proposed(self) -> int | None:
        """The place of the first of the best pairs that stays below its motor's curve, from 0; None where none does."""
        return next((k for k, one in enumerate(self.listed) if one.spare >= 0.0), None)

    @cached_property
    def own(self) -> Figures:
        """The pair that the drive has."""
        held, inertia = self.held, self.held("j")
        ratio, motor = held("i"), held("jm")
        rms = float(self.load.rms(gears(inertia, ratio, held("eta"), held("no_load")))[0])
        inertias = (inertia - motor + self.load.inertia / ratio**2) / motor if motor else 0.0
        margin = held("rated") / rms if rms else 0.0
        return Figures(rms, margin, held("top"), shown(ratio * self.load.speed, RPM), inertias, held("spare"))

    def whole(self, table: str) -> str:
        """Return the range of a table of all pairs."""
        return f"[@{table}1.v.first]:[@{table}{self.rooms[1]}.v.last]"

    def spread(self, table: NDArray[Any], spare: Any) -> list[list[Any]]:
        """Return a table of the pairs by columns, ``spare`` where a row or a column of the sheet is."""
        whole = np.full(self.rooms, spare, dtype=object)
        whole[: table.shape[0], : table.shape[1]] = table
        return [column.tolist() for column in whole.T]
