"""Flying machining: the motion over a cycle against its closed figures, standstill, reversal, the saw, the sweep."""

from math import inf, pi, radians, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.flying import Cut, Tool, flying_saw, rotary_drum, sweep_lengths
from engine.laws import CATALOGUE, Cycloidal, Dwell, ModifiedTrapezoidal, Piece, PieceLaw, TrapezoidalVelocity

DRUM = rotary_drum(tools=3, radius=0.1, tool_angle=radians(30))
SAW = flying_saw(tool_length=0.3, metres_per_radian=0.01)
ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
LAWS = [e.example() for e in CATALOGUE if e.code != "DWL"] + [ASYMMETRIC, TrapezoidalVelocity(0.2, 0.3)]
laws = st.sampled_from(LAWS)
lengths = st.floats(0.12, 1.5)
beyond = st.sampled_from(["standstill", "reversal"])


def samples(cut, n=20001):
    step = cut.cycle_time / n
    time = step * (np.arange(n) + 0.5)
    return time, step, cut.at(time)


@settings(max_examples=40)
@given(laws, lengths, beyond)
def test_the_motion_has_the_closed_figures(law, length, way):
    cut = Cut(DRUM, length, 1.2, law, way)
    _, _, motion = samples(cut)
    scale = cut.max_acceleration
    assert np.abs(motion.acceleration).max() == pytest.approx(scale, rel=2e-3)
    assert sqrt((motion.acceleration**2).mean()) == pytest.approx(cut.rms_acceleration, rel=2e-3)
    assert (motion.speed.min(), motion.speed.max()) == pytest.approx(
        cut.speed_range, abs=2e-3 * (1.2 + abs(cut.speed_change))
    )


@settings(max_examples=40)
@given(laws, lengths, beyond)
def test_position_is_the_integral_of_speed_and_ends_one_pitch_on(law, length, way):
    cut = Cut(DRUM, length, 1.2, law, way)
    time, step, motion = samples(cut)
    travelled = cut.at(time + step / 2).position - cut.at(time - step / 2).position
    assert np.abs(travelled - motion.speed * step).max() <= 1e-7
    assert np.abs(np.diff(motion.speed)).max() <= 1.001 * cut.max_acceleration * step + 1e-12
    assert cut.at(cut.cycle_time).position == pytest.approx(DRUM.design_length, abs=1e-12)


@settings(max_examples=40)
@given(laws, lengths, beyond)
def test_the_tool_works_at_line_speed(law, length, way):
    cut = Cut(DRUM, length, 1.2, law, way)
    at_work = cut.at(np.linspace(cut.repositioning_time, cut.cycle_time, 9))
    assert (at_work.speed == 1.2).all()
    assert (at_work.acceleration == 0.0).all()


@pytest.mark.parametrize("law", LAWS, ids=str)
def test_beyond_the_limit_the_drum_waits_or_reverses(law):
    limit = Cut(DRUM, 0.3, 1.0, law).limit_length
    short, long = (Cut(DRUM, limit * k, 1.0, law) for k in (0.999, 1.001))
    assert (short.waits, long.waits) == (False, True)
    assert not long.reverses
    assert long.waiting_time > 0.0
    assert long.speed_range == pytest.approx((0.0, 1.0), abs=1e-12)
    back = Cut(DRUM, limit * 1.001, 1.0, law, "reversal")
    assert back.reverses
    assert back.waiting_time == 0.0


def test_standstill_takes_over_from_the_plain_motion_without_a_jump():
    limit = Cut(DRUM, 0.3, 1.0, Cycloidal()).limit_length
    below, above = (Cut(DRUM, limit * (1 + e), 1.0, Cycloidal()) for e in (-1e-9, 1e-9))
    assert above.max_acceleration == pytest.approx(below.max_acceleration, rel=1e-7)
    assert above.rms_acceleration == pytest.approx(below.rms_acceleration, rel=1e-7)


