"""How controllers go between the points of a table: each rule makes a profile of it."""

from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.profile import CamProfile
from engine.laws.base import Array

Ends = Literal["natural", "not-a-knot", "periodic"]


def _profile(x: Array, *c: Array) -> CamProfile:
    return CamProfile(x, x[:-1], np.column_stack(c), np.zeros((len(x) - 1, 0, 3)))


def lines(x: Array, y: Array) -> CamProfile:
    """Return straight lines from point to point."""
    return _profile(x, y[:-1], np.diff(y) / np.diff(x))


def hermite(x: Array, y: Array, v: Array) -> CamProfile:
    """Return the cubic of each interval that has y and y' at both its ends."""
    h = np.diff(x)
    m = np.diff(y) / h
    return _profile(x, y[:-1], v[:-1], (3.0 * m - 2.0 * v[:-1] - v[1:]) / h, (v[:-1] + v[1:] - 2.0 * m) / h**2)


def parabolas(x: Array, y: Array) -> CamProfile:
    """Return cubics whose slope at a point is that of the parabola through it and its neighbours.

    At an end it goes through three points. At equal steps that is the slope of the line between the neighbours. y'
    is continuous and y'' is not. Of two points it is the line. Source: Bessel's slopes, C. de Boor, A Practical
    Guide to Splines, IV.
    """
    if len(x) == 2:
        return lines(x, y)
    h = np.diff(x)
    m = np.diff(y) / h
    inner = (h[1:] * m[:-1] + h[:-1] * m[1:]) / (h[1:] + h[:-1])
    return hermite(x, y, np.concatenate([[2.0 * m[0] - inner[0]], inner, [2.0 * m[-1] - inner[-1]]]))


def central(x: Array, y: Array) -> CamProfile:
    """Return cubics whose slope at a point is that of the line between its neighbours, at an end that of the chord.

    At equal steps the slopes inside are those of :func:`parabolas`. Where steps differ, what a mean of both chords'
    slopes leaves is no more than the larger of what these two leave: it is their mean, and cubics are linear in slopes.
    """
    chords = np.diff(y) / np.diff(x)
    return hermite(x, y, np.concatenate([chords[:1], (y[2:] - y[:-2]) / (x[2:] - x[:-2]), chords[-1:]]))


def quintics(x: Array, y: Array, v: Array, a: Array) -> CamProfile:
    """Return the polynomial of degree 5 of each interval that has y, y' and y'' at both its ends."""
    h = np.diff(x)
    d = np.diff(y) - (v[:-1] + 0.5 * a[:-1] * h) * h
    e = (np.diff(v) - a[:-1] * h) * h
    f = np.diff(a) * h**2
    return _profile(
        x, y[:-1], v[:-1], 0.5 * a[:-1],
        (10.0 * d - 4.0 * e + 0.5 * f) / h**3, (-15.0 * d + 7.0 * e - f) / h**4, (6.0 * d - 3.0 * e + 0.5 * f) / h**5,
    )  # fmt: skip


def spline(x: Array, y: Array, ends: Ends | tuple[float, float]) -> CamProfile:
    """Return the cubic spline through the points: y, y' and y'' are continuous.

    ``ends`` are the slopes of a clamped spline; or natural (y'' = 0), not-a-knot (y''' continuous at the last points
    but one), periodic (y' and y'' alike at both ends). Two points, or three of not-a-knot, have one polynomial.
    The slopes m meet m_{k−1}/h_{k−1} + 2 m_k (1/h_{k−1} + 1/h_k) + m_{k+1}/h_k = 3 (d_{k−1}/h_{k−1} + d_k/h_k), d_k the
    slope of a chord; they are linear in those of the ends, which the ends' conditions then settle.
    Raises ValueError for an unknown condition.
    """
    h = np.diff(x)
    fixed, first, last = _slopes(h.tobytes(), (np.diff(y) / h).tobytes())
    if not isinstance(ends, str):
        return hermite(x, y, fixed + ends[0] * first + ends[1] * last)
    if len(x) == 2 and ends != "periodic":
        return lines(x, y)
    rows = [_conditions(hermite(x, values, m), ends)
            for values, m in ((y, fixed), (np.zeros_like(y), first), (np.zeros_like(y), last))]  # fmt: skip
    right, *columns = (np.array(row) for row in rows)
    one, other = np.linalg.lstsq(np.column_stack(columns), -right, rcond=None)[0]
    return hermite(x, y, fixed + one * first + other * last)


def _conditions(of: CamProfile, ends: Ends) -> tuple[float, float]:
    """Return what must be 0 at both ends."""
    (_, v0, a0, j0), c1 = of.c[0], of.c[-1]
    h = float(of.edges[-1] - of.edges[-2])
    v1, a1 = c1[1] + (2.0 * c1[2] + 3.0 * c1[3] * h) * h, c1[2] + 3.0 * c1[3] * h
    scale = of.total
    if ends == "natural":
        return float(a0), float(a1)
    if ends == "not-a-knot":
        return float(of.c[min(1, len(of.c) - 1), 3] - j0), float(c1[3] - of.c[max(len(of.c) - 2, 0), 3])
    if ends == "periodic":
        return float(v1 - v0), float((a1 - a0) * scale)
    raise ValueError(f"the spline's ends are {ends!r}; expected natural, not-a-knot, periodic, or two slopes")


@lru_cache(maxsize=4)
def _slopes(widths: bytes, chords: bytes) -> tuple[Array, Array, Array]:
    """Return the slopes with 0 at both ends, and what a slope of 1 at the first and at the last point adds.

    They are kept, as the rules of a table of points differ in its ends alone.
    """
    h, d = np.frombuffer(widths), np.frombuffer(chords)
    n = len(h) + 1
    rows = [[0.0] * n, [0.0] * n, [0.0] * n]
    rows[1][0] = rows[2][-1] = 1.0
    if n > 2:
        per = (1.0 / h).tolist()
        right = (3.0 * (d[:-1] / h[:-1] + d[1:] / h[1:])).tolist()
        above: list[float] = []
        for k in range(n - 2):
            pivot = 2.0 * (per[k] + per[k + 1]) - (per[k] * above[-1] if k else 0.0)
            above.append(per[k + 1] / pivot)
            for row, given in zip(rows, (right[k], 0.0, 0.0), strict=True):
                row[k + 1] = (given - per[k] * row[k]) / pivot
        for k in range(n - 3, -1, -1):
            for row in rows:
                row[k + 1] -= above[k] * row[k + 2]
    return np.array(rows[0]), np.array(rows[1]), np.array(rows[2])


def parted_spline(x: Array, y: Array, ends: tuple[float, float], straight: NDArray[np.bool_]) -> CamProfile:
    """Return lines where ``straight`` says so, one for each interval, and clamped splines between them.

    A spline beside a line takes the line's slope; at the ends of the table those of ``ends``.
    Source: Rockwell, SegmentType of CAM.
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
