"""Motors by reducers for a course: which pairs can do it within limits, and which of them suit it best. SI units.

Torques are exact for every pair (:class:`engine.machine.geared.Geared`); S5's steps 5 to 7, whose table of pairs this
is, take the motor as driving all the time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from engine.choice.catalogue import Motors, Reducers
from engine.choice.task import Task
from engine.drivetrain import Motor
from engine.laws.base import Array
from engine.machine.geared import Geared, Gears

Rank = Literal["smallest motor", "margin", "inertia match", "mass", "cost"]
RANKS: tuple[str, ...] = get_args(Rank)
Verdict = Literal["yes", "reducer", "speed", "peak", "RMS", "large", "inertia", "–"]
PARTS = 10_000
"""of a unit, in which scores are compared"""


class Wanted(NamedTuple):
    """What a usable pair holds: the largest inertia at the motor over the motor's, the least and the greatest rated
    torque over RMS torque; and the factor on the torque that a reducer must hold."""

    inertia_ratio: float
    least_margin: float
    greatest_margin: float
    torque_factor: float


class Points(NamedTuple):
    """Both ends of the parts of a cycle, arrays of one length, at the shaft behind the reducer.

    α (rad/s²), S (Nm) where it drives the load and where the load drives it (0 elsewhere), and the largest speed
    (rad/s) of the part.
    """

    acceleration: Array
    driving: Array
    driven: Array
    speed: Array


def points(acceleration: Array, torque: Array, going: Array, speed: Array) -> Points:
    """Return them of torques in directions of motion, 1, −1 or 0: at rest a torque counts as driving."""
    back = torque * going < 0.0
    return Points(acceleration, np.where(back, 0.0, torque), np.where(back, torque, 0.0), speed)


class Curve(NamedTuple):
    """Peak torque (Nm), the speed (rad/s) up to which it holds, and its fall beyond (Nm s)."""

    peak: float
    knee: float
    fall: float


def reserve(points: Points, gears: tuple[float, float, float], curve: Curve) -> float:
    """Return what is left below a motor's curve at least (Nm), for J, i, η.

    The torque of each part at its ends with the part's largest speed: never more than what is left; just that where
    the speed stays below the knee, or both are largest at one end.
    """
    inertia, ratio, eta = gears
    turned = inertia * ratio * points.acceleration
    torque = np.abs(turned + points.driving / (eta * ratio) + points.driven * eta / ratio)
    beyond = curve.peak + curve.fall * curve.knee - float((torque + curve.fall * ratio * points.speed).max())
    return min(curve.peak - float(torque.max()), beyond)


class Used(NamedTuple):
    """Speed over the motor's largest, RMS torque over its rated torque."""

    speed: float
    torque: float


def used(motor: Motor, speed: float, rms: float) -> Used:
    """Return what a speed (rad/s) and an RMS torque (Nm) use of a motor."""
    return Used(speed / motor.max_speed, rms / motor.rated_torque)


