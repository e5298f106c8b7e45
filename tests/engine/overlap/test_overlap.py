"""Overlap with laws of any shape: the margin is kept exactly, the cycle closes, what cannot be is refused."""

from math import inf, pi, radians

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from engine.laws import CATALOGUE
from engine.laws.inverse import HEIGHT, inverse, inverse_by_points
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.polynomials import Cubic
from engine.laws.ramps import TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal
from engine.motion.joining import shortfalls
from engine.motion.pieces import MotionPieces
from engine.overlap.plan import Station, colliding
from engine.overlap.schedule import Passage, Schedule, Tool, Transfer, movement_time, pieces_of_parts

TURN = np.linspace(0.0, 2 * pi, 1441)
ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
laws = st.sampled_from([e() for e in CATALOGUE if e.code != "DWL"] + [ASYMMETRIC, TrapezoidalVelocity(0.2, 0.5)])


def in_the_way(station):
    return (station.left.begin < TURN) & (station.left.end > TURN)


@given(laws, laws, laws, st.floats(0, 0.3), st.floats(0.002, 0.02), st.floats(0, 1), st.floats(0.2, 0.8))
def test_the_margin_is_kept_exactly_with_any_laws(law, law_in, law_out, remaining, gap, share, split):
    transfer, tool = Transfer(law, 0.1, radians(200)), Tool(law_in, 0.05, radians(60), law_out)
    passage = Passage(remaining, clearance=gap, margin=share * gap, split=split)
    station = Station(transfer, tool, passage)
    schedule = station.overlapping()
    found = station.clearance(schedule, TURN)
    assert found.meets_margin
    assert not found.collides
    assert found.free[in_the_way(station)].min() >= found.minimum - 1e-12
    if schedule.limit == "clearance":
        assert found.minimum == pytest.approx(passage.margin, abs=1e-12)


@given(laws, st.floats(0.01, 0.2))
def test_the_transfer_misses_the_remaining_share_where_it_ceases_to_block(law, remaining):
    transfer = Transfer(law, 0.1, 2.0)
    begin, end, *_ = Station(transfer, mill_and_die()[1], Passage(remaining, 0.01)).left
    assert law.s(begin / 2.0) == pytest.approx(remaining, abs=1e-12)
    assert law.s(end / 2.0) == pytest.approx(1.0 - remaining, abs=1e-12)


def test_the_way_out_is_that_of_an_asymmetric_law_in_reverse():
    slow_start = TrapezoidalVelocity(0.7, 0.7)
    transfer, tool = Transfer(Cycloidal(), 0.1, radians(200)), Tool(Cycloidal(), 0.05, radians(60), slow_start)
    station = Station(transfer, tool, Passage(0.01, 0.01))
    schedule, (begin, end, *_) = station.overlapping(), station.left
    free = 2 * pi - (end - begin) - radians(60)
    share = 1 - (0.2 * 0.3) ** 0.5  # of the time, to be out by 4/5 of the stroke
    assert schedule.limit == "clearance"
    assert schedule.angle_out == pytest.approx(free / 2 / share, rel=1e-12)


def mill_and_die():
    return Transfer(Cycloidal(), 0.1, radians(150)), Tool(Cycloidal(), 0.05, radians(100), Cubic())


def station():
    return Station(*mill_and_die(), Passage(0.01, 0.02, 0.001))


def test_the_travel_begins_and_ends_where_the_edges_say():
    schedule = station().overlapping()
    away, there, leaves, back = schedule.edges
    tool = schedule.travel(np.array([away, there, leaves, back]))
    assert tool == pytest.approx([0.0, 0.05, 0.05, 0.0], abs=1e-12)
    assert leaves - there == pytest.approx(radians(100), rel=1e-12)


def test_the_tool_s_motion_closes_and_is_counted_from_its_arrival():
    schedule = station().overlapping()
    assert schedule.motion.closes
    assert shortfalls(schedule.motion, "velocity") == ()
    assert schedule.motion.at(TURN).y == pytest.approx(schedule.travel(TURN + schedule.arrival), abs=1e-12)


def test_the_transfer_stays_where_it_has_come_to_until_the_next_cycle():
    transfer = mill_and_die()[0]
    assert transfer.travel(np.array([0.0, transfer.angle / 2, transfer.angle, 2 * pi])) == pytest.approx(
        [0.0, 0.05, 0.1, 0.1]
    )


