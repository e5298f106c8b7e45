"""Motions shifted along the cycle, and the least gap between axes."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, require_finite
from engine.laws.extremes import Curve, zeros
from engine.laws.piece import shifted
from engine.motion.motion import Motion
from engine.motion.phase import MotionValues
from engine.motion.pieces import MotionPiece, motion_pieces

SAME = 1e-12  # share of the cycle: breaks that are nearer to each other count as the same


class Unshifted(NamedTuple):
    """Places in the unshifted motion."""

    cycles: Array  # whole cycles that have passed
    x: Array  # abscissa of the unshifted motion


@dataclass(frozen=True)
class Shifted:
    """A motion y(x) = y0(x − shift), cycle by cycle, with y0(x + cycle) = y0(x) + Σh."""

    motion: Motion
    shift: float = 0.0  # in units of the abscissa

    def __post_init__(self) -> None:
        require_finite(shift=self.shift)

    def at(self, x: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at any x."""
        return self._at(self._unshifted(np.asarray(x, dtype=np.float64)))

    def unshifted(self, x: Array) -> Unshifted:
        """Return the places in the unshifted motion at x of a cycle; its end has the left limit."""
        begin, end = self.motion.edges[[0, -1]]
        cycles, _ = self._unshifted(np.minimum(x, end - 2.0 * self.motion.tolerance))
        return Unshifted(cycles, np.clip(x - self.shift - cycles * self.motion.total, begin, end))

    def over_cycle(self, x: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at x of a cycle; its end has the left limit."""
        return self._at(self.unshifted(x))

    def _at(self, at: Unshifted) -> MotionValues[Array]:
        values = self.motion.at(at.x)
        return values._replace(y=values.y + at.cycles * self.motion.lifts_sum)

    def breaks(self) -> Array:
        """Return the abscissae at which its pieces begin, within the cycle."""
        begin, total = float(self.motion.edges[0]), self.motion.total
        return np.array([begin + (piece.begin + self.shift - begin) % total for piece in self._pieces])

    def curve(self, low: float, high: float) -> Curve:
        """Return y over u = x − ``low``; between ``low`` and ``high`` no piece may begin."""
        cycles, middle = self._unshifted(np.array([0.5 * (low + high)]))
        before = [piece for piece in self._pieces if piece.begin <= middle[0]]
        y, u = before[-1].curves[0], float(middle[0]) - 0.5 * (high - low) - before[-1].begin
        c = list(shifted(y.c, u))
        c[0] += float(cycles[0]) * self.motion.lifts_sum
        return Curve(tuple(c), tuple((a, w, phi + w * u) for a, w, phi in y.sines))

    @cached_property
    def _pieces(self) -> list[MotionPiece]:
        return [piece for piece in motion_pieces(self.motion) if piece.duration > 0.0]

    def _unshifted(self, x: Array) -> Unshifted:
        """Return the places in the unshifted motion at any x."""
        begin, total = float(self.motion.edges[0]), self.motion.total
        cycles = np.floor((x - self.shift - begin + self.motion.tolerance) / total)
        inner = np.clip(x - self.shift - cycles * total, begin, begin + total)
        return Unshifted(cycles, inner)


class Gap(NamedTuple):
    """The least gap between axes over a cycle."""

    least: float  # in the unit of y
    x: float  # abscissa


def least_gap(axes: Sequence[tuple[float, Shifted]], offset: float) -> Gap:
    """Return the least of ``offset`` + Σ factor · y over a cycle; it is exact, at a break or where the slope is 0.

    ``axes`` are factors and motions over a cycle. Raises ValueError for no axes, or for different cycles.
    """
    if not axes:
        raise ValueError("no axes are given; expected at least one")
    cycles = [(float(axis.motion.edges[0]), axis.motion.total) for _, axis in axes]
    if not np.allclose(cycles, cycles[0], rtol=1e-9, atol=0.0):
        raise ValueError("cycles that differ are given; expected one cycle")
    return min(_least(axes, offset, low, high) for low, high in pairwise(_breaks([axis for _, axis in axes])))


class GapLine(NamedTuple):
    """The gap as offset + factor · y of a first axis, from a position of it on, the part of a second axis apart."""

    begin: float  # y, in units of the motion
    offset: float  # in the unit of the gap
    factor: float


def least_gap_by_lines(first: Shifted, second: tuple[float, Shifted], lines: Sequence[GapLine]) -> float:
    """Return the least gap of two axes over a cycle that depends on the first by straight lines; it is exact.

    Parameters
    ----------
    first : Shifted
    second : (float, Shifted)
        The factor and the motion of the second axis, over the same cycle.
    lines : sequence of GapLine
        In rising order; the first and the last go on beyond their ends.

    Returns
    -------
    float
        In the unit of the gap: at a break, where the first axis passes from line to line, or where the slope is 0.
    """
    gaps = []
    for low, high in pairwise(_breaks([first, second[1]])):
        curve = first.curve(low, high)
        passed = [zeros(Curve((curve.c[0] - line.begin, *curve.c[1:]), curve.sines), high - low) for line in lines[1:]]
        places = np.unique([0.0, high - low, *(u for row in passed for u in row)]).tolist()
        for begin, end in pairwise(places):
            y = curve(0.5 * (begin + end))
            line = [line for line in lines if line.begin <= y or line is lines[0]][-1]
            gaps.append(_least([(line.factor, first), second], line.offset, low + begin, low + end).least)
    return min(gaps)


def _breaks(axes: Sequence[Shifted]) -> list[float]:
    """Return the abscissae between which no piece of any axis begins, those of begin and end among them."""
    begin, total = float(axes[0].motion.edges[0]), axes[0].motion.total
    breaks = np.unique(np.concatenate([[begin, begin + total], *(axis.breaks() for axis in axes)]))
    return [float(breaks[0]), *(float(b) for a, b in pairwise(breaks) if b - a > SAME * total)]


def _least(axes: Sequence[tuple[float, Shifted]], offset: float, low: float, high: float) -> Gap:
    """Return the least gap between two neighbouring breaks, of the sum of the axes as a curve over x − ``low``."""
    curves = [(factor, axis.curve(low, high)) for factor, axis in axes]
    columns = np.zeros(max(len(curve.c) for _, curve in curves))
    for factor, curve in curves:
        columns[: len(curve.c)] += factor * np.array(curve.c)
    columns[0] += offset
    gap = Curve(tuple(columns.tolist()), tuple((f * a, w, phi) for f, curve in curves for a, w, phi in curve.sines))
    return min(Gap(gap(u), low + u) for u in (0.0, *zeros(gap.slope, high - low), high - low))


def gap_size(axes: Sequence[tuple[float, Shifted]], offset: float) -> float:
    """Return an upper bound of a gap's size, |offset| + Σ |factor| max|y|, in the unit of y."""
    return abs(offset) + math.fsum(abs(factor) * max(map(abs, axis.motion.reach)) for factor, axis in axes)


def place_in_cycle(angle: float, cycle: float, near: float) -> float:
    """Return the place of an angle in the cycle, from 0.

    Parameters
    ----------
    angle, cycle : float
        In the same unit.
    near : float
        So near the end of the cycle it counts as 0.

    Returns
    -------
    float
    """
    return angle - cycle * math.floor((angle + near) / cycle)
