"""The laws by code, with their parameters checked, between rests or between prescribed ends.

Most are seven stages: an acceleration from rest (an edge up, a constant, an edge down), a uniform velocity, and a
deceleration of the same kind. Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, Callable, Mapping, NamedTuple, Sequence, Tuple

from .law import NUM, VALUE, Law, Piece, Refused, Stage

SUM_TOLERANCE = 1e-9  # of the durations of a law
OWN_WIDTH = 8
# the pieces of the own law where none are given
OWN = ((1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0),)
Rows = Tuple[Tuple[float, ...], ...]
End = Tuple[float, float, float]
REST: End = (0.0, 0.0, 0.0)  # velocity, acceleration and jerk at an end of a law, per unit of ξ


class Domain(NamedTuple):
    """The numbers that a parameter may be: those named, else from 0 to 1; ``open`` without both ends."""

    among: tuple[float, ...] = ()
    open: bool = False

    def has(self, value: float) -> bool:
        """Whether a number is in the domain."""
        if self.among:
            return value in self.among
        return 0.0 < value < 1.0 if self.open else 0.0 <= value <= 1.0


class LawForm(NamedTuple):
    """A law: its parameters as delivered, and its form, of three.

    ``stages`` gives the durations of the edge up, the constant and the edge down of the first pulse, of the uniform
    velocity, and of the second pulse in the order of time; edges are quarters of a sine, or ``straight``. ``half``
    has the acceleration of a polynomial's first half by powers of u/λ, over 1/λ and twice. ``pieces`` gives the
    entries of each piece by name, and ``begin`` is the velocity with which they begin.
    """

    delivered: tuple[float, ...] = ()
    stages: Callable[..., Sequence[Any]] | None = None
    straight: bool = False
    half: tuple[float, ...] = ()
    pieces: Callable[..., Sequence[Mapping[str, Any]]] | None = None
    begin: float = 0.0
    # of parameters by place, where the durations do not tell what is impossible
    domains: Mapping[int, Domain] = {}


def turning(turn: Any, end: float, then: Any, other: Any) -> Any:
    """Return ``then`` where a motion turns round at this end (−1 start, 1 end), else ``other``."""
    if isinstance(turn, (int, float)):
        return then if turn == end else other
    return turn.chosen(end, then, other)


def shared(share: Any, rise: Sequence[Any], fall: Sequence[Any], cruise: Any = 0.0) -> Sequence[Any]:
    """Return the durations of two pulses by the shares of their stages, those of the second from its end."""
    return (*(share * d for d in rise), cruise, *((1.0 - share) * d for d in fall[::-1]))


def cut(share: Any, turn: Any, whole: Sequence[Any], rest: Sequence[Any]) -> Sequence[Any]:
    """Return the durations of two pulses, of which that where the motion turns round has the stages ``rest``."""
    rise, fall = ([turning(turn, end, *both) for both in zip(rest, whole)] for end in (-1.0, 1.0))
    return shared(share, rise, fall)


def mirrored(half: Sequence[Any]) -> Sequence[Any]:
    """Return the acceleration of a polynomial's second half, by powers of u: that of the first, seen from its end."""
    n = len(half)
    return [-sum(half[i] * math.comb(i, k) * (-1) ** k for i in range(k, n)) for k in range(n)]


def two_sines(turn: Any) -> Sequence[Mapping[str, Any]]:
    """Return the piece of the double harmonic, from rest to a reversal at its end, or the other way round."""
    first, second = (turning(turn, 1.0, 0.5 * math.pi, past * math.pi) for past in (-1.5, -2.5))
    p = math.pi**2 / 2
    return [
        {
            "duration": 1.0,
            "amplitude": p,
            "omega": math.pi,
            "phase": first,
            "amplitude2": -p,
            "omega2": 2.0 * math.pi,
            "phase2": second,
        }
    ]


