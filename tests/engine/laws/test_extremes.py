"""Zeros of polynomials with sines: none is missed, however near to another; extremes of pieces that hang on it."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws.extremes import Curve, zeros
from engine.laws.piece import Piece, gains
from tests.engine.extremes import extremes_of

number = st.floats(-5, 5)


def polynomial(roots):
    return tuple(np.polynomial.Polynomial.fromroots(roots).coef.tolist())


@given(st.lists(st.integers(1, 999), min_size=1, max_size=7, unique=True))
def test_roots_of_a_polynomial(parts):
    roots = sorted(part / 1000 for part in parts)
    gap = min([1.0, *np.diff(roots)])
    if gap < 0.02:
        return  # the roots are then not those of the rounded coefficients
    assert zeros(Curve(polynomial(roots)), 1.0) == pytest.approx(roots, abs=1e-8)


def test_two_roots_that_lie_together_are_found():
    roots = [0.3, 0.7, 0.7 + 1e-6]
    assert zeros(Curve(polynomial(roots)), 1.0) == pytest.approx(roots, abs=1e-8)


@pytest.mark.parametrize("w", [3.0, -3.0, 40.0])
def test_zeros_of_a_sine(w):
    expected = sorted(u for k in range(-40, 40) if 0 <= (u := (k * math.pi - 0.4) / w) <= 2.0)
    assert zeros(Curve((), ((1.5, w, 0.4),)), 2.0) == pytest.approx(expected, abs=1e-15)


@given(c=st.lists(number, min_size=1, max_size=6), sine=st.tuples(number, st.floats(-30, 30), number))
def test_a_polynomial_with_a_sine_changes_its_sign_where_samples_do_and_nowhere_else(c, sine):
    f = Curve(tuple(c), (sine,))
    found = [0.0, *zeros(f, 1.0), 1.0]
    size = sum(map(abs, c)) + abs(sine[0]) + 1e-300
    for low, high in pairwise(found):
        inside = [f(low + (high - low) * k / 40) for k in range(1, 40)]
        assert min(inside) >= -1e-9 * size or max(inside) <= 1e-9 * size
    for root in found[1:-1]:
        assert abs(f(root)) <= 1e-9 * size * (1 + abs(sine[1]))


def test_two_sines_are_searched():
    f = Curve((), ((1.0, math.pi, math.pi / 2), (-1.0, math.tau, math.pi / 2)))  # cos πu = cos 2πu at u = 2/3
    assert zeros(f, 1.0) == pytest.approx([2 / 3], rel=1e-14)


pieces = st.builds(
    lambda share, c, p, w, phi: Piece(share, tuple(c), p, w, phi),
    st.sampled_from([0.3, 1.0]),
    st.lists(number, min_size=4, max_size=6),
    number,
    st.floats(-20, 20),
    number,
)


@given(pieces, number)
def test_extremes_of_a_piece_are_the_largest_of_many_samples(piece, v0):
    found = extremes_of((piece,), v0)
    u = np.linspace(0, piece.duration, 4001)
    _, dv, a, j = gains(u, np.array(piece.row)[:, None])
    for (low, high), values in zip(found, (v0 + dv, a, j), strict=True):
        room = 1e-4 * (1 + np.abs(values).max())
        assert low - 1e-12 * room <= values.min() <= low + room
        assert high - room <= values.max() <= high + 1e-12 * room