@given(laws, laws, st.floats(0.2, 0.8))
def test_pieces_give_the_same_motion(law_in, law_out, split):
    """A second way to the travel: by its pieces, as a sheet goes."""
    transfer, _ = mill_and_die()
    tool = Tool(law_in, 0.05, radians(100), law_out)
    schedule = Station(transfer, tool, Passage(0.01, 0.02, 0.001, split=split)).overlapping()
    found = MotionPieces(pieces_of_parts(schedule.parts), 2 * pi).at(schedule.since(TURN))
    assert found.y == pytest.approx(schedule.travel(TURN), abs=1e-12)
    for order, values in enumerate(schedule.rates(TURN, 1.0), 1):
        assert found[order] * (2 * pi) ** order == pytest.approx(values, abs=1e-11 * np.abs(values).max())
    rests = schedule.parts[2].duration > 0.0
    assert {piece.phase for piece in pieces_of_parts(schedule.parts)} == ({0, 1, 2, 3} if rests else {0, 1, 3})


def test_just_below_a_whole_turn_counts_as_on_it():
    schedule = station().one_after_the_other()
    found = schedule.since(np.array([schedule.arrival - 1e-9, schedule.arrival, schedule.arrival - 1e-7]))
    assert found == pytest.approx([-1e-9, 0.0, 2 * pi - 1e-7], abs=1e-12)
    place = MotionPieces(pieces_of_parts(schedule.parts), 2 * pi).located(found)
    assert [pieces_of_parts(schedule.parts)[k].phase for k in place.piece] == [0, 0, 3]


def test_room_and_rests_lead_to_the_ways():
    """S2's steps: free angle, split, over the share that is left when the transfer comes."""
    transfer, tool = mill_and_die()
    passage = Passage(0.0065, 0.02, 0.001, split=0.4)
    station = Station(transfer, tool, passage)
    left, (rest_in, rest_out) = station.left, station.remaining_shares(np.array([passage.margin]))
    found = station.overlapping()
    assert left.end - left.begin + left.free_in + left.free_out + tool.dwell == pytest.approx(2 * pi, rel=1e-14)
    assert left.both == pytest.approx(radians(260), rel=1e-14)
    assert (found.angle_in, found.angle_out) == pytest.approx(
        (left.free_in / rest_in[0], left.free_out / rest_out[0]), rel=1e-14
    )
    gone = tool.law.s(1 - rest_in[0]), tool.out.s(1 - rest_out[0])
    assert gone == pytest.approx((0.38, 0.38), rel=1e-12)


@given(laws, laws, laws, st.floats(0.0, 0.2), st.floats(-0.5, 0.5))
def test_the_least_clearance_stands_at_a_corner(law, law_in, law_out, remaining, shift):
    transfer, tool = Transfer(law, 0.1, radians(200)), Tool(law_in, 0.05, radians(60), law_out)
    passage = Passage(remaining, 0.01, 0.001)
    station = Station(transfer, tool, passage)
    plan = station.overlapping()
    moved = Schedule(tool, plan.angle_in, plan.angle_out, plan.arrival + shift)
    found, at = station.clearance(moved, TURN), station.critical_angles(moved)
    assert found.minimum == at.free.min()
    assert found.free[in_the_way(station)].min() >= found.minimum - 1e-12
    assert ((at.angle >= 0) & (at.angle < 2 * pi)).all()
    assert np.cos(at.raw) == pytest.approx(np.cos(at.angle), abs=1e-12)
    assert (at.free[~at.inside] == passage.clearance).all()


def test_a_tool_that_is_never_in_the_way_is_limited_by_the_cycle():
    transfer, tool = mill_and_die()
    schedule = Station(transfer, tool, Passage(0.01, clearance=0.06)).overlapping()
    assert schedule.limit == "cycle"
    assert schedule.angle_in + schedule.angle_out + tool.dwell == pytest.approx(2 * pi, rel=1e-12)
    assert schedule.motion.closes


def test_a_tool_that_sets_off_too_early_collides():
    _, tool = mill_and_die()
    good = station().overlapping()
    early = Schedule(tool, good.angle_in, good.angle_out, good.arrival - radians(20))
    found = station().clearance(early, TURN)
    assert found.collides
    assert not found.meets_margin
    assert found.minimum == pytest.approx(found.free.min(), abs=2e-4)
    assert colliding(found.free, np.array(0.05)).any()


