"""Where a movement turns: zeros of its derivatives between known ones, by counting points of a grid.

Between two neighbouring zeros of a derivative a function has at most one, and there it is monotone; so brackets from
the ladder of derivatives suffice. A grid of :data:`PARTS` points tells in which of its parts the sign is lost, and
each round is a hundred times finer. Where an extreme is wanted the place counts twice: 10⁻⁶ gives it to 10⁻¹².
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from itertools import pairwise
from math import perm
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.laws.piece_extremes import NODES, WEIGHTS
from engine.motion.pieces import MotionPiece

PARTS, ROUNDS = 100, 3
LOST = 1e-9
"""of a function's scale: below this it has no sign"""
GRID = np.arange(1, PARTS + 1) / PARTS
WITHIN = float(PARTS) ** -ROUNDS
"""of a bracket: the width of its last part"""


class Narrowed(NamedTuple):
    """The sign with which a bracket begins, and where the sign is lost, round by round; the last is half a part on."""

    sign: float
    places: tuple[float, ...]

    @property
    def place(self) -> float:
        """Where the sign is lost."""
        return self.places[-1]


def narrowed(f: Callable[[Array], Array], low: float, high: float, lost: float) -> Narrowed:
    """Return where a monotone function loses the sign that it has at ``low``: at ``low`` if it has none there."""
    first = float(f(np.array([low]))[0])
    sign = float(np.sign(first)) if abs(first) > lost else 0.0
    width, at, places = high - low, low, []
    for turn in range(1, ROUNDS + 1):
        kept = int(np.count_nonzero(sign * f(at + width * GRID) > lost))
        step = min(kept, PARTS - 1) + (0.5 if turn == ROUNDS else 0.0)
        at += width * step / PARTS
        width /= PARTS
        places.append(at)
    return Narrowed(sign, tuple(places))


class Ladder:
    """The zeros of the derivatives of y = Σ e_n ξⁿ over ξ from 0 to 1.

    Of the n-th derivative of a polynomial of degree m there are m − n places, in order: its zeros there, and for
    want of these ends of brackets, which are places like any other.
    """

    def __init__(self, powers: tuple[float, ...]) -> None:
        self.powers = powers
        self.degree = len(powers) - 1

    @cached_property
    def lost(self) -> float:
        """What counts as no sign."""
        return LOST * float(np.abs(self.powers).sum())

    def value(self, order: int, xi: Array) -> Array:
        """Return a derivative at ξ."""
        c = [perm(n, order) * e for n, e in enumerate(self.powers)][order:]
        return np.polynomial.polynomial.polyval(xi, np.array(c))  # type: ignore[no-any-return]

    @cached_property
    def zeros(self) -> dict[int, list[Narrowed]]:
        """The zeros of each derivative, by its order."""
        found: dict[int, list[Narrowed]] = {}
        edges = [0.0, 1.0]
        for order in range(self.degree - 1, 0, -1):
            brackets = pairwise(edges)
            found[order] = [
                narrowed(lambda xi, n=order: self.value(n, xi), low, high, self.lost)  # type: ignore[misc]
                for low, high in brackets
            ]
            edges = [0.0, *(one.place for one in found[order]), 1.0]
        return found

    def end_sign(self, order: int) -> float:
        """Return the sign of a derivative at ξ = 1; 0 where it has none."""
        value = float(self.value(order, np.ones(1))[0])
        return float(np.sign(value)) if abs(value) > self.lost else 0.0

    def changes(self, order: int) -> list[bool]:
        """Return at which of its places a derivative changes its sign."""
        signs = [*(one.sign for one in self.zeros[order]), self.end_sign(order)]
        return [before * after < 0.0 for before, after in pairwise(signs)]

    def changed(self, order: int, i: int, duration: float) -> float:
        """Return where in a duration a derivative changes its sign in its i-th bracket; 0 where it does not.

        A zero of y' is a step of Newton's nearer than the place that is known.
        """
        if not self.changes(order)[i]:
            return 0.0
        place = self.zeros[order][i].place
        if order > 1:
            return duration * place
        v, a = (float(self.value(n, np.array([place]))[0]) for n in (1, 2))
        return duration * (place - nearer(v, a, WITHIN, self.lost))

    def tops(self, order: int) -> list[float]:
        """Return a derivative (0 is y) where the next one is lost."""
        places = np.array([one.place for one in self.zeros[order + 1]])
        return self.value(order, places).tolist()  # type: ignore[no-any-return]


def nearer(value: float, slope: float, most: float, least: float) -> float:
    """Return a step of Newton's of at most a size; a slope of next to nothing, ``least``, counts as that."""
    step = value * slope / max(slope**2, least**2)
    return max(-most, min(most, step))


class Turn(NamedTuple):
    """Where a piece of a motion comes to rest, if it does, and its position there."""

    at: Narrowed
    y: float


def turn_of(piece: MotionPiece, lost: float) -> Turn:
    """Return where y' of a piece, monotone on it, loses its sign; ``lost`` is what counts as no sign."""
    found = narrowed(lambda u: piece.derivative(1, u), 0.0, piece.duration, lost)
    return Turn(found, float(piece.derivative(0, np.array([found.place]))[0]))


def rest_of(piece: MotionPiece, fastest: float) -> float:
    """Return u at which a piece whose y' is monotone turns round; 0 where it does not beside the largest |y'|."""
    d, lost = piece.duration, LOST * fastest
    found = turn_of(piece, lost).at
    place = found.place
    v, a = (float(piece.derivative(order, np.array([place]))[0]) for order in (1, 2))
    if found.sign * float(piece.derivative(1, np.array([d]))[0]) >= -lost:
        return 0.0
    return place - nearer(v, a, d * WITHIN, lost)


def square_of(piece: MotionPiece) -> float:
    """Return ∫y''² over a piece, by Gauss's rule."""
    u = piece.duration * (NODES + 1.0) / 2.0
    return float(WEIGHTS @ piece.derivative(2, u) ** 2) * piece.duration / 2.0
