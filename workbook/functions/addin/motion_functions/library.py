"""The laws by code, with their parameters checked, between rests or between prescribed ends.

Most are seven stages: an acceleration from rest (an edge up, a constant, an edge down), a uniform velocity, and a
deceleration, which is an acceleration seen backwards from its end. Source: S1, 'Modified trapezoidal (acceleration)
curve (seven parameters)'.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple, Sequence, Tuple

from .law import Law, end_of
from .laws import LAWS, OWN_WIDTH, SUM_TOLERANCE, Declared
from .piece import Piece
from .polynomials import half, hermite
from .refused import NUM, VALUE, Refused

Rows = Tuple[Tuple[float, ...], ...]


class Ends(NamedTuple):
    """Lift, and velocities, accelerations and jerks at begin and end, per unit of ξ."""

    lift: float = 1.0
    v0: float = 0.0
    v1: float = 0.0
    a0: float = 0.0
    a1: float = 0.0
    j0: float = 0.0
    j1: float = 0.0


REST = Ends()


@lru_cache(maxsize=512)
def law(code: str, parameters: Rows, ends: Ends = REST) -> Law:
    """Return the law of a code in capitals between ends.

    Refuses what is no code, too many or few parameters, impossible ones, and ends that the law cannot have.
    """
    if code == "OWN":
        return standing(own(parameters), ends)
    if code not in LAWS:
        raise Refused(VALUE)
    declared = LAWS[code]
    p = [value for row in parameters for value in row] if declared.delivered else []
    if not any(p):
        p = list(declared.delivered)
    if len(p) != len(declared.delivered):
        raise Refused(VALUE)
    require(all(domain.has(p[k]) for k, domain in declared.domains.items()))
    if declared.stages:
        return seven_stages(seven(declared.stages(*p)), ends, declared.straight)
    if declared.pieces:
        return standing([Piece(**entries) for entries in declared.pieces(*p)], ends, declared.begin)
    return polynomial(declared, p[0], ends)


def standing(pieces: Sequence[Piece], ends: Ends, begin: float = 0.0) -> Law:
    """Return a law that begins and ends as it does, whatever is beside it; refuses all other ends."""
    if any(ends[1:]):
        raise Refused(NUM)
    return Law([piece.scaled(ends.lift) for piece in pieces], lift=ends.lift, begin=begin * ends.lift)


def require(possible: bool) -> None:
    """Refuse parameters that are not possible."""
    if not possible:
        raise Refused(NUM)


def seven(d: Sequence[float]) -> Sequence[float]:
    """Return seven durations; refuses those that do not fill the rise, and pulses of no duration."""
    require(min(d) >= 0.0 and abs(sum(d) - 1.0) <= SUM_TOLERANCE and sum(d[:3]) > 0.0 and sum(d[4:]) > 0.0)
    return d


def seven_stages(d: Sequence[float], ends: Ends, straight: bool) -> Law:
    """Return the law whose two parts meet at one velocity V, and which gains the lift.

    For unit acceleration the parts gain m and n and travel S_a and S_d from rest, over T₁ and T₂: then
    V = [H − v0 (T₁ − S_a/m) − v1 (T₂ − S_d/n)]/(S_a/m + d4 + S_d/n), A = (V − v0)/m and B = (V − v1)/n.
    """
    if any(ends[3:]):
        raise Refused(NUM)
    ahead, behind = pulse(d[:3], straight), pulse(d[:3:-1], straight)
    (s_a, m), (s_d, n) = reached(ahead), reached(behind)
    first, last = s_a / m, s_d / n
    slid = ends.v0 * (sum(d[:3]) - first) + ends.v1 * (sum(d[4:]) - last)
    top = (ends.lift - slid) / (first + d[3] + last)
    up, down = (top - ends.v0) / m, (top - ends.v1) / n
    forward = [*(piece.scaled(up) for piece in ahead), Piece(d[3])]
    return Law(forward, [piece.scaled(down) for piece in behind], *ends[:3])


def pulse(d: Sequence[float], straight: bool) -> list[Piece]:
    """Return an edge up, a constant, an edge down, of unit acceleration: quarters of a sine, or lines."""
    d1, d2, d3 = d
    if straight:
        up, down = (1 / d if d else 0.0 for d in (d1, d3))
        return [Piece(d1, 0.0, up), Piece(d2, 1.0), Piece(d3, 1.0, -down)]
    edges = [Piece(d, amplitude=1.0, omega=math.pi / (2 * d)) if d else Piece(0.0) for d in (d1, d3)]
    return [edges[0], Piece(d2, 1.0), edges[1]._replace(phase=math.pi / 2)]


def reached(pieces: Sequence[Piece]) -> tuple[float, float]:
    """Return position and velocity at the end of pieces that begin at rest."""
    state = (0.0, 0.0, 0.0)
    for piece in pieces:
        state = end_of(piece, *state)
    return state[1:]


def own(rows: Rows) -> list[Piece]:
    """Return the pieces of the engineer's own law: in a row duration, c0, c1, c2, c3, P, ω, φ."""
    if any(len(row) != OWN_WIDTH for row in rows):
        raise Refused(VALUE)
    durations = [row[0] for row in rows]
    require(min(durations) >= 0.0 and abs(sum(durations) - 1.0) <= SUM_TOLERANCE)
    return [Piece(*row) for row in rows]


def polynomial(declared: Declared, share: float, ends: Ends) -> Law:
    """Return a symmetric polynomial of a share, or, of the share ½, the one between ends."""
    if not any(ends[1:]):
        ahead, behind = (half(declared.half, d).scaled(ends.lift) for d in (share, 1.0 - share))
        return Law([ahead], [behind], ends.lift)
    meets = len(declared.half) // 2
    if share != 0.5 or any(ends[1 + 2 * meets :]):
        raise Refused(NUM)
    return Law([hermite(meets, ends)], lift=ends.lift, begin=ends.v0)
