"""The exact range of rates at which every check of a cycle holds: located at its points, then searched. SI units."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from engine.drive.drive_points import DrivePoints
from engine.drive.limit_use import RateSearch
from engine.drive.limits import LimitChecks, at_speed
from engine.drive.quadrature import QuadratureCycle
from engine.drive.rate_estimates import RateRange
from engine.laws.base import Array

FAR = 1e3  # factor of the present rate up to which, and down to whose inverse, ranges are located
STEP = 0.02  # of the rate, by which they are located
CLOSE = 1e-10  # relative tolerance of the ends
WIDENED = 40  # how often a bracket of an end is widened by a step
NEAR = 1e-9  # share of a cycle within which cuts count as the same


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
