"""The deviation of a rebuilt motion from that meant, bounded without samples; the placing of a table's points."""

from dataclasses import dataclass
from functools import lru_cache
from math import comb, factorial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array, Flags
from engine.motion.profile import SAME, CamProfile

DEGREE = 15  # of every polynomial here; a sine over one rad about its middle is one to 1e-13 of its third derivative
NARROW = 1e-9  # share by which the largest value may exceed the value that is reached
ROUNDS = 40  # of halving
TERMS = range(DEGREE + 1)
BASIS = np.array(
    [
        [
            sum(comb(i, j) * comb(DEGREE - i, k - j) * (-1) ** (k - j) for j in range(k + 1)) / comb(DEGREE, k)
            for i in TERMS
        ]
        for k in TERMS
    ]
)
"""matrix from the coefficients of powers of t, from −1 to 1, to those of Bernstein"""
LEFT = np.array([[comb(i, j) / 2.0**i for i in TERMS] for j in TERMS])
# matrices from Bernstein's coefficients to those of the left and right half (de Casteljau)
RIGHT = LEFT[::-1, ::-1]


class Largest(NamedTuple):
    """The largest absolute value of several polynomials."""

    value: float
    row: int  # number of the polynomial, from 0
    t: float  # place, from −1 to 1


def product(rows: Array, by: Array) -> Array:
    """Return the product of many rows and a small matrix, in a single thread: starting those of BLAS takes longer."""
    return np.asarray(np.einsum("nk,ki->ni", rows, by))


def _derivative_rows(powers: Array, half: Array, order: int) -> Array:
    """Return Bernstein's coefficients, in rows, of derivatives by x of polynomials in t, given by columns of powers."""
    powers = np.polynomial.polynomial.polyder(powers, order) / half**order
    used = int(np.flatnonzero(powers.any(axis=1)).max(initial=0)) + 1
    return product(powers[:used].T, BASIS[:used])


