"""A motor at the points of its cycle: torque, speed and power, their means and peaks, and the highest rate by them."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive import Motor
from engine.drive.limits import ReducerLimits
from engine.drive.motor import TorqueFall
from engine.drive.quadrature import LoadPoints
from engine.laws.base import Array

TIED = 1e-9  # share of the largest absolute value by which equal peaks may differ


class Interpolation(NamedTuple):
    """Places between points."""

    point: NDArray[np.intp]  # number of the last point before each place, from 0
    share: Array  # of the step to the next point

    def of(self, values: Array) -> Array:
        """Return a quantity at the places, interpolated linearly between its values at the points."""
        y = values.ravel()
        return np.asarray(y[self.point] + self.share * (y[self.point + 1] - y[self.point]))


def interpolation_at(points: Array, places: Array, near: float) -> Interpolation:
    """Return where places lie between rising points.

    Parameters
    ----------
    points : array (intervals, points)
        Angles of the points, rising from row to row.
    places : array (n,)
        In the unit of the points.
    near : float
        A place so near the next point counts as at that point.

    Returns
    -------
    Interpolation
    """
    x = points.ravel()
    point = np.searchsorted(x, np.minimum(places + near, x[-1] - near), side="right") - 1
    return Interpolation(point, (places - x[point]) / (x[point + 1] - x[point]))


class Peak(NamedTuple):
    """The first of the largest values of a quantity at points."""

    at: int  # number of the point, from 0
    values: tuple[float, float, float]  # at the point before it, there, and at the point after it
    before: float  # distance of the point before it; 0 at an end of an interval
    after: float  # distance of the point after it; likewise
    top: float  # maximum of the parabola through the three values


def peak(values: Array, place: Array) -> Peak:
    """Return the first of the largest values, with the maximum of the parabola through it and its neighbours.

    ``values`` and their abscissae ``place`` have the shape (intervals, 9). At an end of an interval the value itself is
    the maximum; so is the largest value if the parabola's maximum lies beyond the neighbours.
    """
    y, x = values.ravel(), place.ravel()
    limit = y.max() - TIED * np.abs(y).max()
    k = int((y >= limit).argmax())
    low, high = max(k - 1, 0), min(k + 1, y.size - 1)
    three = float(y[low]), float(y[k]), float(y[high])
    if k % values.shape[1] in (0, values.shape[1] - 1):
        return Peak(k, three, 0.0, 0.0, three[1])
    before, after = float(x[k] - x[low]), float(x[high] - x[k])
    rise, fall = (three[1] - three[0]) / before, (three[1] - three[2]) / after
    bend, lean = rise + fall, rise * after - fall * before
    if not (bend > 0.0 and -2.0 * before * bend <= lean <= 2.0 * after * bend):
        return Peak(k, three, before, after, float(y.max()))
    return Peak(k, three, before, after, three[1] + lean**2 / (4.0 * bend * (before + after)))


@dataclass(frozen=True)
class DrivePoints:
    """A motor and a reducer on a load at the points of its cycle: arrays of shape (intervals, 9)."""

    load: LoadPoints

    @property
    def _drive(self) -> tuple[float, float]:
        drive = self.load.train.drive
        return drive.motor_inertia + drive.mechanism.on_shaft(0), self.load.train.gear

    @cached_property
    def torque(self) -> Array:
        """Torque of the motor (Nm); the no-load torque alone where a brake holds."""
        inertia, ratio = self._drive
        found = self.load.at_motor(self.load.output_torque) + inertia * ratio * self.load.shaft_acceleration
        return np.where(self.load.braked, 0.0, found) + self.no_load

    @cached_property
    def standing(self) -> Array:
        """Torque of the motor without inertia and viscous friction (Nm)."""
        return np.where(self.load.braked, 0.0, self.load.at_motor(self.load.output_torque_at_rest)) + self.no_load

    @property
    def brake_torque(self) -> float:
        """The largest torque that a brake holds in dwells, at the motor's shaft (Nm)."""
        return float(np.abs(np.where(self.load.braked, self.load.at_motor(self.load.output_torque), 0.0)).max())

    @property
    def no_load(self) -> Array:
        """No-load torque, with the sign of the motion (Nm)."""
        return self.load.train.drive.no_load * self.load.direction

    @property
    def speed(self) -> Array:
        """Speed of the motor (rad/s)."""
        return self._drive[1] * self.load.speed

    @property
    def power(self) -> Array:
        """Power of the motor (W), with the losses of its winding."""
        return self.torque * (self.speed + self.load.train.drive.copper * self.torque)

    def mean(self, values: Array) -> float:
        """Return the mean of a quantity over the cycle, in its unit."""
        return float((self.load.share * values).sum())

    @property
    def rms_torque(self) -> float:
        """Return √(mean T²) (Nm)."""
        return math.sqrt(self.mean(self.torque**2))

    @property
    def mean_speed(self) -> float:
        """Mean of |ω| over the cycle (rad/s)."""
        return self.mean(np.abs(self.speed))

    def cubic_mean(self, torque: Array) -> float:
        """Return the cubic mean of a torque weighted by speed, ³√(mean |ω||T|³/mean |ω|) (Nm); 0 without motion."""
        weight = np.abs(self.speed)
        mean_speed = self.mean(weight)
        return math.cbrt(self.mean(weight * np.abs(torque) ** 3) / mean_speed) if mean_speed else 0.0

    def top(self, values: Array) -> float:
        """Return the largest value of a quantity over the cycle, by :func:`peak`."""
        return peak(values, self.load.x).top

    def size(self, values: Array) -> float:
        """Return the largest absolute value of a quantity over the cycle."""
        return max(self.top(values), self.top(-values))

    def falling_use(self, peak: float, falling: TorqueFall) -> Array:
        """Return at each point the use 1/r² of a peak torque T (Nm) that falls: |S + r² I| + f r |ω| = T + f ω_1.

        It has two rows, for positive and negative torque, of the first r that reaches the line; 0 if none does. See
        :func:`limit_uses` for S and I.
        """
        way = np.array([1.0, -1.0])[:, None, None]
        left = falling.corner(peak) - way * self.standing
        sink = falling.fall * np.abs(self.speed)
        square = sink**2 + 4.0 * way * (self.torque - self.standing) * left
        return np.where(square < 0.0, 0.0, ((sink + np.sqrt(np.maximum(square, 0.0))) / (2.0 * left)) ** 2)


