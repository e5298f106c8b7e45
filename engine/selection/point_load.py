"""What a drive asks for behind its reducer, whatever that and the motor are: at the points of its cycle. SI units.

With J all that turns with the motor, T = J i α + f S/i + T_nl d: f = 1/η where S drives the load, η where the load
drives it, d the direction of rotation. Squares of T are sums of means of α, S and d; peaks are those of the points.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.chain import gives_back
from engine.drive.drive_points import TIED
from engine.drive.quadrature import LoadPoints
from engine.drive.results import Energy
from engine.laws.base import Array

AT_ONCE = 1 << 18  # values of which arrays are made


class PairArrays(NamedTuple):
    """Motors with their reducers, arrays of one length: J (kg m²) on the motor's shaft, i, η, no-load torque (Nm)."""

    inertia: Array
    ratio: Array
    efficiency: Array
    no_load: Array

    def parts(self, width: int) -> Iterator[tuple[slice, "PairArrays"]]:
        """Yield some at a time, and which: with no more than :data:`AT_ONCE` values, ``width`` for each."""
        step = max(1, AT_ONCE // width)
        for some in (slice(begin, begin + step) for begin in range(0, len(self.inertia), step)):
            yield some, PairArrays(*(values[some] for values in self))


class ShaftPoints(NamedTuple):
    """Points of a cycle, arrays of one length, at the shaft behind the reducer."""

    acceleration: Array  # α (rad/s²)
    driving: Array  # S (Nm) where it drives the load, 0 elsewhere
    driven: Array  # and where the load drives it
    speed: Array  # rad/s
    direction: Array  # d, of rotation: 1, −1 or 0 at rest


class MeanSquares(NamedTuple):
    """⟨α²⟩; ⟨α S⟩ and ⟨S²⟩ where S drives the load, and where the load drives it; ⟨d²⟩, ⟨α d⟩ and ⟨S d⟩ both ways."""

    own: float
    mixed: float
    mixed_back: float
    load: float
    load_back: float
    direction: float
    direction_acceleration: float
    direction_load: float
    direction_load_back: float


@dataclass(eq=False)
class PointLoad:
    """A load at its points; its largest speed (rad/s) and torque (Nm) at the shaft, and its inertia there (kg m²)."""

    load: LoadPoints
    speed: float
    torque: float
    inertia: float

    def __post_init__(self) -> None:
        load = self.load
        torque = np.where(load.braked, 0.0, load.output_torque)  # of a brake that holds the motor none reaches it
        back = gives_back(torque, load.direction, 0.0) & (load.train.drive.method == "physical")
        driving, driven = np.where(back, 0.0, torque), np.where(back, torque, 0.0)
        each = load.shaft_acceleration, driving, driven, np.abs(load.speed), load.direction
        self.points = ShaftPoints(*(one.ravel() for one in each))
        weight = load.share * np.abs(load.speed)
        cubes = weight * np.abs(load.output_torque) ** 3
        # the mean torque of the shaft, ³√(mean |ω||S|³/mean |ω|) (Nm), by which gears are rated; 0 where it stands
        self.mean_torque = math.cbrt(float(cubes.sum() / weight.sum())) if weight.any() else 0.0
        self.mean_speed = float(weight.sum())  # of |ω| (rad/s)
        alpha, ahead, behind, _, way = self.points
        means = [alpha**2, alpha * ahead, alpha * behind, ahead**2, behind**2]
        means += [way**2, alpha * way, ahead * way, behind * way]
        self.squares = MeanSquares(*(float(load.share.ravel() @ one) for one in means))  # over the cycle

    def rms(self, some: PairArrays) -> Array:
        """Return the RMS torque of motors (Nm)."""
        turned = some.inertia * some.ratio
        square = turned**2 * self.squares.own + 2.0 * some.inertia * self.mixed(some) + self.square(some)
        return np.sqrt(np.maximum(square, 0.0))

    def mixed(self, some: PairArrays) -> Array:
        """Return i ⟨α T'⟩ (W/s), T' the torque of motors without what their inertia asks for."""
        means, eta = self.squares, some.efficiency
        own = some.ratio * some.no_load * means.direction_acceleration
        return np.asarray(means.mixed / eta + means.mixed_back * eta + own)

    def square(self, some: PairArrays) -> Array:
        """Return ⟨T'²⟩ (N²m²)."""
        means, eta, own = self.squares, some.efficiency, some.no_load
        load = (means.load / eta**2 + means.load_back * eta**2) / some.ratio**2
        crossed = 2.0 * own * (means.direction_load / eta + means.direction_load_back * eta) / some.ratio
        return np.asarray(load + crossed + own**2 * means.direction)

    def torques(self, some: PairArrays) -> Array:
        """Return the torque of motors at the points (Nm): motors down, points across."""
        at = self.points
        turned = (some.inertia * some.ratio)[:, None] * at.acceleration
        driving = at.driving / (some.efficiency * some.ratio)[:, None]
        driven = at.driven * (some.efficiency / some.ratio)[:, None]
        return np.asarray(turned + driving + driven + some.no_load[:, None] * at.direction)

    def peak(self, some: PairArrays) -> Array:
        """Return the largest torque of motors at the points (Nm)."""
        parts = some.parts(self.points.speed.size)
        return np.concatenate([np.abs(self.torques(one)).max(axis=1) for _, one in parts])


def shares_of(limit: Array, value: Array) -> Array:
    """Return the limit over the quantity; 0 where nothing is asked for."""
    return np.divide(limit, value, out=np.zeros(np.broadcast(limit, value).shape), where=value != 0.0)


class MotorLimits(NamedTuple):
    """Peak torque of each motor (Nm), up to which speed (rad/s), its fall beyond (Nm s), copper losses (W/(Nm)²)."""

    peak: Array
    knee: Array
    fall: Array
    copper: Array


class Extremes(NamedTuple):
    """Lowest and highest torque (Nm) and power (W) of each motor, and what is left below its curve (Nm)."""

    torque_low: Array
    torque: Array
    power_low: Array
    power: Array
    spare: Array

    @property
    def peak(self) -> Array:
        """The largest size of the torque (Nm)."""
        return np.maximum(self.torque, -self.torque_low)


@dataclass(frozen=True)
class DriveBatch:
    """Motors with their reducers on a load; ``limits`` are the motors'."""

    load: PointLoad
    gears: PairArrays
    limits: MotorLimits

    def _parts(self) -> Iterator[tuple[slice, Array, Array, Array]]:
        """Yield some at a time, with their torques (Nm), speeds (rad/s) and powers (W): motors down, points across."""
        speed = self.load.load.speed.ravel()
        for some, one in self.gears.parts(speed.size):
            torque, fast = self.load.torques(one), one.ratio[:, None] * speed
            yield some, torque, fast, torque * (fast + self.limits.copper[some, None] * torque)

    @cached_property
    def extremes(self) -> Extremes:
        """Peaks over the cycle."""
        place, found = self.load.load.x, []
        for some, torque, speed, power in self._parts():
            peak, knee, fall, _ = (values[some, None] for values in self.limits)
            left = peak - fall * np.maximum(0.0, np.abs(speed) - knee) - np.abs(torque)
            each = (-tops(-torque, place), tops(torque, place), -tops(-power, place), tops(power, place))
            found.append((*each, left.min(axis=1)))
        return Extremes(*(np.concatenate(values) for values in zip(*found, strict=True)))

    def works(self, time: float) -> Energy:
        """Return the work of each over a cycle of so long (s)."""
        share = self.load.load.share.ravel() * time
        each = [[np.maximum(way * power, 0.0) @ share for way in (1.0, -1.0)] for *_, power in self._parts()]
        return Energy(*(np.concatenate(values) for values in zip(*each, strict=True)))


def tops(values: Array, place: Array) -> Array:
    """Return each row's largest value, as :func:`engine.drive.drive_points.peak`; ``place`` is intervals by points."""
    rows, width, x = np.arange(len(values)), place.shape[1], place.ravel()
    limit = values.max(axis=1) - TIED * np.abs(values).max(axis=1)
    k: NDArray[np.intp] = (values >= limit[:, None]).argmax(axis=1)
    inner = (k % width != 0) & (k % width != width - 1)
    middle = np.where(inner, k, 1)
    y = [values[rows, middle + side] for side in (-1, 0, 1)]
    before, after = x[middle] - x[middle - 1], x[middle + 1] - x[middle]
    rise, fall = (y[1] - y[0]) / before, (y[1] - y[2]) / after
    bend = inner & (rise + fall != 0.0)
    over = np.where(bend, 4.0 * (rise + fall) * (before + after), 1.0)
    lean = (rise * after - fall * before) ** 2 / over
    return np.asarray(values[rows, k] + np.where(bend, lean, 0.0))
