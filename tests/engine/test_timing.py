"""A timing diagram: movements with their peaks, closing cycles, and what is refused."""

import math

import numpy as np
import pytest

from engine.laws import Dwell
from engine.laws.modified import ModifiedTrapezoidal
from engine.motion import Motion
from engine.timing import shaft_speed, turn_time

ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
EDGES = np.deg2rad([0, 100, 160, 250, 360])
CAM = Motion.from_edges(EDGES, [0.02, 0.0, -0.02, 0.0], [ASYMMETRIC, Dwell(), ASYMMETRIC, Dwell()])


def test_a_turn_takes_the_time_of_a_piece():
    assert turn_time(200 / 60) == pytest.approx(0.3, rel=1e-15)
    with pytest.raises(ValueError, match="rate is 0"):
        turn_time(0.0)


@pytest.mark.parametrize("number", [0, 2])
def test_peaks_are_what_dense_samples_show(number):
    rate = 3.0
    phase, speed = CAM.phases[number], shaft_speed(rate)
    x = np.linspace(EDGES[number], EDGES[number + 1], 100_001)[:-1]
    at, timed = CAM.at(x), CAM.at_speed(x, speed)
    assert phase.y1_max == pytest.approx(np.abs(at.y1).max(), rel=1e-7)
    assert phase.y2_max == pytest.approx(np.abs(at.y2).max(), rel=1e-7)
    assert phase.y1_max * speed == pytest.approx(np.abs(timed.v).max(), rel=1e-7)
    assert phase.y2_max * speed**2 == pytest.approx(np.abs(timed.a).max(), rel=1e-7)
    assert phase.y2_rms * speed**2 == pytest.approx(math.sqrt(np.mean(timed.a**2)), rel=1e-7)


@pytest.mark.parametrize("rate", [0.0, -1.0, math.nan, math.inf])
def test_a_rate_that_is_none_is_refused(rate):
    with pytest.raises(ValueError, match="rate is"):
        shaft_speed(rate)