LEAST_USE = 1e-9  # a smaller use is rounding: the limit is reached beyond 30,000 times the present rate


class LimitUse(NamedTuple):
    """The use of a limit; all but ``use`` in the limit's unit."""

    limit: float  # at speed 0
    standing: float  # figure without inertia and viscous friction
    present: float  # figure at the present rate
    use: float  # the limit is reached at 1/√use times the present rate

    def highest(self, rate: float) -> float:
        """Return the highest rate that the limit allows, for the present one; infinite if there is none."""
        if math.isinf(self.limit):
            return math.inf
        if self.standing >= self.limit:
            return 0.0
        return rate / math.sqrt(self.use) if self.use > LEAST_USE else math.inf


def mean_squares(points: DrivePoints) -> tuple[float, float, float]:
    """Return the means of S², S·I and I² over the points (N²m²); see :func:`limit_uses`."""
    standing, grows = points.standing, points.torque - points.standing
    return points.mean(standing**2), points.mean(standing * grows), points.mean(grows**2)


class ContinuousTorqueLine(NamedTuple):
    """The continuous torque as a straight line over the rate; see :func:`by_rms`."""

    stall: float  # M, at speed 0 (Nm)
    fall: float  # D, from there to the present mean speed (Nm)
    near: float  # e, rate over the present one at which the bound of √x is exact
    half: float  # half of x's coefficient (N²m²)


def continuous_line(points: DrivePoints, motor: Motor) -> ContinuousTorqueLine:
    """Return the line of a motor's continuous torque, constant if the mean speed is beyond the rated one."""
    own, mixed, _ = mean_squares(points)
    now = float(motor.continuous(points.mean_speed))
    stall = motor.stall_torque if now > motor.rated_torque else motor.rated_torque
    if math.isinf(stall):
        return ContinuousTorqueLine(stall, 0.0, 1.0, mixed)
    fall = stall - now
    near = min(1.0, (stall - math.sqrt(own)) / fall) if fall else 1.0
    return ContinuousTorqueLine(stall, fall, near, mixed + (fall * (stall / near - fall) / 2.0 if near > 0.0 else 0.0))


