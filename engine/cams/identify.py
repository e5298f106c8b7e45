"""Which phases a table of points was made of: dwells, and the simplest law that each movement keeps to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.course import Course, turned
from engine.cams.given import Points, may_be, moves_at, part
from engine.cams.joined import RATES, grown, joined
from engine.cams.points import equal
from engine.cams.segments import quintics_between
from engine.laws import Law, Piece, PieceLaw
from engine.laws.base import Array
from engine.laws.ends import EndedLaw
from engine.laws.registry import CATALOGUE

ROUNDED = 1e-9
"""of the reach: what a fit may miss by whatever the data's precision is"""
TURNS = 12  # of Gauss and Newton
LONGER = 2.0  # times its neighbours: an interval between two equal points is a dwell
DIGITS = (3, 4, 5, 6, 8)  # to which a begin or an end is rounded, where it still fits
MOST_PIECES = 40


@dataclass(frozen=True)
class Found:
    """A phase that was found: a law from x to x and from y by a lift, and how far the table is from it at most."""

    law: Law
    begin: float
    end: float
    y: float
    lift: float
    residual: float
    fits: bool = True

    @property
    def rates(self) -> tuple[float, float]:
        """y' and y'' at its begin, where its ends are prescribed; else 0."""
        return self._prescribed(0)

    @property
    def leaves(self) -> tuple[float, float]:
        """y' and y'' at its end, where its ends are prescribed; else 0."""
        return self._prescribed(1)

    def _prescribed(self, side: int) -> tuple[float, float]:
        if not isinstance(self.law, EndedLaw):
            return 0.0, 0.0
        span = self.end - self.begin
        return self.law.ends.asked("v")[side] / span, self.law.ends.asked("a")[side] / span**2

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
    """Return a stretch of movement parted where it turns."""
    turns, before = [], 0.0
    for k, step in enumerate(np.diff(of.y[begin : end + 1]).tolist(), begin):
        if abs(step) > 2.0 * of.precision:
            if step * before < 0.0:
                turns.append(k)
            before = step
    return list(pairwise([begin, *turns, end]))


def identified(of: Points, rebuilt: Course, turns: bool = False) -> Read:
    """Return the movements of a table with the first law of the registry that each keeps to, in order.

    What does not move from rest to rest is told as phases that meet at speed. A movement that keeps to no law is an own
    law of what rebuilds it, thinned to the data's precision, or a run of quintics; it does not fit where that takes
    too many pieces. Where a cycle begins on the way and ``turns`` allows it, it is told from its
    first dwell at 0 on.
    """
    begins, ends = (moves_at(of, side) for side in (0, -1))
    home = next((k for k, rests in enumerate(dwelling(of)) if rests and abs(of.y[k]) <= _near(of)), None)
    if turns and begins and ends and home is not None:
        found = phases(rolled(of, home), turned(rebuilt, float(of.x[-1] - of.x[home])))
        if all(one.fits and not isinstance(one.law, PieceLaw) and one.rests for one in found):
            return Read(found, float(of.x[home] - of.x[0]))
    return Read(phases(of._replace(begins=begins, ends=ends), rebuilt))


def phases(of: Points, rebuilt: Course) -> list[Found]:
    """Return the phases of each movement of a table."""
    laws = [entry.example() for entry in CATALOGUE if entry.rises and entry.law is not PieceLaw]
    found: list[Found] = []
    for span in movements(of):
        edges = _one_way(of, *span)
        last = len(edges) - 1
        resting = [_identify(of, rebuilt, laws, edge, (k > 0, k < last)) for k, edge in enumerate(edges)]
        if all(not isinstance(one.law, PieceLaw) for one in resting):
            found += resting
            continue
        whole = part(of, *span)
        meeting, known = joined(whole, rebuilt, _near(whole))
        wanted = known or not all(one.fits for one in resting)
        found += [Found(*one, True) for one in meeting] if meeting and wanted else resting
    return found


