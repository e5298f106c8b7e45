"""The largest value of a section from its nodes: wherever it lies, also a hair inside an end."""

import numpy as np
import pytest

from engine.machine.places import NODES, Polynomial


@pytest.mark.parametrize("bend", [0.2, 1.5])
@pytest.mark.parametrize("top", [0.0, 0.31, 0.9, 0.99, 0.998, 0.9989, 0.9993, 0.9996, 0.9999, 0.999999, 1.0])
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_the_top_of_a_sine_is_found_wherever_it_lies(bend, top, way):
    values = 7.0 * np.cos(bend * (NODES - way * top))
    assert Polynomial(values, 7e-11).top.value == pytest.approx(7.0, rel=1e-10)


@pytest.mark.parametrize("beyond", [1.0001, 1.0007, 1.003, 1.5])
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_top_beyond_an_end_does_not_count(beyond, way):
    values = 7.0 * np.cos(NODES - way * beyond)
    expected = 7.0 * np.cos(1.0 - beyond)
    assert Polynomial(values, 7e-11).top.value == pytest.approx(expected, rel=1e-10)


def test_a_top_in_the_middle_does_not_hang_on_rounding():
    values = 7.0 * np.cos(NODES)
    places = {Polynomial(values * (1.0 + way * 1e-15 * NODES), 7e-11).top.x1 for way in (-1.0, 0.0, 1.0)}
    assert len(places) == 1