@dataclass(frozen=True)
class Grid:
    """Every motor of a catalogue (down) behind every reducer (across); ``beside`` turns with the motor (kg m²)."""

    geared: Geared
    motors: Motors
    reducers: Reducers
    beside: float
    wanted: Wanted

    @cached_property
    def gears(self) -> Gears:
        """J, i and η of each pair."""
        r = self.reducers
        inertia = self.motors.inertia[:, None] + r.inertia + self.beside
        return Gears(*(np.array(one) for one in np.broadcast_arrays(inertia, 1.0 / r.ratio, r.efficiency)))

    @cached_property
    def rms(self) -> Array:
        """RMS torque of each motor (Nm)."""
        return self.geared.rms_torque(self.gears)

    @cached_property
    def peak(self) -> Array:
        """Largest torque of each motor (Nm)."""
        return self.geared.torques(self.gears).peak

    @cached_property
    def speed(self) -> Array:
        """Largest speed of the motor before each reducer (rad/s)."""
        return self.geared.speed(1.0 / self.reducers.ratio)

    @cached_property
    def at_motor(self) -> Array:
        """Inertia at the motor without it (kg m²), of each reducer."""
        return self.beside_motor + self.geared.inertia(1.0 / self.reducers.ratio)

    @cached_property
    def inertia_ratio(self) -> Array:
        """The same over each motor's."""
        return self.at_motor / self.motors.inertia[:, None]

    @property
    def beside_motor(self) -> Array:
        """What turns with a motor before each reducer (kg m²)."""
        return self.reducers.inertia + self.beside

    @property
    def task(self) -> Task:
        """What the course asks for behind the reducer, as S5 tells it."""
        own, mixed, square = self.geared.squares
        fastest = self.geared.demand.speed.peak
        return Task.of_figures(math.sqrt(own), math.sqrt(sum(square)), sum(mixed), fastest)

    @property
    def load_factor(self) -> float:
        """β in W/s. Source: S5, eq. (15)."""
        task = self.task
        return 2.0 * (task.acceleration_rms * task.torque_rms + task.power_rate_mean)

    @cached_property
    def behind(self) -> float:
        """The torque that a reducer must hold (Nm)."""
        return self.wanted.torque_factor * self.geared.demand.shaft_torque(1).peak

    @cached_property
    def fits(self) -> NDArray[np.bool_]:
        """Whether each reducer holds torque and speed."""
        return (self.behind <= self.reducers.max_output_torque) & (self.speed <= self.reducers.max_input_speed)

    def use(self, motor: int, reducer: int) -> Used:
        """Return what a pair uses of its motor."""
        m = self.motors
        speed, torque = self.speed[reducer] / m.max_speed[motor], self.rms[motor, reducer] / m.rated_torque[motor]
        return Used(float(speed), float(torque))

    @cached_property
    def verdicts(self) -> NDArray[np.str_]:
        """What each pair fails first, or that it is usable."""
        m, share = self.motors, self.motors.rated_torque[:, None]
        fails = (
            (np.broadcast_to(~self.fits, self.rms.shape), "reducer"),
            (self.speed > m.max_speed[:, None], "speed"),
            (self.peak > m.peak_torque[:, None], "peak"),
            (self.rms * self.wanted.least_margin > share, "RMS"),
            (self.rms * self.wanted.greatest_margin < share, "large"),
            (self.inertia_ratio > self.wanted.inertia_ratio, "inertia"),
        )
        return np.select([one for one, _ in fails], [word for _, word in fails], "yes")

    @cached_property
    def balance(self) -> Array:
        """The inertia with the motor (kg m²) that each reducer balances: J α_rms/τ = τ S_rms/η. Source: S5, (14)."""
        own, _, behind = self.geared.squares
        r = self.reducers
        return np.asarray(r.ratio**2 / r.efficiency * np.sqrt(sum(behind) / own) if own else np.zeros(r.ratio.shape))

    def scores(self, rank: Rank) -> Array:
        """Return what pairs are ranked by, the lowest first; NaN of one without the figure.

        Of the smallest motor: how many have a smaller rated torque, and as a fraction, who has less to do.
        """
        rated = self.motors.rated_torque
        share = self.rms / rated[:, None]
        if rank == "smallest motor":
            return self.smaller[:, None] + share / (1.0 + share)
        if rank == "margin":
            return np.asarray(share)
        if rank == "inertia match":
            x = np.broadcast_to(self.balance, share.shape) / self.gears.inertia
            return np.exp(np.abs(np.log(x, out=np.zeros(x.shape), where=x > 0.0)) / 2.0)
        name = "size" if rank == "mass" else "cost"
        return np.asarray(getattr(self.motors, name)[:, None] + getattr(self.reducers, name))

    @cached_property
    def smaller(self) -> NDArray[np.int_]:
        """How many motors have a smaller rated torque, of each."""
        rated = self.motors.rated_torque
        return np.asarray((rated < rated[:, None]).sum(axis=1))

    def keys(self, rank: Rank, across: int, rooms: int) -> Array:
        """Return whole numbers that rise as pairs rank, NaN of those that do not: equals in the order of the table.

        Of a table of ``rooms`` pairs, ``across`` of them in a row.
        """
        score = np.where(self.verdicts == "yes", self.scores(rank), np.nan)
        motor, reducer = np.indices(score.shape)
        return np.asarray(np.floor(score * PARTS + 0.5) * rooms + motor * across + reducer)

    def best(self, rank: Rank, across: int, rooms: int) -> list[tuple[int, int]]:
        """Return motor and reducer of the ranked pairs, from 0, best first."""
        keys = self.keys(rank, across, rooms)
        order = [int(k) for k in np.argsort(keys, axis=None, kind="stable")][: int(np.isfinite(keys).sum())]
        return [divmod(k, keys.shape[1]) for k in order]
