"""Where the points of a table stand: on the motion's breaks first, then where the rule between them needs them."""

from math import factorial

import numpy as np
from numpy.typing import NDArray

from engine.cams.certificate import derived, enclosing, intervals, local, peaks
from engine.cams.profile import CamProfile
from engine.laws.base import Array

STEPS = 60  # of halving
CUBIC = 4
"""the order of a rule through polynomials of the third degree"""
JUMP = 1e-9  # of the largest y' or y'': a smaller jump is none


def equal(of: CamProfile, n: int) -> Array:
    """Return n points at equal steps over the cycle."""
    return np.linspace(float(of.edges[0]), float(of.edges[-1]), n)


def parted(x: Array, parts: int) -> Array:
    """Return points with others between each two, at so many equal steps."""
    steps = np.linspace(0.0, 1.0, parts, endpoint=False)
    return np.append((x[:-1, None] + np.diff(x)[:, None] * steps).ravel(), x[-1])


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
    steps = _taken(sizes, low, least)
    inner = [np.linspace(a, b, k, endpoint=False) for a, b, k in zip(of.edges[:-1], of.edges[1:], steps, strict=True)]
    return np.concatenate([*inner, of.edges[-1:]])


def _taken(sizes: Array, level: float, least: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return how many steps each piece has: none more than it would of itself, ``level`` as a share of all."""
    share = level / max(1.0 - level, 1e-15)
    return np.maximum(np.ceil(np.minimum(sizes * share, 1e7)), least).astype(np.intp)


def weights(of: CamProfile, order: int) -> Array:
    """Return for each piece its length by the root of its largest derivative of an order, beside the largest."""
    middle, half = intervals(of, of)
    value = np.abs(enclosing(derived(local(of, middle, half), half, order))).max(axis=1)
    found = np.zeros(len(of.origins))
    np.maximum.at(found, of.index(middle), value)
    found[found < found.max(initial=0.0) * 1e-9] = 0.0
    spans = np.diff(of.edges)
    sizes: Array = spans * (found / factorial(order)) ** (1.0 / max(order - 2, 1))
    sizes = sizes / sizes.max() if sizes.max() > 0.0 else sizes
    if order != CUBIC:
        return sizes
    # a spline goes on swinging beside a jump of y'', the less the shorter its steps, also in a parabola that it has
    at = np.isin(of.edges, jumps(of))
    return np.maximum(sizes, np.where(at[:-1] | at[1:], spans / spans.max(), 0.0))


def jumps(of: CamProfile) -> Array:
    """Return the breaks within a profile at which y' or y'' jumps."""
    inner = of.edges[1:-1]
    before, after = of.at(inner, left=True), of.at(inner)
    _, v, a, _ = peaks(of)
    return inner[(np.abs(after.y1 - before.y1) > JUMP * v) | (np.abs(after.y2 - before.y2) > JUMP * a)]
