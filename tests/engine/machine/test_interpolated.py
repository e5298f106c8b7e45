"""The polynomial through values at nodes of a section: right everywhere, and never bent more than it says."""

from itertools import pairwise

import numpy as np
import pytest

from engine.machine.interpolated import Interpolated
from engine.machine.places import NODES

FUNCTIONS = {
    "straight": lambda x: 3.0 - 2.0 * x,
    "parabola": lambda x: 5.0 * x**2 - x,
    "slow sine": lambda x: np.sin(1.3 * x + 0.4),
    "fast sine": lambda x: np.sin(7.0 * x + 1.0),
    "steep at an end": lambda x: 1.0 / (1.55 - x),
    "flat and steep": lambda x: np.exp(5.0 * x),
    "bent in the middle": lambda x: 1.0 / (1.0 + x**2),
}


def section(name, low=2.0, high=2.5):
    """A section of a function, and its power at places of the motion."""
    function = FUNCTIONS[name]
    return Interpolated(function(NODES), low, high), lambda u: function(2.0 * (u - low) / (high - low) - 1.0)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_it_is_the_function_between_nodes_beside_them_and_at_both_ends(name):
    found, power = section(name)
    size = np.abs(found.values).max()
    for u in [2.0, 2.0 + 1e-9, *np.linspace(2.003, 2.499, 37), *(2.25 + (0.25 - 1e-12) * NODES), 2.5]:
        assert found.over(u, 0.0)[0] == pytest.approx(power(u), abs=3e-7 * size)
    assert found.over(2.2, 0.1) == pytest.approx((power(2.1), power(2.3)), abs=3e-7 * size)
    assert found.ends == pytest.approx((power(2.0), power(2.5)))


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("step", [0.002, 0.013, 0.1, 0.5, 3.0])
def test_no_straight_line_is_off_by_more_than_is_said_nor_by_far_less(name, step):
    found, power = section(name)
    size, worst = float(np.abs(found.values).max()), 0.0
    for late in np.linspace(0.0, 1.0, 11):
        cuts = np.unique(np.clip(np.arange(2.0 - late * step, 2.5 + step, step), 2.0, 2.5))
        for low, high in pairwise(cuts.tolist()):
            u = np.linspace(low, high, 33)
            line = power(low) + (power(high) - power(low)) * (u - low) / (high - low)
            worst = max(worst, float(np.abs(power(u) - line).max()))
    off = found.off(step, 0.8) * 0.8
    assert worst <= off + 1e-11 * size
    assert step > 0.05 or off <= 2.2 * worst + 1e-10 * size
