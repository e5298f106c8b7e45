"""The seven-stage law: known heights, and the laws that it contains."""

import math

import numpy as np
import pytest

from engine.laws import ConstantAcceleration, Cycloidal, ModifiedTrapezoidal, TrapezoidalVelocity
from engine.laws.base import BREAK_TOLERANCE

XI = np.linspace(0, 1, 1001)


@pytest.mark.parametrize(
    ("durations", "a", "b"),
    [
        ((0.1, 0.2, 0.1, 0.2, 0.1, 0.2, 0.1), 5.0917956, 5.0917956),
        ((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1), 7.2004460, 4.0772962),
    ],
)
def test_heights_known_from_elsewhere(durations, a, b):
    law = ModifiedTrapezoidal(durations)
    assert (law.acceleration, law.deceleration) == pytest.approx((a, b), abs=5e-8)
    assert (law.coefficients.ca_max, law.coefficients.ca_min) == (law.acceleration, -law.deceleration)


@pytest.mark.parametrize(
    ("durations", "special"),
    [
        ((0, 1 / 2, 0, 0, 0, 1 / 2, 0), ConstantAcceleration()),
        ((0, 1 / 3, 0, 1 / 3, 0, 1 / 3, 0), TrapezoidalVelocity()),
        ((0, 0.2, 0, 0.5, 0, 0.3, 0), TrapezoidalVelocity(0.2, 0.7)),
        ((1 / 4, 0, 1 / 4, 0, 1 / 4, 0, 1 / 4), Cycloidal()),
    ],
    ids=["constant acceleration", "trapezoidal", "asymmetric trapezoidal", "cycloidal"],
)
def test_laws_that_it_contains(durations, special):
    law = ModifiedTrapezoidal(durations)
    for got, expected in zip(law.evaluate(XI), special.evaluate(XI), strict=True):
        assert got == pytest.approx(expected, rel=1e-12, abs=1e-12)
    for name, value in vars(special.coefficients).items():
        assert getattr(law.coefficients, name) == pytest.approx(value, rel=1e-12), name


def test_modified_sine():
    """The textbook's three parts: a quarter turn fast, half a turn three times slower, a quarter fast."""
    law, c = ModifiedTrapezoidal((1 / 8, 0, 3 / 8, 0, 3 / 8, 0, 1 / 8)), 1 / (4 + math.pi)
    fast, slow = np.sin(4 * math.pi * XI), np.sin((4 * math.pi * XI + math.pi) / 3)
    outer = np.where(XI < 0.5, 0.0, 4.0) + math.pi * XI - fast / 4
    s = c * np.where((XI < 1 / 8) | (XI > 7 / 8), outer, 2 + math.pi * XI - 9 / 4 * slow)
    assert law.s(XI) == pytest.approx(s, abs=1e-14)


def test_simple_harmonic():
    law, turn = ModifiedTrapezoidal((0, 0, 1 / 2, 0, 1 / 2, 0, 0)), math.pi * XI
    expected = (
        (1 - np.cos(turn)) / 2,
        math.pi / 2 * np.sin(turn),
        math.pi**2 / 2 * np.cos(turn),
        -(math.pi**3) / 2 * np.sin(turn),
    )
    for got, value in zip(law.evaluate(XI), expected, strict=True):
        assert got == pytest.approx(value, abs=1e-13 * 31)


def test_a_jump_at_the_middle_shows_the_deceleration():
    law = ModifiedTrapezoidal((0, 0.5, 0, 0, 0, 0.5, 0))
    assert law.a(0.5) == law.a(0.5 - BREAK_TOLERANCE / 2) == -4.0
    assert law.a(0.5 - BREAK_TOLERANCE * 2) == 4.0


def test_classic_stages_as_written_in_the_books():
    """a = A sin(πu/2d1), A, A cos(πu/2d3), 0, −B sin(πu/2d5), −B, −B cos(πu/2d7), mid-stage."""
    d = (0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1)
    law = ModifiedTrapezoidal(d)
    half, a, b = math.sqrt(0.5), law.acceleration, law.deceleration
    middles = np.cumsum(d) - np.array(d) / 2
    assert law.a(middles) == pytest.approx([a * half, a, a * half, 0, -b * half, -b, -b * half], abs=1e-13)


def test_durations_that_sum_to_one_but_for_rounding_still_bring_it_home():
    third = 0.333333333
    law = ModifiedTrapezoidal((0, third, 0, third, 0, third + 5e-10, 0))
    assert (law.end.s, law.end.v) == pytest.approx((1.0, 0.0), abs=1e-8)
