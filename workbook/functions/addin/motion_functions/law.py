"""Motion laws as pieces that are carried on, each an acceleration of a polynomial and up to two sines."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from functools import cached_property
from typing import NamedTuple, Sequence

VALUE, NUM = 519, 503  # LibreOffice's own numbers of the errors #VALUE! and #NUM!
SERIES = 0.7  # rad, below which h − sin h has lost digits
GRID = 128  # parts of a piece, and more by its sine: where its derivatives change sign is looked for in each
TOLERANCE = 2e-9  # a ξ this near to a break counts as on it
OUTSIDE = 1e-12  # by so much of its range an argument may lie outside it
ENDING = 1e-14  # of the lift: so near to its end a law has reached it
MOST = 1e3  # rad of a sine within a piece: beyond, a cell would keep Calc waiting
JUMP = 1e-9  # of the largest acceleration: a smaller jump is rounding

# Gauss-Legendre with five nodes (Abramowitz & Stegun, 25.4.29), as (node, weight) on −1 … 1
NEAR, FAR = math.sqrt(5 - 2 * math.sqrt(10 / 7)) / 3, math.sqrt(5 + 2 * math.sqrt(10 / 7)) / 3
HEAVY, LIGHT = (322 + 13 * math.sqrt(70)) / 900, (322 - 13 * math.sqrt(70)) / 900
GAUSS = ((0.0, 128 / 225), (NEAR, HEAVY), (-NEAR, HEAVY), (FAR, LIGHT), (-FAR, LIGHT))


class Refused(Exception):  # noqa: N818 - an answer, not a fault
    """The arguments have no value; it holds the number of the spreadsheet's error."""


class Piece(NamedTuple):
    """Duration and coefficients of a(u) = c0 + c1 u + … + P sin(ωu + φ) + …."""

    duration: float
    c: Sequence[float] = ()
    sines: Sequence[tuple[float, float, float]] = ()  # P, ω, φ of each

    @property
    def turned(self) -> float:
        """The angle by which the fastest sine turns (rad)."""
        return self.duration * max((abs(omega) for _, omega, _ in self.sines), default=0.0)

    @property
    def waves(self) -> list[tuple[float, float, float]]:
        """The sines that are there: of others no frequency is too great."""
        return [sine for sine in self.sines if sine[0]]

    def scaled(self, factor: float) -> Piece:
        """Return the piece with its acceleration times ``factor``."""
        sines = [(factor * amplitude, omega, phase) for amplitude, omega, phase in self.sines]
        return Piece(self.duration, [factor * value for value in self.c], sines)

    def gains(self, u: float) -> tuple[float, float]:
        """Return ∬a and ∫a from the begin to u.

        Of a sine, with h = ωu: ∫ = P u (sin φ sin h/h + cos φ (1 − cos h)/h),
        ∬ = P u² (sin φ (1 − cos h)/h² + cos φ (h − sin h)/h²).
        """
        s = v = 0.0
        for i in range(len(self.c) - 1, -1, -1):
            s = s * u + self.c[i] / ((i + 1) * (i + 2))
            v = v * u + self.c[i] / (i + 1)
        s, v = u * u * s, u * v
        for amplitude, omega, phase in self.waves:
            h = omega * u
            sinc, lift, lag = (math.sin(h) / h, 2 * (math.sin(h / 2) / h) ** 2, _lag(h)) if h else (1.0, 0.5, 0.0)
            sin, cos = math.sin(phase), math.cos(phase)
            s += amplitude * u * u * (sin * lift + cos * lag)
            v += amplitude * u * (sin * sinc + cos * lift * h)
        return s, v

    def derivative(self, order: int, u: float) -> float:
        """Return a(u), or its derivative of an order."""
        value = 0.0
        for i in range(len(self.c) - 1, order - 1, -1):
            value = value * u + self.c[i] * math.factorial(i) / math.factorial(i - order)
        for amplitude, omega, phase in self.waves:
            value += amplitude * omega**order * math.sin(omega * u + phase + order * math.pi / 2)
        return value

    def around(self, order: int) -> list[float]:
        """Return the ends, and where between them a, or its derivative of an order, changes its sign."""
        cells, places = GRID + int(16 * self.turned), [0.0, self.duration]
        edges = [k * self.duration / cells for k in range(cells + 1)]
        above = [self.derivative(order, u) > 0.0 for u in edges]
        for k in range(cells):
            low, high = edges[k : k + 2]
            if above[k] != above[k + 1]:
                for _ in range(60):
                    middle = (low + high) / 2
                    low, high = (middle, high) if (self.derivative(order, middle) > 0.0) == above[k] else (low, middle)
                places.append((low + high) / 2)
        return places

    def peak(self, order: int) -> float:
        """Return the largest |a|, or of its derivative of an order."""
        return max(abs(self.derivative(order, u)) for u in self.around(order + 1))

    @property
    def squared(self) -> float:
        """∫a²: to rounding for eight steps, and of a quarter rad."""
        parts = 8 + int(4 * self.turned)
        half = self.duration / parts / 2
        return half * math.fsum(
            weight * self.derivative(0, half * (2 * k + 1 + node)) ** 2 for k in range(parts) for node, weight in GAUSS
        )


