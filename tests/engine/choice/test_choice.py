"""Choice of motor and reducer: whole catalogues against one pair at a time, efficiency, ranking, step 7's checks."""

import itertools
import math
from dataclasses import astuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.choice import LoadSamples, Motors, Pair, Pairs, Reducers, Task, rank, usable
from engine.choice.curve import TorqueCurve
from engine.choice.pair import reverses, square_steps
from engine.choice.pairs import counted_in, load_at_motor, sorting_keys
from engine.choice.ratios import accelerating_factor, best_ratio, ratio_curves, ratio_ranges, rms_torque
from engine.drivetrain import KINDS, Drive, Load, Stage, direction
from engine.laws import Cycloidal, Dwell, Piece, PieceLaw
from engine.motion import Motion, Phase
from tests.engine.choice.tasks import sampled_task

TASK = Task(acceleration_rms=300.0, torque_rms=9.0, power_rate_mean=1100.0, max_speed=30.0)
AT_REST = Task(acceleration_rms=0.0, torque_rms=9.0, power_rate_mean=0.0, max_speed=30.0)
UNFINISHED = PieceLaw([Piece(1.0, (1.0, 0.0, 0.0, 0.0))])


def motors(n=40, seed=3):
    rng = np.random.default_rng(seed)
    rated = np.geomspace(0.3, 40.0, n)
    inertia = 6e-5 * rated**1.6 * rng.lognormal(0, 0.4, n)
    names = tuple(f"M{k}" for k in range(n))
    return Motors(names, inertia, rated, 3 * rated, rng.uniform(200, 600, n), rng.uniform(1, 9, n), rated * 100)


def reducers(n=30, efficiency=None, inertia=None, seed=4):
    rng = np.random.default_rng(seed)
    eta = rng.uniform(0.8, 0.98, n) if efficiency is None else efficiency
    own = rng.lognormal(-9, 1, n) if inertia is None else inertia
    names = tuple(f"R{k}" for k in range(n))
    fast = rng.uniform(300, 700, n)
    return Reducers(names, np.geomspace(1, 80, n), eta, own, fast, np.inf, rng.uniform(1, 9, n), np.full(n, 50.0))


def one_by_one(task, m, r):
    """The definition, without arrays."""
    found = []
    for i, k in itertools.product(range(len(m.names)), range(len(r.names))):
        inertia = m.inertia[i] + r.inertia[k]
        load, own = r.ratio[k] * task.torque_rms / r.efficiency[k], inertia * task.acceleration_rms / r.ratio[k]
        rms = math.sqrt(load**2 + own**2 + 2 * inertia * task.power_rate_mean / r.efficiency[k])
        fast = task.max_speed / r.ratio[k]
        if rms <= m.rated_torque[i] and fast <= m.max_speed[i] and fast <= r.max_input_speed[k]:
            found.append((i, k, rms))
    return found


def test_usable_pairs_are_those_judged_one_by_one():
    m, r = motors(), reducers()
    motor, reducer, square = usable(TASK, m, r)
    expected = one_by_one(TASK, m, r)
    assert 50 < len(expected) < 1100
    assert list(zip(motor, reducer, strict=True)) == [(i, k) for i, k, _ in expected]
    assert np.sqrt(square) == pytest.approx([rms for *_, rms in expected], rel=1e-12)


def test_catalogues_of_many_blocks_are_judged_like_one(monkeypatch):
    m, r = motors(), reducers()
    whole = usable(TASK, m, r)
    monkeypatch.setattr("engine.choice.pairs.BLOCK", 64)
    for one, other in zip(usable(TASK, m, r), whole, strict=True):
        assert (one == other).all()


def test_without_losses_the_pairs_are_those_in_the_ranges_of_14():
    m, r = motors(), reducers(efficiency=1.0, inertia=0.0)
    ranges = ratio_ranges(TASK, m.rated_torque, m.inertia, m.max_speed)
    inside = (r.ratio >= ranges.lowest[:, None]) & (r.ratio <= ranges.tau_max[:, None])
    inside &= TASK.max_speed / r.ratio <= r.max_input_speed
    motor, reducer, _ = usable(TASK, m, r)
    assert list(zip(motor, reducer, strict=True)) == list(zip(*np.nonzero(inside), strict=True))


