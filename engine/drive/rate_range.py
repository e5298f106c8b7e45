"""The exact rates at which a drive holds its limits: located at points of its cycle, then searched. SI units.

The range in which every check holds; the highest rate, what limits it, in which phase, and what does next.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drive.cycle import TorqueInterval
from engine.drive.drive_points import DrivePoints
from engine.drive.limit_use import RateSearch
from engine.drive.limits import BELOW, CYCLES, NAMES, PEAK_TORQUE, REDUCER_TORQUE, LimitChecks, at_speed
from engine.drive.quadrature import QuadratureCycle
from engine.drive.rate_estimates import RateRange
from engine.drive.results import DriveResults, Extreme
from engine.drive.search import integral
from engine.laws.base import Array

FAR = 1e3  # factor of the present rate up to which, and down to whose inverse, ranges are located
STEP = 0.02  # of the rate, by which they are located
CLOSE, HIGHEST_CLOSE = 1e-10, 1e-6  # relative tolerances of the ends of a range, and of a highest rate
WIDENED = 40  # how often a bracket of an end is widened by a step
NEAR = 1e-9  # share of a cycle within which cuts count as the same
EXACT_NAMES = {PEAK_TORQUE: BELOW, CYCLES: REDUCER_TORQUE}  # of limits that the points tell apart
NEARLY = 0.9  # use of a limit by points from which the exact engine is asked


def rate_range(checks: LimitChecks) -> RateRange:
    """Return the speeds of the abscissa (units per s) between which every check holds.

    Of several ranges it is that of the cycle's speed if that holds, else the highest. At both ends all checks hold;
    beyond, at 1 ± 2e-10 times them, the named check does not.
    """
    factors, holds = located(checks)
    present = checks.drive_cycle.speed
    inside = np.flatnonzero(holds)
    if not inside.size:
        some = (at_speed(checks, present * float(factor)).worst for factor in factors[::50])
        worst = min(some, key=lambda check: check.use)
        return RateRange(0.0, 0.0, worst.name, worst.name)
    first = last = int(np.flatnonzero(factors == 1.0)[0]) if checks.ok else int(inside[-1])
    while last + 1 < len(factors) and holds[last + 1]:
        last += 1
    while first > 0 and holds[first - 1]:
        first -= 1
    low, low_limit, high, high_limit = 0.0, "", math.inf, ""
    if first > 0:
        low, low_limit = _end(checks, present * float(factors[first]), -STEP)
    if last + 1 < len(factors):
        high, high_limit = _end(checks, present * float(factors[last]), STEP)
    return RateRange(low, high, low_limit, high_limit)


def located(checks: LimitChecks) -> tuple[Array, NDArray[np.bool_]]:
    """Return factors of the cycle's speed in order, 1 among them, and whether all limits are held there at points."""
    here = at_points(checks)
    fastest = min(checks.motor.max_speed, checks.reducer.input_speed)
    top = fastest / here.speed if here.speed > 0.0 and fastest < math.inf else FAR
    factors = np.unique([1.0, *np.geomspace(min(1.0, top) / FAR, top * (1.0 + STEP), int(math.log(FAR) / STEP) * 2)])
    holds = np.array([here.at(factor).holds for factor in factors])
    return factors, holds | ((factors == 1.0) & checks.ok)


def at_points(checks: LimitChecks) -> RateSearch:
    """Return the search of the rates that hold all limits by the points of a cycle."""
    cycle = checks.drive_cycle
    points = DrivePoints(QuadratureCycle(cycle, cycle.unshifted.moved, NEAR * cycle.unshifted.total).points())
    return RateSearch(points, points.size(points.speed), checks.motor, checks.reducer, 1.0 / cycle.time)


def _end(checks: LimitChecks, inside: float, step: float) -> tuple[float, str]:
    """Return the speed at which a range ends, near a speed ``inside`` of it, a step up or down, and the limit there."""
    met = crossing(lambda speed: at_speed(checks, speed).worst.use, inside, step, CLOSE)
    way = math.copysign(2.0 * CLOSE, step)
    return met * (1.0 - way), at_speed(checks, met * (1.0 + way)).worst.name


def crossing(use: Callable[[float], float], inside: float, step: float, close: float) -> float:
    """Return the rate near one ``inside`` at which a use reaches 1, by steps up or down; the last tried, if none is.

    Step and tolerance are shares of the rate. A reducer may have a limit from a number of cycles on.
    """
    from scipy.optimize import brentq  # slow to import, and most commands need no range of rates

    def excess(rate: float) -> float:
        return min(use(rate), 2.0) - 1.0

    outside = inside * (1.0 + step)
    for _ in range(WIDENED):
        if excess(inside) <= 0.0:
            break
        inside, outside = inside / (1.0 + step), inside
    for _ in range(WIDENED):
        if excess(outside) > 0.0:
            break
        inside, outside = outside, outside * (1.0 + step)
    bracketed = excess(outside) > 0.0 >= excess(inside)
    return float(brentq(excess, *sorted((inside, outside)), rtol=close)) if bracketed else inside


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

    return crossing(use, estimate, STEP, HIGHEST_CLOSE) * (1.0 - 2.0 * HIGHEST_CLOSE)


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
