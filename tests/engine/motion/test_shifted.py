"""Motions told from another angle, and the least gap between them: against dense samples and closed forms."""

import random
from math import pi

import numpy as np
import pytest

from engine.laws import Dwell, law
from engine.motion import Motion
from engine.motion.shifted import Shifted, least_gap
from engine.timing import Switch
from tests.engine.drive.machines import handing_over, motion_of
from tests.tiers import nights, seed

TURN = 2 * pi


def punch():
    return Motion.from_edges([0.0, 2.0, 4.0, TURN], [0.05, -0.05, 0], [law("CIC"), law("CIC"), Dwell()], position=0.01)


def feed():
    return Motion.from_edges([0.0, 1.5, TURN], [0.3, 0], [law("MTP"), Dwell()])


def test_a_shifted_motion_is_the_motion_later():
    x = np.linspace(0, TURN, 301)[1:-1]
    for shift in (0.0, 1.0, -2.5, 20.0):
        inner = (x - shift) % TURN
        assert Shifted(punch(), shift).at(x).y == pytest.approx(punch().at(inner).y, abs=1e-15)
        assert Shifted(punch(), shift).at(x).y1 == pytest.approx(punch().at(inner).y1, abs=1e-12)


def test_a_feed_goes_on():
    one = Shifted(feed(), 1.0)
    assert one.at(np.array([0.0, 1.0, 2.5, 7.0])).y == pytest.approx([0, 0, 0.3, 0.3])
    assert one.at(np.array([-3.5, 1.0 + TURN + 1.5])).y == pytest.approx([0.0, 0.6])
    y = one.at(np.linspace(-10, 10, 4001)).y
    assert np.diff(y).max() < 0.01
    assert np.diff(y).min() > -1e-14


@pytest.mark.parametrize("number", [*range(6), *nights(40)])
def test_the_least_gap_against_samples(request, number):
    told = f"gap {number}"
    rng = random.Random(seed(told) if request.node.get_closest_marker("nightly") else told)
    axes = [(rng.uniform(-1, 1), Shifted(rng.choice([motion_of, handing_over])(rng, 0, 0.1), rng.uniform(-9, 9)))
            for _ in range(rng.randint(1, 3))]  # fmt: skip
    x = np.linspace(0, TURN, 200001)
    gap = 0.2 + sum(factor * one.at(x).y for factor, one in axes)
    found = least_gap(axes, 0.2)
    assert found.least == pytest.approx(gap.min(), abs=1e-8)
    assert found.least <= gap.min() + 1e-12
    at = 0.2 + sum(factor * float(one.at(np.array([found.x])).y[0]) for factor, one in axes)
    assert at == pytest.approx(found.least, abs=1e-11)


def test_gaps_that_cannot_be_are_refused():
    with pytest.raises(ValueError, match="no axes"):
        least_gap([], 0.0)
    short = Motion.from_edges([0.0, 1.0], [0.1], [law("CIC")])
    with pytest.raises(ValueError, match="one cycle"):
        least_gap([(1.0, Shifted(punch())), (1.0, Shifted(short))], 0.0)
    with pytest.raises(ValueError, match="shift"):
        Shifted(punch(), float("nan"))


def test_a_switch_is_on_from_its_begin_to_its_end():
    valve = Switch("Valve 3", ((20.0, 95.0), (200.0, 215.0), (350.0, 10.0)), 360.0)
    assert list(valve.at(np.array([0.0, 10.0, 20.0, 94.9, 95.0, 214.0, 215.0, 355.0]))) == [1, 0, 1, 1, 0, 1, 0, 1]
    assert valve.total == pytest.approx(110.0)
    assert Switch("always", ((0.0, 360.0),), 360.0).total == 360.0
    assert Switch("never", (), 360.0).at(np.array([1.0])) == 0.0


def test_switches_that_cannot_be_are_refused():
    with pytest.raises(ValueError, match="within 0 to 360"):
        Switch("far", ((10.0, 400.0),), 360.0)
    with pytest.raises(ValueError, match="overlap"):
        Switch("twice", ((10.0, 50.0), (40.0, 60.0)), 360.0)
    with pytest.raises(ValueError, match="overlap"):
        Switch("across", ((350.0, 50.0), (40.0, 60.0)), 360.0)
