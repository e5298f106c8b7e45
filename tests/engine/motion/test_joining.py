"""Phases that hand over at speed: velocities taken over, entries, faults, kinds of end, and every jump left."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import Dwell, Piece, PieceLaw
from engine.laws.modified import ModifiedSine, ModifiedTrapezoidal, SineConstantCosine
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, SimpleHarmonic, StraightLine
from engine.laws.spline import Spline
from engine.motion import Phase
from engine.motion.joining import ORDERS, Fault, Rates, join_phases, shortfalls
from tests.engine.extremes import extremes_of

OWN = PieceLaw([Piece(1.0, (0.0, 60.0, -180.0, 120.0))])
POINTS = Spline(((0.0, 0.0), (0.3, 0.6), (0.7, 0.4), (1.0, 1.0)))
SMOOTH = (ModifiedSine(), ModifiedSine(0.3), SCurve(), ModifiedTrapezoidal(), SineRamps(), SineConstantCosine(),
          Cycloidal(0.4), Polynomial345(), Polynomial4567())  # fmt: skip
CURVED = (*SMOOTH, Cubic(), ConstantAcceleration(0.4), TrapezoidalVelocity(), SimpleHarmonic())


def line(lift, duration):
    return Phase(StraightLine(), lift, duration)


def dwell(duration):
    return Phase(Dwell(), 0.0, duration)


@pytest.mark.parametrize("law", SMOOTH, ids=lambda law: law.code)
def test_rise_to_line_speed_run_in_step_and_return(law):
    """Three phases and a dwell, without being told any velocity."""
    phases = [Phase(law, 30.0, 1.2), line(40.0, 0.7), Phase(law, -70.0, 3.1), dwell(1.3)]
    found = join_phases(phases)
    assert found.faults == ()
    assert found.kinds == (("R", "G"), ("G", "G"), ("G", "R"), ("R", "R"))
    assert shortfalls(found.motion, "acceleration") == ()
    speed = 40.0 / 0.7
    at = found.motion.at(np.array([1.2 - 1e-9, 1.5, 1.9 + 1e-9]))
    assert at.y1 == pytest.approx(speed, rel=1e-6)
    assert at.y[1] == pytest.approx(30 + 0.3 * speed)
    assert found.motion.at(6.3).y == pytest.approx(0.0, abs=1e-12)


def test_a_velocity_is_taken_over_across_the_end_of_the_cycle():
    phases = [line(10.0, 1.0), Phase(ModifiedSine(), 5.0, 1.0), line(4.0, 0.5), Phase(SCurve(), -19.0, 2.0)]
    found = join_phases(phases)
    assert (found.faults, shortfalls(found.motion, "acceleration")) == ((), ())
    last = found.motion.phases[3].law
    assert (last.start.v / 2.0, last.end.v / 2.0) == pytest.approx((8.0, 10.0))
    opened = join_phases(phases, periodic=False)
    assert opened.motion.phases[3].law.end.v == pytest.approx(0.0, abs=1e-12)
    assert opened.kinds[3] == ("G", "R")


rate = st.integers(-300, 300).map(lambda n: n / 100)
lift = st.integers(-50, 50).map(lambda n: n / 10)
duration = st.integers(2, 40).map(lambda n: n / 10)
phase = st.one_of(
    st.builds(Phase, st.sampled_from(CURVED), lift, duration),
    st.builds(line, lift, duration),
    st.builds(dwell, duration),
)


def phase_extremes(one):
    """The lowest and largest y', y'' and y''' of a phase, by the exact ones of its law."""
    both = enumerate(extremes_of(one.law.as_pieces(), one.law.start.v), 1)
    return [sorted(one.scale / one.duration**order * value for value in ends) for order, ends in both]


def jumps(motion, periodic=True):
    """The number of each phase but the first, of a periodic motion of that too, with its jumps of y and y'."""
    ends, n = motion.ends, len(motion.phases)
    both = [(k % n, ends[k - 1].end, ends[k % n].begin) for k in range(1, n + periodic)]
    return [(k, after.y - before.y, after.y1 - before.y1) for k, before, after in both]


def straight(one):
    return isinstance(one.law, StraightLine | Dwell)


