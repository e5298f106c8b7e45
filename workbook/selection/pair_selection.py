"""A shaft that a motor and a reducer are chosen for, and the choice: in formulas, and by the engine in SI units."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.laws.points import POINTS
from engine.selection.catalogue import Motors, Reducers
from engine.selection.pair_matrix import RANKS, Pair, PairMatrix, Requirements
from engine.selection.point_load import PairArrays, PointLoad
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import in_scope
from workbook.book.rows import filled
from workbook.fields.units import KG_CM2, MM, PER_HOUR, RPM, shown, si
from workbook.selection.catalogue import FULL_CYCLES, MotorRow, ReducerRow
from workbook.selection.entries import Ranked, SelectionSizes

BEST = 15  # rows of the list of the best pairs
AS_ENTERED = "as entered"
NO_LIMIT = 1e9  # of a hub (mm) and of a mass (kg), where none is given
# of a shaft and of the pair that drives it, in the order of the sheet
FIGURES = cell_tables(__file__)["figures"]
MIXED = "@product/{eta}+@product_back*{eta}+{i}*{own}*@way_turning"
"""the mean of ω̇ S, of the shaft's acceleration and the load's torque before the reducer's losses, with its own"""
SQUARE = "(@square/{eta}^2+@square_back*{eta}^2)/{i}^2+2*{own}*(@way_behind/{eta}+@way_back*{eta})/{i}+{own}^2*@way"
"""the mean square of the load's torque at the motor, with the reducer's own"""


class Figure(NamedTuple):
    """A figure of a shaft or of its drive: the formula of its cell without ``=``, the engine's value, its scale."""

    name: str
    label: str
    unit: str
    formula: str
    value: float
    scale: float = 0.0


def load_figures(load: PointLoad, turning: float, torque: float) -> dict[str, tuple[float, float]]:
    """Return the figures of a load with their scales, by those of its acceleration (rad/s²) and its torque (Nm)."""
    own, mixed, mixed_back, square, square_back, way, way_turning, way_behind, way_back = load.squares
    return {
        "own": (own, turning**2),
        "square": (square, torque**2),
        "square_back": (square_back, torque**2),
        "product": (mixed, turning * torque),
        "product_back": (mixed_back, turning * torque),
        "way": (way, 0.0),
        "way_turning": (way_turning, turning),
        "way_behind": (way_behind, torque),
        "way_back": (way_back, torque),
        "speed": (load.speed, 0.0),
        "mean": (load.mean_speed, 0.0),
        "smax": (load.torque, torque),
        "smean": (load.mean_torque, torque),
        "inertia": (load.inertia, 0.0),
    }


def shaft_figures(
    scope: str, formulas: Mapping[str, str], values: Mapping[str, float | tuple[float, float]]
) -> list[Figure]:
    """Return the figures of a shaft by the formulas of their cells, and by their values, some with a scale."""
    figures = []
    for name, row in FIGURES.items():
        value = values[name]
        each = value if isinstance(value, tuple) else (value,)
        figures.append(Figure(name, row.texts["label"], row.texts["unit"], in_scope(formulas[name], scope), *each))
    return figures


@dataclass
class Shaft:
    """A shaft behind a reducer, with the pair that drives it.

    ``title`` is the formula of its axis' name. ``columns`` begins the names of the columns of its points in the book
    (``dir``, ``al``, ``S``, ``n``); they have ``rows`` intervals, spare ones among them. ``rpm`` makes |speed| of the
    shaft (rpm) of the column ``n``. ``turning`` is the scale of ω̇ (rad/s²), ``torque`` that of S (Nm).
    """

    name: str
    number: int
    title: str
    columns: str
    rows: int
    load: PointLoad
    rpm: str
    turning: float
    torque: float
    figures: Sequence[Figure]

    def __post_init__(self) -> None:
        # the engine's, by the names of figures
        self.values = {figure.name: figure.value for figure in self.figures}
        self.product = self.turning * self.torque  # the scale of means of ω̇ S (W/s)


def column(rows: Sequence[MotorRow | ReducerRow], entry: str, missing: float = math.nan) -> Array:
    """Return an entry of each product, ``missing`` where it is not given."""
    values = [getattr(row, entry) for row in rows]
    return np.array([missing if v is None else v for v in values], dtype=np.float64)


def engine_motors(rows: Sequence[MotorRow]) -> Motors:
    """Return the engine's catalogue of the motors entered."""
    of = partial(column, rows)
    return Motors(
        tuple(row.name for row in rows),
        si(of("inertia"), KG_CM2),
        of("rated_torque"),
        of("peak_torque"),
        si(of("max_speed"), RPM),
        of("mass"),
        of("cost"),
        si(of("full_torque_to"), RPM),
        of("end_torque"),
        of("stall_torque"),
        si(of("rated_speed"), RPM),
        si(of("shaft"), MM),
    )


def engine_reducers(rows: Sequence[ReducerRow]) -> Reducers:
    """Return the engine's catalogue of the reducers entered."""
    of, none = partial(column, rows), math.inf
    return Reducers(
        tuple(row.name for row in rows),
        of("reduction"),
        of("efficiency"),
        si(of("inertia", 0.0), KG_CM2),
        si(of("max_speed", none), RPM),
        of("max_torque", none),
        of("mean_torque", none),
        of("mass"),
        of("cost"),
        of("no_load_torque", 0.0),
        si(of("full_cycles", FULL_CYCLES), PER_HOUR),
        of("cycle_factor", 1.0),
        si(of("hub", none), MM),
    )


class PairFigures(NamedTuple):
    """The figures of a pair, in the units of the sheet."""

    rms: float
    peak: float
    speed: float
    inertias: float
    spare: float