def test_with_one_efficiency_too():
    m, r = motors(), reducers(efficiency=0.7, inertia=0.0)
    ranges = ratio_ranges(TASK, m.rated_torque, m.inertia, m.max_speed, efficiency=0.7)
    inside = (r.ratio >= ranges.lowest[:, None]) & (r.ratio <= ranges.tau_max[:, None])
    inside &= TASK.max_speed / r.ratio <= r.max_input_speed
    motor, _, _ = usable(TASK, m, r)
    assert motor.size == inside.sum() > 0


@given(st.floats(1, 1e3), st.floats(0.1, 1e2), st.floats(-1, 1), st.floats(0.3, 1), st.floats(1e-5, 1e-1))
def test_rms_torque_has_its_minimum_at_tau_opt(acceleration, torque, correlation, efficiency, inertia):
    task = Task(acceleration, torque, correlation * acceleration * torque, 1.0)
    best = ratio_ranges(task, 1e6, inertia, 1e6, efficiency).tau_opt
    least = rms_torque(task, inertia, best, efficiency)
    around = rms_torque(task, inertia, best * np.array([0.9, 1.1]), efficiency)
    assert (around >= least).all()
    needed = task.required_accelerating_factor(efficiency)
    assert least**2 / inertia == pytest.approx(needed, rel=1e-6, abs=1e-9 * acceleration * torque / efficiency)


def test_a_motor_below_beta_is_rejected_whatever_the_ratio():
    weak = 0.99 * math.sqrt(TASK.load_factor * 1e-3)
    found = ratio_ranges(TASK, [weak], 1e-3, 1e4)
    assert found.accelerating_factor[0] < TASK.load_factor
    assert np.isnan(found.tau_min[0])
    assert not found.accepted[0]
    assert rms_torque(TASK, 1e-3, np.geomspace(1e-3, 10, 999)).min() > weak


def test_a_motor_that_is_too_slow_is_not_accepted():
    torque, inertia = 12.0, 3e-3
    found = ratio_ranges(TASK, torque, inertia, [1e4, 15.0])
    assert found.accepted.tolist() == [True, False]
    assert found.tau_max[1] < found.lowest[1] == 2.0


@pytest.mark.parametrize("criterion", ["margin", "inertia match", "size", "cost"])
def test_ranking_is_by_the_criterion_and_the_best_are_its_first(criterion):
    m, r = motors(), reducers()
    every = rank(TASK, m, r, criterion)
    few = rank(TASK, m, r, criterion, best=17)
    assert len(few) == 17
    assert (np.diff(every.score) >= 0).all()
    assert (every.motor[:17] == few.motor).all()
    assert (every.reducer[:17] == few.reducer).all()
    expected = {
        "margin": lambda p: -p.margin,
        "inertia match": lambda p: p.mismatch,
        "size": lambda p: m.size[p.motor] + r.size[p.reducer],
        "cost": lambda p: m.cost[p.motor] + r.cost[p.reducer],
    }[criterion](every)
    assert (np.diff(expected) >= -1e-12).all()


@pytest.mark.parametrize("best", [None, 300])
def test_equals_keep_the_order_of_the_catalogues(best):
    n = 200
    size = np.arange(n) % 7 + 1.0
    m = Motors(tuple(f"M{k}" for k in range(n)), 1e-3, 50.0, 99.0, 1e4, size)
    r = Reducers(("x", "y"), np.array([10.0, 10.0]), 0.9, 0.0, np.inf, np.inf, 1.0)
    pairs = rank(TASK, m, r, "size", best=best)
    expected = sorted(itertools.product(range(n), range(2)), key=lambda pair: size[pair[0]])[:best]
    assert list(zip(pairs.motor, pairs.reducer, strict=True)) == expected


def test_mismatch_is_one_at_the_best_ratio_with_losses_and_the_reducer_s_inertia():
    inertia, own, eta = 1e-3, 4e-4, 0.8
    tau = math.sqrt((inertia + own) * TASK.acceleration_rms * eta / TASK.torque_rms)
    m = Motors(("M",), inertia, 100.0, 300.0, 1e4)
    r = Reducers(("one", "double", "half"), 1 / np.array([tau, 2 * tau, tau / 2]), eta, own, np.inf, np.inf)
    pairs = rank(TASK, m, r, "inertia match")
    assert pairs.mismatch == pytest.approx([1.0, 2.0, 2.0], rel=1e-12)
    assert pairs.reducer[0] == 0


