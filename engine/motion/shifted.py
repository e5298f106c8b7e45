"""A motion that begins at another angle, and how near two of them come to each other."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, require_finite
from engine.laws.ladder import Curve, zeros
from engine.laws.piece import shifted
from engine.motion.motion import Motion
from engine.motion.phase import MotionValues
from engine.motion.pieces import MotionPiece, motion_pieces

LOST = 1e-9  # of the size of a figure: less is rounding
SAME = 1e-12  # of the cycle: breaks so near to each other are one


class Unshifted(NamedTuple):
    """How many cycles have passed, and the place in the unshifted motion."""

    cycles: Array
    x: Array


@dataclass(frozen=True)
class Shifted:
    """y(x) = y0(x − shift), cycle by cycle; one that does not come back goes on, y0(x + cycle) = y0(x) + Σh."""

    motion: Motion
    shift: float = 0.0

    def __post_init__(self) -> None:
        require_finite(shift=self.shift)

    def at(self, x: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at any x."""
        return self._at(self._unshifted(np.asarray(x, dtype=np.float64)))

    def unshifted(self, x: Array) -> Unshifted:
        """Return the place in the unshifted motion at x of one cycle, the end of which has the left limit."""
        begin, end = self.motion.edges[[0, -1]]
        cycles, _ = self._unshifted(np.minimum(x, end - 2.0 * self.motion.tolerance))
        return Unshifted(cycles, np.clip(x - self.shift - cycles * self.motion.total, begin, end))

    def over_cycle(self, x: Array) -> MotionValues[Array]:
        """Return y, y', y'', y''' at x of one cycle, the end of which has the left limit."""
        return self._at(self.unshifted(x))

    def _at(self, at: Unshifted) -> MotionValues[Array]:
        found = self.motion.at(at.x)
        return found._replace(y=found.y + at.cycles * self.motion.lifts_sum)

    def breaks(self) -> Array:
        """Return where its pieces begin, from the begin of the cycle to less than its end."""
        begin, total = float(self.motion.edges[0]), self.motion.total
        return np.array([begin + (one.begin + self.shift - begin) % total for one in self._pieces])

    def curve(self, low: float, high: float) -> Curve:
        """Return y over u from ``low``, up to ``high``, between which no piece of it begins."""
        cycles, middle = self._unshifted(np.array([0.5 * (low + high)]))
        before = [one for one in self._pieces if one.begin <= middle[0]]
        y, u = before[-1].curves[0], float(middle[0]) - 0.5 * (high - low) - before[-1].begin
        c = [shifted(y.c, i, u) for i in range(len(y.c))]
        c[0] += float(cycles[0]) * self.motion.lifts_sum
        return Curve(tuple(c), tuple((a, w, phi + w * u) for a, w, phi in y.sines))

    @cached_property
    def _pieces(self) -> list[MotionPiece]:
        return [piece for piece in motion_pieces(self.motion) if piece.duration > 0.0]

    def _unshifted(self, x: Array) -> Unshifted:
        """Return how many cycles have passed at x, and the place in the unshifted motion."""
        begin, total = float(self.motion.edges[0]), self.motion.total
        cycles = np.floor((x - self.shift - begin + self.motion.tolerance) / total)
        inner = np.clip(x - self.shift - cycles * total, begin, begin + total)
        return Unshifted(cycles, inner)


class Gap(NamedTuple):
    """The least gap between two axes, and where in the cycle it is."""

    least: float
    x: float


def least_gap(axes: Sequence[tuple[float, Shifted]], offset: float) -> Gap:
    """Return the least of ``offset`` + Σ factor · y over a cycle, exact: at the breaks, and where its slope is 0.

    ``axes`` are factors and motions over one cycle. Raises ValueError for no axes, or cycles that differ.
    """
    if not axes:
        raise ValueError("no axes are given; expected at least one")
    cycles = [(float(one.motion.edges[0]), one.motion.total) for _, one in axes]
    if not np.allclose(cycles, cycles[0], rtol=1e-9, atol=0.0):
        raise ValueError("cycles that differ are given; expected one cycle")
    begin, total = cycles[0]
    breaks = np.unique(np.concatenate([[begin, begin + total], *(one.breaks() for _, one in axes)]))
    kept = [float(breaks[0]), *(float(b) for a, b in pairwise(breaks) if b - a > SAME * total)]
    return min(_least(axes, offset, low, high) for low, high in pairwise(kept))


def _least(axes: Sequence[tuple[float, Shifted]], offset: float, low: float, high: float) -> Gap:
    """Return the least gap between two neighbouring breaks, of the sum of the axes as one curve over u from ``low``."""
    curves = [(factor, one.curve(low, high)) for factor, one in axes]
    columns = np.zeros(max(len(curve.c) for _, curve in curves))
    for factor, curve in curves:
        columns[: len(curve.c)] += factor * np.array(curve.c)
    columns[0] += offset
    gap = Curve(tuple(columns.tolist()), tuple((f * a, w, phi) for f, curve in curves for a, w, phi in curve.sines))
    return min(Gap(gap(u), low + u) for u in (0.0, *zeros(gap.derivative(), high - low), high - low))


def meets_least(gap: float, least: float, size: float) -> bool:
    """Return whether a gap is at least the least that is asked for, but for rounding of its size."""
    return gap >= least - LOST * size


def gap_size(axes: Sequence[tuple[float, Shifted]], offset: float) -> float:
    """Return how large a gap grows: |offset| + Σ |factor| max|y|."""
    return abs(offset) + math.fsum(abs(f) * max(map(abs, one.motion.reach)) for f, one in axes)


def place_in_cycle(angle: float, late: float, cycle: float, near: float = 0.0) -> float:
    """Return the place in the cycle of a place in a motion that is so late; so near before its begin it is on that."""
    place = angle + late
    return place - cycle * math.floor((place + near) / cycle)
