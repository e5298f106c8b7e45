"""A timing diagram: movements with their peaks, closing cycles, and what is refused."""

import math

import numpy as np
import pytest

from engine.laws import ConstantAcceleration, Dwell, ModifiedTrapezoidal
from engine.motion import Motion, Phase
from engine.timing import Axis, lane, shaft_speed, turn_time

ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
EDGES = np.deg2rad([0, 100, 160, 250, 360])
CAM = Motion.from_edges(EDGES, [0.02, 0.0, -0.02, 0.0], [ASYMMETRIC, Dwell(), ASYMMETRIC, Dwell()])
FEED = Motion.from_edges(np.deg2rad([0, 80, 360]), [0.3, 0.0], [ConstantAcceleration(), Dwell()])


def test_a_turn_takes_the_time_of_a_piece():
    assert turn_time(200 / 60) == pytest.approx(0.3, rel=1e-15)
    with pytest.raises(ValueError, match="rate is 0"):
        turn_time(0.0)


def test_an_axis_fills_its_share_of_a_lane_from_the_floor_and_lies_on_it_where_it_stands():
    assert lane(np.array([5.0, 10.0, 7.5]), (5.0, 10.0), 2.0, 0.8) == pytest.approx([2.0, 2.8, 2.4])
    assert lane(np.full(3, 7.0), (7.0, 7.0), 1.0, 0.8).tolist() == [1.0, 1.0, 1.0]


def test_movements_are_the_phases_that_lift():
    found = [one for axis in (Axis("cam", CAM), Axis("feed", FEED, feed=True)) for one in axis.movements(2.0)]
    assert [(m.axis, m.phase, m.of.lift) for m in found] == [("cam", 0, 0.02), ("cam", 2, -0.02), ("feed", 0, 0.3)]
    assert [m.of.duration for m in found[:2]] == [EDGES[1] - EDGES[0], EDGES[3] - EDGES[2]]
    assert found[0].of.law is ASYMMETRIC


@pytest.mark.parametrize("number", [0, 1])
def test_peaks_are_what_dense_samples_show(number):
    rate = 3.0
    movement = Axis("cam", CAM).movements(shaft_speed(rate))[number]
    x = np.linspace(EDGES[movement.phase], EDGES[movement.phase + 1], 100_001)[:-1]
    at, timed = CAM.at(x), CAM.at_speed(x, shaft_speed(rate))
    assert movement.of.y1_max == pytest.approx(np.abs(at.y1).max(), rel=1e-7)
    assert movement.of.y2_max == pytest.approx(np.abs(at.y2).max(), rel=1e-7)
    assert movement.v_max == pytest.approx(np.abs(timed.v).max(), rel=1e-7)
    assert movement.a_max == pytest.approx(np.abs(timed.a).max(), rel=1e-7)
    assert movement.a_rms == pytest.approx(math.sqrt(np.mean(timed.a**2)), rel=1e-7)


def test_a_cycle_in_other_units_runs_at_the_same_rate():
    """A cycle of 360° at 2 cycles a second: 720 °/s."""
    motion = Motion([Phase(ConstantAcceleration(), 0.3, 80.0), Phase(Dwell(), 0.0, 280.0)])
    in_degrees = Axis("feed", motion, feed=True).movements(720.0)[0]
    in_radians = Axis("feed", FEED, feed=True).movements(shaft_speed(2.0))[0]
    assert (in_degrees.v_max, in_degrees.a_max) == pytest.approx((in_radians.v_max, in_radians.a_max), rel=1e-13)


def test_a_cam_comes_back_and_a_feed_need_not():
    assert Axis("cam", CAM).closes
    assert Axis("feed", FEED, feed=True).closes
    assert not Axis("feed", FEED).closes


def test_an_axis_at_rest_closes():
    assert Axis("idle", Motion([Phase(Dwell(), 0.0, math.tau)])).closes


@pytest.mark.parametrize("rate", [0.0, -1.0, math.nan, math.inf])
def test_a_rate_that_is_none_is_refused(rate):
    with pytest.raises(ValueError, match="rate is"):
        shaft_speed(rate)