@pytest.mark.parametrize("criterion", ["size", "cost"])
def test_a_product_without_the_figure_is_usable_and_not_ranked(criterion):
    m, r = motors(), reducers()
    getattr(m, criterion).flags.writeable = True
    getattr(m, criterion)[::3] = np.nan
    every = rank(TASK, m, r, criterion)
    with_figures = [(i, k) for i, k, _ in one_by_one(TASK, m, r) if i % 3]
    assert 0 < len(every) == len(with_figures) < len(rank(TASK, m, r))
    assert set(zip(every.motor, every.reducer, strict=True)) == set(with_figures)


def test_a_reducer_that_does_not_hold_the_torque_is_in_no_pair():
    m, r = motors(), reducers()
    limits = np.linspace(10.0, 100.0, 30)
    limited = Reducers(r.names, r.reduction, r.efficiency, r.inertia, r.max_input_speed, limits)
    motor, reducer, square = usable(TASK, m, limited, output_torque=50.0)
    expected = [(i, k) for i, k, _ in one_by_one(TASK, m, r) if limits[k] >= 50.0]
    assert list(zip(motor, reducer, strict=True)) == expected
    ranked = rank(TASK, m, limited, output_torque=50.0)
    assert len(ranked) == len(square) > 0


def test_terms_at_the_motor_make_its_rms_torque_and_its_balance():
    r = reducers()
    load = load_at_motor(TASK, r)
    inertia = 2e-3 + r.inertia
    square = load.torque_rms**2 + (inertia * load.acceleration_rms) ** 2 + inertia * load.product
    assert np.sqrt(square) == pytest.approx(rms_torque(TASK, 2e-3, r.ratio, r.efficiency, r.inertia), rel=1e-12)
    assert best_ratio(TASK, load.balancing, r.efficiency) == pytest.approx(r.ratio, rel=1e-12)
    assert load.speed == pytest.approx(TASK.max_speed * r.reduction, rel=1e-14)


def test_a_reducer_fits_that_holds_torque_and_speed():
    r = Reducers(("a", "b", "c"), 10.0, 0.9, 0.0, np.array([300.0, 299.0, 300.0]), np.array([50.0, 50.0, 49.0]))
    load = load_at_motor(TASK, r, output_torque=50.0)
    assert load.strong.tolist() == [True, True, False]
    assert load.fits.tolist() == [True, False, False]


def test_the_score_of_the_margin_is_its_inverse():
    pairs = rank(TASK, motors(), reducers())
    assert pairs.score * pairs.margin == pytest.approx(1.0, rel=1e-14)


def scored(*scores):
    n = len(scores)
    nothing, places = np.zeros(n), np.arange(n)
    return Pairs(places, places, nothing, nothing, nothing, np.array(scores))


def test_keys_take_scores_for_equal_that_an_engineer_would_and_keep_their_order():
    pairs = scored(1.2000004, 1.2, 1.2000006, 1.1999996, 0.5)
    keys = sorting_keys(pairs, "margin", [1, 2, 3, 4, 5], parts=10**6, rows=10)
    assert np.argsort(keys).tolist() == [4, 0, 1, 3, 2]
    assert keys.tolist() == [12_000_001, 12_000_002, 12_000_013, 12_000_004, 5_000_005]


def test_halves_are_rounded_up_as_in_cells():
    keys = sorting_keys(scored(0.125, 0.375), "margin", [0, 0], parts=100, rows=1)
    assert keys.tolist() == [13, 38]


def test_sizes_and_costs_are_counted_in_the_largest_of_them():
    pairs = scored(20.0, 50.0, 5.0)
    assert [counted_in(pairs, c) for c in ("margin", "inertia match", "size", "cost")] == [1.0, 1.0, 50.0, 50.0]
    assert counted_in(scored(0.0, 0.0), "size") == counted_in(scored(), "cost") == 1.0
    assert sorting_keys(pairs, "cost", [0, 0, 0], parts=10, rows=1).tolist() == [4, 10, 1]


def test_for_a_load_at_rest_nothing_is_found():
    m, r = motors(), reducers()
    found = ratio_ranges(AT_REST, m.rated_torque, m.inertia, m.max_speed)
    assert not AT_REST.moves
    assert AT_REST.load_factor == 0.0
    assert not found.accepted.any()
    assert not found.strong.any()
    assert np.isnan([found.tau_min, found.tau_max, found.tau_opt, found.tau_limit, found.lowest]).all()
    assert found.accelerating_factor == pytest.approx(accelerating_factor(m.rated_torque, m.inertia))
    assert len(rank(AT_REST, m, r)) == 0
    assert np.isnan(pair().balance(AT_REST))
    assert np.isnan(load_at_motor(AT_REST, r).balancing).all()
    curves = ratio_curves(AT_REST, 5.0, 1e-3, 1.0, 9, (0.01, 0.1))
    assert np.isnan([curves.tau_min, curves.tau_opt, curves.tau_max]).all()
    assert (curves.pace == 0.0).all()


