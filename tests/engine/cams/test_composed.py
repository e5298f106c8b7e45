"""A motion through a mechanism: against the exact angle everywhere, and its derivatives against differences of it."""

import numpy as np
import pytest

from engine import law
from engine.cams.interpolation import FunctionValues, compose_profile
from engine.drive.mechanisms.slides import crank_slider
from engine.drive.mechanisms.variable_ratio import PositionTable
from engine.motion import Motion, Phase
from engine.motion.profile import profile_of_motion

CRANK = crank_slider(0.05, 0.2, 0.01, "inner", "ahead", 0.03)
TABLE = PositionTable([(0.3 * k, 0.02 * k - 0.03 + 0.004 * np.sin(k)) for k in range(8)])


@pytest.mark.parametrize("linkage", [CRANK, TABLE], ids=["crank", "table"])
@pytest.mark.parametrize("name", ["CIC", "ACS", "MTP"])
def test_the_shafts_angle_is_that_of_the_mechanism_everywhere(linkage, name):
    motion = Motion([Phase(law(name), 0.04, 2.0), Phase(law("dwell"), 0.0, 0.5), Phase(law(name), -0.04, 1.5)])
    of = profile_of_motion(motion)
    made = compose_profile(of, lambda y: FunctionValues(*linkage.shaft(y)))
    x = np.sort(np.random.default_rng(3).uniform(0.0, of.total, 4_001))
    exact = linkage.shaft(of.at(x).y).angle
    assert np.abs(made.at(x).y - exact).max() <= 1e-8 * np.ptp(exact)
    h = 1e-4
    inside = np.abs(x[:, None] - made.edges).min(axis=1) > 2 * h
    before, here, after = (linkage.shaft(of.at(x[inside] + by).y).angle for by in (-h, 0.0, h))
    at = made.at(x[inside])
    assert at.y1 == pytest.approx((after - before) / (2 * h), abs=1e-5 * np.abs(at.y1).max())
    assert at.y2 == pytest.approx((after - 2 * here + before) / h**2, abs=2e-3 * np.abs(at.y2).max())
    assert len(made.origins) < 2_000
