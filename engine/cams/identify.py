"""Which phases a table of points was made of: dwells, and the simplest law that each movement keeps to."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.given import AT_SPEED, LONGER, Points, may_be, moves_at, part, seam
from engine.cams.joined import RATES, grown, joined
from engine.cams.profile import CamProfile, turned
from engine.cams.splined import dense, rate_of, splined
from engine.laws import Law, PieceLaw, law
from engine.laws.ends import EndedLaw
from engine.laws.registry import CATALOGUE
from engine.laws.spline import Spline

ROUNDED = 1e-9
"""of the reach: what a fit may miss by whatever the data's precision is"""
TURNS = 12  # of Gauss and Newton
SETTLED, SLOW = 3, 0.5
"""after so many turns the residual must have fallen to so much of itself, or it is another law"""
MOST_WAYS = 24
"""from turn to turn of a movement: more phases has no composed motion"""
FEWEST = 6  # points of positions alone, of which a law has four figures of its own
DIGITS = (0, 1, 2, 3, 4, 5, 6, 8)  # to which a begin or an end is rounded, where it still fits
THINNED = 1e-4
"""of the reach: so far a spline may be from points that keep to no law"""


@dataclass(frozen=True)
class Found:
    """A phase that was found: a law from x to x and from y by a lift, and how far the table is from it at most.

    It is ``known`` if it is a law of the registry, and no spline through the points; ``fits`` if it does at all.
    """

    law: Law
    begin: float
    end: float
    y: float
    lift: float
    residual: float
    fits: bool = True
    known: bool = True

    @property
    def rates(self) -> tuple[float, float]:
        """Rates y' and y'' at its begin, where its ends are prescribed; else 0."""
        return self._prescribed(0)

    @property
    def leaves(self) -> tuple[float, float]:
        """Rates y' and y'' at its end, where its ends are prescribed; else 0."""
        return self._prescribed(1)

    def _prescribed(self, side: int) -> tuple[float, float]:
        span = self.end - self.begin
        if isinstance(self.law, Spline):
            return (self.law.slopes[side] or 0.0) * self.lift / span, 0.0
        if not isinstance(self.law, EndedLaw):
            return 0.0, 0.0
        return self.law.ends.both("v")[side] / span, self.law.ends.both("a")[side] / span**2

    @property
    def rests(self) -> bool:
        """Whether it begins and ends at rest."""
        at = self.law.start, self.law.end
        return all(abs(one.v) <= 1e-6 * self.law.coefficients.cv for one in at)


class Read(NamedTuple):
    """The phases of a table, and by how much the cycle that they are told in begins later than the table."""

    found: list[Found]
    late: float = 0.0


class _Fit(NamedTuple):
    begin: float
    end: float
    y: float
    lift: float


def movements(of: Points) -> list[tuple[int, int]]:
    """Return from which to which point a table moves, dwells left out."""
    still = dwelling(of)
    found = grown([not one for one in still])
    return [(begin, end) for begin, end in found if np.ptp(of.y[begin : end + 1]) > 0.0]


def dwelling(of: Points) -> list[bool]:
    """Return which intervals are dwells."""
    still = np.abs(np.diff(of.y)) <= 2.0 * of.precision
    return [bool(one) and _dwells(of, still, k) for k, one in enumerate(still.tolist())]


def _dwells(of: Points, still: NDArray[np.bool_], k: int) -> bool:
    """Whether the interval between two equal points is a dwell, and no turn between them."""
    if of.v is not None:
        size = np.abs(np.diff(of.y) / np.diff(of.x)).max()
        return bool(max(abs(of.v[k]), abs(of.v[k + 1])) <= RATES * size)
    beside = [i for i in (k - 1, k + 1) if 0 <= i < len(still)]
    h = np.diff(of.x)
    return any(still[i] for i in beside) or all(h[k] > LONGER * h[i] for i in beside)


def _one_way(of: Points, begin: int, end: int) -> list[tuple[int, int]]:
    """Return a part of a movement divided where it turns."""
    turns, before = [], 0.0
    for k, step in enumerate(np.diff(of.y[begin : end + 1]).tolist(), begin):
        if abs(step) > 2.0 * of.precision:
            if step * before < 0.0:
                turns.append(k)
            before = step
    return list(pairwise([begin, *turns, end]))