@pytest.mark.parametrize("efficiency", [1.0, 0.8])
def test_curves_against_the_load_factor_are_the_ranges_at_each_pace(efficiency):
    rated, inertia = 12.0, 3e-3
    alpha = float(accelerating_factor(rated, inertia))
    curves = ratio_curves(TASK, rated, inertia, efficiency, 20, (0.001, 0.1))
    assert curves.share[[0, -1]] == pytest.approx([min(0.1, TASK.load_factor / efficiency / alpha), 1.0])
    assert (np.diff(curves.share) > 0.0).all()
    for k in range(19):
        p = curves.pace[k]
        task = Task(300.0 * p, 9.0 * p, 1100.0 * p**2, 30.0)
        found = ratio_ranges(task, rated, inertia, 1e4, efficiency)
        assert task.load_factor == pytest.approx(curves.load_factor[k], rel=1e-12)
        assert (curves.tau_min[k], curves.tau_max[k]) == pytest.approx((found.tau_min, found.tau_max), rel=1e-9)
        assert (curves.root[k], curves.wide[k]) == pytest.approx((found.root, found.wide), rel=1e-9)
    assert curves.tau_min[-1] == pytest.approx(curves.tau_max[-1], rel=1e-12)
    assert curves.tau_opt == pytest.approx(np.sqrt(curves.tau_min * curves.tau_max), rel=1e-12)


@pytest.mark.parametrize(("rated", "first"), [(0.1, 0.1), (1e4, 0.001)])
def test_curves_begin_within_the_shares_given(rated, first):
    assert ratio_curves(TASK, rated, 1e-3, 1.0, 9, (0.001, 0.1)).share[0] == pytest.approx(first)


def test_the_mean_that_rounding_put_past_what_can_be_is_brought_back():
    assert Task.of_figures(3.0, 5.0, 15.001, 1.0).power_rate_mean == 15.0
    assert Task.of_figures(3.0, 5.0, -15.001, 1.0).power_rate_mean == -15.0
    assert Task.of_figures(3.0, 5.0, -4.0, 1.0) == Task(3.0, 5.0, -4.0, 1.0)


def test_sizes_of_a_load_that_turns_evenly_come_from_its_speed():
    assert Task(1e-13, 2.0, 0.0, 30.0).sizes(cycle_time=0.5) == Task(60.0, 2.0, 120.0, 30.0)
    assert TASK.sizes(cycle_time=0.5).acceleration_rms == 300.0


def test_no_pair_and_no_catalogue_are_empty_not_errors():
    weak = Motors(("M",), 1e-3, 1e-3, 1e-3, 1.0)
    assert len(rank(TASK, weak, reducers())) == 0
    none = Reducers((), np.empty(0), np.empty(0), np.empty(0), np.empty(0), np.empty(0))
    assert isinstance(rank(TASK, motors(), none), Pairs)


def load_samples(n=4001):
    motion = Motion([Phase(Cycloidal(), 2.0, 0.3), Phase(Cycloidal(), -2.0, 0.4)])
    time = np.linspace(0.0, 0.7, n)
    _, w, dw, _ = motion.at(time)
    return LoadSamples(time, w, dw, 4.0 + 0.05 * dw)


def task_of(load):
    return sampled_task(load.time, load.speed, load.acceleration, load.torque)


def pair(motor=(1e-3, 9.0, 30.0, 600.0), reducer=(10.0, 1.0, 2e-4, 600.0, 80.0), **more):
    return Pair(Motors(("M",), *motor, **more), Reducers(("R",), *reducer), 0, 0)


@pytest.mark.parametrize("resists", ["always", "moving"])
def test_task_of_a_load_is_that_of_its_samples(resists):
    load = Load(0.05, 4.0) if resists == "always" else Load(0.05, friction=4.0)
    phases = [Phase(Cycloidal(), 0.2, 0.3), Phase(Dwell(), 0.0, 0.2), Phase(Cycloidal(), -0.2, 0.4)]
    time = np.linspace(0.0, 0.9, 90001)
    _, y1, y2, _ = Motion(phases).at(time)
    w, dw = y1 / 0.1, y2 / 0.1
    sampled = sampled_task(time, w, dw, load.resisting(direction(w)) + 0.05 * dw)
    exact = Task.of_load(load, phases, radius=0.1)
    assert astuple(exact) == pytest.approx(astuple(sampled), rel=1e-4)


