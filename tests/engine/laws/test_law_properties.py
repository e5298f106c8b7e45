"""Trapezoidal velocity and the seven-stage law with any parameters: rest, derivatives, coefficients."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from engine.laws import ModifiedTrapezoidal, Piece, PieceLaw, TrapezoidalVelocity

part = st.floats(0.02, 1.0)
part_or_nothing = st.one_of(st.just(0.0), part)


@st.composite
def seven(draw, stage=part_or_nothing):
    """Seven durations, zeros among them, that make a law."""
    parts = [draw(stage) for _ in range(7)]
    assume(sum(parts[:3]) > 0 and sum(parts[4:]) > 0)
    return tuple(p / sum(parts) for p in parts)


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


@given(seven())
def test_seven_stages_start_and_stop_at_rest_and_never_turn_back(durations):
    assert_keeps_the_rules(ModifiedTrapezoidal(durations))


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
