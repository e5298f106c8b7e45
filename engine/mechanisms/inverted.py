"""A table of positions inverted by counting points of a grid and two steps of Newton's: as cells do it. SI units."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.mechanisms.table import PositionTable
from engine.motion.turning import GRID, PARTS

NEAR = 1e-12
"""of a part: what differs by less is equal"""
STEEPEST = 100.0
"""times that a table may be steeper between two points than at one of them: more, and its inverse loses digits"""


class Cubics(NamedTuple):
    """The parts of a table between points, each over a share t of its width: rise · t (b + t (c2 + t c3)).

    ``chord`` is rise over width, ``limit`` what a part limits the slopes at its ends by; ``free`` and ``slope`` are
    the slope of each point before that and behind; ``begin`` (b) and ``end`` those at a part's ends over its chord.
    """

    width: Array
    rise: Array
    chord: Array
    free: Array
    limit: Array
    slope: Array
    begin: Array
    end: Array
    c2: Array
    c3: Array

    @classmethod
    def of(cls, table: PositionTable) -> Cubics:
        """Return those of a table; slopes as of Fritsch and Carlson."""
        angle, y, slope = table.columns
        width, rise = np.diff(angle), np.diff(y)
        chord = rise / width
        inner = (width[1:] * chord[:-1] + width[:-1] * chord[1:]) / (width[1:] + width[:-1])
        free, limit = np.concatenate([chord[:1], inner, chord[-1:]]), np.ones_like(chord)
        before = 1.0
        for k, one in enumerate(chord):
            limit[k] = before = min(1.0, 3.0 * one / float(np.hypot(free[k] * before, free[k + 1])))
        begin, end = slope[:-1] * width / rise, slope[1:] * width / rise
        return cls(width, rise, chord, free, limit, slope, begin, end, 3.0 - 2.0 * begin - end, begin + end - 2.0)

    @property
    def sharp(self) -> NDArray[np.bool_]:
        """Whether each part is much less steep at an end than on the whole."""
        return np.asarray(np.minimum(self.begin, self.end) < 1.0 / STEEPEST)


class Inverted(NamedTuple):
    """Positions in a table: number of the part, from 1; b, c2, c3 of it; share of its rise; t, step by step."""

    part: Array
    coefficients: tuple[Array, Array, Array]
    height: Array
    rough: Array
    fine: Array
    chord: Array
    step: Array
    share: Array

    @classmethod
    def of(cls, table: PositionTable, y: Array, within: Array) -> Inverted:
        """Return them for positions, each in the part of the position ``within``."""
        cubics, k = Cubics.of(table), table.part(within)
        b, c2, c3 = cubics.begin[k], cubics.c2[k], cubics.c3[k]
        height = (y - table.columns[1][k]) / cubics.rise[k]

        def value(t: Array) -> Array:
            return np.asarray(t * (b + t * (c2 + t * c3)))

        def newton(t: Array, low: Array) -> Array:
            found = t - (value(t) - height) / (b + t * (2.0 * c2 + 3.0 * t * c3))
            return np.asarray(np.clip(found, low, low + 1.0 / PARTS**2))

        def counted(at: Array, width: float) -> Array:
            below = value(at + width * GRID[:, None]) < height - NEAR
            return np.asarray(at + width * np.minimum(PARTS - 1, np.count_nonzero(below, axis=0)) / PARTS)

        rough = counted(np.zeros_like(height), 1.0)
        fine = counted(rough, 1.0 / PARTS)
        low, high = value(fine), value(fine + 1.0 / PARTS**2)
        chord = fine + np.clip((height - low) / (high - low), 0.0, 1.0) / PARTS**2
        step = newton(chord, fine)
        return cls(k + 1, (b, c2, c3), height, rough, fine, chord, step, newton(step, fine))
