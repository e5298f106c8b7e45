"""A motion seen through a mechanism, f(y(x)): by polynomials of degree 5 as close as is asked."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.interpolation import quintics
from engine.cams.profile import CamProfile
from engine.laws.base import Array

NEAR, NEAR_ACCELERATION = 1e-9, 1e-5
"""of the reach of f, and of its largest second derivative: so far may polynomials be off"""
FIRST, NARROWEST = 4, 1e-7
"""intervals of a piece to begin with; of the cycle: the least that is halved"""


class Seen(NamedTuple):
    """f of a position, df/dy and d²f/dy²."""

    value: Array
    first: Array
    second: Array


Outer = Callable[[Array], Seen]


def composed(of: CamProfile, outer: Outer) -> CamProfile:
    """Return f(y(x)) over the same cycle; its jumps of acceleration are those of y, where a piece ends.

    With (f∘y)' = f' y' and (f∘y)'' = f'' y'² + f' y'' at both ends of each interval; one whose middle is off is halved.
    """
    samples = np.linspace(of.edges[0], of.edges[-1], 257)
    value, _, curvature = composed_values(of, outer, samples, of.index(samples))
    most = NEAR * float(np.ptp(value)), NEAR_ACCELERATION * float(np.abs(curvature).max())
    made = [composed_piece(of, outer, k, most) for k in range(len(of.origins))]
    return CamProfile(
        np.append(np.concatenate([one.edges[:-1] for one in made]), of.edges[-1]),
        np.concatenate([one.origins for one in made]),
        np.concatenate([one.c for one in made]),
        np.concatenate([one.sines for one in made]),
    )


def composed_piece(of: CamProfile, outer: Outer, k: int, most: tuple[float, float]) -> CamProfile:
    """Return the polynomials of one piece of y."""
    x = np.linspace(of.edges[k], of.edges[k + 1], FIRST + 1)
    least = NARROWEST * of.total
    while True:
        made = quintics(x, *composed_values(of, outer, x, np.full(len(x), k)))
        middle = 0.5 * (x[:-1] + x[1:])
        value, _, curvature = composed_values(of, outer, middle, np.full(len(middle), k))
        at = made.at(middle)
        off = (np.abs(at.y - value) > most[0]) | (np.abs(at.y2 - curvature) > most[1])
        halved = middle[off & (np.diff(x) > least)]
        if not len(halved):
            return made
        x = np.sort(np.concatenate([x, halved]))


def composed_values(of: CamProfile, outer: Outer, x: Array, k: NDArray[np.intp]) -> tuple[Array, Array, Array]:
    """Return f(y(x)) and its first two derivatives, of y in pieces k."""
    y, v, half = of.taylor(x, k, 3)
    value, first, second = outer(y)
    return value, first * v, second * v**2 + first * 2.0 * half
