"""Motors by reducers for a cycle: which pairs can do it within limits, and which of them suit it best. SI units.

Torques are those of the points of a cycle (:mod:`engine.selection.point_load`); S5's steps 5 to 7, whose table of pairs
this is, take the motor as driving all the time.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive.limits import cycle_factor_at
from engine.laws.base import Array
from engine.selection.catalogue import Motors, Reducers
from engine.selection.point_load import PairArrays, PointLoad
from engine.selection.task import Task

Rank = Literal["smallest motor", "margin", "inertia match", "mass", "cost"]
RANKS: tuple[str, ...] = get_args(Rank)
PARTS = 10_000  # of a unit, in which scores are compared


class Requirements(NamedTuple):
    """What a usable pair meets."""

    inertia_ratio: float  # at most
    least_margin: float  # of the rated over the RMS torque
    greatest_margin: float
    torque_factor: float  # on the torque that a reducer carries
    least_peak: float = 1.0  # a motor's peak torque over what is asked of it
    least_speed: float = 1.0  # its largest speed over what is asked of it


class PeakTorqueCurve(NamedTuple):
    """Peak torque (Nm), the speed (rad/s) up to which it holds, and its fall beyond (Nm s)."""

    peak: float
    knee: float
    fall: float


class Pair(NamedTuple):
    """A motor with a reducer: J (kg m²) of what turns with the motor, i, η, no-load torque (Nm)."""

    inertia: float
    ratio: float
    efficiency: float
    no_load: float = 0.0


def reserve(load: PointLoad, pair: Pair, curve: PeakTorqueCurve) -> float:
    """Return the least that is left below a motor's curve at the points (Nm), for J, i, η and no-load torque."""
    return curve.peak - max(float(load.peak(pair_arrays(*pair))[0]), falling_demand(load, pair, curve))


def falling_demand(load: PointLoad, pair: Pair, curve: PeakTorqueCurve) -> float:
    """Return the largest |T| + f (n − n_1) at the points (Nm): what they ask of the falling part of a curve."""
    torque, speed = load.torques(pair_arrays(*pair))[0], pair.ratio * load.points.speed
    return float((np.abs(torque) + curve.fall * (speed - curve.knee)).max())


def pair_arrays(inertia: ArrayLike, ratio: ArrayLike, efficiency: ArrayLike, no_load: ArrayLike) -> PairArrays:
    """Return motors with their reducers in a line: J (kg m²), i, η, no-load torque (Nm)."""
    each = np.broadcast_arrays(*(np.asarray(one, dtype=np.float64) for one in (inertia, ratio, efficiency, no_load)))
    return PairArrays(*(one.reshape(-1) for one in each))


