"""A place in a cycle that rounding puts a hair before the cycle's end is on its begin, as spreadsheet cells have it."""

import pytest

from engine.motion.shifted import place_in_cycle

NEAR = 1e-6


@pytest.mark.parametrize("late", [0.0, 0.1, 120.0, -37.3, 359.9999999, 360.0, -360.0])
@pytest.mark.parametrize("off", [0.0, 6e-14, -6e-14, 1e-9, -1e-9])
def test_what_lies_a_rounding_beside_the_begin_is_on_it(late, off):
    assert place_in_cycle(360.0 - late + off + late, 360.0, NEAR) == pytest.approx(0.0, abs=2e-9)


@pytest.mark.parametrize("angle", [1e-5, 15.0, 180.0, 360.0 - 1e-5, 360.0 + 15.0, -15.0])
def test_elsewhere_it_is_the_place_in_the_cycle(angle):
    assert place_in_cycle(angle, 360.0, NEAR) == pytest.approx(angle % 360.0, abs=1e-12)
