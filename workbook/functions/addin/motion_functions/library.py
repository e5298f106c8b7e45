"""The laws by code, with their parameters checked.

All but the cubic and the own law are seven stages: an acceleration from rest (a quarter sine up, a constant, a
quarter sine down), a uniform velocity, and a deceleration, which is an acceleration seen backwards from its end.
Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Callable, Sequence, Tuple

from .law import Law, end_of
from .piece import Piece
from .refused import NUM, VALUE, Refused

SUM_TOLERANCE = 1e-9  # of the durations of a law
OWN_WIDTH = 8

Rows = Tuple[Tuple[float, ...], ...]


@lru_cache(maxsize=512)
def law(code: str, parameters: tuple[tuple[float, ...], ...]) -> Law:
    """Return the law of a code in capitals; refuses what is no code, too many or few parameters, impossible ones."""
    if code == "OWN":
        return own(parameters)
    if code not in LAWS:
        raise Refused(VALUE)
    count, made = LAWS[code]
    p = [value for row in parameters for value in row]
    if count and len(p) != count:
        raise Refused(VALUE)
    return made(*p[:count])


def trapezoidal(rise_end: float, fall_start: float) -> Law:
    """Return the trapezoidal velocity profile of two break points."""
    if not 0.0 < rise_end <= fall_start < 1.0:
        raise Refused(NUM)
    return seven_stages(0.0, rise_end, 0.0, fall_start - rise_end, 0.0, 1.0 - fall_start, 0.0)


def modified_trapezoidal(*durations: float) -> Law:
    """Return the modified trapezoidal law of seven durations."""
    complete = abs(sum(durations) - 1.0) <= SUM_TOLERANCE
    if min(durations) < 0.0 or not complete or not sum(durations[:3]) or not sum(durations[4:]):
        raise Refused(NUM)
    return seven_stages(*durations)


def seven_stages(d1: float, d2: float, d3: float, d4: float, d5: float, d6: float, d7: float) -> Law:
    """Return the law whose two parts meet at one velocity and rise by 1 together.

    For unit acceleration the parts end at the velocities m and n and the positions S_a and S_d; then
    A = 1/(S_a + S_d m/n) and B = A m/n.
    """
    ahead, behind = [*lobe(d1, d2, d3), Piece(d4)], lobe(d7, d6, d5)
    (s_a, m), (s_d, n) = reached(ahead), reached(behind)
    up = 1.0 / (s_a + s_d * m / n)
    return Law([piece.scaled(up) for piece in ahead], [piece.scaled(up * m / n) for piece in behind])


def lobe(d1: float, d2: float, d3: float) -> list[Piece]:
    """Return a quarter sine up, a constant, a quarter sine down, of unit acceleration."""
    quarters = [Piece(d, amplitude=1.0, omega=math.pi / (2 * d)) if d else Piece(0.0) for d in (d1, d3)]
    return [quarters[0], Piece(d2, 1.0), quarters[1]._replace(phase=math.pi / 2)]


def reached(pieces: Sequence[Piece]) -> tuple[float, float]:
    """Return position and velocity at the end of pieces that begin at rest."""
    state = (0.0, 0.0, 0.0)
    for piece in pieces:
        state = end_of(piece, *state)
    return state[1:]


def own(rows: Rows) -> Law:
    """Return the engineer's own law: in a row duration, c0, c1, c2, c3, P, ω, φ of a piece."""
    if any(len(row) != OWN_WIDTH for row in rows):
        raise Refused(VALUE)
    durations = [row[0] for row in rows]
    if min(durations) < 0.0 or abs(sum(durations) - 1.0) > SUM_TOLERANCE:
        raise Refused(NUM)
    return Law([Piece(*row) for row in rows])


LAWS: dict[str, tuple[int, Callable[..., Law]]] = {
    "DWL": (0, lambda: Law([Piece(1.0)])),
    "ACS": (0, lambda: seven_stages(0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0)),
    "TVP": (2, trapezoidal),
    "CIC": (0, lambda: seven_stages(0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25)),
    "CUB": (0, lambda: Law([Piece(1.0, 6.0, -12.0)])),
    "MTP": (7, modified_trapezoidal),
}
"""how many parameters each law takes, and what makes it of them; the own law beside them takes rows of pieces"""
PARAMETERS = {code: count for code, (count, _) in LAWS.items()}
DELIVERED: dict[str, Rows] = {
    "TVP": ((1 / 3, 2 / 3),),
    "MTP": ((0.125, 0.25, 0.125, 0.0, 0.125, 0.25, 0.125),),
    "OWN": ((1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0),),
}
"""the parameters of a law where none are given"""
