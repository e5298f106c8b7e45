"""Extremes and integrals of functions that are smooth between two points: for what has no closed form."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from engine.laws.base import Array
from engine.laws.crossings import narrowed

PARTS = 16
ROUNDS = 9  # of narrowing a bracket, to an eighth by each
TOPS = 4  # of which are narrowed, at most
NOISE = 1e-9
"""of a quantity's size in its piece: what is smaller at an end has no sign, and a change of sign there is none"""

LAST_ROUNDS = 6  # of narrowing a change of sign: to the last digit
ORDERS = (16, 32, 64, 128)
TOLERANCE = 1e-13
"""of the integral of the size"""
LEAST = 0.1
"""of the scale over the width: of what is smaller, rounding is not asked to be right"""
HALVINGS = 12

Function = Callable[[Array], Array]


def largest(function: Function, low: float, high: float, nodes: int) -> tuple[float, float]:
    """Return the largest value of a function between two points, and where.

    The ends of ``nodes`` parts that are not lower than their neighbours are narrowed, the highest of them; the ends
    count. Right where the function has at most one top within two parts.
    """
    u = np.linspace(low, high, nodes + 1)
    values = function(u)
    padded = np.concatenate([[-np.inf], values, [-np.inf]])
    tops = np.flatnonzero((values >= padded[:-2]) & (values >= padded[2:]))
    tops = tops[np.argsort(-values[tops], kind="stable")[:TOPS]]
    left, right = u[np.maximum(tops - 1, 0)], u[np.minimum(tops + 1, nodes)]
    best = int(np.argmax(values))
    top, place = float(values[best]), float(u[best])
    each, share = np.arange(tops.size), np.linspace(0.0, 1.0, PARTS + 1)
    for _ in range(ROUNDS):
        points = left[:, None] + (right - left)[:, None] * share
        found = function(points.ravel()).reshape(points.shape)
        k = found.argmax(axis=1)
        one = int(found[each, k].argmax())
        if found[one, k[one]] > top:
            top, place = float(found[one, k[one]]), float(points[one, k[one]])
        left, right = points[each, np.maximum(k - 1, 0)], points[each, np.minimum(k + 1, PARTS)]
    return top, place


def crossed(function: Function, low: float, high: float, nodes: int) -> list[float]:
    """Return where a function changes its sign, by nodes between which it does so once at most."""
    u = np.linspace(low, high, nodes + 1)
    values = function(u)
    kept = np.abs(values) > NOISE * float(np.abs(values).max())
    u, positive = u[kept], values[kept] > 0.0
    at = np.flatnonzero(positive[1:] != positive[:-1])
    if not at.size:
        return []
    return [float(one) for one in narrowed(lambda u: function(u) > 0.0, u[at], u[at + 1], LAST_ROUNDS)]


@lru_cache(maxsize=8)
def rule(n: int) -> tuple[Array, Array]:
    """Return the n + 1 nodes of the rule of Clenshaw and Curtis on [0, 1], and its weights.

    Source: C. W. Clenshaw, A. R. Curtis, A method for numerical integration on an automatic computer, Numer. Math. 2
    (1960) 197–205.
    """
    angle = np.pi * np.arange(n + 1) / n
    k = np.arange(0, n + 1, 2)
    terms = np.cos(np.outer(angle, k)) * (2.0 / (1.0 - k.astype(np.float64) ** 2))
    terms[:, [0, -1]] *= 0.5
    weights = terms.sum(axis=1) / n
    weights[[0, -1]] *= 0.5
    return (1.0 - np.cos(angle)) / 2.0, weights


def integral(function: Function, low: float, high: float, scale: float = 0.0) -> float:
    """Return the integral of a function between two points, to :data:`TOLERANCE` of that of its size.

    ``scale`` is the largest that such functions grow elsewhere: to how many digits this one is known. By the rule of
    Clenshaw and Curtis with more and more nodes; where the most do not do, in halves.
    """
    return _integral(function, low, high, LEAST * scale, HALVINGS)


def _integral(function: Function, low: float, high: float, least: float, halvings: int) -> float:
    last = np.nan
    for n in ORDERS:
        nodes, weights = rule(n)
        values = function(low + (high - low) * nodes)
        found = float(weights @ values)
        if abs(found - last) <= TOLERANCE * max(least, float(weights @ np.abs(values))):
            return (high - low) * found
        last = found
    if not halvings:
        return (high - low) * last
    middle = 0.5 * (low + high)
    return sum(_integral(function, a, b, least, halvings - 1) for a, b in ((low, middle), (middle, high)))
