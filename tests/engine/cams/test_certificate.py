"""What a controller makes of a table, over the whole cycle: the figures of the field, and other routes to them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine import law
from engine.cams.certificate import Certificate, certify, equal_steps, spread
from engine.cams.interpolation import lines, parabolas, parted_spline, quintics, spline
from engine.laws import CATALOGUE, Dwell
from engine.motion import Motion, Phase
from engine.motion.profile import CamProfile, profile_of_motion

RISE = profile_of_motion(Motion([Phase(law("MTP"), 300.0, 80.0)]))
TURN = profile_of_motion(Motion([Phase(law("MTP"), 300.0, 80.0), Phase(law("dwell"), 0.0, 280.0)]))
MOVING = [entry for entry in CATALOGUE if entry is not Dwell]


def through(of: CamProfile, x: np.ndarray, real: bool = False) -> Certificate:
    """The certificate of a clamped cubic spline through points, in 32 bits or 64."""
    y = of.at(x).y
    return certify(of, spline(x, y.astype(np.float32).astype(float) if real else y, (0.0, 0.0)))


def percent(found: Certificate) -> float:
    return found.deviations[2].share * 100.0


# The figures: a modified trapezoid of 300 mm, rebuilt by a clamped cubic spline


@pytest.mark.parametrize(("intervals", "said"), [(20, 2.8), (80, 0.23)])
def test_a_rise_rebuilt_in_lreal_costs_acceleration(intervals: int, said: float) -> None:
    assert percent(through(RISE, equal_steps(RISE, intervals + 1))) == pytest.approx(said, rel=0.02)


@pytest.mark.parametrize(("intervals", "said"), [(400, 1.4), (1000, 7.5), (2000, 36.0)])
def test_more_points_make_it_worse_in_real(intervals: int, said: float) -> None:
    assert percent(through(RISE, equal_steps(RISE, intervals + 1), real=True)) == pytest.approx(said, rel=0.04)


@pytest.mark.parametrize(("intervals", "said"), [(20, 37.0), (400, 0.8)])
def test_equal_steps_over_the_turn_miss_the_breaks(intervals: int, said: float) -> None:
    assert percent(through(TURN, equal_steps(TURN, intervals + 1))) == pytest.approx(said, rel=0.01)


def test_points_on_the_breaks_cost_far_less_than_as_many_at_equal_steps() -> None:
    x = spread(TURN, 60, 4, np.full(len(TURN.origins), 2), np.zeros(len(TURN.origins), dtype=bool))
    assert len(x) <= 60
    assert set(TURN.edges) <= set(x)
    assert percent(through(TURN, x)) < percent(through(TURN, equal_steps(TURN, 60))) / 20.0


# Another route: a dense search, which must find no more, and nearly as much


@pytest.mark.parametrize("entry", MOVING, ids=lambda entry: entry.code)
def test_a_dense_search_finds_no_more_and_nearly_as_much(entry) -> None:
    of = profile_of_motion(Motion([Phase(entry(), 30.0, 90.0), Phase(law("dwell"), 0.0, 270.0)]))
    x = np.unique(np.concatenate([of.edges, equal_steps(of, 50)]))
    at = of.at(x)
    for rebuilt in (lines(x, at.y), parabolas(x, at.y), spline(x, at.y, "not-a-knot"), quintics(x, at.y, at.y1, at.y2)):
        found = certify(of, rebuilt)
        dense = (x[:-1, None] + np.diff(x)[:, None] * np.linspace(1e-6, 1.0 - 1e-6, 400)).ravel()
        for order, (one, other) in enumerate(zip(of.at(dense), rebuilt.at(dense), strict=True)):
            searched = np.abs(one - other).max()
            noise = 1e-11 * found.deviations[order].peak + 1e-12
            assert searched <= found.deviations[order].largest + noise, (entry.code, order)
            assert found.deviations[order].largest <= searched * 1.02 + noise, (entry.code, order)


@pytest.mark.parametrize("entry", MOVING, ids=lambda entry: entry.code)
def test_a_course_is_the_motion(entry) -> None:
    motion = Motion([Phase(entry(), 30.0, 90.0), Phase(law("dwell"), 0.0, 270.0)], start=5.0, position=3.0)
    of = profile_of_motion(motion).in_units(2.0, 1000.0)
    x = np.random.default_rng(3).uniform(5.0, 365.0, 400)
    for order, (one, other) in enumerate(zip(motion.at(x), of.at(2.0 * x), strict=True)):
        scaled = one * 1000.0 / 2.0**order
        assert np.abs(other - scaled).max() <= 1e-10 * max(1e-9, np.abs(scaled).max()), order
    assert all(one.largest == 0.0 for one in certify(of, of).deviations)


# The rules


def test_a_line_in_a_spline_keeps_a_dwell() -> None:
    """The figures of the reference: the clamped spline swings to 37.5 in a dwell of 30, beside a line it does not."""
    x, y = np.array([0.0, 120.0, 240.0, 360.0]), np.array([0.0, 30.0, 30.0, 0.0])
    at = np.array([60.0, 180.0])
    assert spline(x, y, (0.0, 0.0)).at(at).y == pytest.approx([11.25, 37.5])
    assert spline(x, y, "natural").at(at).y[0] == pytest.approx(17.25)
    parted = parted_spline(x, y, (0.0, 0.0), np.array([False, True, False]))
    assert parted.at(at).y == pytest.approx([15.0, 30.0])
    assert parted.at(np.array([120.0]), left=True).y1 == pytest.approx([0.0])


def test_quintics_meet_the_check_values_of_the_reference() -> None:
    x, y = np.array([0.0, 90.0, 180.0, 360.0]), np.array([0.0, 15.0, 30.0, 0.0])
    found = quintics(x, y, np.array([0.0, 0.25, 0.0, 0.0]), np.zeros(4)).at(np.array([45.0, 135.0, 225.0, 270.0]))
    assert found.y == pytest.approx([3.984375, 26.015625, 26.89453125, 15.0])
    assert found.y1 == pytest.approx([0.203125, 0.203125, -0.17578125, -0.3125])


# What is said beside the deviations


def test_jumps_and_closure_are_told() -> None:
    x = np.array([0.0, 40.0, 80.0, 360.0])
    found = certify(TURN, lines(x, np.array([0.0, 150.0, 300.0, 301.0])))
    assert found.closure[0] == pytest.approx(1.0)
    assert found.jumps[1] == pytest.approx(3.75 - 1.0 / 280.0)


@given(by=st.floats(0.001, 359.999))
def test_a_turned_course_is_the_same_motion_later(by: float) -> None:
    later = TURN.shifted(by)
    assert later.edges[[0, -1]] == pytest.approx(TURN.edges[[0, -1]])
    assert np.all(np.diff(later.edges) > 0.0)
    x = np.random.default_rng(1).uniform(0.0, 360.0, 60)
    before = x - by
    expected = TURN.at(np.where(before < 0.0, before + 360.0, before)).y - np.where(before < 0.0, 300.0, 0.0)
    assert later.at(x).y == pytest.approx(expected, abs=1e-8)
