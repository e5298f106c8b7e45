"""Every zero of a polynomial plus a sine: each derivative's zeros bracket those of the function before it."""

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array

STEPS = 100  # of Newton's method, or of halving where that leaves the bracket: to the last digit
CELLS = 64  # a half turn, in which two sines together are searched: they have no ladder

Sine = tuple[float, float, float]
"""P, ω, φ of P sin(ωu + φ)"""


@dataclass(frozen=True)
class Curve:
    """f(u) = Σ c_i uⁱ + Σ P sin(ωu + φ)."""

    c: tuple[float, ...]
    sines: tuple[Sine, ...] = ()

    def __call__(self, u: float) -> float:
        """Return f(u)."""
        value = 0.0
        for c in reversed(self.c):
            value = value * u + c
        return value + sum(p * math.sin(w * u + phi) for p, w, phi in self.sines)

    def at(self, u: Array) -> Array:
        """Return f at places."""
        value = np.zeros(np.shape(u))
        for c in reversed(self.c):
            value = value * u + c
        for p, w, phi in self.sines:
            value = value + p * np.sin(w * u + phi)
        return value

    def derivative(self) -> "Curve":
        """Return f'."""
        c = tuple(i * c for i, c in enumerate(self.c))[1:]
        return Curve(c, tuple((p * w, w, phi + math.pi / 2.0) for p, w, phi in self.sines))


def trimmed(f: Curve) -> Curve:
    """Return a curve without the highest powers that are 0."""
    powers = max((k for k, c in enumerate(f.c, 1) if c), default=0)
    return Curve(f.c[:powers], f.sines)


def zeros(f: Curve, d: float) -> list[float]:
    """Return every u from 0 to d at which f changes its sign, rising.

    Between two neighbouring zeros of f' the function is monotone and has at most one zero, so that nothing rests
    on how dense a search is: a polynomial of degree n with a sine needs n + 1 rungs down to the sine alone, whose
    zeros are (kπ − φ)/ω. Two sines without a polynomial are searched in cells.
    """
    f = trimmed(f)
    if not f.c and len(f.sines) < 2:
        return _of_sine(f.sines[0], d) if f.sines else []
    slope = f.derivative()
    if f.c:
        points = [0.0, *zeros(slope, d), d]
    else:
        cells = CELLS * (1 + int(max(abs(w) for _, w, _ in f.sines) * d / math.pi))
        points = [d * k / cells for k in range(cells + 1)]
    values = map(f, points)
    between = zip(itertools.pairwise(points), itertools.pairwise(values), strict=True)
    return [root(f, slope, *cell) for cell, ends in between if min(ends) < 0.0 < max(ends)]


def _of_sine(sine: Sine, d: float) -> list[float]:
    amplitude, w, phi = sine
    if not amplitude or not w:
        return []
    low, high = sorted((phi / math.pi, (phi + w * d) / math.pi))
    found = ((k * math.pi - phi) / w for k in range(math.ceil(low), math.floor(high) + 1))
    return sorted(min(max(u, 0.0), d) for u in found)


def root(f: Curve, slope: Curve, low: float, high: float) -> float:
    """Return the zero between two points of different sign, by Newton's method kept within them."""
    rises = f(high) > 0.0
    u = 0.5 * (low + high)
    for _ in range(STEPS):
        value, rate = f(u), slope(u)
        if value == 0.0:
            break
        low, high = (low, u) if (value > 0.0) == rises else (u, high)
        newton = u - value / rate if rate else low
        following = newton if low < newton < high else 0.5 * (low + high)
        if following in (u, low, high):
            break
        u = following
    return u


PARTS = 256


def narrowed(positive: Callable[[Array], NDArray[np.bool_]], low: Array, high: Array, rounds: int) -> Array:
    """Return the points at which ``positive`` changes within brackets, to 256^-rounds of each bracket.

    ``positive`` takes and returns arrays of shape (n,) and differs at the ends of each bracket; where it changes
    more than once in a bracket, the first change that its samples show is taken. Sampling a whole bracket costs
    hardly more than halving it, and is worth eight halvings.
    """
    share = np.linspace(0.0, 1.0, PARTS + 1)
    each = np.arange(low.size)
    for _ in range(rounds):
        points = low[:, None] + (high - low)[:, None] * share
        above = positive(points.ravel()).reshape(points.shape)
        changed = above != above[:, :1]
        changed[:, -1] = True  # also where rounding hides it
        at = changed.argmax(axis=1)
        low, high = points[each, at - 1], points[each, at]
    return 0.5 * (low + high)