def test_rms_of_the_task_is_that_of_the_motor_over_the_cycle():
    load = load_samples()
    assert pair().points(load).rms_torque == pytest.approx(float(rms_torque(task_of(load), 1.2e-3, 0.1)))


def test_operating_points_are_those_of_the_drive_with_losses_both_ways():
    load = load_samples()
    found = pair(reducer=(10.0, 0.7, 2e-4, 600.0, 80.0)).points(load)
    drive = Drive(KINDS["gear train"].of(Load(0.05, 4.0), gears=[Stage("reducer", 10.0, 0.7)]), 1.2e-3)
    assert found.torque == pytest.approx(drive.torque(load.acceleration, direction(load.speed)), rel=1e-12)
    assert found.power == pytest.approx(found.torque * found.speed)


def test_steps_of_the_square_add_up_to_the_rms_torque():
    load = load_samples(400)
    points = pair().points(load)
    steps = square_steps(load.time, points.torque)
    assert (steps.size, steps[0]) == (400, 0.0)
    assert math.sqrt(steps.sum() / load.cycle_time) == pytest.approx(points.rms_torque, rel=1e-12)


def test_margin_is_the_rated_torque_over_the_rms_torque():
    points = pair().points(load_samples())
    assert pair().margin(points) * points.rms_torque == pytest.approx(9.0, rel=1e-14)
    nothing = np.zeros(3)
    still = LoadSamples(np.arange(3.0), nothing, nothing, nothing)
    assert pair().margin(pair().points(still)) == 0.0


@pytest.mark.parametrize("factor", [0.5, 1.0, 2.0])
def test_balance_is_the_ratio_over_that_of_the_least_rms_torque(factor):
    best = pair(reducer=(1.0, 0.8, 2e-4, 600.0, 80.0))
    around = np.geomspace(0.001, 1.0, 20001)
    least = around[rms_torque(TASK, 1e-3, around, 0.8, 2e-4).argmin()]
    assert best.balance(TASK) == pytest.approx(1.0 / least, rel=1e-3)
    exact = float(best_ratio(TASK, 1.2e-3, 0.8))
    there = pair(reducer=(1 / (factor * exact), 0.8, 2e-4, 600.0, 80.0))
    assert there.balance(TASK) == pytest.approx(factor, rel=1e-12)


def checked(load, curve=None, factor=1.0, max_speed=200.0):
    slow = pair((1e-3, 2.0, 6.0, max_speed), (10.0, 0.9, 2e-4, 100.0, 80.0), **(curve or {}))
    points = slow.points(load)
    return slow, points, {check.name: check for check in slow.checks(points, load, factor)}


def test_checks_of_a_pair_against_the_torque_curve():
    load = load_samples()
    _, points, plain = checked(load)
    assert plain["motor speed"].ok
    assert not plain["reducer input speed"].ok
    assert plain["reducer output torque"].ok
    assert plain["torque below the curve"][1:] == pytest.approx((points.peak_torque, 6.0, True))
    falling, points, bent = checked(load, {"full_torque_to": 20.0, "end_torque": 0.0}, max_speed=135.0)
    assert bent["motor speed"].ok
    peak = bent["torque below the curve"]
    assert not peak.ok
    assert peak.limit - peak.value == pytest.approx(falling.reserve(points).min(), rel=1e-12)


def test_the_reducer_must_hold_the_torque_times_its_factor():
    load = load_samples()
    largest = float(np.abs(load.torque).max())
    assert load.torque_needed(1.5) == 1.5 * largest
    share = 80.0 / largest
    assert checked(load, factor=0.999 * share)[2]["reducer output torque"].ok
    assert not checked(load, factor=1.001 * share)[2]["reducer output torque"].ok


def test_a_motor_driven_too_fast_without_torque_is_not_below_its_curve():
    time = np.linspace(0.0, 1.0, 5)
    load = LoadSamples(time, np.full(5, 50.0), np.zeros(5), np.zeros(5))
    _, points, found = checked(load)
    assert points.max_speed == 500.0
    assert not found["torque below the curve"].ok


def test_reserve_is_what_is_left_below_the_curve_at_each_speed():
    load = load_samples()
    falling, points, _ = checked(load, {"full_torque_to": 50.0, "end_torque": 1.0})
    for k in range(0, 4001, 400):
        speed = abs(points.speed[k])
        available = 6.0 if speed <= 50.0 else 6.0 - 5.0 * (speed - 50.0) / 150.0
        assert falling.reserve(points)[k] == pytest.approx(available - abs(points.torque[k]), rel=1e-12)


