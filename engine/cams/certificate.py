"""How far a rebuilt motion is from the one that was meant, over the whole cycle: no sample decides."""

from dataclasses import dataclass
from functools import lru_cache
from math import comb
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
TERMS = range(DEGREE + 1)
BASIS = np.array([
    [sum(comb(i, j) * comb(DEGREE - i, k - j) * (-1) ** (k - j) for j in range(k + 1)) / comb(DEGREE, k) for i in TERMS]
    for k in TERMS
])  # fmt: skip
"""makes the coefficients of powers of t, from −1 to 1, those of Bernstein: the polar form at i times 1, else −1"""
LEFT = np.array([[comb(i, j) / 2.0**i for i in TERMS] for j in TERMS])
RIGHT = LEFT[::-1, ::-1]
"""make a row of coefficients that of its left half, and of its right half (de Casteljau)"""


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


@dataclass(frozen=True)
class Certificate:
    """How far a rebuilt motion is from the one meant: of y, y', y'' and y''' the largest deviation over the cycle.

    ``jumps`` are the largest between two pieces that rebuilding adds to y, y' and y'', ``closure`` what the end of the
    cycle fails to meet its begin by in these, beyond what the motion does.
    """

    deviations: tuple[Deviation, ...]
    jumps: tuple[float, ...]
    closure: tuple[float, ...]


def certify(meant: CamProfile, rebuilt: CamProfile) -> Certificate:
    """Compare a rebuilt motion with the one meant, over the cycle of the latter.

    Between two neighbouring breaks of either both are polynomials and sines. Their difference is enclosed by the
    coefficients of Bernstein of its Taylor polynomial, which are halved until they show the largest size.
    """
    middle, half = intervals(meant, rebuilt)
    difference = local(rebuilt, middle, half) - local(meant, middle, half)
    deviations, jumps, closure = [], [], []
    for order, peak in enumerate(peaks(meant)):
        off = enclosing(derived(difference, half, order))
        worst = largest(off)
        deviations.append(Deviation(worst.value, float(middle[worst.row] + worst.t * half[worst.row]), peak))
        jumps.append(float(np.abs(off[1:, 0] - off[:-1, -1]).max(initial=0.0)))
        closure.append(float(off[-1, -1] - off[0, 0]))
    return Certificate(tuple(deviations), tuple(jumps[:-1]), tuple(closure[:-1]))


@lru_cache(maxsize=64)
def peaks(of: CamProfile) -> tuple[float, ...]:
    """Return the reach of a motion, and the largest sizes of y', y'' and y'''."""
    middle, half = intervals(of, of)
    powers = local(of, middle, half)
    y, *rates = (enclosing(derived(powers, half, order)) for order in range(ORDERS))
    low, high = float(y.min()), float(y.max())  # the motion is within the span of its coefficients
    reach = max(0.0, largest(y - low).value + largest(high - y).value - (high - low))
    return reach, *(largest(one).value for one in rates)


def intervals(meant: CamProfile, rebuilt: CamProfile) -> tuple[Array, Array]:
    """Return middles and halves of the intervals of the cycle of ``meant`` in which both are a polynomial and sines."""
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


def local(of: CamProfile, middle: Array, half: Array) -> Array:
    """Return a profile between ends that are ``half`` from ``middle`` as powers of t from −1 to 1, a column each."""
    powers = of.taylor(middle, of.index(middle), DEGREE + 1)
    return np.asarray(powers * half ** np.arange(DEGREE + 1)[:, None])


def derived(powers: Array, half: Array, order: int) -> Array:
    """Return the powers of a derivative by x."""
    return np.asarray(np.polynomial.polynomial.polyder(powers, order) / half**order)