def test_longer_products_ask_no_more_acceleration_once_the_drum_waits():
    cuts = [Cut(DRUM, length, 1.0, Cycloidal()) for length in (0.5, 0.8, 1.4)]
    assert [c.max_acceleration for c in cuts] == pytest.approx([cuts[0].max_acceleration] * 3, rel=1e-12)


@settings(max_examples=40)
@given(laws, st.floats(0.31, 3.0))
def test_the_saw_comes_back_and_its_stroke_is_what_it_covers(law, length):
    cut = Cut(SAW, length, 0.8, law)
    _, _, motion = samples(cut)
    assert cut.at(cut.cycle_time).position == pytest.approx(0.0, abs=1e-12)
    assert cut.reverses
    assert not cut.waits
    assert cut.stroke == pytest.approx(float(np.ptp(motion.position)), abs=1e-3)
    assert cut.stroke >= np.ptp(motion.position) - 1e-12


def test_stroke_of_a_reversing_drum_by_hand():
    cut = Cut(DRUM, 1.0, 1.0, TrapezoidalVelocity(1 / 4, 3 / 4), "reversal")
    motion = cut.at(np.linspace(0, cut.cycle_time, 200001))
    assert cut.stroke == pytest.approx(np.ptp(motion.position), abs=1e-8)


def test_angular_figures_are_those_of_the_radius():
    cut = Cut(DRUM, 0.15, 1.0, Cycloidal())
    assert cut.max_angular_speed == pytest.approx((1.0 + cut.speed_change) / 0.1, rel=1e-14)
    assert cut.max_angular_acceleration == pytest.approx(cut.max_acceleration / 0.1, rel=1e-14)


def test_the_sweep_is_the_cut_of_each_length():
    found = sweep_lengths(DRUM, np.linspace(0.12, 1.0, 12), 1.1, ASYMMETRIC, inertia=0.03)
    cuts = [Cut(DRUM, length, 1.1, ASYMMETRIC) for length in np.linspace(0.12, 1.0, 12)]
    assert found.displacement == pytest.approx([c.displacement for c in cuts])
    assert found.highest_speed == pytest.approx([c.speed_range[1] for c in cuts])
    assert found.max_acceleration == pytest.approx([c.max_acceleration for c in cuts])
    assert found.load_factor == pytest.approx([c.load_factor(0.03) for c in cuts])
    assert sweep_lengths(DRUM, [], 1.1, ASYMMETRIC, 0.03).length.shape == (0,)


UNFINISHED = PieceLaw([Piece(1.0, (1.0, 0.0, 0.0, 0.0))])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: rotary_drum(0, 0.1, 0.1), "tools is 0"),
        (lambda: rotary_drum(3, 0.1, radians(120)), "tool angle is 120 degrees; expected at least 0 and less than 120"),
        (lambda: rotary_drum(3, 0.0, 0.1), "radius is 0"),
        (lambda: Tool(0.2, 0.3, 0.1), "tool length is 0.3 m; expected less than 0.2 m"),
        (lambda: flying_saw(-0.1, 0.01), "tool length is -0.1"),
        (lambda: Cut(DRUM, 0.05, 1.0, Cycloidal()), "product length is 0.05 m; expected more than L_T"),
        (lambda: Cut(DRUM, inf, 1.0, Cycloidal()), "product length is inf"),
        (lambda: Cut(DRUM, 0.2, 0.0, Cycloidal()), "line speed is 0"),
        (lambda: Cut(DRUM, 0.2, 1.0, Dwell()), "Dwell: expected a law that rises from rest"),
        (lambda: Cut(DRUM, 0.2, 1.0, UNFINISHED), "Own law: expected a law that rises from rest"),
        (lambda: Cut(DRUM, 0.2, 1.0, Cycloidal(), "stop"), "beyond is 'stop'"),
        (lambda: Cut(DRUM, 0.2, 1.0, Cycloidal()).at(1.0), "expected 0 to 0.2 s"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_one_tool_that_works_for_an_instant():
    drum = rotary_drum(1, 0.1, 0.0)
    assert drum.repositioning_length == pytest.approx(2 * pi * 0.1)
    assert Cut(drum, 0.5, 1.0, Cycloidal()).tool_time == 0.0