def rolled(of: Points, k: int) -> Points:
    """Return the table of a cycle that is told from its point ``k`` on, over the same x."""
    total, travel = float(of.x[-1] - of.x[0]), float(of.y[-1] - of.y[0])
    by = total - float(of.x[k] - of.x[0])
    x = np.concatenate([of.x[k:-1] + by - total, of.x[: k + 1] + by])
    y = np.concatenate([of.y[k:-1], of.y[: k + 1] + travel])
    v, a = (None if one is None else np.concatenate([one[k:-1], one[: k + 1]]) for one in (of.v, of.a))
    return of._replace(x=x, y=y, v=v, a=a)


def _identify(
    of: Points, rebuilt: Course, laws: Sequence[Law], span: tuple[int, int], turns: tuple[bool, bool]
) -> Found:  # fmt: skip
    """Return the law of a movement between two points; one at which it turns may belong to the next."""
    for late, early in ((0, 0), (turns[0], 0), (0, turns[1]), turns):
        inner = part(of, span[0] + late, span[1] - early)
        if len(inner.x) >= 4 or (inner.a is not None and len(inner.x) > 1):
            for one in laws:
                fit = _fitted(one, inner, _near(inner)) if may_be(one, inner) else None
                if fit is not None:
                    return Found(one, *fit, residual=_residual(one, inner, fit))
    whole = part(of, *span)
    return _own(whole, rebuilt, _near(whole))


def _near(of: Points) -> float:
    """Return what a fit may miss by."""
    return max(2.0 * of.precision, ROUNDED * float(np.ptp(of.y)))


def _fitted(law: Law, of: Points, near: float) -> _Fit | None:
    """Return a law's begin, end, y and lift by least squares, in round numbers where these do; None if it misses."""
    fit = _Fit(float(of.x[0]), float(of.x[-1]), float(of.y[0]), float(of.y[-1] - of.y[0]))
    step = float(np.diff(of.x).max())
    for _ in range(TURNS):
        if _residual(law, of, fit) <= near:
            break
        fit = _improved(law, of, fit, step)
        if fit.end - fit.begin < step:
            return None
    if _residual(law, of, fit) > near or not _rates_agree(law, of, fit):
        return None
    for digits in DIGITS:
        tidy = _Fit(*(round(value, digits) + 0.0 for value in fit))
        if tidy.end > tidy.begin and _residual(law, of, tidy) <= near:
            return tidy
    return fit


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


def _own(of: Points, rebuilt: Course, near: float) -> Found:
    """Return an own law of polynomials of degree 5, as few as keep to the points."""
    begin, end = float(of.x[0]), float(of.x[-1])
    lift, span = float(of.y[-1] - of.y[0]), float(of.x[-1] - of.x[0])
    inner = Course(np.array([begin, end]), rebuilt.origins[:1], rebuilt.c[:1], rebuilt.sines[:1])
    at = [rebuilt.at(np.array([begin])), rebuilt.at(np.array([end]), left=True)]
    best: Found | None = None
    for n in range(2, MOST_PIECES + 2):
        x = of.x if n > len(of.x) else equal(inner, n)
        law = _law_of(rebuilt, x, float(at[0].y[0]), lift, span)
        fit = _Fit(begin, end, float(of.y[0]), lift)
        missed = _residual(law, of, fit)
        rests = max(abs(law.end.v), abs(float(at[0].y1[0]) * span / lift)) <= 1e-6
        if best is None or missed < best.residual:
            best = Found(law, *fit, missed, rests and missed <= near)
        if best.fits or n > len(of.x):
            break
    if best is None:
        raise ValueError("a movement has no points; expected two or more")
    return best


def _law_of(rebuilt: Course, x: Array, y: float, lift: float, span: float) -> PieceLaw:
    """Return what rebuilds a movement as an own law, over places."""
    after, before = rebuilt.at(x), rebuilt.at(x, left=True)
    begin, end = ([(one.y - y) / lift, one.y1 * span / lift, one.y2 * span**2 / lift] for one in (after, before))
    xi = (x - x[0]) / span
    c = quintics_between(xi, [one[:-1] for one in begin], [one[1:] for one in end])
    durations = np.diff(xi)
    return PieceLaw([Piece(float(d), (2.0 * row[2], 6.0 * row[3], 12.0 * row[4], 20.0 * row[5]))
                     for d, row in zip(durations, c.tolist(), strict=True)])  # fmt: skip
