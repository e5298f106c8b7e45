"""Extremes, zeros and integrals of what is smooth between two points: of curves, powers and sines, and of functions."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.drive.drivetrain import Force
from engine.laws.base import Array
from engine.laws.ladder import Curve, narrowed, root, zeros
from engine.motion.pieces import MotionPiece

PARTS = 16
ROUNDS = 9  # of narrowing a bracket, to an eighth by each
FLAT = 1e-13  # of the largest value: what differs by less is all one height
TOPS = 4  # of which are narrowed, at most
NOISE = 1e-9
"""of a quantity's size in its piece: what is smaller at an end has no sign, and a change of sign there is none"""
LAST_ROUNDS = 6  # of narrowing a change of sign: to the last digit
ORDERS = (16, 32, 64, 128)
TOLERANCE = 1e-13  # of the integral of the size
LEAST = 0.1  # of the scale over the width: of what is smaller, rounding is not asked to be right
HALVINGS = 12
Function = Callable[[Array], Array]


class Extremum(NamedTuple):
    """A value of a function, and where it is."""

    value: float
    x: float


def extremes(
    function: Function, low: float, high: float, nodes: int, signs: Sequence[float] = (-1.0, 1.0),
    least: float = -np.inf,
) -> tuple[Extremum, ...]:  # fmt: skip
    """Return the lowest and the largest value of a function between two points: one for each of ``signs``.

    The ends of ``nodes`` parts that are not lower than their neighbours (or not higher) are narrowed, the best of
    them; the ends count. Right where the function has at most one top within two parts, and
    rises above an end of theirs by no more than that is above the lower of its neighbours. Where it stays below
    ``least``, no more is done than is needed to see that.
    """
    u = np.linspace(low, high, nodes + 1)
    values = function(u)
    return tuple(_top(function, sign, u, sign * values, least) for sign in signs)


def _top(function: Function, sign: float, u: Array, values: Array, least: float) -> Extremum:
    """Return where a function, times a sign, is largest; ``values`` of it at u are known."""
    padded = np.concatenate([[-np.inf], values, [-np.inf]])
    tops = np.flatnonzero((values >= padded[:-2]) & (values >= padded[2:]))
    tops = tops[np.argsort(-values[tops], kind="stable")[:TOPS]]
    best = Extremum(float(values[tops[0]]), float(u[tops[0]]))
    before, after = np.maximum(tops - 1, 0), np.minimum(tops + 1, u.size - 1)
    reached, spread = values[tops], values[tops] - np.minimum(values[before], values[after])
    left, right = u[before], u[after]
    for _ in range(ROUNDS):
        worth = (reached + spread >= max(least, best.value)) & (spread > FLAT * np.abs(values).max())
        if not worth.any():
            break
        points = np.linspace(left[worth], right[worth], PARTS + 1, axis=1)
        found = sign * function(points.ravel()).reshape(points.shape)
        each, k = np.arange(len(found)), found.argmax(axis=1)
        reached, spread = found[each, k], found.max(axis=1) - found.min(axis=1)
        highest = int(reached.argmax())
        if reached[highest] > best.value:
            best = Extremum(float(reached[highest]), float(points[highest, k[highest]]))
        left, right = points[each, np.maximum(k - 1, 0)], points[each, np.minimum(k + 1, PARTS)]
    return Extremum(sign * best.value, best.x)


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
def clenshaw_curtis(n: int) -> tuple[Array, Array]:
    """Return the n + 1 nodes of the rule of Clenshaw and Curtis on [0, 1], and its weights.

    Source: C. W. Clenshaw, A. R. Curtis, Numer. Math. 2 (1960) 197–205.
    """
    angle = np.pi * np.arange(n + 1) / n
    k = np.arange(0, n + 1, 2)
    terms = np.cos(np.outer(angle, k)) * (2.0 / (1.0 - k.astype(np.float64) ** 2))
    terms[:, [0, -1]] *= 0.5
    weights = terms.sum(axis=1) / n
    weights[[0, -1]] *= 0.5
    return (1.0 - np.cos(angle)) / 2.0, weights


def integral(function: Function, low: float, high: float, scale: float = 0.0, halvings: int = HALVINGS) -> float:
    """Return the integral of a function between two points, to :data:`TOLERANCE` of that of its size.

    ``scale`` is the largest that such functions grow elsewhere: to how many digits this one is known. By the rule of
    Clenshaw and Curtis with more and more nodes; where the most do not do, in halves.
    """
    last = np.nan
    for n in ORDERS:
        nodes, weights = clenshaw_curtis(n)
        values = function(low + (high - low) * nodes)
        found = float(weights @ values)
        if abs(found - last) <= TOLERANCE * max(LEAST * scale, float(weights @ np.abs(values))):
            return (high - low) * found
        last = found
    if not halvings:
        return (high - low) * last
    middle = 0.5 * (low + high)
    return sum(integral(function, a, b, scale, halvings - 1) for a, b in ((low, middle), (middle, high)))


def force_curve(
    piece: MotionPiece, speed: float, force: Force, share: float = 1.0, inertia: float = 0.0, more: float = 0.0
) -> Curve:
    """Return ``share`` · F + ``inertia`` · ÿ + ``more`` as a curve over u."""
    _, velocity, acceleration, _ = piece.curves
    level, c = share * force.level + more, share * force.viscous * speed
    m = (share * force.mass + inertia) * speed**2
    both = [*(m * c2 for c2 in acceleration.c), 0.0]
    polynomial = [c * c1 + other for c1, other in zip(velocity.c, both, strict=True)]
    polynomial[0] += level
    sines = [(m * p, w, phi) for p, w, phi in acceleration.sines]
    sines += [(c * p, w, phi) for p, w, phi in velocity.sines] if c else []
    joined = []  # those of one ω added up
    for w in dict.fromkeys(w for _, w, _ in sines):
        one = sum(p * np.exp(1j * phi) for p, other, phi in sines if other == w)
        joined.append((float(abs(one)), w, float(np.angle(one))))
    return Curve(tuple(polynomial), tuple(joined))


def sign_changes(curve: Curve, low: float, high: float) -> list[float]:
    """Return where a curve changes its sign beyond rounding: between zeros of its derivative, and so none is missed."""
    slope = curve.derivative()
    turns = [u for u in zeros(slope, high) if low < u < high]
    points = [low, *turns, high]
    values = [curve(u) for u in points]
    noise = NOISE * max(map(abs, values))
    kept = [(u, value) for u, value in zip(points, values, strict=True) if abs(value) > noise]
    return [root(curve, slope, one[0], other[0]) for one, other in pairwise(kept) if (one[1] > 0.0) != (other[1] > 0.0)]


def largest_size(curve: Curve, d: float) -> float:
    """Return the largest size of a curve from 0 to d."""
    return max(abs(curve(u)) for u in (0.0, *zeros(curve.derivative(), d), d))
