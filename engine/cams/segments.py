"""A motion as the segments that controllers know: exact where it is one, polynomials of degree 5 elsewhere."""

import numpy as np
from numpy.typing import NDArray

from engine.cams.interpolation import quintics
from engine.cams.profile import CamProfile
from engine.laws.base import Array

HIGHEST = 6
"""power of a segment's polynomial"""


def simple(of: CamProfile) -> NDArray[np.bool_]:
    """Return which pieces are a polynomial of degree 6 at most, and one sine at most."""
    sines = (of.sines[:, :, 0] != 0.0).sum(axis=1) if of.sines.size else np.zeros(len(of.c), dtype=np.intp)
    return np.asarray((of.c[:, HIGHEST + 1 :] == 0.0).all(axis=1) & (sines <= 1))


def straight(of: CamProfile) -> NDArray[np.bool_]:
    """Return which pieces are a line: a dwell, or a motion at constant velocity."""
    turns = (of.sines[:, :, 0] != 0.0).any(axis=1) if of.sines.size else np.zeros(len(of.c), dtype=np.bool_)
    return np.asarray((of.c[:, 2:] == 0.0).all(axis=1) & ~turns)


def segmented(of: CamProfile, x: Array) -> CamProfile:
    """Return a motion between places: its own pieces where simple, else quintics; u counts from a place."""
    at, last = of.at(x), of.at(x, left=True)
    k = of.index(0.5 * (x[:-1] + x[1:]))
    made = quintics_between(x, [column[:-1] for column in at[:3]], [column[1:] for column in last[:3]])
    exact = simple(of)[k]
    terms = HIGHEST + 1
    c, sines = np.zeros((len(k), terms)), np.zeros((len(k), 1, 3))
    c[:, :6] = made
    kept = of.c.shape[1]
    for row in np.flatnonzero(exact):
        polynomial = CamProfile(of.edges, of.origins, of.c[:, : min(kept, terms)], of.sines[:, :0])
        c[row] = polynomial.taylor(x[row : row + 1], k[row : row + 1], terms)[:, 0]
        for a, w, phi in of.sines[k[row]]:
            if a:
                sines[row, 0] = a, w, phi + w * (x[row] - of.origins[k[row]])
    return CamProfile(x, x[:-1], c, sines)


def quintics_between(x: Array, begin: list[Array], end: list[Array]) -> Array:
    """Return the coefficients of degree 5 of each interval from y, y' and y'' at its begin and at its end."""
    rows = []
    for k in range(len(x) - 1):
        y, v, a = (np.array([one[k], other[k]]) for one, other in zip(begin, end, strict=True))
        rows.append(quintics(x[k : k + 2], y, v, a).c[0])
    return np.array(rows)
