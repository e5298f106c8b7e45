"""Where a law changes its formula, where it crosses a level, where it is fastest: for exact peaks."""

from collections.abc import Callable

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.family import Law
from engine.laws.ladder import narrowed

SAMPLES = 257
"""of a stage, between which a crossing is looked for: two crossings within one step are not seen"""

INSIDE = 1e-9
"""of a stage, by which samples keep off its ends, and by twice the tolerance of a break: there a law already has
the value of the next stage"""

ROUNDS = 6
"""of a search for a crossing: 256 times as narrow by each, to the last digit"""


def breaks(law: Law) -> Array:
    """Return every ξ at which the law's formula changes, with 0 and 1, rising."""
    kept = [0.0]
    for xi in law.breaks:
        if kept[-1] + INSIDE < xi < 1.0 - INSIDE:
            kept.append(xi)
    return np.array([*kept, 1.0])


def roots(function: Callable[[Array], Array], edges: Array) -> Array:
    """Return the zeros, with a change of sign, of a function of ξ within the stages between the edges.

    A jump through zero at an edge is not among them: the edge itself is where the sign changes.
    """
    width = np.diff(edges)[:, None]
    off = np.minimum(np.maximum(INSIDE * width, 2.0 * BREAK_TOLERANCE), 0.5 * width)
    xi = edges[:-1, None] + off + (width - 2.0 * off) * np.linspace(0.0, 1.0, SAMPLES)
    above = function(xi) > 0.0
    row, column = np.nonzero(above[:, :-1] != above[:, 1:])
    if row.size == 0:
        return np.empty(0)
    return np.sort(narrowed(lambda x: function(x) > 0.0, xi[row, column], xi[row, column + 1], ROUNDS))


def velocity_extremes(law: Law) -> Array:
    """Return every ξ at which v can be largest or smallest, with 0 and 1, rising."""
    edges = breaks(law)
    return np.union1d(edges, roots(law.a, edges))


def velocity_peak(law: Law) -> float:
    """Return the first ξ at which v is at its largest; of a uniform stage, its begin."""
    xi = velocity_extremes(law)
    v = law.v(xi)
    return float(xi[np.argmax(v >= v.max() - 1e-12 * abs(v.max()))])
