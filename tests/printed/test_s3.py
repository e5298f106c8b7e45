"""S3: the examples of its script."""

import math

import numpy as np
import pytest

from engine.motion import motionlaw


def test_example_of_a_complex_motion():
    """{Dwell CIC Dwell CIC Dwell}, lifts 0 20 0 −20 0°, durations 60 45 75 90 90, in rad per degree."""
    names = ["Dwell", "CIC", "Dwell", "CIC", "Dwell"]
    samples = motionlaw(names, np.deg2rad([0, 20, 0, -20, 0]), [60, 45, 75, 90, 90], 721)
    h = math.radians(20)
    at = {x: i for i, x in enumerate(samples.abscissa)}
    for x, y, y1 in [(30, 0, 0), (82.5, h / 2, 2 * h / 45), (140, h, 0), (225, h / 2, -2 * h / 90), (300, 0, 0)]:
        assert (samples.y[at[x]], samples.y1[at[x]]) == pytest.approx((y, y1), abs=1e-15)
    assert samples.y2.max() == pytest.approx(2 * math.pi * h / 45**2, rel=1e-3)
    assert samples.y2[at[202.5]] == pytest.approx(-2 * math.pi * h / 90**2, rel=1e-12)


def test_example_of_a_simple_motion():
    """{TVP}, h = π over 360, 1000 samples."""
    samples = motionlaw(["TVP"], [math.pi], [360], 1000)
    assert len(samples.abscissa) == 1000
    assert (samples.y[0], samples.y[-1]) == pytest.approx((0, math.pi), abs=1e-14)
    assert samples.y1.max() == pytest.approx(1.5 * math.pi / 360, rel=1e-14)
    assert (samples.y2.max(), samples.y2.min()) == pytest.approx(
        (4.5 * math.pi / 360**2, -4.5 * math.pi / 360**2), rel=1e-14
    )