# stages of a pulse
FLAT, HALVES, EDGE, QUARTERS = (0.0, 1.0, 0.0), (0.5, 0.0, 0.5), (0.0, 0.0, 1.0), (0.25, 0.5, 0.25)
ENDS, ANYWHERE, PART = Domain((-1.0, 1.0)), Domain((-1.0, 0.0, 1.0)), Domain()
SHARED = {0: Domain(open=True)}
LAWS: dict[str, LawForm] = {
    "DWL": LawForm(pieces=lambda: [{"duration": 1.0}]),
    "LIN": LawForm(pieces=lambda: [{"duration": 1.0}], begin=1.0),
    "ACS": LawForm((0.5,), lambda share: shared(share, FLAT, FLAT)),
    "CIC": LawForm((0.5,), lambda share: shared(share, HALVES, HALVES)),
    "CUB": LawForm((0.5,), half=(1.5, -1.5), domains=SHARED),
    "SHM": LawForm((0.5,), lambda share: shared(share, EDGE, EDGE)),
    "PO5": LawForm((0.5,), half=(0.0, 7.5, -11.25, 3.75), domains=SHARED),
    "PO7": LawForm((0.5,), half=(0.0, 0.0, 26.25, -52.5, 32.8125, -6.5625), domains=SHARED),
    "TVP": LawForm((1 / 3, 2 / 3), lambda rise, fall: (0.0, rise, 0.0, fall - rise, 0.0, 1.0 - fall, 0.0)),
    "SRT": LawForm((0.25, 0.75), lambda rise, fall:
                    (rise / 2, 0.0, rise / 2, fall - rise, (1.0 - fall) / 2, 0.0, (1.0 - fall) / 2)),
    "MTP": LawForm((0.125, 0.25, 0.125, 0.0, 0.125, 0.25, 0.125), lambda *d: d),
    "SCV": LawForm((1 / 12, 1 / 6, 1 / 12, 1 / 3, 1 / 12, 1 / 6, 1 / 12), lambda *d: d, straight=True),
    "DHM": LawForm((1.0,), pieces=two_sines, domains={0: ENDS}),
    "MSN": LawForm((0.5, 0.25, 0.25), lambda share, first, last:
                    shared(share, (first, 0.0, 1.0 - first), (last, 0.0, 1.0 - last))),
    "MTS": LawForm((0.5, 0.0, 0.5), lambda share, turn, edge: cut(share, turn, QUARTERS, (0.0, 1.0 - edge, edge)),
                    domains={1: ANYWHERE, 2: PART}),
    "SCC": LawForm((1 / 3, 1 / 3, 1 / 3, 0.0, 0.5), lambda outer, level, inner, cruise, share:
                    shared(share, (outer, level, inner), (outer, level, inner), cruise)),
    "HAC": LawForm((0.5, 1.0), lambda share, turn: cut(share, turn, (0.25, 0.0, 0.75), EDGE), domains={1: ENDS}),
    "SGS": LawForm((0.5, 0.5), lambda share, curved:
                    shared(share, (0.0, 0.0, curved), (0.0, 0.0, curved), 1.0 - curved)),
}  # fmt: skip
PARAMETERS = {code: len(family.delivered) for code, family in LAWS.items()}


@lru_cache(maxsize=512)
def law(code: str, parameters: Rows, lift: float = 1.0, begin: End = REST, end: End = REST) -> Law:
    """Return the law of a code over a lift between ends; refuses unknown codes, parameters or ends it cannot have."""
    if code == "OWN":
        require(begin == end == REST)
        return own_law(parameters, lift)
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
        return seven_stages(declared.stages(*p), lift, begin, end, declared.straight)
    if declared.half:
        return polynomial(declared.half, p[0], lift, begin, end)
    require(begin == end == REST)  # it begins and ends as it does, whatever is beside it
    pieces = declared.pieces(*p) if declared.pieces else []
    return Law([Piece(**entries).scaled(lift) for entries in pieces], declared.begin * lift)


