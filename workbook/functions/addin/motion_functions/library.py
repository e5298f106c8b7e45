"""The laws by code, with their parameters checked, between rests or between prescribed ends.

Most are seven stages: an acceleration from rest (an edge up, a constant, an edge down), a uniform velocity, and a
deceleration of the same kind. Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'.
"""

from __future__ import annotations

import math
import os
import re
from fractions import Fraction
from functools import lru_cache
from typing import Any, Callable, NamedTuple, Sequence, Tuple

from .law import NUM, VALUE, Law, Piece, Refused, Stage

SUM_TOLERANCE = 1e-9  # of the durations of a law
MISSED = 1e-9  # of lift and velocities, by which an own law may miss those at its end
OWN_WIDTH = 8
# the pieces of the own law where none are given
OWN = ((1.0, 0.0, 60.0, -180.0, 120.0, 0.0, 0.0, 0.0),)
Rows = Tuple[Tuple[float, ...], ...]
End = Tuple[float, float, float]
REST: End = (0.0, 0.0, 0.0)  # velocity, acceleration and jerk at an end of a law, per unit of ξ


class LawForm(NamedTuple):
    """A row of ``laws.md``: how a law follows from its parameters."""

    parameters: tuple[str, ...]  # their names in formulas
    delivered: tuple[float, ...]
    form: str  # stages, straight, half or pieces
    formula: str
    half: tuple[float, ...]
    possible: tuple[str, ...]  # conditions that they have to keep to
    takes: tuple[str, ...]  # what it takes, in English, Italian and German

    @property
    def staged(self) -> bool:
        """Whether seven durations say it."""
        return self.form in ("stages", "straight")

    def computed(self, formula: str, p: Sequence[float]) -> Sequence[Any]:
        """Return the values of a formula, which has several, for parameters."""
        return function(", ".join(self.parameters), formula)(*p)

    def stages(self, p: Sequence[float]) -> Sequence[float]:
        """Return the seven durations: those of a formula, else the parameters."""
        return self.computed(self.formula, p) if self.formula else p


@lru_cache(maxsize=None)
def function(parameters: str, formula: str) -> Callable[..., Sequence[Any]]:
    """Return a formula of ``laws.md``, a file beside this, as a function of parameters; it gives each of its values."""
    python = re.sub("(?<![<>])=", "==", formula).replace("^", "**")
    known = {"IF": lambda so, then, other: then if so else other, "OR": lambda *each: any(each), "PI": lambda: math.pi}
    compiled: Callable[..., Sequence[Any]] = eval(f"lambda {parameters}: ({python},)", known)
    return compiled


def numbers(text: str) -> tuple[float, ...]:
    """Return the fractions in a text as numbers."""
    return tuple(float(Fraction(word)) for word in text.split())


def laws_in(text: str) -> dict[str, LawForm]:
    """Return the laws in the rows of the table in a text, by their codes."""
    lines = (line.split("|")[1:-1] for line in text.splitlines() if line.startswith("|"))
    _, _, *rows = ([cell.strip(" `") for cell in line] for line in lines)
    laws = {}
    for code, parameters, delivered, form, formula, possible, *takes in rows:
        half = numbers(formula) if form == "half" else ()
        conditions, words = (tuple(filter(None, texts)) for texts in (possible.split("; "), takes))
        laws[code] = LawForm(tuple(parameters.split()), numbers(delivered), form, formula, half, conditions, words)
    return laws


def mirror_half(half: Sequence[Any]) -> Sequence[Any]:
    """Return the acceleration of a polynomial's second half, by powers of u: that of the first, seen from its end."""
    n = len(half)
    return [-sum(half[i] * math.comb(i, k) * (-1) ** k for i in range(k, n)) for k in range(n)]


with open(os.path.join(os.path.dirname(__file__), "laws.md"), encoding="utf-8") as table:
    LAWS = laws_in(table.read())
PARAMETERS = {code: len(family.delivered) for code, family in LAWS.items()}


