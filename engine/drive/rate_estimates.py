"""The estimate of the rates at which a drive holds its limits: T_s at standstill, and what grows with the square x."""

import math
from typing import NamedTuple

import numpy as np

from engine.drive.drive_points import DrivePoints
from engine.drive.limits import BELOW, CYCLES, PEAK_TORQUE, REDUCER_TORQUE, ReducerLimits
from engine.drive.motor import Motor
from engine.laws.base import Array

LEAST_GROWTH = 1e-3  # share of a limit's use by which it must grow from standstill on to tell a power of the rate
# a smaller growth is rounding: the limit is reached beyond 1,000 times the present rate
LEAST_USE = 1e-6
NEVER = 1.0 / LEAST_USE  # of shares, and of squares of a rate's factor: as good as infinite
TINY = 1e-30  # more than 0, so that a quotient has a value
NO_LIMIT = 1.0 / TINY  # stands for an infinite rate
SPEEDS = ("motor speed", "reducer input speed")
# use of a limit at the ends of the range; where peaks lie between points
TARGET, TARGET_BETWEEN = 0.999, 0.997
TARGET_CURVE = 0.992  # of a peak torque that falls with speed
HAIR = 1e-6  # by which the range ends before the rate at which a speed is at its limit
# by which the rate that is tried is beyond the estimate: of it, and of the way to it
BEYOND, ASTRAY = 0.02, 0.1


class Ends(NamedTuple):
    """The rates (1/s) from and up to which a limit is held; infinite if there is no upper rate."""

    low: float
    high: float


class RateRange(NamedTuple):
    """The rates (1/s) between which all limits are held, 0 and 0 if none is, and the limits at either end."""

    low: float
    high: float  # infinite if there is no limit
    low_limit: str  # empty at standstill
    high_limit: str

    def times(self, factor: float) -> "RateRange":
        """Return the range in another unit."""
        return self._replace(low=self.low * factor, high=self.high * factor)


class Estimate(NamedTuple):
    """The estimate of a limit over x, the square of a rate's factor; limit and standing figure in the limit's unit."""

    limit: float  # at speed 0
    standing: float  # figure without inertia and viscous friction
    forward: float  # 1/x up to which it is held, of torques forward; 0 of any
    backward: float = 0.0  # likewise of torques backward
    from_forward: float = 0.0  # x from which it is held, of torques forward
    from_backward: float = 0.0  # likewise

    def most(self, power: float) -> float:
        """Return the factor of the rate up to which it is held, growing with that power; infinite if none is met."""
        share = max(self.forward, self.backward)
        return (1.0 / math.sqrt(share)) ** (2.0 / power) if share > LEAST_USE else math.inf

    @property
    def least(self) -> float:
        """The factor of the rate from which it is held; infinite if none holds it."""
        least = max(self.from_forward, self.from_backward)
        return math.sqrt(least) if least < NEVER else math.inf


def by_points(torque: Array, standing: Array, limit: float) -> Estimate:
    """Return the estimate of a limit of torque (Nm) at every point."""
    grows, most = torque - standing, min(limit, NO_LIMIT)
    rises, falls = grows > LEAST_USE * most, -grows > LEAST_USE * most
    return Estimate(
        limit,
        float(np.abs(standing).max()),
        clipped(float((rises * grows / (np.maximum(0.0, most - standing) + TINY)).max())),
        clipped(float((falls * -grows / (np.maximum(0.0, most + standing) + TINY)).max())),
        clipped(float(((standing - most) / (falls * -grows + TINY)).max())),
        clipped(float(((-standing - most) / (rises * grows + TINY)).max())),
    )


def clipped(x: float) -> float:
    """Return x within 0 and :data:`NEVER`."""
    return min(NEVER, max(0.0, x))


def mean_squares(points: DrivePoints) -> tuple[float, float, float]:
    """Return the means of S², S·I and I² over the points (N²m²)."""
    standing, grows = points.standing, points.torque - points.standing
    return points.mean(standing**2), points.mean(standing * grows), points.mean(grows**2)


def growth_power(points: DrivePoints) -> float:
    """Return the power of the rate with which torques grow: 2 as of inertia, down to 1 as of viscous friction.

    It is 2 − w, where w is the mean square of the torque of viscous friction, c v²/ω, over that of all that grows.
    """
    (velocity, _), speed = points.load.moving, points.speed
    viscous = points.load.train.viscous * velocity**2 / (speed + TINY)
    return 2.0 - min(1.0, points.mean(viscous**2) / (mean_squares(points)[2] + TINY))


def use_below(rest: float, now: float, then: float) -> float:
    """Return the use of a limit at standstill, 0 unless it is less than at two rates by :data:`LEAST_GROWTH` of it.

    Parameters
    ----------
    rest, now, then : float
        Use of the limit, as a share of it: at standstill, at the present rate, at another rate.

    Returns
    -------
    float
    """
    return rest if rest < min(now, then) * (1.0 - LEAST_GROWTH) else 0.0


def power_through(base: float, now: float, then: float, factor: float) -> float:
    """Return the power of the rate that three uses of a limit tell; 1 where none does.

    They are at standstill as :func:`use_below` counts it, at the present rate, and at ``factor`` times this.
    """
    if min(now, then) <= base:
        return 1.0
    return math.log((then - base) / (now - base)) / (math.log(factor) + TINY)


