"""Polynomials between two ends by Bernstein's coefficients: they enclose every value between them."""

from math import comb
from typing import NamedTuple

import numpy as np

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
