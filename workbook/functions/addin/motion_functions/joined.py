"""Rows of a table of phases, joined: a curved phase takes over what stands beside it."""

from __future__ import annotations

from typing import NamedTuple, Sequence, Tuple

from .composed import Motion, Phase
from .library import Ends, law
from .refused import NUM, VALUE, Refused

AGREES = 1e-9
Rows = Tuple[Tuple[float, ...], ...]


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