class PairSelection:
    """The choice for the shaft that is named, or the only shaft.

    ``rooms`` are the rows and columns of the grid, ``pairs`` their number, ``rank`` that of what pairs are ranked by.
    """

    def __init__(self, given: Ranked, sizes: SelectionSizes, shafts: Sequence[Shaft], number: int = 0) -> None:
        self.given, self.sizes, self.shafts, self.number = given, sizes, shafts, number
        self.shaft = shafts[number]
        self.load = self.shaft.load
        # of whichever shaft is named
        self.point_rows = max(shaft.rows for shaft in shafts) * POINTS
        self.is_ragged = any(shaft.rows * POINTS < self.point_rows for shaft in shafts)
        self.rooms, self.pairs = (sizes.motors, sizes.reducers), sizes.motors * sizes.reducers
        self.rank = RANKS.index(given.rank) + 1
        own = self.shaft.values
        self.requirements = Requirements(
            own["inertia_ratio"],
            own["rms_reserve"],
            given.greatest_margin,
            own["torque_factor"],
            own["peak_reserve"],
            own["speed_reserve"],
            own["most_mass"],
        )
        self.motors = engine_motors(given.motors).derated(self.shaft.values["left"])
        r = self.reducers = engine_reducers(given.reducers)
        # before any motor
        self.bare = PairArrays(0.0 * r.reduction, r.reduction, r.efficiency, r.no_load)
        self.grid = PairMatrix(self.load, self.motors, r, own["beside"], self.requirements, si(own["cycles"], PER_HOUR))
        scores = self.grid.rounded(given.rank)
        motor, reducer = np.indices(scores.shape)
        # what pairs are sorted by; NaN: not ranked
        self.keys = scores * self.pairs + motor * sizes.reducers + reducer
        self.ranked = self.grid.best(given.rank)  # motor and reducer, best first

    def by_point(self, values: Array) -> list[float]:
        """Return values of the points as a column; spare intervals have that of the last, rows beyond them 0."""
        flat = values.ravel()
        return filled(filled(flat, self.shaft.rows * POINTS, float(flat[-1])), self.point_rows)

    def in_use(self, name: str) -> float:
        """Return a figure of the pair that the shaft has."""
        return self.shaft.values[f"held_{name}"]

    @cached_property
    def own_reducer(self) -> PairArrays:
        """The reducer that the drive has."""
        return Pair(0.0, *(self.in_use(name) for name in ("i", "eta", "no_load"))).arrays

    @property
    def means_behind_own(self) -> tuple[float, float]:
        """The means of ω̇ S (W/s) and S² (Nm²) behind the reducer that the drive has, S the load's torque."""
        return float(self.load.mixed(self.own_reducer)[0]), float(self.load.square(self.own_reducer)[0])

    @cached_property
    def behind_own(self) -> PairMatrix:
        """All motors behind the reducer that the drive has, whose own limits are checked on the drive's sheet."""
        none, own = np.array([np.inf]), self.own_reducer
        hub = np.array([si(self.in_use("hub"), MM)])
        reducer = Reducers(("own",), own.ratio, own.efficiency, own.inertia, none, none, no_load=own.no_load, hub=hub)
        wanted = self.requirements._replace(most_mass=self.in_use("room"))
        return PairMatrix(self.load, self.motors, reducer, self.in_use("j") - self.in_use("jm"), wanted)

    @cached_property
    def usable_behind_own(self) -> list[int]:
        """The motors that can do it behind the reducer that the drive has, the smallest first."""
        yes = np.flatnonzero(self.behind_own.verdicts[:, 0] == "yes").tolist()
        return sorted(yes, key=lambda k: (self.grid.smaller[k], k))

    @cached_property
    def every_drive(self) -> list["PairSelection"]:
        """The choice for each shaft."""
        return [PairSelection(self.given, self.sizes, self.shafts, n) for n in range(len(self.shafts))]

    @property
    def names_in_use(self) -> tuple[str, str]:
        """The names of the drive's motor and reducer."""
        motor, reducer = int(self.in_use("row")), int(self.in_use("gear"))
        return (
            self.motors.names[motor - 1] if motor else AS_ENTERED,
            self.reducers.names[reducer - 1] if reducer else AS_ENTERED,
        )

    def built(self, motor: int, reducer: int) -> dict[str, float]:
        """Return a motor's shaft, the largest in a reducer's hub (mm), and masses (kg), by cell; 0: not told."""
        m, r, hub = self.motors, self.reducers, shown(float(self.reducers.hub[reducer]), MM)
        figures = shown(m.shaft[motor], MM), m.size[motor], hub if math.isfinite(hub) else 0.0, r.size[reducer]
        names = "@motor_shaft", "@motor_kg", "@reducer_hub", "@reducer_kg"
        return dict(zip(names, map(float, np.nan_to_num(figures)), strict=True))

    @cached_property
    def listed(self) -> list[PairFigures]:
        """The figures of the best pairs."""
        g, pairs = self.grid, []
        for m, r in self.ranked[:BEST]:
            peak, speed = float(g.peak[m, r]), shown(float(g.speed[r]), RPM)
            inertias, spare = float(g.inertia_ratio[m, r]), g.reserve(m, r)
            pairs.append(PairFigures(float(g.rms[m, r]), peak, speed, inertias, spare))
        return pairs

    @cached_property
    def proposed(self) -> int | None:
        """The place of the first of the best pairs that stays below its motor's curve, from 0; None where none does."""
        return next((k for k, pair in enumerate(self.listed) if pair.spare >= 0.0), None)

    def whole(self, table: str) -> str:
        """Return the range of a table of all pairs."""
        return f"[@{table}1.v.first]:[@{table}{self.rooms[1]}.v.last]"
