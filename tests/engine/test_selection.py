"""Choice of motor and reducer: whole catalogues against one pair at a time, efficiency, ranking, step 7's checks."""

import itertools
import math
from dataclasses import astuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.drivetrain import KINDS, Drive, Load, Stage, direction
from engine.laws import Cycloidal, Dwell, Piece, PieceLaw
from engine.motion import Motion, Phase
from engine.pairing import Motors, Pairs, Reducers, TorqueCurve, checks, operating_points, rank, usable
from engine.selection import Task, accelerating_factor, ratio_ranges, rms_torque

TASK = Task(acceleration_rms=300.0, torque_rms=9.0, power_rate_mean=1100.0, max_speed=30.0)
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
    return Reducers(names, 1 / np.geomspace(1, 80, n), eta, own, fast, np.inf, rng.uniform(1, 9, n), np.full(n, 50.0))


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
    monkeypatch.setattr("engine.pairing.BLOCK", 64)
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
    r = Reducers(("x", "y"), np.array([0.1, 0.1]), 0.9, 0.0, np.inf, np.inf, 1.0)
    pairs = rank(TASK, m, r, "size", best=best)
    expected = sorted(itertools.product(range(n), range(2)), key=lambda pair: size[pair[0]])[:best]
    assert list(zip(pairs.motor, pairs.reducer, strict=True)) == expected


def test_mismatch_is_one_at_the_best_ratio_with_losses_and_the_reducer_s_inertia():
    inertia, own, eta = 1e-3, 4e-4, 0.8
    tau = math.sqrt((inertia + own) * TASK.acceleration_rms * eta / TASK.torque_rms)
    m = Motors(("M",), inertia, 100.0, 300.0, 1e4)
    r = Reducers(("one", "double", "half"), np.array([tau, 2 * tau, tau / 2]), eta, own, np.inf, np.inf)
    pairs = rank(TASK, m, r, "inertia match")
    assert pairs.mismatch == pytest.approx([1.0, 2.0, 2.0], rel=1e-12)
    assert pairs.reducer[0] == 0


def test_no_pair_and_no_catalogue_are_empty_not_errors():
    weak = Motors(("M",), 1e-3, 1e-3, 1e-3, 1.0)
    assert len(rank(TASK, weak, reducers())) == 0
    none = Reducers((), np.empty(0), np.empty(0), np.empty(0), np.empty(0), np.empty(0))
    assert isinstance(rank(TASK, motors(), none), Pairs)


def load_samples(n=4001):
    motion = Motion([Phase(Cycloidal(), 2.0, 0.3), Phase(Cycloidal(), -2.0, 0.4)])
    time = np.linspace(0.0, 0.7, n)
    _, w, dw = motion.at(time)
    return time, w, dw, 4.0 + 0.05 * dw


def test_task_of_samples_is_that_of_the_closed_forms():
    time, w, dw, torque = load_samples()
    task = Task.of_samples(time, w, dw, torque)
    square = 2 * math.pi**2 * 4.0 * (1 / 0.3**3 + 1 / 0.4**3) / 0.7
    assert task.acceleration_rms == pytest.approx(math.sqrt(square), rel=1e-6)
    assert task.torque_rms == pytest.approx(math.sqrt(16 + 0.05**2 * square), rel=1e-6)
    assert task.power_rate_mean == pytest.approx(0.05 * square, rel=1e-6)
    assert task.max_speed == pytest.approx(2 * 2.0 / 0.3, rel=1e-6)


@pytest.mark.parametrize("resists", ["always", "moving"])
def test_task_of_a_load_is_that_of_its_samples(resists):
    load = Load(0.05, 4.0) if resists == "always" else Load(0.05, friction=4.0)
    phases = [Phase(Cycloidal(), 0.2, 0.3), Phase(Dwell(), 0.0, 0.2), Phase(Cycloidal(), -0.2, 0.4)]
    time = np.linspace(0.0, 0.9, 90001)
    _, y1, y2 = Motion(phases).at(time)
    w, dw = y1 / 0.1, y2 / 0.1
    sampled = Task.of_samples(time, w, dw, load.resisting(direction(w)) + 0.05 * dw)
    exact = Task.of_load(load, phases, radius=0.1)
    assert astuple(exact) == pytest.approx(astuple(sampled), rel=1e-4)


