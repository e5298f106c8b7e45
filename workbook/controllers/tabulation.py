"""From an axis to a target's table: so many points, or the fewest within a tolerance, each with certificates."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from math import ceil, log10
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import Certificate, certify, equal_steps, jumps, spread
from engine.cams.interpolation import straight
from engine.laws.base import Array
from engine.motion.profile import SAME, CamProfile
from workbook.controllers.table import RULES, Rule, Table
from workbook.controllers.target import Target, parse_table
from workbook.controllers.texts import Units, step_of
from workbook.errors import TargetError
from workbook.template_outputs import CamAxis

GROWTH = (1.25, 2.0)
BETTER = 0.95  # times the best so far: more points are worth it
LOST = 0.5  # of its peak: an order that the best misses by so much jumps, and no number of points helps it
COARSE = 100
DRAWN = 12
IDLE = 3  # tries that were not: no more are built
MOST_TRIED, MOST_EQUAL = 4000, 2000
WORK = 80_000  # points times rules that are certified for an axis: a second or so
ORDERS = ("y", "v", "a", "j")  # position, velocity, acceleration and jerk, as tolerances name them
DIGITS = 13  # of the cycle: so many digits of x are held, which the breaks of a motion have
ROUNDED = 1e-14  # of the largest of a column: what is smaller is none
BEFORE = 1e-5  # of the cycle: so far before a jump of y' or y'' stands a point of its own
# of a way from point to point: so near to its ends a break, rounded to 32 bits, may lie
WITHIN = 1e-3


class CertifiedTable(NamedTuple):
    """A table for a target, and the certificate of each rule that may be its."""

    table: Table
    certificates: Mapping[str, Certificate]

    @property
    def points(self) -> int:
        """The number of its points."""
        return len(self.table.x)

    def share(self, order: str) -> float:
        """Return the largest deviation of an order by any of the rules, as a share of the motion's peak."""
        k = ORDERS.index(order)
        return max(certificate.deviations[k].share for certificate in self.certificates.values())

    def excess(self, tolerance: Mapping[str, float]) -> float:
        """Return the largest ratio of a deviation to what is tolerated."""
        return max(self.share(order) / most for order, most in tolerance.items())


def rules_of(target: Target, table: Table) -> dict[str, Rule]:
    """Return the rules by which a target may go between the points of a table."""
    named = target.plain if target.plain and (table.v is None or table.a is None) else target.rules
    if table.profile is not None:
        named = ("polynomials",)
    return {name: RULES[name] for name in named}


def certify_table(target: Target, table: Table, meant: CamProfile) -> CertifiedTable:
    """Return a table with its certificates."""
    rules = rules_of(target, table).items()
    return CertifiedTable(table, {name: certify(meant, rule.rebuild(table)) for name, rule in rules})


def tabulate(target: Target, axis: CamAxis, n: int) -> Table:
    """Return the table of at most n points, in the target's numbers: at equal steps, or on breaks and as rules need."""
    require_count(target, n)
    of, units = axis.profile, (axis.x_unit, axis.y_unit)
    if target.spacing == "equal":
        return table_at(target, of, equal_steps(of, n), units)
    if n < (needed := fewest_points(target, of)):
        raise TargetError(f"{target.name}: {n} points; the breaks of the motion need at least {needed}")
    before = before_jumps(target, of)
    x = spread(of, n - len(before), RULES[target.rules[0]].order, steps(target, of), target.exact(of))
    return table_at(target, of, np.union1d(x, before), units)


def placed_otherwise(target: Target, axis: CamAxis, tried: CertifiedTable) -> CertifiedTable | None:
    """Return the table of as many points at equal steps, or of a table at equal steps as many on the breaks.

    There is none of segments, and of too few points for the breaks.
    """
    other = replace(target, spacing="free" if target.spacing == "equal" else "equal", counts=())
    if target.spacing == "breaks" or tried.points < fewest_points(other, axis.profile):
        return None
    return certify_table(other, tabulate(other, axis, tried.points), axis.profile)


def require_count(target: Target, n: int) -> None:
    """Raise TargetError for a number of points that a target cannot have."""
    least, most = target.points
    if not least <= n <= most:
        raise TargetError(f"{target.name}: {n:,} points; expected {least:,} to {most:,}")
    if target.counts and n not in target.counts:
        raise TargetError(f"{target.name}: {n:,} points; expected one of {', '.join(map(str, target.counts))}")


def before_jumps(target: Target, of: CamProfile) -> Array:
    """Return points just before each jump: of a target whose points have a y' and a y'', which serve both sides."""
    return jumps(of) - BEFORE * of.total if "y''" in target.columns else np.empty(0)


def steps(target: Target, of: CamProfile) -> NDArray[np.intp]:
    """Return how many steps each stretch needs: 1 where it is exact, else those of the rule."""
    return np.where(target.exact(of), 1, RULES[target.rules[0]].least)


