"""Halving step by step: each middle is that of the part with the root, and the last is as near as it can be."""

import numpy as np
import pytest

from engine.halving import velocity_halvings
from engine.laws import ConstantAcceleration, Cubic, Cycloidal, ModifiedTrapezoidal


@pytest.mark.parametrize("law", [Cycloidal(), Cubic(), ModifiedTrapezoidal(), ConstantAcceleration()], ids=str)
@pytest.mark.parametrize("wanted", [0.3, 1.0, 1.4])
@pytest.mark.parametrize("ends", [(0.0, 0.5), (0.5, 1.0)])
def test_velocity_is_met_on_either_side_of_the_peak(law, wanted, ends):
    low, high, middle = velocity_halvings(law, wanted, *ends, 30, 1e-12)
    assert (low[0], high[0]) == ends
    assert law.v(float(middle[-1])) == pytest.approx(wanted, abs=1e-7)
    assert (np.diff(high - low) < 0).all()
    assert (middle == (low + high) / 2).all()
