"""The highest rate at which drives hold all their limits, and which limit of which axis binds. SI units."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from engine.drive.limits import LimitChecks

FAR = 1e6
"""times the rate that is asked about: no further is looked, up or down"""

CLOSE = 1e-10
"""of the rate: so near to the one that binds"""

STEPS = 200


class HighestRate(NamedTuple):
    """The highest speed of the abscissa (1/s) at which every check holds, and the axis and the limit that bind there.

    0 where one does not even hold at a millionth of the speed asked about; infinite, with no name, where none binds
    up to a million times.
    """

    speed: float
    axis: str
    limit: str


def highest_rate(axes: Mapping[str, LimitChecks]) -> HighestRate:
    """Return the highest rate of axes that are driven by one shaft, or in one time.

    It is looked for from the speed of each cycle: upwards where all hold, downwards where one does not, to the first
    change. At the speed found all hold, and a little above it the named limit does not.
    """
    each = [HighestRate(speed, name, limit) for name, one in axes.items() for speed, limit in (of_axis(one),) if limit]
    return min(each, default=HighestRate(math.inf, "", ""))


def of_axis(checks: LimitChecks) -> tuple[float, str]:
    """Return the highest speed of one axis, and the limit that binds."""
    speed = checks.drive_cycle.speed
    holds, fails = (speed, 2.0 * speed) if checks.ok else (0.5 * speed, speed)
    while holds > speed / FAR and not at_speed(checks, holds).ok:
        holds, fails = 0.5 * holds, holds
    if holds <= speed / FAR:
        return 0.0, named(at_speed(checks, holds))
    while fails < speed * FAR and at_speed(checks, fails).ok:
        holds, fails = fails, 2.0 * fails
    if fails >= speed * FAR:
        return math.inf, ""
    return _narrowed(checks, holds, fails)


def at_speed(checks: LimitChecks, speed: float) -> LimitChecks:
    """Return the same cycle and limits at another speed of the abscissa."""
    return LimitChecks(replace(checks.drive_cycle, speed=speed), checks.limits)


def named(checks: LimitChecks) -> str:
    """Return the name of the limit that is used most; nothing without any limit."""
    return checks.worst.name if checks.worst else ""


def over(checks: LimitChecks) -> float:
    """Return by how much the most used limit is overstepped, as a share of it: below 0 where all hold."""
    return min(checks.worst.use, 2.0) - 1.0 if checks.worst else -1.0


def _narrowed(checks: LimitChecks, low: float, high: float) -> tuple[float, str]:
    """Return the last speed between two that holds, by false position with halved weights (Illinois), and what fails.

    Source: M. Dowell, P. Jarratt, A modified regula falsi method, BIT 11 (1971) 168–174.
    """
    at_high = at_speed(checks, high)
    below, above = over(at_speed(checks, low)), over(at_high)
    name, last = named(at_high), 0
    for _ in range(STEPS):
        if high - low <= CLOSE * high:
            break
        middle = low + (high - low) * min(max(-below / (above - below), 1e-3), 1.0 - 1e-3) if above > below else low
        one = at_speed(checks, middle)
        if one.ok:
            low, below, above, last = middle, over(one), above * (0.5 if last < 0 else 1.0), -1
        else:
            high, above, below, last = middle, over(one), below * (0.5 if last > 0 else 1.0), 1
            name = named(one)
    return low, name
