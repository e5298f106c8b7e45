"""The highest rate of a drive, exact from an estimate by points: what limits it, in which phase, and what does next."""

import math
from collections.abc import Iterable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from engine.drive.cycle import TorqueInterval
from engine.drive.limits import BELOW, CYCLES, NAMES, LimitChecks, at_speed
from engine.drive.rate_estimates import PEAK_TORQUE, REDUCER_TORQUE
from engine.drive.rate_range import at_points, crossing
from engine.drive.results import DriveResults, Extreme
from engine.drive.search import integral
from engine.laws.base import Array

EXACT_NAMES = {PEAK_TORQUE: BELOW, CYCLES: REDUCER_TORQUE}  # of limits that the points tell apart
NEARLY = 0.9  # use of a limit by points from which the exact engine is asked
STEP, CLOSE = 0.02, 1e-6  # of the rate: by which it is looked for, to which it is known


class RateLimit(NamedTuple):
    """A limit of a drive and the rate at which it is reached."""

    rate: float  # cycles per second; infinite without limits, 0 where no rate holds them
    limit: str  # empty without limits


def highest_rate(checks: LimitChecks) -> RateLimit:
    """Return the highest rate at which a drive holds all limits, right to 2e-6 of it, and the limit there.

    Of the limits, those that the points find nearly used at their own highest rate are asked of the exact engine.
    """
    search = at_points(checks)
    estimate = search.range.high
    if not 0.0 < estimate < math.inf:
        return RateLimit(estimate, search.range.high_limit)
    uses = search.at(estimate / search.rate).uses
    nearly_used = (name for name, use in uses.items() if use > NEARLY)
    names = dict.fromkeys(EXACT_NAMES.get(name, name) for name in (search.range.high_limit, *nearly_used))
    rate = reached(checks, names, estimate)
    there = {check.name: check.use for check in at_speed(checks, rate * checks.drive_cycle.unshifted.total).of(names)}
    return RateLimit(rate, max(names, key=lambda name: there.get(name, 0.0)))


def limits_in_order(checks: LimitChecks) -> Iterator[RateLimit]:
    """Yield the rate at which each limit of a drive alone is reached, in no order; limits that no rate reaches not."""
    search = at_points(checks)
    estimates: dict[str, float] = {}
    for name, ends in search.estimated.items():
        exact = EXACT_NAMES.get(name, name)
        estimates[exact] = min(ends.high, estimates.get(exact, math.inf))
    for name in NAMES:
        if 0.0 < estimates.get(name, math.inf) < math.inf:
            yield RateLimit(reached(checks, [name], estimates[name]), name)


def reached(checks: LimitChecks, names: Iterable[str], estimate: float) -> float:
    """Return the rate (1/s) near an estimate at which the first of some limits is reached, safe, to 2e-6 of it."""
    asked, total = list(names), checks.drive_cycle.unshifted.total

    def use(rate: float) -> float:
        return max((check.use for check in at_speed(checks, rate * total).of(asked)), default=0.0)

    return crossing(use, estimate, STEP, CLOSE) * (1.0 - 2.0 * CLOSE)


class Moment(NamedTuple):
    """The moment at which a limit is used most."""

    phase: int  # number of the phase, from 0
    x: float  # abscissa of the unshifted motion at which the quantity is extreme; of a mean, of the torque
    share: float  # what the phase adds to the mean; 1 of a quantity that has a moment


def moment_of(checks: LimitChecks, limit: str) -> Moment:
    """Return where a limit is used most: the extreme, or of a mean the phase that adds most to it."""
    results = checks.results
    if limit in ("motor speed", "reducer input speed"):
        ends: tuple[Extreme, ...] = results.speed
    else:
        ends = results.shaft_torque(1) if limit.startswith("reducer") else results.torque
    if limit not in ("RMS torque", "reducer mean torque"):
        most = max(ends, key=lambda extreme: abs(extreme.value))
        return Moment(most.phase, most.x, 1.0)
    shares = shares_of_phases(results, 1 if limit.startswith("reducer") else 0)
    phase = max(shares, key=lambda number: shares[number])
    return Moment(phase, max(ends, key=lambda extreme: abs(extreme.value)).x, shares[phase])


def shares_of_phases(results: DriveResults, shaft: int) -> dict[int, float]:
    """Return by phase its share in the integral of T² of the motor (shaft 0), else of |ω| |T|³ behind the reducer."""

    def burden(part: TorqueInterval, u: Array) -> Array:
        torque = np.abs(part.torque(u, shaft))
        return torque**2 if shaft == 0 else np.abs(part.motor_speed(u)) * torque**3

    added: dict[int, float] = {}
    for part in results.drive_cycle.torque_intervals:
        more = integral(partial(burden, part), part.low, part.high)
        added[part.piece.phase] = added.get(part.piece.phase, 0.0) + more
    whole = math.fsum(added.values())
    return {phase: more / whole if whole else 0.0 for phase, more in added.items()}
