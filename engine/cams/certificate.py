"""How far a rebuilt motion is from the one that was meant, over the whole cycle: no sample decides."""

from dataclasses import dataclass
from functools import lru_cache
from math import comb, factorial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.profile import SAME, CamProfile
from engine.laws.base import Array

DEGREE = 15
"""of every polynomial here; a sine over one rad about its middle is one to 1e-13 of its third derivative"""
NARROW = 1e-9
"""by so much of itself the largest may be larger than what was found"""
ROUNDS = 40


def _basis() -> Array:
    """Return what makes the coefficients of powers of t, from −1 to 1, those of Bernstein, by their polar form."""
    n = DEGREE
    rows = np.zeros((n + 1, n + 1))
    for k in range(n + 1):
        for i in range(n + 1):  # i factors of the polar form are at 1, the others at −1
            signs = sum(
                comb(i, j) * comb(n - i, k - j) * (-1) ** (k - j) for j in range(max(0, k - n + i), min(i, k) + 1)
            )
            rows[k, i] = signs / comb(n, k)
    return rows


def _halves() -> tuple[Array, Array]:
    """Return what makes a row of coefficients that of its left half, and of its right half (de Casteljau)."""
    left = np.zeros((DEGREE + 1, DEGREE + 1))
    for i in range(DEGREE + 1):
        left[: i + 1, i] = [comb(i, j) / 2.0**i for j in range(i + 1)]
    return left, left[::-1, ::-1]


BASIS = _basis()
LEFT, RIGHT = _halves()


class Largest(NamedTuple):
    """The largest size of polynomials, and where it is: in which, and at which t from −1 to 1."""

    value: float
    row: int
    t: float


def product(rows: Array, by: Array) -> Array:
    """Return the product of many rows and a small matrix, by one thread: the threads of BLAS take longer to begin."""
    return np.asarray(np.einsum("nk,ki->ni", rows, by))


def enclosing(powers: Array) -> Array:
    """Return rows of Bernstein's coefficients of polynomials in t from −1 to 1, a column of powers each."""
    used = int(np.flatnonzero(powers.any(axis=1)).max(initial=0)) + 1
    return product(powers[:used].T, BASIS[:used])


def largest(rows: Array) -> Largest:
    """Return the largest size of polynomials between their ends, by rows of coefficients halved until these enclose it.

    What was found is at most :data:`NARROW` of itself too small, but for the rounding of the coefficients.
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
        number, low, high = np.tile(number, 2), np.concatenate([low, middle]), np.concatenate([middle, high])
        size = np.abs(rows)
    return best


ORDERS = 4
"""position, velocity, acceleration, jerk"""
WIDEST = 1.0  # rad of a sine in one interval


class Deviation(NamedTuple):
    """The largest deviation of one derivative over the cycle: how large, where, and the motion's own peak.

    The peak of the position is its reach, from the lowest to the highest.
    """

    largest: float
    x: float
    peak: float

    @property
    def share(self) -> float:
        """The deviation as a share of the peak; infinite where the motion has none, and 0 where neither is."""
        return self.largest / self.peak if self.peak else float(np.inf) if self.largest else 0.0


class Jump(NamedTuple):
    """The largest jump that rebuilding adds to one derivative between two pieces, and where it is."""

    largest: float
    x: float


@dataclass(frozen=True)
class Certificate:
    """How far a rebuilt motion is from the one meant: of y, y', y'' and y''' the largest deviation over the cycle.

    ``jumps`` are those of y, y' and y'' that the motion has not, ``closure`` what the end of the cycle fails to meet
    its begin by in y, y' and y'', beyond what the motion does.
    """

    deviations: tuple[Deviation, ...]
    jumps: tuple[Jump, ...]
    closure: tuple[float, ...]


def certify(meant: CamProfile, rebuilt: CamProfile) -> Certificate:
    """Compare a rebuilt motion with the one meant, over the cycle of the latter.

    Between two neighbouring breaks of either both are polynomials and sines. Their difference is enclosed by the
    coefficients of Bernstein of its Taylor polynomial, which are halved until they show the largest size.
    """
    low, high = intervals(meant, rebuilt)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    one, other = (local(of, middle, half) for of in (meant, rebuilt))
    deviations, jumps, closure = [], [], []
    for order in range(ORDERS):
        off = enclosing(derived(other - one, half, order))
        worst = largest(off)
        x = float(middle[worst.row] + worst.t * half[worst.row])
        deviations.append(Deviation(worst.value, x, peaks(meant)[order]))
        if order < ORDERS - 1:
            between = np.abs(off[1:, 0] - off[:-1, -1])
            k = int(between.argmax()) if between.size else 0
            jumps.append(Jump(float(between[k]), float(high[k])) if between.size else Jump(0.0, float(low[0])))
            closure.append(float(off[-1, -1] - off[0, 0]))
    return Certificate(tuple(deviations), tuple(jumps), tuple(closure))


@lru_cache(maxsize=64)
def peaks(of: CamProfile) -> tuple[float, ...]:
    """Return the reach of a motion, and the largest sizes of y', y'' and y'''."""
    low, high = intervals(of, of)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    powers = local(of, middle, half)
    rows = [enclosing(derived(powers, half, order)) for order in range(ORDERS)]
    return _reach(rows[0]), *(largest(one).value for one in rows[1:])


def _reach(rows: Array) -> float:
    """Return the highest less the lowest value of polynomials: each is within the span of its coefficients."""
    low, high = float(rows.min()), float(rows.max())
    return max(0.0, largest(rows - low).value + largest(high - rows).value - (high - low))


def intervals(meant: CamProfile, rebuilt: CamProfile) -> tuple[Array, Array]:
    """Return begins and ends of the intervals of the cycle of ``meant`` in which both are one polynomial and sines."""
    begin, end = float(meant.edges[0]), float(meant.edges[-1])
    inner = rebuilt.edges[(rebuilt.edges > begin) & (rebuilt.edges < end)]
    edges = np.unique(np.concatenate([meant.edges, inner]))
    edges = edges[np.concatenate([[True], np.diff(edges) > SAME * (end - begin)])]
    edges[-1] = end
    middle = 0.5 * (edges[:-1] + edges[1:])
    rate = np.maximum(*(fastest(of)[of.index(middle)] for of in (meant, rebuilt)))
    parts: NDArray[np.intp] = np.ceil(np.maximum(rate * np.diff(edges) / WIDEST, 1.0)).astype(np.intp)
    width = np.repeat(np.diff(edges) / parts, parts)
    nth = np.arange(int(parts.sum())) - np.repeat(np.cumsum(parts) - parts, parts)
    low = np.repeat(edges[:-1], parts) + nth * width
    return low, np.append(low[1:], end)


def fastest(of: CamProfile) -> Array:
    """Return the largest ω of the sines of each piece."""
    if not of.sines.size:
        return np.zeros(len(of.origins))
    return np.asarray(np.abs(np.where(of.sines[:, :, 0] != 0.0, of.sines[:, :, 1], 0.0)).max(axis=1))


def local(of: CamProfile, middle: Array, half: Array) -> Array:
    """Return a profile between ends that are ``half`` from ``middle`` as powers of t from −1 to 1, a column each."""
    powers = of.taylor(middle, of.index(middle), DEGREE + 1)
    return np.asarray(powers * half ** np.arange(DEGREE + 1)[:, None])


def derived(powers: Array, half: Array, order: int) -> Array:
    """Return the powers of a derivative by x."""
    found = np.zeros_like(powers)
    for k in range(order, len(powers)):
        found[k - order] = powers[k] * (factorial(k) / factorial(k - order))
    return found / half**order