@lru_cache(maxsize=512)
def law(code: str, parameters: Rows, lift: float = 1.0, begin: End = REST, end: End = REST) -> Law:
    """Return the law of a code over a lift between ends; refuses unknown codes, parameters or ends it cannot have."""
    if code == "OWN":
        return own_law(parameters, lift, begin, end)
    if code not in LAWS:
        raise Refused(VALUE)
    declared = LAWS[code]
    p = [value for row in parameters for value in row] if declared.delivered else []
    if not any(p):
        p = list(declared.delivered)
    if len(p) != len(declared.delivered):
        raise Refused(VALUE)
    require(all(all(declared.computed(condition, p)) for condition in declared.possible))
    if declared.staged:
        return seven_stages(declared.stages(p), lift, begin, end, declared.form == "straight")
    if declared.half:
        return polynomial(declared.half, p[0], lift, begin, end)
    require(begin == end == REST)  # it begins and ends as it does, whatever is beside it
    d, *c, p1, w1, phi1, p2, w2, phi2, velocity = declared.computed(declared.formula, p)
    return Law([Piece(d, c, [(p1, w1, phi1), (p2, w2, phi2)]).scaled(lift)], velocity * lift)


def own_law(rows: Rows, lift: float, begin: End, end: End) -> Law:
    """Return the law of pieces in rows over a lift, from the velocity at its begin; refuses rows of another width.

    Refuses durations whose sum is not 1 and, unless both ends rest, pieces that miss the lift or the velocity at the
    end.
    """
    if any(len(row) != OWN_WIDTH for row in rows):
        raise Refused(VALUE)
    durations = [row[0] for row in rows]
    require(min(durations) >= 0.0 and abs(sum(durations) - 1.0) <= SUM_TOLERANCE)
    law = Law([Piece(d, c, [(p, w, phi)]).scaled(lift) for d, *c, p, w, phi in rows], begin[0])
    if not begin == end == REST:
        s, v, *_ = law.at(1.0)
        require(abs(s - lift) + abs(v - end[0]) <= MISSED * (abs(lift) + abs(begin[0]) + abs(end[0])))
    return law


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
    (s_a, m), (s_d, n) = end_of_pieces(rise), end_of_pieces(fall)
    first, slid = s_a / m, s_d / n
    top = (lift - v0 * (sum(d[:3]) - first) - v1 * slid) / (first + d[3] + sum(d[4:]) - slid)
    up, down = (top - v0) / m, (v1 - top) / n
    return Law([*(x.scaled(up) for x in rise), Piece(d[3]), *(x.scaled(down) for x in fall)], v0)


def pulse(d: Sequence[float], straight: bool) -> list[Piece]:
    """Return an edge up, a constant, an edge down, of unit acceleration: quarters of a sine, or lines."""
    d1, d2, d3 = d
    if straight:
        up, down = (1 / d if d else 0.0 for d in (d1, d3))
        return [Piece(d1, (0.0, up)), Piece(d2, (1.0,)), Piece(d3, (1.0, -down))]
    up, down = (math.pi / (2 * d) if d else 0.0 for d in (d1, d3))
    return [Piece(d1, (), [(1.0, up, 0.0)]), Piece(d2, (1.0,)), Piece(d3, (), [(1.0, down, math.pi / 2)])]


def end_of_pieces(pieces: Sequence[Piece]) -> tuple[float, float]:
    """Return position and velocity at the end of pieces that begin at rest."""
    s, v = 0.0, 0.0
    for piece in pieces:
        s, v = Stage(piece, 0.0, s, v).state(piece.duration)
    return s, v


def polynomial(half: Sequence[float], share: float, lift: float, begin: End, end: End) -> Law:
    """Return a symmetric polynomial of a share, or, of the share ½, that between ends."""
    if begin == end == REST:
        halves = (half, share), (mirror_half(half), 1.0 - share)
        return Law([Piece(d, [2.0 * lift * c / d ** (i + 1) for i, c in enumerate(half)]) for half, d in halves])
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
    return Piece(1.0, [i * (i - 1) * s[i] for i in range(2, 2 * n)])
