"""The spline: its moments against SciPy's, its conditions, points that cannot be."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from engine.laws import PieceLaw
from engine.laws.ends import BoundaryValues, kinds
from engine.laws.spline import Spline

step = st.floats(0.05, 1.0)
height = st.floats(-2.0, 2.0)


@st.composite
def points(draw, most=12):
    steps = draw(st.lists(step, min_size=1, max_size=most))
    xi = np.cumsum(steps) / sum(steps)
    inner = [(float(x), draw(height)) for x in xi[:-1]]
    return ((0.0, 0.0), *inner, (1.0, 1.0))


def many(n, seed=4):
    rng = np.random.default_rng(seed)
    xi = np.cumsum(rng.uniform(0.1, 1.0, n))
    xi = (xi - xi[0]) / (xi[-1] - xi[0])
    return ((0.0, 0.0), *zip(xi[1:-1].tolist(), rng.normal(size=n - 2).tolist(), strict=True), (1.0, 1.0))


@given(points(), height, height, st.booleans(), st.booleans())
def test_the_moments_are_those_of_scipys_spline(given_, v0, v1, free0, free1):
    law = Spline(given_, (v0, v1), (free0, free1))
    ends = tuple((2, 0.0) if free else (1, v) for v, free in ((v0, free0), (v1, free1)))
    expected = CubicSpline(*np.array(given_).T, bc_type=ends)(np.array(given_)[:, 0], 2)
    assert law.moments == pytest.approx(expected, abs=1e-10 * (1 + np.abs(expected).max()))


@given(points(), height, height, st.floats(-2, 2))
def test_points_slopes_and_continuity(given_, v0, v1, stroke):
    law = Spline(given_, ends=BoundaryValues(stroke, v0, v1))
    xi, s = np.array(given_).T
    at = law.evaluate(xi)
    size = largest = 1 + np.abs(law.moments).max()
    assert at.s == pytest.approx(stroke * s, abs=1e-13 * size)
    assert (law.start.v, law.end.v) == pytest.approx((v0, v1), abs=1e-12 * size)
    left = law.evaluate(np.maximum(xi - 1e-9, 0.0))
    assert left.v == pytest.approx(at.v, abs=1e-8 * largest)
    assert left.a == pytest.approx(at.a, abs=1e-7 * (1 + np.abs(at.j).max()))


@pytest.mark.parametrize("n", [2, 3, 50, 100])
def test_many_points_evaluate_as_their_pieces(n):
    law = Spline(many(n), natural=(True, True))
    own = PieceLaw(law.as_pieces())
    xi = np.random.default_rng(0).uniform(size=2001)
    at, carried = law.evaluate(xi), own.evaluate(xi)
    v0 = law.start.v
    sizes = np.abs(at.v).max(), np.abs(at.a).max(), np.abs(at.j).max()
    assert at.s == pytest.approx(v0 * xi + carried.s, abs=1e-11)
    for value, other, size in zip(at[1:], (carried.v + v0, carried.a, carried.j), sizes, strict=True):
        assert value == pytest.approx(other, abs=1e-11 * size)


def test_points_close_together_are_each_found():
    near = [0.5 + k * 2e-6 for k in range(40)]
    law = Spline(((0.0, 0.0), *((x, x) for x in near), (1.0, 1.0)), (1.0, 1.0))
    xi = np.array(near) + 1e-6
    assert law.s(xi) == pytest.approx(xi, abs=1e-12)


def test_an_end_is_natural_and_another_has_its_slope():
    law = Spline(many(5), (None, 0.3), (True, False))
    assert (law.start.a, law.end.v) == pytest.approx((0.0, 0.3), abs=1e-12)
    assert kinds(law) == ("RG", "UB")


@pytest.mark.parametrize(
    ("given_", "reason"),
    [
        (((0.0, 0.0),), "1 points are given; expected 2 to 100"),
        (many(101), "101 points are given"),
        (((0.0, 0.0), (0.5, math.nan), (1.0, 1.0)), r"point 2 is \(0.5, nan\)"),
        (((0.0, 0.1), (1.0, 1.0)), r"expected from \(0, 0\) to \(1, 1\)"),
        (((0.0, 0.0), (0.6, 0.1), (0.6, 0.2), (1.0, 1.0)), "point 3 is at 0.6, the one before at 0.6"),
    ],
)
def test_points_that_cannot_be(given_, reason):
    with pytest.raises(ValueError, match=reason):
        Spline(given_)


def test_a_slope_that_is_no_number():
    with pytest.raises(ValueError, match="the last slope is inf"):
        Spline(((0.0, 0.0), (1.0, 1.0)), (None, math.inf))