class SquareLine(NamedTuple):
    """A mean torque over x, its square taken for S² + 2 h x + G x²: at its limit at x = L/(√(h² + G L) + h)."""

    limit: float  # M, at speed 0 (Nm)
    standing: float  # S, without inertia and viscous friction (Nm)
    growing: float  # G (N²m²)
    half: float  # h (N²m²)
    left: float  # L, what S leaves, M² − S² of a limit that does not fall (N²m²); infinite without a limit
    square: float  # h² + G L (N⁴m⁴)

    @property
    def estimate(self) -> Estimate:
        """From where on and up to where it is within its limit."""
        limit, standing, growing, half, left, square = self
        root = math.sqrt(max(0.0, square))
        if math.isinf(limit):
            return Estimate(limit, standing, 0.0)
        if left > 0.0:
            return Estimate(limit, standing, (root + half) / left)
        if half >= 0.0 or square < 0.0:
            return Estimate(limit, standing, 0.0, from_forward=NEVER)
        return Estimate(limit, standing, growing / (root - half), from_forward=clipped(-left / (root - half)))


def continuous_line(points: DrivePoints, motor: Motor) -> tuple[SquareLine, float, float]:
    """Return the line of the RMS torque up to the continuous torque, D (Nm), and e.

    The continuous torque falls by D from speed 0 to the present mean speed, not at all if this is beyond the rated:
    mean (S + x I)² = (M − D √x)² with √x ≤ (e + x/e)/2, exact at the rate e over the present rate, is quadratic in x.
    """
    own, mixed, growing = mean_squares(points)
    now = float(motor.continuous(points.mean_speed))
    stall = motor.stall_torque if now > motor.rated_torque else motor.rated_torque
    if math.isinf(stall):
        return SquareLine(stall, math.sqrt(own), growing, mixed, math.inf, math.inf), 0.0, 1.0
    fall = stall - now
    near = min(1.0, (stall - math.sqrt(own)) / fall) if fall > 0.0 and stall > math.sqrt(own) else 1.0
    half, left = mixed + fall * (stall / near - fall) / 2.0, stall * (stall - fall * near) - own
    return SquareLine(stall, math.sqrt(own), growing, half, left, half**2 + growing * left), fall, near


def mean_torque_line(points: DrivePoints, limit: float) -> SquareLine:
    """Return the line of the reducer's mean torque up to a limit (Nm), as if it were a mean square."""
    stands, now = points.load.output_torque_at_rest, points.load.output_torque
    standing, present, growing = (points.cubic_mean(torque) for torque in (stands, now, now - stands))
    half, left = (present**2 - standing**2 - growing**2) / 2.0, limit**2 - standing**2
    square = half**2 + growing**2 * left if growing else half**2
    return SquareLine(limit, standing, growing**2, half, left, square)


def by_speed(speed: float, limit: float) -> Estimate:
    """Return the estimate of a speed limit (rad/s), which is exact."""
    return Estimate(limit, 0.0, (speed / limit) ** 2)


def estimates_of(points: DrivePoints, speed: float, motor: Motor, reducer: ReducerLimits) -> dict[str, Estimate]:
    """Return the estimate of each limit of a motor and a reducer by its name.

    Parameters
    ----------
    points : DrivePoints
        At the present rate.
    speed : float, rad/s
        The largest of the motor.
    motor : Motor
    reducer : ReducerLimits

    Returns
    -------
    dict of str to Estimate
        Of the reducer's peak torque in full, and beyond its cycles; of a curve only if the peak torque falls.
    """
    peak, behind = motor.peak_torque, points.load.output_torque
    standing = points.load.output_torque_at_rest
    estimates = {
        "RMS torque": continuous_line(points, motor)[0].estimate,
        PEAK_TORQUE: by_points(points.torque, points.standing, peak),
        "motor speed": by_speed(speed, motor.max_speed),
        "reducer input speed": by_speed(speed, reducer.input_speed),
        REDUCER_TORQUE: by_points(behind, standing, reducer.peak_torque),
        CYCLES: by_points(behind, standing, reducer.peak_torque / reducer.cycle_factor),
        "reducer mean torque": mean_torque_line(points, reducer.mean_torque).estimate,
    }
    if motor.falling.fall:
        forward, backward = points.falling_use(motor).max(axis=(1, 2)).tolist()
        estimates[BELOW] = Estimate(motor.falling.corner(peak), estimates[PEAK_TORQUE].standing, forward, backward)
    return estimates


def largest(values: Array) -> float:
    """Return the largest absolute value."""
    return float(np.abs(values).max())


class Shares(NamedTuple):
    """Inverse shares of the way from a rate to another after which a limit is reached, of torques either way."""

    forward: float
    backward: float = 0.0

    @classmethod
    def of_torques(cls, begin: Array, end: Array, limit: float) -> "Shares":
        """Return those of a limit of torque (Nm) at every point."""
        estimate = by_points(end, begin, limit)
        return cls(estimate.forward, estimate.backward)

    @classmethod
    def of_uses(cls, begin: float, end: float, target: float) -> "Shares":
        """Return those of the use of a limit up to a target."""
        grows = end - begin if end - begin > LEAST_USE * begin else 0.0
        return cls(min(NEVER, grows / max(TINY, target - begin)))