def by_rms(points: DrivePoints, motor: Motor) -> LimitUse:
    """Return the use of the continuous torque (Nm): mean (S + x I)² = (M − D √x)², x the square of the rate's factor.

    √x ≤ (e + x/e)/2 makes this a quadratic in x that is exact at √x = e and on the safe side elsewhere. e is 1, or
    less if S alone reaches the line before.
    """
    own, _, growing = mean_squares(points)
    stall, fall, near, half = continuous_line(points, motor)
    stands, use = math.sqrt(own), 0.0
    if stands < stall < math.inf:
        left = stall * (stall - fall * near) - own
        use = (math.sqrt(half**2 + growing * left) + half) / left
    return LimitUse(stall, stands, points.rms_torque, use)


def _by_peak(points: DrivePoints, torque: Array, standing: Array, limit: float) -> LimitUse:
    """Return the use of a torque limit (Nm), 0 of an infinite one: |I| over the limit less S in the direction of I."""
    grows, use = torque - standing, 0.0
    if not math.isinf(limit):
        use = float(np.maximum(grows / (limit - standing), -grows / (limit + standing)).max())
    return LimitUse(limit, float(np.abs(standing).max()), points.size(torque), use)


def by_cycles(points: DrivePoints, reducer: ReducerLimits, rate: float) -> tuple[float, float, float]:
    """Return three uses of a reducer: of its peak torque reduced by f_s, of ``full_rate``, of both.

    The reduced torque is no limit up to ``full_rate``, so the smaller use counts; that of ``full_rate`` if S alone is
    beyond the reduced torque. The use of an infinite torque is 0.

    Parameters
    ----------
    points : DrivePoints
    reducer : ReducerLimits
    rate : float, 1/s

    Returns
    -------
    tuple of three floats
        As :func:`limit_uses` counts uses.
    """
    load = points.load
    limit = reducer.peak_torque / reducer.cycle_factor
    reduced = _by_peak(points, load.output_torque, load.output_torque_at_rest, limit)
    of_rate = (rate / reducer.full_rate) ** 2
    return reduced.use, of_rate, of_rate if reduced.standing >= reduced.limit else min(of_rate, reduced.use)


def by_mean(points: DrivePoints, limit: float) -> LimitUse:
    """Return the use of the reducer's mean torque (Nm), which is taken to grow linearly with the rate's square."""
    standing = points.cubic_mean(points.load.output_torque_at_rest)
    present = points.cubic_mean(points.load.output_torque)
    use = max(0.0, present - standing) / (limit - standing) if standing < limit < math.inf else 0.0
    return LimitUse(limit, standing, present, use)


def by_speed(speed: float, limit: float) -> LimitUse:
    """Return the use of a speed limit (rad/s)."""
    return LimitUse(limit, 0.0, speed, (speed / limit) ** 2)


def limit_uses(
    points: DrivePoints, speed: float, motor: Motor, reducer: ReducerLimits, falling: TorqueFall, rate: float
) -> dict[str, LimitUse]:
    """Return the use of each limit by its name.

    Torques of inertia grow with the square of the rate. With S, the torque without motion, and I = T − S, a limit is
    reached at 1/√use times the present rate. This is exact for use = 1; elsewhere viscous friction and
    reversals of power make errors of about 1 %. :func:`engine.drive.limits.highest_rate` is exact.

    Parameters
    ----------
    points : DrivePoints
    speed : float, rad/s
        Largest speed of the motor.
    motor : Motor
    reducer : ReducerLimits
    falling : TorqueFall
        By which the motor's peak torque falls above a speed.
    rate : float, 1/s
        The present rate.

    Returns
    -------
    dict of str to LimitUse
    """
    peak, fastest = motor.peak_torque, motor.max_speed
    behind, standing = points.load.output_torque, points.load.output_torque_at_rest
    whole = _by_peak(points, behind, standing, reducer.peak_torque)
    found = {
        "RMS torque": by_rms(points, motor),
        "peak torque": _by_peak(points, points.torque, points.standing, peak),
        "motor speed": by_speed(speed, fastest),
        "reducer input speed": by_speed(speed, reducer.input_speed),
        "reducer peak torque": whole._replace(use=max(whole.use, by_cycles(points, reducer, rate)[2])),
        "reducer mean torque": by_mean(points, reducer.mean_torque),
    }
    if falling.fall:
        use = float(points.falling_use(peak, falling).max())
        found["torque below the curve"] = found["peak torque"]._replace(limit=falling.corner(peak), use=use)
    return found