def identified(of: Points, rebuilt: CamProfile, turns: bool = False, share: float = THINNED) -> Read:
    """Return the movements of a table with the first law of the registry that each keeps to, in order.

    What does not move from rest to rest is told as phases that meet at speed. What keeps to no law is a spline through
    few of the points, no farther from the others than a share of the reach; it does not fit where that takes too many.
    Where a cycle begins on the way and ``turns`` allows it, it is told from its first dwell at 0 on.
    """
    of = of._replace(thinned=share * float(np.ptp(of.y)))
    begins, ends = (moves_at(of, side) for side in (0, -1))
    home = next((k for k, rests in enumerate(dwelling(of)) if rests and abs(of.y[k]) <= _near(of)), None)
    if turns and begins and ends and home is not None:
        found = phases(rolled(of, home), turned(rebuilt, float(of.x[-1] - of.x[home])))
        if all(one.fits and one.rests for one in found):
            return Read(found, float(of.x[home] - of.x[0]))
    across = seam(of) if begins and ends else None
    return Read(phases(of._replace(begins=begins, ends=ends, seam=across), rebuilt))


def phases(of: Points, rebuilt: CamProfile) -> list[Found]:
    """Return the phases of each movement of a table."""
    laws = [entry.example() for entry in CATALOGUE if entry.rises and entry.law is not PieceLaw]
    found: list[Found] = []
    for span in movements(of):
        edges = _one_way(of, *span)
        last = len(edges) - 1
        tried = laws if last < MOST_WAYS else []
        resting = [_identify(of, tried, edge, (k > 0, k < last)) for k, edge in enumerate(edges)]
        laid = [one for one in resting if one]
        if len(laid) < len(resting):
            laid = _laid(of, rebuilt, span, edges, resting)
        found += laid
    return found


def _laid(
    of: Points, rebuilt: CamProfile, span: tuple[int, int], edges: Sequence[tuple[int, int]],
    resting: Sequence[Found | None],
) -> list[Found]:  # fmt: skip
    """Return the phases of a movement some of whose ways from rest to rest keep to no law."""
    whole = part(of, *span)
    meeting, known = joined(whole, rebuilt, _near(whole))
    if not known and any(resting):
        told = [[one] if one else _thinned(part(of, *edge), rebuilt) for one, edge in zip(resting, edges, strict=True)]
        if all(told):
            return [one for each in told for one in each]
    if meeting:
        return [Found(*one, known=one.law.code != Spline.code) for one in meeting]
    fit = _Fit(float(whole.x[0]), float(whole.x[-1]), float(whole.y[0]), float(np.ptp(whole.y)))
    return [Found(law("PO5"), *fit, _residual(law("PO5"), whole, fit), fits=False, known=False)]


def _thinned(of: Points, rebuilt: CamProfile) -> list[Found]:
    """Return splines from rest to rest through few points; none where it does not rest, or too many are needed."""
    rate = rate_of(rebuilt)
    slow = AT_SPEED * float(np.abs(np.diff(of.y) / np.diff(of.x)).max())
    if max(abs(rate(float(of.x[0]))), abs(rate(float(of.x[-1])))) > slow:
        return []
    made = splined(dense(of, rebuilt), (0.0, 0.0), rate, max(of.thinned, _near(of)))
    return [Found(*one, known=False) for one in made]


def rolled(of: Points, k: int) -> Points:
    """Return the table of a cycle that is told from its point ``k`` on, over the same x."""
    total, travel = float(of.x[-1] - of.x[0]), float(of.y[-1] - of.y[0])
    by = total - float(of.x[k] - of.x[0])
    x = np.concatenate([of.x[k:-1] + by - total, of.x[: k + 1] + by])
    y = np.concatenate([of.y[k:-1], of.y[: k + 1] + travel])
    v, a = (None if one is None else np.concatenate([one[k:-1], one[: k + 1]]) for one in (of.v, of.a))
    return of._replace(x=x, y=y, v=v, a=a)