def own_law(rows: Rows, lift: float) -> Law:
    """Return the law of pieces in rows over a lift; refuses rows of another width, durations whose sum is not 1."""
    if any(len(row) != OWN_WIDTH for row in rows):
        raise Refused(VALUE)
    durations = [row[0] for row in rows]
    require(min(durations) >= 0.0 and abs(sum(durations) - 1.0) <= SUM_TOLERANCE)
    return Law([Piece(*row).scaled(lift) for row in rows])


def require(possible: bool) -> None:
    """Refuse parameters that are not possible."""
    if not possible:
        raise Refused(NUM)


def seven_stages(d: Sequence[float], lift: float, begin: End, end: End, straight: bool) -> Law:
    """Return the law whose two pulses meet at the same velocity V, and which gains the lift H.

    Refuses durations that do not fill the rise, and pulses of no duration. For unit acceleration the pulses gain m and
    n and travel S_a and S_d from rest, over T₁ and T₂: then A = (V − v0)/m, B = (V − v1)/n and
    V = [H − v0 (T₁ − S_a/m) − v1 S_d/n]/(S_a/m + d4 + T₂ − S_d/n).
    """
    require(min(d) >= 0.0 and abs(sum(d) - 1.0) <= SUM_TOLERANCE and sum(d[:3]) > 0.0 and sum(d[4:]) > 0.0)
    require(not any(begin[1:] + end[1:]))
    v0, v1 = begin[0], end[0]
    rise, fall = pulse(d[:3], straight), pulse(d[4:], straight)
    (s_a, m), (s_d, n) = reached(rise), reached(fall)
    first, slid = s_a / m, s_d / n
    top = (lift - v0 * (sum(d[:3]) - first) - v1 * slid) / (first + d[3] + sum(d[4:]) - slid)
    up, down = (top - v0) / m, (v1 - top) / n
    return Law([*(x.scaled(up) for x in rise), Piece(d[3]), *(x.scaled(down) for x in fall)], v0)


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
    s, v = 0.0, 0.0
    for piece in pieces:
        s, v = Stage(piece, 0.0, s, v).state(piece.duration)
    return s, v


def polynomial(half: Sequence[float], share: float, lift: float, begin: End, end: End) -> Law:
    """Return a symmetric polynomial of a share, or, of the share ½, that between ends."""
    if begin == end == REST:
        halves = (half, share), (mirrored(half), 1.0 - share)
        c = [{f"c{i}": 2.0 * lift * value / d ** (i + 1) for i, value in enumerate(half)} for half, d in halves]
        return Law([Piece(share, **c[0]), Piece(1.0 - share, **c[1])])
    n = len(half) // 2 + 1
    require(share == 0.5 and not any(begin[n - 1 :] + end[n - 1 :]))
    return Law([hermite(n, lift, begin, end)], begin[0])


def hermite(n: int, lift: float, begin: End, end: End) -> Piece:
    """Return the polynomial that meets s, v and so on, two, three or four of them, at either end.

    Of s = Σ s_i ξ^i + ξⁿ Σ b_k (ξ − 1)^k the first powers are those of the begin. With ``left``, Taylor's
    coefficients at 1 of what these leave, and those of ξ⁻ⁿ, (−1)^k C(n + k − 1, k), b is the product of both series.
    """
    first, last = ([s, v, a / 2, j / 6][:n] for s, (v, a, j) in ((0.0, begin), (lift, end)))
    left = [last[k] - sum(math.comb(i, k) * first[i] for i in range(k, n)) for k in range(n)]
    inverse = [(-1) ** k * math.comb(n + k - 1, k) for k in range(n)]
    b = [sum(left[i] * inverse[k - i] for i in range(k + 1)) for k in range(n)]
    rest = [0.0] * n
    for value in b[::-1]:  # Horner's scheme in ξ − 1
        rest = [before - here for before, here in zip([0.0, *rest[:-1]], rest)]
        rest[0] += value
    s = [*first, *rest]
    return Piece(1.0, **{f"c{i - 2}": i * (i - 1) * s[i] for i in range(2, 2 * n)})
