"""From an axis to what a target is given: points in its numbers, and the certificate of what it makes of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import ceil, log10

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import Certificate, certify
from engine.cams.interpolation import straight
from engine.cams.points import doubled, equal, jumps, spread
from engine.cams.profile import SAME, CamProfile
from engine.laws.base import Array
from workbook.axes import CamAxis
from workbook.controllers.files import parsed
from workbook.controllers.number import step_of
from workbook.controllers.table import RULES, Rule, Table
from workbook.controllers.target import Target
from workbook.errors import TargetError

ORDERS = ("y", "v", "a", "j")
"""position, velocity, acceleration and jerk, as tolerances name them"""
DIGITS = 13
"""of the cycle: so many digits of x are kept, which the breaks of a motion have"""
ROUNDED = 1e-14
"""of the largest of a column: what is smaller is none"""
WITHIN = 1e-3
"""of a way from point to point: so near to its ends a break may lie, which numbers of 32 bits have rounded"""


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
    named = target.plain if target.plain and (table.v is None or table.a is None) else target.rules
    if table.profile is not None:
        named = ("polynomials",)
    return {name: RULES[name] for name in named}


def certified(target: Target, table: Table, meant: CamProfile) -> Made:
    """Return a table with its certificates."""
    return Made(table, {name: certify(meant, rule.made(table)) for name, rule in rules_of(target, table).items()})


def tabulated(target: Target, axis: CamAxis, n: int) -> Table:
    """Return the table of n points at most, in the target's numbers; raise TargetError beyond its limits."""
    allowed(target, n)
    return filled(target, axis.profile, placed(target, axis.profile, n), (axis.x_unit, axis.y_unit))


def allowed(target: Target, n: int) -> None:
    """Raise TargetError for a number of points that a target cannot have."""
    least, most = target.points
    if not least <= n <= most:
        raise TargetError(f"{target.name}: {n:,} points; expected {least:,} to {most:,}")
    if target.counts and n not in target.counts:
        raise TargetError(f"{target.name}: {n:,} points; expected one of {', '.join(map(str, target.counts))}")


def placed(target: Target, of: CamProfile, n: int) -> Array:
    """Return the places of at most n points: at equal steps, or on the breaks and where the rule needs them."""
    if target.spacing == "equal":
        return equal(of, n)
    if n < (needed := fewest(target, of)):
        raise TargetError(f"{target.name}: {n} points; the breaks of the motion need at least {needed}")
    exact = target.exact(of) if target.exact else None
    extra = more(target, of)
    x = spread(of, n - extra, RULES[target.rules[0]].order, steps(target, of), exact)
    return doubled(of, x) if extra else x


def more(target: Target, of: CamProfile) -> int:
    """Return how many points of their own jumps of y'' need: those of a target whose points have one y''."""
    return len(jumps(of)) if "y''" in target.columns else 0


def steps(target: Target, of: CamProfile) -> NDArray[np.intp]:
    """Return how many steps each stretch needs: one where it is exact, else those of the rule."""
    least = np.full(len(of.origins), RULES[target.rules[0]].least)
    return np.where(target.exact(of), 1, least) if target.exact else least


def filled(target: Target, of: CamProfile, x: Array, units: tuple[str, str]) -> Table:
    """Return the table of a motion at places, each number as the target holds it."""
    number = target.number
    x_step = step_of(units[0], float(np.abs(of.edges).max()), number.largest)
    y_step = step_of(units[1])
    places, x = x, number.rounded(np.round(x, DIGITS - ceil(log10(of.total))), x_step)
    of = snapped(of, places, x)
    if target.built:
        return target.built(of, x, (x_step, y_step))
    inner, last = of.at(x[:-1]), of.at(x[-1:], left=True)
    y, v, a, j = (np.concatenate(both) for both in zip(inner, last, strict=True))
    size = float(np.ptp(y))
    y, v, a, j = (clean(one, size * (len(x) / of.total) ** order) for order, one in enumerate((y, v, a, j)))
    had = [number.rounded(column) if name in target.columns else None
           for name, column in (("y'", v), ("y''", a), ("y'''", j))]  # fmt: skip
    lines = lying(of, x) if "straight" in target.columns else None
    first, second = (v if number.whole else number.rounded(v))[[0, -1]].tolist()
    return Table(x, number.rounded(y, y_step), had[0], had[1], had[2], (first, second), lines, steps=(x_step, y_step))


def snapped(of: CamProfile, places: Array, x: Array) -> CamProfile:
    """Return a profile whose breaks lie where numbers have rounded the places: what jumps there jumps at a point."""
    after = np.clip(np.searchsorted(places, of.edges), 1, len(places) - 1)
    nearest = np.where(of.edges - places[after - 1] <= places[after] - of.edges, after - 1, after)
    on = np.abs(places[nearest] - of.edges) <= SAME * of.total
    return replace(of, edges=np.where(on, x[nearest], of.edges))


def lying(of: CamProfile, x: Array) -> NDArray[np.bool_]:
    """Return which ways between places lie within one straight stretch."""
    h = np.diff(x)
    first, last = of.index(x[:-1] + WITHIN * h), of.index(x[1:] - WITHIN * h)
    return np.asarray(straight(of)[first] & (first == last))


def clean(values: Array, size: float) -> Array:
    """Return values without those that are only what rounding leaves of zero, beside others or a size."""
    return np.where(np.abs(values) < ROUNDED * max(float(np.abs(values).max(initial=0.0)), size), 0.0, values)


def fewest(target: Target, of: CamProfile) -> int:
    """Return the fewest points that do for a motion."""
    least = target.points[0]
    return least if target.spacing == "equal" else max(least, int(steps(target, of).sum()) + 1 + more(target, of))


def reread(target: Target, text: str, made: Table) -> Table:
    """Return what an independent reader finds in the file; slopes that go beside it are taken from what was made."""
    table = parsed(text, target)
    return table if table.slopes or not made.slopes else replace(table, slopes=made.slopes)
