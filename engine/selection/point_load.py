"""The load at a reducer's output, at the points of a cycle, and the torques of many motors and reducers. SI units.

T = J i α + f S/i + T_nl d, with J of all that turns with the motor, α and S the acceleration and torque at the output,
f = 1/η where the motor drives, else η, and d the direction of rotation. Mean squares of T are sums of means of products
of α, S and d; peaks are those of the points.
Source: S5, 'Model of dynamic system', squared; its step 7 for η and J_T.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.drive_points import TIED
from engine.drive.quadrature import LoadPoints
from engine.drive.results import Energy
from engine.laws.base import Array

AT_ONCE = 1 << 18  # values of an array, at most


class PairArrays(NamedTuple):
    """Motors with their reducers, arrays of shape (pairs,)."""

    inertia: Array  # J of all that turns with the motor (kg m²)
    ratio: Array  # i
    efficiency: Array  # η
    no_load: Array  # no-load torque at the motor's shaft (Nm)

    def parts(self, width: int) -> Iterator[tuple[slice, "PairArrays"]]:
        """Yield slices and the pairs in them, so few that :data:`AT_ONCE` values hold ``width`` for each pair."""
        step = max(1, AT_ONCE // width)
        for some in (slice(begin, begin + step) for begin in range(0, len(self.inertia), step)):
            yield some, PairArrays(*(values[some] for values in self))


class ShaftPoints(NamedTuple):
    """The reducer's output at the points of a cycle, arrays of equal length."""

    acceleration: Array  # α (rad/s²)
    driving: Array  # S (Nm) where the motor drives, else 0
    driven: Array  # S (Nm) where the load drives, else 0
    speed: Array  # |ω| (rad/s)
    direction: Array  # d, of rotation: 1, −1, or 0 at rest


class MeanSquares(NamedTuple):
    """Means ⟨ ⟩ over the cycle, in rad/s² and Nm; with S where the motor drives, and ``back`` where the load does."""

    own: float  # ⟨α²⟩
    mixed: float  # ⟨α S⟩
    mixed_back: float
    load: float  # ⟨S²⟩
    load_back: float
    direction: float  # ⟨d²⟩
    direction_acceleration: float  # ⟨α d⟩
    direction_load: float  # ⟨S d⟩
    direction_load_back: float


@dataclass(eq=False)
class PointLoad:
    """The load at a reducer's output over a cycle."""

    load: LoadPoints
    speed: float  # largest at the output (rad/s)
    torque: float  # largest at the output (Nm)
    inertia: float  # of the load at the output (kg m²)

    def __post_init__(self) -> None:
        load = self.load
        # a brake holds it back from the motor
        torque = np.where(load.braked, 0.0, load.output_torque)
        # the load drives
        back = (torque * load.direction < 0.0) & (load.train.method == "physical")
        driving, driven = np.where(back, 0.0, torque), np.where(back, torque, 0.0)
        self.turning = load.output_ratio * load.speed  # of the output (rad/s)
        each = load.output_ratio * load.shaft_acceleration, driving, driven, np.abs(self.turning), load.direction
        self.points = ShaftPoints(*(values.ravel() for values in each))
        weight = load.share * np.abs(self.turning)
        cubes = weight * np.abs(load.output_torque) ** 3
        # cubic mean torque ³√(mean |ω||S|³/mean |ω|) (Nm), by which reducers are rated; 0 without motion
        self.mean_torque = math.cbrt(float(cubes.sum() / weight.sum())) if weight.any() else 0.0
        self.mean_speed = float(weight.sum())  # of |ω| (rad/s)
        alpha, ahead, behind, _, way = self.points
        means = [alpha**2, alpha * ahead, alpha * behind, ahead**2, behind**2]
        means += [way**2, alpha * way, ahead * way, behind * way]
        # over the cycle
        self.squares = MeanSquares(*(float(load.share.ravel() @ values) for values in means))

    def rms(self, pairs: PairArrays) -> Array:
        """Return the RMS torque of motors (Nm)."""
        own = (pairs.inertia * pairs.ratio) ** 2 * self.squares.own
        square = own + 2.0 * pairs.inertia * self.mixed(pairs) + self.square(pairs)
        return np.sqrt(np.maximum(square, 0.0))

    def mixed(self, pairs: PairArrays) -> Array:
        """Return i ⟨α T'⟩ (Nm/s²), T' the torque of motors without that for the inertia J."""
        means, eta = self.squares, pairs.efficiency
        own = pairs.ratio * pairs.no_load * means.direction_acceleration
        return np.asarray(means.mixed / eta + means.mixed_back * eta + own)

    def square(self, pairs: PairArrays) -> Array:
        """Return ⟨T'²⟩ (N²m²), T' as in :meth:`mixed`."""
        means, eta, own = self.squares, pairs.efficiency, pairs.no_load
        load = (means.load / eta**2 + means.load_back * eta**2) / pairs.ratio**2
        crossed = 2.0 * own * (means.direction_load / eta + means.direction_load_back * eta) / pairs.ratio
        return np.asarray(load + crossed + own**2 * means.direction)

    def torques(self, pairs: PairArrays) -> Array:
        """Return the torque of motors at the points (Nm): shape (pairs, points)."""
        at = self.points
        accelerating = (pairs.inertia * pairs.ratio)[:, None] * at.acceleration
        driving = at.driving / (pairs.efficiency * pairs.ratio)[:, None]
        driven = at.driven * (pairs.efficiency / pairs.ratio)[:, None]
        return np.asarray(accelerating + driving + driven + pairs.no_load[:, None] * at.direction)

    def peak(self, pairs: PairArrays) -> Array:
        """Return the largest |torque| of motors at the points (Nm)."""
        parts = pairs.parts(self.points.speed.size)
        return np.concatenate([np.abs(self.torques(part)).max(axis=1) for _, part in parts])


