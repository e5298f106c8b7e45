"""The seven-stage law: known heights, and the laws that it contains."""

import math

import numpy as np
import pytest

from engine.laws import ModifiedTrapezoidal


@pytest.mark.parametrize(
    ("durations", "a", "b"),
    [
        ((0.1, 0.2, 0.1, 0.2, 0.1, 0.2, 0.1), 5.0917956, 5.0917956),
        ((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1), 7.2004460, 4.0772962),
    ],
)
def test_heights_known_from_elsewhere(durations, a, b):
    law = ModifiedTrapezoidal(durations)
    assert (law.acceleration, law.deceleration) == pytest.approx((a, b), abs=5e-8)
    assert (law.coefficients.ca_max, law.coefficients.ca_min) == (law.acceleration, -law.deceleration)


def test_classic_stages_as_written_in_the_books():
    """a = A sin(πu/2d1), A, A cos(πu/2d3), 0, −B sin(πu/2d5), −B, −B cos(πu/2d7), mid-stage."""
    d = (0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1)
    law = ModifiedTrapezoidal(d)
    half, a, b = math.sqrt(0.5), law.acceleration, law.deceleration
    middles = np.cumsum(d) - np.array(d) / 2
    assert law.a(middles) == pytest.approx([a * half, a, a * half, 0, -b * half, -b, -b * half], abs=1e-13)


def test_durations_that_sum_to_one_but_for_rounding_still_bring_it_home():
    third = 0.333333333
    law = ModifiedTrapezoidal((0, third, 0, third, 0, third + 5e-10, 0))
    assert (law.end.s, law.end.v) == pytest.approx((1.0, 0.0), abs=1e-8)
