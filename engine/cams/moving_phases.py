"""Identification of phases that meet at speed: straight lines, laws with boundary values, splines for the rest."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise, product
from typing import NamedTuple

import numpy as np

from engine.cams.cam_points import (
    FEW,
    LONGER,
    MOST_PHASES,
    QUINTIC,
    RATES,
    SEAM,
    CamPoints,
    FoundPhase,
    gauss_newton,
    splines,
)
from engine.laws import CATALOGUE, law
from engine.laws.base import Array, Flags
from engine.laws.ends import BoundaryLaw, BoundaryValues, EndError
from engine.motion.profile import CamProfile

SHORTEST = 3  # intervals of a straight line, if the table has no y'
CORNER = 2e-5  # share of the cycle: a curve between lines that is shorter, in a table with y', is their corner
TURNED = 0.1  # share of the largest velocity by which that of a curve beside a line is another: there is a corner
MOST = 8  # quintics in place of a law


class EndLine(NamedTuple):
    """The line that a curved phase meets at an end, in the units of the table."""

    x: float
    y: float  # at x
    v: float  # y'
    a: float = 0.0  # y''
    fixed: bool = False  # whether the phase has to end at this x, as no phase is beyond


Sides = tuple[EndLine, EndLine]  # at begin and end of a phase


def phases_at_speed(of: CamPoints, rebuilt: CamProfile) -> tuple[list[FoundPhase], bool]:
    """Return the phases, meeting at speed, of a movement between rests or ends of the table; and if all are known.

    They are known if each is a line or a law. A part between lines that follows no law is divided into quintics with
    equal y' and y'' where they meet, or into splines. There are no phases if it takes too many.
    """
    phases: list[FoundPhase] = []
    known = True
    near, runs = of.near, _straight_runs(of)
    edges = [0, *(k for run in runs for k in run), len(of.x) - 1]
    places = _edge_places(of, rebuilt, runs, edges)
    laws = [family() for family in CATALOGUE if issubclass(family, BoundaryLaw)]
    quintic = next(family for family in laws if family.code == QUINTIC)
    for k, (begin, end) in enumerate(pairwise(edges)):
        if places[k] == places[k + 1]:
            continue
        if k % 2:
            phases.append(_line(of, (begin, end), (places[k], places[k + 1])))
            continue
        sides = _beside(of, rebuilt, runs, begin), _beside(of, rebuilt, runs, end)
        inner = of.part(begin, end)
        fitted = _law_between(laws, inner, sides, near)
        laid = [fitted] if fitted else _quintics(quintic, inner, rebuilt, sides, near)
        slopes = _slope(inner, sides[0], 0), _slope(inner, sides[1], -1)
        laid = laid or splines(inner, rebuilt, slopes, max(of.thinned, near))
        if not laid:
            return [], False
        known &= fitted is not None
        phases += laid
    return _with_lines_to_neighbours(phases), known


def _law_between(laws: Sequence[BoundaryLaw], of: CamPoints, sides: Sides, near: float) -> FoundPhase | None:
    """Return the first law that a curve between two lines follows, in their direction or from a corner, or None."""
    ends = list(product(_meeting(of, sides[0], 0), _meeting(of, sides[1], -1)))
    fits = (_fit_law_to(law, of, both, near) for both in ends for law in laws if of.identifies(law))
    return next(filter(None, fits), None)


def _meeting(of: CamPoints, met: EndLine, side: int) -> list[EndLine]:
    """Return how a curve may begin (0) or end (-1) beside a line: in its direction, or at a corner, at rest or not."""
    if met.fixed or not met.v:
        return [met]
    at_corner = met._replace(fixed=True)
    v, a = of.rate_at(side)
    return [met, at_corner._replace(v=0.0), at_corner._replace(v=v, a=a)]


def _slope(of: CamPoints, met: EndLine, side: int) -> float:
    """Return y' of a spline at its begin (0) or end (-1) beside a line: its own where both meet at a corner."""
    if met.fixed:
        return met.v
    own = of.rate_at(side)[0]
    return own if abs(own - met.v) > TURNED * of.fastest else met.v


def _edge_places(
    of: CamPoints, rebuilt: CamProfile, runs: Sequence[tuple[int, int]], edges: Sequence[int]
) -> list[float]:
    """Return the x of each edge of lines and curves: where lines cross between neighbouring points, both end there."""
    places = [float(of.x[edge]) for edge in edges]
    widest = np.inf if of.v is None else CORNER * rebuilt.total
    for k in range(0, len(edges), 2):
        begin, end = edges[k : k + 2]
        if end - begin == 1 and places[k + 1] - places[k] <= widest:
            near, other = (_beside(of, rebuilt, runs, edge) for edge in (begin, end))
            turn = near.v - other.v
            across = near.x + (other.y - near.y - other.v * (other.x - near.x)) / turn if turn else np.nan
            if not (near.fixed or other.fixed) and places[k] <= across <= places[k + 1]:
                places[k] = places[k + 1] = across
    return places


