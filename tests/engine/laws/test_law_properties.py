"""Trapezoidal velocity and the seven-stage law with any parameters: rest, derivatives, coefficients."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from engine.laws import ModifiedTrapezoidal, Piece, PieceLaw, TrapezoidalVelocity
from engine.laws.base import BREAK_TOLERANCE

HAIR = 2 * BREAK_TOLERANCE

part = st.floats(0.02, 1.0)
part_or_nothing = st.one_of(st.just(0.0), part)
stencil = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12.0


@st.composite
def seven(draw, stage=part_or_nothing):
    """Seven durations, zeros among them, that make a law."""
    parts = [draw(stage) for _ in range(7)]
    assume(sum(parts[:3]) > 0 and sum(parts[4:]) > 0)
    return tuple(p / sum(parts) for p in parts)


@st.composite
def breaks(draw):
    """Break points of the trapezoidal velocity, also with no uniform stage."""
    first, uniform, last = draw(part), draw(part_or_nothing), draw(part)
    total = first + uniform + last
    return first / total, min((first + uniform) / total, 1 - 1e-3) if uniform else first / total


def stages(law):
    """Begin and end of each stage that lasts."""
    if isinstance(law, TrapezoidalVelocity):
        edges = [0.0, law.rise_end, law.fall_start, 1.0]
    else:
        edges = [0.0, *itertools.accumulate(law.durations)]
    return [(a, min(b, 1.0)) for a, b in itertools.pairwise(edges) if b - a > 1e-6]


def inside(law, n=9):
    """Points within the stages, one row a stage, and the step of a stencil that stays within."""
    ends = np.array(stages(law))
    width = np.diff(ends)
    return ends[:, :1] + width * np.linspace(0.1, 0.9, n), width / 100.0


def assert_keeps_the_rules(law):
    end = law.end
    assert (end.s, end.v) == pytest.approx((1.0, 0.0), abs=1e-12)
    at = law.evaluate(np.linspace(0, 1, 501))
    assert np.diff(at.s).min() >= -1e-13
    assert at.v.min() >= -1e-13


def assert_derivatives(law):
    xi, h = inside(law)
    around = law.evaluate(xi[..., None] + h[..., None] * np.arange(-2, 3))
    at = law.evaluate(xi)
    for value, rate in zip(around[:3], at[1:], strict=True):
        numerical = value @ stencil / h
        assert numerical == pytest.approx(rate, rel=1e-5, abs=1e-6 * max(1.0, np.abs(rate).max()))


def assert_coefficients(law):
    k = law.coefficients
    xi = np.concatenate([np.linspace(a + HAIR, b - HAIR, 2001) for a, b in stages(law)])
    weights = np.concatenate([np.full(2001, (b - a) / 2000) for a, b in stages(law)])
    weights[::2001] /= 2
    weights[2000::2001] /= 2
    at = law.evaluate(xi)
    power = at.v * at.a
    shown = (np.abs(at.v).max(), at.a.max(), at.a.min(), power.max(), power.min())
    assert shown == pytest.approx((k.cv, k.ca_max, k.ca_min, k.va_max, k.va_min), rel=2e-5)
    assert math.sqrt(weights @ at.a**2) == pytest.approx(k.ca_rms, rel=1e-5)
    if math.isfinite(k.cj):
        assert np.abs(at.j).max() == pytest.approx(k.cj, rel=1e-5)


@given(breaks())
def test_trapezoidal_velocity(parameters):
    law = TrapezoidalVelocity(*parameters)
    assert_keeps_the_rules(law)
    assert_derivatives(law)
    assert_coefficients(law)


@given(seven())
def test_seven_stages_start_and_stop_at_rest_and_never_turn_back(durations):
    assert_keeps_the_rules(ModifiedTrapezoidal(durations))


@given(seven())
def test_seven_stages_derivatives(durations):
    assert_derivatives(ModifiedTrapezoidal(durations))


@given(seven())
def test_seven_stages_coefficients(durations):
    assert_coefficients(ModifiedTrapezoidal(durations))


@given(seven())
def test_seven_stages_jerk_is_finite_only_with_four_sines(durations):
    law = ModifiedTrapezoidal(durations)
    assert math.isfinite(law.coefficients.cj) == all(d > 0 for d in durations[::2])


@given(seven(), st.sampled_from([-5e-13, 0.0, 5e-13]))
def test_seven_stages_are_right_continuous_at_every_break(durations, rounding):
    law = ModifiedTrapezoidal(durations)
    a, b = law.acceleration, law.deceleration
    expected = (0.0, a, a, 0.0, 0.0, -b, -b)
    begin = 0.0
    for d, value in zip(durations, expected, strict=True):
        if d > 0:
            assert law.a(min(max(begin + rounding, 0.0), 1.0)) == pytest.approx(value, abs=1e-6)
        begin += d


@given(seven())
def test_seven_stages_end_with_the_left_limit(durations):
    law = ModifiedTrapezoidal(durations)
    last = max(i for i, d in enumerate(durations) if d > 0)
    left = {4: -law.deceleration, 5: -law.deceleration, 6: 0.0}[last]
    assert law.end.a == pytest.approx(left, abs=1e-9)


@given(seven())
def test_seven_stages_backwards_are_the_law_of_the_durations_backwards(durations):
    law, mirrored = ModifiedTrapezoidal(durations), ModifiedTrapezoidal(durations[::-1])
    xi, _ = inside(law)
    there, back = law.evaluate(xi), mirrored.evaluate(1.0 - xi)
    assert there.s == pytest.approx(1.0 - back.s, abs=1e-12)
    assert there.v == pytest.approx(back.v, abs=1e-11)
    assert there.a == pytest.approx(-back.a, abs=1e-9)


@given(seven())
def test_seven_stages_carried_on_piece_by_piece_are_the_same_law(durations):
    law = ModifiedTrapezoidal(durations)
    own = PieceLaw(seven_pieces(law))
    xi, _ = inside(law)
    scales = (1.0, law.coefficients.cv, law.coefficients.ca, np.abs(law.j(xi)).max() + 1.0)
    for one, other, scale in zip(law.evaluate(xi), own.evaluate(xi), scales, strict=True):
        assert one == pytest.approx(other, abs=1e-11 * scale)
    for name, value in vars(law.coefficients).items():
        assert getattr(own.coefficients, name) == pytest.approx(value, rel=1e-9), name


def seven_pieces(law):
    """The seven stages as an engineer would enter them, from the heights A and B."""
    d, a, b = law.durations, law.acceleration, law.deceleration
    w = [math.pi / 2 / x if x else 1.0 for x in d]
    quarter = math.pi / 2
    return [
        Piece(d[0], amplitude=a, omega=w[0]),
        Piece(d[1], (a, 0, 0, 0)),
        Piece(d[2], amplitude=a, omega=w[2], phase=quarter),
        Piece(d[3]),
        Piece(d[4], amplitude=-b, omega=w[4]),
        Piece(d[5], (-b, 0, 0, 0)),
        Piece(d[6], amplitude=-b, omega=w[6], phase=quarter),
    ]


@given(seven(stage=part), st.integers(0, 6))
def test_a_stage_that_shrinks_to_nothing_ends_as_the_law_without_it(durations, stage):
    def law(length):
        d = list(durations)
        d[stage] = length
        return ModifiedTrapezoidal([x / sum(d) for x in d])

    xi = np.linspace(0, 1, 41)
    nearly, without = law(1e-9), law(0.0)
    assert nearly.s(xi) == pytest.approx(without.s(xi), abs=1e-7)
    assert nearly.v(xi) == pytest.approx(without.v(xi), abs=1e-6)
