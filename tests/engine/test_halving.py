"""Halving step by step: each middle is that of the part with the root, and the last is as near as it can be."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.halving import middles, newton_step, velocity_halvings
from engine.laws import ConstantAcceleration, Cubic, Cycloidal, ModifiedTrapezoidal


@given(st.floats(0.01, 1.0), st.floats(0, 1))
def test_middles_are_those_of_a_plain_bisection(width, share):
    root, low, high = share * width, 0.0, width
    for found in middles(np.array([width]), np.array([root]), 20)[:, 0]:
        middle = (low + high) / 2
        if abs(root - middle) < 1e-9 or min(root - low, high - root) < 1e-9:
            return  # by rounding, either side is right
        assert found == pytest.approx(middle, abs=1e-12)
        low, high = (middle, high) if root > middle else (low, middle)


def test_a_width_of_nothing_has_its_middle_at_0():
    assert (middles(np.array([0.0]), np.array([0.0]), 5) == 0.0).all()


def test_the_ends_belong_to_the_outer_parts():
    found = middles(np.array([1.0, 1.0]), np.array([0.0, 1.0]), 3)
    assert found.tolist() == [[0.5, 0.5], [0.25, 0.75], [0.125, 0.875]]


def test_newton_s_step_of_a_square():
    t = np.array([1.5, 1.5, 0.1])
    step = newton_step(t, t**2, 2 * t, np.array(2.0), np.array([2.0, 1.4, 2.0]), slow=0.5)
    assert step == pytest.approx([1.5 - 0.25 / 3, 1.4, 0.1])  # the second is held in, the third too slow


@pytest.mark.parametrize("law", [Cycloidal(), Cubic(), ModifiedTrapezoidal(), ConstantAcceleration()], ids=str)
@pytest.mark.parametrize("wanted", [0.3, 1.0, 1.4])
@pytest.mark.parametrize("ends", [(0.0, 0.5), (0.5, 1.0)])
def test_velocity_is_met_on_either_side_of_the_peak(law, wanted, ends):
    low, high, middle = velocity_halvings(law, wanted, *ends, 30, 1e-12)
    assert (low[0], high[0]) == ends
    assert law.v(float(middle[-1])) == pytest.approx(wanted, abs=1e-7)
    assert (np.diff(high - low) < 0).all()
    assert (middle == (low + high) / 2).all()
