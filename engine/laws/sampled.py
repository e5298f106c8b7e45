"""The engineer's own law with the coefficients that a table of its samples shows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from engine.laws.base import Array, Coefficients, Kinematics, Law
from engine.laws.piece import Piece
from engine.laws.piece_extremes import reach_of
from engine.laws.pieces import PieceLaw


def abscissae(intervals: int) -> Array:
    """Return ξ = k/N for k = 0 … N."""
    return np.arange(intervals + 1) / intervals


def reach(law: Law) -> tuple[float, float]:
    """Return the lowest and the highest position of a law: exact, or of its samples if its coefficients are theirs."""
    return law.reach if isinstance(law, SampledPieceLaw) else reach_of(law.as_pieces(), law.start.v)


class SampledPieceLaw(PieceLaw):
    """An own law whose coefficients are the extremes of its ``intervals + 1`` samples, beside the exact RMS.

    No closed form leads from a cubic and a sine to their extremes; a workbook's coefficients are therefore those of
    its table, and a movement is judged by the same. Whether C_j is infinite is exact.
    """

    intervals: int

    def __init__(self, pieces: Sequence[Piece], intervals: int) -> None:
        super().__init__(pieces)
        object.__setattr__(self, "intervals", intervals)

    @cached_property
    def samples(self) -> Kinematics[Array]:
        """Its values at the samples."""
        return self.evaluate(abscissae(self.intervals))

    @property
    def reach(self) -> tuple[float, float]:
        """The lowest and the highest position of its samples."""
        s = self.samples.s
        return float(s.min()), float(s.max())

    @property
    def powers(self) -> Array:
        """The values of v·a at the samples."""
        return self.samples.v * self.samples.a

    def _coefficients(self) -> Coefficients:
        exact, (_, v, a, j), power = super()._coefficients(), self.samples, self.powers
        return replace(
            exact,
            cv=float(np.abs(v).max()),
            ca_max=float(a.max()),
            ca_min=float(a.min()),
            cj=float(np.abs(j).max()) if math.isfinite(exact.cj) else math.inf,
            va_max=float(power.max()),
            va_min=float(power.min()),
        )
