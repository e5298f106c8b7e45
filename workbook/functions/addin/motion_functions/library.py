"""The laws by code, with their parameters checked, between rests or between prescribed ends.

Most are seven stages: an acceleration from rest (an edge up, a constant, an edge down), a uniform velocity, and a
deceleration, which is an acceleration seen backwards from its end. Source: S1, 'Modified trapezoidal (acceleration)
curve (seven parameters)'.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Callable, NamedTuple, Sequence, Tuple

from .law import Law, end_of
from .piece import Piece
from .polynomials import POLYNOMIALS, halves, hermite
from .refused import NUM, VALUE, Refused

SUM_TOLERANCE = 1e-9  # of the durations of a law
OWN_WIDTH = 8

Rows = Tuple[Tuple[float, ...], ...]
Seven = Tuple[float, ...]


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
    count = PARAMETERS[code]
    p = [value for row in parameters for value in row] if count else []
    if not any(p):
        p = list(DELIVERED[code])
    if len(p) != count:
        raise Refused(VALUE)
    return LAWS[code][1](p, ends)


def standing(pieces: Sequence[Piece], ends: Ends, begin: float = 0.0) -> Law:
    """Return a law that begins and ends as it does, whatever is beside it; refuses all other ends."""
    if any(ends[1:]):
        raise Refused(NUM)
    return Law([piece.scaled(ends.lift) for piece in pieces], lift=ends.lift, begin=begin * ends.lift)


def require(possible: bool) -> None:
    """Refuse parameters that are not possible."""
    if not possible:
        raise Refused(NUM)


def sines(durations: Callable[..., Seven]) -> Callable[[Sequence[float], Ends], Law]:
    """Return what makes a law whose edges are quarters of a sine, of the durations that parameters make."""
    return lambda p, ends: seven_stages(durations(*p), ends, quarters)


def seven_stages(d: Seven, ends: Ends, lobe: Callable[[float, float, float], list[Piece]]) -> Law:
    """Return the law whose two parts meet at one velocity V, and which gains the lift.

    For unit acceleration the parts gain m and n and travel S_a and S_d from rest, over T₁ and T₂: then
    V = [H − v0 (T₁ − S_a/m) − v1 (T₂ − S_d/n)]/(S_a/m + d4 + S_d/n), A = (V − v0)/m and B = (V − v1)/n.
    """
    if any(ends[3:]):
        raise Refused(NUM)
    ahead, behind = lobe(*d[:3]), lobe(d[6], d[5], d[4])
    (s_a, m), (s_d, n) = reached(ahead), reached(behind)
    first, last = s_a / m, s_d / n
    slid = ends.v0 * (sum(d[:3]) - first) + ends.v1 * (sum(d[4:]) - last)
    top = (ends.lift - slid) / (first + d[3] + last)
    up, down = (top - ends.v0) / m, (top - ends.v1) / n
    forward = [*(piece.scaled(up) for piece in ahead), Piece(d[3])]
    return Law(forward, [piece.scaled(down) for piece in behind], *ends[:3])


def quarters(d1: float, d2: float, d3: float) -> list[Piece]:
    """Return a quarter sine up, a constant, a quarter sine down, of unit acceleration."""
    edges = [Piece(d, amplitude=1.0, omega=math.pi / (2 * d)) if d else Piece(0.0) for d in (d1, d3)]
    return [edges[0], Piece(d2, 1.0), edges[1]._replace(phase=math.pi / 2)]


def ramps(d1: float, d2: float, d3: float) -> list[Piece]:
    """Return a line up, a constant, a line down, of unit acceleration."""
    up, down = (1 / d if d else 0.0 for d in (d1, d3))
    return [Piece(d1, 0.0, up), Piece(d2, 1.0), Piece(d3, 1.0, -down)]


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


def seven(*d: float) -> Seven:
    """Return seven durations."""
    require(min(d) >= 0.0 and abs(sum(d) - 1.0) <= SUM_TOLERANCE and sum(d[:3]) > 0.0 and sum(d[4:]) > 0.0)
    return d


def shared(share: float, rise: Seven, fall: Seven, cruise: float = 0.0) -> Seven:
    """Return the durations of two pulses by their own shares of either part, the second told from its end."""
    require(0.0 < share < 1.0)
    return (*(share * d for d in rise), cruise, *((1.0 - share) * d for d in fall[::-1]))


def between(rise_end: float, fall_start: float, edge: float) -> Seven:
    """Return the durations of two ramps and a cruise, ``edge`` of a ramp being either of its edges."""
    require(0.0 < rise_end <= fall_start < 1.0)
    up, down = ((d * edge, d * (1.0 - 2.0 * edge), d * edge) for d in (rise_end, 1.0 - fall_start))
    return (*up, fall_start - rise_end, *down)


def modified_sine(share: float, rise: float, fall: float) -> Seven:
    """Return the durations of quarter sines, by the outer edge of either half."""
    require(0.0 <= rise <= 1.0 and 0.0 <= fall <= 1.0)
    return shared(share, (rise, 0.0, 1.0 - rise), (fall, 0.0, 1.0 - fall))


def cut(share: float, turns: float, edge: float) -> Seven:
    """Return the durations of modified trapezoids, one of them cut off where the motion turns round."""
    require(turns in (-1.0, 0.0, 1.0) and 0.0 <= edge <= 1.0)
    rise, fall = ((0.0, 1.0 - edge, edge) if turns == end else (0.25, 0.5, 0.25) for end in (-1.0, 1.0))
    return shared(share, rise, fall)


def sine_constant_cosine(sine: float, constant: float, cosine: float, straight: float, share: float) -> Seven:
    """Return the durations of sine edges, constants, cosine edges and a straight line."""
    parts = (sine, constant, cosine)
    require(min(*parts, straight) >= 0.0 and sum(parts) > 0.0 and abs(sum(parts) + straight - 1.0) <= SUM_TOLERANCE)
    return shared(share, parts, parts, straight)


def harmonic_combination(share: float, turns: float) -> Seven:
    """Return the durations of a modified sine's half, and a quarter of a sine where the motion turns round."""
    require(turns in (-1.0, 1.0))
    rise, fall = ((0.0, 0.0, 1.0) if turns == end else (0.25, 0.0, 0.75) for end in (-1.0, 1.0))
    return shared(share, rise, fall)


