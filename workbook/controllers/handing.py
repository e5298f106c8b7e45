"""From an axis to what a target is given: points in its numbers, and the certificate of what it makes of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import ceil, log10

import numpy as np

from engine.cams.certificate import Certificate, certify
from engine.cams.course import Course
from engine.cams.points import equal, spread
from engine.laws.base import Array
from workbook.axes import CamAxis
from workbook.controllers.table import RULES, Rule, Table
from workbook.controllers.target import Target
from workbook.errors import TargetError

ORDERS = ("y", "v", "a", "j")
"""position, velocity, acceleration and jerk, as tolerances name them"""
DIGITS = 13
"""of the cycle: so many digits of x are kept, which the breaks of a motion have"""
ROUNDED = 1e-14
"""of the largest of a column: what is smaller is none"""
GROWTH = 1.25
WORSE = 4.0  # times the best: no more points are tried
MOST_TRIED = 4000


@dataclass(frozen=True)
class Made:
    """A table for a target, and the certificate of each rule that may be its."""

    table: Table
    certificates: Mapping[str, Certificate]

    @property
    def points(self) -> int:
        """How many points it has."""
        return len(self.table.x)

    def share(self, order: str) -> float:
        """Return the largest deviation of one order by any of the rules, as a share of the motion's peak."""
        k = ORDERS.index(order)
        return max(one.deviations[k].share for one in self.certificates.values())

    def excess(self, tolerance: Mapping[str, float]) -> float:
        """Return the largest ratio of a deviation to what is tolerated."""
        return max(self.share(order) / most for order, most in tolerance.items())


def rules_of(target: Target, table: Table) -> dict[str, Rule]:
    """Return the rules by which a target may go between the points of a table."""
    named = target.plain if target.plain and table.v is None else target.rules
    return {name: RULES[name] for name in named}


def certified(target: Target, table: Table, meant: Course) -> Made:
    """Return a table with its certificates."""
    return Made(table, {name: certify(meant, rule.made(table)) for name, rule in rules_of(target, table).items()})


def tabulated(target: Target, axis: CamAxis, n: int) -> Table:
    """Return the table of n points at most, in the target's numbers; raise TargetError beyond its limits."""
    least, most = target.points
    if not least <= n <= most:
        raise TargetError(f"{target.name}: {n:,} points; expected {least:,} to {most:,}")
    return filled(target, axis.course, placed(target, axis.course, n))


def placed(target: Target, of: Course, n: int) -> Array:
    """Return the places of at most n points: at equal steps, or on the breaks and where the rule needs them."""
    if target.spacing == "equal":
        return equal(of, n)
    rule = RULES[target.rules[0]]
    fewest = len(of.origins) * rule.least + 1
    if n < fewest:
        raise TargetError(f"{target.name}: {n} points; the breaks of the motion need at least {fewest}")
    return spread(of, n, rule.order, rule.least)


def filled(target: Target, of: Course, x: Array) -> Table:
    """Return the table of a motion at places, each number as the target holds it."""
    decimals = DIGITS - ceil(log10(of.total))
    x = target.number.rounded(np.round(x, decimals))
    inner, last = of.at(x[:-1]), of.at(x[-1:], left=True)
    y, v, a, j = (target.number.rounded(clean(np.concatenate(both))) for both in zip(inner, last, strict=True))
    had = [column if name in target.columns else None for name, column in (("y'", v), ("y''", a), ("y'''", j))]
    return Table(x, y, had[0], had[1], had[2], slopes=(float(v[0]), float(v[-1])))


def clean(values: Array) -> Array:
    """Return values without those that are only what rounding leaves of zero."""
    return np.where(np.abs(values) < ROUNDED * np.abs(values).max(initial=0.0), 0.0, values)


def tried(target: Target, axis: CamAxis) -> Iterator[Made]:
    """Yield tables of more and more points."""
    n, most = fewest(target, axis.course), min(target.points[1], MOST_TRIED)
    while n <= most:
        yield certified(target, tabulated(target, axis, n), axis.course)
        n = min(max(n + 1, int(n * GROWTH)), most) if n < most else most + 1


def fewest(target: Target, of: Course) -> int:
    """Return the fewest points that do for a motion."""
    least = target.points[0]
    return least if target.spacing == "equal" else max(least, len(of.origins) * RULES[target.rules[0]].least + 1)


def automatic(target: Target, axis: CamAxis, tolerance: Mapping[str, float]) -> Made:
    """Return the table of the fewest points that keeps to the tolerance, or the best there is.

    Raises TargetError where the target has no room for the breaks of the motion.
    """
    best: Made | None = None
    before = 0
    for made in tried(target, axis):
        if made.excess(tolerance) <= 1.0:
            return fewer(target, axis, tolerance, before, made)
        if best is None or made.excess(tolerance) < best.excess(tolerance):
            best = made
        if made.excess(tolerance) > WORSE * best.excess(tolerance):
            break
        before = made.points
    if best is None:
        needed = fewest(target, axis.course)
        raise TargetError(f"{target.name}: {axis.name} has breaks for {needed} points; at most {target.points[1]} fit")
    return best


def fewer(target: Target, axis: CamAxis, tolerance: Mapping[str, float], low: int, made: Made) -> Made:
    """Return the table of the fewest points above ``low`` that still keeps to the tolerance."""
    high = made.points
    low = max(low, fewest(target, axis.course) - 1)
    while high - low > 1:
        middle = (low + high) // 2
        one = certified(target, tabulated(target, axis, middle), axis.course)
        if one.excess(tolerance) <= 1.0:
            made, high = one, middle
        else:
            low = middle
    return made


def reread(target: Target, text: str, made: Table) -> Table:
    """Return what an independent reader finds in the file; slopes that go beside it are taken from what was made."""
    table = target.read(text)
    return table if table.slopes or not made.slopes else replace(table, slopes=made.slopes)