@dataclass(eq=False)
class PairMatrix:
    """Every motor of a catalogue (down) behind every reducer (across)."""

    load: PointLoad
    motors: Motors
    reducers: Reducers
    beside: float  # turns with the motor (kg m²)
    wanted: Requirements
    rate: float = 0.0  # of cycles (1/s)

    def __post_init__(self) -> None:
        r, rated = self.reducers, self.motors.rated_torque
        self.beside_motor: Array = r.inertia + self.beside  # what turns with a motor before each reducer (kg m²)
        self.inertias: Array = self.motors.inertia[:, None] + self.beside_motor  # J of each pair (kg m²)
        self.gears = pair_arrays(self.inertias, 1.0 / r.ratio, r.efficiency, r.no_load)  # of each pair, motor by motor
        self.speed: Array = self.load.speed / r.ratio  # largest speed of the motor before each reducer (rad/s)
        self.at_motor: Array = self.beside_motor + self.load.inertia * r.ratio**2  # inertia that each drives (kg m²)
        self.inertia_ratio: Array = self.at_motor / self.motors.inertia[:, None]  # the same over each motor's
        self.output_torque = self.wanted.torque_factor * self.load.torque  # that a reducer must hold (Nm)
        held = r.max_output_torque / cycle_factor_at(self.rate, r.full_rate, r.cycle_factor)
        self.most_output_torque: Array = held  # of each reducer at these cycles (Nm)
        strong = (self.output_torque <= held) & (self.load.mean_torque <= r.max_mean_torque)
        self.fits: NDArray[np.bool_] = strong & (self.speed <= r.max_input_speed)  # whether a reducer holds the load
        self.smaller: NDArray[np.int_] = (rated < rated[:, None]).sum(axis=1)  # how many motors are rated less, of each

    def pair(self, motor: int, reducer: int) -> Pair:
        """Return J, i, η and no-load torque of a pair."""
        return Pair(*(float(one.reshape(self.inertias.shape)[motor, reducer]) for one in self.gears))

    @cached_property
    def rms(self) -> Array:
        """RMS torque of each motor (Nm)."""
        return self.load.rms(self.gears).reshape(self.inertias.shape)

    @cached_property
    def peak(self) -> Array:
        """Largest torque of each motor (Nm)."""
        return self.load.peak(self.gears).reshape(self.inertias.shape)

    @property
    def task(self) -> Task:
        """What the cycle asks for behind the reducer, as S5 tells it; a mean past ±ω̇_rms T*_rms is rounding."""
        means = self.load.squares
        acceleration, torque = math.sqrt(means.own), math.sqrt(means.load + means.load_back)
        most = acceleration * torque
        return Task(acceleration, torque, max(-most, min(most, means.mixed + means.mixed_back)), self.load.speed)

    def use(self, motor: int, reducer: int) -> tuple[float, float]:
        """Return a pair's speed over its motor's largest, its RMS torque over the continuous at the mean speed."""
        return float(self.speed[reducer] / self.motors.max_speed[motor]), float(self.uses[motor, reducer])

    @cached_property
    def uses(self) -> Array:
        """The RMS torque of each pair over its motor's continuous torque at the mean speed."""
        return self.rms / self.motors.continuous(np.s_[:, None], self.load.mean_speed / self.reducers.ratio)

    @cached_property
    def verdicts(self) -> NDArray[np.str_]:
        """What each pair fails first, or that it is usable."""
        m, wanted = self.motors, self.wanted
        fails = {
            "reducer": np.broadcast_to(~self.fits, self.rms.shape),
            "speed": self.speed * wanted.least_speed > m.max_speed[:, None],
            "peak": self.peak * wanted.least_peak > m.peak_torque[:, None],
        }
        return np.select(list(fails.values()), list(fails), self.wanted_verdicts)

    @cached_property
    def wanted_verdicts(self) -> NDArray[np.str_]:
        """What each pair fails of margins and inertia ratio, or that it is usable."""
        fails = {
            "RMS": self.uses * self.wanted.least_margin > 1.0,
            "large": self.uses * self.wanted.greatest_margin < 1.0,
            "inertia": self.inertia_ratio > self.wanted.inertia_ratio,
        }
        return np.select(list(fails.values()), list(fails), "yes")

    @cached_property
    def balance(self) -> Array:
        """The inertia with the motor (kg m²) that each reducer balances: J α_rms/τ = τ S_rms/η. Source: S5, (14)."""
        r, means = self.reducers, self.load.squares
        if not means.own:
            return np.zeros(r.ratio.shape)
        share = math.sqrt((means.load + means.load_back) / means.own)
        return np.asarray(r.ratio**2 / r.efficiency * share)

    def scores(self, rank: Rank) -> Array:
        """Return what pairs are ranked by, lowest first, NaN without the figure; of equal motors the less used."""
        used = self.uses / (1.0 + self.uses)
        if rank == "smallest motor":
            return self.smaller[:, None] + used
        if rank == "margin":
            return np.asarray(used)
        if rank == "inertia match":
            x = np.broadcast_to(self.balance, used.shape) / self.inertias
            return np.where(x > 0.0, np.exp(np.abs(np.log(x, out=np.zeros(x.shape), where=x > 0.0)) / 2.0), 0.0)
        name = "size" if rank == "mass" else "cost"
        return np.asarray(getattr(self.motors, name)[:, None] + getattr(self.reducers, name))

    def keys(self, rank: Rank, across: int, rooms: int) -> Array:
        """Return whole numbers that rise as pairs rank, of ``rooms``, ``across`` in a row; NaN of no rank."""
        score = np.where(self.verdicts == "yes", self.scores(rank), np.nan)
        motor, reducer = np.indices(score.shape)
        return np.asarray(np.floor(score * PARTS + 0.5) * rooms + motor * across + reducer)

    def best(self, rank: Rank, across: int, rooms: int) -> list[tuple[int, int]]:
        """Return motor and reducer of the ranked pairs, from 0, best first."""
        keys = self.keys(rank, across, rooms)
        order = [int(k) for k in np.argsort(keys, axis=None, kind="stable")][: int(np.isfinite(keys).sum())]
        return [divmod(k, keys.shape[1]) for k in order]
