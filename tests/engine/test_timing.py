"""A timing diagram: movements with their peaks, closing cycles, and what is refused."""

import math

import pytest

from engine.timing import shaft_speed, turn_time


def test_a_turn_takes_the_time_of_a_piece():
    assert turn_time(200 / 60) == pytest.approx(0.3, rel=1e-15)
    with pytest.raises(ValueError, match="rate is 0"):
        turn_time(0.0)


@pytest.mark.parametrize("rate", [0.0, -1.0, math.nan, math.inf])
def test_a_rate_that_is_none_is_refused(rate):
    with pytest.raises(ValueError, match="rate is"):
        shaft_speed(rate)
