"""Motions of phases, and sums over rotating parts and over intervals."""

from __future__ import annotations

import math
from bisect import bisect_right
from itertools import accumulate
from typing import NamedTuple, Sequence

from .law import OUTSIDE, TOLERANCE, Law
from .refused import NUM, VALUE, Refused


class Phase(NamedTuple):
    """A law that has its lift in itself, and its duration."""

    law: Law
    duration: float
    lift: float


class Motion:
    """Phases one after the other, from position 0: from x = 0, or from a rest that goes on before and after."""

    def __init__(self, phases: Sequence[Phase]) -> None:
        if not phases:
            raise Refused(VALUE)
        self.phases = phases
        *self.begins, self.total = accumulate([0.0, *(phase.duration for phase in phases)])
        self.positions = list(accumulate([0.0, *(phase.lift for phase in phases)]))
        self.rests_from: float | None = None

    def at(self, x: float) -> tuple[float, float, float]:
        """Return position, velocity per unit of x, acceleration per unit of x²; at a joint of the later phase."""
        if self.rests_from is not None:
            x = min(max(x - self.rests_from, 0.0), self.total)
        if not -OUTSIDE * self.total <= x <= self.total * (1.0 + OUTSIDE):
            raise Refused(NUM)
        k = max(bisect_right(self.begins, x + TOLERANCE * self.total) - 1, 0)
        law, duration, _ = self.phases[k]
        s, v, a, _ = law.at(min(max((x - self.begins[k]) / duration, 0.0), 1.0))
        return self.positions[k] + s, v / duration, a / duration / duration


def reflected(inertias: Sequence[float], ratios: Sequence[float]) -> float:
    """Return Σ J (ω_i/ω)². Source: S1, 'Feeding group layout'."""
    if min(inertias) < 0.0:
        raise Refused(NUM)
    return math.fsum(j * ratio * ratio for j, ratio in zip(inertias, ratios))


def root_mean_square(values: Sequence[float], durations: Sequence[float]) -> float:
    """Return √(Σ v² t / Σ t)."""
    if min(durations) < 0.0 or not sum(durations):
        raise Refused(NUM)
    return math.sqrt(math.fsum(v * v * t for v, t in zip(values, durations)) / math.fsum(durations))