def sine_straight_sine(share: float, curved: float) -> Seven:
    """Return the durations of two quarters of a sine and a straight line."""
    require(0.0 < curved <= 1.0)
    edge = (0.0, 0.0, curved)
    return shared(share, edge, edge, 1.0 - curved)


def double_harmonic(p: Sequence[float], ends: Ends) -> Law:
    """Return the law of two sines, from rest to a reversal at its end, or the other way round."""
    require(p[0] in (-1.0, 1.0))
    size = math.pi**2 / 2
    first, second = (math.pi / 2, math.pi / 2) if p[0] == 1.0 else (-1.5 * math.pi, -2.5 * math.pi)
    piece = Piece(1.0, amplitude=size, omega=math.pi, phase=first)
    return standing([piece._replace(amplitude2=-size, omega2=2 * math.pi, phase2=second)], ends)


def polynomial(code: str) -> Callable[[Sequence[float], Ends], Law]:
    """Return what makes a symmetric polynomial of a share, or, of the share ½, the one between ends."""
    meets = POLYNOMIALS[code]

    def made(p: Sequence[float], ends: Ends) -> Law:
        (share,) = p
        require(0.0 < share < 1.0)
        if not any(ends[1:]):
            ahead, behind = halves(code, share)
            return Law([ahead.scaled(ends.lift)], [behind.scaled(ends.lift)], ends.lift)
        if share != 0.5 or any(ends[1 + 2 * meets :]):
            raise Refused(NUM)
        return Law([hermite(code, ends)], lift=ends.lift, begin=ends.v0)

    return made


HALVES = (0.5, 0.0, 0.5)
EDGE, FLAT = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)
LAWS: dict[str, tuple[tuple[float, ...], Callable[[Sequence[float], Ends], Law]]] = {
    "DWL": ((), lambda p, ends: standing([Piece(1.0)], ends)),
    "LIN": ((), lambda p, ends: standing([Piece(1.0)], ends, 1.0)),
    "ACS": ((0.5,), sines(lambda share: shared(share, FLAT, FLAT))),
    "TVP": ((1 / 3, 2 / 3), sines(lambda rise_end, fall_start: between(rise_end, fall_start, 0.0))),
    "CIC": ((0.5,), sines(lambda share: shared(share, HALVES, HALVES))),
    "CUB": ((0.5,), polynomial("CUB")),
    "MTP": ((0.125, 0.25, 0.125, 0.0, 0.125, 0.25, 0.125), sines(seven)),
    "SHM": ((0.5,), sines(lambda share: shared(share, EDGE, EDGE))),
    "DHM": ((1.0,), double_harmonic),
    "PO5": ((0.5,), polynomial("PO5")),
    "PO7": ((0.5,), polynomial("PO7")),
    "MSN": ((0.5, 0.25, 0.25), sines(modified_sine)),
    "MTS": ((0.5, 0.0, 0.5), sines(cut)),
    "SCC": ((1 / 3, 1 / 3, 1 / 3, 0.0, 0.5), sines(sine_constant_cosine)),
    "HAC": ((0.5, 1.0), sines(harmonic_combination)),
    "SGS": ((0.5, 0.5), sines(sine_straight_sine)),
    "SRT": ((0.25, 0.75), sines(lambda rise_end, fall_start: between(rise_end, fall_start, 0.5))),
    "SCV": (
        (1 / 12, 1 / 6, 1 / 12, 1 / 3, 1 / 12, 1 / 6, 1 / 12),
        lambda p, ends: seven_stages(seven(*p), ends, ramps),
    ),
}
"""what each law takes, as delivered, and what makes the law of it; the own law beside them takes rows of pieces"""
DELIVERED = {code: values for code, (values, _) in LAWS.items()}
PARAMETERS = {code: len(values) for code, values in DELIVERED.items()}
OWN: Rows = ((1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0),)
"""the own law where none is given"""