def _lag(h: float) -> float:
    """Return (h − sin h)/h², by its series where the difference would lose digits."""
    if abs(h) > SERIES:
        return (h - math.sin(h)) / (h * h)
    term, total = h / 6, h / 6
    for k in range(4, 16, 2):
        term *= -h * h / (k * (k + 1))
        total += term
    return total


class Stage(NamedTuple):
    """A piece at its place, with position and velocity at its begin: s = s0 + v0 u + ∬a, v = v0 + ∫a, u = ξ − x0."""

    piece: Piece
    x0: float = 0.0
    s0: float = 0.0
    v0: float = 0.0

    def state(self, u: float) -> tuple[float, float]:
        """Return s and v at u from its begin."""
        s, v = self.piece.gains(u)
        return self.s0 + self.v0 * u + s, self.v0 + v

    def xi_at(self, s: float) -> float:
        """Return the ξ in the stage that has the position s, by halving."""
        low, high = 0.0, self.piece.duration
        while low < (middle := (low + high) / 2) < high:
            low, high = (low, middle) if self.state(middle)[0] >= s else (middle, high)
        return self.x0 + high


class Coefficients(NamedTuple):
    """C_v, C_a, C_a,rms, C_j (infinite where a jumps), and the lowest velocity."""

    cv: float
    ca: float
    ca_rms: float
    cj: float
    v_min: float


class Law:
    """A law over ξ in [0, 1] from s = 0, of pieces in succession; ``begin`` is the velocity at its begin."""

    def __init__(self, pieces: Sequence[Piece], begin: float = 0.0) -> None:
        self.stages: list[Stage] = []
        x, s, v = 0.0, 0.0, begin
        for piece in pieces:
            if piece.duration > 0.0:
                self.stages.append(Stage(piece, x, s, v))
                s, v = self.stages[-1].state(piece.duration)
                x += piece.duration
        self.end = self.at(1.0)[0]

    def at(self, xi: float) -> tuple[float, float, float, float]:
        """Return s, v, a, j at ξ: of the later stage at a break, of the last at 1. Refuses a ξ outside [0, 1]."""
        if not -OUTSIDE <= xi <= 1.0 + OUTSIDE:
            raise Refused(NUM)
        inside = min(max(xi, 0.0), 1.0)
        reached = min(inside + TOLERANCE, 1.0 - TOLERANCE)
        stage = self.stages[bisect_right([piece.x0 for piece in self.stages], reached) - 1]
        u = inside - stage.x0
        return (*stage.state(u), stage.piece.derivative(0, u), stage.piece.derivative(1, u))

    def xi_at(self, s: float) -> float:
        """Return the first ξ with the position s. The law must not move backwards. Refuses an s that it never has."""
        if not (self.end > 0.0 and -OUTSIDE <= s <= self.end + OUTSIDE):
            raise Refused(NUM)
        if s <= 0.0 or s >= self.end * (1.0 - ENDING):
            return 0.0 if s <= 0.0 else 1.0
        return self.stages[max(bisect_left([piece.s0 for piece in self.stages], s) - 1, 0)].xi_at(s)

    @cached_property
    def coefficients(self) -> Coefficients:
        """The coefficients for unit rise and time; refused are sines of more than 1,000 rad in a piece."""
        pieces = [stage.piece for stage in self.stages]
        if any(piece.turned > MOST for piece in pieces):
            raise Refused(NUM)
        v = [stage.state(u)[1] for stage in self.stages for u in stage.piece.around(0)]
        ca, cj = (max(piece.peak(order) for piece in pieces) for order in (0, 1))
        begins = [*(piece.derivative(0, 0.0) for piece in pieces), 0.0]
        ends = [0.0, *(piece.derivative(0, piece.duration) for piece in pieces)]
        jumps = any(abs(begin - end) > JUMP * ca for begin, end in zip(begins, ends))
        square = math.fsum(piece.squared for piece in pieces)
        return Coefficients(max(map(abs, v)), ca, math.sqrt(square), math.inf if jumps else cj, min(v))
