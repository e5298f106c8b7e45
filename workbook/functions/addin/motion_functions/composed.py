"""Motions of phases, of which a curved one takes over what stands beside it; sums over parts and over intervals."""

from __future__ import annotations

import math
from bisect import bisect_right
from itertools import accumulate
from typing import NamedTuple, Sequence

from .law import NUM, OUTSIDE, TOLERANCE, VALUE, Refused
from .library import REST, End, Rows, law

AGREES = 1e-9


class Via(NamedTuple):
    """Velocity, acceleration and jerk that are prescribed where two phases meet, or where the motion begins or ends."""

    v: float = 0.0
    a: float = 0.0
    j: float = 0.0


class Row(NamedTuple):
    """A phase: code and parameters of its law, duration and lift."""

    code: str
    parameters: Rows
    duration: float
    lift: float

    @property
    def straight(self) -> bool:
        """Whether it is a straight line, or a dwell."""
        return self.code in ("LIN", "DWL")

    def met(self, end: Via) -> End:
        """Return what it has to meet at an end per unit of its duration; a straight line meets nothing."""
        return REST if self.straight else (end.v * self.duration, end.a * self.duration**2, end.j * self.duration**3)


class Motion:
    """Phases one after the other, from position 0: from x = 0, or from a rest that goes on before and after.

    Refuses what is prescribed twice, or other than a straight line has it.
    """

    def __init__(self, rows: Sequence[Row | Via], rests_from: float | None = None) -> None:
        met = [(beside(rows, k, -1), beside(rows, k, 1)) for k in range(len(rows))]
        phases = [(row, ends) for row, ends in zip(rows, met) if isinstance(row, Row)]
        if not phases:
            raise Refused(NUM if rows else VALUE)
        self.durations = [row.duration for row, _ in phases]
        self.laws = [law(row.code, row.parameters, row.lift, *(row.met(end) for end in ends)) for row, ends in phases]
        *self.begins, self.total = accumulate([0.0, *self.durations])
        self.positions = list(accumulate([0.0, *(row.lift for row, _ in phases)]))
        self.rests_from = rests_from

    def at(self, x: float) -> tuple[float, float, float]:
        """Return position, velocity per unit of x, acceleration per unit of x²; at a joint of the later phase."""
        if self.rests_from is not None:
            x = min(max(x - self.rests_from, 0.0), self.total)
        if not -OUTSIDE * self.total <= x <= self.total * (1.0 + OUTSIDE):
            raise Refused(NUM)
        k = max(bisect_right(self.begins, x + TOLERANCE * self.total) - 1, 0)
        duration = self.durations[k]
        s, v, a, _ = self.laws[k].at(min(max((x - self.begins[k]) / duration, 0.0), 1.0))
        return self.positions[k] + s, v / duration, a / duration / duration


def beside(rows: Sequence[Row | Via], k: int, side: int) -> Via:
    """Return what a row has to meet beside it: a straight line, what is prescribed, else rest."""
    asked, place = rows[k], k + side
    near = rows[place] if 0 <= place < len(rows) else None
    if isinstance(asked, Row) and isinstance(near, Via):
        asked, place = near, place + side
        near = rows[place] if 0 <= place < len(rows) else None
    if isinstance(asked, Via) and isinstance(near, Via):
        raise Refused(NUM)
    if isinstance(near, Row) and near.straight:
        own = near.lift / near.duration
        if isinstance(asked, Via) and (asked.a or asked.j or abs(asked.v - own) > AGREES * (abs(asked.v) + abs(own))):
            raise Refused(NUM)
        return Via(own)
    return asked if isinstance(asked, Via) else Via()


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