@given(st.lists(phase, min_size=1, max_size=7), st.booleans(), st.data())
def test_random_phases_join_without_a_jump_that_was_not_asked_for(phases, periodic, data):
    """Velocity jumps exactly between two straight lines of different slope; position never."""
    n = len(phases)
    free = [k for k in range(n) if (k or periodic) and not (straight(phases[k - 1]) or straight(phases[k]))]
    through = {k: Rates(data.draw(rate)) for k in free if data.draw(st.booleans())}
    found = join_phases(phases, through, periodic)
    assert found.faults == ()
    motion = found.motion
    joints = jumps(motion, periodic)
    allowed = {
        k for k in range(n) if (k or periodic) and straight(phases[k - 1]) and straight(phases[k])
        and not math.isclose(phases[k - 1].lift / phases[k - 1].duration, phases[k].lift / phases[k].duration,
                             rel_tol=1e-9, abs_tol=1e-9)
    }  # fmt: skip
    size = 1 + max(max(map(abs, phase_extremes(one)[0])) for one in motion.phases)
    for k, y, v in joints:
        assert k == 0 or abs(y) <= 1e-11 * (1 + size * sum(one.duration for one in phases))
        assert k in allowed or abs(v) <= 1e-11 * size
    told = {one.phase for one in shortfalls(motion, "velocity", periodic)}
    assert told <= allowed
    assert all(abs(joints[k - 1][2]) <= 1e-9 * size for k in allowed - told)
    for k, rates in through.items():
        assert joints[k - 1][2] == pytest.approx(0.0, abs=1e-11 * size)
        begin = motion.phases[k]
        assert begin.scale * begin.law.start.v / begin.duration == pytest.approx(rates.v, abs=1e-11 * size)


@given(
    st.lists(st.tuples(st.sampled_from([Polynomial345(), Polynomial4567()]), lift, duration), min_size=2, max_size=5),
    st.data(),
)
def test_polynomials_through_entered_velocities_and_accelerations_are_smooth(drawn, data):
    through = {k: Rates(data.draw(rate), data.draw(rate)) for k in range(len(drawn))}
    found = join_phases([Phase(*one) for one in drawn], through)
    assert found.faults == ()
    assert shortfalls(found.motion, "acceleration") == ()
    assert found.kinds == tuple(
        (name(through[k]), name(through[(k + 1) % len(drawn)])) for k in range(len(drawn))
    )  # fmt: skip


def name(rates):
    return ("B" if rates.a else "G") if rates.v else ("U" if rates.a else "R")


def test_septics_join_with_an_entered_jerk():
    phases = [Phase(Polynomial4567(), 2.0, 1.0), Phase(Polynomial4567(), -2.0, 1.5)]
    through = {0: Rates(0.5, -1.0, 3.0), 1: Rates(0.0, -20.0, 8.0)}
    found = join_phases(phases, through)
    assert shortfalls(found.motion, "jerk") == ()
    assert found.kinds == (("B", "U"), ("U", "B"))
    without = join_phases([Phase(Polynomial345(), 2.0, 1.0), phases[1]], {0: Rates(0.5, -1.0), 1: Rates(0.0, -20.0)})
    assert shortfalls(without.motion, "acceleration") == ()
    assert {ORDERS[one.order - 1] for one in shortfalls(without.motion, "jerk")} == {"jerk"}


def test_two_straight_lines_of_different_slope_jump_and_say_so():
    found = join_phases([line(1.0, 2.0), line(3.0, 2.0), Phase(Cycloidal(), -4.0, 3.0)])
    (one,) = shortfalls(found.motion, "acceleration")
    assert (one.order, one.x, one.before, one.phase) == (1, 2.0, 0, 1)
    assert one.size == pytest.approx(1.0)
    assert found.faults == ()


@pytest.mark.parametrize("law", CURVED)
@pytest.mark.parametrize("bent", [0.0, 1e-13, 1e-6, -1e-6])
def test_a_curve_between_lines_of_its_own_slope_is_straight_but_for_rounding(law, bent):
    slope, (first, d, last) = 0.7193, (11.3, 17.9, 23.7)
    curve = Phase(law, slope * d * (1.0 + bent), d)
    found = join_phases([line(slope * first, first), curve, line(slope * last, last)], periodic=False).motion
    assert found.phases[1].y1_max == pytest.approx(slope, rel=1e-5)
    if abs(bent) < 1e-9:
        assert (found.phases[1].y2_max, found.phases[1].y3_max) == (0.0, 0.0)
        assert shortfalls(found, "jerk", periodic=False) == ()
    else:
        assert found.phases[1].y2_max > slope * 1e-7 / d
    assert max(abs(y) for _, y, _ in jumps(found)[:-1]) < 1e-11


