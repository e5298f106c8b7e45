"""The highest rate of a drive by its limits, from its torque at points: what stands, and what grows with the rate.

Inertia grows with the square of a rate. With S the torque without motion and I = T − S what grows, a limit is met where
the square of the rate is 1/use times the present one. It is met exactly at the present rate; elsewhere, with viscous
friction or where power turns round, to about 1 %. :func:`engine.drive.limits.highest_rate` is exact. SI units.
"""

import math
from typing import NamedTuple

import numpy as np

from engine.drive import Motor
from engine.drive.drive_points import DrivePoints
from engine.drive.limits import ReducerLimits
from engine.drive.motor import Falling
from engine.laws.base import Array

LEAST_USE = 1e-9
"""a smaller use of a limit is lost in rounding: the limit allows more than 30,000 times the present rate"""


class Share(NamedTuple):
    """A limit at no speed, what of it is taken without motion and at the present rate, the use of the rate's square."""

    limit: float
    standing: float
    present: float
    use: float

    def highest(self, rate: float) -> float:
        """Return the highest rate that it allows for a present one; infinite where none is found too high."""
        if math.isinf(self.limit):
            return math.inf
        if self.standing >= self.limit:
            return 0.0
        return rate / math.sqrt(self.use) if self.use > LEAST_USE else math.inf


def squares(points: DrivePoints) -> tuple[float, float, float]:
    """Return means over the points (Nm²): S², S·I and I²."""
    standing, grows = points.standing, points.torque - points.standing
    return points.mean(standing**2), points.mean(standing * grows), points.mean(grows**2)


class Line(NamedTuple):
    """The continuous torque against the rate: at no speed, its fall to the present mean speed (Nm); see :func:`by_rms`.

    ``near`` is the rate over the present one at which the fall is exact, ``half`` half of x's coefficient (Nm²).
    """

    stall: float
    fall: float
    near: float
    half: float


def line(points: DrivePoints, motor: Motor) -> Line:
    """Return the line of a motor's continuous torque; level where the mean speed is beyond the rated one."""
    own, mixed, _ = squares(points)
    now = float(motor.continuous(points.mean_speed))
    stall = motor.stall_torque if now > motor.rated_torque else motor.rated_torque
    if math.isinf(stall):
        return Line(stall, 0.0, 1.0, mixed)
    fall = stall - now
    near = min(1.0, (stall - math.sqrt(own)) / fall) if fall else 1.0
    return Line(stall, fall, near, mixed + (fall * (stall / near - fall) / 2.0 if near > 0.0 else 0.0))


def by_rms(points: DrivePoints, motor: Motor, moves: bool = True) -> Share:
    """Return the share of the continuous torque (Nm): mean (S + x I)² = (M − D √x)², M at no speed, D its fall.

    √x ≤ (e + x/e)/2 makes this a quadratic in x that is exact at √x = e and on the safe side elsewhere: e is 1, or
    less where S alone meets the line before.
    """
    own, _, growing = squares(points)
    stall, fall, near, half = line(points, motor)
    stands, use = math.sqrt(own), 0.0
    if moves and stands < stall < math.inf:
        left = stall * (stall - fall * near) - own
        use = (math.sqrt(half**2 + growing * left) + half) / left
    return Share(stall, stands, points.rms_torque, use)


def falling_use(points: DrivePoints, peak: float, falling: Falling) -> Array:
    """Return at each point the use by a peak torque that falls, 1/r² of |S + r² I| + f r |ω| = T + f ω_1.

    In two rows: of torques forward, and of those backward; of the first r that meets the line, 0 where none does.
    """
    way = np.array([1.0, -1.0])[:, None, None]
    left = falling.corner(peak) - way * points.standing
    sink = falling.fall * np.abs(points.speed)
    square = sink**2 + 4.0 * way * (points.torque - points.standing) * left
    return np.where(square < 0.0, 0.0, ((sink + np.sqrt(np.maximum(square, 0.0))) / (2.0 * left)) ** 2)


def by_peak(points: DrivePoints, torque: Array, standing: Array, limit: float) -> Share:
    """Return the share of a limit of torque (Nm), none of an infinite one: |I| over what S leaves in its direction."""
    grows, use = torque - standing, 0.0
    if not math.isinf(limit):
        use = float(np.maximum(grows / (limit - standing), -grows / (limit + standing)).max())
    return Share(limit, float(np.abs(standing).max()), points.size(torque), use)


def by_cycles(points: DrivePoints, reducer: ReducerLimits, rate: float) -> tuple[float, float, float]:
    """Return uses of a reducer's peak torque (Nm) beyond the cycles that it holds in full for, at so many (1/s).

    Its use, that of these cycles, the less; 0 of an infinite torque. Up to these cycles it binds no sooner, so the less
    of both counts; the second where S alone is beyond it.
    """
    load = points.load
    limit = reducer.peak_torque / reducer.cycle_factor
    over = by_peak(points, load.output_torque, load.output_torque_at_rest, limit)
    way = (rate / reducer.full_rate) ** 2
    return over.use, way, way if over.standing >= over.limit else min(way, over.use)


def by_mean(points: DrivePoints, limit: float) -> Share:
    """Return the share of the reducer's mean torque (Nm), which grows in a straight line from that without motion."""
    none, present = (points.cubic_mean(one) for one in (points.load.output_torque_at_rest, points.load.output_torque))
    use = max(0.0, present - none) / (limit - none) if none < limit < math.inf else 0.0
    return Share(limit, none, present, use)


def by_speed(speed: float, limit: float) -> Share:
    """Return the share of a speed (rad/s)."""
    return Share(limit, 0.0, speed, (speed / limit) ** 2)


def shares(
    points: DrivePoints, speed: float, motor: Motor, reducer: ReducerLimits, falling: Falling, rate: float
) -> dict[str, Share]:
    """Return the share of each limit, by its name; ``speed`` is the largest of the motor (rad/s), ``rate`` in 1/s."""
    peak, fastest = motor.peak_torque, motor.max_speed
    behind, standing = points.load.output_torque, points.load.output_torque_at_rest
    whole = by_peak(points, behind, standing, reducer.peak_torque)
    found = {
        "RMS torque": by_rms(points, motor, speed > 0.0),
        "peak torque": by_peak(points, points.torque, points.standing, peak),
        "motor speed": by_speed(speed, fastest),
        "reducer input speed": by_speed(speed, reducer.input_speed),
        "reducer peak torque": whole._replace(use=max(whole.use, by_cycles(points, reducer, rate)[2])),
        "reducer mean torque": by_mean(points, reducer.mean_torque),
    }
    if falling.fall:
        use = float(falling_use(points, peak, falling).max())
        found["torque below the curve"] = found["peak torque"]._replace(limit=falling.corner(peak), use=use)
    return found
