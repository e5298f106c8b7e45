"""When a law has reached a share of its rise; where its formula changes, and where it is fastest."""

from functools import lru_cache

import numpy as np

from engine.laws.base import ROUNDING, Array, Real, require_within, unwrap
from engine.laws.family import Law
from engine.laws.ladder import zeros
from engine.laws.piece import begins
from engine.laws.piece_extremes import acceleration

KNOTS = 65  # a stage, between which a height is first located
STEPS = 120
LAST_DIGITS = 4e-16  # of ξ: within them rounding of s turns the steps to and fro
BACKWARDS = 1e-9
"""a velocity below minus this, in units of the mean velocity, is a motion backwards"""
INSIDE = 1e-9
"""of a stage: what is nearer to its end is at it"""


def breaks(law: Law) -> Array:
    """Return every ξ at which the law's formula changes, with 0 and 1, rising."""
    kept = [0.0]
    for xi in law.breaks:
        if kept[-1] + INSIDE < xi < 1.0 - INSIDE:
            kept.append(xi)
    return np.array([*kept, 1.0])


def velocity_extremes(law: Law) -> Array:
    """Return every ξ at which v can be largest or smallest, with 0 and 1, rising."""
    pieces, turns = law.as_pieces(), []
    for piece, begin in zip(pieces, begins(pieces), strict=True):
        d = piece.duration
        turns += [begin + u for u in zeros(acceleration(piece), d) if INSIDE * d < u < (1.0 - INSIDE) * d]
    return np.union1d(breaks(law), turns)


def velocity_peak(law: Law) -> float:
    """Return the first ξ at which v is at its largest; of a uniform stage, its begin."""
    xi = velocity_extremes(law)
    v = law.v(xi)
    return float(xi[np.argmax(v >= v.max() - 1e-12 * abs(v.max()))])


@lru_cache(maxsize=256)
def is_monotone(law: Law) -> bool:
    """Whether the law never moves backwards."""
    return bool(law.v(velocity_extremes(law)).min() >= -BACKWARDS)


def inverse(law: Law, s: Real) -> Real:
    """Return ξ with s(ξ) = s, for any law that never moves backwards: a float of a number, an array of an array.

    Newton's method between two bounds that close in, to the last digits of s: the error of ξ is that of s
    over the velocity v(ξ). Where the law stands at s, the first such ξ; the end values give 0 and 1.
    Raises ValueError where s is not a number from 0 to the law's end value, for a law that moves backwards
    and for a dwell. Replaces the reading of a table in S2, 'Cycloid Cam Profile Analysis' (38 % at 44 %).
    """
    wanted = np.asarray(s, dtype=np.float64)
    flat = wanted.reshape(-1)
    end = law.end.s
    if end <= 0.0 or not is_monotone(law):
        raise ValueError(f"{law.name} does not rise throughout; expected a law that never moves backwards")
    require_within("s", flat, 0.0, end, ROUNDING)
    xi = np.where(flat <= 0.0, 0.0, 1.0)
    inside = (flat > 0.0) & (flat < end)
    if inside.any():
        xi[inside] = _solve(law, flat[inside])
    return unwrap(s, [xi.reshape(wanted.shape)])[0]  # type: ignore[no-any-return]


def _solve(law: Law, s: Array) -> Array:
    edges = breaks(law)
    knots = np.unique(edges[:-1, None] + np.diff(edges)[:, None] * np.linspace(0.0, 1.0, KNOTS))
    above = np.clip(np.searchsorted(np.maximum.accumulate(law.s(knots)), s), 1, knots.size - 1)
    low, high = knots[above - 1], knots[above]
    xi = 0.5 * (low + high)
    for _ in range(STEPS):
        at = law.evaluate(xi)
        over = at.s >= s
        low, high = np.where(over, low, xi), np.where(over, xi, high)
        step = np.divide(at.s - s, at.v, out=np.full_like(xi, np.inf), where=at.v > 0.0)
        newton = xi - step
        following = np.where((newton >= low) & (newton <= high), newton, 0.5 * (low + high))
        moved = np.abs(following - xi).max()
        xi = following
        if moved <= LAST_DIGITS:
            break
    return xi
