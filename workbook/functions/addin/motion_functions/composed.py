"""Motions of phases, of which a curved one takes over what stands beside it; sums over parts and over intervals."""

from __future__ import annotations

import math
from bisect import bisect_right
from itertools import accumulate
from typing import NamedTuple, Sequence

from .law import OUTSIDE, TOLERANCE, Law
from .library import Ends, Rows, law
from .refused import NUM, VALUE, Refused

AGREES = 1e-9


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
        one, duration, _ = self.phases[k]
        s, v, a, _ = one.at(min(max((x - self.begins[k]) / duration, 0.0), 1.0))
        return self.positions[k] + s, v / duration, a / duration / duration


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

    @property
    def rates(self) -> Via:
        """What a straight line has at its ends."""
        return Via(self.lift / self.duration)


def joined(rows: Sequence[Row | Via]) -> Motion:
    """Return the motion of rows; refuses what is prescribed twice, or other than a straight line has it."""
    sides: list[tuple[Row, list[Via]]] = []
    for k, row in enumerate(rows):
        before, after = met(rows, k, -1), met(rows, k, 1)
        if isinstance(row, Row):
            sides.append((row, [before, after]))
    if not sides:
        raise Refused(NUM if rows else VALUE)
    return Motion([carried_out(row, *ends) for row, ends in sides])


def met(rows: Sequence[Row | Via], k: int, side: int) -> Via:
    """Return what a row has to meet beside it: a straight line, what is prescribed, else rest."""
    asked = rows[k] if isinstance(rows[k], Via) else None
    place = k + side
    if asked is None and 0 <= place < len(rows) and isinstance(rows[place], Via):
        asked, place = rows[place], place + side
    beside = rows[place] if 0 <= place < len(rows) else None
    if isinstance(asked, Via) and isinstance(beside, Via):
        raise Refused(NUM)
    if isinstance(beside, Row) and beside.straight:
        if isinstance(asked, Via):
            require_agreed(asked, beside.rates)
        return beside.rates
    return asked if isinstance(asked, Via) else Via()


def require_agreed(asked: Via, own: Via) -> None:
    """Refuse what is prescribed other than a straight line has it."""
    if asked.a or asked.j or abs(asked.v - own.v) > AGREES * (abs(asked.v) + abs(own.v)):
        raise Refused(NUM)


def carried_out(row: Row, begin: Via, end: Via) -> Phase:
    """Return a phase between what it has to meet; a straight line meets nothing."""
    d = row.duration
    if row.straight:
        begin = end = Via()
    ends = Ends(row.lift, begin.v * d, end.v * d, begin.a * d**2, end.a * d**2, begin.j * d**3, end.j * d**3)
    return Phase(law(row.code, row.parameters, ends), d, row.lift)


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