def _line(of: CamPoints, run: tuple[int, int], places: tuple[float, float]) -> FoundPhase:
    """Return the straight line through the first and the last point of a run, from an x to another."""
    (begin, end), (first, last) = run, places
    slope = float((of.y[end] - of.y[begin]) / (of.x[end] - of.x[begin]))
    y = float(of.y[begin]) + slope * (first - float(of.x[begin]))
    residual = float(_off_chord(of, run).max())
    return FoundPhase(law("LIN"), first, last, y, slope * (last - first), residual)


def _with_lines_to_neighbours(phases: Sequence[FoundPhase]) -> list[FoundPhase]:
    """Return the phases with their lines extended or cut to their neighbours."""
    settled = list(phases)
    for k, phase in enumerate(phases):
        if phase.law.code == "LIN":
            begin = settled[k - 1].end if k else phase.begin
            end = phases[k + 1].begin if k + 1 < len(phases) else phase.end
            slope = phase.lift / (phase.end - phase.begin)
            y, lift = phase.y + slope * (begin - phase.begin), slope * (end - begin)
            settled[k] = replace(phase, begin=begin, end=end, y=y, lift=lift)
    return settled


def _straight_runs(of: CamPoints) -> list[tuple[int, int]]:
    """Return the first and the last point of each straight line in a table."""
    x, y, h, near = of.x, of.y, np.diff(of.x), of.near
    slope = np.diff(y) / h
    size = float(np.abs(slope).max())
    if of.v is not None:
        off = np.maximum(np.abs(of.v[:-1] - slope), np.abs(of.v[1:] - slope))
        flat = off <= 1e-9 * size + np.minimum(4.0 * near / h, RATES * size)
        return [(k, k + 1) for k in np.flatnonzero(flat).tolist()] if flat.sum() < 2 else true_runs(flat)
    vertices = _polygon(of)
    turns = np.diff(y[vertices])[1:] * np.diff(y[vertices])[:-1] < 0.0
    if 2 < len(vertices) <= MOST_PHASES and (turns.all() or len(x) < FEW):
        # there and back, and straight on the way; few positions tell no more
        return list(pairwise(vertices))
    bends = np.abs(y[1:-1] - (y[:-2] + (y[2:] - y[:-2]) * (x[1:-1] - x[:-2]) / (x[2:] - x[:-2]))) > near
    lines = pairwise([0, *(np.flatnonzero(bends) + 1).tolist(), len(x) - 1])
    around = np.pad(h, 1)

    def sparse(begin: int, end: int) -> bool:
        """Return whether a line's points are much farther apart than the neighbours', as a controller writes lines."""
        beside = float(max(around[begin], around[end + 1]))
        return end - begin > 1 and 0.0 < LONGER * beside < float(h[begin:end].min())

    return [run for run in lines if (run[1] - run[0] >= SHORTEST or sparse(*run)) and _off_chord(of, run).max() <= near]


def _off_chord(of: CamPoints, run: tuple[int, int]) -> Array:
    """Return the deviations of points from the straight line through the first and the last of them."""
    x, y = (row[run[0] : run[1] + 1] for row in (of.x, of.y))
    return np.abs(y - np.interp(x, x[[0, -1]], y[[0, -1]]))


def _polygon(of: CamPoints) -> list[int]:
    """Return the numbers of the points between which straight lines keep to all points, or more than it may have.

    A line is divided at the point that is farthest off (D. H. Douglas, T. K. Peucker, 1973).
    """
    corners, left = [0], [len(of.x) - 1]
    while left and len(corners) <= MOST_PHASES:
        off = _off_chord(of, (corners[-1], left[-1]))
        if off.max() <= of.near:
            corners.append(left.pop())
        else:
            left.append(corners[-1] + int(off.argmax()))
    return corners + left[::-1]


