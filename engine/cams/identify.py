"""Identification of the phases of a cam table: dwells, and the simplest law that each movement follows."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.cams.cam_points import AT_SPEED, LONGER, RATES, ROUNDED, CamPoints, FoundPhase, gauss_newton, splines
from engine.cams.moving_phases import phases_at_speed, true_runs
from engine.laws import CATALOGUE, Dwell, Law, PieceLaw, law
from engine.laws.base import Array, Flags
from engine.motion.profile import CamProfile

MOST_WAYS = 24  # strokes between reversals of a movement; with more of them no law is tried
FEWEST = 6  # points of positions alone, from which four figures of a phase can be fitted
KEPT = 3.0  # times the allowed error of a fit: so far phases, each fitted by itself, are off in succession
RESTS = 4.0  # length over the neighbours' from which equal points among such that creep are a dwell
# decimals to which a begin or an end is rounded, if it still fits
DIGITS = (0, 1, 2, 3, 4, 5, 6, 8)
THINNED = 1e-4  # share of the range: allowed error of a spline through points that follow no law


class IdentifiedMotion(NamedTuple):
    """The phases of a table over a cycle, in its units."""

    phases: list[FoundPhase]
    allowed: float  # deviation from the points at most
    delay: float = 0.0  # x by which the cycle begins later than the table


def identify(of: CamPoints, rebuilt: CamProfile, turns: bool = False, share: float = THINNED) -> IdentifiedMotion:
    """Return the movements of a table in order, each with the first law of the catalogue that it follows.

    A movement that is not from rest to rest becomes phases that meet at speed. One that follows no law becomes splines
    through few of the points; it does not fit if they are too many.

    Parameters
    ----------
    of : CamPoints
        The table, in any units of x and y.
    rebuilt : CamProfile
        The whole table by the controller's rule between points.
    turns : bool
        Whether a cycle that begins at speed is counted from its first dwell at 0.
    share : float, dimensionless
        Deviation of the splines from the other points at most, as a share of the range of y.
    """
    of = of._replace(thinned=share * float(np.ptp(of.y)))
    begins, ends = (of.moves_at(side) for side in (0, -1))
    if turns and begins and ends and (motion := _from_first_dwell(of, rebuilt)):
        return motion
    of = of._replace(begins=begins, ends=ends, seam=of.rates_across() if begins and ends else None)
    phases = _phases(of, rebuilt)
    if _keeps_to(of, phases):
        return IdentifiedMotion(phases, _tolerance(of))
    slopes = [of.rate_at(side)[0] if moves else 0.0 for side, moves in ((0, begins), (-1, ends))]
    through = splines(of, rebuilt, (slopes[0], slopes[1]), max(of.thinned, of.near))
    first, last, y, lift = (float(value) for value in (*of.x[[0, -1]], of.y[0], of.y[-1] - of.y[0]))
    line = FoundPhase(law("LIN"), first, last, y, lift, known=False)
    missed = [replace(phase, fits=False) for phase in phases or [line]]
    return IdentifiedMotion(through or missed, _tolerance(of))


def _from_first_dwell(of: CamPoints, rebuilt: CamProfile) -> IdentifiedMotion | None:
    """Return the movements of a cycle counted from its first dwell at 0; None unless each is from rest to rest."""
    home = np.flatnonzero(_dwelling(of) & (np.abs(of.y[:-1]) <= of.near))
    if not home.size:
        return None
    k = int(home[0])
    later = _rolled(of, k)
    phases = _phases(later, rebuilt.shifted(float(of.x[-1] - of.x[k])))
    if all(phase.fits and phase.rests for phase in phases) and _keeps_to(later, phases):
        return IdentifiedMotion(phases, _tolerance(of), float(of.x[k] - of.x[0]))
    return None


def motion_at(phases: Sequence[FoundPhase], x: Array, rest: float) -> Array:
    """Return the position at places by phases in succession; without phases it is ``rest`` everywhere."""
    y = np.full(len(x), phases[0].y if phases else rest)
    for phase in phases:
        xi = np.clip((x - phase.begin) / (phase.end - phase.begin), 0.0, 1.0)
        y += phase.scale * (phase.law.s(xi) - phase.law.start.s)
    return y


def _keeps_to(of: CamPoints, phases: Sequence[FoundPhase]) -> bool:
    """Return whether phases, in succession, go through every point of a table."""
    off = np.abs(motion_at(phases, of.x, float(of.y[0])) - of.y).max()
    return bool(off <= _tolerance(of))


def _tolerance(of: CamPoints) -> float:
    """Return by how much a motion may be off a table's points."""
    return max(of.thinned, KEPT * of.near)


def _dwelling(of: CamPoints) -> Flags:
    """Return whether each interval is a dwell: between equal points, and next to another such or long."""
    step = 2.0 * of.precision * (1.0 + ROUNDED)
    still = np.abs(np.diff(of.y)) <= step
    if of.v is not None:
        dwelling = still & (np.maximum(np.abs(of.v[:-1]), np.abs(of.v[1:])) <= RATES * of.fastest)
    else:
        h, beside = np.pad(np.diff(of.x), 1), np.pad(still, 1)
        longer = h[1:-1] > LONGER * np.maximum(h[:-2], h[2:])
        dwelling = still & (beside[:-2] | beside[2:] | longer)
    for begin, end in true_runs(dwelling):
        if np.ptp(of.y[begin : end + 1]) > step:
            dwelling[begin:end] = _resting(of.part(begin, end))
    return np.asarray(dwelling)


