"""Phases that meet at speed, taken apart: straight lines, laws with prescribed ends, splines for what is left."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.cams.given import LONGER, SEAM, Points, fastest, may_be, part, precision, rate_at
from engine.cams.profile import CamProfile
from engine.cams.splined import dense, rate_of, splined
from engine.laws import Law, law
from engine.laws.base import Array
from engine.laws.ends import EndedLaw, EndError, Ends, between
from engine.laws.registry import CATALOGUE

SHORTEST = 3  # ways from point to point of a straight line, where y' is not known
TURNS = 12  # of Gauss and Newton
RATES = 1e-5  # of the peak: so far a law's velocity and acceleration may be from a table's
STEP = 1e-4  # of the interval between points, to see how a break's place matters
MOST = 8
"""quintics in place of a part that is one law no longer"""


class Side(NamedTuple):
    """A line that a curved phase meets, y and y' at ``x``; ``fixed`` where it meets nothing, at that x alone."""

    x: float
    y: float
    v: float
    a: float = 0.0
    fixed: bool = False

    def at(self, x: float) -> float:
        """Return y of the line."""
        return self.y + self.v * (x - self.x)


class Ended(NamedTuple):
    """A phase: a law with its ends from x to x and from y by a lift, and how far the points are from it."""

    law: Law
    begin: float
    end: float
    y: float
    lift: float
    residual: float

    @property
    def scale(self) -> float:
        """What the law's s is multiplied by: 1 where the law has the lift in itself."""
        return 1.0 if isinstance(self.law, EndedLaw) and not self.law.ends.at_rest else self.lift


def joined(of: Points, rebuilt: CamProfile, near: float) -> tuple[list[Ended], bool]:
    """Return the phases of a movement between rests, or from a table's begin or to its end, that meet at speed.

    The other is whether each is a line or a law as it is meant.

    Where a part between lines keeps to no law, it is parted into quintics with y' and y'' where they meet, or if a
    few of these do not do, into splines. Empty where even so there would be too many.
    """
    found: list[Ended] = []
    known = True
    runs = straight_runs(of, near)
    edges = [0, *(k for run in runs for k in run), len(of.x) - 1]
    for k, (begin, end) in enumerate(pairwise(edges)):
        if begin == end:
            continue
        if k % 2:
            found.append(line(of, begin, end))
            continue
        sides = beside(of, rebuilt, runs, begin), beside(of, rebuilt, runs, end)
        inner = part(of, begin, end)
        one = curved(inner, sides, near)
        made = [one] if one else run(inner, rebuilt, sides, near) or splines(inner, rebuilt, sides, near)
        if not made:
            return [], False
        known &= one is not None
        found += made
    return settled(found), known


def settled(found: Sequence[Ended]) -> list[Ended]:
    """Return phases whose lines begin and end where their neighbours do."""
    kept = list(found)
    for k, one in enumerate(found):
        if one.law.code == "LIN":
            begin = kept[k - 1].end if k else one.begin
            end = found[k + 1].begin if k + 1 < len(found) else one.end
            slope = one.lift / (one.end - one.begin)
            lift = slope * (end - begin)
            kept[k] = one._replace(begin=begin, end=end, y=one.y + slope * (begin - one.begin), lift=lift)
    return kept


def straight_runs(of: Points, near: float) -> list[tuple[int, int]]:
    """Return from which to which point a table runs along lines."""
    x, y = of.x, of.y
    slope = np.diff(y) / np.diff(x)
    size = float(np.abs(slope).max())
    if of.v is not None:
        off = np.maximum(np.abs(of.v[:-1] - slope), np.abs(of.v[1:] - slope))
        flat = off <= 1e-9 * size + np.minimum(4.0 * near / np.diff(x), RATES * size)
        return [(k, k + 1) for k in np.flatnonzero(flat).tolist()] if flat.sum() < 2 else grown(flat.tolist())
    bend = np.abs(y[1:-1] - (y[:-2] + (y[2:] - y[:-2]) * (x[1:-1] - x[:-2]) / (x[2:] - x[:-2]))) <= near
    flat = np.zeros(len(slope), dtype=np.bool_)
    for k in np.flatnonzero(bend).tolist():
        flat[k : k + 2] = True
    return [run for run in grown(flat.tolist()) if run[1] - run[0] >= SHORTEST or sparse(x, *run)]