def _identify(
    of: Points, laws: Sequence[Law], span: tuple[int, int], turns: tuple[bool, bool]
) -> Found | None:  # fmt: skip
    """Return the law of a movement between two points, if it keeps to one; a turn's point may belong to the next."""
    for late, early in ((0, 0), (turns[0], 0), (0, turns[1]), turns):
        inner = part(of, span[0] + late, span[1] - early)
        if len(inner.x) >= FEWEST or (inner.a is not None and len(inner.x) > 1):
            for one in laws:
                fit = _fitted(one, inner, _near(inner)) if may_be(one, inner) else None
                if fit is not None:
                    return Found(one, *fit, residual=_residual(one, inner, fit))
    return None


def _near(of: Points) -> float:
    """Return what a fit may miss by."""
    return max(2.0 * of.precision, ROUNDED * float(np.ptp(of.y)))


def _fitted(law: Law, of: Points, near: float) -> _Fit | None:
    """Return a law's begin, end, y and lift by least squares, in round numbers where these do; None if it misses."""
    fit = _Fit(float(of.x[0]), float(of.x[-1]), float(of.y[0]), float(of.y[-1] - of.y[0]))
    step = float(np.diff(of.x).max())
    missed = [_residual(law, of, fit)]
    while missed[-1] > near and len(missed) <= TURNS:
        if len(missed) > SETTLED and missed[-1] > SLOW * missed[-SETTLED]:
            return None
        fit = _improved(law, of, fit, step)
        if fit.end - fit.begin < step:
            return None
        missed.append(_residual(law, of, fit))
    if missed[-1] > near or _beyond(of, fit) or not _rates_agree(law, of, fit):
        return None
    for digits in DIGITS:
        tidy = _Fit(*(round(value, digits) + 0.0 for value in fit))
        if tidy.end > tidy.begin and _residual(law, of, tidy) <= near:
            return tidy
    return fit


def _beyond(of: Points, fit: _Fit) -> bool:
    """Whether a movement from rest to rest would begin or end where the table is none."""
    near = ROUNDED * (fit.end - fit.begin)
    return (of.begins and fit.begin < of.x[0] - near) or (of.ends and fit.end > of.x[-1] + near)


def _improved(law: Law, of: Points, fit: _Fit, step: float) -> _Fit:
    span = fit.end - fit.begin
    xi = np.clip((of.x - fit.begin) / span, 0.0, 1.0)
    at = law.evaluate(xi)
    inside = (xi > 0.0) & (xi < 1.0)
    slopes = np.where(inside, fit.lift * at.v / span, 0.0)
    columns = np.column_stack([slopes * (xi - 1.0), -slopes * xi, np.ones_like(xi), at.s])
    moved = np.linalg.lstsq(columns, of.y - (fit.y + fit.lift * at.s), rcond=1e-12)[0]
    return _Fit(*(value + float(np.clip(by, -step, step)) if k < 2 else value + float(by)
                  for k, (value, by) in enumerate(zip(fit, moved, strict=True))))  # fmt: skip


def _residual(law: Law, of: Points, fit: _Fit) -> float:
    xi = np.clip((of.x - fit.begin) / (fit.end - fit.begin), 0.0, 1.0)
    return float(np.abs(fit.y + fit.lift * law.s(xi) - of.y).max())


def _rates_agree(law: Law, of: Points, fit: _Fit) -> bool:
    """Whether y' and y'' of a table, within the movement, are the law's, where the table has them."""
    span = fit.end - fit.begin
    at = law.evaluate(np.clip((of.x - fit.begin) / span, 0.0, 1.0))
    inner = slice(0, -1)  # what a table has at a place is what follows there
    for given, meant, per in ((of.v, at.v, fit.lift / span), (of.a, at.a, fit.lift / span**2)):
        if given is not None:
            off = np.abs(given[inner] - per * meant[inner])
            if (
                np.median(off) > RATES * np.abs(per * meant).max()
                or (off > RATES * np.abs(per * meant).max()).mean() > 0.5
            ):
                return False
    return True