def test_rms_of_the_task_is_that_of_the_motor_over_the_cycle():
    time, w, dw, torque = load_samples()
    m, r = Motors(("M",), 1e-3, 9.0, 30.0, 600.0), Reducers(("R",), 0.1, 1.0, 2e-4, 600.0, 80.0)
    points = operating_points(m, r, (0, 0), time, w, dw, torque)
    assert points.rms_torque == pytest.approx(float(rms_torque(Task.of_samples(time, w, dw, torque), 1.2e-3, 0.1)))


def test_operating_points_are_those_of_the_drive_with_losses_both_ways():
    time, w, dw, torque = load_samples()
    m, r = Motors(("M",), 1e-3, 9.0, 30.0, 600.0), Reducers(("R",), 0.1, 0.7, 2e-4, 600.0, 80.0)
    found = operating_points(m, r, (0, 0), time, w, dw, torque)
    drive = Drive(KINDS["gear train"].of(Load(0.05, 4.0), gears=[Stage("reducer", 10.0, 0.7)]), 1.2e-3)
    assert found.torque == pytest.approx(drive.torque(dw, direction(w)), rel=1e-12)
    assert found.power == pytest.approx(found.torque * found.speed)


def test_checks_of_a_pair_against_the_torque_curve():
    time, w, dw, torque = load_samples()
    m, r = Motors(("M",), 1e-3, 2.0, 6.0, 200.0), Reducers(("R",), 0.1, 0.9, 2e-4, 100.0, 80.0)
    points = operating_points(m, r, (0, 0), time, w, dw, torque)
    plain = {check.name: check for check in checks(m, r, (0, 0), points, torque)}
    assert plain["motor speed"].ok
    assert not plain["reducer input speed"].ok
    assert plain["reducer output torque"].ok
    assert plain["peak torque, share of the curve"].value == pytest.approx(points.peak_torque / 6.0)
    falling = TorqueCurve(np.array([0.0, 20.0, 60.0, 200.0]), np.array([6.0, 6.0, 0.1, 0.1]))
    bent = {check.name: check for check in checks(m, r, (0, 0), points, torque, falling)}
    assert not bent["peak torque, share of the curve"].ok


def test_torque_curve_between_and_beyond_its_corners():
    curve = TorqueCurve(np.array([0.0, 300.0, 600.0]), np.array([10.0, 10.0, 4.0]))
    assert curve.at([0.0, -450.0, 600.0, 601.0]) == pytest.approx([10.0, 7.0, 4.0, 0.0])


def test_accelerating_factor_is_rated_torque_squared_over_inertia():
    assert accelerating_factor([2.0, 3.0], 1e-3) == pytest.approx([4000.0, 9000.0])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Task(0.0, 1.0, 0.0, 1.0), "acceleration_rms is 0"),
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
            lambda: Reducers(("A",), 0.1, 1.2, 0.0, 1.0, 1.0),
            "reducer 'A': efficiency is 1.2; expected a number at most 1",
        ),
        (lambda: Reducers(("A",), 0.1, 0.9, -1.0, 1.0, 1.0), "reducer 'A': inertia is -1; expected a number 0 or more"),
        (
            lambda: rank(TASK, motors(), reducers(), "beauty"),
            "criterion is 'beauty'; expected one of margin, inertia match",
        ),
        (lambda: rank(TASK, motors(), reducers(), best=0), "best is 0"),
        (
            lambda: rank(TASK, Motors(("A",), 1e-3, 50.0, 90.0, 1e4), reducers(), "cost"),
            "give no cost of each motor and reducer",
        ),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