def test_where_the_transfer_is_in_place_the_tool_may_go_to_the_part():
    plan = station().overlapping()
    found = station().clearance(plan, TURN)
    assert (found.allowed == np.where(in_the_way(station()), 0.02, 0.05)).all()
    assert found.allowed - found.free == pytest.approx(plan.travel(TURN), abs=1e-15)
    assert not colliding(found.free, np.array(0.05)).any()


def test_the_sweep_is_the_schedule_of_each_margin():
    transfer, tool = mill_and_die()
    margins = np.linspace(0.0, 0.02, 9)
    sweep = Station(transfer, tool, Passage(0.01, 0.02)).sweep(margins, 0.5)
    single = [Station(transfer, tool, Passage(0.01, 0.02, m)).overlapping() for m in margins]
    before = station().one_after_the_other().peak_acceleration(0.5)
    assert sweep.angle_in == pytest.approx([s.angle_in for s in single], rel=1e-13)
    assert sweep.angle_out == pytest.approx([s.angle_out for s in single], rel=1e-13)
    assert sweep.acceleration == pytest.approx([s.peak_acceleration(0.5) for s in single], rel=1e-12)
    assert sweep.ratio == pytest.approx([before / s.peak_acceleration(0.5) for s in single], rel=1e-12)
    assert np.diff(sweep.ratio).max() < 0.0


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Passage(0.6, 0.02), "remaining is 0.6"),
        (lambda: Passage(0.1, 0.02, 0.03), "margin is 0.03 m; expected 0 to the clearance, 0.02 m"),
        (lambda: Passage(0.1, inf), "clearance is inf"),
        (lambda: Passage(0.1, 0.02, split=1.0), "split is 1"),
        (lambda: Passage(0.1, 0.02, allowance=-0.1), "allowance is -5.7"),
        (lambda: Transfer(Cycloidal(), 0.0, 1.0), "transfer: stroke is 0"),
        (lambda: Transfer(Cycloidal(), 0.1, 7.0), "401.07 degrees; expected less than 360"),
        (lambda: Tool(Cycloidal(), 0.1, -1.0), "dwells for -57.2"),
        (lambda: movement_time(1.0, 0.0), "rate is 0"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_no_angle_left_is_said_in_degrees():
    transfer = Transfer(ConstantAcceleration(), 0.1, radians(270))
    with pytest.raises(ValueError, match=r"transfer \(270 degrees\) and dwell \(100 degrees\)"):
        Station(transfer, mill_and_die()[1], Passage(0.01, 0.02)).one_after_the_other()


def test_an_allowance_that_takes_all_is_refused():
    with pytest.raises(ValueError, match="an allowance of 170 degrees"):
        Station(*mill_and_die(), Passage(0.01, 0.02, allowance=radians(170))).overlapping()


@given(st.floats(0, 0.02), st.floats(0, 0.02))
def test_a_larger_margin_never_gains(one, other):
    assume(one < other)
    sweep = Station(*mill_and_die(), Passage(0.01, 0.02)).sweep([one, other], 0.5)
    assert sweep.acceleration[0] <= sweep.acceleration[1] * (1 + 1e-12)


@given(laws, st.lists(st.floats(0, 1), min_size=1, max_size=20))
def test_points_of_a_law_give_its_inverse_within_what_is_stated(law, heights):
    wanted = np.array(heights)
    found, exact = inverse_by_points(law, wanted), inverse(law, wanted)
    assert np.abs(law.s(found) - wanted).max() <= HEIGHT
    away = np.minimum(wanted, 1.0 - wanted) > 1e-5
    assert (np.abs(found - exact) <= np.where(away, 1e-4, 1e-2)).all()


@given(laws, laws, st.floats(0, 0.3), st.floats(0.002, 0.02), st.floats(0, 1))
def test_schedules_by_points_keep_the_margin_within_what_is_stated(law, law_in, remaining, gap, share):
    passage = Passage(remaining, clearance=gap, margin=share * gap)
    by_points, exact = (
        Station(Transfer(law, 0.1, radians(200), how), Tool(law_in, 0.05, radians(60), None, how), passage)
        for how in (inverse_by_points, inverse)
    )
    plan, exactly = by_points.overlapping(), exact.overlapping()
    found = by_points.clearance(plan, 0.0)
    assert found.meets_margin
    assert found.minimum == pytest.approx(exact.clearance(exactly, 0.0).minimum, abs=2 * HEIGHT * 0.05)
    assert plan.angle_in == pytest.approx(exactly.angle_in, rel=0.01)
