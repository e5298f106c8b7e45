"""Rules by which controllers interpolate between the points of a table: each makes a profile of it."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array, Flags
from engine.motion.profile import CamProfile

SplineEnds = Literal["natural", "not-a-knot", "periodic"]


def _profile(x: Array, *c: Array) -> CamProfile:
    return CamProfile(x, x[:-1], np.column_stack(c), np.zeros((len(x) - 1, 0, 3)))


def lines(x: Array, y: Array) -> CamProfile:
    """Return straight lines from point to point."""
    return _profile(x, y[:-1], np.diff(y) / np.diff(x))


def hermite(x: Array, y: Array, v: Array) -> CamProfile:
    """Return the cubic of each interval with y and y' at both its ends.

    Parameters
    ----------
    x, y, v : array (n,), any units of x and y
        Points, and y' at each.
    """
    h = np.diff(x)
    m = np.diff(y) / h
    return _profile(x, y[:-1], v[:-1], (3.0 * m - 2.0 * v[:-1] - v[1:]) / h, (v[:-1] + v[1:] - 2.0 * m) / h**2)


def parabolas(x: Array, y: Array) -> CamProfile:
    """Return cubics whose slope at a point is that of the parabola through it and its neighbours; y' is continuous.

    At an end the parabola goes through the nearest three points; of two points the result is a line.
    Source: Bessel's slopes, C. de Boor, A Practical Guide to Splines, IV.
    """
    return lines(x, y) if len(x) == 2 else hermite(x, y, np.gradient(y, x, edge_order=2))


def central(x: Array, y: Array) -> CamProfile:
    """Return cubics whose slope at a point is that of the line between its neighbours, at an end that of the chord.

    At equal steps the slopes inside are those of :func:`parabolas`. At other steps a rule whose slopes are a mean of
    both has an error of no more than the larger of theirs, as cubics are linear in the slopes.
    """
    chords = np.diff(y) / np.diff(x)
    return hermite(x, y, np.concatenate([chords[:1], (y[2:] - y[:-2]) / (x[2:] - x[:-2]), chords[-1:]]))


def quintics(x: Array, y: Array, v: Array, a: Array) -> CamProfile:
    """Return the polynomial of degree 5 of each interval.

    Parameters
    ----------
    x, y, v, a : array (n,), any units of x and y
        Points, and y' and y'' at each.
    """
    return _profile(x, *quintics_between(x, [rate[:-1] for rate in (y, v, a)], [rate[1:] for rate in (y, v, a)]).T)


def quintics_between(x: Array, begin: Sequence[Array], end: Sequence[Array]) -> Array:
    """Return the coefficients of a polynomial of degree 5 on each interval.

    Parameters
    ----------
    x : array (n,), any unit
        Ends of the intervals.
    begin, end : three arrays (n − 1,), any units of x and y
        y, y' and y'' at the begin and at the end of each interval.

    Returns
    -------
    array (n − 1, 6)
        Of the powers of x from the begin of each.
    """
    h, (y, v, a) = np.diff(x), begin
    d = end[0] - y - (v + 0.5 * a * h) * h
    e = (end[1] - v - a * h) * h
    f = (end[2] - a) * h**2
    c3 = (10.0 * d - 4.0 * e + 0.5 * f) / h**3
    c4 = (-15.0 * d + 7.0 * e - f) / h**4
    c5 = (6.0 * d - 3.0 * e + 0.5 * f) / h**5
    return np.column_stack([y, v, 0.5 * a, c3, c4, c5])


def spline(x: Array, y: Array, ends: SplineEnds | tuple[float, float]) -> CamProfile:
    """Return the cubic spline through points: y, y' and y'' are continuous.

    Parameters
    ----------
    x, y : array (n,), any units
        A travel is added to a periodic spline as a line.
    ends : (float, float), unit of y over that of x; or "natural", "not-a-knot", "periodic"
        Slopes of a clamped spline, or: y'' = 0; y''' continuous at the second point from each end; y' and y'' equal at
        both ends.
    """
    from scipy.interpolate import CubicSpline  # slow to import, and most commands need no spline

    rise = (y[-1] - y[0]) / (x[-1] - x[0]) if ends == "periodic" else 0.0
    level = y - rise * (x - x[0])
    if ends == "periodic":
        level[-1] = level[0]
    c = CubicSpline(x, level, bc_type=ends if isinstance(ends, str) else [(1, slope) for slope in ends]).c[::-1]
    return _profile(x, y[:-1], c[1] + rise, *c[2:])


def parted_spline(x: Array, y: Array, ends: tuple[float, float], straight: Flags) -> CamProfile:
    """Return lines, and clamped splines between them, that have the slope of the line next to them.

    Source: Rockwell, SegmentType.

    Parameters
    ----------
    x, y : array (n,), any units
    ends : (float, float), unit of y over that of x
        Slopes at the ends of the table.
    straight : array (n − 1,) of bool
        Which intervals are lines.
    """
    slope = np.diff(y) / np.diff(x)
    c = np.zeros((len(slope), 4))
    c[:, 0], c[:, 1] = y[:-1], slope
    turns = np.flatnonzero(np.diff(straight)) + 1
    for low, high in pairwise([0, *turns.tolist(), len(slope)]):
        if not straight[low]:
            first = ends[0] if low == 0 else float(slope[low - 1])
            last = ends[1] if high == len(slope) else float(slope[high])
            c[low:high] = spline(x[low : high + 1], y[low : high + 1], (first, last)).c
    return _profile(x, *c.T)


HIGHEST = 6  # power of a segment's polynomial


def simple(of: CamProfile) -> Flags:
    """Return whether each piece is a polynomial of at most degree 6 with at most one sine."""
    return np.asarray((of.c[:, HIGHEST + 1 :] == 0.0).all(axis=1) & ((of.sines[:, :, 0] != 0.0).sum(axis=1) <= 1))


def straight(of: CamProfile) -> Flags:
    """Return whether each piece is a line: a dwell, or a motion at constant velocity."""
    return np.asarray((of.c[:, 2:] == 0.0).all(axis=1) & (of.sines[:, :, 0] == 0.0).all(axis=1))


def segment_profile(of: CamProfile, x: Array) -> CamProfile:
    """Return a motion between the places x: its own pieces if :func:`simple`, else quintics; u = 0 at each place."""
    begin, end = of.at(x[:-1]), of.at(x[1:], left=True)
    k = of.index(0.5 * (x[:-1] + x[1:]))
    c, sines = np.zeros((len(k), HIGHEST + 1)), np.zeros((len(k), 1, 3))
    c[:, :6] = quintics_between(x, begin[:3], end[:3])
    powers = replace(of, c=of.c[:, : HIGHEST + 1], sines=of.sines[:, :0])
    for row in np.flatnonzero(simple(of)[k]):
        c[row] = powers.taylor(x[row : row + 1], k[row : row + 1], HIGHEST + 1)[:, 0]
        for a, w, phi in of.sines[k[row]]:
            if a:
                sines[row, 0] = a, w, phi + w * (x[row] - of.origins[k[row]])
    return CamProfile(x, x[:-1], c, sines)


NEAR, NEAR_ACCELERATION = 1e-9, 1e-5
"""allowed errors of the polynomials, as shares of the range of f(y(x)) and of its largest second derivative"""
# intervals of a piece at first; share of the cycle below which none is halved
FIRST, NARROWEST = 4, 1e-7


class FunctionValues(NamedTuple):
    """A function f of the position y, arrays of equal shape."""

    value: Array  # f
    first: Array  # df/dy
    second: Array  # d²f/dy²


OuterFunction = Callable[[Array], FunctionValues]


def compose_profile(of: CamProfile, outer: OuterFunction) -> CamProfile:
    """Return f(y(x)) over the same cycle, ``outer`` being f: a quintic on each interval, none across a break of y.

    It has (f∘y)' = f' y' and (f∘y)'' = f'' y'² + f' y'' at both ends; an interval off in its middle is halved.
    """

    def values(x: Array, k: NDArray[np.intp]) -> tuple[Array, Array, Array]:
        y, v, half = of.taylor(x, k, 3)
        value, first, second = outer(y)
        return value, first * v, second * v**2 + first * 2.0 * half

    samples = np.linspace(of.edges[0], of.edges[-1], 257)
    value, _, curvature = values(samples, of.index(samples))
    near = NEAR * float(np.ptp(value))
    near_curvature = NEAR_ACCELERATION * float(np.abs(curvature).max())
    x = np.append(np.linspace(of.edges[:-1], of.edges[1:], FIRST, endpoint=False, axis=1).ravel(), of.edges[-1])
    while True:
        middle = 0.5 * (x[:-1] + x[1:])
        k = of.index(middle)
        profile = _profile(x, *quintics_between(x, values(x[:-1], k), values(x[1:], k)).T)
        at, (value, _, curvature) = profile.at(middle), values(middle, k)
        off = (np.abs(at.y - value) > near) | (np.abs(at.y2 - curvature) > near_curvature)
        halved = middle[off & (np.diff(x) > NARROWEST * of.total)]
        if not len(halved):
            return profile
        x = np.sort(np.append(x, halved))
