"""Flying machining: the motion over a cycle against its closed figures, standstill, reversal, the saw, the sweep."""

from math import inf, pi, radians, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.drive import Load
from engine.flying.cut import Cut, Tool, flying_saw, rotary_drum
from engine.flying.pieces import cut_joints, cut_pieces, cycle_of, rates_of, train_of
from engine.laws import CATALOGUE, Dwell, Piece, PieceLaw
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.ramps import TrapezoidalVelocity
from engine.laws.simple import Cycloidal
from engine.motion.pieces import MotionPieces

DRUM = rotary_drum(tools=3, radius=0.1, tool_angle=radians(30))
SAW = flying_saw(tool_length=0.3, metres_per_radian=0.01)
ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
RESTING = [
    law for law in (one() for one in CATALOGUE if one is not Dwell) if max(abs(law.start.v), abs(law.end.v)) < 1e-9
]
LAWS = [*RESTING, ASYMMETRIC, TrapezoidalVelocity(0.2, 0.3)]
laws = st.sampled_from(LAWS)
lengths = st.floats(0.12, 1.5)
beyond = st.sampled_from(["standstill", "reversal"])


def samples(cut, n=20001):
    step = cut.cycle_time / n
    time = step * (np.arange(n) + 0.5)
    return time, step, cut.at(time)


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


@given(laws, lengths, beyond)
def test_what_jumps_at_the_joints_is_what_the_motion_shows_on_either_side(law, length, way):
    """A wait interrupts the law in the middle of a piece; from the closed forms, just before and just behind."""
    cut = Cut(DRUM, length, 1.2, law, way)
    near, scales = 1e-6 * cut.cycle_time, rates_of(cut)
    apart = [joint for joint in cut_joints(cut, "jerk") if joint.jump]
    begins = np.array([joint.x for joint in apart])
    assert len(begins) > 1
    crowded = np.diff(begins, append=cut.cycle_time) < 4 * near
    before, behind = (cut.at((begins + side * near) % cut.cycle_time) for side in (-1, 1))
    for n, name in enumerate(("speed", "acceleration")):
        seen = getattr(behind, name) - getattr(before, name)
        told = np.array([joint.jump[n] for joint in apart])
        assert np.abs(np.where(crowded, 0.0, seen - told)).max() <= 1e-3 * scales[n]


@pytest.mark.parametrize("way", ["standstill", "reversal"])
@pytest.mark.parametrize("length", [0.15, 0.9])
def test_the_tool_is_as_smooth_as_its_law(length, way):
    """Whether it waits or not: at its fastest instant a law without a jump has no acceleration."""

    def least(law):
        cut = Cut(DRUM, length, 1.2, law, way)
        return [max(joint.order for joint in cut_joints(cut, s)) for s in ("velocity", "acceleration", "jerk")]

    assert least(Cycloidal()) == least(ModifiedTrapezoidal()) == [0, 0, 3]
    assert least(TrapezoidalVelocity(0.2, 0.3)) == [0, 2, 2]
    septic = next(law for law in RESTING if law.name == "Polynomial 4-5-6-7")
    assert least(septic)[:2] == [0, 0]


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


@given(laws, st.floats(0.31, 3.0))
def test_the_saw_comes_back_and_its_stroke_is_what_it_covers(law, length):
    cut = Cut(SAW, length, 0.8, law)
    _, _, motion = samples(cut)
    assert cut.at(cut.cycle_time).position == pytest.approx(0.0, abs=1e-12)
    assert cut.reverses
    assert not cut.waits
    stroke = float(np.ptp(cycle_of(cut, train_of(cut, Load(1.0))).points().position))
    assert stroke == pytest.approx(float(np.ptp(motion.position)), abs=1e-3)
    assert stroke >= np.ptp(motion.position) - 1e-12


def test_on_an_event_is_what_follows_it():
    cut = Cut(DRUM, 1.4, 1.0, Cycloidal())
    begin, end = cut.wait
    jerk = cut.at([begin, (begin + end) / 2, end, cut.repositioning_time]).jerk
    assert list(jerk != 0.0) == [False, False, True, False]  # waits, waits, moves on, works
    assert cut.at([begin, end]).speed == pytest.approx([0.0, 0.0], abs=1e-12)


def test_a_peak_that_is_given_is_where_the_drum_waits():
    """A law of uniform velocity has its peak anywhere in between; the position at the end is the same."""
    early, late = (Cut(DRUM, 1.4, 1.0, TrapezoidalVelocity(0.3, 0.7), peak=peak) for peak in (None, 0.6))
    assert (early.fastest, late.fastest) == (0.3, 0.6)
    assert late.wait[0] == pytest.approx(2 * early.wait[0])
    assert late.at(late.cycle_time).position == pytest.approx(early.at(early.cycle_time).position)


@pytest.mark.parametrize("limits", [(50.0, 1e9), (1e9, 700.0)])
@pytest.mark.parametrize("length", [0.15, 0.4, 1.2])
def test_at_the_fastest_line_the_shaft_is_at_its_first_limit(limits, length):
    cut = Cut(DRUM, length, 1.1, ASYMMETRIC)
    there = Cut(DRUM, length, cut.fastest_line(*limits), ASYMMETRIC)
    reached = there.max_angular_speed / limits[0], there.max_angular_acceleration / limits[1]
    assert max(reached) == pytest.approx(1.0, rel=1e-12)


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


@given(laws, lengths, beyond, st.sampled_from([DRUM, SAW]))
def test_pieces_give_the_same_motion(law, length, way, tool):
    cut = Cut(tool, length + tool.tool_length, 1.2, law, way)
    time = np.linspace(0.0, cut.cycle_time, 1501)
    found = MotionPieces(cut_pieces(cut), cut.cycle_time).at(time)
    for order, (one, other) in enumerate(zip(found, cut.at(time), strict=True)):
        assert np.abs(one - other).max() <= 1e-11 * max(cut.size(order), np.abs(other).max())