def _resting(of: CamPoints) -> Flags:
    """Return whether each interval is a dwell, of points that creep: if equal for much longer than beside."""
    level = np.abs(np.diff(of.y)) <= of.precision
    starts = np.concatenate([[0], np.flatnonzero(~level) + 1, [len(of.y) - 1]])
    lengths = np.pad(np.diff(of.x[starts]), 1)
    rests = lengths[1:-1] > RESTS * np.maximum(lengths[:-2], lengths[2:])
    return np.asarray(level & np.repeat(rests, np.diff(starts)))


def _rolled(of: CamPoints, k: int) -> CamPoints:
    """Return the table of a cycle that begins at its point ``k``, over the same x."""
    total, travel = float(of.x[-1] - of.x[0]), float(of.y[-1] - of.y[0])
    by = total - float(of.x[k] - of.x[0])
    x = np.concatenate([of.x[k:-1] + by - total, of.x[: k + 1] + by])
    y = np.concatenate([of.y[k:-1], of.y[: k + 1] + travel])
    v, a = (None if rates is None else np.concatenate([rates[k:-1], rates[: k + 1]]) for rates in (of.v, of.a))
    return of._replace(x=x, y=y, v=v, a=a)


def _phases(of: CamPoints, rebuilt: CamProfile) -> list[FoundPhase]:
    """Return the phases of each movement of a table."""
    laws = [family() for family in CATALOGUE if family not in (Dwell, PieceLaw)]
    laws = [some for some in laws if abs(some.start.v) <= AT_SPEED]  # of a stroke from rest to rest
    phases: list[FoundPhase] = []
    for begin, end in true_runs(~_dwelling(of)):
        if not np.ptp(of.y[begin : end + 1]):
            continue
        steps = np.diff(of.y[begin : end + 1])
        moving = np.flatnonzero(np.abs(steps) > 2.0 * of.precision)
        turns = moving[1:][steps[moving[1:]] * steps[moving[:-1]] < 0.0] + begin
        edges = list(pairwise([begin, *turns.tolist(), end]))
        last = len(edges) - 1
        tried = laws if last < MOST_WAYS else []
        resting = [_identify(of, tried, edge, (k > 0, k < last)) for k, edge in enumerate(edges)]
        laid = [phase for phase in resting if phase]
        phases += laid if len(laid) == len(resting) else _laid(of, rebuilt, edges, resting)
    return phases


def _laid(
    of: CamPoints, rebuilt: CamProfile, edges: Sequence[tuple[int, int]], resting: Sequence[FoundPhase | None]
) -> list[FoundPhase]:
    """Return the phases of a movement of which some strokes from rest to rest follow no law."""
    whole = of.part(edges[0][0], edges[-1][1])
    meeting, known = phases_at_speed(whole, rebuilt)
    if not known and any(resting):
        strokes = zip(resting, edges, strict=True)
        parts = [[phase] if phase else _by_itself(of.part(*edge), rebuilt) for phase, edge in strokes]
        if all(parts):
            return [phase for phases in parts for phase in phases]
    if meeting:
        return meeting
    quintic = _phase_of(law("PO5"), whole, np.array([*whole.x[[0, -1]], whole.y[0], np.ptp(whole.y)]))
    return [replace(quintic, fits=False, known=False)]


def _by_itself(of: CamPoints, rebuilt: CamProfile) -> list[FoundPhase]:
    """Return the phases of a stroke between others from rest to rest: lines and laws, or splines through few points.

    There are none if it follows no law and its ends are not at rest, or too many points are needed.
    """
    phases, known = phases_at_speed(of, rebuilt)
    if known or np.abs(rebuilt.at(of.x[[0, -1]]).y1).max() > AT_SPEED * of.fastest:
        return phases if known else []
    return splines(of, rebuilt, (0.0, 0.0), max(of.thinned, of.near))


def _identify(of: CamPoints, laws: Sequence[Law], span: tuple[int, int], turns: tuple[bool, bool]) -> FoundPhase | None:
    """Return the law that a movement between two points follows, or None; the point at a reversal may be left out."""
    for late, early in ((0, 0), (turns[0], 0), (0, turns[1]), turns):
        inner = of.part(span[0] + late, span[1] - early)
        if len(inner.x) >= FEWEST or (inner.a is not None and len(inner.x) > 1):
            for law in laws:
                fitted = _fit_law(law, inner) if inner.identifies(law) else None
                if fitted is not None:
                    return fitted
    return None


def _fit_law(law: Law, of: CamPoints) -> FoundPhase | None:
    """Return a law with begin, end, y and lift by least squares, in round numbers if they fit; None if none fits."""
    step = float(np.diff(of.x).max())

    def off(fit: Array) -> Array:
        return FoundPhase(law, *fit.tolist()).off(of) if fit[1] - fit[0] >= step else np.full(len(of.x), np.inf)

    start = np.array([*of.x[[0, -1]], of.y[0], of.y[-1] - of.y[0]])
    fit = gauss_newton(off, start, np.array([step, step, np.inf, np.inf]), of.near)
    if fit is None:
        return None
    beyond = ROUNDED * (fit[1] - fit[0])
    outside = (of.begins and fit[0] < of.x[0] - beyond) or (of.ends and fit[1] > of.x[-1] + beyond)
    if outside or not _phase_of(law, of, fit).agrees(of, np.median):
        return None
    tidied = (np.array([round(value, digits) + 0.0 for value in fit.tolist()]) for digits in DIGITS)
    fits = (
        figures for figures in tidied if figures[1] > figures[0] and _phase_of(law, of, figures).residual <= of.near
    )
    return _phase_of(law, of, next(fits, fit))


def _phase_of(law: Law, of: CamPoints, fit: Array) -> FoundPhase:
    """Return the phase of a law with a begin, an end, a y and a lift."""
    phase = FoundPhase(law, *fit.tolist())
    return replace(phase, residual=float(np.abs(phase.off(of)).max()))