def true_runs(flat: Flags) -> list[tuple[int, int]]:
    """Return the first and the last point of each run of intervals that are true."""
    edges = np.flatnonzero(np.diff(np.pad(flat.astype(np.int8), 1)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _beside(of: CamPoints, rebuilt: CamProfile, runs: Sequence[tuple[int, int]], k: int) -> EndLine:
    """Return the line, or rest, that a curved phase meets at a point; at an end of the table its own rates there."""

    def slope(begin: int, end: int) -> float:
        return float((of.y[end] - of.y[begin]) / (of.x[end] - of.x[begin]))

    last = len(of.x) - 1
    met = next((slope(*run) for run in runs if k in run), None)
    if met is not None or not ((k == 0 and of.begins) or (k == last and of.ends)):
        return EndLine(float(of.x[k]), float(of.y[k]), met or 0.0)
    free = _rates(of, rebuilt, k)._replace(fixed=True)
    # the line that a table ends with may go on at its begin, and the other way round
    if of.begins and of.ends:
        across = next((slope(*run) for run in runs if (run[1] == last if k == 0 else run[0] == 0)), np.inf)
        if abs(across - free.v) <= SEAM * of.fastest:
            return free._replace(v=across, a=0.0)
    return free


def _rates(of: CamPoints, rebuilt: CamProfile, k: int) -> EndLine:
    """Return y, y' and y'' at a point: the table's own, else those of the rebuilt profile."""
    x, y, last = float(of.x[k]), float(of.y[k]), k == len(of.x) - 1
    if (of.begins and k == 0) or (of.ends and last):
        return EndLine(x, y, *(of.seam or of.rate_at(-1 if last else 0)))
    at = rebuilt.at(of.x[k : k + 1], left=last)
    v, a = (at.y1[0] if of.v is None else of.v[k]), (at.y2[0] if of.a is None else of.a[k])
    return EndLine(x, y, float(v), float(a))


def _law_from_to(base: BoundaryLaw, places: Sequence[float], sides: Sides) -> FoundPhase | None:
    """Return a law between two x, with the velocities of the lines there; None if it cannot have these."""
    begin, end = places
    first, last = (s.y if s.fixed else s.y + s.v * (x - s.x) for s, x in zip(sides, places, strict=True))
    d = end - begin
    if d <= 0.0:
        return None
    a0, a1 = (side.a * d**2 if "a" in base.takes and side.fixed else 0.0 for side in sides)
    try:
        ends = BoundaryValues(last - first, sides[0].v * d, sides[1].v * d, a0, a1)
        bounded = base if ends.at_rest else base.between(ends)
    except EndError:
        return None
    return FoundPhase(bounded, begin, end, first, last - first, 0.0)


def _fit_law_to(base: BoundaryLaw, of: CamPoints, sides: Sides, near: float) -> FoundPhase | None:
    """Return a law whose begin and end are fitted to the points by least squares; None if it does not fit."""
    step = np.diff(of.x)[[0, -1]]
    free = np.array([not side.fixed for side in sides])
    free &= len(of.x) >= free.sum() + 2

    def moved_law(moved: Array) -> FoundPhase | None:
        """Return the law with its free ends moved; None if it cannot have them, or they are moved too far."""
        by = np.zeros(2)
        by[free] = moved
        return _law_from_to(base, (of.x[[0, -1]] + by).tolist(), sides) if np.all(np.abs(by) <= 2.0 * step) else None

    def off(moved: Array) -> Array:
        return phase.off(of) if (phase := moved_law(moved)) else np.full(len(of.x), np.inf)

    moved = gauss_newton(off, np.zeros(int(free.sum())), step[free], near)
    phase = None if moved is None else moved_law(moved)
    if phase is None or not phase.agrees(of):
        return None
    return replace(phase, residual=float(np.abs(phase.off(of)).max()))


def _quintics(quintic: BoundaryLaw, of: CamPoints, rebuilt: CamProfile, sides: Sides, most: float) -> list[FoundPhase]:
    """Return polynomials of degree 5 between points, each as long as ``most`` allows; none if over :data:`MOST`."""
    phases: list[FoundPhase] = []
    k, last = 0, len(of.x) - 1
    here = sides[0]
    while k < last:
        low, high, best = k, last, None
        while high > low:
            middle = high if best is None and high == last else (low + high + 1) // 2
            there = sides[1] if middle == last else _rates(of, rebuilt, middle)
            ends = here._replace(fixed=True), there._replace(fixed=True)
            phase = _law_from_to(quintic, (here.x, there.x), ends)
            missed = float(np.abs(phase.off(of.part(k, middle))).max()) if phase else np.inf
            if phase and missed <= most:
                best, low = (replace(phase, residual=missed), there), middle
            else:
                high = middle - 1
        if best is None or len(phases) == MOST:
            return []
        phases.append(best[0])
        k, here = low, best[1]
    return phases
