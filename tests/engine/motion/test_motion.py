"""Phases joined: position carried on, derivatives, edges, junctions, and S3's call."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import Dwell, Piece, PieceLaw, UnknownLawError
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.polynomials import Cubic
from engine.laws.ramps import TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal
from engine.motion import Motion, Phase, motionlaw

RISE_AND_RETURN = [
    Phase(Dwell(), 0.0, 1.0),
    Phase(Cycloidal(), 20.0, 2.0),
    Phase(Dwell(), 0.0, 1.0),
    Phase(ModifiedTrapezoidal(), -20.0, 4.0),
]


def test_position_is_carried_on():
    motion = Motion(RISE_AND_RETURN, start=-1.0, position=5.0)
    at = motion.at(np.array([-1.0, 0.0, 1.0, 2.0, 2.5, 3.0, 5.0, 7.0]))
    assert at.y == pytest.approx([5, 5, 15, 25, 25, 25, 15, 5], abs=1e-12)
    assert (motion.total, motion.lifts_sum) == (8.0, 0.0)


def test_derivatives_are_per_unit_of_the_abscissa():
    motion = Motion(RISE_AND_RETURN)
    middle = motion.at(2.0)
    assert middle.y1 == pytest.approx(2 * 20 / 2)
    assert motion.at(1.5).y2 == pytest.approx(2 * math.pi * 20 / 2**2)
    x = np.array([1.3, 2.2, 4.3, 5.1, 7.7])
    h = 1e-4
    assert (motion.at(x + h).y - motion.at(x - h).y) / (2 * h) == pytest.approx(motion.at(x).y1, abs=1e-5)
    assert (motion.at(x + h).y1 - motion.at(x - h).y1) / (2 * h) == pytest.approx(motion.at(x).y2, abs=1e-5)


def test_numbers_in_numbers_out_and_arrays_keep_their_shape():
    motion = Motion(RISE_AND_RETURN)
    assert {type(value) for value in motion.at(1.5)} == {float}
    x = np.linspace(0, 8, 6).reshape(2, 3)
    assert {value.shape for value in motion.at(x)} == {(2, 3)}
    assert motion.at(np.array([])).y.shape == (0,)
    assert motion.at(np.array(1.5)).y.shape == ()


@pytest.mark.parametrize("rounding", [-7e-12, 0.0, 7e-12])
def test_edges_belong_to_the_later_phase(rounding):
    motion = Motion([Phase(ConstantAcceleration(), 1.0, 4.0), Phase(ConstantAcceleration(), -1.0, 4.0)])
    assert motion.at(4.0 + rounding).y2 == -4 / 16
    assert motion.at(4.0 - 1e-7).y2 == -4 / 16  # also the deceleration before it


def test_the_last_edge_has_the_left_limit():
    motion = Motion([Phase(Dwell(), 0.0, 1.0), Phase(ConstantAcceleration(), 1.0, 1.0)])
    assert motion.at(2.0) == (1.0, 0.0, -4.0, 0.0)
    assert motion.at(2.0 + 1e-12) == motion.at(2.0)


def test_edges_are_kept_to_the_last_bit():
    edges = np.deg2rad([0.0, 80.0, 145.0, 360.0])
    motion = Motion.from_edges(edges, [0.3, 0.0, -0.3], [Cubic(), Dwell(), Cubic()])
    assert (motion.edges == edges).all()
    assert motion.at(edges).y == pytest.approx([0, 0.3, 0.3, 0], abs=1e-15)
    with pytest.raises(ValueError, match="read-only"):
        motion.edges[0] = 1.0
    edges[0] = 1.0  # the motion has its own


@pytest.mark.parametrize("x", [-0.1, 8.1, math.inf])
def test_an_abscissa_outside_is_refused(x):
    with pytest.raises(ValueError, match=r"x reaches from .* expected numbers from 0 to 8"):
        Motion(RISE_AND_RETURN).at(x)


def test_nan_is_refused():
    with pytest.raises(ValueError, match="x holds NaN"):
        Motion(RISE_AND_RETURN).at(math.nan)


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda: Phase(Cubic(), 1.0, 0.0), "duration is 0; expected more than 0"),
        (lambda: Phase(Cubic(), 1.0, -1.0), "duration is -1"),
        (lambda: Phase(Cubic(), math.nan, 1.0), "lift is nan"),
        (lambda: Phase(Dwell(), 1.0, 1.0), "lift is 1 in a dwell; expected 0"),
        (lambda: Motion([]), "no phases"),
        (lambda: Motion(RISE_AND_RETURN, position=math.inf), "position is inf"),
        (lambda: Motion.from_edges([0, 1], [1, 2], [Cubic()]), "2 edges, 2 lifts and 1 laws"),
        (lambda: Motion.from_edges([0, 2, 1], [1, 1], [Cubic(), Cubic()]), "phase 2: duration is -1"),
    ],
)
def test_what_cannot_be_is_refused(made, message):
    with pytest.raises(ValueError, match=message):
        made()


def test_motionlaw_hands_parameters_to_their_phase():
    settings = [None, {"rise_end": 0.2, "fall_start": 0.7}, {}]
    samples = motionlaw(["Dwell", "TVP", "TVP"], [0, 2, -2], [1, 2, 2], 51, settings)
    other = Motion(
        [Phase(Dwell(), 0, 1), Phase(TrapezoidalVelocity(0.2, 0.7), 2, 2), Phase(TrapezoidalVelocity(), -2, 2)]
    ).at(np.linspace(0, 5, 51))
    for got, expected in zip(samples[1:], other, strict=True):
        assert (got == expected).all()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((["CIC", "ACS"], [1.0], [1.0, 1.0], 10), "2 laws, 1 lifts, 2 durations are given"),
        ((["CIC"], [1.0], [1.0], 10, [None, None]), "1 laws, 1 lifts, 1 durations, 2 parameters"),
        ((["CIC"], [1.0], [1.0], 1), "n is 1; expected at least 2 samples"),
        ((["CIC", "Dwell"], [1.0, 0.5], [1.0, 1.0], 10), "phase 2: lift is 0.5 in a dwell"),
        (([], [], [], 10), "no phases"),
    ],
)
def test_motionlaw_says_what_does_not_go_together(arguments, message):
    with pytest.raises(ValueError, match=message):
        motionlaw(*arguments)


def test_motionlaw_refuses_an_unknown_law():
    with pytest.raises(UnknownLawError, match="'SPI'"):
        motionlaw(["Dwell", "SPI"], [0, 1], [1, 1], 10)


THROWN = PieceLaw([Piece(1.0, (2.0, 0.0, 0.0, 0.0))])  # from rest to v = 2
SHORT = PieceLaw([Piece(0.5, (2.0, 0.0, 0.0, 0.0)), Piece(0.5, (-2.0, 0.0, 0.0, 0.0))])  # s(1) = 1/2, at rest
laws = st.sampled_from([ConstantAcceleration(), Cycloidal(), Cubic(), ModifiedTrapezoidal(), THROWN, SHORT])
lifted = st.builds(Phase, laws, st.floats(-5, 5), st.floats(0.5, 3))


@given(st.lists(lifted, min_size=1, max_size=4))
def test_the_ends_of_each_phase_are_the_motion_s_limits_there(phases):
    motion = Motion(phases, position=1.5)
    for k, (begin, end) in enumerate(motion.ends):
        assert begin == pytest.approx(motion.at(float(motion.edges[k])), abs=1e-12)
        near = motion.at(float(motion.edges[k + 1]) - 1e-8 * motion.total)
        assert end == pytest.approx(near, abs=1e-4)


@given(st.lists(lifted, min_size=1, max_size=4))
def test_peaks_and_rms_are_those_of_the_samples(phases):
    motion, n = Motion(phases), 40_000
    at = motion.at((np.arange(n) + 0.5) * motion.total / n)
    assert motion.peaks.y1 == pytest.approx(np.abs(at.y1).max(), rel=1e-3, abs=1e-9)
    assert motion.peaks.y2 == pytest.approx(np.abs(at.y2).max(), rel=1e-3, abs=1e-9)
    assert motion.y2_rms == pytest.approx(math.sqrt(np.mean(at.y2**2)), rel=1e-3, abs=1e-9)


def test_sizes_are_1_where_nothing_moves():
    assert [Motion([Phase(Dwell(), 0.0, 3.0)]).size(n) for n in range(4)] == [1.0, 1.0, 1.0, 1.0]
    assert [Motion([Phase(Cycloidal(), -6.0, 2.0), Phase(Cubic(), 1.0, 4.0)]).size(n) for n in range(4)] == [
        6.0,
        3.0,
        1.5,
        0.75,
    ]


def test_a_motion_that_comes_back_closes_and_says_its_gap_if_not():
    assert Motion(RISE_AND_RETURN).closes
    advanced = Motion(RISE_AND_RETURN[:3], position=7.0)
    assert (advanced.closes, advanced.gap) == (False, 20.0)


def test_a_law_that_stops_short_leaves_the_motion_incomplete():
    phase = Phase(SHORT, 4.0, 1.0)
    assert phase.missing_lift == pytest.approx(2.0)
    assert Motion(RISE_AND_RETURN).complete
    assert not Motion([phase]).complete
    assert Motion([phase]).gap == pytest.approx(2.0)
