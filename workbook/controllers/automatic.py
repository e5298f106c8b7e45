"""The fewest points that keep to a tolerance, or the best there is, for a target's numbers, within a bounded work."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from workbook.axes import CamAxis
from workbook.controllers.handing import ORDERS, Made, certified, fewest, tabulated
from workbook.controllers.target import Target
from workbook.errors import TargetError

GROWTH = (1.25, 2.0)
BETTER = 0.95  # times the best so far: more points are worth it
LOST = 0.5
"""of its peak: an order that the best misses by so much jumps, and no number of points helps it"""
COARSE = 100
DRAWN = 12
IDLE = 3  # tries that were not: no more are made
MOST_TRIED, MOST_EQUAL = 4000, 2000
WORK = 80_000
"""points times rules that are certified for one axis: a second or so"""


@dataclass
class Tries:
    """The tables of an axis that were made for a target, by their number of points; no more than :data:`WORK`."""

    target: Target
    axis: CamAxis
    made: dict[int, Made] = field(default_factory=dict)
    spent: int = 0

    def of(self, n: int) -> Made | None:
        """Return the table of n points at most with its certificate; None where the work is done."""
        if n not in self.made:
            if self.spent > WORK:
                return None
            one = certified(self.target, tabulated(self.target, self.axis, n), self.axis.profile)
            self.spent += (n + len(self.axis.profile.edges)) * len(one.certificates)
            self.made[n] = one
        return self.made[n]


def automatic(target: Target, axis: CamAxis, tolerance: Mapping[str, float]) -> Made:
    """Return the table of the fewest points that keeps to the tolerance, or the best there is.

    Where none does, as where an acceleration jumps, and several are alike, it is the one that keeps velocity and
    position to theirs, or to what is tolerated of the derivatives above. Raises TargetError where the target has no
    room for the breaks of the motion.
    """
    tries = Tries(target, axis)
    best = nearest(tries, tolerance)
    if best.excess(tolerance) <= 1.0:
        return best
    for orders in range(max(map(ORDERS.index, tolerance)), 0, -1):
        lower = {order: tolerance.get(order) or above(order, tolerance) for order in ORDERS[:orders]}
        other = nearest(tries, lower)
        lost = max(best.share(order) for order in tolerance) >= LOST
        kept = other.excess(tolerance) * BETTER <= best.excess(tolerance)
        if other.excess(lower) < best.excess(lower) and (lost or kept):
            best = other
        if best.excess(lower) <= 1.0:
            break
    return best


def above(order: str, tolerance: Mapping[str, float]) -> float:
    """Return the least that is tolerated of the derivatives above one."""
    return min(one for name, one in tolerance.items() if ORDERS.index(name) > ORDERS.index(order))


def tried(tries: Tries, tolerance: Mapping[str, float]) -> Iterator[Made]:
    """Yield tables of more and more points: the more of them, the farther each is from what is tolerated."""
    target, of = tries.target, tries.axis.profile
    if target.counts:
        yield from filter(None, map(tries.of, target.counts))
        return
    equal_steps = target.spacing == "equal"
    n, most = fewest(target, of), min(target.points[1], MOST_EQUAL if equal_steps else MOST_TRIED)
    n = max(n, min(len(of.edges), most)) if equal_steps else n
    while n <= most and (made := tries.of(n)):
        yield made
        growth = min(max(made.excess(tolerance) ** 0.5, GROWTH[0]), GROWTH[1])
        n = min(max(n + 1, int(n * growth)), most) if n < most else most + 1


def nearest(tries: Tries, tolerance: Mapping[str, float]) -> Made:
    """Return the table of the fewest points that keeps to the tolerance, or the first that comes nearest."""
    target = tries.target
    best: Made | None = None
    before, idle = 0, 0
    for made in tried(tries, tolerance):
        if made.excess(tolerance) <= 1.0:
            return made if target.counts else fewer(tries, tolerance, before, made)
        idle += 1
        if best is None or made.excess(tolerance) < BETTER * best.excess(tolerance):
            best, idle = made, 0
        if idle == IDLE and target.spacing != "equal":  # equal steps miss the breaks by luck: each try may be better
            break
        before = made.points
    if best is None:
        needed = fewest(target, tries.axis.profile)
        said = f"{tries.axis.name} has breaks for {needed} points; at most {target.points[1]} fit"
        raise TargetError(f"{target.name}: {said}")
    return best


def fewer(tries: Tries, tolerance: Mapping[str, float], low: int, made: Made) -> Made:
    """Return the table of the fewest points above ``low`` that still keeps to the tolerance, to a hundredth of them."""
    high = made.points
    low = max(low, fewest(tries.target, tries.axis.profile) - 1)
    while high - low > max(1, high // COARSE) and (one := tries.of((low + high) // 2)):
        if one.excess(tolerance) <= 1.0:
            made, high = one, (low + high) // 2
        else:
            low = (low + high) // 2
    return made


def curve(target: Target, axis: CamAxis) -> list[Made]:
    """Return tables from the fewest points to the most that are tried, for a picture."""
    low, high = fewest(target, axis.profile), min(target.points[1], MOST_TRIED)
    if low > high:
        return []
    counts = target.counts or dict.fromkeys(round(n) for n in np.geomspace(low, high, DRAWN))
    return [certified(target, tabulated(target, axis, n), axis.profile) for n in counts]