def table_at(target: Target, of: CamProfile, x: Array, units: Units) -> Table:
    """Return the table of a motion at places as the target holds it, the motion's breaks moved to where x is."""
    number = target.number
    x_step = step_of(units[0], float(np.abs(of.edges).max()), number.largest)
    y_step = step_of(units[1])
    places, x = x, number.rounded(np.round(x, DIGITS - ceil(log10(of.total))), x_step)
    after = np.clip(np.searchsorted(places, of.edges), 1, len(places) - 1)
    nearest = np.where(of.edges - places[after - 1] <= places[after] - of.edges, after - 1, after)
    of = replace(of, edges=np.where(np.abs(places[nearest] - of.edges) <= SAME * of.total, x[nearest], of.edges))
    if target.built:
        return target.built(of, x, (x_step, y_step))
    at = of.at(x)
    sizes = [max(float(np.abs(row).max()), float(np.ptp(at.y)) * (len(x) / of.total) ** k) for k, row in enumerate(at)]
    y, v, a, j = (np.where(np.abs(row) < ROUNDED * size, 0.0, row) for row, size in zip(at, sizes, strict=True))
    rates = {"y'": v, "y''": a, "y'''": j}
    had = [number.rounded(row) if name in target.columns else None for name, row in rates.items()]
    h = WITHIN * np.diff(x)
    begins, ends = of.index(x[:-1] + h), of.index(x[1:] - h)
    lines = np.asarray(straight(of)[begins] & (begins == ends)) if "straight" in target.columns else None
    first, second = (v if number.whole else number.rounded(v))[[0, -1]].tolist()
    y, steps = number.rounded(y, y_step), (x_step, y_step)
    return Table(x, y, had[0], had[1], had[2], (first, second), lines, steps=steps)


def fewest_points(target: Target, of: CamProfile) -> int:
    """Return the fewest points that do for a motion."""
    needed = 0 if target.spacing == "equal" else int(steps(target, of).sum()) + 1 + len(before_jumps(target, of))
    return max(target.points[0], needed)


def reread(target: Target, text: str, old: Table) -> Table:
    """Return the table that an independent reader gives of the file, with the written slopes where these go beside."""
    table = parse_table(text, target)
    return table if table.slopes or not old.slopes else replace(table, slopes=old.slopes)


@dataclass
class Tries:
    """The tables of an axis that were built for a target, by their number of points; no more than :data:`WORK`."""

    target: Target
    axis: CamAxis
    tables: dict[int, CertifiedTable] = field(default_factory=dict)
    spent: int = 0

    def of(self, n: int) -> CertifiedTable | None:
        """Return the table of n points at most with its certificate; None where the work is done."""
        if n not in self.tables:
            if self.spent > WORK:
                return None
            tried = certify_table(self.target, tabulate(self.target, self.axis, n), self.axis.profile)
            self.spent += (n + len(self.axis.profile.edges)) * len(tried.certificates)
            self.tables[n] = tried
        return self.tables[n]


def automatic(target: Target, axis: CamAxis, tolerance: Mapping[str, float]) -> CertifiedTable:
    """Return the table of the fewest points within the tolerance, else the best, of several that with right y and v."""
    tries = Tries(target, axis)
    best = search_table(tries, tolerance)
    if best.excess(tolerance) <= 1.0:
        return best
    for orders in range(max(map(ORDERS.index, tolerance)), 0, -1):
        lower = {
            order: tolerance.get(order) or min(most for name, most in tolerance.items() if ORDERS.index(name) > k)
            for k, order in enumerate(ORDERS[:orders])
        }
        other = search_table(tries, lower)
        lost = max(best.share(order) for order in tolerance) >= LOST
        keeps = other.excess(tolerance) * BETTER <= best.excess(tolerance)
        if other.excess(lower) < best.excess(lower) and (lost or keeps):
            best = other
        if best.excess(lower) <= 1.0:
            break
    return best


def candidates(tries: Tries, tolerance: Mapping[str, float]) -> Iterator[CertifiedTable]:
    """Yield tables of more and more points: the more of them, the farther each is from what is tolerated."""
    target, of = tries.target, tries.axis.profile
    if target.counts:
        yield from filter(None, map(tries.of, target.counts))
        return
    equal = target.spacing == "equal"
    n, most = fewest_points(target, of), min(target.points[1], MOST_EQUAL if equal else MOST_TRIED)
    n = max(n, min(len(of.edges), most)) if equal else n
    while n <= most and (certified := tries.of(n)):
        yield certified
        growth = min(max(certified.excess(tolerance) ** 0.5, GROWTH[0]), GROWTH[1])
        n = min(max(n + 1, int(n * growth)), most) if n < most else most + 1


def search_table(tries: Tries, tolerance: Mapping[str, float]) -> CertifiedTable:
    """Return the table of the fewest points that keeps to the tolerance, or the first that comes nearest."""
    target = tries.target
    best: CertifiedTable | None = None
    before, idle = 0, 0
    for certified in candidates(tries, tolerance):
        # between it and that before, to a hundredth of the points
        if certified.excess(tolerance) <= 1.0:
            low, high = max(before, fewest_points(target, tries.axis.profile) - 1), certified.points
            while high - low > max(1, high // COARSE) and not target.counts and (middle := tries.of((low + high) // 2)):
                if middle.excess(tolerance) <= 1.0:
                    certified, high = middle, (low + high) // 2
                else:
                    low = (low + high) // 2
            return certified
        idle += 1
        if best is None or certified.excess(tolerance) < BETTER * best.excess(tolerance):
            best, idle = certified, 0
        # equal steps miss the breaks by luck: each try may be better
        if idle == IDLE and target.spacing != "equal":
            break
        before = certified.points
    if best is None:
        message = f"{tries.axis.name} has breaks for {fewest_points(target, tries.axis.profile)} points"
        raise TargetError(f"{target.name}: {message}; at most {target.points[1]} fit")
    return best


def curve(target: Target, axis: CamAxis) -> list[CertifiedTable]:
    """Return tables from the fewest points to the most that are tried, for a picture."""
    low, high = fewest_points(target, axis.profile), min(target.points[1], MOST_TRIED)
    if low > high:
        return []
    counts = target.counts or dict.fromkeys(round(n) for n in np.geomspace(low, high, DRAWN))
    return [certify_table(target, tabulate(target, axis, n), axis.profile) for n in counts]
