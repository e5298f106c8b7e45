"""Extremes, zeros and integrals of smooth functions between two points, and of curves: powers and sines."""

import math
from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.laws.extremes import Curve, narrow, zeros

PARTS = 16  # of a bracket, in a round
ROUNDS = 9  # of narrowing a bracket, to an eighth each
FLAT = 1e-13  # share of the largest value by which equal values may differ
TOPS = 4  # local extremes that are narrowed, at most
NOISE = 1e-9  # share of the largest value: a smaller value has no sign
LAST_ROUNDS = 6  # of narrowing a change of sign, to the last digit
ORDERS = (16, 32, 64, 128)  # of the rule of integration, in succession
TOLERANCE = 1e-13  # of the integral of the absolute value
LEAST = 0.1  # share of the scale: the tolerance is no smaller than that of an integral of so much over the width
HALVINGS = 12  # of the range of an integral, at most
Function = Callable[[Array], Array]


class Extremum(NamedTuple):
    """An extreme value of a function."""

    value: float
    x: float  # where it is


def extremes(
    function: Function, samples: Array, signs: Sequence[float] = (-1.0, 1.0), least: float = -np.inf
) -> tuple[Extremum, ...]:
    """Return the lowest and the largest value of a function from the first to the last sample.

    The best samples are narrowed. The result is right if the function has at most one maximum within three of them,
    which exceeds a sample by no more than the sample does the lower of its neighbours.

    Parameters
    ----------
    function : callable
        From array (n,), in the unit of the samples, to array (n,), in any unit.
    samples : array (n,)
        Abscissae in order.
    signs : sequence of {-1.0, 1.0}
        −1 asks for the lowest value, 1 for the largest.
    least : float, in the unit of the values
        A value that an extreme, times its sign, must reach to be narrowed.

    Returns
    -------
    tuple of Extremum, for each sign
    """
    values = function(samples)
    return tuple(_top(function, sign, samples, sign * values, least) for sign in signs)


def _top(function: Function, sign: float, u: Array, values: Array, least: float) -> Extremum:
    """Return the largest value of a function times a sign; ``values`` are those of the product at u."""
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
        sampled = sign * function(points.ravel()).reshape(points.shape)
        each, k = np.arange(len(sampled)), sampled.argmax(axis=1)
        reached, spread = sampled[each, k], sampled.max(axis=1) - sampled.min(axis=1)
        highest = int(reached.argmax())
        if reached[highest] > best.value:
            best = Extremum(float(reached[highest]), float(points[highest, k[highest]]))
        left, right = points[each, np.maximum(k - 1, 0)], points[each, np.minimum(k + 1, PARTS)]
    return Extremum(sign * best.value, best.x)


def crossings(function: Function, u: Array) -> list[float]:
    """Return every u at which a function changes its sign, if it does so at most once between two samples at u."""
    values = function(u)
    clear = np.abs(values) > NOISE * float(np.abs(values).max())
    u, positive = u[clear], values[clear] > 0.0
    at = np.flatnonzero(positive[1:] != positive[:-1])
    if not at.size:
        return []
    return [float(zero) for zero in narrow(lambda u: function(u) > 0.0, u[at], u[at + 1], LAST_ROUNDS)]


# the nodes of the rule on [−1, 1], and its weights
gauss_legendre = cache(np.polynomial.legendre.leggauss)


def integral(function: Function, low: float, high: float, scale: float = 0.0, halvings: int = HALVINGS) -> float:
    """Return the integral of a function between two points, to :data:`TOLERANCE` of that of its absolute value.

    The rule of Gauss and Legendre is used with 16 to 128 nodes, then on halves of the range.

    Parameters
    ----------
    function : callable
        From array (n,), in the unit of the two points, to array (n,), in any unit.
    low, high : float
        The two points.
    scale : float, in the unit of the values
        The largest absolute value outside this range, whose rounding this integral need not undercut.
    halvings : int
        How often the range may be halved.

    Returns
    -------
    float, in the unit of the values times that of the points
    """
    middle, half, last = 0.5 * (low + high), 0.5 * (high - low), np.nan
    for n in ORDERS:
        nodes, weights = gauss_legendre(n)
        values = function(middle + half * nodes)
        value = half * float(weights @ values)
        if abs(value - last) <= TOLERANCE * half * max(2.0 * LEAST * scale, float(weights @ np.abs(values))):
            return value
        last = value
    if not halvings:
        return last
    return math.fsum(integral(function, a, b, scale, halvings - 1) for a, b in ((low, middle), (middle, high)))


def sign_changes(curve: Curve, low: float, high: float) -> list[float]:
    """Return every u between two others at which a curve changes its sign beyond rounding, rising.

    It does so at most once between two zeros of its slope.
    """
    turns = [u for u in zeros(curve.slope, high) if low < u < high]
    points = [low, *turns, high]
    values = [curve(u) for u in points]
    noise = NOISE * max(map(abs, values))
    clear = [(u, value) for u, value in zip(points, values, strict=True) if abs(value) > noise]
    return [curve.root(a, b) for (a, at_a), (b, at_b) in pairwise(clear) if (at_a > 0.0) != (at_b > 0.0)]


def least_use(
    uses: Callable[[Array], Array],
    start: Array,
    margins: Callable[[Array], Array],
    slope: float = 1.5e-8,
) -> Array:
    """Return variables near some at which the largest of several uses is least; they may miss the margins.

    Parameters
    ----------
    uses : callable
        From variables (n,) to an array of uses.
    start : array
        Of the variables (n,).
    margins : callable
        From variables between 0 and 1 to an array of what is not to be below 0.
    slope : float
        By how much a variable changes where a slope is worked out.

    Returns
    -------
    array of the shape of ``start``
    """
    from scipy.optimize import minimize  # slow to import

    solved = minimize(
        lambda both: both[-1],
        np.append(start, float(uses(start).max())),
        jac=lambda both: np.append(np.zeros(start.size), 1.0),
        bounds=[*[(0.0, 1.0)] * start.size, (None, None)],
        constraints=[
            {"type": "ineq", "fun": lambda both: both[-1] - uses(both[:-1])},
            {"type": "ineq", "fun": lambda both: margins(both[:-1])},
        ],
        method="SLSQP",
        options={"maxiter": 60, "ftol": 1e-7, "eps": slope},
    )
    return np.asarray(solved.x[:-1])
