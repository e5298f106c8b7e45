"""How much a drive uses of each limit, by the points of its cycle."""

import math
from typing import NamedTuple

import numpy as np

from engine.drive import Motor
from engine.drive.drive_points import DrivePoints
from engine.drive.limits import ReducerLimits
from engine.laws.base import Array

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
    points: DrivePoints, speed: float, motor: Motor, reducer: ReducerLimits, rate: float
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
    if motor.falling.fall:
        use = float(points.falling_use(motor).max())
        found["torque below the curve"] = found["peak torque"]._replace(limit=motor.falling.corner(peak), use=use)
    return found
