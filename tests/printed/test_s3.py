"""S3: the laws' properties, the exercise's composed motion and the examples of the script."""

import math

import numpy as np
import pytest

from engine.laws import law
from engine.motion import motionlaw

NAMES = ("ACS", "TVP", "CIC", "CUB", "ModTVP")


@pytest.mark.parametrize("name", NAMES)
def test_laws_change_the_sign_of_the_acceleration_once(name):
    a = law(name).a(np.linspace(0.001, 0.999, 999))
    signs = np.sign(np.round(a, 9))
    assert np.count_nonzero(np.diff(signs[signs != 0])) == 1


# --- The exercise: 20° cycloidal rise, modified trapezoidal return ---------------------------------

EXERCISE = ["Dwell", "CIC", "Dwell", "ModTVP", "Dwell"]


def exercise(n):
    return motionlaw(EXERCISE, [0, 20, 0, -20, 0], [60, 60, 60, 60, 120], n)


def test_exercise_positions():
    samples = exercise(13)  # every 30°
    assert samples.abscissa.tolist() == [30.0 * k for k in range(13)]
    expected = [0, 0, 0, 10, 20, 20, 20, 10, 0, 0, 0, 0, 0]
    assert samples.y == pytest.approx(expected, abs=1e-12)


def test_exercise_dwell_after_the_rise_stays_up():
    """The script's listing leaves the accumulated position out: there the dwell would drop to 0."""
    samples = exercise(361)
    assert samples.y[120:181] == pytest.approx(np.full(61, 20.0), abs=1e-12)
    assert np.abs(np.diff(samples.y)).max() < 1.0


def test_exercise_peaks_of_velocity_and_acceleration():
    samples = exercise(36_001)
    rise, back = samples.y2[6000:12001], samples.y2[18000:24001]
    assert samples.y1.max() == pytest.approx(2 * 20 / 60, rel=1e-12)
    assert samples.y1.min() == pytest.approx(-2 * 20 / 60, rel=1e-12)
    assert (rise.max(), rise.min()) == pytest.approx((2 * math.pi / 180, -2 * math.pi / 180), rel=1e-9)
    height = 8 * math.pi / (2 + math.pi) * 20 / 60**2
    assert (back.max(), back.min()) == pytest.approx((height, -height), rel=1e-12)


# --- The script's own examples --------------------------------------------------------------------


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