def sparse(x: Array, begin: int, end: int) -> bool:
    """Whether the points of a line are so far apart beside its neighbours' that no curve could pass for it there."""
    h = np.diff(x)
    beside = [float(h[k]) for k in (begin - 1, end) if 0 <= k < len(h)]
    return bool(beside) and float(h[begin:end].min()) > LONGER * max(beside)


def grown(flat: Sequence[bool]) -> list[tuple[int, int]]:
    """Return from which to which point intervals that follow one another are flat."""
    found: list[tuple[int, int]] = []
    begin: int | None = None
    for k, one in enumerate([*flat, False]):
        if one and begin is None:
            begin = k
        elif not one and begin is not None:
            found.append((begin, k))
            begin = None
    return found


def line(of: Points, begin: int, end: int) -> Ended:
    """Return a straight line between two points."""
    lift = float(of.y[end] - of.y[begin])
    return Ended(law("LIN"), float(of.x[begin]), float(of.x[end]), float(of.y[begin]), lift, 0.0)


def beside(of: Points, rebuilt: CamProfile, runs: Sequence[tuple[int, int]], k: int) -> Side:
    """Return what a curved phase meets at a point: a line, a rest, or at an end of the table what it has there."""
    for begin, end in runs:
        if k in (begin, end):
            slope = float((of.y[end] - of.y[begin]) / (of.x[end] - of.x[begin]))
            return Side(float(of.x[k]), float(of.y[k]), slope)
    place = Side(float(of.x[k]), float(of.y[k]), 0.0)
    if not ((k == 0 and of.begins) or (k == len(of.x) - 1 and of.ends)):
        return place
    free = rates(of, rebuilt, k)._replace(fixed=True)
    across = line_across(of, runs, k)
    return free._replace(v=across, a=0.0) if abs(across - free.v) <= SEAM * fastest(of) else free


def line_across(of: Points, runs: Sequence[tuple[int, int]], k: int) -> float:
    """Return the slope of the line that a table ends with at its begin, or begins with at its end; infinity of none."""
    last = len(of.x) - 1
    for begin, end in runs:
        if of.begins and of.ends and (end == last if k == 0 else begin == 0):
            return float((of.y[end] - of.y[begin]) / (of.x[end] - of.x[begin]))
    return np.inf


def rates(of: Points, rebuilt: CamProfile, k: int) -> Side:
    """Return y, y' and y'' at a point: the table's own, or those of what rebuilds it."""
    place = of.x[k : k + 1]
    last = k == len(of.x) - 1
    if (of.begins and k == 0) or (of.ends and last):
        return Side(float(place[0]), float(of.y[k]), *(of.seam or rate_at(of, -1 if last else 0)))
    at = rebuilt.at(place, left=last)
    v = float(at.y1[0]) if of.v is None else float(of.v[k])
    a = float(at.y2[0]) if of.a is None else float(of.a[k])
    return Side(float(place[0]), float(of.y[k]), v, a)


def curved(of: Points, sides: tuple[Side, Side], near: float) -> Ended | None:
    """Return the first law of the registry, with the ends that its neighbours ask for, that keeps to the points."""
    for one in ending():
        found = fitted(one, of, sides, near) if may_be(one, of) else None
        if found is not None:
            return found
    return None


def ending() -> Iterator[EndedLaw]:
    """Yield the laws that can meet a neighbour at speed."""
    for entry in CATALOGUE:
        one = entry.example()
        if isinstance(one, EndedLaw):
            yield one


def made(one: EndedLaw, places: tuple[float, float], sides: tuple[Side, Side]) -> Ended | None:
    """Return a law between two places, with the velocities of its sides; None where it cannot have these."""
    begin, end = places
    first, last = (side.y if side.fixed else side.at(x) for side, x in zip(sides, places, strict=True))
    d = end - begin
    takes = "a" in one.takes
    a0, a1 = (side.a * d**2 if takes and side.fixed else 0.0 for side in sides)
    if d <= 0.0:
        return None
    try:
        found, _ = between(one, Ends(last - first, sides[0].v * d, sides[1].v * d, a0, a1))
    except EndError:
        return None
    return Ended(found, begin, end, first, last - first, 0.0)


