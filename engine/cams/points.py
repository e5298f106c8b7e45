"""Where the points of a table stand: on the motion's breaks first, then where the rule between them needs them."""

from math import factorial

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import DEGREE, derived, enclosing, intervals, local, peaks
from engine.cams.profile import CamProfile
from engine.laws.base import Array

STEPS = 60  # of halving
CUBIC = 4
"""the order of a rule through polynomials of the third degree"""
JUMP = 1e-9  # of the largest y' or y'': a smaller jump is none
BEFORE = 1e-5
"""of the cycle: so far before a jump of y' or y'' stands a point of its own"""


def equal(of: CamProfile, n: int) -> Array:
    """Return n points at equal steps over the cycle."""
    return np.linspace(float(of.edges[0]), float(of.edges[-1]), n)


def spread(
    of: CamProfile, n: int, order: int, least: NDArray[np.intp], exact: NDArray[np.bool_] | None = None
) -> Array:
    """Return at most n points: the breaks, and between them equal steps by what a rule of an order leaves.

    Between points h apart a rule through polynomials of degree ``order`` − 1 leaves of y'' what goes with
    h^(order − 2) max|y^(order)|; the steps of each piece are the longest that keep this below one level. Each
    piece has ``least`` steps, and no more where it is ``exact``. Raises ValueError where n does not do for these.
    """
    needed = int(least.sum()) + 1
    if n < needed:
        raise ValueError(f"{n} points are given; expected at least {needed}, for the breaks of the motion")
    low, high = 0.0, 1.0
    sizes = weights(of, order)
    if exact is not None:
        sizes = np.where(exact, 0.0, sizes)
        sizes = sizes / max(sizes.max(), 1e-300)
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _taken(sizes, middle, least).sum() + 1 <= n else (low, middle)
    return nodes(of, _taken(sizes, low, least))


def _taken(sizes: Array, level: float, least: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return how many steps each piece has: none more than it would of itself, ``level`` as a share of all."""
    share = level / max(1.0 - level, 1e-15)
    return np.maximum(np.ceil(np.minimum(sizes * share, 1e7)), least).astype(np.intp)


def weights(of: CamProfile, order: int) -> Array:
    """Return for each piece its length by the root of its largest derivative of an order, beside the largest."""
    low, high = intervals(of, of)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    powers = local(of, middle, half)
    value = np.abs(enclosing(derived(powers, half, order))).max(axis=1) if order <= DEGREE else np.zeros(len(low))
    found = np.zeros(len(of.origins))
    np.maximum.at(found, of.index(middle), value)
    found[found < found.max(initial=0.0) * 1e-9] = 0.0
    root = 1.0 / max(order - 2, 1)
    spans = np.diff(of.edges)
    sizes: Array = spans * (found / factorial(order)) ** root
    sizes = sizes / sizes.max() if sizes.max() > 0.0 else sizes
    return np.maximum(sizes, np.where(beside(of), spans / spans.max(), 0.0)) if order == CUBIC else sizes


def beside(of: CamProfile) -> NDArray[np.bool_]:
    """Return which pieces are beside a jump of y'': a spline goes on swinging there, the less the shorter its steps.

    A parabola that a cubic has exactly needs steps all the same.
    """
    at = np.isin(of.edges, jumps(of))
    return np.asarray(at[:-1] | at[1:])


def nodes(of: CamProfile, steps: NDArray[np.intp]) -> Array:
    """Return the breaks of a profile, and between them as many equal steps as each piece has."""
    inner = [np.linspace(a, b, k, endpoint=False) for a, b, k in zip(of.edges[:-1], of.edges[1:], steps, strict=True)]
    return np.concatenate([*inner, of.edges[-1:]])


def doubled(of: CamProfile, x: Array) -> Array:
    """Return points with one more just before each jump: a point has one y' and one y'', which serve both sides."""
    steps = np.array([one - BEFORE * of.total for one in jumps(of)])
    return np.unique(np.concatenate([x, steps]))


def jumps(of: CamProfile) -> Array:
    """Return the breaks within a profile at which y' or y'' jumps."""
    inner = of.edges[1:-1]
    before, after = of.at(inner, left=True), of.at(inner)
    _, v, a, _ = peaks(of)
    return inner[(np.abs(after.y1 - before.y1) > JUMP * v) | (np.abs(after.y2 - before.y2) > JUMP * a)]