def largest(rows: Array) -> Largest:
    """Return the largest absolute value of polynomials on [−1, 1], from rows of Bernstein's coefficients.

    A polynomial is within the span of its coefficients; intervals are halved until these leave :data:`NARROW`.
    """
    size = np.abs(rows)
    ends = size[:, [0, -1]]
    place = int(ends.argmax())
    best = Largest(float(ends.flat[place]), place // 2, -1.0 if place % 2 == 0 else 1.0)
    number, low, high = np.arange(len(rows)), np.full(len(rows), -1.0), np.full(len(rows), 1.0)
    for _ in range(ROUNDS):
        open_ = size.max(axis=1) > best.value * (1.0 + NARROW)
        if not open_.any():
            break
        rows, number, low, high = rows[open_], number[open_], low[open_], high[open_]
        middle = 0.5 * (low + high)
        rows = np.concatenate([product(rows, LEFT), product(rows, RIGHT)])
        at = np.abs(rows[: len(number), -1])
        k = int(at.argmax())
        if at[k] > best.value:
            best = Largest(float(at[k]), int(number[k]), float(middle[k]))
        number, low = np.tile(number, 2), np.concatenate([low, middle])
        high = np.concatenate([middle, high])
        size = np.abs(rows)
    return best


ORDERS = 4  # position, velocity, acceleration, jerk
WIDEST = 1.0  # angle of a sine within an interval, at most (rad)


class Deviation(NamedTuple):
    """The largest deviation of a derivative of y over the cycle, in the units of the motion."""

    largest: float
    x: float  # where it is
    peak: float  # largest absolute value of the derivative meant; of y its range

    @property
    def share(self) -> float:
        """The deviation over the peak; of a peak of 0 infinite, or 0 if there is no deviation."""
        return self.largest / self.peak if self.peak else float(np.inf if self.largest else 0.0)


@dataclass(frozen=True)
class Certificate:
    """Bounds of the deviation of a rebuilt motion from that meant, over the cycle."""

    deviations: tuple[Deviation, ...]  # of y, y', y'' and y'''
    jumps: tuple[float, ...]  # largest jumps of y, y', y'' at breaks that rebuilding adds
    closure: tuple[float, ...]  # jumps of y, y', y'' from the end to the begin that rebuilding adds


def certify(meant: CamProfile, rebuilt: CamProfile) -> Certificate:
    """Compare a rebuilt motion with that meant, over the cycle of the latter.

    Between two neighbouring breaks of either, both are polynomials and sines. The Bernstein coefficients of the Taylor
    polynomial of their difference bound the deviation; intervals are halved until the bound is close.
    """
    middle, half = intervals(meant, rebuilt)
    difference = _local_powers(rebuilt, middle, half) - _local_powers(meant, middle, half)
    deviations, jumps, closure = [], [], []
    for order, peak in enumerate(peaks(meant)):
        off = _derivative_rows(difference, half, order)
        worst = largest(off)
        deviations.append(Deviation(worst.value, float(middle[worst.row] + worst.t * half[worst.row]), peak))
        jumps.append(float(np.abs(off[1:, 0] - off[:-1, -1]).max(initial=0.0)))
        closure.append(float(off[-1, -1] - off[0, 0]))
    return Certificate(tuple(deviations), tuple(jumps[:-1]), tuple(closure[:-1]))


@lru_cache(maxsize=64)
def peaks(of: CamProfile) -> tuple[float, ...]:
    """Return the range of y, and the largest absolute values of y', y'' and y'''."""
    middle, half = intervals(of, of)
    powers = _local_powers(of, middle, half)
    y, *rates = (_derivative_rows(powers, half, order) for order in range(ORDERS))
    low, high = float(y.min()), float(y.max())  # the motion is within the span of its coefficients
    reach = max(0.0, largest(y - low).value + largest(high - y).value - (high - low))
    return reach, *(largest(rows).value for rows in rates)


def intervals(meant: CamProfile, rebuilt: CamProfile) -> tuple[Array, Array]:
    """Return middle and half width of each interval of the cycle of ``meant`` without a break of either motion."""
    begin, end = float(meant.edges[0]), float(meant.edges[-1])
    inner = rebuilt.edges[(rebuilt.edges > begin) & (rebuilt.edges < end)]
    edges = np.unique(np.concatenate([meant.edges, inner]))
    edges = edges[np.concatenate([[True], np.diff(edges) > SAME * (end - begin)])]
    edges[-1] = end
    middle = 0.5 * (edges[:-1] + edges[1:])
    rate = np.zeros(len(middle))
    for of in (meant, rebuilt):
        rates = np.where(of.sines[:, :, 0] != 0.0, np.abs(of.sines[:, :, 1]), 0.0)
        rate = np.maximum(rate, rates.max(axis=1, initial=0.0)[of.index(middle)])
    parts: NDArray[np.intp] = np.ceil(np.maximum(rate * np.diff(edges) / WIDEST, 1.0)).astype(np.intp)
    width = np.repeat(np.diff(edges) / parts, parts)
    nth = np.arange(int(parts.sum())) - np.repeat(np.cumsum(parts) - parts, parts)
    low = np.repeat(edges[:-1], parts) + nth * width
    high = np.append(low[1:], end)
    return 0.5 * (low + high), 0.5 * (high - low)


def _local_powers(of: CamProfile, middle: Array, half: Array) -> Array:
    """Return a profile within ``half`` of each ``middle`` as powers of t from −1 to 1, a column each."""
    powers = of.taylor(middle, of.index(middle), DEGREE + 1)
    return np.asarray(powers * half ** np.arange(DEGREE + 1)[:, None])


STEPS = 60  # of halving
LINEAR = 2  # order of straight lines
CUBIC = 4  # order of a rule by polynomials of degree 3
JUMP = 1e-9  # share of the largest y' or y'': a smaller jump is rounding


def equal_steps(of: CamProfile, n: int) -> Array:
    """Return n points at equal steps over the cycle."""
    return np.linspace(float(of.edges[0]), float(of.edges[-1]), n)


def subdivide_intervals(x: Array, parts: int) -> Array:
    """Return points with each interval divided into equal parts."""
    steps = np.linspace(0.0, 1.0, parts, endpoint=False)
    return np.append((x[:-1, None] + np.diff(x)[:, None] * steps).ravel(), x[-1])


def spread(of: CamProfile, n: int, order: int, least: NDArray[np.intp], exact: Flags) -> Array:
    """Return points of a profile: the breaks, and between them equal steps by the error of a rule of interpolation.

    A rule by polynomials of degree ``order`` − 1 between points h apart has an error of y'' in proportion to
    h^(order − 2) max|y^(order)|, and lines that of y to h² max|y''|; the steps of each piece are the longest that keep
    it below a common level.

    Parameters
    ----------
    of : CamProfile
        The motion, in any units of x and y.
    n, order : int
        Number of points at most, and order of the rule.
    least : array (pieces,) of int
        Least number of steps of each piece.
    exact : array (pieces,) of bool
        Pieces that need no more than these, as the rule meets them exactly.

    Returns
    -------
    array (n,) at most
        Abscissae, in units of the profile.

    Raises
    ------
    ValueError
        If ``n`` is too small for the least steps.
    """
    needed = int(least.sum()) + 1
    if n < needed:
        raise ValueError(f"{n} points are given; expected at least {needed}, for the breaks of the motion")
    low, high = 0.0, 1.0
    sizes = np.where(exact, 0.0, weights(of, order))
    sizes /= max(sizes.max(), 1e-300)
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _steps(sizes, middle, least).sum() + 1 <= n else (low, middle)
    steps = _steps(sizes, low, least)
    inner = [np.linspace(a, b, k, endpoint=False) for a, b, k in zip(of.edges[:-1], of.edges[1:], steps, strict=True)]
    return np.concatenate([*inner, of.edges[-1:]])


def _steps(sizes: Array, level: float, least: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return the number of steps of each piece at a ``level`` from 0, fewest steps, to 1."""
    share = level / max(1.0 - level, 1e-15)
    return np.maximum(np.ceil(np.minimum(sizes * share, 1e7)), least).astype(np.intp)


def weights(of: CamProfile, order: int) -> Array:
    """Return for each piece its length times the root of its largest derivative of an order, over the largest."""
    middle, half = intervals(of, of)
    value = np.abs(_derivative_rows(_local_powers(of, middle, half), half, order)).max(axis=1)
    by_piece = np.zeros(len(of.origins))
    np.maximum.at(by_piece, of.index(middle), value)
    by_piece[by_piece < by_piece.max(initial=0.0) * 1e-9] = 0.0
    spans = np.diff(of.edges)
    sizes: Array = spans * (by_piece / factorial(order)) ** (1.0 / (order if order == LINEAR else order - 2))
    sizes = sizes / sizes.max() if sizes.max() > 0.0 else sizes
    if order != CUBIC:
        return sizes
    # a spline oscillates next to a jump of y'', the less the shorter its steps are, even on a parabola
    at = np.isin(of.edges, jumps(of))
    return np.maximum(sizes, np.where(at[:-1] | at[1:], spans / spans.max(), 0.0))


def jumps(of: CamProfile) -> Array:
    """Return the x of the breaks within a profile at which y' or y'' jumps."""
    inner = of.edges[1:-1]
    before, after = of.at(inner, left=True), of.at(inner)
    _, v, a, _ = peaks(of)
    return inner[(np.abs(after.y1 - before.y1) > JUMP * v) | (np.abs(after.y2 - before.y2) > JUMP * a)]
