"""The engine's laws of a book, by code."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from engine.laws import (
    ConstantAcceleration,
    Cubic,
    Cycloidal,
    Dwell,
    Law,
    ModifiedTrapezoidal,
    Piece,
    PieceLaw,
    TrapezoidalVelocity,
)
from engine.laws.base import Coefficients
from workbook.laws import entries as entered


class OwnLaw(PieceLaw):
    """The own law with the coefficients that cells can find: extremes of its ``intervals + 1`` samples, the exact RMS.

    No closed form leads from a cubic and a sine to their extremes; the workbook's coefficients are therefore those
    of its table, and a movement is judged by the same.
    """

    intervals: int

    def __init__(self, pieces: Sequence[Piece], intervals: int) -> None:
        super().__init__(pieces)
        object.__setattr__(self, "intervals", intervals)

    def _coefficients(self) -> Coefficients:
        exact = super()._coefficients()
        _, v, a, j = self.evaluate(np.arange(self.intervals + 1) / self.intervals)
        return replace(
            exact,
            cv=float(np.abs(v).max()),
            ca_max=float(a.max()),
            ca_min=float(a.min()),
            cj=float(np.abs(j).max()) if math.isfinite(exact.cj) else math.inf,
            va_max=float((v * a).max()),
            va_min=float((v * a).min()),
        )


def laws(given: entered.Laws, intervals: int) -> dict[str, Law]:
    """Return the engine's laws by code, in the order of the Laws sheet; the own law is sampled in ``intervals``."""
    pieces = [Piece(p.duration, (p.c0, p.c1, p.c2, p.c3), p.amplitude, p.omega, p.phase) for p in given.OWN.pieces]
    d = given.MTP.durations
    return {
        "DWL": Dwell(),
        "ACS": ConstantAcceleration(),
        "TVP": TrapezoidalVelocity(given.TVP.rise_end, given.TVP.fall_start),
        "CIC": Cycloidal(),
        "CUB": Cubic(),
        "MTP": ModifiedTrapezoidal((d[0], d[1], d[2], d[3], d[4], d[5], d[6])),
        "OWN": OwnLaw(pieces, intervals),
    }