def test_knee_and_slope_are_those_of_the_curve():
    m = Motors(
        ("level", "falling"), 1e-3, 2.0, np.array([6.0, 8.0]), 300.0,
        full_torque_to=np.array([np.nan, 100.0]), end_torque=np.array([np.nan, 4.0]),
    )  # fmt: skip
    assert m.knee.tolist() == [300.0, 100.0]
    assert m.slope == pytest.approx([0.0, -0.02])
    assert m.curve(0).at([0.0, 300.0]).tolist() == [6.0, 6.0]
    between = m.curve(1).at([100.0, 200.0, 300.0])
    assert between == pytest.approx(8.0 + m.slope[1] * np.array([0.0, 100.0, 200.0]))


def test_the_outline_is_closed_and_each_corner_lies_on_the_curve():
    curve = TorqueCurve(np.array([0.0, 300.0, 600.0]), np.array([10.0, 10.0, 4.0]))
    line = curve.outline(5.0, reverses=True)
    assert [column[0] for column in line] == [column[-1] for column in line]
    assert np.abs(line.peak) == pytest.approx(curve.at(line.speed))
    assert set(zip(np.sign(line.speed), np.sign(line.peak), strict=True)) == {(1, 1), (1, -1), (-1, -1), (-1, 1)}
    assert (line.rated == 5.0 * np.sign(line.peak)).all()
    assert curve.outline(5.0, reverses=False).speed.min() == 0.0


def test_a_motor_reverses_where_its_speed_is_negative():
    load = load_samples()
    assert reverses(pair().points(load))
    forth = LoadSamples(load.time, np.abs(load.speed), load.acceleration, load.torque)
    assert not reverses(pair().points(forth))


def test_torque_curve_between_and_beyond_its_corners():
    curve = TorqueCurve(np.array([0.0, 300.0, 600.0]), np.array([10.0, 10.0, 4.0]))
    assert curve.at([0.0, -450.0, 600.0, 601.0]) == pytest.approx([10.0, 7.0, 4.0, 0.0])


def test_accelerating_factor_is_rated_torque_squared_over_inertia():
    assert accelerating_factor([2.0, 3.0], 1e-3) == pytest.approx([4000.0, 9000.0])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Task(-1.0, 1.0, 0.0, 1.0), "acceleration_rms is -1; expected a finite number, 0 or more"),
        (lambda: Task(1.0, 1.0, 2.0, 1.0), "power_rate_mean is 2; expected −1 to 1"),
        (lambda: Task.of_load(Load(1.0, 0.0), []), "0 phases"),
        (
            lambda: Task.of_load(Load(1.0, 0.0), [Phase(UNFINISHED, 1.0, 1.0)]),
            "phase 1: Own law does not begin and end",
        ),
        (lambda: ratio_ranges(TASK, 1.0, 1.0, 1.0, efficiency=1.1), "efficiency is 1.1"),
        (lambda: Motors(("A", "B"), 1e-3, np.array([1.0, -2.0]), 3.0, 400.0), "motor 'B': rated_torque is -2"),
        (lambda: Motors(("A", "B"), np.ones(3), 1.0, 3.0, 400.0), "2 motors are named and 3 values of inertia given"),
        (
            lambda: Reducers(("A",), 10.0, 1.2, 0.0, 1.0, 1.0),
            "reducer 'A': efficiency is 1.2; expected a number at most 1",
        ),
        (
            lambda: Reducers(("A",), 10.0, 0.9, -1.0, 1.0, 1.0),
            "reducer 'A': inertia is -1; expected a number 0 or more",
        ),
        (
            lambda: rank(TASK, motors(), reducers(), "beauty"),
            "criterion is 'beauty'; expected one of margin, inertia match",
        ),
        (lambda: rank(TASK, motors(), reducers(), best=0), "best is 0"),
        (lambda: Motors(("A",), 1e-3, 1.0, 2.0, 9.0, end_torque=1.0), "motor 'A': end_torque is 1"),
        (
            lambda: Motors(("A",), 1e-3, 1.0, 2.0, 9.0, full_torque_to=9.0, end_torque=1.0),
            "full_torque_to is 9; expected a number below max_speed",
        ),
        (lambda: Motors(("A",), 1e-3, 1.0, 2.0, 9.0, size=-1.0), "size is -1; expected a number 0 or more"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