def off(one: Ended | None, of: Points) -> Array:
    """Return by how much points are off a phase, or the line that it meets beyond its end."""
    if one is None:
        return np.full(len(of.x), np.inf)
    d = one.end - one.begin
    xi = (of.x - one.begin) / d
    at = one.law.evaluate(np.clip(xi, 0.0, 1.0))
    v0, v1 = one.scale * one.law.start.v, one.scale * one.law.end.v
    beyond = np.where(xi < 0.0, v0 * xi, np.where(xi > 1.0, v1 * (xi - 1.0), 0.0))
    return np.asarray(one.y + one.scale * at.s + beyond - of.y)


def fitted(one: EndedLaw, of: Points, sides: tuple[Side, Side], near: float) -> Ended | None:
    """Return a law with its begin and its end where the points want them, by least squares; None if it misses."""
    places = float(of.x[0]), float(of.x[-1])
    step = np.diff(of.x)[[0, -1]]
    free = [k for k in (0, 1) if not sides[k].fixed]
    for _ in range(TURNS):
        found = made(one, places, sides)
        missed = off(found, of)
        if not np.all(np.isfinite(missed)):
            return None
        if found and np.abs(missed).max() <= near:
            return found._replace(residual=float(np.abs(missed).max())) if rates_agree(found, of) else None
        if not free or len(of.x) < len(free) + 2:
            return None
        slopes = []
        for k in free:
            h = STEP * float(step[k])
            moved = (places[0] + h, places[1]) if k == 0 else (places[0], places[1] + h)
            slopes.append((off(made(one, moved, sides), of) - missed) / h)
        by = np.linalg.lstsq(np.column_stack(slopes), -missed, rcond=1e-12)[0]
        both = list(places)
        for k, value in zip(free, by.tolist(), strict=True):
            both[k] += float(np.clip(value, -step[k], step[k]))
        places = both[0], both[1]
        if abs(places[0] - of.x[0]) > 2.0 * step[0] or abs(places[1] - of.x[-1]) > 2.0 * step[1]:
            return None
    return None


def rates_agree(one: Ended, of: Points) -> bool:
    """Whether y' and y'' of the points are the phase's, where the table has them; y'' at its end is the next one's."""
    d = one.end - one.begin
    at = one.law.evaluate(np.clip((of.x - one.begin) / d, 0.0, 1.0))
    per, peaks = one.scale / d, one.law.coefficients
    for given, meant, most in ((of.v, per * at.v, per * peaks.cv), (of.a, per / d * at.a, per / d * peaks.ca)):
        if given is not None:
            near = max(RATES * abs(most), 2.0 * precision(given))
            if np.abs(given - meant)[:-1].max() > near:
                return False
    return True


def splines(of: Points, rebuilt: CamProfile, sides: tuple[Side, Side], near: float) -> list[Ended]:
    """Return splines that keep to the points as far as these are thinned; none where too many would be needed."""
    slopes = sides[0].v, sides[1].v
    return [Ended(*one) for one in splined(dense(of, rebuilt), slopes, rate_of(rebuilt), max(of.thinned, near))]


def run(of: Points, rebuilt: CamProfile, sides: tuple[Side, Side], most: float) -> list[Ended]:
    """Return polynomials of degree 5 from point to point, at most :data:`MOST`."""
    quintic = next(one for one in ending() if one.code == "PO5")
    found: list[Ended] = []
    k, last = 0, len(of.x) - 1
    here = sides[0]
    while k < last:
        low, high, best = k, last, None
        while high > low:
            middle = high if best is None and high == last else (low + high + 1) // 2
            there = sides[1] if middle == last else rates(of, rebuilt, middle)
            ends = here._replace(fixed=True), there._replace(fixed=True)
            inner = part(of, k, middle)
            one = made(quintic, (here.x, there.x), ends)
            missed = float(np.abs(off(one, inner)).max())
            if one is not None and missed <= most:
                best, low = (one._replace(residual=missed), there), middle
            else:
                high = middle - 1
        if best is None or len(found) == MOST:
            return []
        found.append(best[0])
        k, here = low, best[1]
    return found
