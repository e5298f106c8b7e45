"""The matrix of motors by reducers for a cycle: the pairs within limits, and their ranks. SI units.

Torques are those at the points of a cycle (:mod:`engine.selection.point_load`). Source: S5, steps 5 to 7, whose table
of pairs takes the motor as driving all the time.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from engine.drive.limits import cycle_factor_at
from engine.laws.base import Array
from engine.selection.catalogue import Motors, Reducers
from engine.selection.point_load import PairArrays, PointLoad
from engine.selection.task import Task

Rank = Literal["smallest motor", "margin", "inertia match", "mass", "cost"]
RANKS: tuple[str, ...] = get_args(Rank)
MOTOR_LIMITS = ("shaft", "speed", "peak", "RMS", "large", "inertia", "mass")  # "large": beyond the greatest margin
PARTS = 10_000  # of a unit, to which scores are rounded before they are compared


class Requirements(NamedTuple):
    """Requirements of a usable pair: ratios, and a mass in kg."""

    inertia_ratio: float  # largest allowed
    least_margin: float  # continuous torque over RMS torque, at least
    greatest_margin: float  # likewise, at most
    torque_factor: float  # factor on the output torque of a reducer
    least_peak: float = 1.0  # peak torque of a motor over the cycle's, at least
    least_speed: float = 1.0  # largest speed of a motor over the cycle's, at least
    most_mass: float = math.inf  # of motor and reducer together (kg), as far as masses are given


class Pair(NamedTuple):
    """A motor with a reducer."""

    inertia: float  # J of all that turns with the motor (kg m²)
    ratio: float  # i
    efficiency: float  # η
    no_load: float = 0.0  # no-load torque (Nm)

    @property
    def arrays(self) -> PairArrays:
        """The pair as arrays of a single pair."""
        return PairArrays(*np.array(self)[:, None])


@dataclass(eq=False)
class PairMatrix:
    """Every motor of a catalogue (down) behind every reducer (across)."""

    load: PointLoad
    motors: Motors
    reducers: Reducers
    beside: float  # further inertia on the motor's shaft (kg m²)
    wanted: Requirements
    rate: float = 0.0  # cycles per second

    def __post_init__(self) -> None:
        r, rated = self.reducers, self.motors.rated_torque
        # on the motor's shaft with each reducer (kg m²)
        self.beside_motor: Array = r.inertia + self.beside
        # J of each pair (kg m²)
        self.inertias: Array = self.motors.inertia[:, None] + self.beside_motor
        each = np.broadcast_arrays(self.inertias, 1.0 / r.ratio, r.efficiency, r.no_load)
        # of each pair, motor by motor
        self.gears = PairArrays(*(column.ravel() for column in each))
        # largest speed of the motor before each reducer (rad/s)
        self.speed: Array = self.load.speed / r.ratio
        # inertia that each drives (kg m²)
        self.at_motor: Array = self.beside_motor + self.load.inertia * r.ratio**2
        # the same over each motor's
        self.inertia_ratio: Array = self.at_motor / self.motors.inertia[:, None]
        # demand on a reducer (Nm)
        self.output_torque = self.wanted.torque_factor * self.load.torque
        # of each reducer at the rate
        self.cycle_factors = cycle_factor_at(self.rate, r.full_rate, r.cycle_factor)
        # of each reducer at the rate (Nm)
        self.most_output_torque: Array = r.max_output_torque / self.cycle_factors
        torques = self.output_torque / self.most_output_torque, self.load.mean_torque / r.max_mean_torque
        # the most that the load uses of a reducer's limits
        self.reducer_uses: Array = np.maximum(np.maximum(*torques), self.speed / r.max_input_speed)
        # whether a reducer holds the load
        self.fits: NDArray[np.bool_] = self.reducer_uses <= 1.0
        # how many motors are rated less, of each
        self.smaller: NDArray[np.int_] = (rated < rated[:, None]).sum(axis=1)

    def pair(self, motor: int, reducer: int) -> Pair:
        """Return J, i, η and no-load torque of a pair."""
        return Pair(*(float(column.reshape(self.inertias.shape)[motor, reducer]) for column in self.gears))

    def reserve(self, motor: int, reducer: int) -> float:
        """Return the least rest of torque below a pair's curve, over its reserve, at the points (Nm)."""
        most = max(float(self.peak[motor, reducer]), self.falling_demand(motor, reducer))
        return float(self.motors.peak_torque[motor]) / self.wanted.least_peak - most

    def falling_demand(self, motor: int, reducer: int) -> float:
        """Return the largest |T| + f (ω − ω_1) of a pair at the points (Nm), its demand on a curve over its reserve."""
        pair, m = self.pair(motor, reducer), self.motors
        fall = self.motors.fall[motor] / self.wanted.least_peak
        torque, speed = self.load.torques(pair.arrays)[0], pair.ratio * self.load.points.speed
        return float((np.abs(torque) + fall * (speed - m.knee[motor])).max())

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
        """The task of S5 at the reducer's output; a mean beyond ±ω̇_rms T*_rms is rounding, and is set to it."""
        means = self.load.squares
        acceleration, torque = math.sqrt(means.own), math.sqrt(means.load + means.load_back)
        most = acceleration * torque
        return Task(acceleration, torque, max(-most, min(most, means.mixed + means.mixed_back)), self.load.speed)

    def use(self, motor: int, reducer: int) -> tuple[float, float]:
        """Return a pair's speed over the motor's largest, and RMS torque over continuous torque at the mean speed."""
        return float(self.speed[reducer] / self.motors.max_speed[motor]), float(self.uses[motor, reducer])

    @cached_property
    def uses(self) -> Array:
        """The RMS torque of each pair over its motor's continuous torque at the mean speed."""
        return self.rms / self.motors.continuous(np.s_[:, None], self.load.mean_speed / self.reducers.ratio)

    @cached_property
    def limit_uses(self) -> dict[str, Array]:
        """The use of each limit by each pair, 1 at the limit, in the order in which they are looked at."""
        m, wanted = self.motors, self.wanted
        mass = np.nan_to_num(m.size)[:, None] + np.nan_to_num(self.reducers.size)
        return {
            "reducer": np.broadcast_to(self.reducer_uses, self.rms.shape),
            "shaft": m.shaft[:, None] / self.reducers.hub,
            "speed": self.speed * wanted.least_speed / m.max_speed[:, None],
            "peak": self.peak * wanted.least_peak / m.peak_torque[:, None],
            "RMS": self.uses * wanted.least_margin,
            "large": self.uses,  # of the continuous torque
            "inertia": self.inertia_ratio / wanted.inertia_ratio,
            "mass": mass / wanted.most_mass,
        }

    @cached_property
    def failures(self) -> dict[str, NDArray[np.bool_]]:
        """Whether each pair fails each limit, in the order in which they are looked at."""
        r, wanted = self.reducers, self.wanted
        fails = {word: use > 1.0 for word, use in self.limit_uses.items()}
        large = self.uses * wanted.greatest_margin < 1.0
        heavy = np.nan_to_num(self.motors.size)[:, None] > wanted.most_mass - np.nan_to_num(r.size)
        return fails | {"large": large, "mass": heavy}

    @cached_property
    def verdicts(self) -> NDArray[np.str_]:
        """The first limit that each pair fails, or "yes"."""
        return np.select(list(self.failures.values()), list(self.failures), "yes")

    @cached_property
    def wanted_verdicts(self) -> NDArray[np.str_]:
        """The first of margins, inertia ratio and mass that each pair fails, or "yes"."""
        words = ["RMS", "large", "inertia", "mass"]
        return np.select([self.failures[word] for word in words], words, "yes")

    @cached_property
    def failing_uses(self) -> Array:
        """The use of the limit that each pair fails first; 0 of usable pairs, and of those whose reducer fails."""
        uses = [self.limit_uses[word] for word in MOTOR_LIMITS]
        return np.select([self.verdicts == word for word in MOTOR_LIMITS], uses, 0.0)

    @cached_property
    def balance(self) -> Array:
        """The inertia J on the motor's shaft (kg m²) at which J α_rms/τ = τ S_rms/η. Source: S5, (14)."""
        r, means = self.reducers, self.load.squares
        if not means.own:
            return np.zeros(r.ratio.shape)
        share = math.sqrt((means.load + means.load_back) / means.own)
        return np.asarray(r.ratio**2 / r.efficiency * share)

    def scores(self, rank: Rank) -> Array:
        """Return the scores of pairs, lowest first, of equal motors that of the less used; NaN without a figure."""
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

    def rounded(self, rank: Rank) -> Array:
        """Return the scores of usable pairs as whole numbers of 1/:data:`PARTS`; NaN of others."""
        return np.floor(np.where(self.verdicts == "yes", self.scores(rank), np.nan) * PARTS + 0.5)

    def best(self, rank: Rank) -> list[tuple[int, int]]:
        """Return the numbers of motor and reducer of the ranked pairs, from 0, best first, of equal ones the first."""
        scores = self.rounded(rank)
        order = np.argsort(scores, axis=None, kind="stable")[: int(np.isfinite(scores).sum())]
        return [divmod(k, scores.shape[1]) for k in order.tolist()]