def shares_of(limit: Array, value: Array) -> Array:
    """Return the limit over the quantity; 0 if the quantity is 0."""
    return np.divide(limit, value, out=np.zeros(np.broadcast(limit, value).shape), where=value != 0.0)


class MotorLimits(NamedTuple):
    """Limits and losses of motors, arrays of shape (pairs,)."""

    peak: Array  # peak torque (Nm), up to the knee
    knee: Array  # rad/s
    fall: Array  # decrease of the peak torque beyond the knee (Nm s)
    copper: Array  # copper losses over the square of the torque (W/(Nm)²)


class Extremes(NamedTuple):
    """Extremes of motors over the cycle, arrays of shape (pairs,)."""

    torque_low: Array  # Nm
    torque: Array  # highest (Nm)
    power_low: Array  # W
    power: Array  # highest (W)
    spare: Array  # least reserve below the peak torque's curve (Nm)

    @property
    def peak(self) -> Array:
        """The largest |torque| (Nm)."""
        return np.maximum(self.torque, -self.torque_low)


@dataclass(frozen=True)
class DriveBatch:
    """Many motors with their reducers on the same load."""

    load: PointLoad
    gears: PairArrays
    limits: MotorLimits

    def _parts(self) -> Iterator[tuple[slice, Array, Array, Array]]:
        """Yield slices of the pairs with torques (Nm), speeds (rad/s) and powers (W): shape (pairs, points)."""
        speed = self.load.turning.ravel()
        for some, pairs in self.gears.parts(speed.size):
            torque, fast = self.load.torques(pairs), pairs.ratio[:, None] * speed
            yield some, torque, fast, torque * (fast + self.limits.copper[some, None] * torque)

    @cached_property
    def extremes(self) -> Extremes:
        """Extremes over the cycle."""
        place, extremes = self.load.load.x, []
        for some, torque, speed, power in self._parts():
            peak, knee, fall, _ = (values[some, None] for values in self.limits)
            left = peak - fall * np.maximum(0.0, np.abs(speed) - knee) - np.abs(torque)
            each = (-tops(-torque, place), tops(torque, place), -tops(-power, place), tops(power, place))
            extremes.append((*each, left.min(axis=1)))
        return Extremes(*(np.concatenate(values) for values in zip(*extremes, strict=True)))

    def works(self, time: float) -> Energy:
        """Return the energy of each motor over a cycle of a time (s)."""
        share = self.load.load.share.ravel() * time
        each = [[np.maximum(way * power, 0.0) @ share for way in (1.0, -1.0)] for *_, power in self._parts()]
        return Energy(*(np.concatenate(values) for values in zip(*each, strict=True)))


def tops(values: Array, place: Array) -> Array:
    """Return each row's largest value, as :func:`engine.drive.drive_points.peak` for abscissae ``place`` of (n, 9)."""
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