@pytest.mark.parametrize(
    ("law", "reason"),
    [
        (OWN, "Own law cannot end with a prescribed velocity"),
        (DoubleHarmonic(), "Double harmonic cannot end with a prescribed velocity"),
        (Polynomial345(0.3), "Polynomial 3-4-5 with the share 0.3 is made of two halves"),
    ],
)
def test_a_law_that_cannot_have_its_end_is_named_with_the_reason_and_rests(law, reason):
    found = join_phases([dwell(1.0), Phase(law, 2.0, 1.0), line(3.0, 1.0), Phase(ModifiedSine(), -5.0, 2.0)])
    (fault,) = found.faults
    assert fault.phase == 1
    assert fault.reason.startswith(reason)
    assert found.motion.phases[1].law == law
    (jump,) = shortfalls(found.motion, "velocity")
    assert (jump.before, jump.phase, jump.size) == (1, 2, pytest.approx(3.0))


def test_an_entered_acceleration_needs_a_law_that_takes_it():
    phases = [Phase(ModifiedSine(), 1.0, 1.0), Phase(Polynomial345(), -1.0, 1.0)]
    found = join_phases(phases, {1: Rates(0.0, -5.0)})
    assert found.faults == (
        Fault(0, "Modified sine cannot end with a prescribed acceleration: it takes velocity there; "
                 "a polynomial of degree 5 takes an acceleration, of degree 7 a jerk too"),
    )  # fmt: skip


def test_an_entry_beside_a_straight_line_may_only_repeat_it():
    phases = [line(2.0, 1.0), Phase(ModifiedSine(), -2.0, 1.0)]
    assert join_phases(phases, {1: Rates(2.0)}).faults == ()
    faults = join_phases(phases, {1: Rates(1.0, 3.0)}).faults
    assert faults == (Fault(0, "a straight line has y' = 2 and no acceleration; 1, 3, 0 are entered"),)


def test_what_two_curved_laws_have_of_themselves_is_a_reversal():
    """s = sin⁴ up and down: a = −π² on both sides."""
    found = join_phases([Phase(DoubleHarmonic(), 1.0, 1.0), Phase(DoubleHarmonic("start"), -1.0, 1.0)])
    assert found.kinds == (("R", "U"), ("U", "R"))
    assert shortfalls(found.motion, "acceleration") == ()
    assert found.motion.at(1.0).y2 == pytest.approx(-(math.pi**2))


def test_a_constant_acceleration_falls_short_of_acceleration_at_its_ends_and_within():
    found = join_phases(
        [dwell(1.0), Phase(ConstantAcceleration(), 2.0, 2.0), dwell(1.0), Phase(Cycloidal(), -2.0, 2.0)]
    )
    told = shortfalls(found.motion, "acceleration")
    assert [(one.order, one.x, one.before, one.phase) for one in told] == [
        (2, 1.0, 0, 1), (2, 2.0, 1, 1), (2, 3.0, 1, 2),
    ]  # fmt: skip
    assert [one.size for one in told] == pytest.approx([2.0, -4.0, 2.0])
    assert shortfalls(found.motion, "velocity") == ()


def test_jerk_is_asked_for_within_laws_and_across_the_cycle():
    found = join_phases([Phase(Polynomial4567(), 1.0, 1.0), Phase(ModifiedSine(), -1.0, 1.0)])
    assert [(one.before, one.phase, round(one.x, 3)) for one in shortfalls(found.motion, "jerk")] == [
        (1, 0, 0.0), (0, 1, 1.0)]  # fmt: skip
    assert shortfalls(join_phases([Phase(Polynomial4567(), 1.0, 1.0), dwell(1.0)]).motion, "jerk", periodic=False) == ()


def test_a_spline_takes_the_velocity_of_a_line_unless_its_slope_is_entered():
    def found(slopes):
        return join_phases(
            [Phase(Spline(POINTS.points, slopes), 10.0, 2.0), line(6.0, 1.0), Phase(SCurve(), -16.0, 2.0)]
        )

    assert shortfalls(found((None, None)).motion, "velocity") == ()
    (jump,) = shortfalls(found((None, 1.0)).motion, "velocity")
    assert jump.size == pytest.approx(6.0 - 5.0)
    (jump,) = shortfalls(found((1.0, None)).motion, "velocity")  # at its begin alone
    assert jump.size == pytest.approx(5.0)
