"""A drive that creeps, a cycle a minute, as a machine starts up: with its process forces, or empty. SI units."""

from dataclasses import replace

from engine.drive.drive_points import DrivePoints
from engine.drive.limits import LimitChecks, ReducerLimits
from engine.drive.motor import LimitCheck, Motor
from engine.drive.rate_estimates import PEAK_TORQUE, REDUCER_TORQUE

CREEP_RATE = 1.0 / 60.0  # cycles per second


def creep_factor(time: float) -> float:
    """Return the rate of creeping over that of a cycle of a time (s): at most 1."""
    return min(1.0, CREEP_RATE * time)


def creeping(checks: LimitChecks, loaded: bool) -> LimitChecks:
    """Return the checks of the same drive creeping, exact; its process forces act if it is ``loaded``."""
    cycle = checks.drive_cycle
    train = cycle.train if loaded else replace(cycle.train, windows=())
    return replace(checks, drive_cycle=replace(cycle, train=train, speed=cycle.speed * creep_factor(cycle.time)))


def creep_checks(points: DrivePoints, motor: Motor, reducer: ReducerLimits, rate: float) -> tuple[LimitCheck, ...]:
    """Return the torques of a drive at the points of its cycle against their limits.

    Parameters
    ----------
    points : DrivePoints
        While it creeps.
    motor : Motor
        Of a peak torque that falls with speed, what it has fallen counts as torque.
    reducer : ReducerLimits
    rate : float, 1/s
        Cycles per second, creeping.

    Returns
    -------
    tuple of LimitCheck
        RMS torque and peak torque of the motor, peak and mean torque behind the reducer (Nm).
    """
    behind = points.load.output_torque
    peak = float((abs(points.torque) + motor.falling.fallen(points.speed)).max())
    return (
        LimitCheck("RMS torque", points.rms_torque, float(motor.continuous(points.mean_speed))),
        LimitCheck(PEAK_TORQUE, peak, motor.peak_torque),
        LimitCheck(REDUCER_TORQUE, float(abs(behind).max()), reducer.peak_at(rate)),
        LimitCheck("reducer mean torque", points.cubic_mean(behind), reducer.mean_torque),
    )
