"""Motion laws as pieces that are carried on, forwards from the begin and backwards from the end."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from itertools import accumulate
from typing import NamedTuple, Sequence

from .piece import Piece
from .refused import NUM, Refused

TOLERANCE = 2e-9  # a ξ this near to a break counts as on it
OUTSIDE = 1e-12  # by so much of its range an argument may lie outside it
ROUNDING = 4e-16


class Stage(NamedTuple):
    """A piece at its place: with u = ±(ξ − origin), s = base ± (s0 + v0 u + ∬a), v = v0 + ∫a; the sign is ``way``."""

    piece: Piece
    way: int
    origin: float
    base: float
    s0: float
    v0: float

    def at(self, xi: float) -> tuple[float, float, float, float]:
        """Return s, v, a, j at ξ."""
        u = self.way * (xi - self.origin)
        gained_s, gained_v = self.piece.gains(u)
        s = self.base + self.way * (self.s0 + self.v0 * u + gained_s)
        return s, self.v0 + gained_v, self.way * self.piece.derivative(0, u), self.piece.derivative(1, u)

    def xi_at(self, s: float) -> float:
        """Return the ξ in the stage that has the position s, by Newton's method between bounds that close in."""
        wanted = self.way * (s - self.base) - self.s0
        low, high = 0.0, self.piece.duration
        u = high / 2
        for _ in range(200):
            gained_s, gained_v = self.piece.gains(u)
            over, speed = self.v0 * u + gained_s - wanted, self.v0 + gained_v
            low, high = (low, u) if over >= 0.0 else (u, high)
            newton = u - over / speed if speed > 0.0 else -1.0
            following = newton if low <= newton <= high else (low + high) / 2
            done = abs(following - u) <= ROUNDING * u
            u = following
            if done:
                break
        return self.origin + self.way * u


class Law:
    """A law over ξ in [0, 1] from s = 0: pieces from its begin, then pieces as seen backwards from its end.

    ``lift`` is where it ends, ``begin`` and ``finish`` are the velocities at begin and end.
    """

    def __init__(
        self, forward: Sequence[Piece], backward: Sequence[Piece] = (), lift: float = 1.0, begin: float = 0.0,
        finish: float = 0.0,
    ) -> None:  # fmt: skip
        ahead = [piece for piece in forward if piece.duration > 0.0]
        behind = [piece for piece in backward if piece.duration > 0.0]
        *self.begins, end = accumulate([0.0, *(piece.duration for piece in [*ahead, *behind[::-1]])])
        self.stages = [
            *(Stage(p, 1, x, 0.0, s, v) for p, x, s, v in _carried(ahead, begin)),
            *(Stage(p, -1, end - x, lift, s, v) for p, x, s, v in _carried(behind, finish)[::-1]),
        ]
        self.heights = [stage.at(begin)[0] for stage, begin in zip(self.stages, self.begins)]
        self.end = self.at(1.0)[0]

    def at(self, xi: float) -> tuple[float, float, float, float]:
        """Return s, v, a, j at ξ: of the later stage at a break, of the last at 1. Refuses a ξ outside [0, 1]."""
        if not -OUTSIDE <= xi <= 1.0 + OUTSIDE:
            raise Refused(NUM)
        inside = min(max(xi, 0.0), 1.0)
        reached = min(inside + TOLERANCE, 1.0 - TOLERANCE)
        return self.stages[bisect_right(self.begins, reached) - 1].at(inside)

    def xi_at(self, s: float) -> float:
        """Return the first ξ with the position s. The law must not move backwards. Refuses an s that it never has."""
        if not (self.end > 0.0 and -OUTSIDE <= s <= self.end + OUTSIDE):
            raise Refused(NUM)
        if s <= 0.0 or s >= self.end * (1.0 - 4 * ROUNDING):
            return 0.0 if s <= 0.0 else 1.0
        return self.stages[max(bisect_left(self.heights, s) - 1, 0)].xi_at(s)


def _carried(pieces: Sequence[Piece], velocity: float) -> list[tuple[Piece, float, float, float]]:
    """Return each piece with abscissa, position and velocity at its begin, the first with this velocity."""
    found, (x, s, v) = [], (0.0, 0.0, velocity)
    for piece in pieces:
        found.append((piece, x, s, v))
        x, s, v = end_of(piece, x, s, v)
    return found


def end_of(piece: Piece, x: float = 0.0, s: float = 0.0, v: float = 0.0) -> tuple[float, float, float]:
    """Return abscissa, position and velocity at the end of a piece that begins with these."""
    gained_s, gained_v = piece.gains(piece.duration)
    return x + piece.duration, s + v * piece.duration + gained_s, v + gained_v
